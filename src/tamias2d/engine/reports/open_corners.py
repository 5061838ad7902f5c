"""Thin walls that only just meet: what is thin is pressed past the end of one, and slips out.

Contacts yield by a small part of a body's size. What is thinner than that, and lies on one wall,
passes beside the end of the next one, unless that reaches farther. Cost: a sweep over the shapes
that do not move freely, if some of them are thin and a body is, as often as they change.
"""

import math
from collections.abc import Iterator, Sequence
from itertools import islice
from typing import NamedTuple

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import BodyState, Shapes
from tamias2d.state import Array

YIELDS = 2.0**-8  # of how far a body reaches: walls that overlap by more hold it
SLENDER = 2.0**-6  # of that: what is less than so thick, from its centre, may slip out


class OpenCorners:
    """Where thin walls only just meet, as far as that was asked."""

    def __init__(self) -> None:
        """Know of none."""
        self._asked = b""
        self._found: tuple[int, int, int] | None = None

    def find(self, state: BodyState, shapes: Shapes) -> tuple[int, int, int] | None:
        """Return the rows of two walls that only just meet, and of a thin body; or None."""
        if not len(state.body_of_slot):
            return None
        thin = (shapes.kind == tb.THIN_CAPSULE) | (shapes.kind == tb.THIN_POLYGON)
        if not thin.any():
            return None
        row = state.body_of_slot[shapes.slot].astype(np.int64)
        free = state.kind[row] == tb.DYNAMIC
        wide, half = state.properties[row, tb.BOUNDING_RADIUS], state.properties[row, tb.MIN_EXTENT]
        reach = np.where(free & (half < SLENDER * wide), wide, 0.0)
        if not reach.any() or not (thin & ~free).any():
            return None
        solid = (shapes.vertex_count > 0) & (
            shapes.filters[:, tb.SENSOR] == 0
        )  # removed ones have none
        walls = np.flatnonzero(~free & (shapes.kind < tb.PIECE) & solid)
        asked = walls.tobytes() + reach.max().tobytes()
        if asked != self._asked:
            self._asked, self._found = asked, None
            placed = [_placed(k, int(row[k]), bool(thin[k]), state, shapes) for k in walls.tolist()]
            for a, b in islice(_just_met(placed, YIELDS * float(reach.max())), 1):
                self._found = int(row[walls[a]]), int(row[walls[b]]), int(row[reach.argmax()])
        return self._found

    def know(self, state: BodyState, shapes: Shapes) -> None:
        """Find none until other walls or bodies come: of those there are it was told before.

        They may have moved since, and are not asked about again for that.
        """
        self.find(state, shapes)
        self._found = None


class _Wall(NamedTuple):
    """A convex shape where it stands."""

    corners: Array
    """(c, 2), m"""
    sides: Array
    """(c, 2), outward normals"""
    ends: Array
    """(2, 2), outward normals of the ends of one that is thin, or (0, 2)"""
    radius: float
    """m, around the corners; infinite for a half-plane, which has one corner"""

    @property
    def low(self) -> Array:
        """The lower corner of the box around it, (2,), m."""
        return self.corners.min(axis=0) - self.radius

    @property
    def high(self) -> Array:
        """The upper corner, likewise."""
        return self.corners.max(axis=0) + self.radius


def _placed(k: int, row: int, thin: bool, state: BodyState, shapes: Shapes) -> _Wall:
    """Return the shape k of a body, where that is."""
    first = shapes.first[k]
    vertices = shapes.local_vertices[first : first + shapes.vertex_count[k]]
    x, y, turn = state.pose[row]
    turned = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    sides = vertices[:, 2:] @ turned
    if shapes.kind[k] == tb.HALF_PLANE:
        return _Wall(vertices[0, 0] * sides + (x, y), sides, np.zeros((0, 2)), math.inf)
    corners = vertices[:, :2] @ turned + (x, y)
    length = corners[np.hypot(*(corners - corners[0]).T).argmax()] - corners[0]
    ends = np.array([length, -length]) / np.hypot(*length) if thin else np.zeros((0, 2))
    return _Wall(corners, sides, ends, float(shapes.radius[k]))


def _just_met(walls: Sequence[_Wall], most: float) -> Iterator[tuple[int, int]]:
    """Go through the pairs that end at each other, and part or overlap by at most so much, m."""
    boxes = [(*wall.low.tolist(), *wall.high.tolist()) for wall in walls]
    near: list[int] = []
    for k in sorted(range(len(walls)), key=boxes.__getitem__):
        left, low, _, high = boxes[k]
        near = [m for m in near if boxes[m][2] >= left - most]
        for m in near:
            beside = boxes[m][1] > high + most or low > boxes[m][3] + most
            if not beside and _ends_at(walls[m], walls[k], most):
                yield m, k
        near.append(k)


def _ends_at(a: _Wall, b: _Wall, most: float) -> bool:
    """Return whether an end of one of two shapes is at the other one."""
    sides = max(_gap_along(a.sides, a, b), _gap_along(b.sides, b, a))
    ends = max(_gap_along(a.ends, a, b), _gap_along(b.ends, b, a))
    if math.isinf(a.radius + b.radius):  # on a half-plane a thin shape stands, or lies
        return abs(sides) <= most and len(a.ends) + len(b.ends) > 0
    return ends >= -most and max(sides, ends) <= most


def _gap_along(normals: Array, p: _Wall, q: _Wall) -> float:
    """Return the largest gap before P along its outward normals (k, 2), m."""
    if not len(normals) or math.isinf(q.radius):
        return -math.inf
    radius = 0.0 if math.isinf(p.radius) else p.radius
    gaps = (normals @ q.corners.T).min(axis=1) - (normals @ p.corners.T).max(axis=1)
    return float(gaps.max()) - radius - q.radius
