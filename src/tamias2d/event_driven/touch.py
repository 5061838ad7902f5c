"""In which one point a pair touches, if in one, and whether it touches a third body besides."""

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.approach import (
    MARGIN,
    axis_of,
    position_at,
    resolution,
    size_of,
    state_at,
)
from tamias2d.event_driven.axes import best_axis, find_axes, find_gaps, nearest_gap
from tamias2d.event_driven.cells import gather
from tamias2d.event_driven.kinds import has_hull, is_pushed
from tamias2d.event_driven.meeting import meets
from tamias2d.event_driven.stand import resolution_of, stand, turn
from tamias2d.event_driven.tables import Moving, Pair, Point, World
from tamias2d.kernels.assembled import inlined, separate

NOT_ONE = -1.0
MOST_RESOLUTION = 0.01  # of the smaller size: the largest gap that may count as none


@inlined
def touch_of(
    i: int, j: int, a: Moving, b: Moving, time: float, world: World
) -> tuple[Point, int, int, float]:
    """Return where a pair touches, whether P is the second body and has a side there, as 0 or 1.

    Last comes the largest gap that counts as none, m, or `NOT_ONE` where it is not one point.
    """
    if has_hull(i, j, world):
        return touch_of_hulls(i, j, time, world)
    tolerance = resolution(a, b, size_of(i, world), size_of(j, world), time)
    ux, uy, gap, swapped = axis_of(a, b, i, j, world)
    sided = 1 if world.kinds[i] == tb.PLANE or world.kinds[j] == tb.PLANE else 0
    good = gap <= tolerance
    return (ux, uy, 0.0, 0.0, 0.0, 0.0), swapped, sided, tolerance if good else NOT_ONE


@separate
def touch_of_hulls(i: int, j: int, time: float, world: World) -> tuple[Point, int, int, float]:
    """Return what `touch_of` does, for a pair with corners; undecided where several axes touch."""
    tolerance, count = axes_at(i, j, time, world)
    best = best_axis(count, world)
    gap = world.hulls.axes[best, tb.AXIS_GAP]
    sided = 1 if world.hulls.owners[best, tb.SIDE] >= 0 else 0
    good = gap <= tolerance
    for axis in range(count):
        good = good and (axis == best or world.hulls.axes[axis, tb.AXIS_GAP] < gap - tolerance)
    found, touching = find_gaps(best, tb.FIRST_STAND, tb.SECOND_STAND, world), 0
    for k in range(found):
        touching += 1 if world.hulls.gaps[k, tb.GAP] <= gap + tolerance else 0
    nearest = nearest_gap(best, tb.FIRST_STAND, tb.SECOND_STAND, found, world)
    good = good and not (sided == 1 and touching > 1)
    axis, row = world.hulls.axes[best], world.hulls.gaps[nearest]
    point = (axis[tb.AXIS_X], axis[tb.AXIS_Y], row[tb.Q_X], row[tb.Q_Y], row[tb.P_X], row[tb.P_Y])
    return point, world.hulls.owners[best, tb.SWAPPED], sided, tolerance if good else NOT_ONE


@separate
def axes_at(i: int, j: int, time: float, world: World) -> tuple[float, int]:
    """List the axes of a pair with corners at a time, s; return its resolution, m, and how many."""
    stand(tb.FIRST_STAND, i, time, world)
    stand(tb.SECOND_STAND, j, time, world)
    turn(tb.FIRST_STAND, world)
    turn(tb.SECOND_STAND, world)
    tolerance = resolution_of(tb.FIRST_STAND, tb.SECOND_STAND, time, world)
    return tolerance, find_axes(tb.FIRST_STAND, tb.SECOND_STAND, world)


@inlined
def touches_third(i: int, j: int, time: float, world: World) -> bool:
    """Return whether one of two bodies that meet may touch a third one."""
    for k in (i, j):
        if not is_pushed(k, world):
            continue
        a = state_at(k, time, world.paths)
        for place in range(gather(k, world)):
            other = world.near[place]
            if other in (i, j) or not meets(k, other, world) or is_far(a, k, other, time, world):
                continue
            gap, tolerance = gap_between(k, a, other, time, world)
            if gap <= 2.0 * tolerance:
                return True
    return False


@inlined
def gap_between(k: int, a: Moving, other: int, time: float, world: World) -> Pair:
    """Return the gap between a body in a state and another one, and its resolution, m."""
    if has_hull(k, other, world):
        tolerance, count = axes_at(k, other, time, world)
        return float(world.hulls.axes[best_axis(count, world), tb.AXIS_GAP]), tolerance
    b = state_at(other, time, world.paths)
    tolerance = resolution(a, b, size_of(k, world), size_of(other, world), time)
    _, _, gap, _ = axis_of(a, b, k, other, world)
    return gap, tolerance


@inlined
def is_far(a: Moving, i: int, j: int, time: float, world: World) -> bool:
    """Return whether a body in a state is well apart from another one at a time, s."""
    if world.kinds[j] == tb.PLANE:
        return False
    x, y = position_at(j, time, world.paths)
    apart = (world.bodies[i, tb.RADIUS] + world.bodies[j, tb.RADIUS]) * (1.0 + MARGIN)
    return bool((x - a[0]) * (x - a[0]) + (y - a[1]) * (y - a[1]) > apart * apart)
