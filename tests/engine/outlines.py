"""Shapes as the stepped way's arrays, and what numpy finds about them by trying everything."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from tamias2d.stepped.layout import (
    CAPSULE,
    COUNT,
    DISC,
    FEATURE,
    GAP,
    HALF_PLANE,
    POINT,
    POLYGON,
    PX,
    PY,
    TOUCH,
)
from tamias2d.stepped.manifold import collide

Array = Any


@dataclass(frozen=True)
class Outline:
    """Corners counter-clockwise from the centre of mass, grown by a radius; or a half-plane."""

    corners: Array
    radius: float = 0.0
    plane: bool = False

    @property
    def kind(self) -> int:
        if self.plane:
            return HALF_PLANE
        return {1: DISC, 2: CAPSULE}.get(len(self.corners), POLYGON)

    def rows(self) -> Array:
        if self.plane:
            return np.array([[self.corners[0][0], 0.0, *self.corners[1]]])
        corners = np.asarray(self.corners, float)
        if len(corners) == 1:
            return np.array([[*corners[0], 0.0, 0.0]])
        along = np.roll(corners, -1, axis=0) - corners
        along /= np.hypot(*along.T)[:, None]
        return np.column_stack([corners, along[:, 1], -along[:, 0]])

    def surface(self) -> list[float]:
        """A row of surfaces: of use is only how near the sides are to the centre."""
        if self.plane:
            return [0.0, 0.0, 0.0, -np.inf]
        rows = self.rows()
        inner = (rows[:, :2] * rows[:, 2:]).sum(axis=1).min()
        return [0.0, 0.0, 0.0, inner if inner >= 0.0 else -np.inf]

    def turned(self, angle: float) -> "Outline":
        if self.plane:
            return Outline((self.corners[0], turn(np.array(self.corners[1]), angle)), 0.0, True)
        return Outline(turn(np.asarray(self.corners, float), angle), self.radius)

    def scaled(self, factor: float) -> "Outline":
        if self.plane:
            (offset, _), normal = self.corners
            return Outline(((offset * factor, 0.0), normal), 0.0, True)
        return Outline(np.asarray(self.corners) * factor, self.radius * factor)


def turn(vectors: Array, angle: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return vectors @ np.array([[c, s], [-s, c]])


def disc(radius: float, at: tuple[float, float] = (0.0, 0.0)) -> Outline:
    return Outline(np.array([at]), radius)


def capsule(length: float, radius: float = 0.0) -> Outline:
    return Outline(np.array([[-length / 2, 0.0], [length / 2, 0.0]]), radius)


def box(width: float, height: float) -> Outline:
    x, y = width / 2, height / 2
    return Outline(np.array([[-x, -y], [x, -y], [x, y], [-x, y]]))


def regular(count: int, size: float) -> Outline:
    angles = 2 * np.pi * np.arange(count) / count
    return Outline(size * np.column_stack([np.cos(angles), np.sin(angles)]))


def half_plane(offset: float, normal: tuple[float, float] = (0.0, 1.0)) -> Outline:
    return Outline(((offset, 0.0), normal), 0.0, True)


class Pairing:
    """Two shapes with a row for their manifold."""

    def __init__(self, collide: Any = collide) -> None:
        self.touch = np.zeros((1, TOUCH))
        self.trace = np.zeros((1, 6), np.int32)
        self.collide = collide

    def __call__(self, a: Outline, b: Outline, delta: Array, margin: float = 1e100) -> int:
        rows = np.vstack([a.rows(), b.rows()])
        count = len(a.rows())
        return int(
            self.collide(
                0,
                0,
                1,
                float(delta[0]),
                float(delta[1]),
                margin,
                np.array([a.kind, b.kind], np.int8),
                np.array([0, count], np.int32),
                np.array([count, len(rows) - count], np.int32),
                np.array([a.radius, b.radius]),
                np.array([a.surface(), b.surface()]),
                rows,
                self.touch,
                self.trace,
            )
        )

    @property
    def normal(self) -> Array:
        return self.touch[0, :2]

    @property
    def count(self) -> int:
        return int(self.trace[0, COUNT])

    @property
    def points(self) -> Array:
        return self.touch[0].reshape(2, POINT)[: self.count, PX : PY + 1]

    @property
    def gaps(self) -> Array:
        return self.touch[0, GAP : GAP + 2 * POINT : POINT][: self.count]

    @property
    def features(self) -> list[int]:
        return list(self.trace[0, FEATURE : FEATURE + self.count])


def room(a: Outline, b: Outline, delta: Array) -> float:
    """The distance of the cores, or by how much they overlap along the best side, negative."""
    p, q = np.asarray(a.corners), np.asarray(b.corners) + delta
    along = [_rooms(a.rows(), p, q), _rooms(b.rows(), q, p)]
    best = max(float(each.max(initial=-np.inf)) for each in along)
    touching = (len(p) > 1 and len(q) > 1) or max(len(p), len(q)) > 2
    if touching and best < 0 and not (len(p) == len(q) == 2 and not _cross(p, q)):
        return best
    return min(_nearest(p, q), _nearest(q, p))


def outside(outline: Outline, points: Array) -> Array:
    """How far points are outside of a shape, from its centre; 0 inside its core."""
    if outline.plane:
        return np.asarray(points) @ np.asarray(outline.corners[1]) - outline.corners[0][0]
    corners = np.asarray(outline.corners)
    found = []
    for point in points:
        value = _nearest(corners, point[None])
        if len(corners) > 2 and _rooms(outline.rows(), corners, point[None]).max() < 0:
            value = 0.0
        found.append(value - outline.radius)
    return np.array(found)


def _rooms(rows: Array, p: Array, q: Array) -> Array:
    if len(p) == 1:
        return np.array([])
    return np.array([min((q - v) @ n) for v, n in zip(p, rows[:, 2:], strict=True)])


def _nearest(p: Array, q: Array) -> float:
    """The distance from the corners of q to the sides of p."""
    best = np.inf
    for start, end in zip(p, np.roll(p, -1, axis=0), strict=True):
        along = end - start
        for point in q:
            t = np.clip((point - start) @ along / max(along @ along, 1e-300), 0, 1)
            best = min(best, float(np.hypot(*(point - start - t * along))))
    return best


def _cross(p: Array, q: Array) -> bool:
    def side(u: Array, v: Array, w: Array) -> float:
        return float((v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0]))

    return (
        side(p[0], p[1], q[0]) * side(p[0], p[1], q[1]) < 0
        and side(q[0], q[1], p[0]) * side(q[0], q[1], p[1]) < 0
    )
