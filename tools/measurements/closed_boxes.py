"""Closed boxes of random walls, in which crowds and bullets fly about: does any body get out?

Each box has a seed: its walls, its bodies, their speeds and surfaces are drawn from it. A body is
out if it is ever wholly beyond the outer side of the walls: contacts yield under a load.
"""

import math
import random
import warnings
from argparse import ArgumentParser
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

import tamias2d as t2
from tamias2d.scene import Shape
from tamias2d.state import Array
from tools.measurements.columns import Columns
from tools.measurements.progress import each

WALLS = ("segments", "boards", "half-planes", "loop", "frame", "driven frame")
ASKED = ("driven loop",)  # walls that are not drawn, but may be asked for
ENDS = ("overlap", "just meet")  # at corners; half-planes overlap, and the sides of a loop meet
BODIES = ("disc", "box", "capsule", "polygon", "segment", "needle")
SECONDS = 3.0


@dataclass(frozen=True)
class ClosedBox:
    """A scene whose last bodies are inside walls around the origin."""

    seed: int
    walls: str
    ends: str
    half: float  # m, from the middle to the inner side of a wall
    thickness: float  # m, of a wall
    reach: Array  # m, (n,) of the circles around bodies
    time_step: float  # s
    scene: t2.Scene

    def outside(self, position: Array, orientation: Array) -> int:
        """Return how many bodies are beyond the walls, given all poses."""
        driven = self.walls.startswith("driven")
        middle, turn = (position[0], orientation[0]) if driven else (np.zeros(2), 0.0)
        c, s = math.cos(turn), math.sin(turn)
        away = (position[-len(self.reach) :] - middle) @ np.array([[c, -s], [s, c]])
        farthest = np.abs(away).max(axis=1)
        return int((farthest > self.half + self.thickness + self.reach).sum())


def options(parser: ArgumentParser) -> None:
    """Add what can be chosen."""
    parser.add_argument("--count", type=int, default=200, help="boxes (200)")
    parser.add_argument("--first", type=int, default=0, help="seed of the first box (0)")
    parser.add_argument("--bodies", type=int, default=60, help="in a box at most (60)")
    parser.add_argument("--walls", choices=WALLS + ASKED, help="of all boxes (at random)")


def measure(
    count: int = 200, first: int = 0, bodies: int = 60, walls: str | None = None
) -> dict[str, Any]:
    """Return for each kind of walls how many boxes kept all bodies, and the seeds of others."""
    rows: dict[tuple[str, str], dict[str, Any]] = {}
    for seed in each(range(first, first + count), "boxes"):
        box = closed_box(seed, bodies, walls)
        row = rows.setdefault((box.walls, box.ends), _row(box))
        row["boxes"] += 1
        row["bodies"] += len(box.reach)
        row["fastest"] = max(row["fastest"], _fastest(box))
        if (warned := leaks(box)) is not None:
            row["told" if warned else "leaky"].append(seed)
    return {"first": first, "rows": [rows[key] for key in sorted(rows)]}


def _row(box: ClosedBox) -> dict[str, Any]:
    counts: dict[str, Any] = {"boxes": 0, "bodies": 0, "fastest": 0.0, "leaky": [], "told": []}
    return {"walls": box.walls, "ends": box.ends, **counts}


COLUMNS: Columns = {
    "walls": "{walls}",
    "ends": "{ends}",
    "boxes": "{boxes}",
    "bodies": "{bodies}",
    "fastest, radii a step": "{fastest:.3g}",
    "lost one": lambda row: str(len(row["leaky"])),
    "told": lambda row: str(len(row["told"])),
    "seeds": lambda row: " ".join(str(seed) for seed in row["leaky"][:5]),
}


def notes(found: dict[str, Any]) -> list[str]:
    """Return the sum."""
    boxes = sum(row["boxes"] for row in found["rows"])
    lost, told = (sum(len(row[key]) for row in found["rows"]) for key in ("leaky", "told"))
    return [
        f"{boxes - lost - told} of {boxes} boxes kept all bodies; {told} told that they may not"
    ]


def leaks(box: ClosedBox) -> bool | None:
    """Return whether a step warned of a box before a body is outside; `None` if none ever is."""
    sim = t2.Simulator(box.scene, time_step=box.time_step)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", t2.StepWarning)
        for _ in range(math.ceil(SECONDS / box.time_step)):
            sim.step()
            if box.outside(sim.position, sim.orientation):
                return bool(sim.warnings)
    return None


