"""The axes that separate two bodies at hand, and the gaps along one of them.

It is what `tamias2d.contact.gap` does, operation by operation.
"""

from math import inf, sqrt

from tamias2d.event_driven.length import hypot
from tamias2d.event_driven.tables import (
    AXIS_GAP,
    AXIS_X,
    AXIS_Y,
    BEGIN,
    CORNERS,
    GAP,
    HIGH,
    LOW,
    P_X,
    P_Y,
    PLACED_NORMAL_X,
    PLACED_NORMAL_Y,
    PLACED_X,
    PLACED_Y,
    Q_X,
    Q_Y,
    RATE,
    REACH,
    REACH_P,
    REACH_Q,
    ROUND,
    ROUND_STAND,
    SIDE,
    SIDE_OFFSET,
    SIDES,
    SIZE,
    SPIN,
    SWAPPED,
    VX,
    VY,
    World,
    X,
    Y,
)
from tamias2d.generated import impact
from tamias2d.kernels.assembled import inlined

IN_LINE = 1e-12  # of the sizes: by how much rounding may make collinear cores seem to cross


def find_axes(a: int, b: int, world: World) -> int:
    """List the axes of two bodies at hand; return how many. One of them has sides."""
    forms, count = world.hulls.forms, 0
    if forms[a, SIDES] > 0 and forms[b, CORNERS] > 0:
        count = add_sides(a, b, 0, count, world)
    if forms[b, SIDES] > 0 and forms[a, CORNERS] > 0:
        count = add_sides(b, a, 1, count, world)
    if forms[a, CORNERS] == 1:
        return with_corner(b, a, 1, count, world)
    if forms[b, CORNERS] == 1:
        return with_corner(a, b, 0, count, world)
    p, q = world.hulls.stands[a], world.hulls.stands[b]
    round_ends = p[ROUND] > 0.0 or q[ROUND] > 0.0
    if round_ends or min(forms[a, CORNERS], forms[b, CORNERS]) == 2:
        return with_nearest(a, b, count, world)
    return count


def best_axis(count: int, world: World) -> int:
    """Return the first of the axes with the largest gap."""
    best = 0
    for k in range(1, count):
        if world.hulls.axes[k, AXIS_GAP] > world.hulls.axes[best, AXIS_GAP]:
            best = k
    return best


def add_sides(p: int, q: int, swapped: int, count: int, world: World) -> int:
    """Add the axes that the sides of P have; return how many there are then."""
    body, other = world.hulls.stands[p], world.hulls.stands[q]
    dx, dy = other[X] - body[X], other[Y] - body[Y]
    begin, corners = world.hulls.forms[p, BEGIN], world.hulls.forms[q, CORNERS]
    for side in range(world.hulls.forms[p, SIDES]):
        ux = world.hulls.placed[p, side, PLACED_NORMAL_X]
        uy = world.hulls.placed[p, side, PLACED_NORMAL_Y]
        nearest = inf
        for k in range(corners):
            corner = world.hulls.placed[q, k]
            nearest = min(nearest, ux * corner[PLACED_X] + uy * corner[PLACED_Y])
        offset = world.hulls.outline[begin + side, SIDE_OFFSET]
        row, owner = world.hulls.axes[count], world.hulls.owners[count]
        row[AXIS_X], row[AXIS_Y] = ux, uy
        row[AXIS_GAP] = ux * dx + uy * dy + nearest - offset - other[ROUND]
        owner[SWAPPED], owner[SIDE] = swapped, side
        count += 1
    return count


@inlined
def between(x: float, y: float, base: float, swapped: int, world: World) -> int:
    """Replace all axes by the one along a vector from P to Q, m."""
    distance, row = hypot(x, y), world.hulls.axes[0]
    row[AXIS_X], row[AXIS_Y], row[AXIS_GAP] = 1.0, 0.0, distance - base
    if distance > 0.0:
        row[AXIS_X], row[AXIS_Y] = x / distance, y / distance
    world.hulls.owners[0, SWAPPED], world.hulls.owners[0, SIDE] = swapped, -1
    return 1


def with_corner(p: int, disc: int, swapped: int, count: int, world: World) -> int:
    """Replace the axes by that from P's corner to a disc, if a corner is what is nearest to it."""
    best, body, other = best_axis(count, world), world.hulls.stands[p], world.hulls.stands[disc]
    axis, form = world.hulls.axes[best], world.hulls.forms[p]
    side = world.hulls.outline[form[BEGIN] + world.hulls.owners[best, SIDE]]
    radius = body[ROUND] + other[ROUND]
    inside = axis[AXIS_GAP] + radius <= 0.0 and form[CORNERS] > 2
    if inside or side[LOW] == -inf:
        return count
    ux, uy = axis[AXIS_X], axis[AXIS_Y]
    dx, dy = other[X] - body[X], other[Y] - body[Y]
    along = dy * ux - dx * uy
    if side[LOW] <= along <= side[HIGH]:
        return count
    t = side[LOW] if along < side[LOW] else side[HIGH]
    offset = side[SIDE_OFFSET] - body[ROUND]
    x, y = offset * ux - t * uy, offset * uy + t * ux
    return between(dx - x, dy - y, radius, swapped, world)


