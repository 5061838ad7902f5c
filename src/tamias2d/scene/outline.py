"""The outline of a polygon: the check that it is convex, and its centre.

An outline is accepted only if it turns the same way at every vertex, and once around in all.
"""

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from tamias2d.generated import definitions
from tamias2d.scene.rules import RuleError, Vector, sequence, vector

Columns = tuple[NDArray[np.float64], NDArray[np.float64]]

_OF = "a polygon"
_REMEDY = "Give at least three corners of a convex outline in m, e.g. [(0, 0), (1, 0), (0, 1)]."
_MOST = 1000  # corners: what finds contacts compares each with each
_KEPT = 256  # polygons: pieces of one that breaks are of few
_STRAIGHT = 1e-12  # sine of the turn below which three corners count as one line


def checked_outline(vertices: object) -> tuple[Vector, ...]:
    """Return the vertices of a convex outline as plain numbers, or raise `RuleError`."""
    items = sequence(vertices, _OF, _REMEDY, at=("vertices",))
    if len(items) < 3:
        raise RuleError(
            f"vertices of {_OF}: found {len(items)}: must be at least 3 (R4). {_REMEDY}", "vertices"
        )
    if len(items) > _MOST:
        raise RuleError(
            f"vertices of {_OF}: found {len(items)}: must be at most {_MOST} (R4). Leave corners "
            "out, or take a Disc, or a Compound of smaller polygons.",
            "vertices",
        )
    outline = tuple(
        vector(item, "vertex", _OF, _REMEDY, at=("vertices", k)) for k, item in enumerate(items)
    )
    _refuse_unless_convex(outline)
    return outline


def _refuse_unless_convex(outline: tuple[Vector, ...]) -> None:
    turns = [_turn(outline, k) for k in range(len(outline))]
    sense = math.copysign(1.0, sum(turns))
    around = 0.0
    for k, turn in enumerate(turns):
        around += turn * sense
        if turn * sense < 0:
            raise _fault(outline, k, "is a dent", "Take the convex outline without it.")
        if around > 2 * math.pi + 1e-6:
            raise _fault(outline, k, "is where the outline crosses itself", "Reorder the corners.")


def _turn(outline: tuple[Vector, ...], k: int) -> float:
    """Return the angle by which the outline turns at vertex k; refuse a corner that is none."""
    before, here, after = outline[k - 1], outline[k], outline[(k + 1) % len(outline)]
    into, out = math.dist(before, here), math.dist(here, after)
    if not 0 < into < math.inf:
        raise _fault(outline, k, "is the same as the one before it", "Leave one out.")
    in_x, in_y = (here[0] - before[0]) / into, (here[1] - before[1]) / into
    out_x, out_y = (after[0] - here[0]) / (out or 1.0), (after[1] - here[1]) / (out or 1.0)
    sine, cosine = in_x * out_y - in_y * out_x, in_x * out_x + in_y * out_y
    if out > 0 and abs(sine) < _STRAIGHT:
        raise _fault(outline, k, "is in line with its neighbours", "Leave it out.")
    return math.atan2(sine, cosine)


def _fault(outline: tuple[Vector, ...], k: int, found: str, remedy: str) -> RuleError:
    x, y = outline[k]
    return RuleError(
        f"vertices[{k}] ({x:g}, {y:g}) of {_OF}: {found}: must be convex (R4). {remedy}",
        "vertices",
        k,
    )


def centred(outline: tuple[Vector, ...]) -> tuple[tuple[Vector, ...], Vector]:
    """Return the vertices relative to the centroid, counter-clockwise, and the centroid."""
    origin = np.array(outline[0])
    with np.errstate(all="ignore"):
        near = np.array(outline) - origin  # so that an outline far away loses no digits
        vertex, following = _columns(near), _columns(np.roll(near, -1, axis=0))
        area = float(definitions.area_polygon(vertex, following))
        centroid = np.array(definitions.centroid_polygon(vertex, following) if area else origin)
    if area == 0 or not np.isfinite([area, *centroid]).all():
        raise RuleError(
            f"vertices of {_OF}: found an area of {area:g} m^2: must be finite and not 0 (R4). "
            "Give corners of a size that float64 can square.",
            "vertices",
        )
    relative = (near - centroid).tolist()
    x, y = (origin + centroid).tolist()
    return tuple((p, q) for p, q in relative[:: 1 if area > 0 else -1]), (x, y)


@lru_cache(_KEPT)
def edges(vertices: tuple[Vector, ...]) -> tuple[Columns, Columns]:
    """Return the start and the end of every edge, each as a pair of read-only arrays (x, y)."""
    corners = np.array(vertices)
    later = np.roll(corners, -1, axis=0)
    for points in (corners, later):
        points.flags.writeable = False
    return _columns(corners), _columns(later)


def _columns(points: NDArray[np.float64]) -> Columns:
    return points[:, 0], points[:, 1]
