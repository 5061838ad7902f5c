"""Libraries: plain functions that are compiled together.

Serves: the engine, and `tamias2d warm`. Hides: assembling and compiling.
"""

import gc
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass
from functools import cache, wraps
from types import SimpleNamespace, TracebackType
from typing import TypeVar

from tamias2d.errors import InputError
from tamias2d.kernels.assembled import assembled
from tamias2d.kernels.compile_lock import compile_lock
from tamias2d.kernels.compiled import is_kept, loaded
from tamias2d.kernels.copied import Function, leaving_out
from tamias2d.kernels.digest import digest_of
from tamias2d.kernels.kept_source import is_of_package, kept_source
from tamias2d.kernels.progress import progress, time_of_compiling

T = TypeVar("T")


@dataclass(frozen=True)
class Library:
    """Functions, by a name, that are compiled together."""

    name: str
    """What people are told is compiled, such as 'contact engine'."""
    entries: tuple[Function, ...]
    """What is called from outside; their types are those of `tamias2d.kernels.arrays`."""

    without: tuple[Function, ...] = ()
    """Stages that it does without: statements that only call one of them are left out."""

    def source(self) -> str:
        """Return the source that is compiled, with all that the entries use."""
        with leaving_out(self.without):
            return assembled(*self.entries, says=f"The {self.name} of Tamias2D.")

    def is_kept(self) -> bool:
        """Whether it was compiled before, as far as can be told without the compiler."""
        return is_kept(_text(self))

    def time_of_compiling(self) -> float:
        """Return about how long it takes to compile, s of processor time, as people are told."""
        return time_of_compiling(_text(self))

    def is_loaded(self) -> bool:
        """Whether it is at hand, compiled."""
        return self in _LOADED

    def plain(self) -> SimpleNamespace:
        """Return the entries by their names as they are, to look into and to compare with."""
        return SimpleNamespace(**{entry.__name__: entry for entry in self.entries})

    def compiled(self) -> SimpleNamespace:
        """Return the entries by their names, compiled; where that takes a while, it is said.

        Their bits are those of the plain ones. An entry that takes a group takes its `addresses`
        instead.
        """
        return _compiled(self)


_LOADED: set[Library] = set()
_SELDOM = 50_000
"""New objects before a search for cycles: of numba's many objects nearly all stay, and searches at
Python's own pace take a sixteenth of the time of compiling."""


def _fault_again(make: Callable[[Library], T]) -> Callable[[Library], T]:
    """Let who asks for a library that could not be made be told the fault of then, at once.

    To assemble and to compile one takes from seconds to minutes: to try it again for each of
    thousands of tests looks like hanging. What may be mended meanwhile, such as a directory, is.
    """
    faults: dict[Library, tuple[Exception, TracebackType | None]] = {}

    @wraps(make)
    def ask(library: Library) -> T:
        if library in faults:
            fault, where = faults[library]
            raise fault.with_traceback(where)
        try:
            return make(library)
        except (InputError, OSError, MemoryError):
            raise
        except Exception as fault:
            faults[library] = fault, fault.__traceback__
            raise

    return ask


@_fault_again
@cache
def _compiled(library: Library) -> SimpleNamespace:
    text = _text(library)
    alone = nullcontext() if is_kept(text) else compile_lock(library.name, digest_of(text))
    with alone, progress(library.name, text), _seldom_collected():
        module = loaded(text)
    _LOADED.add(library)
    return SimpleNamespace(
        **{entry.__name__: getattr(module, entry.__name__) for entry in library.entries}
    )


@contextmanager
def _seldom_collected() -> Iterator[None]:
    before = gc.get_threshold()
    gc.set_threshold(before[0] and max(_SELDOM, before[0]), *before[1:])  # 0: never
    try:
        yield
    finally:
        gc.set_threshold(*before)


@_fault_again
@cache
def _text(library: Library) -> str:
    keeps = all(is_of_package(entry) for entry in library.entries)
    return kept_source(library.name, library.source) if keeps else library.source()