def with_nearest(a: int, b: int, count: int, world: World) -> int:
    """Replace the axes by that from corner to corner, if these are nearest: of round ends."""
    p, q = world.hulls.stands[a], world.hulls.stands[b]
    base = p[ROUND] + q[ROUND]
    gap = world.hulls.axes[best_axis(count, world), AXIS_GAP]
    crossed = gap + base < -IN_LINE * (p[SIZE] + q[SIZE])
    if crossed or world.hulls.forms[a, CORNERS] == 0 or world.hulls.forms[b, CORNERS] == 0:
        return count
    dx, dy = q[X] - p[X], q[Y] - p[Y]
    least, x, y = inf, 0.0, 0.0
    for m in range(world.hulls.forms[a, CORNERS]):
        for n in range(world.hulls.forms[b, CORNERS]):
            one, other = world.hulls.placed[a, m], world.hulls.placed[b, n]
            to_x = dx + other[PLACED_X] - one[PLACED_X]
            to_y = dy + other[PLACED_Y] - one[PLACED_Y]
            length = hypot(to_x, to_y)
            if length < least:
                least, x, y = length, to_x, to_y
    if (x == 0.0 and y == 0.0) or least > distance_to_sides(a, b, dx, dy, world):
        return count
    return between(x, y, base, 0, world)


@inlined
def distance_to_sides(a: int, b: int, dx: float, dy: float, world: World) -> float:
    """Return how far the corners of each of two bodies are from sides that they stand beside, m."""
    best = inf
    for m in range(world.hulls.forms[a, CORNERS]):
        x, y = world.hulls.placed[a, m, PLACED_X], world.hulls.placed[a, m, PLACED_Y]
        best = min(best, distance_to_outline(x, y, b, dx, dy, world))
    for n in range(world.hulls.forms[b, CORNERS]):
        x = dx + world.hulls.placed[b, n, PLACED_X]
        y = dy + world.hulls.placed[b, n, PLACED_Y]
        best = min(best, distance_to_outline(x, y, a, 0.0, 0.0, world))
    return best


def distance_to_outline(x: float, y: float, body: int, dx: float, dy: float, world: World) -> float:
    """Return the distance of a point from the nearest side that it stands beside, or infinity."""
    best, count = inf, world.hulls.forms[body, CORNERS]
    for k in range(count):
        first, last = world.hulls.placed[body, k], world.hulls.placed[body, (k + 1) % count]
        px, py = dx + first[PLACED_X], dy + first[PLACED_Y]
        ex, ey = dx + last[PLACED_X] - px, dy + last[PLACED_Y] - py
        along = (x - px) * ex + (y - py) * ey
        square = ex * ex + ey * ey
        if 0.0 < along < square:
            best = min(best, abs((x - px) * ey - (y - py) * ex) / sqrt(square))
    return best


def find_gaps(axis: int, a: int, b: int, world: World) -> int:
    """List the gaps along an axis of two bodies at hand; return how many."""
    p, q = (b, a) if world.hulls.owners[axis, SWAPPED] == 1 else (a, b)
    ux, uy = world.hulls.axes[axis, AXIS_X], world.hulls.axes[axis, AXIS_Y]
    body, other = world.hulls.stands[p], world.hulls.stands[q]
    dx, dy, side = other[X] - body[X], other[Y] - body[Y], world.hulls.owners[axis, SIDE]
    of_p, of_q = world.hulls.forms[p, BEGIN], world.hulls.forms[q, BEGIN]
    sided = side >= 0
    base = world.hulls.outline[of_p + side, SIDE_OFFSET] if sided else body[ROUND]
    base += other[ROUND]
    count, v_p, v_q = 0, (body[VX], body[VY]), (other[VX], other[VY])
    for m in range(1 if sided else world.hulls.forms[p, CORNERS]):
        vx = 0.0 if sided else world.hulls.placed[p, m, PLACED_X]
        vy = 0.0 if sided else world.hulls.placed[p, m, PLACED_Y]
        for n in range(world.hulls.forms[q, CORNERS]):
            wx, wy = world.hulls.placed[q, n, PLACED_X], world.hulls.placed[q, n, PLACED_Y]
            x, y = dx + wx - vx, dy + wy - vy
            arm = (x, y) if sided else (vx, vy)
            row = world.hulls.gaps[count]
            row[GAP] = ux * x + uy * y - base
            row[RATE] = impact.normal_velocity(
                v_p, body[SPIN], arm, v_q, other[SPIN], (wx, wy), (ux, uy)
            )
            row[REACH_P] = 0.0 if sided else reach_of(p, of_p + m, world)
            row[REACH_Q] = reach_of(q, of_q + n, world)
            row[Q_X], row[Q_Y], row[P_X], row[P_Y] = wx, wy, vx, vy
            count += 1
    return count


def reach_of(place: int, row: int, world: World) -> float:
    """Return how far a corner of a body at hand is from the centre, m."""
    return 0.0 if place == ROUND_STAND else world.hulls.outline[row, REACH]
