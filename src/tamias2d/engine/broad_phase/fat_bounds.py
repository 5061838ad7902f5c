"""Fat bounds of bodies: while each is within its own, the contact list holds.

Bounds are around the path for as long as the list is made for, with a margin relative to sizes;
they move with the comoving frame.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.bvh import FAR
from tamias2d.engine.tables import Bodies, BroadPhase, Control, Integers
from tamias2d.generated.continuous_collision import motion_bound
from tamias2d.state import Array

FAST = 0.35  # of half its width: a body that goes farther in a step needs continuous collision
AABB_MARGIN = 0.1  # of the bounding radius, or of the mean one if that is less


def mark_out_of_bounds(control: Control, bodies: Bodies, broad_phase: BroadPhase) -> int:
    """Mark the bodies that have left their bounds, or will within a time, s; return how many."""
    time, left, far = control.progress[tb.PART_TIME], 0, 0
    for i in range(len(bodies.kind)):
        out = is_out_of_bounds(i, bodies, broad_phase)
        if will_go_far(i, time, bodies):
            far = 1
            out = out or will_leave(i, time, bodies, broad_phase)
        broad_phase.left[i] = 1 if out else 0
        left += 1 if out else 0  # not a sum of bytes, which a hundred and more would pass
    control.counts[tb.GOES_FAR] = far
    return left


def is_out_of_bounds(i: int, bodies: Bodies, broad_phase: BroadPhase) -> bool:
    """Return whether a body is out of its bounds."""
    pose, bounds, frame = bodies.pose[i], broad_phase.fat_bounds[i], broad_phase.frame
    x, y = pose[tb.X] - frame[tb.FRAME_X], pose[tb.Y] - frame[tb.FRAME_Y]
    inside = within_bounds(x, y, bounds)
    inside = inside & (abs(pose[tb.ANGLE] - bounds[tb.BASE_ANGLE]) <= bounds[tb.ANGLE_MARGIN])
    return bool((not inside) & (bodies.kind[i] != tb.ABSENT))


def will_go_far(i: int, time: float, bodies: Bodies) -> bool:
    """Return whether a body goes farther in a time, s, than a fraction of its width."""
    motion, properties = bodies.motion[i], bodies.properties[i]
    speed = motion_bound(
        (motion[tb.VX], motion[tb.VY]), motion[tb.SPIN], properties[tb.CORE_RADIUS]
    )
    return bool(time * speed > FAST * properties[tb.MIN_EXTENT])


def will_leave(i: int, time: float, bodies: Bodies, broad_phase: BroadPhase) -> bool:
    """Return whether a body leaves its bounds in a time, s, at its velocity."""
    pose, motion, frame = bodies.pose[i], bodies.motion[i], broad_phase.frame
    x = pose[tb.X] - frame[tb.FRAME_X] + time * (motion[tb.VX] - frame[tb.FRAME_VX])
    y = pose[tb.Y] - frame[tb.FRAME_Y] + time * (motion[tb.VY] - frame[tb.FRAME_VY])
    return not within_bounds(x, y, broad_phase.fat_bounds[i])


def within_bounds(x: float, y: float, bounds: Array) -> bool:
    """Return whether a point of the comoving frame is within bounds."""
    in_x = (x >= bounds[tb.LOW_X]) & (x <= bounds[tb.HIGH_X])
    return bool(in_x & (y >= bounds[tb.LOW_Y]) & (y <= bounds[tb.HIGH_Y]))


def left_by_frame(bodies: Bodies, broad_phase: BroadPhase) -> bool:
    """Return whether a body that nothing pushes leaves its bounds, because the frame moves on."""
    frame, out = broad_phase.frame, False
    if frame[tb.FRAME_MOVES] == 0.0:
        return False
    for i in range(len(bodies.kind)):
        x = bodies.pose[i, tb.X] + bodies.motion[i, tb.DX] - frame[tb.FRAME_X]
        y = bodies.pose[i, tb.Y] + bodies.motion[i, tb.DY] - frame[tb.FRAME_Y]
        inside = within_bounds(x, y, broad_phase.fat_bounds[i])
        out = out | (
            (not inside) & ((bodies.kind[i] == tb.STATIC) | (bodies.kind[i] == tb.KINEMATIC))
        )
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
    spare = AABB_MARGIN * mean if frame[tb.FRAME_MOVES] != 0.0 else 0.0
    mobile = bodies.kind[i] > tb.STATIC
    margin = AABB_MARGIN * min(properties[tb.BOUNDING_RADIUS], mean) if mobile else spare
    x, y = pose[tb.X] - frame[tb.FRAME_X], pose[tb.Y] - frame[tb.FRAME_Y]
    by_x, by_y = (
        (motion[tb.VX] - frame[tb.FRAME_VX]) * ahead,
        (motion[tb.VY] - frame[tb.FRAME_VY]) * ahead,
    )
    bounds[tb.LOW_X] = x - margin + min(by_x, motion[tb.DX], 0.0)
    bounds[tb.LOW_Y] = y - margin + min(by_y, motion[tb.DY], 0.0)
    bounds[tb.HIGH_X] = x + margin + max(by_x, motion[tb.DX], 0.0)
    bounds[tb.HIGH_Y] = y + margin + max(by_y, motion[tb.DY], 0.0)
    bounds[tb.BASE_ANGLE], bounds[tb.ANGLE_MARGIN] = pose[tb.ANGLE], 0.0
    if mobile and properties[tb.CORE_RADIUS] > 0.0:
        turn = max(abs(motion[tb.SPIN]) * ahead, abs(motion[tb.DANGLE]))
        bounds[tb.ANGLE_MARGIN] = margin / properties[tb.CORE_RADIUS] + turn
    elif mobile:
        bounds[tb.ANGLE_MARGIN] = FAR


def mean_radius(kind: Integers, properties: Array) -> float:
    """Return the mean bounding radius of dynamic bodies, m."""
    total = 0.0
    number = 0
    for i in range(len(kind)):
        if kind[i] == tb.DYNAMIC:
            total += properties[i, tb.BOUNDING_RADIUS]
            number += 1
    return total / number if number > 0 else 0.0
