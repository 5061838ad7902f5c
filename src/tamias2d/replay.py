"""Look at a recording, or compute it again and compare every bit of its numbers."""

import tempfile
from contextlib import suppress
from dataclasses import dataclass, fields
from pathlib import Path

from tamias2d.certificate import Certificate
from tamias2d.errors import FrameLoopError, InputError, RecordingError, SimulationError
from tamias2d.record import files, header as headers, history
from tamias2d.record.difference import Difference, first_difference
from tamias2d.record.header import Header
from tamias2d.run import Run
from tamias2d.solve import solve, work_limit_of
from tamias2d.study.certify import certify_as


@dataclass(frozen=True)
class Check:
    """The answer of a recomputation: whether it is `identical`, and what it `says` in one line."""

    identical: bool
    says: str
    difference: Difference | None
    """The earliest number that differs, if one does."""


def check(path: str | Path) -> Check:
    """Compute a recorded run again, and compare every bit of its history and its certificate.

    Notes and versions cannot be computed; a digest covers them against chance, not against intent.
    Nothing covers what an `.rrd` has for the viewer besides: drawings and texts made from these.

    Raises:
        InputError: the name is that of no recording.
        RecordingError: the file is missing, cut, damaged or of another program.
    """
    header, arrays = files.stored(Path(path))
    recorded = Run(**vars(history.run_of(header, arrays, where=str(path))))
    recomputed = _again(recorded, where=str(path))
    difference = first_difference(recorded, recomputed)
    fault = _fault(header, recorded, difference) or _certificate_fault(recorded, recomputed)
    if fault:
        return Check(False, f"{path}: {fault}.", difference)
    says = (
        f"{path}: identical: {len(recorded.times)} samples and {len(recorded.impacts)} "
        f"impacts of {len(recorded.scene.bodies)} bodies{_further(header)}{_drawn(path)}."
    )
    return Check(True, says, None)


def _fault(header: Header, recorded: Run, difference: Difference | None) -> str:
    """Return what is wrong with the numbers or the header; nothing if they are as recorded."""
    intact = headers.digest(header, recorded) == header.digest
    if difference is not None:
        return f"differs first {difference}; {_why(header, intact=intact)}"
    return "" if intact else f"its digest does not fit; {_why(header, intact=intact)}"


def _certificate_fault(recorded: Run, recomputed: Run) -> str:
    """Return in what a certificate differs from one that is made now; nothing if in nothing.

    Whoever changes a certificate can change the digest, too: so it is computed again.
    """
    claimed = recorded.certificate
    if claimed is None:
        return ""
    made = certify_as(recomputed, claimed.basis).certificate
    names = [field.name for field in fields(Certificate)]
    for name in ("how", *names):  # from another way all else follows
        ours, theirs = getattr(claimed, name), getattr(made, name)
        if name != "hashes" and ours != theirs:  # those of another version are other ones
            return f"its certificate differs: {name}: recorded {ours!r}, computed again {theirs!r}"
    return ""


def _further(header: Header) -> str:
    """Return what was checked besides the numbers."""
    return "; its certificate, computed again, is the same" if header.certificate else ""


def _drawn(path: str | Path) -> str:
    """Return what an `.rrd` holds besides the numbers: the viewer's drawing is not looked at."""
    return "; what the viewer draws was not compared" if Path(path).suffix == ".rrd" else ""


def _again(recorded: Run, *, where: str) -> Run:
    """Simulate as recorded; a run that was refused half-way is compared as far as it came."""
    try:
        return solve(
            recorded.scene,
            duration=recorded.duration,
            method=recorded.method,
            time_step=recorded.time_step,
            times=recorded.times,
            work_limit=work_limit_of(recorded),
        )
    except (InputError, SimulationError) as fault:
        if isinstance(fault, SimulationError) and isinstance(fault.run, Run):
            return fault.run
        if isinstance(fault, InputError):
            raise RecordingError(f"{where}: its inputs are refused: {fault}") from fault
        raise


def _why(header: Header, *, intact: bool) -> str:
    """Return what may have made the difference."""
    if not intact:
        return "it was changed after it was recorded"
    here = headers.versions()
    changed = [
        f"{name} {header.versions.get(name)}, now {version}"
        for name, version in here.items()
        if header.versions.get(name) != version
    ]
    if changed:
        return "recorded with " + ", ".join(changed)
    return "the program has changed, or it was not `simulate` that made the run"


def replay(path: str | Path) -> None:
    """Open a recording in rerun's viewer, and return when it is closed.

    An `.npz` is opened too: by way of a temporary `.rrd`. A run is read before, so that a damaged
    file is told, not shown as an empty window; a frame loop is opened at once, also one that its
    program could not end.

    Raises:
        InputError: the name is that of no recording.
        RecordingError: the file cannot be read, rerun is not installed, or no window opens.
    """
    path = Path(path)
    with suppress(FrameLoopError):  # there is nothing but what the viewer shows
        files.stored(path)
    viewer = files.rerun(path, "the viewer", otherwise="check the file by `replay --check`")
    if path.suffix == ".rrd":
        with viewer.whole(path) as shown:
            viewer.view(shown, named=path)
        return
    with tempfile.TemporaryDirectory(prefix="tamias2d-") as folder:
        shown = Path(folder, f"{path.stem}.rrd")
        files.save(files.load(path), shown)
        viewer.view(shown, named=path)
