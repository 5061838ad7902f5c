"""One source that stands alone, assembled from plain functions and all that they use.

Serves: engines, whose modules run as they are and are compiled as one. Hides: how what a function
uses is found, named and put in order. Nothing is looked up elsewhere when the source runs but
intrinsics, whose digest it has; so its text decides what it does, and a change in any function is a
change of the text.
"""

import ast
import builtins
import inspect
import math
from collections.abc import Callable, Hashable
from types import FunctionType, ModuleType
from typing import Any, TypeVar

from tamias2d.kernels.arrays import signature
from tamias2d.kernels.copied import Function, copied, references, text_of
from tamias2d.kernels.flattened import Flat, flattened
from tamias2d.kernels.groups import is_group, lines_of_entry, text_of_classes, text_of_views
from tamias2d.kernels.lanes import INTRINSICS, intrinsics_digest
from tamias2d.spec import functions as elementary

F = TypeVar("F", bound=Function)
_HEAD = '''"""{says}

Assembled by tamias2d.kernels from plain functions, which are to be edited in their own modules.
"""
'''
_BARE = 'error_model="numpy", _nrt=False'  # references to arrays are not counted: that takes longer
# numba hands `forceinline` down to what an inlined function calls, unless that says otherwise
_HELPER = f"@njit({_BARE}, no_cpython_wrapper=True, no_cfunc_wrapper=True, forceinline=False)"
_INLINED = _HELPER.replace("inline=False", "inline=True")
_SEPARATE = _HELPER.replace(")", ', inline="never")')
_ENTRY = f'@njit("{{signature}}", cache=True, {_BARE}, nogil=True, no_cfunc_wrapper=True)'
_SAME: dict[Any, Any] = {
    getattr(elementary, name): getattr(math, name)
    for name in ("sqrt", "sin", "cos", "tan", "exp", "log", "atan2")
} | {elementary.least: min, elementary.largest: max}
"""What elementary functions are on numbers. The compiler knows these, to the bit: of two equal
numbers, zeros of both signs too, and where one is no number, min and max return the first."""


_inlined: set[Function] = set()
_separate: set[Function] = set()
_for_each: set[Function] = set()


def inlined(function: F) -> F:
    """Mark a function whose code is put where it is called: a call passes all parts of its arrays.

    For what is called once in the source and often in a run; elsewhere it makes code long.
    """
    _inlined.add(function)
    return function


def separate(function: F) -> F:
    """Mark a function whose code stays by itself, even where it is called in one place only.

    For a loop over lanes: among others, compiled code may take its lanes one by one.
    """
    _separate.add(function)
    return function


def for_each(function: F) -> F:
    """Mark an entry that compiled code takes for many groups of arrays, one after another.

    Compiled, it takes their tables (w, k, 4), an array (w,) for what it returns of each, and its
    other arguments; it returns what it did of the last. So a call does the work of many.
    """
    _for_each.add(function)
    return function


def assembled(*entries: Function, says: str) -> str:
    """Return the source of a module with some functions and all that they use.

    The functions are defined at the level of modules of this package, and so is what they call;
    the entries state their types by `tamias2d.kernels.arrays`, and the first argument may be a
    group of arrays. Their other names are whole or real constants, functions of `math`, groups, or
    functions that have intrinsics (`kernels.lanes`).
    A generated function is named after its module as well.

    Raises:
        TypeError: a function uses something else, or a name would have two meanings; says where.
    """
    parts = _Parts(entries)
    for entry in entries:
        parts.add(entry, entry=True)
    imports = [f"from math import {', '.join(sorted(parts.imports))}"] if parts.imports else []
    constants = [f"{name} = {value!r}" for name, value in parts.constants.items()]
    views = [text_of_views(*parts.entered)] if parts.entered else []
    numba = ["from numba import njit", *(["from numba import types"] if views else [])]
    numba += [parts.import_of_intrinsics()] if parts.intrinsics else []
    names = ["from collections import namedtuple"] if parts.groups else []
    names += ["from typing import Any"] if views else []
    head = [_HEAD.format(says=says), *names, *imports, *numba]
    for lines in (constants, parts.groups):
        head += ["", *lines] if lines else []
    return "\n\n\n".join(["\n".join(head), *views, *parts.texts]) + "\n"


