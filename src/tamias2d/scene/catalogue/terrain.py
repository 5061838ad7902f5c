"""Scenes on terrain."""

import math

from tamias2d.scene.catalogue.stacks import FRICTION, GRAVITY, add
from tamias2d.scene.chain import Chain
from tamias2d.scene.compound import Compound, Part, Shape
from tamias2d.scene.scene import Scene
from tamias2d.scene.shapes import Box, Capsule, Disc, Polygon

_PIECES = 200
_ENDS = (-15.0, 15.0)


def hill(name: str) -> Scene:
    """Return bodies of all shapes above a hill between two hollows."""
    scene = Scene(
        gravity=GRAVITY,
        name=name,
        says="bodies of all shapes on a hill of two hundred pieces, where they slide and roll",
        duration=8.0,
    )
    left, right = _ENDS
    places = [right + (left - right) * k / _PIECES for k in range(_PIECES + 1)]
    ground = [(round(x, 6), round(_height(x), 6)) for x in places]
    chain = Chain(vertices=[(right, 8.0), *ground, (left, 8.0)], one_sided=True)
    scene.add_static(chain, friction=FRICTION, restitution=0.0, name="hill")
    bar, knob = Capsule(length=0.8, radius=0.1), Disc(radius=0.3)
    dumbbell = Compound(
        parts=[Part(shape=bar), *(Part(shape=knob, position=(x, 0.0)) for x in (-0.5, 0.5))]
    )
    shapes: tuple[Shape, ...] = (
        Disc(radius=0.4),
        Box(width=0.8, height=0.5),
        Capsule(length=0.7, radius=0.2),
        Polygon(vertices=[(-0.5, -0.3), (0.5, -0.3), (0.0, 0.6)]),
        dumbbell,
    )
    for k in range(15):
        x = -7.0 + k
        friction = 0.02 if k % 2 else FRICTION
        at = (x, round(_height(x), 6) + 1.5 + 0.4 * (k % 3))
        add(scene, shapes[k % 5], mass=1.0, at=at, friction=friction)
    return scene


def _height(x: float) -> float:
    return 2.0 * math.cos(0.42 * x) + 0.15 * math.cos(2.5 * x)
