"""A recording appears whole or not at all.

Serves: everything that writes a recording. Hides: what can be in the way, told in one line.
"""

from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from tamias2d import storage
from tamias2d.errors import RecordingError

if TYPE_CHECKING:
    from collections.abc import Iterator


def refuse_place(path: Path) -> None:
    """Raise `RecordingError` if no file can be at this path."""
    if path.is_dir():
        raise RecordingError(f"{path}: is a directory. Give the name of a file in it.")
    if path.parent.exists() and not path.parent.is_dir():
        raise RecordingError(f"{path}: {path.parent} is no directory. Choose another place.")
    if not path.parent.is_dir():
        raise RecordingError(f"{path}: there is no directory {path.parent}. Make it first.")


@contextmanager
def aside(path: Path) -> Iterator[Path]:
    """Give a path to write to, which takes the place of `path` when the block ends well.

    Raises:
        RecordingError: the directory is missing, or the file cannot be written (a full disk).
    """
    refuse_place(path)
    try:
        with storage.aside(path) as draft:
            yield draft
    except OSError as fault:
        why = fault.strerror or type(fault).__name__
        raise RecordingError(
            f"{path}: cannot be written: {why}. Check the disk's space and the permissions."
        ) from fault
