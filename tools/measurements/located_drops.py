"""Ordinary drops whose impacts are located: how many come to their end, and do they obey the laws?

The drops are those of `drops`, for 3 s. Each has a process of its own with a limit of processor
time. Of 720 instants of each run it is looked at:

- overlap: the deepest one, as a share of the smaller body's radius;
- energy: its largest rise from one instant to the next, as a share of the energy above the floor;
- momentum: the floor alone pushes, upwards by no less than its told impulses and, until a body
  rests on it, by just these; sideways by no more than friction times that. What is off counts as a
  share of the weight of all bodies times the duration.

With --store FILE each drop is written there as a line of JSON, and what is there is not run again.
Stop it by Ctrl-C or SIGTERM, and what was found is printed.
"""

import json
import math
import re
import time
from argparse import ArgumentParser
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

from tamias2d.errors import TamiasError
from tamias2d.event_driven import LIBRARY
from tamias2d.motion import ClosedForm
from tamias2d.run import Run
from tamias2d.simulate import simulate
from tamias2d.state import Array
from tamias2d.study.engines.overlap import worst
from tools.measurements.drops import drop
from tools.measurements.in_time import in_time
from tools.measurements.progress import each, until_stopped

_DURATION, _SAMPLES = 3.0, 720
ROUNDING = 1e-11
"""What a drop may be off of each law: its rests begin where bounces are left that are so small."""
LAWS = "overlap", "energy", "momentum"


def options(parser: ArgumentParser) -> None:
    """Add what can be chosen."""
    parser.add_argument("--count", type=int, default=1000, help="drops (1000)")
    parser.add_argument("--first", type=int, default=0, help="seed of the first drop (0)")
    parser.add_argument("--limit", type=int, default=120, help="s of the processor for each (120)")
    parser.add_argument("--store", type=Path, metavar="FILE", help="write each drop there, go on")


def measure(
    count: int = 1000, first: int = 0, limit: int = 120, store: Path | None = None
) -> dict[str, Any]:
    """Return a row for each drop."""
    rows = _stored(store)
    if LIBRARY.is_kept():
        LIBRARY.compiled()  # here, so that the process of each drop has it at hand
    with until_stopped():
        for seed in each(range(first, first + count), "Drops"):
            if seed not in rows:
                rows[seed] = _row(seed, limit)
                if store is not None:
                    with store.open("a") as file:
                        file.write(json.dumps(rows[seed]) + "\n")
    found = [row for seed, row in sorted(rows.items()) if first <= seed < first + count]
    return {"first": first, "limit": limit, "rows": found}


def table(found: dict[str, Any]) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """Return heads and rows for people: how drops ended, and the worst of each law."""
    rows = found["rows"]
    lines = []
    for outcome, count in Counter(row["outcome"] for row in rows).most_common():
        of = [row for row in rows if row["outcome"] == outcome]
        low, high = interval(count, len(rows))
        lines.append(
            (
                outcome,
                f"{count}",
                f"{count / len(rows):.1%} ({low:.1%} to {high:.1%})",
                f"{np.median([row['seconds'] for row in of]):.2g} s",
                *(f"{max(row.get(law, math.nan) for row in of):.0e}" for law in LAWS),
            )
        )
    return ("outcome", "drops", "share (95 % confidence)", "takes", *LAWS), lines


def notes(found: dict[str, Any]) -> list[str]:
    """Return what was not located to the end, or broke a law."""
    return [
        f"{row['seed']}: {row['outcome']} after {row['seconds']:.1f} s: {row['said']}"
        for row in found["rows"]
        if row["outcome"] != "located"
    ]


def interval(count: int, of: int) -> tuple[float, float]:
    """Return Wilson's interval of a share, which holds it with 95 % confidence."""
    share, z = count / of, 1.96
    middle = (share + z * z / (2 * of)) / (1 + z * z / of)
    width = z / (1 + z * z / of) * math.sqrt(share * (1 - share) / of + (z / (2 * of)) ** 2)
    return max(middle - width, 0.0), min(middle + width, 1.0)


def laws(run: Run) -> dict[str, float]:
    """Return by how much a run of a drop is off of each law, as shares."""
    bodies = [body for body in run.scene.bodies if body.dynamic]
    states = np.dstack((run.position, run.orientation, run.velocity, run.angular_velocity))
    return {
        "overlap": worst(run.scene, *states).share,
        "energy": float(max(np.diff(run.energy).max() / run.energy[0], 0.0)),
        "momentum": _momentum(run, sum(body.mass for body in bodies)),
    }


def _momentum(run: Run, mass: float) -> float:
    (floor,) = (k for k, body in enumerate(run.scene.bodies) if not body.dynamic)
    friction = run.scene.bodies[floor].friction or 0.0
    weight = mass * -run.scene.gravity[1]
    side, up = np.diff(run.momentum, axis=0).T
    up = up + weight * np.diff(run.times)
    excess = up - _told(run, floor)
    resting = run.times[1:] > _first_rest(run, floor)
    off = [np.maximum(-excess, 0.0), np.where(resting, 0.0, np.abs(excess))]
    off.append(np.maximum(np.abs(side) - friction * np.maximum(up, 0.0), 0.0))
    return float(np.max(off)) / (weight * run.duration)


def _told(run: Run, floor: int) -> Array:
    """Return the impulses of the floor that a run tells of, between its samples, N s."""
    on_floor = (run.impacts.bodies == floor).any(axis=1)
    found, _ = np.histogram(
        run.impacts.time[on_floor],
        np.nextafter(run.times, math.inf),  # at the instant of an impact a sample is after it
        weights=run.impacts.impulse[on_floor],
    )
    return found


def _first_rest(run: Run, floor: int) -> float:
    name = f"'{run.scene.bodies[floor].name}'"
    rests = [note for note in run.notes if note.startswith("rest: ") and name in note]
    since = [float(found[1]) for note in rests if (found := re.search(r"from (\S+) s", note))]
    return min(since, default=math.inf)


def _row(seed: int, limit: int) -> dict[str, Any]:
    late = {"seed": seed, "outcome": "late", "said": f"more than {limit} s", "seconds": limit}
    found: dict[str, Any] = in_time(_located, (seed,), limit) or late
    return found


def _located(seed: int) -> dict[str, Any]:
    began = time.process_time()
    said, off = "", {}
    times = np.linspace(0.0, _DURATION, _SAMPLES + 1)
    try:
        run = simulate(drop(seed), duration=_DURATION, method=ClosedForm(), times=times)
        seconds = time.process_time() - began
        off = laws(run)
        outcome = "located"
        if broken := [law for law, value in off.items() if not value <= ROUNDING]:
            outcome = f"off: {', '.join(broken)}"
    except TamiasError as refused:
        seconds, said = time.process_time() - began, f"{refused}"
        rule = re.search(r"\(([A-Z]+\d+)", said)
        outcome = f"{type(refused).__name__} ({rule[1] if rule else '-'})"
    except Exception as fault:
        seconds = time.process_time() - began
        outcome, said = f"fault: {type(fault).__name__}", f"{fault}"
    return {"seed": seed, "outcome": outcome, "said": said, "seconds": seconds, **off}


def _stored(store: Path | None) -> dict[int, dict[str, Any]]:
    if store is None or not store.exists():
        return {}
    rows = [json.loads(line) for line in store.read_text().splitlines()]
    return {row["seed"]: row for row in rows}
