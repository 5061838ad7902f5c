"""Which bodies go far in a step, and when they leave the bounds in which their pairs are known."""

from tamias2d.engine.broad_phase.fat_bounds import FAST
from tamias2d.engine.broad_phase.fat_box import SPECULATIVE_MARGIN
from tamias2d.engine.continuous.conservative_advancement import MISSED
from tamias2d.engine.tables import (
    ANGLE,
    ANGLE_MARGIN,
    BASE_ANGLE,
    BOUNDING_RADIUS,
    CORE_RADIUS,
    DANGLE,
    DX,
    DY,
    DYNAMIC,
    FRAME_MOVES,
    FRAME_X,
    FRAME_Y,
    HIGH_X,
    HIGH_Y,
    KINEMATIC,
    LOW_X,
    LOW_Y,
    MIN_EXTENT,
    Bodies,
    BroadPhase,
    X,
    Y,
)
from tamias2d.generated.continuous_collision import motion_bound
from tamias2d.state import Array

ANY_TURN = 2.0  # rad: with so large an angle margin, pairs are known whichever way the body turns


def goes_far(i: int, bodies: Bodies) -> bool:
    """Return whether a body goes farther in this step than the solver could push it back from."""
    length = path_length(i, bodies.motion, bodies.properties)
    return bool((length > FAST * bodies.properties[i, MIN_EXTENT]) & (bodies.kind[i] >= KINEMATIC))


def path_length(i: int, motion: Array, properties: Array) -> float:
    """Return how far some point of a body may go in this step, m."""
    shift = (motion[i, DX], motion[i, DY])
    return motion_bound(shift, motion[i, DANGLE], properties[i, CORE_RADIUS])


def mark_leaving_bounds(bodies: Bodies, broad_phase: BroadPhase) -> int:
    """Mark bodies that go far and leave the bounds in which their pairs are known; count them."""
    left = 0
    for i in range(len(bodies.kind)):
        broad_phase.left[i] = 1 if leaves_bounds(i, bodies, broad_phase) else 0
        left += broad_phase.left[i]
    return left


def leaves_bounds(i: int, bodies: Bodies, broad_phase: BroadPhase) -> bool:
    """Return whether a body goes far, and out of where its pairs are known.

    They are known a little beyond its bounds. If the frame moves on, a body at rest goes far in it.
    """
    fixed_frame = broad_phase.frame[FRAME_MOVES] == 0.0
    length = path_length(i, bodies.motion, bodies.properties)
    near = fixed_frame and length <= FAST * bodies.properties[i, MIN_EXTENT]
    if bodies.kind[i] < KINEMATIC or near:
        return False
    pose, motion, fat = bodies.pose[i], bodies.motion[i], broad_phase.fat_bounds[i]
    x = pose[X] + motion[DX] - broad_phase.frame[FRAME_X]
    y = pose[Y] + motion[DY] - broad_phase.frame[FRAME_Y]
    dynamic = bodies.kind[i] == DYNAMIC
    more = SPECULATIVE_MARGIN * bodies.properties[i, BOUNDING_RADIUS] if dynamic else 0.0
    turn = abs(pose[ANGLE] + motion[DANGLE] - fat[BASE_ANGLE])
    return bool(
        (x < fat[LOW_X] - more)
        | (x > fat[HIGH_X] + more)
        | (y < fat[LOW_Y] - more)
        | (y > fat[HIGH_Y] + more)
        | (turn > fat[ANGLE_MARGIN]) & (fat[ANGLE_MARGIN] < ANY_TURN)
    )


def time_of_leaving(i: int, now: float, bodies: Bodies, broad_phase: BroadPhase) -> float:
    """Return the fraction of the step, from `now` on, at which a body leaves, or `MISSED`."""
    if not leaves_bounds(i, bodies, broad_phase):
        return MISSED
    if broad_phase.frame[FRAME_MOVES] != 0.0:
        return now
    pose, motion, fat = bodies.pose[i], bodies.motion[i], broad_phase.fat_bounds[i]
    more = SPECULATIVE_MARGIN * bodies.properties[i, BOUNDING_RADIUS]
    until = 1.0
    for k in range(2):
        start = pose[X + k] - broad_phase.frame[FRAME_X + k]
        low, high = fat[LOW_X + k] - more, fat[HIGH_X + k] + more
        until = min(until, fraction_within(start, motion[DX + k], low, high))
    if fat[ANGLE_MARGIN] < ANY_TURN:
        start, most = pose[ANGLE] - fat[BASE_ANGLE], fat[ANGLE_MARGIN]
        until = min(until, fraction_within(start, motion[DANGLE], -most, most))
    return max(until, now)


def fraction_within(start: float, by: float, low: float, high: float) -> float:
    """Return the fraction of a displacement, at most 1, at which it leaves an interval."""
    if start + by > high and by > 0.0:
        return (high - start) / by
    if start + by < low and by < 0.0:
        return (low - start) / by
    return 1.0