class _Parts:
    """What has been collected, each after what it uses."""

    def __init__(self, entries: tuple[Function, ...]) -> None:
        self.entries = entries
        self.imports: set[str] = set()
        self.intrinsics: set[str] = set()
        self.constants: dict[str, float] = {}
        self.groups: list[str] = []
        self.entered: list[type] = []
        self.texts: list[str] = []
        self.flat: dict[Function, Flat] = {}
        self.meanings: dict[str, tuple[Any, Function]] = {}
        """What a name means, and for which function it was taken up."""

    def add(self, function: Function, *, entry: bool = False) -> str:
        """Add a function, unless it is there, and what it uses; return its name here.

        An entry that others call, too, is there twice.
        """
        name = _name(function) if entry or function not in self.entries else f"{function.__name__}_"
        if name in self.meanings and self.meanings[name][0] is function:
            return name
        self._claim(name, function, function)
        if entry and function in _for_each:
            self._add_loop(function, self.add(function))
            return name
        names, called = {}, {}
        for node in references(function):
            names[ast.unparse(node)] = self._use(function, node)
            if isinstance(value := _value(function, node), Hashable) and value in self.flat:
                called[ast.unparse(node)] = (value, self.flat[value])
        flat, edits = flattened(function, text_of(function), called, entry=entry)
        self.flat[function] = flat
        self.entered += flat.groups.values() if entry else ()
        text = copied(function, names, edits, flat.groups)
        text = text.replace(f"def {function.__name__}(", f"def {name}(", 1)
        helper = _SEPARATE if function in _separate else _HELPER
        helper = _INLINED if function in _inlined | _for_each else helper
        decorator = _ENTRY.format(signature=signature(function)) if entry else helper
        self.texts.append(f"{decorator}\n{text}")
        return name

    def _add_loop(self, function: Function, inner: str) -> None:
        """Add an entry that calls a function of the source for each of many groups."""
        flat = self.flat[function]
        ((parameter, group),) = flat.groups.items()
        others = list(inspect.signature(function).parameters)[1:]
        given = ", ".join((*flat.names(parameter), *others))
        lines = (
            _ENTRY.format(signature=signature(function, for_each=True)),
            f"def {function.__name__}({', '.join(('tables', 'results', *others))}):",
            f'    """Call {inner} for each group; note its results, and return the last."""',
            "    for each in range(len(tables)):",
            "        addresses = tables[each]",
            *(f"        {line}" for line in lines_of_entry(group, flat.used[parameter])),
            f"        results[each] = {inner}({given})",
            "    return results[len(tables) - 1]",
        )
        self.entered.append(group)
        self.texts.append("\n".join(lines) + "\n")

    def import_of_intrinsics(self) -> str:
        """Return the lines that import them and say by a digest what they are."""
        names = ", ".join(sorted(self.intrinsics))
        lines = (
            f"from tamias2d.kernels.lane_code import {names}",
            "",
            f"LANE_CODE = {intrinsics_digest()!r}",
        )
        return "\n".join(lines)

    def _use_group(self, group: type) -> None:
        for part, text in text_of_classes(group):
            if text not in self.groups:
                self._claim(part.__name__, part, self.entries[0])
                self.groups.append(text)

    def _use(self, function: Function, node: ast.Name | ast.Attribute) -> str:
        """Add what a function means by a name; return the name here."""
        written, value = ast.unparse(node), _value(function, node)
        name = written.rpartition(".")[2]
        if isinstance(value, Hashable) and value in _SAME:
            value = _SAME[value]
            name = value.__name__
        if type(value) in (int, float, bool) and math.isfinite(value):
            self._claim(name, value, function)
            self.constants[name] = value
        elif getattr(math, name, None) is value:
            self._claim(name, value, function)
            self.imports.add(name)
        elif value in INTRINSICS:
            self._claim(name, value, function)
            self.intrinsics.add(name)
        elif isinstance(value, FunctionType) and value.__module__.startswith("tamias2d."):
            name = self.add(value)
        elif is_group(value):
            self._use_group(value)
        elif getattr(builtins, name, None) is not value:
            raise _refusal(
                function,
                f"'{written}' is {type(value).__name__}: must be a function "
                "of this package or of math, or a number. Use one of them.",
            )
        if name in function.__code__.co_varnames:
            raise _refusal(function, f"'{name}' is also a variable. Rename the variable.")
        return name

    def _claim(self, name: str, value: Any, function: Function) -> None:
        known, user = self.meanings.setdefault(name, (value, function))
        same = known is value or (type(known) is type(value) is not FunctionType and known == value)
        if not same:
            other = f"another meaning in {user.__module__}.{user.__name__}"
            raise _refusal(function, f"'{name}' has {other}. Rename one, for they are one source.")


def _name(function: Function) -> str:
    package, _, module = function.__module__.rpartition(".")
    generated = package == "tamias2d.generated"
    return f"{module}_{function.__name__}" if generated else function.__name__


def _value(function: Function, node: ast.Name | ast.Attribute) -> Any:
    known = function.__globals__
    if isinstance(node, ast.Name):
        if node.id in known:
            return known[node.id]
        if hasattr(builtins, node.id):
            return getattr(builtins, node.id)
    elif isinstance(node.value, ast.Name):
        module = known.get(node.value.id)
        if isinstance(module, ModuleType) and hasattr(module, node.attr):
            return getattr(module, node.attr)
    raise _refusal(function, f"'{ast.unparse(node)}' is not known. Define it in a module.")


def _refusal(function: Callable[..., Any], what: str) -> TypeError:
    return TypeError(f"{function.__module__}.{function.__name__}: {what}")
