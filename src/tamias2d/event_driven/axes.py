"""The axes that separate two bodies at hand, and the gaps along one of them.

It is what `tamias2d.contact.gap` does, operation by operation.
"""

from math import inf

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.length import hypot
from tamias2d.event_driven.tables import World
from tamias2d.generated import impact
from tamias2d.kernels.assembled import inlined

EPSILON = 2.0**-52
AWAY = 4  # of the rounding of a place: by how far a step that leaves a side turns away from it
IN_LINE = 1e-12  # of the sizes: by how much rounding may make collinear cores seem to cross


def find_axes(a: int, b: int, world: World) -> int:
    """List the axes of two bodies at hand; return how many. One of them has sides."""
    forms, count = world.hulls.forms, 0
    if forms[a, tb.SIDES] > 0 and forms[b, tb.CORNERS] > 0:
        count = add_sides(a, b, 0, count, world)
    if forms[b, tb.SIDES] > 0 and forms[a, tb.CORNERS] > 0:
        count = add_sides(b, a, 1, count, world)
    if forms[a, tb.CORNERS] == 1:
        return with_corner(b, a, 1, count, world)
    if forms[b, tb.CORNERS] == 1:
        return with_corner(a, b, 0, count, world)
    p, q = world.hulls.stands[a], world.hulls.stands[b]
    round_ends = p[tb.ROUND] > 0.0 or q[tb.ROUND] > 0.0
    if round_ends or min(forms[a, tb.CORNERS], forms[b, tb.CORNERS]) == 2:
        return with_nearest(a, b, count, world)
    return count


def best_axis(count: int, world: World) -> int:
    """Return the first of the axes with the largest gap."""
    best = 0
    for k in range(1, count):
        if world.hulls.axes[k, tb.AXIS_GAP] > world.hulls.axes[best, tb.AXIS_GAP]:
            best = k
    return best


def add_sides(p: int, q: int, swapped: int, count: int, world: World) -> int:
    """Add the axes that the sides of P have; return how many there are then."""
    body, other = world.hulls.stands[p], world.hulls.stands[q]
    dx, dy = other[tb.X] - body[tb.X], other[tb.Y] - body[tb.Y]
    begin, corners = world.hulls.forms[p, tb.BEGIN], world.hulls.forms[q, tb.CORNERS]
    for side in range(world.hulls.forms[p, tb.SIDES]):
        ux = world.hulls.placed[p, side, tb.PLACED_NORMAL_X]
        uy = world.hulls.placed[p, side, tb.PLACED_NORMAL_Y]
        nearest = inf
        for k in range(corners):
            corner = world.hulls.placed[q, k]
            nearest = min(nearest, ux * corner[tb.PLACED_X] + uy * corner[tb.PLACED_Y])
        offset = world.hulls.outline[begin + side, tb.SIDE_OFFSET]
        row, owner = world.hulls.axes[count], world.hulls.owners[count]
        row[tb.AXIS_X], row[tb.AXIS_Y] = ux, uy
        row[tb.AXIS_GAP] = ux * dx + uy * dy + nearest - offset - other[tb.ROUND]
        owner[tb.SWAPPED], owner[tb.SIDE] = swapped, side
        count += 1
    return count


@inlined
def between(x: float, y: float, base: float, swapped: int, world: World) -> int:
    """Replace all axes by the one along a vector from P to Q, m."""
    distance, row = hypot(x, y), world.hulls.axes[0]
    row[tb.AXIS_X], row[tb.AXIS_Y], row[tb.AXIS_GAP] = 1.0, 0.0, distance - base
    if distance > 0.0:
        row[tb.AXIS_X], row[tb.AXIS_Y] = x / distance, y / distance
    world.hulls.owners[0, tb.SWAPPED], world.hulls.owners[0, tb.SIDE] = swapped, -1
    return 1


def with_corner(p: int, disc: int, swapped: int, count: int, world: World) -> int:
    """Replace the axes by that from P's corner to a disc, if a corner is what is nearest to it."""
    best, body, other = best_axis(count, world), world.hulls.stands[p], world.hulls.stands[disc]
    axis, form = world.hulls.axes[best], world.hulls.forms[p]
    side = world.hulls.outline[form[tb.BEGIN] + world.hulls.owners[best, tb.SIDE]]
    radius = body[tb.ROUND] + other[tb.ROUND]
    inside = axis[tb.AXIS_GAP] + radius <= 0.0 and form[tb.CORNERS] > 2
    if inside or side[tb.LOW] == -inf:
        return count
    ux, uy = axis[tb.AXIS_X], axis[tb.AXIS_Y]
    dx, dy = other[tb.X] - body[tb.X], other[tb.Y] - body[tb.Y]
    along = dy * ux - dx * uy
    if side[tb.LOW] <= along <= side[tb.HIGH]:
        return count
    t = side[tb.LOW] if along < side[tb.LOW] else side[tb.HIGH]
    offset = side[tb.SIDE_OFFSET] - body[tb.ROUND]
    x, y = offset * ux - t * uy, offset * uy + t * ux
    return between(dx - x, dy - y, radius, swapped, world)


