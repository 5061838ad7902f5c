"""The kinds of recording, told apart by the suffix of the file."""

from __future__ import annotations

import importlib
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tamias2d.errors import InputError, MissingExtraError, RecordingError, path_text
from tamias2d.record import header as headers, history
from tamias2d.recording_file import checked_path, refuse_missing, refuse_place

if TYPE_CHECKING:
    from tamias2d.record.header import Header
    from tamias2d.record.history import Arrays
    from tamias2d.run_data import RunData

_RECORDED = "Give a file that `tamias2d run --record` or `Run.save` has written."


def save(run: RunData, path: str | Path) -> None:
    """Write a run as a recording to look at (`.rrd`) or as its exact history (`.npz`).

    Raises:
        InputError: another suffix.
        RecordingError: the file cannot be written, or rerun is not installed.
    """
    where = checked_path(path)
    _kind(where).write(run, where)


def refuse_file(path: Path) -> None:
    """Raise as `save` would, where that can be known before there is a run."""
    _kind(path)
    refuse_place(path)


def load(path: str | Path) -> RunData:
    """Read the run back, to the last bit, from a recording of either kind.

    Raises:
        InputError: another suffix.
        RecordingError: no such file, or it is cut, damaged, changed or of another program.
    """
    header, arrays = stored(checked_path(path))
    run = history.run_of(header, arrays, where=str(path))
    if headers.digest(header, run) != header.digest:
        raise RecordingError(
            f"{path}: was changed after it was recorded: its digest does not fit. "
            "Record the run again."
        )
    return run


def stored(path: Path) -> tuple[Header, Arrays]:
    """Read the header and the arrays of a recording; raises as `load` does."""
    kind = _kind(path, _RECORDED)
    left = path.with_suffix(".part.rrd")
    if os.path.isfile(left) and not os.path.exists(path):
        raise RecordingError(
            f"{path}: there is no such file: its recorder has not ended it. Give {left}."
        )
    refuse_missing(path, made_by="`tamias2d run SCENE --record FILE` or `run.save(path)`")
    found: tuple[Header, Arrays] = kind.read(path)
    return found


def _kind(path: Path, remedy: str = "Give the name one of these endings.") -> Any:
    if path.suffix == ".npz":
        return history
    if path.suffix == ".rrd":
        return rerun(path)
    found = "a directory" if os.path.isdir(path) else f"suffix {path.suffix!r}"
    raise InputError(f"{path_text(path)}: {found}: a run is saved as .rrd or .npz (R5). {remedy}")


def rerun(path: Path, wants: str = ".rrd", *, otherwise: str = "save as .npz") -> Any:
    """Load the one way to rerun: an extra, large and slow to import.

    Raises:
        MissingExtraError: it is not installed; `path` is the user's file, `wants` what of it needs
            rerun, and `otherwise` what to do without.
    """
    try:
        return importlib.import_module("tamias2d.record.rerun")
    except ImportError as fault:
        raise MissingExtraError(
            f"{path}: {wants} needs rerun, which is not installed ({fault}). "
            f'Install it by `pip install "tamias2d[record]"`, or {otherwise}.',
            extra="record",
        ) from fault
