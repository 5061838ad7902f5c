"""Bodies of all shapes, as thin as nothing, thrown on floors as thin: does one pass through?

Each throw has a seed: body, floor, speeds, surface and the direction of gravity are drawn from it.
A body has passed if its centre of mass is ever below the floor, which is 400 m wide.
"""

import math
import random
from argparse import ArgumentParser
from dataclasses import dataclass
from typing import Any

import numpy as np

import tamias2d as t2
from tamias2d.scene import Shape
from tamias2d.state import Array
from tools.measurements.columns import Columns
from tools.measurements.progress import each

WAYS = ("stepped", "located")
BODIES = ("segment", "board", "capsule", "disc", "needle", "polygon", "cross")
FLOORS = ("segment", "board", "capsule", "polygon", "row", "half-plane")
KINDS = ("static", "static", "lifted", "heavy")
WIDE = 400.0  # m, of a floor
SECONDS = 2.0
SOFT = 0.2  # of its radius: how far a body may be pressed in, which has not passed
SMALLEST = 1e-7  # m, of a disc: gravity outruns smaller ones in any part of a step, which is told
_HEAVY = 1e6  # kg


@dataclass(frozen=True)
class Throw:
    """A scene in which the second body is thrown on the first."""

    seed: int
    body: str
    floor: str
    kind: str
    thickness: float  # m, of the floor
    reach: float  # m, of the circle around the body
    up: tuple[float, float]
    time_step: float  # s
    scene: t2.Scene

    def heights(self, position: Array, orientation: Array) -> Array:
        """Return how far the body's centre is above the floor, which may turn, m."""
        turned = orientation[..., 0] - self.scene.bodies[0].orientation
        x, y = np.moveaxis(position[..., 1, :] - position[..., 0, :], -1, 0)
        c, s = np.cos(turned), np.sin(turned)
        found: Array = x * (c * self.up[0] - s * self.up[1]) + y * (s * self.up[0] + c * self.up[1])
        return found

    def passes(self, position: Array, orientation: Array) -> bool:
        """Return whether the body is on the other side of the floor at any time, given all poses.

        Contacts that are solved softly may press it in by a part of its size.
        """
        lowest = self.heights(position, orientation)
        return bool((lowest < -0.5 * self.thickness - SOFT * self.reach).any())


def options(parser: ArgumentParser) -> None:
    """Add what can be chosen."""
    parser.add_argument("--count", type=int, default=10_000, help="throws for each way (10 000)")
    parser.add_argument("--first", type=int, default=0, help="seed of the first throw (0)")
    parser.add_argument("--way", choices=WAYS, action="append", help="one way only")


def measure(count: int = 10_000, first: int = 0, way: list[str] | None = None) -> dict[str, Any]:
    """Return a row for each way and pair of shapes, with the seeds of what passed."""
    ways = tuple(way or WAYS)
    rows: dict[tuple[str, str, str], dict[str, Any]] = {}
    for name in ways:
        for seed in each(range(first, first + count), name):
            one = throw(seed)
            key = (name, one.body, one.floor)
            row = rows.setdefault(key, _row(*key))
            row["throws"] += 1
            found = (stepped if name == "stepped" else located)(one)
            row["refused"] += found is None
            row["passed"] += [seed] if found else []
    return {"count": count, "first": first, "rows": [rows[key] for key in sorted(rows)]}


def _row(way: str, body: str, floor: str) -> dict[str, Any]:
    empty: list[int] = []
    return {
        "way": way,
        "body": body,
        "floor": floor,
        "throws": 0,
        "refused": 0,
        "passed": empty,
    }


COLUMNS: Columns = {
    "way": "{way}",
    "body": "{body}",
    "floor": "{floor}",
    "throws": "{throws}",
    "refused": "{refused}",
    "passed": lambda row: str(len(row["passed"])),
    "seeds": lambda row: " ".join(str(seed) for seed in row["passed"][:5]),
}


def notes(found: dict[str, Any]) -> list[str]:
    """Return the sums."""
    lines = []
    for way in WAYS:
        rows = [row for row in found["rows"] if row["way"] == way]
        passed = sum(len(row["passed"]) for row in rows)
        refused = sum(row["refused"] for row in rows)
        throws = sum(row["throws"] for row in rows)
        if rows:
            lines.append(f"{way}: {passed} of {throws} passed, {refused} refused by name")
    return lines


def stepped(one: Throw) -> bool:
    """Return whether a body passes where it is stepped."""
    sim = t2.Simulator(one.scene, time_step=one.time_step)
    for _ in range(math.ceil(SECONDS / one.time_step)):
        sim.step()
        if one.passes(sim.position, sim.orientation):
            return True
    return False


def located(one: Throw) -> bool | None:
    """Return whether a body passes where its impacts are located; `None` if that is refused."""
    try:
        run = t2.simulate(one.scene, duration=SECONDS)
    except t2.TamiasError:
        return None
    return one.passes(run.position, run.orientation)


