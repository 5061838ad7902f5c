"""Impacts a second of an elastic gas of discs or of polygons, located, beside Pymunk.

The bodies fill a tenth of a box. Located runs go on for so many impacts that their start does not
count. Pymunk takes steps in which a body of mean speed goes a hundredth of its radius, for as long
as each body meets about one other, and is compared with the located run: most of its impacts are
told late by a part of a step, and the positions differ by the median that is given.
"""

import math
from argparse import ArgumentParser
from time import process_time
from typing import Any

import numpy as np

from tamias2d.balance import balance
from tamias2d.contact import Located
from tamias2d.event_driven import EventDriven
from tamias2d.motion import ClosedForm
from tamias2d.scene import Box, Disc, HalfPlane, Polygon, Scene
from tamias2d.solve import solve
from tamias2d.study.engines.chipmunk import Chipmunk
from tamias2d.work_limit import Work
from tools.measurements.columns import Columns
from tools.measurements.progress import each

COUNTS = (100, 1000, 10_000)
POLYGONS = (10, 100, 1000)
IMPACTS = 200_000  # of a located run
_RADIUS = 0.01  # m
_SHARE = 0.1  # of the box
_WAY = 0.01  # of a radius, in a step of Pymunk at mean speed
_MOST_STEPS = 500  # of Pymunk
_PILOT = 0.05  # s
_NO_LIMIT = 10**9


def options(parser: ArgumentParser) -> None:
    """Add what can be chosen."""
    parser.add_argument("--counts", nargs="+", type=int, default=COUNTS, help="numbers of discs")
    parser.add_argument("--polygons", nargs="+", type=int, default=POLYGONS, help="of polygons")
    parser.add_argument("--impacts", type=int, default=IMPACTS, help="of each located run, about")
    parser.add_argument("--steps", type=int, default=_MOST_STEPS, help="of Pymunk, at most")


def gas(count: int, *, share: float = _SHARE, seed: int = 0) -> Scene:
    """Return discs of one size that fill a box to a share, at velocities by chance, about 1 m/s."""
    return _filled([Disc(radius=_RADIUS)], count, share, seed)


def polygon_gas(count: int, *, share: float = _SHARE, seed: int = 0) -> Scene:
    """Return squares and pentagons in turn that fill a box likewise.

    Their corners are as far from their middles as those of the discs, and at the speed of these.
    """
    side, turns = math.sqrt(2) * _RADIUS, [2 * math.pi * k / 5 for k in range(5)]
    corners = [(_RADIUS * math.cos(turn), _RADIUS * math.sin(turn)) for turn in turns]
    return _filled([Polygon(vertices=corners), Box(width=side, height=side)], count, share, seed)


def _filled(shapes: list[Disc | Polygon | Box], count: int, share: float, seed: int) -> Scene:
    """Return a box that bodies of some shapes in turn fill to a share; those with corners spin."""
    chance = np.random.default_rng(seed)
    width = math.sqrt(count * sum(shape.area for shape in shapes) / len(shapes) / share)
    scene = Scene(gravity=(0.0, 0.0))
    for normal, offset in (
        ((1.0, 0.0), 0.0), ((-1.0, 0.0), -width), ((0.0, 1.0), 0.0), ((0.0, -1.0), -width)
    ):  # fmt: skip
        scene.add_static(HalfPlane(normal=normal, offset=offset), restitution=1.0)
    across = math.ceil(math.sqrt(count))
    step = width / across
    slack = 0.9 * (step / 2 - _RADIUS)
    for k, place in enumerate(np.sort(chance.permutation(across**2)[:count]).tolist()):
        middle = np.array([place // across + 0.5, place % across + 0.5]) * step
        shape = shapes[k % len(shapes)]
        at = tuple((middle + chance.uniform(-slack, slack, 2)).tolist())
        going = tuple(chance.normal(0.0, 1.0, 2).tolist())
        turning = chance.normal(0.0, 1.0 / _RADIUS) if shape.vertices else 0.0
        scene.add_body(
            shape, mass=1.0, position=at, velocity=going, angular_velocity=turning, restitution=1.0
        )
    return scene


def measure(
    counts: list[int] | tuple[int, ...] = COUNTS,
    polygons: list[int] | tuple[int, ...] = POLYGONS,
    impacts: int = IMPACTS,
    steps: int = _MOST_STEPS,
) -> dict[str, Any]:
    """Return one row for each number of discs, then of polygons."""
    asked = [("discs", gas, count) for count in counts]
    asked += [("polygons", polygon_gas, count) for count in polygons]
    rows = [
        {"shapes": shapes, "bodies": count, **_row(made(count), impacts, steps)}
        for shapes, made, count in each(asked)
    ]
    return {"rows": rows, "share": _SHARE}


COLUMNS: Columns = {
    "bodies": "{bodies}",
    "shapes": "{shapes}",
    "impacts": "{impacts}",
    "a second": "{impacts_per_second:.2g}",
    "pairs looked at": "{looked_at_per_impact:.1f}",
    "energy": "{energy_error:.0e}",
    "Pymunk: a second": "{pymunk_impacts_per_second:.2g}",
    "off by, of a radius": "{pymunk_error:.1g}",
}


def _row(scene: Scene, impacts: int, steps: int) -> dict[str, Any]:
    pace = _followed(scene, _PILOT)["impacts"] / _PILOT
    return {**_followed(scene, impacts / max(pace, 1.0)), **_pymunk(scene, steps)}


def _followed(scene: Scene, duration: float) -> dict[str, Any]:
    """Return how many impacts a run has, how fast they are found, and how energy is kept."""
    times = np.array([0.0, duration])
    motion = ClosedForm().motion(scene, duration, duration)
    followed = EventDriven(scene, times, many=True)
    located = Located(scene, motion, Work(duration, _NO_LIMIT), followed)
    start = process_time()
    located.go(duration)
    spent = process_time() - start
    found = len(located.impacts)
    energy, _, _ = balance(scene, followed.history(located.tracks, times))
    return {
        "impacts": found,
        "impacts_per_second": found / spent,
        "looked_at_per_impact": followed.looked_at / max(found, 1),
        "energy_error": abs(float(energy[1] / energy[0]) - 1),
    }


def _pymunk(scene: Scene, steps: int) -> dict[str, float]:
    """Return the impacts a second of Pymunk, and how far off its positions are in the median."""
    time_step = _WAY * _RADIUS
    engine = Chipmunk(scene, time_step)
    start = process_time()
    engine.step(steps)
    spent = process_time() - start
    duration = steps * time_step
    exact = solve(scene, duration=duration, method=ClosedForm(), times=[duration])
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    way = engine.state()[moving, :2] - exact.position[-1, moving]
    return {
        "pymunk_impacts_per_second": len(exact.impacts) / spent,
        "pymunk_error": float(np.median(np.hypot(*way.T))) / _RADIUS,
    }
