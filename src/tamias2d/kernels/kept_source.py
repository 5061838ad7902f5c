"""The source of a library as it was assembled, kept until a file of this package changes.

To assemble a large one takes as long as all else that a program does before its first step.
"""

import hashlib
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

from tamias2d.kernels import kept_files
from tamias2d.kernels.copied import Function

_PACKAGE = Path(__file__).parent.parent


def kept_source(name: str, assemble: Callable[[], str]) -> str:
    """Return the source of a library of this package, and keep it.

    Raises InputError if others may write where it is kept.
    """
    key = _package_key()
    if key is None:
        return assemble()
    where = hashlib.sha256(str(_PACKAGE).encode()).hexdigest()[:16]
    path = kept_files.folder() / f"{where}.{name.replace(' ', '-')}.source"
    kept = kept_files.read(path, key)
    if kept is not None:
        return kept.decode()
    text = assemble()
    kept_files.write(path, key, text.encode())
    return text


def is_of_package(function: Function) -> bool:
    """Whether a function stands in a file of this package, so that its source may be kept."""
    return Path(function.__code__.co_filename).is_relative_to(_PACKAGE)


@cache
def _package_key() -> bytes | None:
    """Return what changes with any file of the package or with Python; None without files."""
    files = sorted(_PACKAGE.rglob("*.py"))
    if not files:
        return None
    whole = hashlib.sha256(sys.version.encode())
    for file in files:
        content = file.read_bytes()
        whole.update(f"{file.relative_to(_PACKAGE)} {len(content)} ".encode())
        whole.update(content)
    return whole.digest()
