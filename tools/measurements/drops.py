"""Ordinary drops beside Pymunk and Box2D v3 (pyb2d3): how deep do bodies get into each other?

Two to twelve discs, boxes and pentagons of 0.2 to 0.5 m fall from 1 to 5 m on a floor, at random
angles, with some friction and restitution, in steps of 1/60 s. The deepest overlap of a drop is the
deepest one at the end of any step, as a share of the smaller body's size. The energy is that of the
motion and of gravity.
"""

import math
from argparse import ArgumentParser
from typing import Any

import numpy as np

from tamias2d.scene import Box, Disc, HalfPlane, Polygon, Scene
from tamias2d.study.engines.box2d import Box2D
from tamias2d.study.engines.chipmunk import Chipmunk
from tamias2d.study.engines.engine import Maker
from tamias2d.study.engines.overlap import worst
from tamias2d.study.engines.own import Own
from tools.measurements.arena.followed import Followed
from tools.measurements.columns import Columns
from tools.measurements.progress import each

_ENGINES: tuple[Maker, ...] = (Own, Chipmunk, Box2D)
_STEPS = 180
_DEEP = 0.05  # of the smaller body


def options(parser: ArgumentParser) -> None:
    """Add what can be chosen."""
    parser.add_argument("--count", type=int, default=1000, help="drops (1000)")
    parser.add_argument("--first", type=int, default=0, help="seed of the first drop (0)")


def drop(seed: int) -> Scene:
    """Return a drop, as its seed has it."""
    chance = np.random.default_rng(seed)
    surface: Any = {"friction": chance.uniform(0.0, 0.8), "restitution": chance.uniform(0.0, 1.0)}
    scene = Scene(gravity=(0.0, -9.81), name=f"drop-{seed}")
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    for k in range(chance.integers(2, 13)):
        half = 0.5 * chance.uniform(0.2, 0.5)
        corners = [(half * math.cos(0.4 * math.pi * n), half * math.sin(0.4 * math.pi * n))
                   for n in range(5)]  # fmt: skip
        shapes = (
            Disc(radius=half),
            Box(width=2 * half, height=2 * half),
            Polygon(vertices=corners),
        )
        scene.add_body(
            shapes[chance.integers(3)],
            mass=chance.uniform(0.5, 5.0),
            position=(
                0.8 * (k % 4) + chance.uniform(-0.1, 0.1),
                1.0 + 1.4 * (k // 4) + chance.uniform(0.0, 0.5),
            ),
            orientation=chance.uniform(0.0, 6.0),
            **surface,
        )
    return scene


def deepest(make: Maker, scene: Scene, steps: int = _STEPS) -> tuple[str, float, float]:
    """Return the engine's name, its deepest overlap and largest rise of energy, as shares."""
    followed = Followed(make, scene)
    deep = 0.0
    for _ in range(steps):
        followed.step()
        deep = max(deep, 0.5 * worst(scene, followed.engine.state()).share)
    return followed.engine.name, deep, followed.gain


def measure(count: int = 1000, first: int = 0) -> dict[str, Any]:
    """Return a row for each engine."""
    seen: dict[str, list[list[float]]] = {}
    for seed in each(range(first, first + count), "Drops"):
        scene = drop(seed)
        for make in _ENGINES:
            name, *values = deepest(make, scene)
            seen.setdefault(name, []).append(values)
    rows = []
    for name, found in seen.items():
        overlaps, gains = np.array(found).T
        rows.append(
            {
                "engine": name,
                "deep": float((overlaps > _DEEP).mean()),
                "median": float(np.median(overlaps)),
                "worst": float(overlaps.max()),
                "seed": first + int(overlaps.argmax()),
                "gain": float(gains.max()),
            }
        )
    return {"count": count, "first": first, "rows": rows}


COLUMNS: Columns = {
    "engine": "{engine}",
    f"deeper than {_DEEP:.0%}": "{deep:.1%}",
    "median": "{median:.1%}",
    "worst": "{worst:.1%}",
    "its seed": "{seed}",
    "energy rises by": "{gain:.0e}",
}


def notes(found: dict[str, Any]) -> list[str]:
    """Return what the table leaves out."""
    return [f"{found['count']} drops of {_STEPS} steps, from seed {found['first']} on."]
