"""How the time of a step and memory grow with the number of bodies.

Serves: the measurement of contacts. Hides: how memory is asked for.

The scene is that of X16: discs fall on a floor, 100 rows high and ever wider, so that a body has as
many neighbours whatever their number is.
"""

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from time import process_time

from tamias2d.study.engines.box2d import Box2D
from tamias2d.study.engines.chipmunk import Chipmunk
from tamias2d.study.engines.engine import Engine, Maker
from tamias2d.study.engines.own import Own
from tools.measurements.arena.race import TIME_STEP, undisturbed
from tools.measurements.arena.scenes import falling_discs

ROWS = 100
BODIES = (6_250, 12_500, 25_000, 50_000, 100_000)
_STEPS = 120  # the lowest rows lie by then, and others meet them
_AGAIN = 3
_ROOM = Path("/proc/self/statm")
_ENGINES: dict[str, Maker] = {engine.name: engine for engine in (Own, Chipmunk, Box2D)}


def seconds(makers: Sequence[Maker], bodies: int) -> dict[str, float]:
    """Return the seconds of a step of each engine while discs fall and pile up.

    Of each step the shortest of some runs counts, for they differ only by what else goes on.
    """
    scene = falling_discs(ROWS, bodies // ROWS)
    found: dict[str, list[list[float]]] = {}
    for make in (*makers,) * _AGAIN:
        engine = make(scene, TIME_STEP)
        engine.step()
        with undisturbed():
            times = [_seconds(engine) for _ in range(_STEPS)]
        found.setdefault(engine.name, []).append(times)
    return {name: sum(map(min, zip(*runs, strict=True))) / _STEPS for name, runs in found.items()}


def _seconds(engine: Engine) -> float:
    start = process_time()
    engine.step()
    return process_time() - start


def bytes_of_a_body(name: str, bodies: int = 20_000) -> float | None:
    """Return what an engine of that name takes for each body, without our `Scene`.

    A process of its own finds it, in which little else is; None where the system does not tell.
    """
    if not _ROOM.exists():
        return None
    code = f"from {__name__} import taken; print(taken({name!r}, {bodies}))"
    found = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    return float(found.stdout)


def taken(name: str, bodies: int) -> float:
    """Return the bytes of memory for each body in this process, after a second of steps."""
    make = _ENGINES[name]
    make(falling_discs(10, 10), TIME_STEP).step()  # what is loaded once is not counted
    scene = falling_discs(ROWS, bodies // ROWS)
    before = _room()
    engine = make(scene, TIME_STEP)
    for _ in range(_STEPS):
        engine.step()
    return (_room() - before) / bodies


def _room() -> int:
    from resource import getpagesize

    return int(_ROOM.read_text().split()[1]) * getpagesize()