def closed_box(seed: int, most: int, asked: str | None = None) -> ClosedBox:
    """Return the box of a seed, with so many bodies at most, and the walls that are asked for."""
    chance = random.Random(seed)
    drawn, half = chance.choice(WALLS), 10.0 ** chance.uniform(-1.0, 1.5)
    walls = asked or drawn
    ends = "overlap" if walls == "half-planes" else "just meet" if walls.endswith("loop") else ""
    ends = ends or chance.choice(ENDS)
    thin = walls not in ("boards", "frame", "driven frame")
    thickness = 0.0 if thin else half * 10.0 ** chance.uniform(-9.0, -1.0)
    surface = _surface(chance)
    gravity = chance.choice((0.0, 9.81))
    scene = t2.Scene(gravity=(0.0, -gravity))
    longer = half * chance.uniform(0.01, 1.0) if ends == "overlap" else 0.0
    if walls in ("segments", "boards", "half-planes"):
        _add_walls(scene, walls, half, thickness, longer, surface)
    else:
        _add_container(scene, walls, _container(walls, half, thickness, longer), chance, surface)
    side = math.ceil(math.sqrt(chance.choice((1, 3, chance.randint(2, most)))))
    cell = 1.9 * half / side
    count = min(side * side, most)
    reaches = []
    time_step = chance.choice((1 / 60, 1 / 60, 1 / 30, 1 / 240))
    for k in range(count):
        row, column = divmod(k, side)
        place = ((column + 0.5 - 0.5 * side) * cell, (row + 0.5 - 0.5 * side) * cell)
        radius = 0.45 * cell * 10.0 ** chance.uniform(-1.5, 0.0)
        shape = _body(chance.choice(BODIES), radius)
        reach = shape.bounding_radius
        speed = reach * 10.0 ** chance.uniform(-2.0, 1.5) / time_step
        aim = chance.uniform(-math.pi, math.pi)
        scene.add_body(
            shape,
            mass=10.0 ** chance.uniform(-1.0, 1.0),
            position=place,
            orientation=chance.uniform(-math.pi, math.pi),
            velocity=(speed * math.cos(aim), speed * math.sin(aim)),
            angular_velocity=chance.choice((0.0, chance.uniform(-30.0, 30.0))),
            **_surface(chance),
        )
        reaches.append(reach)
    return ClosedBox(seed, walls, ends, half, thickness, np.array(reaches), time_step, scene)


def _surface(chance: random.Random) -> dict[str, Any]:
    return {
        "restitution": chance.choice((0.0, 0.0, 0.5, 1.0)),
        "friction": chance.choice((0.0, 0.4, 1.0)),
    }


def _add_walls(
    scene: t2.Scene,
    walls: str,
    half: float,
    thickness: float,
    longer: float,
    surface: dict[str, Any],
) -> None:
    """Add walls whose inner sides are so far from the origin, and which are longer by so much."""
    for shape, place, turn in _sides(half, thickness, longer):
        if walls == "half-planes":
            inwards = (-place[0] / half, -place[1] / half)
            scene.add_static(t2.HalfPlane(normal=inwards, offset=-half), **surface)
        else:
            scene.add_static(shape, position=place, orientation=turn, **surface)


def _add_container(
    scene: t2.Scene, walls: str, shape: Shape, chance: random.Random, surface: dict[str, Any]
) -> None:
    """Add walls that are one body, which stands, or is driven at up to 3 m/s and 3 rad/s."""
    if walls.startswith("driven"):
        scene.add_kinematic(
            shape,
            position=(0.0, 0.0),
            velocity=(chance.uniform(-3.0, 3.0), chance.uniform(-3.0, 3.0)),
            angular_velocity=chance.uniform(-3.0, 3.0),
            **surface,
        )
    else:
        scene.add_static(shape, position=(0.0, 0.0), **surface)


def _container(walls: str, half: float, thickness: float, longer: float) -> Shape:
    if walls.endswith("loop"):
        corners = [(-half, -half), (half, -half), (half, half), (-half, half)]
        return t2.Chain(vertices=corners, loop=True)
    sides = _sides(half, thickness, longer)
    return t2.Compound(
        parts=[t2.Part(shape=side, position=at, orientation=turn) for side, at, turn in sides]
    )


def _sides(
    half: float, thickness: float, longer: float
) -> Iterator[tuple[t2.Box | t2.Segment, tuple[float, float], float]]:
    """Yield the four sides of a box: their shapes, places and orientations."""
    middle, length = half + 0.5 * thickness, 2.0 * (half + thickness + longer)
    for k in range(4):
        turn = k * math.pi / 2
        place = (middle * round(math.cos(turn)), middle * round(math.sin(turn)))
        if thickness:
            yield t2.Box(width=thickness, height=length), place, turn
        else:
            yield t2.Segment(length=length), place, turn + math.pi / 2


def _body(kind: str, radius: float) -> Shape:
    """Return a shape within a circle of this radius, m."""
    if kind == "box":
        return t2.Box(width=1.2 * radius, height=0.8 * radius)
    if kind == "capsule":
        return t2.Capsule(length=1.2 * radius, radius=0.3 * radius)
    if kind == "polygon":
        turns = [2 * math.pi * k / 5 for k in range(5)]
        return t2.Polygon(vertices=[(radius * math.cos(t), radius * math.sin(t)) for t in turns])
    if kind == "segment":
        return t2.Segment(length=2.0 * radius)
    if kind == "needle":
        return t2.Box(width=2.0 * radius, height=1e-4 * radius)
    return t2.Disc(radius=radius)


def _fastest(box: ClosedBox) -> float:
    """Return how far a body goes in a step as the box begins, of its radius."""
    moving = box.scene.bodies[-len(box.reach) :]
    speed = np.array([math.hypot(*body.velocity) for body in moving])
    return float((speed * box.time_step / box.reach).max())
