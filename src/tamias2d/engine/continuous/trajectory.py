"""The straight paths along which bodies go through a step, and how they are redirected.

A path is kept as the pose from which it would have begun, and its displacement over a whole step.
"""

from typing import NamedTuple

from tamias2d.engine.tables import ANGLE, DANGLE, DX, DY, Bodies, X, Y
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
    dx, dy = motion[j, DX] - motion[i, DX], motion[j, DY] - motion[i, DY]
    return RelativePath(
        x, y, left * dx, left * dy, left * motion[i, DANGLE], left * motion[j, DANGLE]
    )


def relative_place(i: int, j: int, now: float, pose: Array, motion: Array) -> Vector:
    """Return where body j is from i at a fraction of the step, m."""
    return (
        pose[j, X] - pose[i, X] + now * (motion[j, DX] - motion[i, DX]),
        pose[j, Y] - pose[i, Y] + now * (motion[j, DY] - motion[i, DY]),
    )


def redirect_path(i: int, now: float, by: Vector, turn: float, pose: Array, motion: Array) -> None:
    """Change the displacement over a whole step, m and rad, from where a path is now."""
    pose[i, X] -= now * by[0]
    pose[i, Y] -= now * by[1]
    pose[i, ANGLE] -= now * turn
    motion[i, DX] += by[0]
    motion[i, DY] += by[1]
    motion[i, DANGLE] += turn
