"""Shapes as rows of arrays, as the engine keeps them.

Serves: the roster. Hides: what each kind of shape is made of.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tamias2d.engine.tables import CAPSULE, DISC, HALF_PLANE, POLYGON
from tamias2d.scene import HalfPlane
from tamias2d.scene.compound import Shape, pieces_of
from tamias2d.scene.rules import Vector
from tamias2d.state import Array


class Piece(NamedTuple):
    """One shape of the engine; a body has one or more."""

    kind: int
    """of `stepped.layout`"""
    radius: float
    """how far it reaches around its corners, m"""
    corner: Array
    """(c, 4), corner, m, and outward normal of the side from it, in the axes of its body"""

    arm: float
    """how far its farthest corner is from the centre of mass, m; 0 for a half-plane"""
    reach: float
    """how far all of it is from the centre of mass at most, m; infinite for a half-plane"""
    half: float
    """half of its least width, m; infinite for a half-plane"""
    inner: float
    """how near its sides are to the centre of mass, m; minus infinity where that is outside"""


def pieces(shape: Shape | None) -> tuple[Piece, ...]:
    """Return what the engine keeps of a shape; a particle has nothing."""
    if shape is None:
        return ()
    if isinstance(shape, HalfPlane):
        x, y = shape.normal
        return (
            Piece(
                kind=HALF_PLANE,
                radius=0.0,
                corner=np.array([[shape.offset, 0.0, x, y]]),
                arm=0.0,
                reach=math.inf,
                half=math.inf,
                inner=-math.inf,
            ),
        )
    return tuple(_bounded(part.core, part.shape.rounding) for part in pieces_of(shape))


def _bounded(core: Sequence[Vector], radius: float) -> Piece:
    arm = max(math.hypot(x, y) for x, y in core)
    corner = _corners(core)
    across = corner[:, 2:] @ corner[:, :2].T
    half = radius + float(np.ptp(across, axis=1).min()) / 2
    inner = float((corner[:, :2] * corner[:, 2:]).sum(axis=1).min())
    return Piece(
        kind=_kind(len(core)),
        radius=radius,
        corner=corner,
        arm=arm,
        reach=arm + radius,
        half=half,
        inner=inner if inner >= 0.0 else -math.inf,
    )


def _kind(corners: int) -> int:
    return {1: DISC, 2: CAPSULE}.get(corners, POLYGON)


def _corners(core: Sequence[Vector]) -> Array:
    """Return corners with the outward normals of the sides that begin there."""
    rows = np.zeros((len(core), 4))
    rows[:, :2] = core
    if len(core) > 1:
        for k, (x, y) in enumerate(core):
            end_x, end_y = core[(k + 1) % len(core)]
            length = math.hypot(end_x - x, end_y - y)
            rows[k, 2:] = (end_y - y) / length + 0.0, (x - end_x) / length + 0.0
    return rows
