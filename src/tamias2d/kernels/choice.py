"""Whether a kernel is compiled, or runs as plain Python: whichever ends sooner.

Serves: the steps of smooth motion. Hides: what compiling costs. Results do not depend on the
choice: compiled and plain code have the same bits.
"""

import logging
import sys
from collections.abc import Callable
from functools import cache, cached_property
from math import inf
from time import perf_counter
from typing import Any

from tamias2d.errors import InputError
from tamias2d.kernels.compiled import is_kept, loaded, plainly

_IMPORT = 0.7  # s, of the compiler
_LOAD = 0.1  # s, of what was compiled before
_LOOKS = 2  # at what calls cost, before it is told what those to come do
_COMPILE = 0.8, 6000.0  # s, and characters of source a second


class Kernel:
    """One function of a source, which counts what its plain runs have cost."""

    def __init__(self, text: str, plain: str, name: str) -> None:
        self._text = text
        self._plain = plain
        self._name = name
        self._compiled: Callable[..., Any] | None = None
        self._spent = 0.0
        self._looks = 0
        self._least = inf  # s, of a call: what else the processor does counts for none
        self._barred = False

    def compiled(self, ahead: float) -> Callable[..., Any] | None:
        """Return it compiled if that pays for the calls that are ahead, or were made otherwise."""
        if self._compiled is None and not self._barred:
            coming = ahead * self._least if self._looks >= _LOOKS else 0.0
            if self._spent + coming > _LOAD and self._spent + coming > self._price():
                self._compile()
        return self._compiled

    def _compile(self) -> None:
        """Compile it, or never, where others may write to what would be loaded."""
        try:
            self._compiled = getattr(loaded(self._text), self._name)
        except InputError as refused:
            logging.getLogger("tamias2d").warning("Runs are not compiled: %s", refused)
            self._barred = True

    def otherwise(self, calls: int, seconds: float) -> None:
        """Hear that calls, or steps, of some seconds each were made without it."""
        self._spent += calls * seconds
        self._looks += 1
        self._least = min(self._least, seconds)

    def plain(self, *arguments: Any) -> int:
        """Run it as plain Python; return what it returns, and take the time of that many calls."""
        function = plainly(self._plain)[self._name]  # read once: that is no cost of a call
        start = perf_counter()
        calls: int = function(*arguments)
        took, made = perf_counter() - start, max(calls, 1)
        self.otherwise(made, took / made)
        return calls

    def _price(self) -> float:
        """Return what compiling costs now, s."""
        compiler = 0.0 if "numba" in sys.modules else _IMPORT
        if self._is_kept:
            return compiler + _LOAD
        least, pace = _COMPILE
        return compiler + least + len(self._text) / pace

    @cached_property
    def _is_kept(self) -> bool:
        """Whether it was compiled before: asked once, for each call pays what the disk takes."""
        return is_kept(self._text)


@cache
def kernel(text: str, plain: str, name: str) -> Kernel:
    """Return the kernel of a source, the same one each time."""
    return Kernel(text, plain, name)
