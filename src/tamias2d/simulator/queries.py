"""Queries about places: what a ray or a shape meets first, what lies at a point or in a box."""

import math
from dataclasses import dataclass

import numpy as np

from tamias2d.engine.engine import Engine
from tamias2d.engine.query_tree import Piece, QueryTree
from tamias2d.engine.state import LARGEST
from tamias2d.scene import Box, Capsule, Chain, Compound, Disc, Polygon, Segment
from tamias2d.scene.compound import pieces_of
from tamias2d.scene.filters import checked_mask
from tamias2d.scene.rules import RuleError, number, shown
from tamias2d.simulator.columns import as_array, vectors
from tamias2d.state import Array, IntArray

_BOUNDED = (Disc, Box, Polygon, Capsule, Segment, Compound, Chain)
_POINT = "Give (x, y) in m."


@dataclass(frozen=True, kw_only=True)
class Hits:
    """What k rays, or ways of a shape, met first."""

    body: IntArray
    """(k,), index, or -1 where nothing was met"""
    point: Array
    """(k, 2), where it was met, m, on its surface; the end of the way where nothing was"""
    normal: Array
    """(k, 2), unit, out of the body; (0, 0) where nothing was met"""
    fraction: Array
    """(k,), of the way up to there; 1 where nothing was met"""

    def __len__(self) -> int:
        return len(self.body)


def cast_rays(engine: Engine, start: object, end: object, mask: object) -> Hits:
    """Return what rays from points to points, (2,) or (k, 2) each, m, meet first.

    Raises:
        InputError: a ray has no length, or a value breaks a rule (R4).
    """
    of = "the rays"
    ends = _ways(start, end, "ray", of, "Give rays with a length, or ask at_point.")
    bits = checked_mask(mask, of)
    body, hits = _tree(engine).cast_rays(np.hstack(ends), bits)
    fraction = np.minimum(hits[:, 0], 1.0)
    return Hits(
        body=body,
        point=ends[0] + fraction[:, None] * (ends[1] - ends[0]),
        normal=hits[:, 1:].copy(),
        fraction=fraction,
    )


def cast_shape(
    engine: Engine,
    shape: object,
    start: object,
    end: object,
    orientation: object,
    ignored: IntArray,
    mask: object,
) -> Hits:
    """Return what a shape meets first on its ways from places to places, (2,) or (k, 2) each, m.

    Raises:
        InputError: it is a half-plane or no shape, a way has no length, or a value breaks a rule
            (R4).
    """
    of = "the shape cast"
    pieces = _pieces(shape, (0.0, 0.0), orientation, of)
    ends = _ways(start, end, "way", of, "Give ways with a length, or ask in_shape.")
    bits = checked_mask(mask, of)
    without = np.zeros(len(engine.pose), dtype=np.int8)
    without[ignored] = 1
    body, hits = _tree(engine).cast_pieces(pieces, np.hstack(ends), bits, without)
    met = body >= 0
    return Hits(
        body=body,
        point=np.where(met[:, None], hits[:, 3:], ends[1]),
        normal=hits[:, 1:3].copy(),
        fraction=np.minimum(hits[:, 0], 1.0),
    )


def _ways(start: object, end: object, each: str, of: str, remedy: str) -> tuple[Array, Array]:
    """Return starts and ends (k, 2), checked."""
    count = max(_rows(start, "start", of), _rows(end, "end", of))
    first, last = (
        vectors(points, key, of, _POINT, count=count, symbol="position", each=each)
        for key, points in (("start", start), ("end", end))
    )
    for key, points in (("start", first), ("end", last)):
        _refuse_far(points, key, of)
    still = np.flatnonzero((first == last).all(axis=1))
    if len(still):
        raise RuleError(
            f"end[{still[0]}] of {of}: found the start: must be another point (R4). {remedy}", "end"
        )
    return first, last


