"""What it buys to model only what a scene requires: time and memory traffic of a body's step.

The kernel for gravity alone is compared with those that also know constant forces and rotation,
and all terms. Beside each stands what the machine's memory allows: the time in which the plainest
of loops, a = b + s a, moves as many bytes, from arrays of the same total size in the same blocks.
"""

from collections.abc import Callable
from statistics import median
from time import perf_counter
from typing import Any

import numpy as np

from tamias2d.kernels import Demand, compiled
from tamias2d.kernels.source import BLOCK, arguments
from tools.measurements.columns import Columns

BODIES = (100, 1_000, 10_000, 100_000)
_WORK = 10_000_000  # body-steps of one timing
_REPEATS = 9
_SCHEME = "semi_implicit_euler"
DEMANDS = {
    "gravity": Demand(_SCHEME),
    "forces and rotation": Demand(_SCHEME, rotation=True, forces=True),
    "all terms": Demand(_SCHEME, rotation=True, forces=True, linear_drag=True, quadratic_drag=True),
}


def measure() -> dict[str, Any]:
    """Return rows of medians, interleaved: one for each number of bodies and each demand."""
    rows: list[dict[str, Any]] = []
    for bodies in BODIES:
        steps = max(_WORK // bodies, 2)
        runs = {name: _flight(demand, bodies, steps) for name, demand in DEMANDS.items()}
        loops = {name: _plain_loop(demand, bodies) for name, demand in DEMANDS.items()}
        times: dict[str, list[float]] = {name: [] for name in runs}
        limits: dict[str, list[float]] = {name: [] for name in runs}
        for _ in range(_REPEATS + 1):  # the first compiles
            for name, demand in DEMANDS.items():
                times[name].append(_seconds(runs[name]) / bodies / steps * 1e9)
                limits[name].append(_bytes(demand) * loops[name]())
        everything = times["all terms"][1:]
        for name, demand in DEMANDS.items():
            own, limit = times[name][1:], limits[name][1:]
            rows.append(
                {
                    "bodies": bodies,
                    "demand": name,
                    "arrays": len(_arrays(demand)),
                    "bytes": _bytes(demand),
                    "ns": median(own),
                    "gain": median(a / b for a, b in zip(everything, own, strict=True)),
                    "limit_ns": median(limit),
                    "of_limit": median(a / b for a, b in zip(own, limit, strict=True)),
                }
            )
    return {"scheme": _SCHEME, "rows": rows}


COLUMNS: Columns = {
    "bodies": "{bodies}",
    "kernel for": "{demand}",
    "arrays": "{arrays}",
    "bytes": "{bytes}",
    "ns": "{ns:.3f}",
    "gain": "{gain:.1f}",
    "memory's ns": "{limit_ns:.3f}",
    "ratio": "{of_limit:.2f}",
}


def _arrays(demand: Demand) -> list[str]:
    return [a for a in arguments(demand)[1:] if not a.startswith(("gravity", "acceleration_"))]


def _states(demand: Demand) -> list[str]:
    return [a for a in _arrays(demand) if a.startswith(("positions", "velocities"))]


def _bytes(demand: Demand) -> int:
    """Bytes of a body's step: each array is read, and the state is written back."""
    return 8 * (len(_arrays(demand)) + len(_states(demand)))


def _flight(demand: Demand, bodies: int, steps: int) -> Any:
    generator = np.random.default_rng(0)
    values: list[Any] = [np.arange(steps + 1) / 1024]
    for name in arguments(demand)[1:]:
        is_array = name in _arrays(demand)
        values.append(generator.uniform(0.5, 1.0, bodies) if is_array else -9.81)
    kernel = compiled(demand)
    return lambda: kernel(*values)


def _plain_loop(demand: Demand, bodies: int) -> Callable[[], float]:
    """Return a measurement of the ns that a byte takes in the plainest loop."""
    from numba import njit

    @njit
    def loop(steps: int, a: Any, b: Any) -> None:
        for first in range(0, len(a), BLOCK):
            block_a, block_b = a[first : first + BLOCK], b[first : first + BLOCK]
            for _ in range(steps):
                for i in range(len(block_a)):
                    block_a[i] = block_b[i] + 0.5 * block_a[i]

    length = max(len(_arrays(demand)) * bodies // 2, 1)
    a, b = np.ones(length), np.ones(length)
    steps = max(_WORK // length, 2)
    moved = 3 * 8 * length * steps  # two reads and a write
    return lambda: _seconds(lambda: loop(steps, a, b)) / moved * 1e9


def _seconds(call: Any) -> float:
    start = perf_counter()
    call()
    return perf_counter() - start
