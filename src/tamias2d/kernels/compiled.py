"""Kernels in memory: the module that a source becomes, compiled or as plain Python.

Serves: whoever runs a kernel. Hides: numba, and how a source is run. What is run is the source that
this process has made; compiled code is found again by all of its statements, because numba does
not notice that a function elsewhere has changed.
"""

import linecache
import sys
from collections.abc import Callable
from functools import cache
from types import ModuleType
from typing import Any

from tamias2d import storage
from tamias2d.kernels.demand import Demand
from tamias2d.kernels.digest import digest_of
from tamias2d.kernels.source import source

_IMPORT = "from numba import njit"

Kernel = Callable[..., None]


@cache
def compiled(demand: Demand) -> Kernel:
    """Return the kernel for a demand, compiled when it is first called for a machine."""
    kernel: Kernel = loaded(source(demand)).advance
    return kernel


@cache
def plain(demand: Demand) -> Kernel:
    """Return the same kernel as plain Python, which debuggers and tracebacks can look into."""
    kernel: Kernel = plainly(source(demand, compiled=False))["advance"]
    return kernel


@cache
def plainly(text: str) -> dict[str, Any]:
    """Return what a source without marks for the compiler defines, by name."""
    names: dict[str, Any] = {}
    _run(text, names)
    return names


def is_kept(text: str) -> bool:
    """Whether a source was compiled before, as far as can be told without the compiler."""
    try:
        return any((storage.home_path() / "kernels").glob(f"{digest_of(text)}.*"))
    except OSError:  # a directory that may not be entered, or whose name is too long
        return False


@cache
def loaded(text: str) -> ModuleType:
    """Return the module with a text; what it compiles is kept on disk, or found there.

    Raises InputError if others may write where compiled code is kept.
    """
    from tamias2d.kernels.cache import njit

    module = ModuleType(f"tamias2d_kernel_{digest_of(text)}")
    module.__dict__["njit"] = njit(text)
    sys.modules[module.__name__] = module  # numba finds the names of compiled code here
    _run(text, module.__dict__)
    return module


def _run(text: str, names: dict[str, Any]) -> None:
    """Run a source; tracebacks show its lines."""
    name = f"<tamias2d kernel {digest_of(text)}>"
    linecache.cache[name] = (len(text), None, text.splitlines(keepends=True), name)
    exec(compile(text.replace(_IMPORT, "", 1), name, "exec"), names)  # our `njit` is in `names`
