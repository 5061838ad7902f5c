"""Arrays in an `.npz` that somebody else may have made: read only if it holds what it claims."""

import math
import zipfile
from pathlib import Path
from typing import Any

from numpy.lib import format as npy
from numpy.typing import NDArray

from tamias2d.errors import RecordingError

_HEADERS = {(1, 0): npy.read_array_header_1_0, (2, 0): npy.read_array_header_2_0}


class _Unfit(Exception):  # noqa: N818 - it becomes a RecordingError
    """What is wrong with a container that can be opened."""


def read(path: Path, *, remedy: str) -> dict[str, NDArray[Any]]:
    """Return the arrays in a file by name; the message of a fault ends with the remedy.

    Raises:
        RecordingError: the file is cut, damaged, of another kind, compressed or holds pickles.
    """
    try:
        with zipfile.ZipFile(path) as container:
            _check_sizes(container, path.stat().st_size)
            names = [entry.filename for entry in container.infolist()]
            return {name.removesuffix(".npy"): _array(container, name) for name in names}
    except _Unfit as fault:
        raise RecordingError(f"{path}: {fault}. {remedy}") from None
    except Exception as fault:  # zipfile, zlib, numpy and its header's tokenizer have their own
        raise RecordingError(
            f"{path}: cannot be read as .npz ({type(fault).__name__}): it is cut, damaged or of "
            f"another kind. {remedy}"
        ) from fault


def _check_sizes(container: zipfile.ZipFile, size: int) -> None:
    """Refuse what would be more than the file when it is read."""
    entries = container.infolist()
    if len({entry.filename for entry in entries}) < len(entries):
        raise _Unfit("it is damaged: it holds two arrays of one name")
    for entry in entries:
        if entry.compress_type != zipfile.ZIP_STORED:
            raise _Unfit(f"{entry.filename}: is compressed: must be stored as it is")
    total = sum(entry.file_size for entry in entries)
    if total > size:
        raise _Unfit(f"it is damaged: it claims {total} bytes of arrays in {size} bytes")


def _array(container: zipfile.ZipFile, name: str) -> NDArray[Any]:
    with container.open(name) as file:
        shape, _, dtype = _HEADERS[npy.read_magic(file)](file)
        claimed, there = math.prod(shape) * dtype.itemsize, container.getinfo(name).file_size
        if claimed != there - file.tell():
            raise _Unfit(f"{name}: is damaged: it claims {claimed} bytes in {there}")
        file.seek(0)
        array: NDArray[Any] = npy.read_array(file, allow_pickle=False)
        return array