def bodies_in_box(engine: Engine, low: object, high: object, mask: object) -> IntArray:
    """Return the bodies (k,) that reach into a box between two corners (2,), m, by rank.

    Raises:
        InputError: `low` is beyond `high`, or a value breaks a rule (R4).
    """
    least, most = (_point(corner, key, "the box") for key, corner in (("low", low), ("high", high)))
    if (least > most).any():
        raise RuleError(
            f"low {least.tolist()} of the box: is beyond high {most.tolist()} (R4). Give the "
            "lower left and the upper right corner.",
            "low",
        )
    return _within(engine, least, most, mask)


def bodies_in_shape(
    engine: Engine, shape: object, position: object, orientation: object, mask: object
) -> IntArray:
    """Return the bodies (k,) that reach into a shape at a position (2,), m, by rank.

    Raises:
        InputError: it is a half-plane or no shape, or a value breaks a rule (R4).
    """
    of = "the question"
    pieces = _pieces(shape, position, orientation, of)
    return _tree(engine).bodies_in_shape(pieces, checked_mask(mask, of))


def _pieces(shape: object, position: object, orientation: object, of: str) -> list[Piece]:
    """Return the pieces of a shape that is bounded at a position, turned by rad."""
    if not isinstance(shape, _BOUNDED):
        raise RuleError(
            f"shape of {of}: found {shown(shape)}: must be bounded (R4). Give a shape such as "
            "Disc(radius=2.0).",
            "shape",
        )
    place = _point(position, "position", of)
    angle = number(orientation, "orientation", of, "Give it in rad.", at=("orientation",))
    c, s = math.cos(angle), math.sin(angle)
    turn = np.array([[c, s], [-s, c]])
    return [
        (np.array(piece.core) @ turn + place, float(piece.shape.rounding))
        for piece in pieces_of(shape)
    ]


def bodies_at_point(engine: Engine, point: object, mask: object) -> IntArray:
    """Return the bodies (k,) at a point (2,), m, by rank.

    Raises:
        InputError: a value breaks a rule (R4).
    """
    place = _point(point, "point", "the question")
    return _within(engine, place, place, mask)


def _within(engine: Engine, low: Array, high: Array, mask: object) -> IntArray:
    bits = checked_mask(mask, "the question")
    return _tree(engine).bodies_in_box(low, high, bits)


def _tree(engine: Engine) -> QueryTree:
    """Return the tree that is asked, for the poses as they are; raise `RuleError` for bad ones."""
    tree = engine.queries
    if not tree.holds():
        _refuse_endless(engine)
        tree.build()
    return tree


def _refuse_endless(engine: Engine) -> None:
    """Raise `RuleError` if a body is nowhere, or too far away."""
    good = np.abs(engine.pose[:, :2]).max(axis=1, initial=0.0) <= LARGEST
    good &= np.isfinite(engine.pose[:, 2])
    if not good.all():
        raise RuleError(
            f"position or orientation[{int(np.argmin(good))}]: must be finite, and within "
            f"{LARGEST:.2g} m, to be asked for (R4). Set it to a number."
        )


def _refuse_far(points: Array, key: str, of: str) -> None:
    """Raise `RuleError` if float64 cannot hold the squares of distances to points (k, 2)."""
    far = np.flatnonzero((np.abs(points) > LARGEST).any(axis=1))
    if len(far):
        raise RuleError(
            f"{key}[{far[0]}] {points[far[0]].tolist()} of {of}: must be within {LARGEST:.2g} m, "
            "or float64 cannot hold what follows (R4). Give a nearer point.",
            key,
        )


def _rows(points: object, key: str, of: str) -> int:
    given = as_array(points, key, of, _POINT)
    return len(given) if given.ndim == 2 else 1


def _point(point: object, key: str, of: str) -> Array:
    place: Array = vectors(point, key, of, _POINT, count=1, symbol="position")
    _refuse_far(place, key, of)
    one: Array = place[0]
    return one
