"""Compiling a whole source at once: functions are translated one by one, and optimised together.

Hides: what numba does with a function that others call. By itself it links, optimises and turns
into machine code each function with all that this calls, and does so anew at each level of calls.
Here a function stays as it was translated, and its entry is linked with all of them, optimised and
turned into machine code once. As nothing else can call them, what is called in one place is put
there, unless it is to stay by itself: that takes two thirds of the time to compile, and the code is
faster. This uses internals of numba, so its version is bounded.
"""

from types import FunctionType
from typing import Any

from llvmlite.binding import Linkage
from numba._dynfunc import make_function
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import Compiler


class HelperCompiler(Compiler):
    """Translates a function that only other compiled functions call."""

    def __init__(self, typing: Any, target: Any, library: Any, *rest: Any) -> None:
        super().__init__(typing, target, library or _Translated(target.codegen(), "helper"), *rest)
        self.state.flags.no_compile = True

    def compile_extra(self, function: FunctionType) -> Any:
        """Return the result, which other functions can call from now on."""
        result = super().compile_extra(function)
        library, module = result.library, result.fndesc.lookup_module()
        key = make_function(module, function.__name__, "", 0, result.environment, (library,))
        self.state.targetctx.insert_user_function(key, result.fndesc, [library])
        return result._replace(entry_point=key)


class SeparateCompiler(HelperCompiler):
    """Translates a function whose code is not put where it is called."""

    def compile_extra(self, function: FunctionType) -> Any:
        """Return the result, which other functions can call from now on."""
        result = super().compile_extra(function)
        code = result.library._final_module.get_function(result.fndesc.llvm_func_name)
        code.add_function_attribute("noinline")
        return result


class EntryCompiler(Compiler):
    """Compiles a function that is called from outside, with all that it calls."""

    def __init__(self, typing: Any, target: Any, library: Any, *rest: Any) -> None:
        if library is None:
            library = _Whole(target.codegen(), "entry")
            library.enable_object_caching()
        super().__init__(typing, target, library, *rest)


class _Wide(JITCodeLibrary):
    """Functions whose loops take as many lanes at once as the processor can.

    LLVM prefers half of that where the first processors with so wide registers slowed down; loops
    over lanes take three quarters of the time with all of it.
    """

    def add_ir_module(self, ir_module: Any) -> None:
        """Add functions as they were translated."""
        for function in ir_module.functions:
            if not function.is_declaration:
                set.add(function.attributes, '"prefer-vector-width"="512"')  # not one it checks
        super().add_ir_module(ir_module)


class _Translated(_Wide):
    """A function as it was translated, neither linked nor optimised."""

    def finalize(self) -> None:
        """Let others link this."""
        self._raise_if_finalized()
        self._finalized = True


class _Whole(_Wide):
    """An entry with all that it calls."""

    def finalize(self) -> None:
        """Link everything, each once; optimise it, and turn it into machine code."""
        called: dict[JITCodeLibrary, None] = {}
        for library in self._linking_libraries:
            _add_called(library, called)
        self._linking_libraries = list(reversed(called))
        super().finalize()

    def _optimize_final_module(self) -> None:
        """Optimise, knowing that nothing else calls what was linked."""
        for function in self._final_module.functions:
            if function.linkage == Linkage.linkonce_odr and not function.is_declaration:
                function.linkage = Linkage.internal
        super()._optimize_final_module()


def _add_called(library: JITCodeLibrary, known: dict[JITCodeLibrary, None]) -> None:
    """Add a function after all that it calls: what nothing refers to yet would not be linked."""
    if library not in known:
        for called in library._linking_libraries if isinstance(library, _Translated) else ():
            _add_called(called, known)
        known[library] = None