def throw(seed: int) -> Throw:
    """Return the throw of a seed."""
    chance = random.Random(seed)
    body, floor, kind = chance.choice(BODIES), chance.choice(FLOORS), chance.choice(KINDS)
    if floor == "half-plane":
        kind = "static"
    thickness = 0.0 if floor in ("segment", "row", "half-plane") else _thickness(chance)
    turn = chance.choice((0.0, chance.uniform(-math.pi, math.pi)))
    up = (-math.sin(turn), math.cos(turn))
    surface: dict[str, Any] = {
        "restitution": chance.choice((0.0, 0.0, 0.5, 1.0)),
        "friction": chance.choice((0.0, 0.4, 1.0)),
    }
    pull = 0.0 if kind == "heavy" else 9.81
    scene = t2.Scene(gravity=(-pull * up[0], -pull * up[1]))
    shape = _floor(floor, thickness)
    if kind == "heavy":
        scene.add_body(shape, mass=_HEAVY, position=(0.0, 0.0), orientation=turn, **surface)
    elif kind == "lifted":
        speed = chance.uniform(0.0, 3.0)
        velocity = (speed * up[0], speed * up[1])
        scene.add_kinematic(
            shape, position=(0.0, 0.0), orientation=turn, velocity=velocity, **surface
        )
    elif floor == "half-plane":
        scene.add_static(t2.HalfPlane(normal=up, offset=0.0), **surface)
    else:
        scene.add_static(shape, position=(0.0, 0.0), orientation=turn, **surface)
    thrown, reach = _body(body, chance)
    height = reach + 0.5 * thickness + chance.choice((1e-3, 0.1, 1.0))
    speed, aim = chance.uniform(0.0, 10.0), chance.uniform(-math.pi, 0.0)
    scene.add_body(
        thrown,
        mass=10.0 ** chance.uniform(-2.0, 2.0),
        position=(height * up[0], height * up[1]),
        orientation=turn + chance.choice((0.0, math.pi / 2, chance.uniform(-3.0, 3.0))),
        velocity=(speed * math.cos(turn + aim), speed * math.sin(turn + aim)),
        angular_velocity=chance.choice((0.0, chance.uniform(-10.0, 10.0))),
        **surface,
    )
    time_step = chance.choice((1 / 60, 1 / 60, 1 / 30, 1 / 240))
    return Throw(seed, body, floor, kind, thickness, reach, up, time_step, scene)


def _thickness(chance: random.Random) -> float:
    """Return a thickness, m: often that of a sheet, and down to nearly nothing."""
    return math.pow(10.0, chance.choice((chance.uniform(-3.0, -0.7), chance.uniform(-12.0, -3.0))))


def _floor(kind: str, thickness: float) -> Shape:
    if kind == "board":
        return t2.Box(width=WIDE, height=thickness)
    if kind == "capsule":
        return t2.Capsule(length=WIDE, radius=0.5 * thickness)
    if kind == "polygon":  # a parallelogram
        half, skew = 0.5 * thickness, 1.0
        right, left = 0.5 * WIDE, -0.5 * WIDE
        corners = [(left, -half), (right, -half), (right + skew, half), (left + skew, half)]
        return t2.Polygon(vertices=corners)
    if kind == "row":  # of segments, end to end
        count = 9
        length = WIDE / count
        places = [(length * (k - count // 2), 0.0) for k in range(count)]
        line = t2.Segment(length=length)
        return t2.Compound(parts=[t2.Part(shape=line, position=place) for place in places])
    return t2.Segment(length=WIDE)


def _body(kind: str, chance: random.Random) -> tuple[Shape, float]:
    """Return a shape, and the radius of the circle around it, m."""
    size, thickness = 10.0 ** chance.uniform(-1.5, 0.5), _thickness(chance)
    thin = min(thickness, size)
    if kind == "board":
        shape: Shape = t2.Box(width=size, height=thin)
    elif kind == "capsule":
        shape = t2.Capsule(length=size, radius=0.5 * thin)
    elif kind == "disc":
        shape = t2.Disc(radius=max(0.5 * thin, SMALLEST))
    elif kind == "needle":
        shape = t2.Polygon(vertices=[(0.0, 0.0), (size, 0.0), (0.0, max(thin, 1e-7 * size))])
    elif kind == "polygon":
        shape = t2.Polygon(vertices=[(0.0, 0.0), (size, 0.0), (0.8 * size, size), (0.0, size)])
    elif kind == "cross":
        line = t2.Segment(length=size)
        shape = t2.Compound(parts=[t2.Part(shape=line), t2.Part(shape=line, orientation=1.5)])
    else:
        shape = t2.Segment(length=size)
    return shape, shape.bounding_radius
