"""Kernels on disk and in memory: each is compiled once, and found again by its text.

Serves: whoever runs a kernel. Hides: numba, its cache, and where files lie. A file is named after
the hash of all of its text, because numba does not notice that a function elsewhere has changed.
"""

import hashlib
import importlib.util
import linecache
import os
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

from tamias2d.kernels.demand import Demand
from tamias2d.kernels.source import source
from tamias2d.storage import home, temporary, write_aside

Kernel = Callable[..., None]


@cache
def compiled(demand: Demand) -> Kernel:
    """Return the kernel for a demand, compiled when it is first called for a machine."""
    kernel: Kernel = loaded(source(demand)).advance
    return kernel


@cache
def plain(demand: Demand) -> Kernel:
    """Return the same kernel as plain Python, which debuggers and tracebacks can look into."""
    text = source(demand, compiled=False)
    name = f"<tamias2d kernel {_hash(text)}>"
    linecache.cache[name] = (len(text), None, text.splitlines(keepends=True), name)
    names: dict[str, Any] = {}
    exec(compile(text, name, "exec"), names)
    kernel: Kernel = names["advance"]
    return kernel


@cache
def loaded(text: str) -> ModuleType:
    """Return the module with a text, which is kept on disk so that its compiled code is too.

    What the text compiles when it is run is compiled here, or found where a process left it.
    """
    path = _stored(text)
    name = f"tamias2d_kernel_{path.stem}"
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:
        raise ImportError(path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module  # numba finds compiled code again by the module's name
    spec.loader.exec_module(module)
    return module


def _stored(text: str) -> Path:
    """Write a text where compiled code can be kept beside it; return its path."""
    name = f"{_hash(text)}.py"
    try:
        return _written(home() / "kernels" / name, text)
    except OSError:  # a place that was made by somebody else, or is full
        return _written(temporary() / "kernels" / name, text)


def _written(path: Path, text: str) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    if not os.access(path.parent, os.W_OK | os.X_OK):
        raise PermissionError(path.parent)
    if not path.exists():
        write_aside(path, text.encode())
    return path


def _hash(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:16]
