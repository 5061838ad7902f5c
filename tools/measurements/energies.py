"""Energy of random mechanisms that nothing drives, over many steps of the frame loop: does it rise?

Two to eight bodies each, in a tree of joints of all kinds with a loop now and then, under gravity.
Looked at is every step. What was found of a seed is kept in a file, a line each, so that a long
measurement is done in parts, and goes on where it was interrupted. 1e4 mechanisms over 1e5 steps
take some twelve hours of one core.
"""

import argparse
import json
import warnings
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from tamias2d.errors import StepWarning
from tamias2d.simulator import Simulator
from tools.measurements.mechanisms.faults import Energy
from tools.measurements.mechanisms.programs import rates_of
from tools.measurements.mechanisms.random_mechanism import EQUATIONS, LIMITS, random_mechanism
from tools.measurements.progress import each, until_stopped

_STEP = 1 / 60
ROUNDING = 1e-9  # of all that gravity gave or motion had
_WORST = 10


def options(parser: argparse.ArgumentParser) -> None:
    """Add which mechanisms, how long, and where to keep what was found."""
    parser.add_argument("--count", type=int, default=200, help="mechanisms (200)")
    parser.add_argument("--first", type=int, default=2_000_000, help="seed of the first (2000000)")
    parser.add_argument("--steps", type=int, default=10_000, help="of each mechanism (10000)")
    parser.add_argument(
        "--more", choices=(LIMITS, EQUATIONS), help="that bounce, or of one's own, besides"
    )
    parser.add_argument("--kept", type=Path, help="file of what was found: begun, or gone on with")


def measure(
    count: int = 200,
    first: int = 2_000_000,
    steps: int = 10_000,
    more: str | None = None,
    kept: Path | None = None,
) -> dict[str, Any]:
    """Return how much the energy of each mechanism rose, as a share of what was at play."""
    asked = (steps, more)
    known = {r["seed"]: r for r in _kept(kept) if (r["steps"], r.get("more")) == asked}
    seeds = range(first, first + count)
    with until_stopped():
        for seed in each([seed for seed in seeds if seed not in known], "Mechanisms"):
            known[seed] = _followed(seed, steps, more)
            if kept:
                with kept.open("a") as file:
                    file.write(json.dumps(known[seed]) + "\n")
    return {"steps": steps, "rows": [known[seed] for seed in seeds if seed in known]}


def table(found: dict[str, Any]) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """Return heads and rows for people: how energies rose that were told, and that were not."""
    heads = ("warned of", "mechanisms", "rise", "median", "99 %", "at most", f"above {ROUNDING:g}")
    return heads, [
        (words, str(len(rows)), what, *_spread([row[key] for row in rows]))
        for words, rows in _parted(found["rows"])
        for what, key in (("above the first", "above"), ("in a step", "gain"))
    ]


def notes(found: dict[str, Any]) -> list[str]:
    """Return what the columns mean, and the worst seeds."""
    worst = sorted(found["rows"], key=lambda row: -row["above"])[:_WORST]
    named = ", ".join(f"{row['seed']} ({row['above']:.1e})" for row in worst)
    return [
        f"{found['steps']} steps of 1/60 s; shares of the most that gravity gave or motion had",
        f"highest above the first: seeds {named}",
    ]


def _followed(seed: int, steps: int, more: str | None) -> dict[str, Any]:
    """Return how the energy of a mechanism rose, and whether its steps warned."""
    scene = random_mechanism(seed, more)
    seen = Energy(scene)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", StepWarning)
        sim = Simulator(scene, time_step=_STEP)
        for _ in range(steps):
            seen.look(np.column_stack((sim.position, sim.orientation)), rates_of(sim))
            sim.step()
        seen.look(np.column_stack((sim.position, sim.orientation)), rates_of(sim))
    return {
        "seed": seed,
        "steps": steps,
        "more": more,
        "above": seen.above,
        "gain": seen.gain,
        "warned": bool(sim.warnings),
    }


def _kept(file: Path | None) -> Iterator[dict[str, Any]]:
    if file and file.exists():
        yield from map(json.loads, file.read_text().splitlines())


def _parted(rows: list[dict[str, Any]]) -> Iterable[tuple[str, list[dict[str, Any]]]]:
    parts = (("no", False), ("yes", True))
    found = [(words, [row for row in rows if row["warned"] == told]) for words, told in parts]
    return [(words, part) for words, part in found if part]


def _spread(values: list[float]) -> tuple[str, ...]:
    numbers = (np.median(values), np.quantile(values, 0.99), max(values))
    return (*(f"{number:.1e}" for number in numbers), str(sum(v > ROUNDING for v in values)))
