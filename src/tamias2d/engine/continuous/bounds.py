"""Which bodies go far in a step, and when they leave the bounds in which their pairs are known."""

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.fat_bounds import FAST
from tamias2d.engine.broad_phase.fat_box import SPECULATIVE_MARGIN
from tamias2d.engine.continuous.conservative_advancement import MISSED
from tamias2d.engine.tables import Bodies, BroadPhase
from tamias2d.generated.continuous_collision import motion_bound
from tamias2d.state import Array

ANY_TURN = 2.0  # rad: with so large an angle margin, pairs are known whichever way the body turns


def goes_far(i: int, bodies: Bodies) -> bool:
    """Return whether a body goes farther in this step than the solver could push it back from."""
    length = path_length(i, bodies.motion, bodies.properties)
    return bool(
        (length > FAST * bodies.properties[i, tb.MIN_EXTENT]) & (bodies.kind[i] >= tb.KINEMATIC)
    )


def path_length(i: int, motion: Array, properties: Array) -> float:
    """Return how far some point of a body may go in this step, m."""
    shift = (motion[i, tb.DX], motion[i, tb.DY])
    return motion_bound(shift, motion[i, tb.DANGLE], properties[i, tb.CORE_RADIUS])


def mark_leaving_bounds(bodies: Bodies, broad_phase: BroadPhase) -> int:
    """Mark bodies that go far and leave the bounds in which their pairs are known; count them."""
    left = 0
    for i in range(len(bodies.kind)):
        leaves = leaves_bounds(i, bodies, broad_phase)
        broad_phase.left[i] = 1 if leaves else 0
        left += 1 if leaves else 0
    return left


def leaves_bounds(i: int, bodies: Bodies, broad_phase: BroadPhase) -> bool:
    """Return whether a body goes far, and out of where its pairs are known.

    They are known a little beyond its bounds. If the frame moves on, a body at rest goes far in it.
    """
    fixed_frame = broad_phase.frame[tb.FRAME_MOVES] == 0.0
    length = path_length(i, bodies.motion, bodies.properties)
    near = fixed_frame and length <= FAST * bodies.properties[i, tb.MIN_EXTENT]
    if bodies.kind[i] < tb.KINEMATIC or near:
        return False
    pose, motion, fat = bodies.pose[i], bodies.motion[i], broad_phase.fat_bounds[i]
    x = pose[tb.X] + motion[tb.DX] - broad_phase.frame[tb.FRAME_X]
    y = pose[tb.Y] + motion[tb.DY] - broad_phase.frame[tb.FRAME_Y]
    dynamic = bodies.kind[i] == tb.DYNAMIC
    more = SPECULATIVE_MARGIN * bodies.properties[i, tb.BOUNDING_RADIUS] if dynamic else 0.0
    turn = abs(pose[tb.ANGLE] + motion[tb.DANGLE] - fat[tb.BASE_ANGLE])
    return bool(
        (x < fat[tb.LOW_X] - more)
        | (x > fat[tb.HIGH_X] + more)
        | (y < fat[tb.LOW_Y] - more)
        | (y > fat[tb.HIGH_Y] + more)
        | (turn > fat[tb.ANGLE_MARGIN]) & (fat[tb.ANGLE_MARGIN] < ANY_TURN)
    )


def time_of_leaving(i: int, now: float, bodies: Bodies, broad_phase: BroadPhase) -> float:
    """Return the fraction of the step, from `now` on, at which a body leaves, or `MISSED`."""
    if not leaves_bounds(i, bodies, broad_phase):
        return MISSED
    if broad_phase.frame[tb.FRAME_MOVES] != 0.0:
        return now
    pose, motion, fat = bodies.pose[i], bodies.motion[i], broad_phase.fat_bounds[i]
    more = SPECULATIVE_MARGIN * bodies.properties[i, tb.BOUNDING_RADIUS]
    until = 1.0
    for k in range(2):
        start = pose[tb.X + k] - broad_phase.frame[tb.FRAME_X + k]
        low, high = fat[tb.LOW_X + k] - more, fat[tb.HIGH_X + k] + more
        until = min(until, fraction_within(start, motion[tb.DX + k], low, high))
    if fat[tb.ANGLE_MARGIN] < ANY_TURN:
        start, most = pose[tb.ANGLE] - fat[tb.BASE_ANGLE], fat[tb.ANGLE_MARGIN]
        until = min(until, fraction_within(start, motion[tb.DANGLE], -most, most))
    return max(until, now)


def fraction_within(start: float, by: float, low: float, high: float) -> float:
    """Return the fraction of a displacement, at most 1, at which it leaves an interval."""
    if start + by > high and by > 0.0:
        return (high - start) / by
    if start + by < low and by < 0.0:
        return (low - start) / by
    return 1.0
