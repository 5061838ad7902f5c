"""Check that what is kept of a run in steps has its bits, and that damage is refused (R16)."""

import math
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from tamias2d import replay
from tamias2d.ensemble.request import STATE
from tamias2d.errors import RecordingError
from tamias2d.run import Run
from tamias2d.simulator import Simulator
from tamias2d.verify.case import Case
from tamias2d.verify.outcome import Outcome


def compare(case: Case, given: Mapping[str, Any], run: Run, time_step: float) -> Iterator[Outcome]:
    """A recording read back, computed again, cut and changed; a simulator saved half way."""
    with TemporaryDirectory() as folder:
        path = Path(folder) / "run.npz"
        run.save(path)
        held = {
            "bits of the run when read back": Run.load(path).digest() == run.digest(),
            "bits of a replay": replay.check(path).identical,
            "a recording that is cut is refused": _is_refused(path, lambda data: data[:-40]),
            "a recording that is changed is refused": _is_refused(path, _changed),
            "bits of a simulator that was restored": _goes_on(case, time_step, Path(folder)),
        }
    for what, holds in held.items():
        yield case.outcome(given, what, 0.0 if holds else math.inf)


def _changed(data: bytes) -> bytes:
    """Return a file with one other bit in the middle."""
    middle = len(data) // 2
    return data[:middle] + bytes([data[middle] ^ 1]) + data[middle + 1 :]


def _is_refused(path: Path, damage: Callable[[bytes], bytes]) -> bool:
    damaged = path.with_name("damaged.npz")
    damaged.write_bytes(damage(path.read_bytes()))
    try:
        Run.load(damaged)
    except RecordingError:
        return True
    return False


def _goes_on(case: Case, time_step: float, folder: Path) -> bool:
    """Whether a simulator that was saved half way, and its copy, end with the same bits."""
    steps = round(case.duration / time_step)
    sim = Simulator(case.scene, time_step=time_step)
    sim.step(steps // 2)
    sim.save(folder / "half.npz")
    other = Simulator.restore(folder / "half.npz")
    for each in (sim, other):
        each.step(steps - steps // 2)
    return all(np.array_equal(getattr(sim, name), getattr(other, name)) for name in STATE)
