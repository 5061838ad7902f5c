"""Convex cores as the engine's arrays, and what numpy finds about them by trying everything."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.collide import collide
from tamias2d.engine.tables import Contacts, Shapes

Array = Any


@dataclass(frozen=True)
class Outline:
    """Corners counter-clockwise from the centre of mass, grown by a radius; or a half-plane."""

    vertices: Array
    radius: float = 0.0
    plane: bool = False

    @property
    def kind(self) -> int:
        if self.plane:
            return tb.HALF_PLANE
        return {1: tb.DISC, 2: tb.CAPSULE}.get(len(self.vertices), tb.POLYGON)

    def rows(self) -> Array:
        if self.plane:
            return np.array([[self.vertices[0][0], 0.0, *self.vertices[1]]])
        vertices = np.asarray(self.vertices, float)
        if len(vertices) == 1:
            return np.array([[*vertices[0], 0.0, 0.0]])
        along = np.roll(vertices, -1, axis=0) - vertices
        along /= np.hypot(*along.T)[:, None]
        return np.column_stack([vertices, along[:, 1], -along[:, 0]])

    def inradius(self) -> float:
        if self.plane:
            return -np.inf
        rows = self.rows()
        inner = (rows[:, :2] * rows[:, 2:]).sum(axis=1).min()
        return float(inner) if inner >= 0.0 else -np.inf

    def turned(self, angle: float) -> "Outline":
        if self.plane:
            return Outline((self.vertices[0], turn(np.array(self.vertices[1]), angle)), 0.0, True)
        return Outline(turn(np.asarray(self.vertices, float), angle), self.radius)

    def scaled(self, factor: float) -> "Outline":
        if self.plane:
            (offset, _), normal = self.vertices
            return Outline(((offset * factor, 0.0), normal), 0.0, True)
        return Outline(np.asarray(self.vertices) * factor, self.radius * factor)


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


def shape_arrays(outlines: Sequence[Outline]) -> Shapes:
    """Shapes, each of a body of its own, turned as they are."""
    rows = [outline.rows() for outline in outlines]
    counts = np.array([len(each) for each in rows], np.int32)
    material = np.zeros((len(rows), tb.END_SINE + 1))
    material[:, tb.SHAPE_INRADIUS] = [outline.inradius() for outline in outlines]
    vertices = np.vstack(rows)
    return Shapes(
        slot=np.arange(len(rows), dtype=np.uint32),
        kind=np.array([outline.kind for outline in outlines], np.int32),
        first=(np.cumsum(counts) - counts).astype(np.int32),
        vertex_count=counts,
        radius=np.array([outline.radius for outline in outlines]),
        material=material,
        stated=np.full((len(rows), 4), -1.0),
        filters=np.zeros((len(rows), 4), np.int64),
        local_vertices=vertices,
        world_vertices=vertices.copy(),
        boxes=np.zeros((len(rows), 8)),
        pair_overrides=np.zeros((0, 4)),
    )


def contact_arrays(pairs: Array) -> Contacts:
    """Contacts of pairs (k, 2) of shapes, before their first step."""
    rows = np.zeros((len(pairs), 4), np.uint32)
    rows[:, :2] = pairs
    manifolds, axes = np.zeros((len(rows), tb.MANIFOLD)), np.zeros((len(rows), 4))
    return Contacts(rows, manifolds, axes, np.zeros((len(rows), 6), np.int32))


class Contact:
    """A contact of two shapes, and its manifold."""

    def __init__(self) -> None:
        self.contacts = contact_arrays(np.array([[0, 1]]))

    def collide(self, a: Outline, b: Outline, delta: Array, margin: float = 1e100) -> int:
        """Find the manifold with B's body at `delta` from A's; return its number of points."""
        shapes = shape_arrays((a, b))
        return int(
            collide(0, 0, 1, float(delta[0]), float(delta[1]), margin, shapes, self.contacts)
        )

    @property
    def manifold(self) -> Array:
        return self.contacts.manifolds[0]

    @property
    def cached_axis(self) -> Array:
        """The relative pose that was seen when an axis was cached, and how far it holds."""
        return self.contacts.axes[0]

    @property
    def impulses(self) -> Array:
        """Normal and tangent impulse of both points, which may be written."""
        return self.manifold.reshape(2, tb.POINT)[:, tb.NORMAL_IMPULSE : tb.NORMAL_IMPULSE + 2]

    @property
    def normal(self) -> Array:
        return self.manifold[:2]

    @property
    def count(self) -> int:
        return int(self.contacts.flags[0, tb.POINT_COUNT])

    @property
    def points(self) -> Array:
        return self.manifold.reshape(2, tb.POINT)[: self.count, tb.PX : tb.PY + 1]

    @property
    def gaps(self) -> Array:
        return self.manifold[tb.GAP : tb.GAP + 2 * tb.POINT : tb.POINT][: self.count]

    @property
    def features(self) -> list[int]:
        return list(self.contacts.flags[0, tb.FEATURE : tb.FEATURE + self.count])


def separation(a: Outline, b: Outline, delta: Array) -> float:
    """The distance of the cores, or by how much they overlap along the best side, negative."""
    p, q = np.asarray(a.vertices), np.asarray(b.vertices) + delta
    along = [_separations(a.rows(), p, q), _separations(b.rows(), q, p)]
    best = max(float(each.max(initial=-np.inf)) for each in along)
    touching = (len(p) > 1 and len(q) > 1) or max(len(p), len(q)) > 2
    if touching and best < 0 and not (len(p) == len(q) == 2 and not _cross(p, q)):
        return best
    return min(_nearest(p, q), _nearest(q, p))


def outside(outline: Outline, points: Array) -> Array:
    """How far points are outside of a shape, from its centre; 0 inside its core."""
    if outline.plane:
        return np.asarray(points) @ np.asarray(outline.vertices[1]) - outline.vertices[0][0]
    vertices = np.asarray(outline.vertices)
    found = []
    for point in points:
        value = _nearest(vertices, point[None])
        if len(vertices) > 2 and _separations(outline.rows(), vertices, point[None]).max() < 0:
            value = 0.0
        found.append(value - outline.radius)
    return np.array(found)


def _separations(rows: Array, p: Array, q: Array) -> Array:
    if len(p) == 1:
        return np.array([])
    return np.array([min((q - v) @ n) for v, n in zip(p, rows[:, 2:], strict=True)])


def _nearest(p: Array, q: Array) -> float:
    """The distance from the vertices of q to the sides of p."""
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
