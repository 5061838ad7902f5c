"""Which directions separate two convex pieces of bodies, at many times at once.

A direction w from A to B separates them by the least of w . b over the points b of B, less the
largest of w . a over those of A. Convex pieces are apart where one of these does: a normal of a
side or, where one of the two is a line or a point, a line between corners. Of directions that are
less than a right angle and a half apart, all between them separate, too.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.scene import Body, HalfPlane
from tamias2d.scene.compound import pieces_of
from tamias2d.state import Array, History

Flags = NDArray[np.bool_]

_NEAR = -0.5  # cosine between directions that are surely joined by others


class SeparableHull(NamedTuple):
    """A convex piece of a body, in the body's axes."""

    body: int
    corners: Array
    """(m, 2), m"""
    radius: float
    """Around the corners and what lies between them, m."""
    normals: Array
    """(s, 2), unit, out of its sides"""
    reach: float
    """Of the farthest corner from the centre of mass, m."""
    size: float
    """The radius around it, m."""
    offset: float | None
    """How far out a half-plane reaches along its normal, m; None for others."""


class View(NamedTuple):
    """What c directions say of two pieces at k times."""

    directions: Array
    """(k, c, 2), unit, from A to B"""
    separation: Array
    """(k, c), m"""
    distance: Array
    """(k, c), m: between the corners on whose line a direction is; infinite for normals"""
    between: Array
    """(k, 2), m: from the centre of mass of A's body to that of B's"""
    angles: Array
    """(k, 2), rad: of both bodies"""

    def rows(self, chosen: slice | NDArray[np.int64]) -> "View":
        """Return the view at some of the times."""
        return View(*(part[chosen] for part in self))


def hulls_of(index: int, body: Body) -> list[SeparableHull]:
    """Return the convex pieces of a body that has a shape."""
    if isinstance(body.shape, HalfPlane):
        normal, offset = np.array([body.shape.normal]), body.shape.offset
        return [SeparableHull(index, normal * offset, 0.0, normal, 0.0, math.inf, offset)]
    assert body.shape is not None
    found = []
    for part in pieces_of(body.shape):
        corners, radius = np.array(part.core), part.shape.rounding
        reach = float(np.hypot(*corners.T).max())
        size = float(np.hypot(*(corners - corners.mean(axis=0)).T).max()) + radius
        found.append(SeparableHull(index, corners, radius, _normals(corners), reach, size, None))
    return found


def view(a: SeparableHull, b: SeparableHull, history: History) -> View:
    """Return how the directions of two pieces separate them along the history of their bodies."""
    between = history.position[:, 1] - history.position[:, 0]
    angles = history.orientation
    corners_a, corners_b = _turned(a.corners, angles[:, 0]), _turned(b.corners, angles[:, 1])
    directions = [_turned(a.normals, angles[:, 0])]
    if a.offset is None:
        directions.append(-_turned(b.normals, angles[:, 1]))
        steps = between[:, None, None] + corners_b[:, None] - corners_a[:, :, None]
        steps = steps.reshape(len(between), -1, 2)
        if min(len(a.corners), len(b.corners)) > 2:
            steps = steps[:, :0]
        length = np.hypot(steps[..., 0], steps[..., 1])
        directions.append(steps / np.where(length > 0, length, 1.0)[..., None])
    found = np.concatenate(directions, axis=1)
    distance = np.full(found.shape[:2], math.inf)
    inner = _along(found, corners_a).max(axis=-1) if a.offset is None else a.offset
    if a.offset is None and length.shape[1]:
        distance[:, -length.shape[1] :] = length
    outer = _along(found, corners_b).min(axis=-1) + np.einsum("kcx,kx->kc", found, between)
    separation = outer - inner - a.radius - b.radius
    return View(found, np.where(distance > 0, separation, -math.inf), distance, between, angles)


def joined(reached: Flags, separating: Flags, directions: Array) -> Flags:
    """Return (c,): the separating directions joined to those reached, through separating ones."""
    links = (directions @ directions.T > _NEAR) & separating[:, None] & separating
    while True:
        wider: Flags = (links @ reached) | (reached & separating)
        if (wider == reached).all():
            return wider
        reached = wider


def divided(separating: Flags, seen: View) -> Flags:
    """Return (k,): at which times some separating direction seems not to be joined to the best."""
    best = np.argmax(np.where(separating, seen.separation, -math.inf), axis=1)
    ahead = np.take_along_axis(seen.directions, best[:, None, None], axis=1)
    cosine = (seen.directions * ahead).sum(axis=-1)
    far: Flags = (separating & (cosine <= _NEAR)).any(axis=1)
    return far


def _normals(corners: Array) -> Array:
    """Return the unit normals out of all sides; a line has one on either side."""
    sides = np.roll(corners, -1, axis=0) - corners
    length = np.hypot(*sides.T)
    sides = sides[length > 0] / length[length > 0, None]
    return np.stack((sides[:, 1], -sides[:, 0]), axis=-1)


def _turned(vectors: Array, angle: Array) -> Array:
    """Return (k, m, 2): vectors (m, 2) of a body's axes in those of the world, at angles (k,)."""
    cosine, sine = np.cos(angle)[:, None], np.sin(angle)[:, None]
    x, y = vectors[:, 0], vectors[:, 1]
    return np.stack((cosine * x - sine * y, sine * x + cosine * y), axis=-1)


def _along(directions: Array, corners: Array) -> Array:
    """Return (k, c, m): how far corners (k, m, 2) lie along directions (k, c, 2)."""
    found: Array = np.einsum("kcx,kmx->kcm", directions, corners)
    return found
