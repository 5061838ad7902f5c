"""Look at a recording, or compute it again and compare every bit.

Serves: the command `replay`. Hides: how a run is computed again.
"""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from tamias2d.errors import InputError, RecordingError, SimulationError
from tamias2d.record import files, header as headers, history
from tamias2d.record.difference import Difference, first_difference
from tamias2d.simulate import simulate

if TYPE_CHECKING:
    from tamias2d.record.header import Header
    from tamias2d.run import Run


@dataclass(frozen=True)
class Check:
    """The answer of a recomputation: whether it is `identical`, and what it `says` in one line."""

    identical: bool
    says: str
    difference: Difference | None
    """The earliest number that differs, if one does."""


def check(path: str | Path) -> Check:
    """Compute a recorded run again, and compare every bit of its history.

    Raises:
        InputError: the name is that of no recording.
        RecordingError: the file is missing, cut, damaged or of another program.
    """
    header, arrays = files.stored(Path(path))
    recorded = history.run_of(header, arrays, where=str(path))
    recomputed = _again(recorded, where=str(path))
    difference = first_difference(recorded, recomputed)
    if difference is None and recorded.digest() == header.digest:
        says = (
            f"{path}: identical: {len(recorded.times)} samples and {len(recorded.impacts)} "
            f"impacts of {len(recorded.scene.bodies)} bodies."
        )
        return Check(True, says, None)
    return Check(False, f"{path}: {_differs(difference)}; {_why(header, recorded)}.", difference)


def _again(recorded: Run, *, where: str) -> Run:
    """Simulate as recorded; a run that was refused half-way is compared as far as it came."""
    try:
        return simulate(
            recorded.scene,
            duration=recorded.duration,
            method=recorded.method,
            time_step=recorded.time_step,
            times=recorded.times,
        )
    except InputError as fault:
        raise RecordingError(f"{where}: its inputs are refused: {fault}") from fault
    except SimulationError as refusal:
        reached: Run | None = getattr(refusal, "run", None)
        if reached is None:
            raise
        return reached


def _differs(difference: Difference | None) -> str:
    return f"differs first {difference}" if difference else "its digest does not fit its numbers"


def _why(header: Header, recorded: Run) -> str:
    """Return what may have made the difference."""
    if recorded.digest() != header.digest:
        return "its numbers were changed after it was recorded"
    here = headers.versions()
    changed = [
        f"{name} {header.versions.get(name)}, now {version}"
        for name, version in here.items()
        if header.versions.get(name) != version
    ]
    return "recorded with " + ", ".join(changed) if changed else "the program has changed"


def replay(path: str | Path) -> None:
    """Open a recording in rerun's viewer, and return when it is closed.

    An `.npz` is opened too: by way of a temporary `.rrd`.

    Raises:
        InputError: the name is that of no recording.
        RecordingError: the file cannot be read, rerun is not installed, or no window opens.
    """
    path = Path(path)
    files.stored(path)  # so that a damaged file is told here, not by an empty window
    if path.suffix == ".rrd":
        files.rerun(path).view(path, named=path)
        return
    with tempfile.TemporaryDirectory(prefix="tamias2d-") as folder:
        shown = Path(folder, f"{path.stem}.rrd")
        files.save(files.load(path), shown)
        files.rerun(path).view(shown, named=path)
