"""The broad phase: pairs whose swept bounding boxes overlap (IM4)."""

import math
from collections.abc import Collection, Sequence

import numpy as np

from tamias2d.contact.core import Core
from tamias2d.generated import detection, translation
from tamias2d.path import PathPiece
from tamias2d.scene.filters import filters, may_touch
from tamias2d.state import Array


class SweptAabbs:
    """The axis-aligned bounding boxes (AABBs) that n bodies sweep on their paths."""

    def __init__(self, cores: Sequence[Core], kept_apart: Collection[tuple[int, int]] = ()) -> None:
        """Take the bodies, and the pairs (i, j), i < j, that do not touch whatever they do."""
        self._cores = cores
        self._kept_apart = kept_apart
        self._solid = np.array([core.solid for core in cores])
        self._dynamic = np.array([core.dynamic for core in cores])
        self._filtered = any(filters(core.filter) for core in cores)
        # Of each body: x and y of the centre, width and height of its box, m.
        self._aabbs = np.tile([[0.0], [0.0], [math.inf], [math.inf]], len(cores))

    def update(self, body: int, path: PathPiece) -> None:
        """Set the box of a body on a path; that of a half-plane is the whole plane."""
        core = self._cores[body]
        if core.corners:
            self._aabbs[:, body] = _aabb(path, 2 * core.bounding_radius)

    def overlapping(self, body: int) -> list[int]:
        """Return the bodies whose boxes overlap with that of a body, where one of the two moves.

        A particle touches nothing, whichever of the two it is.
        """
        if not self._cores[body].solid:
            return []
        x, y, width, height = self._aabbs
        own = self._aabbs[:, body].tolist()
        overlaps = detection.overlap((own[0], own[1]), own[2], own[3], (x, y), width, height)
        overlaps &= self._solid & (self._dynamic | self._dynamic[body])
        overlaps[body] = False
        found = [int(other) for other in np.flatnonzero(overlaps)]
        if self._kept_apart:
            found = [k for k in found if (min(k, body), max(k, body)) not in self._kept_apart]
        if not self._filtered:
            return found
        own_filter = self._cores[body].filter
        return [other for other in found if may_touch(own_filter, self._cores[other].filter)]


def _aabb(path: PathPiece, size: float) -> Array:
    """Return centre, width and height of the AABB of a body on a path.

    By Taylor's theorem about the middle of its time; 1e-9 wider, for rounding.
    """
    half = (path.end - path.start) / 2
    middle = path.at(path.start + half)
    bounds = path.bounds(path.start, path.end)
    (x, y), (u, v), (ax, ay) = middle.position, middle.velocity, bounds.acceleration
    most = (abs(ax) + bounds.deviation, abs(ay) + bounds.deviation)
    to_x, to_y = translation.position((0.0, 0.0), (abs(u), abs(v)), most, half)
    width, height = size + 2 * to_x, size + 2 * to_y
    width += 1e-9 * (width + abs(x))
    height += 1e-9 * (height + abs(y))
    return np.array([x, y, width, height])
