"""When two shapes that move on first come close: conservative advancement within a step.

Serves: a step, for what moves far in it. Hides: how an instant is found that passes no meeting.

Over a step the centres move in straight lines and the bodies turn evenly. Along a fixed direction
n from the nearest point of A to that of B, the gap after a further fraction h is at least

    phi(h) = min n.(w + h w') - max n.(v + h v') + n.(d + h d') - radii - h^2/2 bend

with corners v of A and w of B, the place d of B from A, and bend the largest centripetal part that
the turning has: turn^2 times the lever of the farthest corner, for A and for B. This is concave,
so that it is positive before its root, and secants find the root from below. A body that turns far
is taken as a disc around its centre where that allows a longer stride. Shapes meet where the gap
falls to `NEAR` of the smaller one's size.

Source: Mirtich, Impulse-based dynamic simulation (1996), with bounds of second order.
"""

from math import cos, sin, sqrt

from tamias2d.engine.narrow_phase.clip import TINY
from tamias2d.engine.narrow_phase.collide import collide_cores
from tamias2d.engine.narrow_phase.core import Core
from tamias2d.engine.tables import GAP, HALF_PLANE, NX, NY, POINT, Events, Shapes
from tamias2d.state import Array

NEAR = 2.0**-13  # of the smaller shape's size: a gap that counts as met
LOOKS = 4096  # poses looked at, at most: a bar that spins 50 times within a hair of a wall
CLOSE_LOOKS = 64  # of these, while a pair is as close as at the start
MISSED = 2.0
WIDE = 1e100  # m, farther than anything
WIDER = 1.0 + 2.0**-20  # of a circle, against rounding
ROUNDS = 6  # halvings of what is not yet known to be free


def time_of_impact(
    a: int,
    b: int,
    delta_x: float,
    delta_y: float,
    move_x: float,
    move_y: float,
    turn_a: float,
    turn_b: float,
    shapes: Shapes,
    events: Events,
) -> float:
    """Return the fraction of a step at which shapes a and b first come close, or `MISSED`.

    B's body starts at (delta_x, delta_y) from A's and moves by (move_x, move_y) more than it, m;
    the bodies turn by turn_a and turn_b, rad; `turned` is as at the start. `scratch` (k, 32) has a
    row for the result and one for each corner of both shapes.

    At the fraction the gap is positive, and at most `NEAR` of the smaller shape's size: their
    manifold at that pose has the normal and the points. A pair that is as close already at the
    start is met when it has come as much closer, or close again after it was apart.
    """
    if shapes.kind[b] == HALF_PLANE:
        a, b = b, a
        delta_x, delta_y, move_x, move_y = -delta_x, -delta_y, -move_x, -move_y
        turn_a, turn_b = turn_b, turn_a
    if shapes.kind[b] == HALF_PLANE:
        return MISSED
    plane = shapes.kind[a] == HALF_PLANE
    first_a, count_a = int(shapes.first[a]), int(shapes.count[a])
    first_b, count_b = int(shapes.first[b]), int(shapes.count[b])
    radius_a, radius_b = float(shapes.radius[a]), float(shapes.radius[b])
    lever_a = 0.0 if plane else vertex_radius(first_a, count_a, shapes.world_vertices)
    lever_b = vertex_radius(first_b, count_b, shapes.world_vertices)
    size = extent(first_b, count_b, shapes.world_vertices) + radius_b
    if not plane:
        size = min(size, extent(first_a, count_a, shapes.world_vertices) + radius_a)
    near = NEAR * size
    reach = (lever_a + radius_a + lever_b + radius_b) * WIDER + near
    at, last = 0.0, 1.0
    if not plane:
        at, last = within_circle(delta_x, delta_y, move_x, move_y, reach)
    elif turn_a == 0.0:
        nx, ny = shapes.world_vertices[first_a, 2], shapes.world_vertices[first_a, 3]
        height = nx * delta_x + ny * delta_y - shapes.world_vertices[first_a, 0] - reach
        at, last = below(height, nx * move_x + ny * move_y)
    row = events.scratch[0]
    rows = events.scratch[1:]
    least = near
    for look in range(LOOKS):
        if at >= last:
            return MISSED
        x, y = delta_x + at * move_x, delta_y + at * move_y
        place_vertices(first_a, count_a, turn_a * at, plane, shapes.world_vertices, 0, rows)
        place_vertices(first_b, count_b, turn_b * at, False, shapes.world_vertices, count_a, rows)
        _, second = collide_cores(
            row,
            Core(int(shapes.kind[a]), 0, count_a, radius_a, 0.0),
            Core(int(shapes.kind[b]), count_a, count_b, radius_b, 0.0),
            x,
            y,
            WIDE,
            rows,
        )
        gap = row[GAP]
        if second > 0:
            gap = min(gap, row[GAP + POINT])
        if at == 0.0 and gap <= near:
            least = gap - near
        elif gap > near:
            least = near
        if gap > least and (least == near or look < CLOSE_LOOKS):
            free = safe_advance(
                row[NX],
                row[NY],
                radius_a + radius_b + least - 0.5 * near,
                x,
                y,
                move_x,
                move_y,
                turn_a,
                turn_b,
                lever_a,
                lever_b,
                0 if plane else count_a,
                count_a,
                count_b,
                last - at,
                rows,
            )
            if at + free == at:
                return at
            at += free
        else:
            return at
    return at