def with_nearest(a: int, b: int, count: int, world: World) -> int:
    """Replace the axes by that from corner to corner, if these are nearest: of round ends."""
    p, q = world.hulls.stands[a], world.hulls.stands[b]
    base = p[tb.ROUND] + q[tb.ROUND]
    gap = world.hulls.axes[best_axis(count, world), tb.AXIS_GAP]
    crossed = gap + base < -IN_LINE * (p[tb.SIZE] + q[tb.SIZE])
    if crossed or world.hulls.forms[a, tb.CORNERS] == 0 or world.hulls.forms[b, tb.CORNERS] == 0:
        return count
    dx, dy = q[tb.X] - p[tb.X], q[tb.Y] - p[tb.Y]
    least, x, y, i, j = inf, 0.0, 0.0, 0, 0
    for m in range(world.hulls.forms[a, tb.CORNERS]):
        for n in range(world.hulls.forms[b, tb.CORNERS]):
            one, other = world.hulls.placed[a, m], world.hulls.placed[b, n]
            to_x = dx + other[tb.PLACED_X] - one[tb.PLACED_X]
            to_y = dy + other[tb.PLACED_Y] - one[tb.PLACED_Y]
            length = hypot(to_x, to_y)
            if length < least:
                least, x, y, i, j = length, to_x, to_y, m, n
    slack = AWAY * EPSILON * (abs(dx) + abs(dy) + p[tb.SIZE] + q[tb.SIZE]) if base > 0.0 else 0.0
    if leaves(x, y, a, i, slack, world) and leaves(-x, -y, b, j, slack, world):
        return between(x, y, base, 0, world)
    return count


def leaves(x: float, y: float, body: int, k: int, slack: float, world: World) -> bool:
    """Return whether a step from a corner turns away from both sides there."""
    count, corner = world.hulls.forms[body, tb.CORNERS], world.hulls.placed[body, k]
    found = True
    for other in ((k + count - 1) % count, (k + 1) % count):
        row = world.hulls.placed[body, other]
        u, v = row[tb.PLACED_X] - corner[tb.PLACED_X], row[tb.PLACED_Y] - corner[tb.PLACED_Y]
        found = found and x * u + y * v < -slack * hypot(u, v)
    return found


def find_gaps(axis: int, a: int, b: int, world: World) -> int:
    """List the gaps along an axis of two bodies at hand; return how many."""
    p, q = (b, a) if world.hulls.owners[axis, tb.SWAPPED] == 1 else (a, b)
    ux, uy = world.hulls.axes[axis, tb.AXIS_X], world.hulls.axes[axis, tb.AXIS_Y]
    body, other = world.hulls.stands[p], world.hulls.stands[q]
    dx, dy, side = (
        other[tb.X] - body[tb.X],
        other[tb.Y] - body[tb.Y],
        world.hulls.owners[axis, tb.SIDE],
    )
    of_p, of_q = world.hulls.forms[p, tb.BEGIN], world.hulls.forms[q, tb.BEGIN]
    sided = side >= 0
    base = world.hulls.outline[of_p + side, tb.SIDE_OFFSET] if sided else body[tb.ROUND]
    base += other[tb.ROUND]
    count, v_p, v_q = 0, (body[tb.VX], body[tb.VY]), (other[tb.VX], other[tb.VY])
    for m in range(1 if sided else world.hulls.forms[p, tb.CORNERS]):
        vx = 0.0 if sided else world.hulls.placed[p, m, tb.PLACED_X]
        vy = 0.0 if sided else world.hulls.placed[p, m, tb.PLACED_Y]
        for n in range(world.hulls.forms[q, tb.CORNERS]):
            wx, wy = world.hulls.placed[q, n, tb.PLACED_X], world.hulls.placed[q, n, tb.PLACED_Y]
            x, y = dx + wx - vx, dy + wy - vy
            arm = (x, y) if sided else (vx, vy)
            row = world.hulls.gaps[count]
            row[tb.GAP] = ux * x + uy * y - base
            row[tb.RATE] = impact.normal_velocity(
                v_p, body[tb.SPIN], arm, v_q, other[tb.SPIN], (wx, wy), (ux, uy)
            )
            row[tb.REACH_P] = 0.0 if sided else reach_of(p, of_p + m, world)
            row[tb.REACH_Q] = reach_of(q, of_q + n, world)
            row[tb.Q_X], row[tb.Q_Y], row[tb.P_X], row[tb.P_Y] = wx, wy, vx, vy
            count += 1
    return count


def nearest_gap(axis: int, a: int, b: int, count: int, world: World) -> int:
    """Return which of the gaps listed is the least; from corner to corner, that between these."""
    p, q = (b, a) if world.hulls.owners[axis, tb.SWAPPED] == 1 else (a, b)
    body, other = world.hulls.stands[p], world.hulls.stands[q]
    dx, dy = other[tb.X] - body[tb.X], other[tb.Y] - body[tb.Y]
    nearest, least = 0, inf
    for k in range(count):
        row = world.hulls.gaps[k]
        size = row[tb.GAP]
        if world.hulls.owners[axis, tb.SIDE] < 0:
            size = hypot(dx + row[tb.Q_X] - row[tb.P_X], dy + row[tb.Q_Y] - row[tb.P_Y])
        if size < least:
            nearest, least = k, size
    return nearest


def reach_of(place: int, row: int, world: World) -> float:
    """Return how far a corner of a body at hand is from the centre, m."""
    return 0.0 if place == tb.ROUND_STAND else world.hulls.outline[row, tb.REACH]
