"""Fat bounds of bodies: while each is within its own, the contact list holds.

Bounds are around the path for as long as the list is made for, with a margin relative to sizes;
they move with the comoving frame.
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
    GOES_FAR,
    HIGH_X,
    HIGH_Y,
    KINEMATIC,
    LOW_X,
    LOW_Y,
    MIN_EXTENT,
    PART_TIME,
    SPIN,
    STATIC,
    VX,
    VY,
    Bodies,
    BroadPhase,
    Control,
    Integers,
    X,
    Y,
)
from tamias2d.generated.continuous_collision import motion_bound
from tamias2d.state import Array

FAST = 0.35  # of half its width: a body that goes farther in a step needs continuous collision
AABB_MARGIN = 0.1  # of the bounding radius, or of the mean one if that is less


def mark_out_of_bounds(control: Control, bodies: Bodies, broad_phase: BroadPhase) -> int:
    """Mark the bodies that have left their bounds, or will within a time, s; return how many."""
    time, left, far = control.progress[PART_TIME], 0, 0
    for i in range(len(bodies.kind)):
        out = is_out_of_bounds(i, bodies, broad_phase)
        if will_go_far(i, time, bodies):
            far = 1
            out = out or will_leave(i, time, bodies, broad_phase)
        broad_phase.left[i] = 1 if out else 0
        left += broad_phase.left[i]
    control.counts[GOES_FAR] = far
    return left


def is_out_of_bounds(i: int, bodies: Bodies, broad_phase: BroadPhase) -> bool:
    """Return whether a body is out of its bounds."""
    pose, bounds, frame = bodies.pose[i], broad_phase.fat_bounds[i], broad_phase.frame
    x, y = pose[X] - frame[FRAME_X], pose[Y] - frame[FRAME_Y]
    inside = within_bounds(x, y, bounds)
    inside = inside & (abs(pose[ANGLE] - bounds[BASE_ANGLE]) <= bounds[ANGLE_MARGIN])
    return bool((not inside) & (bodies.kind[i] != ABSENT))


def will_go_far(i: int, time: float, bodies: Bodies) -> bool:
    """Return whether a body goes farther in a time, s, than a fraction of its width."""
    motion, properties = bodies.motion[i], bodies.properties[i]
    speed = motion_bound((motion[VX], motion[VY]), motion[SPIN], properties[CORE_RADIUS])
    return bool(time * speed > FAST * properties[MIN_EXTENT])


def will_leave(i: int, time: float, bodies: Bodies, broad_phase: BroadPhase) -> bool:
    """Return whether a body leaves its bounds in a time, s, at its velocity."""
    pose, motion, frame = bodies.pose[i], bodies.motion[i], broad_phase.frame
    x = pose[X] - frame[FRAME_X] + time * (motion[VX] - frame[FRAME_VX])
    y = pose[Y] - frame[FRAME_Y] + time * (motion[VY] - frame[FRAME_VY])
    return not within_bounds(x, y, broad_phase.fat_bounds[i])


def within_bounds(x: float, y: float, bounds: Array) -> bool:
    """Return whether a point of the comoving frame is within bounds."""
    in_x = (x >= bounds[LOW_X]) & (x <= bounds[HIGH_X])
    return bool(in_x & (y >= bounds[LOW_Y]) & (y <= bounds[HIGH_Y]))


def left_by_frame(bodies: Bodies, broad_phase: BroadPhase) -> bool:
    """Return whether a body that nothing pushes leaves its bounds, because the frame moves on."""
    frame, out = broad_phase.frame, False
    if frame[FRAME_MOVES] == 0.0:
        return False
    for i in range(len(bodies.kind)):
        x = bodies.pose[i, X] + bodies.motion[i, DX] - frame[FRAME_X]
        y = bodies.pose[i, Y] + bodies.motion[i, DY] - frame[FRAME_Y]
        inside = within_bounds(x, y, broad_phase.fat_bounds[i])
        out = out | ((not inside) & ((bodies.kind[i] == STATIC) | (bodies.kind[i] == KINEMATIC)))
    return bool(out)


def fatten_all_bounds(bodies: Bodies, broad_phase: BroadPhase, ahead: float) -> None:
    """Give each body bounds for a time ahead, s, and for the rest of this step."""
    mean = mean_radius(bodies.kind, bodies.properties)
    for i in range(len(bodies.kind)):
        fatten_bounds(i, mean, bodies, broad_phase, ahead)


def fatten_bounds(
    i: int, mean: float, bodies: Bodies, broad_phase: BroadPhase, ahead: float
) -> None:
    """Give a body bounds, where the mean bounding radius is `mean`, m.

    A static body has a margin, too, if the frame moves: the frame may speed up as bodies do.
    """
    frame, bounds = broad_phase.frame, broad_phase.fat_bounds[i]
    pose, motion, properties = bodies.pose[i], bodies.motion[i], bodies.properties[i]
    spare = AABB_MARGIN * mean if frame[FRAME_MOVES] != 0.0 else 0.0
    mobile = bodies.kind[i] > STATIC
    margin = AABB_MARGIN * min(properties[BOUNDING_RADIUS], mean) if mobile else spare
    x, y = pose[X] - frame[FRAME_X], pose[Y] - frame[FRAME_Y]
    by_x, by_y = (motion[VX] - frame[FRAME_VX]) * ahead, (motion[VY] - frame[FRAME_VY]) * ahead
    bounds[LOW_X] = x - margin + min(by_x, motion[DX], 0.0)
    bounds[LOW_Y] = y - margin + min(by_y, motion[DY], 0.0)
    bounds[HIGH_X] = x + margin + max(by_x, motion[DX], 0.0)
    bounds[HIGH_Y] = y + margin + max(by_y, motion[DY], 0.0)
    bounds[BASE_ANGLE], bounds[ANGLE_MARGIN] = pose[ANGLE], 0.0
    if mobile and properties[CORE_RADIUS] > 0.0:
        turn = max(abs(motion[SPIN]) * ahead, abs(motion[DANGLE]))
        bounds[ANGLE_MARGIN] = margin / properties[CORE_RADIUS] + turn
    elif mobile:
        bounds[ANGLE_MARGIN] = FAR


def mean_radius(kind: Integers, properties: Array) -> float:
    """Return the mean bounding radius of dynamic bodies, m."""
    total = 0.0
    number = 0
    for i in range(len(kind)):
        if kind[i] == DYNAMIC:
            total += properties[i, BOUNDING_RADIUS]
            number += 1
    return total / number if number > 0 else 0.0
