"""Which bodies may come near each other, and when: upright boxes around their paths, swept.

Of each body there is a box around all that it can reach within an interval of time. Along one axis
boxes are sorted by where they begin; two can meet only if one begins before the other ends.
"""

from collections import defaultdict
from collections.abc import Sequence

import numpy as np

from tamias2d.scene import Body, HalfPlane
from tamias2d.state import Array, IntArray
from tamias2d.study.separation import Flags, SeparableHull

_BEYOND = 2.0  # times the way and what the speed makes of it: how far a path may lead aside


def swept_boxes(
    marks: Array, times: Array, position: Array, velocity: Array, reach: float
) -> tuple[Array, Array]:
    """Return the least and largest (i, 2), m, that a body reaches in intervals between marks, s.

    Its positions (k, 2) and velocities are those at sorted times (k,), which hold all marks; all of
    it is within a `reach`, m, of them.
    """
    way = np.hypot(*np.diff(position, axis=0).T)
    speed = np.hypot(*velocity.T)
    aside = reach + _BEYOND * (way + np.diff(times) * np.maximum(speed[1:], speed[:-1]))
    low = np.minimum(position[1:], position[:-1]) - aside[:, None]
    high = np.maximum(position[1:], position[:-1]) + aside[:, None]
    first = np.searchsorted(times, marks[:-1])
    return np.minimum.reduceat(low, first), np.maximum.reduceat(high, first)


def standing_box(body: Body, parts: Sequence[SeparableHull]) -> tuple[Array, Array]:
    """Return the least and largest (1, 2), m, that a body reaches which stays where it is."""
    cos, sin = np.cos(body.orientation), np.sin(body.orientation)
    turn = np.array([[cos, sin], [-sin, cos]])
    low = [(part.corners @ turn).min(axis=0) - part.radius for part in parts]
    high = [(part.corners @ turn).max(axis=0) + part.radius for part in parts]
    place = np.array(body.position)
    return place + np.min(low, axis=0)[None], place + np.max(high, axis=0)[None]


def meeting(low: Array, high: Array) -> dict[tuple[int, int], Flags]:
    """Return, of boxes (n, i, 2), which pairs meet, and in which intervals (i,)."""
    count = low.shape[1]
    found: dict[tuple[int, int], Flags] = defaultdict(lambda: np.zeros(count, dtype=bool))
    for k in range(count):
        for a, b in _pairs(low[:, k], high[:, k]).tolist():
            found[a, b][k] = True
    return found


def beside(half_plane: HalfPlane, low: Array, high: Array) -> Flags:
    """Return (n, i): in which intervals boxes (n, i, 2) reach a half-plane."""
    normal = np.array(half_plane.normal)
    nearest: Array = np.minimum(low * normal, high * normal).sum(axis=-1)
    reached: Flags = nearest <= half_plane.offset
    return reached


def _pairs(low: Array, high: Array) -> IntArray:
    """Return the pairs (p, 2) of boxes (n, 2) that meet; the lower one is first."""
    order = np.argsort(low[:, 0], kind="stable")
    last = np.searchsorted(low[order, 0], high[order, 0], side="right")
    count = last - np.arange(len(order)) - 1
    one = np.repeat(np.arange(len(order)), count)
    other = one + 1 + np.arange(len(one)) - np.repeat(np.cumsum(count) - count, count)
    pairs = np.stack((order[one], order[other]), axis=1)
    meet = (low[pairs[:, 0], 1] <= high[pairs[:, 1], 1]) & (
        low[pairs[:, 1], 1] <= high[pairs[:, 0], 1]
    )
    return np.sort(pairs[meet], axis=1)
