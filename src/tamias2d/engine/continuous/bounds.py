"""Who goes far in a step, and leaves the room in which its neighbours are known.

Serves: a step and flight. Hides: that neighbours are known a little farther than the room.
"""

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

FAST = 0.35  # of half its width: how far a body goes before it is looked after
ANY_TURN = 2.0  # rad: where there is so much room, neighbours are known whichever way it turns


def goes_far(i: int, bodies: Bodies) -> bool:
    """Return whether a body goes farther in this step than it could be pushed back from."""
    return bool(
        (path_length(i, bodies.motion, bodies.properties) > FAST * bodies.properties[i, MIN_EXTENT])
        & (bodies.kind[i] >= KINEMATIC)
    )


def mark_leaving_bounds(bodies: Bodies, broad_phase: BroadPhase) -> int:
    """Mark bodies that go far and leave the room in which neighbours are known; return how many.

    They are known a little farther than the room, too.
    """
    left = 0
    for i in range(len(bodies.kind)):
        broad_phase.left[i] = 1 if leaves_bounds(i, bodies, broad_phase) else 0
        left += broad_phase.left[i]
    return left


def leaves_bounds(i: int, bodies: Bodies, broad_phase: BroadPhase) -> bool:
    """Return whether a body goes far, and out of where its neighbours are known.

    Where the frame moves on, what stands still goes far from it.
    """
    stays = (
        broad_phase.frame[FRAME_MOVES] == 0.0
        and path_length(i, bodies.motion, bodies.properties)
        <= FAST * bodies.properties[i, MIN_EXTENT]
    )
    if bodies.kind[i] < KINEMATIC or stays:
        return False
    x = bodies.pose[i, X] + bodies.motion[i, DX] - broad_phase.frame[FRAME_X]
    y = bodies.pose[i, Y] + bodies.motion[i, DY] - broad_phase.frame[FRAME_Y]
    more = (
        SPECULATIVE_MARGIN * bodies.properties[i, BOUNDING_RADIUS]
        if bodies.kind[i] == DYNAMIC
        else 0.0
    )
    turn = abs(
        bodies.pose[i, ANGLE] + bodies.motion[i, DANGLE] - broad_phase.fat_bounds[i, BASE_ANGLE]
    )
    return bool(
        (x < broad_phase.fat_bounds[i, LOW_X] - more)
        | (x > broad_phase.fat_bounds[i, HIGH_X] + more)
        | (y < broad_phase.fat_bounds[i, LOW_Y] - more)
        | (y > broad_phase.fat_bounds[i, HIGH_Y] + more)
        | (turn > broad_phase.fat_bounds[i, ANGLE_MARGIN])
        & (broad_phase.fat_bounds[i, ANGLE_MARGIN] < ANY_TURN)
    )


def path_length(i: int, motion: Array, properties: Array) -> float:
    """Return how far some point of a body may go in this step, m."""
    shift = (motion[i, DX], motion[i, DY])
    return motion_bound(shift, motion[i, DANGLE], properties[i, CORE_RADIUS])


def time_of_leaving(i: int, now: float, bodies: Bodies, broad_phase: BroadPhase) -> float:
    """Return the fraction of the step, from `now` on, at which a body leaves, or `MISSED`."""
    if not leaves_bounds(i, bodies, broad_phase):
        return MISSED
    if broad_phase.frame[FRAME_MOVES] != 0.0:
        return now
    more = SPECULATIVE_MARGIN * bodies.properties[i, BOUNDING_RADIUS]
    until = 1.0
    for k in range(2):
        start, way = (
            bodies.pose[i, X + k] - broad_phase.frame[FRAME_X + k],
            bodies.motion[i, DX + k],
        )
        low, high = (
            broad_phase.fat_bounds[i, LOW_X + k] - more,
            broad_phase.fat_bounds[i, HIGH_X + k] + more,
        )
        until = min(until, leaves_between(start, way, low, high))
    if broad_phase.fat_bounds[i, ANGLE_MARGIN] < ANY_TURN:
        start, room = (
            bodies.pose[i, ANGLE] - broad_phase.fat_bounds[i, BASE_ANGLE],
            broad_phase.fat_bounds[i, ANGLE_MARGIN],
        )
        until = min(until, leaves_between(start, bodies.motion[i, DANGLE], -room, room))
    return max(until, now)


def leaves_between(start: float, way: float, low: float, high: float) -> float:
    """Return the fraction of a way, at most 1, at which it comes out of an interval."""
    if start + way > high and way > 0.0:
        return (high - start) / way
    if start + way < low and way < 0.0:
        return (low - start) / way
    return 1.0
