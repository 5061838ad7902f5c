"""Rooms of bodies: where each may be until the list of pairs is not known to hold any more.

Serves: the look around, and a step, which asks whether the list still holds. Hides: how much room
each body has. It is relative to sizes and to what the motion at hand would take.
"""

from tamias2d.engine.broad_phase.bvh import FAR
from tamias2d.engine.tables import (
    ABSENT,
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
    FRAME_VX,
    FRAME_VY,
    FRAME_X,
    FRAME_Y,
    HIGH_X,
    HIGH_Y,
    KINEMATIC,
    LOW_X,
    LOW_Y,
    SPIN,
    STATIC,
    VX,
    VY,
    Bodies,
    BroadPhase,
    Integers,
    X,
    Y,
)
from tamias2d.state import Array

AABB_MARGIN = 0.1  # of the reach, or the mean if that is less: how far a body may go from its way


def mark_out_of_bounds(bodies: Bodies, broad_phase: BroadPhase) -> int:
    """Mark bodies that are where the list of pairs is not known to hold; return how many.

    Rooms move with the frame: where all fall together, nobody comes nearer to anybody.
    """
    left = 0
    for i in range(len(bodies.kind)):
        broad_phase.left[i] = 1 if is_out_of_bounds(i, bodies, broad_phase) else 0
        left += broad_phase.left[i]
    return left


def is_out_of_bounds(i: int, bodies: Bodies, broad_phase: BroadPhase) -> bool:
    """Return whether a body is out of its room."""
    x, y = (
        bodies.pose[i, X] - broad_phase.frame[FRAME_X],
        bodies.pose[i, Y] - broad_phase.frame[FRAME_Y],
    )
    inside = (
        (x >= broad_phase.fat_bounds[i, LOW_X])
        & (x <= broad_phase.fat_bounds[i, HIGH_X])
        & (y >= broad_phase.fat_bounds[i, LOW_Y])
        & (y <= broad_phase.fat_bounds[i, HIGH_Y])
        & (
            abs(bodies.pose[i, ANGLE] - broad_phase.fat_bounds[i, BASE_ANGLE])
            <= broad_phase.fat_bounds[i, ANGLE_MARGIN]
        )
    )
    return bool((not inside) & (bodies.kind[i] != ABSENT))


def left_by_frame(bodies: Bodies, broad_phase: BroadPhase) -> bool:
    """Return whether something that nothing pushes leaves its room within the step.

    It does so where the frame moves on without it.
    """
    if broad_phase.frame[FRAME_MOVES] == 0.0:
        return False
    out = False
    for i in range(len(bodies.kind)):
        x = bodies.pose[i, X] + bodies.motion[i, DX] - broad_phase.frame[FRAME_X]
        y = bodies.pose[i, Y] + bodies.motion[i, DY] - broad_phase.frame[FRAME_Y]
        inside = (
            (x >= broad_phase.fat_bounds[i, LOW_X])
            & (x <= broad_phase.fat_bounds[i, HIGH_X])
            & (y >= broad_phase.fat_bounds[i, LOW_Y])
            & (y <= broad_phase.fat_bounds[i, HIGH_Y])
        )
        out = out | ((not inside) & ((bodies.kind[i] == STATIC) | (bodies.kind[i] == KINEMATIC)))
    return bool(out)


def fatten_all_bounds(bodies: Bodies, broad_phase: BroadPhase, ahead: float) -> None:
    """Give each body room around where it will be for a time ahead, s, and in this step."""
    mean = mean_radius(bodies.kind, bodies.properties)
    for i in range(len(bodies.kind)):
        fatten_bounds(i, mean, bodies, broad_phase, ahead)


def fatten_bounds(
    i: int, mean: float, bodies: Bodies, broad_phase: BroadPhase, ahead: float
) -> None:
    """Give a body room, where bodies reach `mean` on the average, m.

    What stands still moves against the frame, which may speed up as bodies do: it has some room.
    """
    frame_x, frame_y = broad_phase.frame[FRAME_VX], broad_phase.frame[FRAME_VY]
    spare = AABB_MARGIN * mean if broad_phase.frame[FRAME_MOVES] != 0.0 else 0.0
    room = (
        AABB_MARGIN * min(bodies.properties[i, BOUNDING_RADIUS], mean)
        if bodies.kind[i] > STATIC
        else spare
    )
    x, y = (
        bodies.pose[i, X] - broad_phase.frame[FRAME_X],
        bodies.pose[i, Y] - broad_phase.frame[FRAME_Y],
    )
    by_x, by_y = (bodies.motion[i, VX] - frame_x) * ahead, (bodies.motion[i, VY] - frame_y) * ahead
    on_x, on_y = bodies.motion[i, DX], bodies.motion[i, DY]
    broad_phase.fat_bounds[i, LOW_X] = x - room + min(by_x, on_x, 0.0)
    broad_phase.fat_bounds[i, LOW_Y] = y - room + min(by_y, on_y, 0.0)
    broad_phase.fat_bounds[i, HIGH_X] = x + room + max(by_x, on_x, 0.0)
    broad_phase.fat_bounds[i, HIGH_Y] = y + room + max(by_y, on_y, 0.0)
    broad_phase.fat_bounds[i, BASE_ANGLE] = bodies.pose[i, ANGLE]
    arm = bodies.properties[i, CORE_RADIUS]
    if bodies.kind[i] <= STATIC:
        broad_phase.fat_bounds[i, ANGLE_MARGIN] = 0.0
    elif arm > 0.0:
        turn = max(abs(bodies.motion[i, SPIN]) * ahead, abs(bodies.motion[i, DANGLE]))
        broad_phase.fat_bounds[i, ANGLE_MARGIN] = room / arm + turn
    else:
        broad_phase.fat_bounds[i, ANGLE_MARGIN] = FAR


def mean_radius(kind: Integers, properties: Array) -> float:
    """Return the mean radius of the bodies that move, m."""
    total = 0.0
    number = 0
    for i in range(len(kind)):
        if kind[i] == DYNAMIC:
            total += properties[i, BOUNDING_RADIUS]
            number += 1
    return total / number if number > 0 else 0.0
