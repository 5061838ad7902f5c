"""Wide lines that fill an area: a viewer that fills nothing in 2D ends each with half a disc."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Points = NDArray[np.float64]
    Lines = tuple[Points, float]  # (l, v, 2) and their half-width, m

_RINGS = (1 / 17, 4 / 17, 16 / 17)
"""Half-widths of rings, as parts of how far the centroid is from the rim: two thirds at least of
what fits into it, so that the widest one fills the middle. The others fill the corners that a wider
one rounds, down to 60 degrees."""


def rings(rim: Points) -> list[Lines]:
    """Return closed rings (1, v, 2) that fill a convex rim (v, 2) up to its corners."""
    centre = _centroid(rim)
    depth = min(_distance(centre, a, b) for a, b in pairwise(rim))
    return [(_within(rim, share * depth)[None], share * depth) for share in _RINGS]


def parallels(rim: Points, lines: int) -> Lines:
    """Return parallel lines (l, 2, 2) along the longer side that fill a rim (v, 2).

    As they are rounded, their ends keep half their width from the rim.
    """
    if np.ptp(rim[:, 1]) > np.ptp(rim[:, 0]):
        filling, half = parallels(rim[:, ::-1], lines)
        return filling[..., ::-1], half
    middle = rim[:-1].mean(axis=0)
    rim = middle + 0.98 * (rim - middle)  # what curves is within its corners
    low, high = rim[:, 1].min(), rim[:, 1].max()
    half = (high - low) / lines / 2
    heights = low + half + 2 * half * np.arange(lines)
    (x0, y0), (x1, y1) = rim[:-1].T, rim[1:].T
    with np.errstate(divide="ignore", invalid="ignore"):
        part = (heights[:, None] - y0) / (y1 - y0)
        crossing = np.where((part >= 0) & (part <= 1), x0 + part * (x1 - x0), np.nan)
    left, right = np.nanmin(crossing, axis=1), np.nanmax(crossing, axis=1)
    inset = np.minimum(half, (right - left) / 2)
    ends = np.column_stack([left + inset, right - inset])
    return np.stack([ends, np.broadcast_to(heights[:, None], ends.shape)], axis=-1), half


def _distance(point: Points, a: Points, b: Points) -> float:
    """How far a point is to the left of the line from a to b, m."""
    along, way = b - a, point - a
    return float((along[0] * way[1] - along[1] * way[0]) / np.hypot(*along))


def _centroid(rim: Points) -> Points:
    (x0, y0), (x1, y1) = rim[:-1].T - rim[0][:, None], rim[1:].T - rim[0][:, None]
    twice = x0 * y1 - x1 * y0
    moment = np.array([((x0 + x1) * twice).sum(), ((y0 + y1) * twice).sum()])
    centroid: Points = rim[0] + moment / (3 * twice.sum())
    return centroid


def _within(rim: Points, depth: float) -> Points:
    """Return what of a convex rim is so deep, in m: as many points, of which some may coincide."""
    corners = list(rim[:-1])
    for a, b in pairwise(rim):
        heights = [_distance(corner, a, b) - depth for corner in corners]
        kept = []
        for k, corner in enumerate(corners):
            before, at_before, at = corners[k - 1], heights[k - 1], heights[k]
            if at_before * at < 0:
                kept.append(before + at_before / (at_before - at) * (corner - before))
            if at >= 0:
                kept.append(corner)
        corners = kept
    return np.array([*corners, *[corners[0]] * (len(rim) - len(corners))])
