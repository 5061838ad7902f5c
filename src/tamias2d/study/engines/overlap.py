"""How deep bodies are in each other, computed from where they are, and asked of no engine.

Serves: the judgement of engines. Hides: which pairs are near, and how depths are found.

Two convex hulls overlap by the least that one must move to leave the other, which is along the
normal of one of their sides; two that are apart are so by the least distance of a corner of one to
a side of the other. Radii are then added.
"""

import math
from collections.abc import Iterator
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from tamias2d.scene import Body, HalfPlane, Scene
from tamias2d.scene.filters import filters, may_touch
from tamias2d.state import Array
from tamias2d.study.engines.pieces import ConvexPart, pieces

_FLAT = 1e-12  # of a hull's size: an overlap below it may be rounding, and is a distance
_AT_ONCE = 50_000  # pairs, to bound the memory that they take

Indices: TypeAlias = NDArray[np.int64]


class Overlap(NamedTuple):
    """The worst: in m, and as shares of the smaller body."""

    depth: float
    share: float
    """of the radius of the largest circle in it"""
    share_of_size: float
    """of the radius around it"""


class _Solids:
    """All pieces of a scene as arrays; corners are repeated where others have more."""

    def __init__(self, scene: Scene) -> None:
        held = [
            (k, piece)
            for k, body in enumerate(scene.bodies)
            if body.shape is not None and not isinstance(body.shape, HalfPlane) and not body.sensor
            for piece in pieces(body, 0.0)
        ]
        most = max((len(piece.corners) for _, piece in held), default=1)
        self.body = np.array([k for k, _ in held])
        self.moves = np.array([scene.bodies[k].dynamic for k in self.body])
        self.radius = np.array([piece.radius for _, piece in held])
        self.inner = np.array([_inner(piece) for _, piece in held])
        self.outer = np.array([_outer(scene.bodies[k]) for k, _ in held])
        padded = [
            piece.corners + piece.corners[-1:] * (most - len(piece.corners)) for _, piece in held
        ]
        self._corners = np.array(padded).reshape(len(padded), most, 2)

    def corners(self, state: Array) -> Array:
        """Return (m, c, 2) in world axes, m."""
        at = state[self.body]
        cos, sin = np.cos(at[:, 2, None]), np.sin(at[:, 2, None])
        x, y = self._corners[..., 0], self._corners[..., 1]
        turned = np.stack((cos * x - sin * y, sin * x + cos * y), axis=-1)
        return np.asarray(turned + at[:, None, :2])


def worst(scene: Scene, state: Array) -> Overlap:
    """Return the deepest overlap of a scene in a state (n, 6) of all its bodies, or 0."""
    solids = _Solids(scene)
    corners = solids.corners(state)
    found = [Overlap(0.0, 0.0, 0.0), *_in_half_planes(scene, solids, corners)]
    filtered = any(filters(body) for body in scene.bodies)
    for first, second in _near(solids, corners):
        apart = separations(corners[first], corners[second])
        depth = solids.radius[first] + solids.radius[second] - apart
        if filtered:
            depth = np.where(_solid_pairs(scene, solids, first, second), depth, 0.0)
        inner = np.minimum(solids.inner[first], solids.inner[second])
        outer = np.minimum(solids.outer[first], solids.outer[second])
        found.append(_worst_of(depth, inner, outer))
    return Overlap(*(max(column) for column in zip(*found, strict=True)))


def _worst_of(depth: Array, inner: Array, outer: Array) -> Overlap:
    """Return the largest of depths, m, and of their shares of radii in and around bodies, m."""
    if not len(depth):
        return Overlap(0.0, 0.0, 0.0)
    return Overlap(float(depth.max()), float((depth / inner).max()), float((depth / outer).max()))


def _solid_pairs(scene: Scene, solids: _Solids, first: Indices, second: Indices) -> Array:
    pairs = zip(solids.body[first].tolist(), solids.body[second].tolist(), strict=True)
    return np.array([may_touch(scene.bodies[a], scene.bodies[b]) for a, b in pairs], dtype=bool)