def place_vertices(
    first: int, count: int, turn: float, fixed: bool, vertices: Array, to: int, rows: Array
) -> None:
    """Write the corners of a shape, turned on by an angle, from a row on; an offset is fixed."""
    c, d = cos(turn), sin(turn)
    for k in range(count):
        x, y, nx, ny = (
            vertices[first + k, 0],
            vertices[first + k, 1],
            vertices[first + k, 2],
            vertices[first + k, 3],
        )
        rows[to + k, 0] = x if fixed else c * x - d * y
        rows[to + k, 1] = y if fixed else d * x + c * y
        rows[to + k, 2], rows[to + k, 3] = c * nx - d * ny, d * nx + c * ny


def safe_advance(
    nx: float,
    ny: float,
    radii: float,
    x: float,
    y: float,
    move_x: float,
    move_y: float,
    turn_a: float,
    turn_b: float,
    lever_a: float,
    lever_b: float,
    count_a: int,
    first_b: int,
    count_b: int,
    rest: float,
    rows: Array,
) -> float:
    """Return the fraction, at most the rest, for which the cores stay more than `radii` apart.

    `count_a` is 0 for a half-plane, with which n turns; its offset is then in the first row.
    """
    rate = nx * move_x + ny * move_y
    bend_a, bend_b = turn_a * turn_a * lever_a, turn_b * turn_b * lever_b
    spin_b = turn_b
    if count_a == 0 and turn_a != 0.0:
        spin_b -= turn_a
        rate += turn_a * (nx * y - ny * x)
        far = sqrt(x * x + y * y) + lever_b + rest * (abs(move_x) + abs(move_y))
        speed = abs(move_x) + abs(move_y) + abs(turn_b) * lever_b
        bend_a = turn_a * turn_a * far + 2.0 * abs(turn_a) * speed
    base = nx * x + ny * y - radii - (rows[0, 0] if count_a == 0 else 0.0)
    free = 0.0
    for way in range(4):  # with corners or as a disc: A is one in ways 1 and 3, B in 2 and 3
        round_a, round_b = way % 2 == 1, way >= 2
        if round_a and (count_a == 0 or abs(turn_a) * rest < 1.0):
            continue
        if round_b and abs(turn_b) * rest < 1.0:
            continue
        free = max(
            free,
            below_root(
                nx,
                ny,
                base - (lever_a if round_a else 0.0) - (lever_b if round_b else 0.0),
                rate,
                (0.0 if round_a else bend_a) + (0.0 if round_b else bend_b),
                turn_a,
                spin_b,
                0 if round_a else count_a,
                first_b,
                0 if round_b else count_b,
                rest,
                rows,
            ),
        )
        if free >= rest:
            break
    return free


