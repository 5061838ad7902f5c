"""Files that are whole or not used: a digest stands before what they hold.

Serves: compiled code, and sources. Hides: the directory, and what may lie there instead of a file.
What is kept is run, so nobody else may write to the directory, nor to a file in it.
"""

import hashlib
import logging
import os
from functools import cache
from pathlib import Path

from tamias2d import storage

_DIGEST = hashlib.sha256().digest_size
_MODE = 0o644  # of files, whatever the umask lets others write


def folder() -> Path:
    """The directory of what is kept, which need not exist.

    Raises InputError if others may write to it.
    """
    path = storage.home_path() / "kernels"
    storage.refuse_shared(path)
    return path


def read(path: Path, key: bytes) -> bytes | None:
    """Return what was kept in a file under a key; None where there is nothing, or it is damaged."""
    content = _content(path)
    payload = content[_DIGEST:]
    return payload if content[:_DIGEST] == _digest(key, payload) else None


def write(path: Path, key: bytes, payload: bytes) -> None:
    """Keep something in a file; where that cannot be done, say so once and go on."""
    try:
        storage.make_own(path.parent)
        _replace(path, _digest(key, payload) + payload)
    except OSError as fault:
        _say_not_kept(path.parent, fault.strerror or type(fault).__name__)


def _content(path: Path) -> bytes:
    """What is in a file; nothing where there is none, or a link, a pipe or a directory."""
    try:
        return path.read_bytes() if _is_plain(path) else b""
    except OSError:
        return b""


def _replace(path: Path, content: bytes) -> None:
    """Write a file; what lies there instead of one is removed, and a link is not followed."""
    if path.is_dir() and not path.is_symlink():
        path.rmdir()
    elif not _is_plain(path):
        path.unlink(missing_ok=True)
    storage.write_aside(path, content, mode=_MODE)


def _is_plain(path: Path) -> bool:
    return path.is_file() and not path.is_symlink()


def _digest(key: bytes, payload: bytes) -> bytes:
    """With the key, so that what was kept under another one is found out."""
    return hashlib.sha256(hashlib.sha256(key).digest() + payload).digest()


@cache
def _say_not_kept(place: Path, why: str) -> None:
    logging.getLogger("tamias2d").warning(
        "Compiled code cannot be %s in %s: %s. Each process compiles it again until it can, or "
        "until TAMIAS2D_HOME names another directory.",
        "kept" if os.access(place, os.R_OK | os.X_OK) else "found or kept",
        place,
        why,
    )
