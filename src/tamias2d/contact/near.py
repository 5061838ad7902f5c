"""Which pairs are worth a look: the boxes that paths sweep (IM4 in its broad use).

Serves: the located way. Hides: the boxes and how they are compared.
"""

import math
from collections.abc import Sequence
from typing import TypeAlias

from tamias2d.contact.core import Core
from tamias2d.contact.path import Piece
from tamias2d.generated import detection
from tamias2d.state import Vector

_Box: TypeAlias = tuple[Vector, float, float]
"""Centre, width and height, m."""


class Swept:
    """The boxes, along the axes of the world, that n bodies sweep on their paths."""

    def __init__(self, cores: Sequence[Core]) -> None:
        self._cores = cores
        self._solid = [core.index for core in cores if core.solid]
        self._boxes: list[_Box] = [((0.0, 0.0), math.inf, math.inf) for _ in cores]

    def put(self, body: int, path: Piece) -> None:
        """Take the box of a body on a path; a half-plane keeps the whole plane."""
        core = self._cores[body]
        if core.corners:
            self._boxes[body] = _box(path, 2 * core.bounding_radius)

    def near(self, body: int) -> list[int]:
        """Return the bodies whose boxes overlap with that of a body, one of the two moving."""
        own, moving = self._boxes[body], self._cores[body].dynamic
        return [
            other
            for other in self._solid
            if (moving or self._cores[other].dynamic)
            and other != body
            and detection.overlap(*own, *self._boxes[other])
        ]


def _box(path: Piece, size: float) -> _Box:
    """Return the box around all places of a body of some size on a path.

    From the middle of its time, by Taylor's theorem, and a little wider than rounding needs.
    """
    half = (path.end - path.start) / 2
    middle = path.at(path.start + half)
    bounds = path.bounds(path.start, path.end)
    (x, y), (u, v), (ax, ay) = middle.position, middle.velocity, bounds.acceleration
    bend_x, bend_y = abs(ax) + bounds.deviation, abs(ay) + bounds.deviation
    width = size + 2 * (abs(u) + bend_x * half / 2) * half
    height = size + 2 * (abs(v) + bend_y * half / 2) * half
    return (x, y), width + 1e-9 * (width + abs(x)), height + 1e-9 * (height + abs(y))