def below_root(
    nx: float,
    ny: float,
    base: float,
    rate: float,
    bend: float,
    turn_a: float,
    turn_b: float,
    count_a: int,
    first_b: int,
    count_b: int,
    rest: float,
    rows: Array,
) -> float:
    """Return a fraction below the root of phi, near it, or the rest if the root is not within."""
    low, high = 0.0, rest
    over = least_gap(low, nx, ny, base, rate, bend, turn_a, turn_b, count_a, first_b, count_b, rows)
    if over <= 0.0:
        return 0.0
    enough = 2.0**-4 * over
    under = least_gap(
        high, nx, ny, base, rate, bend, turn_a, turn_b, count_a, first_b, count_b, rows
    )
    if under >= 0.0:
        return rest
    for _ in range(ROUNDS):
        low += (high - low) * over / (over - under)
        over = least_gap(
            low, nx, ny, base, rate, bend, turn_a, turn_b, count_a, first_b, count_b, rows
        )
        if over <= enough:
            break
        middle = 0.5 * (low + high)
        value = least_gap(
            middle, nx, ny, base, rate, bend, turn_a, turn_b, count_a, first_b, count_b, rows
        )
        if value > 0.0:
            low, over = middle, value
        else:
            high, under = middle, value
    return low


def least_gap(
    ahead: float,
    nx: float,
    ny: float,
    base: float,
    rate: float,
    bend: float,
    turn_a: float,
    turn_b: float,
    count_a: int,
    first_b: int,
    count_b: int,
    rows: Array,
) -> float:
    """Return the least that the gap can be after a further fraction, m."""
    by_a, by_b = ahead * turn_a, ahead * turn_b
    low_a = least_along(0, count_a, -nx - by_a * ny, -ny + by_a * nx, rows)
    low_b = least_along(first_b, count_b, nx + by_b * ny, ny - by_b * nx, rows)
    return base + low_a + low_b + ahead * (rate - 0.5 * ahead * bend)


def least_along(first: int, count: int, nx: float, ny: float, rows: Array) -> float:
    """Return how far the corners reach along a direction at least, m; 0 for none."""
    low = WIDE if count > 0 else 0.0
    for k in range(first, first + count):
        low = min(low, nx * rows[k, 0] + ny * rows[k, 1])
    return low


def vertex_radius(first: int, count: int, vertices: Array) -> float:
    """Return how far the corners are from the centre at most, m."""
    far = 0.0
    for k in range(first, first + count):
        far = max(far, vertices[k, 0] * vertices[k, 0] + vertices[k, 1] * vertices[k, 1])
    return sqrt(far)


def extent(first: int, count: int, vertices: Array) -> float:
    """Return half of the distance of the first corner from the farthest one, m."""
    far = 0.0
    for k in range(first + 1, first + count):
        x, y = vertices[k, 0] - vertices[first, 0], vertices[k, 1] - vertices[first, 1]
        far = max(far, x * x + y * y)
    return 0.5 * sqrt(far)


def within_circle(
    x: float, y: float, move_x: float, move_y: float, reach: float
) -> tuple[float, float]:
    """Return between which fractions a point that moves is within reach of the origin."""
    square = move_x * move_x + move_y * move_y
    if square <= TINY:
        return (0.0, 1.0) if x * x + y * y <= reach * reach else (0.0, 0.0)
    speed = sqrt(square)
    beside = (x * move_y - y * move_x) / speed
    if abs(beside) > reach:
        return 0.0, 0.0
    middle = -(x * move_x + y * move_y) / square
    half = sqrt(reach * reach - beside * beside) / speed
    return max(0.0, middle - half), min(1.0, middle + half)


def below(height: float, rate: float) -> tuple[float, float]:
    """Return between which fractions a height that changes evenly is not positive."""
    after = height + rate
    if height > 0.0:
        return (1.0 if after >= 0.0 else -height / rate), 1.0
    return 0.0, (1.0 if after <= 0.0 else -height / rate)
