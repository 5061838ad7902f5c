"""Scenes of a thousand bodies: poured, tumbled, and in flight.

Where sizes and places should look random they follow multiples of the golden ratio, which are the
same on every machine.
"""

import math

from tamias2d.scene.catalogue.stacks import FRICTION, GRAVITY, add, on_floor
from tamias2d.scene.compound import Compound, Part
from tamias2d.scene.scene import Scene
from tamias2d.scene.shapes import Box, Disc, HalfPlane, Polygon

_GOLDEN = (math.sqrt(5) - 1) / 2
_BODIES = 1000


def disc_pile(name: str) -> Scene:
    """Return discs above the floor of a container."""
    scene = on_floor(name, "a thousand discs poured into a container of three walls", duration=20.0)
    for name, side in (("left", -1.0), ("right", 1.0)):
        wall = HalfPlane(normal=(-side, 0.0), offset=-5.0)
        scene.add_static(wall, friction=FRICTION, restitution=0.0, name=name)
    for k in range(_BODIES):
        radius = round(0.2 + 0.05 * _spread(k), 4)
        x = -4.6 + 0.51 * (k % 19) + 0.04 * (_spread(7 * k) - 0.5)
        at = (round(x, 6), 0.3 + 0.51 * (k // 19))
        add(scene, Disc(radius=radius), mass=round(math.pi * radius**2, 6), at=at)
    return scene


def tumbler(name: str) -> Scene:
    """Return polygons in a square drum that turns about its middle."""
    scene = Scene(
        gravity=GRAVITY,
        name=name,
        says="a thousand convex polygons of 3 to 8 corners in a square drum that turns",
        duration=20.0,
    )
    flat, upright = Box(width=22.0, height=1.0), Box(width=1.0, height=20.0)
    walls = [Part(shape=flat, position=(0.0, y)) for y in (-10.5, 10.5)]
    walls += [Part(shape=upright, position=(x, 0.0)) for x in (-10.5, 10.5)]
    scene.add_kinematic(
        Compound(parts=walls),
        position=(0.0, 0.0),
        angular_velocity=0.5,
        friction=FRICTION,
        restitution=0.0,
        name="drum",
    )
    for k in range(_BODIES):
        stone = _stone(3 + k % 6, math.tau * _spread(k))
        at = (0.6 * (k % 32) - 9.3, 0.6 * (k // 32) - 9.3)
        add(scene, stone, mass=round(stone.area, 6), at=at)
    return scene


def free_discs(name: str) -> Scene:
    """Return discs that fall side by side and never meet."""
    scene = Scene(gravity=GRAVITY, name=name, says="a thousand discs in free flight", duration=5.0)
    for k in range(_BODIES):
        add(scene, Disc(radius=0.25), mass=1.0, at=(float(k % 32), float(k // 32)))
    return scene


def _stone(corners: int, start: float) -> Polygon:
    """Return a regular polygon of a radius of 0.3 m."""
    angles = [start + math.tau * k / corners for k in range(corners)]
    outline = [(round(0.3 * math.cos(a), 6), round(0.3 * math.sin(a), 6)) for a in angles]
    return Polygon(vertices=outline)


def _spread(k: int) -> float:
    """Return the k-th of numbers that fill 0 to 1 evenly, without a pattern that is seen."""
    return k * _GOLDEN % 1.0