def separations(first: Array, second: Array) -> Array:
    """Return (p,) separations, m, of pairs of hulls (p, c, 2), (p, d, 2) without their radii."""
    across = np.maximum(_gaps(first, second), _gaps(second, first))
    between = np.minimum(_distances(first, second), _distances(second, first))
    size = np.abs(second - first[:, :1]).max(axis=(1, 2))
    overlap = np.isfinite(across) & (across < -_FLAT * size)
    return np.where(overlap, across, between)


def _gaps(first: Array, second: Array) -> Array:
    """Return the largest gap along the outward normals of the first ones' sides; -inf if none."""
    sides = np.roll(first, -1, axis=1) - first
    length = np.hypot(sides[..., 0], sides[..., 1])
    normals = np.stack((sides[..., 1], -sides[..., 0]), axis=-1)
    with np.errstate(invalid="ignore", divide="ignore"):
        normals /= length[..., None]
    reach = np.einsum("pkx,plkx->plk", normals, second[:, :, None] - first[:, None])
    return np.asarray(np.where(length > 0, reach.min(axis=1), -np.inf).max(axis=1))


def _distances(first: Array, second: Array) -> Array:
    """Return the least distance of a corner of the first ones to a side of the second ones."""
    sides = np.roll(second, -1, axis=1) - second
    squares = np.maximum((sides**2).sum(axis=-1), np.finfo(float).tiny)
    to = first[:, :, None] - second[:, None]
    along = np.clip(np.einsum("pklx,plx->pkl", to, sides) / squares[:, None], 0.0, 1.0)
    off = to - along[..., None] * sides[:, None]
    return np.asarray(np.hypot(off[..., 0], off[..., 1]).min(axis=(1, 2)))


def _near(solids: _Solids, corners: Array) -> Iterator[tuple[Indices, Indices]]:
    """Give pairs of pieces of two bodies, one of which moves, whose upright boxes meet."""
    low = corners.min(axis=1) - solids.radius[:, None]
    high = corners.max(axis=1) + solids.radius[:, None]
    moving, still = np.flatnonzero(solids.moves), np.flatnonzero(~solids.moves)
    first, second = _close(low[moving], high[moving])
    pairs = [(moving[first], moving[second])]
    pairs += [(np.full(len(moving), k), moving) for k in still]
    for one, other in pairs:
        meet = ((low[one] <= high[other]) & (low[other] <= high[one])).all(axis=1)
        meet &= solids.body[one] != solids.body[other]
        one, other = one[meet], other[meet]
        for start in range(0, len(one), _AT_ONCE):
            yield one[start : start + _AT_ONCE], other[start : start + _AT_ONCE]


def _close(low: Array, high: Array) -> tuple[Indices, Indices]:
    """Return pairs whose centres are no farther apart than two of the largest can reach."""
    from scipy.spatial import cKDTree  # a quarter of a second, for what few ask for

    reach = np.linalg.norm(high - low, axis=1).max(initial=0.0)
    pairs = cKDTree((low + high) / 2).query_pairs(reach, output_type="ndarray")
    return pairs[:, 0], pairs[:, 1]


def _in_half_planes(scene: Scene, solids: _Solids, corners: Array) -> Iterator[Overlap]:
    """Give the overlap with each half-plane, which is that of the lowest corner."""
    for body in scene.bodies:
        if isinstance(body.shape, HalfPlane) and solids.moves.any():
            height = (corners @ body.shape.normal).min(axis=1) - solids.radius
            depth = np.where(
                [may_touch(body, scene.bodies[k]) for k in solids.body],
                body.shape.offset - height,
                0.0,
            )
            moves = solids.moves
            yield _worst_of(depth[moves], solids.inner[moves], solids.outer[moves])


def _outer(body: Body) -> float:
    """Return the radius around a body, m."""
    return body.shape.bounding_radius if body.shape is not None else math.inf


def _inner(piece: ConvexPart) -> float:
    """Return the radius of the largest circle about a piece's middle, m; inf for a line."""
    corners = np.array(piece.corners)
    middle = corners.mean(axis=0)
    if len(corners) <= 2:
        return piece.radius or math.inf
    sides = np.roll(corners, -1, axis=0) - corners
    normals = np.stack((sides[:, 1], -sides[:, 0]), axis=1) / np.hypot(*sides.T)[:, None]
    return float(np.einsum("kx,kx->k", normals, corners - middle).min()) + piece.radius
