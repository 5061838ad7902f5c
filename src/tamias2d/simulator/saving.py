"""A simulator as plain arrays, and back: it goes on with the same bits.

Serves: `save`, `restore` and pickle. Hides: what of it decides how it goes on, and the file.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.engine import Engine
from tamias2d.errors import RecordingError
from tamias2d.storage import aside

Arrays = Mapping[str, NDArray[Any]]
VERSION = 6  # of what the arrays hold; of the engine's columns too
_MARK = "tamias2d simulator"


def write(path: Path, arrays: Arrays) -> None:
    """Write arrays to a file, whole or not at all.

    Raises:
        RecordingError: it cannot be written.
    """
    if path.suffix != ".npz":
        raise RecordingError(
            f"{path}: a simulator is saved as .npz. Give the name this ending, e.g. game.npz."
        )
    try:
        with aside(path) as draft, draft.open("wb") as file:
            np.savez(file, allow_pickle=False, mark=np.array(_MARK), version=VERSION, **arrays)
    except OSError as error:
        why = error.strerror or type(error).__name__
        raise RecordingError(
            f"{path}: cannot be written: {why}. Check the directory, the disk's space and the "
            "permissions."
        ) from error


def read(path: Path) -> dict[str, NDArray[Any]]:
    """Return the arrays in a file.

    Raises:
        RecordingError: there is no file, or it is damaged, of another kind or another version.
    """
    if not path.is_file():
        raise RecordingError(f"{path}: there is no such file. Make it by `sim.save(path)`.")
    try:
        with np.load(path, allow_pickle=False) as file:
            arrays = {name: file[name] for name in file.files}
        mark, version = str(arrays.pop("mark")), int(arrays.pop("version"))
    except Exception as error:  # zipfile, zlib and numpy have their own
        raise RecordingError(
            f"{path}: cannot be read ({type(error).__name__}): it is damaged, or no saved "
            "simulator. Save it again."
        ) from error
    if (mark, version) != (_MARK, VERSION):
        raise RecordingError(
            f"{path}: found '{mark}' of version {version}: must be '{_MARK}' of version "
            f"{VERSION}. Save it again with this version."
        )
    return arrays


def part(arrays: Arrays, name: str) -> dict[str, NDArray[Any]]:
    """Return the arrays of one part, by their names in it."""
    return {key.partition(".")[2]: a for key, a in arrays.items() if key.startswith(f"{name}.")}


def fill(engine: Engine, found: Arrays, where: str) -> None:
    """Let an engine continue from arrays.

    Raises:
        RecordingError: one is missing, or of another kind than the engine's own.
    """
    for name, own in engine.arrays().items():
        there = found.get(name)
        if there is None or (there.dtype, there.ndim) != (own.dtype, own.ndim):
            what = "nothing" if there is None else f"{there.dtype} of {there.ndim} axes"
            raise RecordingError(
                f"{where}: {name}: found {what}: must be {own.dtype} of {own.ndim} axes. It is "
                "damaged, or was saved by another version. Save it again."
            )
    engine.take_over(found)
