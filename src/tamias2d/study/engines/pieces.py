"""Shapes as rounded convex pieces: corners in the body's own axes, and a radius.

Serves: the peers' worlds, and the overlap that no engine reports. Hides: the kinds of shapes.
"""

from typing import NamedTuple

from tamias2d.scene import Body, HalfPlane, Scene
from tamias2d.scene.compound import pieces_of
from tamias2d.scene.rules import Vector

_LONG, _DEEP = 10.0, 2.0  # times the size of the scene: a half-plane in an engine without such


class ConvexPart(NamedTuple):
    """A convex hull of one corner or more, rounded by a radius; m."""

    corners: tuple[Vector, ...]
    radius: float = 0.0


def pieces(body: Body, size: float) -> list[ConvexPart]:
    """Return what a body consists of; a half-plane is a box that reaches far beyond `size`, m."""
    if body.shape is None:
        return []
    if isinstance(body.shape, HalfPlane):
        return [ConvexPart(_slab(body.shape, size))]
    return [ConvexPart(part.core, part.shape.rounding) for part in pieces_of(body.shape)]


def size_of(scene: Scene) -> float:
    """Return a length in m that no body that moves freely is beyond at the start."""
    places = [abs(value) for body in scene.bodies for value in body.position]
    offsets = [abs(b.shape.offset) for b in scene.bodies if isinstance(b.shape, HalfPlane)]
    return max(*places, *offsets, *reaches(scene))


def reaches(scene: Scene) -> list[float]:
    """Return the radius of the circle that holds each body that moves freely, m."""
    return [body.shape.bounding_radius for body in scene.bodies if body.dynamic and body.shape]


def _slab(shape: HalfPlane, size: float) -> tuple[Vector, ...]:
    (x, y), top = shape.normal, shape.offset
    bottom, half = top - _DEEP * size, _LONG * size
    ends = ((half, bottom), (-half, bottom), (-half, top), (half, top))
    return tuple((x * up + y * along, y * up - x * along) for along, up in reversed(ends))
