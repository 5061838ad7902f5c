"""The messages that an `.rrd` is made of: what was not written whole can be left off.

Of a file that ends within a message the viewer shows nothing at all, and of one that ends after
some message all that is there.
"""

from __future__ import annotations

import os
import shutil
import struct
import tempfile
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

_BEGIN = 12  # bytes, before the first message
_HEAD = struct.Struct("<QQ")  # of a message: its kind, and how many bytes follow
_END = 0
"""The kind of the last message of a file that was ended; what follows it is an index."""


def of(encoded: bytes, *, begun: bool) -> bytes:
    """Return the messages of a whole recording, to go on with one that has begun, or to begin.

    The index at its end is left off, which readers can do without: it is that of a part.
    """
    end = _BEGIN
    while end < len(encoded):
        kind, length = _HEAD.unpack_from(encoded, end)
        if kind == _END:
            break
        end += _HEAD.size + length
    return encoded[_BEGIN if begun else 0 : end]


def cut(path: Path) -> bool:
    """Take off a message at the end that is not whole; return whether one is left."""
    length = _whole(path)
    os.truncate(path, length)
    return length > _BEGIN


@contextmanager
def whole(path: Path) -> Iterator[Path]:
    """Give a file with all whole messages of another one: mostly that one itself, else a copy."""
    if not _is_torn(path):
        yield path
        return
    with tempfile.TemporaryDirectory(prefix="tamias2d-") as folder:
        copy = Path(folder, path.name)
        shutil.copyfile(path, copy)
        cut(copy)
        yield copy


def _is_torn(path: Path) -> bool:
    try:
        return _whole(path) < path.stat().st_size
    except OSError:  # whoever reads it says so
        return False


def _whole(path: Path) -> int:
    """Return how many bytes of a file are whole messages, with the beginning and the index."""
    size = path.stat().st_size
    end = min(_BEGIN, size)
    with path.open("rb") as file:
        while True:
            file.seek(end)
            head = file.read(_HEAD.size)
            if len(head) < _HEAD.size:
                return end
            kind, length = _HEAD.unpack(head)
            if end + _HEAD.size + length > size:
                return end
            if kind == _END:
                return size
            end += _HEAD.size + length
