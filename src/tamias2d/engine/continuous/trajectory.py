"""The straight paths along which bodies go through a step, and how they are redirected.

A path is kept as the pose from which it would have begun, and its displacement over a whole step.
"""

from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies
from tamias2d.generated.continuous_collision import (
    orientation_redirected,
    position_redirected,
    shift_redirected,
    span,
    turn_redirected,
)
from tamias2d.state import Array, Vector


class RelativePath(NamedTuple):
    """The path of a body B as seen from A, and the turns of both."""

    x: float  # where it begins, m
    y: float
    dx: float  # displacement, m
    dy: float
    turn_a: float  # rad
    turn_b: float


def relative_path(i: int, j: int, now: float, bodies: Bodies) -> RelativePath:
    """Return the path of body j as seen from i, from a fraction of the step to its end."""
    pose, motion, left = bodies.pose, bodies.motion, 1.0 - now
    x, y = relative_place(i, j, now, pose, motion)
    dx, dy = motion[j, tb.DX] - motion[i, tb.DX], motion[j, tb.DY] - motion[i, tb.DY]
    return RelativePath(
        x, y, left * dx, left * dy, left * motion[i, tb.DANGLE], left * motion[j, tb.DANGLE]
    )


def relative_place(i: int, j: int, now: float, pose: Array, motion: Array) -> Vector:
    """Return where body j is from i at a fraction of the step, m."""
    return span(
        (pose[i, tb.X], pose[i, tb.Y]),
        (motion[i, tb.DX], motion[i, tb.DY]),
        (pose[j, tb.X], pose[j, tb.Y]),
        (motion[j, tb.DX], motion[j, tb.DY]),
        now,
    )


def redirect_path(i: int, now: float, by: Vector, turn: float, pose: Array, motion: Array) -> None:
    """Change the displacement over a whole step, m and rad, from where a path is now (GD14)."""
    pose[i, tb.X], pose[i, tb.Y] = position_redirected((pose[i, tb.X], pose[i, tb.Y]), by, now)
    pose[i, tb.ANGLE] = orientation_redirected(pose[i, tb.ANGLE], turn, now)
    motion[i, tb.DX], motion[i, tb.DY] = shift_redirected((motion[i, tb.DX], motion[i, tb.DY]), by)
    motion[i, tb.DANGLE] = turn_redirected(motion[i, tb.DANGLE], turn)
