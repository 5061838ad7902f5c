"""Compiled code on disk: a file for each function and machine, whole or not used.

Serves: `compiled`. Hides: what numba asks of a cache.

Compiled code is a pickle, and a pickle runs what its author wants. So a file is loaded only if its
digest fits, and only from a directory that nobody else may write (`kept_files`). A damaged file
counts as none: the function is compiled once more, and the file replaced.
"""

import hashlib
import pickle
import sys
from collections.abc import Callable
from pathlib import Path
from types import FunctionType
from typing import Any

import llvmlite
import numba
from numba.core.caching import _Cache
from numba.core.compiler import CompileResult
from numba.core.serialize import dumps

from tamias2d.kernels import kept_files
from tamias2d.kernels.digest import digest_of
from tamias2d.kernels.known_calls import known_calls
from tamias2d.kernels.linking import EntryCompiler, HelperCompiler, SeparateCompiler
from tamias2d.kernels.widening import compile_once


def njit(source: str) -> Callable[..., Callable[[FunctionType], Any]]:
    """Return numba's `njit` for one source; with `cache=True`, code is kept as this module says."""

    def decorator(*signatures: str, cache: bool = False, **options: Any) -> Any:
        """Return what compiles a function, at once for these signatures."""

        def compile_(function: FunctionType) -> Any:
            """Return the compiled function, which looks for its code in the cache if it may."""
            compiler = HelperCompiler if options.get("no_cpython_wrapper") else EntryCompiler
            compiler = SeparateCompiler if options.get("inline") == "never" else compiler
            made: Any = numba.njit(pipeline_class=compiler, **options)(function)
            if made is function:  # NUMBA_DISABLE_JIT
                return made
            if options.get("no_cpython_wrapper"):
                compile_once(made)
            if cache:
                made._cache = KernelCache(function.__qualname__, source)
            with known_calls():
                for signature in signatures:
                    made.compile(signature)
            if signatures:
                made.disable_compile()
            return made

        return compile_

    return decorator


class KernelCache(_Cache):
    """The compiled code of one function of a source, for any types of its arguments."""

    def __init__(self, function: str, source: str) -> None:
        self._name = f"{digest_of(source)}.{function}"
        self._folder = kept_files.folder()

    @property
    def cache_path(self) -> str:
        """The directory of the files."""
        return str(self._folder)

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Return the code for some types, or None if there is none, or a damaged one."""
        target_context.refresh()
        key = self._key(sig, target_context.codegen())
        payload = kept_files.read(self._path(key), key)
        if payload is None:
            return None
        found = pickle.loads(payload)
        return CompileResult._rebuild(target_context, *found)

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep the code for some types; where that cannot be done, say so once and go on."""
        key = self._key(sig, data.codegen)
        kept_files.write(self._path(key), key, dumps(data._reduce()))

    def enable(self) -> None:
        """Nothing: it always is."""

    def disable(self) -> None:
        """Nothing: what is not to be kept has no such cache."""

    def flush(self) -> None:
        """Nothing: it holds no list of its files."""

    def _path(self, key: bytes) -> Path:
        return self._folder / f"{self._name}.{hashlib.sha256(key).hexdigest()[:16]}"

    def _key(self, types: Any, codegen: Any) -> bytes:
        """All that decides whether code can be used: its statements, types, compiler, machine."""
        parts = (
            self._name, types, codegen.magic_tuple(), numba.__version__,
            llvmlite.__version__, sys.implementation.cache_tag, getattr(sys, "abiflags", ""),
        )  # fmt: skip
        return "\0".join(map(str, parts)).encode()
