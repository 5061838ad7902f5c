"""What accuracy costs, beside Pymunk and Box2D (pyb2d3), on scenes of all kinds.

With --store DIR the studies are written there, a file for each scene; the docs draw their pictures
from those in docs/measured/fronts. All scenes take some minutes. Stop it by Ctrl-C, and what is
stored stays.
"""

import json
from argparse import ArgumentParser
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from tamias2d.scene import catalogue
from tamias2d.storage import write_aside
from tamias2d.study import work_precision
from tamias2d.study.contact_candidates import RATES
from tamias2d.study.contact_study import contact_study
from tamias2d.study.report import as_json, contacts_as_json
from tamias2d.study.stepped_plan import stepped_because
from tools.measurements.columns import Table
from tools.measurements.progress import each, until_stopped

SCENES = {
    "projectiles": 2.0,
    "bouncing-elastic": 3.0,
    "oblique-discs": 3.0,
    "kepler": 10.0,
    "quadratic-drag": 3.0,
    "pendulum": 5.0,
    "spring-chain": 0.5,
    "slider-crank": 1.0,
    "incline": 1.0,
    "dominoes": 1.0,
    "arch": 1.0,
    "card-house": 1.0,
    "pyramid-30": 0.2,
    "disc-pile": 0.2,
    "bullet-wall": 1.0,
}
"""Names of the catalogue, and how long each is simulated, s."""
_LINE, _LINE_OF_STEPS = 1e-6, 1e-2  # the tolerances in the pictures
_PHASES, _STARTS = 8, 4


def options(parser: ArgumentParser) -> None:
    """Add what can be chosen."""
    parser.add_argument(
        "--scenes", nargs="+", choices=SCENES, metavar="SCENE",
        help=f"these alone, of {', '.join(SCENES)}",
    )  # fmt: skip
    parser.add_argument("--store", type=Path, metavar="DIR", help="also write each study there")


def measure(
    scenes: Sequence[str] | None = None,
    store: Path | None = None,
    rates: Sequence[int] = RATES,
) -> dict[str, Any]:
    """Return the studies of all scenes, in the form of `tradeoff --json`."""
    found: dict[str, Any] = {}
    with until_stopped():
        for name in each(list(scenes or SCENES)):
            found[name] = _study(name, rates)
            if store is not None:
                store.mkdir(parents=True, exist_ok=True)
                write_aside(store / f"{name}.json", (json.dumps(found[name]) + "\n").encode())
    return found


def _study(name: str, rates: Sequence[int]) -> dict[str, Any]:
    scene, duration = catalogue.load(name), SCENES[name]
    if reason := stepped_because(scene, duration):
        steps = contact_study(
            scene, duration=duration, reason=reason, phases_asked=_STARTS, rates=rates
        )
        return contacts_as_json(steps, tolerance=_LINE_OF_STEPS)
    found = work_precision.study(scene, duration=duration, phases_asked=_PHASES)
    return as_json(found, tolerance=_LINE)


def table(found: dict[str, Any]) -> Table:
    """Return heads and rows for people: how many settings of each engine, and how they ended."""
    heads = ("scene", "s", "contacts", "settings", "failed", "floor", "horizon, s")
    return heads, [
        (
            name,
            f"{study['duration']:g}",
            study.get("contacts", "located"),
            f"{len(study['points'])}",
            f"{sum(point['failure'] is not None for point in study['points'])}",
            f"{study['floor']:.0e}",
            f"{study.get('horizon', study['duration']):.3g}",
        )
        for name, study in found.items()
    ]


def notes(found: dict[str, Any]) -> list[str]:
    """Return why candidates failed, each reason once."""
    said = {
        f"{name}, {point['method']}: {point['failure']}": None
        for name, study in found.items()
        for point in study["points"]
        if point["failure"]
    }
    return list(said)
