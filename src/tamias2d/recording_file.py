"""The file of a recording, or of a saved simulator: it appears whole or not at all."""

from __future__ import annotations

import os
import reprlib
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from tamias2d import storage
from tamias2d.errors import InputError, RecordingError, path_text

if TYPE_CHECKING:
    from collections.abc import Iterator


def checked_path(path: object) -> Path:
    """Return the path of a file, or raise `InputError` for what is none."""
    if not isinstance(path, str | os.PathLike):
        raise InputError(
            f"path: found {reprlib.repr(path)}: must be a text or a Path (R5). Give the name of a "
            "file."
        )
    return Path(path)


def refuse_place(path: Path) -> None:
    """Raise `RecordingError` if no file can be written at this path."""
    where = path_text(path)
    try:
        os.lstat(path)
    except (FileNotFoundError, NotADirectoryError):
        pass
    except (OSError, ValueError) as fault:  # ValueError: a null byte, or half a character
        why = getattr(fault, "strerror", None) or fault
        raise RecordingError(f"{where}: cannot be written: {why}. Rename it.") from None
    target = Path(os.path.realpath(path)) if path.is_symlink() else path
    folder = path_text(target.parent)
    if os.path.isdir(target):
        raise RecordingError(f"{where}: is a directory. Give the name of a file in it.")
    if os.path.exists(target) and not os.path.isfile(target):
        raise RecordingError(f"{where}: is a pipe or a device. Give the name of a file.")
    if os.path.exists(target.parent) and not os.path.isdir(target.parent):
        raise RecordingError(f"{where}: {folder} is no directory. Choose another place.")
    if not os.path.isdir(target.parent):
        raise RecordingError(f"{where}: there is no directory {folder}. Make it first.")
    if not os.access(target.parent, os.W_OK | os.X_OK):
        raise RecordingError(f"{where}: {folder} cannot be written. Choose another place.")


def refuse_missing(path: Path, *, made_by: str) -> None:
    """Raise `RecordingError` if there is no file at this path; say what makes one."""
    where = path_text(path)
    if os.path.isdir(path):
        raise RecordingError(f"{where}: is a directory. Give the name of a file in it.")
    if not os.path.isfile(path):  # False for what is no name, too
        raise RecordingError(f"{where}: there is no such file. Make it by {made_by}.")


@contextmanager
def aside(path: Path) -> Iterator[Path]:
    """Give a path to write to, which takes the place of `path` when the block ends well.

    Raises:
        RecordingError: the directory is missing, or the file cannot be written (a full disk).
    """
    refuse_place(path)
    with _told(path), storage.aside(path) as draft:
        yield draft


@contextmanager
def growing(path: Path) -> Iterator[Path]:
    """Likewise, but what was written is kept, as `part_of` says, where the block ends by an error.

    Raises:
        RecordingError: likewise.
    """
    refuse_place(path)
    with _told(path), storage.growing(path) as draft:
        yield draft


@contextmanager
def _told(path: Path) -> Iterator[None]:
    """Let an error of the operating system be one of the file at a path."""
    try:
        yield
    except OSError as fault:
        why = fault.strerror or type(fault).__name__
        raise RecordingError(
            f"{path_text(path)}: cannot be written: {why}. Check the disk's space and "
            "the permissions."
        ) from fault
