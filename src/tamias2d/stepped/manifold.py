"""Where two shapes touch, or would touch soon: a normal and up to two points with separations.

Serves: a step, for each pair at its start. Hides: the kinds of shapes, and what a pair remembers.

All shapes but half-planes are corners grown by a radius: a disc has one corner, a capsule two. A
point is midway between the surfaces. So of the arm p from the centre of A to it, p.n - radius_a -
separation/2 reaches along the normal and turns with the sides and corners of A, and of the arm q
from B's centre q.n + radius_b + separation/2: both are 0 for a disc, which may roll.

Sources: Gregorius, The separating axis test between convex polyhedra (GDC 2013), for the side that
leaves most room; Catto, Box2D v3 (2024), for points of pairs that do not touch yet.
"""

from math import sqrt

from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array
from tamias2d.stepped.clip import NAMES, TINY
from tamias2d.stepped.layout import (
    COUNT,
    FEATURE,
    GAP,
    HALF_PLANE,
    NX,
    NY,
    POINT,
    PRELOAD,
    PUSH,
    PX,
    PY,
    RUB,
    SHAPE_INNER,
    Whole,
)
from tamias2d.stepped.polygons import touch_again, touch_polygons
from tamias2d.stepped.separation import facing_side


@inlined
def collide(
    slot: int,
    a: int,
    b: int,
    delta_x: float,
    delta_y: float,
    margin: float,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    surface: Array,
    turned: Array,
    touch: Array,
    trace: Whole,
) -> int:
    """Write the manifold of shapes a and b to a row of `touch` and `trace`; return its points.

    B's body is at (delta_x, delta_y) from A's, m. Points with a separation below the margin, m,
    count; impulses of points that were there before are kept, others are 0. A row of
    `trace` starts with zeros, and serves one pair of shapes.
    """
    row, ids = touch[slot], trace[slot]
    kind_a, kind_b = int(shape_kind[a]), int(shape_kind[b])
    first_a, first_b = int(shape_first[a]), int(shape_first[b])
    count_a, count_b = int(shape_count[a]), int(shape_count[b])
    radius_a, radius_b = float(shape_radius[a]), float(shape_radius[b])
    x, y = float(delta_x), float(delta_y)
    if count_a > 1 and count_b > 1:
        first, second = touch_again(
            row,
            ids,
            first_a,
            count_a,
            first_b,
            count_b,
            x,
            y,
            radius_a,
            radius_b,
            float(surface[a, SHAPE_INNER]),
            float(surface[b, SHAPE_INNER]),
            margin,
            turned,
        )
    else:
        first, second = touch_pair(
            row,
            kind_a,
            kind_b,
            first_a,
            count_a,
            first_b,
            count_b,
            x,
            y,
            radius_a,
            radius_b,
            margin,
            turned,
        )
    return kept(row, ids, first, second)


def touch_pair(
    row: Array,
    kind_a: int,
    kind_b: int,
    first_a: int,
    count_a: int,
    first_b: int,
    count_b: int,
    x: float,
    y: float,
    radius_a: float,
    radius_b: float,
    margin: float,
    turned: Array,
) -> tuple[int, int]:
    """Write normal, points and separations of two shapes to a row of `touch`.

    Return the names of the points, 0 for one that is not within the margin.
    """
    if kind_a == HALF_PLANE:
        if kind_b == HALF_PLANE:
            return 0, 0
        return touch_plane(row, first_a, first_b, count_b, x, y, radius_b, margin, False, turned)
    if kind_b == HALF_PLANE:
        return touch_plane(row, first_b, first_a, count_a, -x, -y, radius_a, margin, True, turned)
    if count_a > 1:
        if count_b > 1:
            return touch_polygons(
                row, first_a, count_a, first_b, count_b, x, y, radius_a, radius_b, margin, turned
            )
        name = touch_disc(
            row, first_a, count_a, first_b, x, y, radius_a, radius_b, margin, False, turned
        )
    elif count_b > 1:
        name = touch_disc(
            row, first_b, count_b, first_a, -x, -y, radius_b, radius_a, margin, True, turned
        )
    else:
        name = touch_discs(row, first_a, first_b, x, y, radius_a, radius_b, margin, turned)
    return name, 0


def kept(row: Array, ids: Whole, first: int, second: int) -> int:
    """Move impulses to where their points are now, set those of new points to 0, count points."""
    before, other = ids[FEATURE], ids[FEATURE + 1]
    if first != before or second != other:
        push, rub = row[PUSH], row[RUB]
        push_other, rub_other = row[PUSH + POINT], row[RUB + POINT]
        preload, preload_other = row[PRELOAD], row[PRELOAD + POINT]
        for k in range(2):
            name = second if k else first
            at = POINT * k
            is_first = name > 0 and name == before
            is_second = name > 0 and name == other
            row[PUSH + at] = push if is_first else push_other if is_second else 0.0
            row[RUB + at] = rub if is_first else rub_other if is_second else 0.0
            row[PRELOAD + at] = preload if is_first else preload_other if is_second else 0.0
        ids[FEATURE], ids[FEATURE + 1] = first, second
    count = (first > 0) + (second > 0)
    ids[COUNT] = count
    return count


def touch_discs(
    row: Array,
    first_a: int,
    first_b: int,
    x: float,
    y: float,
    radius_a: float,
    radius_b: float,
    margin: float,
    turned: Array,
) -> int:
    """Write the point between two discs to a row of `touch`; return its name, or 0."""
    ax, ay = turned[first_a, 0], turned[first_a, 1]
    dx, dy = x + turned[first_b, 0] - ax, y + turned[first_b, 1] - ay
    radii = radius_a + radius_b
    square = dx * dx + dy * dy
    if square >= (radii + margin) * (radii + margin):
        return 0
    distance = sqrt(square)
    nx, ny = (dx / distance, dy / distance) if square > TINY else (0.0, 1.0)
    middle = 0.5 * (distance + radius_a - radius_b)
    row[NX], row[NY] = nx, ny
    row[PX], row[PY], row[GAP] = ax + nx * middle, ay + ny * middle, distance - radii
    return 1


def touch_disc(
    row: Array,
    first_p: int,
    count_p: int,
    first_q: int,
    x: float,
    y: float,
    radius_p: float,
    radius_q: float,
    margin: float,
    swapped: bool,
    turned: Array,
) -> int:
    """Write the point between a shape with sides and a disc; return its name, or 0.

    The disc's body is at (x, y) from the other, m; `swapped` says that the disc is A.
    """
    centre_x, centre_y = turned[first_q, 0], turned[first_q, 1]
    x, y = x + centre_x, y + centre_y
    if not swapped:
        centre_x, centre_y = x, y
    reach = radius_p + radius_q + margin
    best = -1e308
    i = 0
    for k in range(count_p):
        p = first_p + k
        room = turned[p, 2] * (x - turned[p, 0]) + turned[p, 3] * (y - turned[p, 1])
        if room > best:
            best = room
            i = k
    if best >= reach:
        return 0
    p = first_p + i
    next_p = first_p + (i + 1 if i + 1 < count_p else 0)
    nx, ny = turned[p, 2], turned[p, 3]
    vx, vy = turned[p, 0], turned[p, 1]
    length = nx * (turned[next_p, 1] - vy) - ny * (turned[next_p, 0] - vx)
    along = nx * (y - vy) - ny * (x - vx)
    distance = best
    if best >= 0.0 and (along < 0.0 or along > length):
        at = first_p + (i if along < 0.0 else (i + 1 if i + 1 < count_p else 0))
        dx, dy = x - turned[at, 0], y - turned[at, 1]
        square = dx * dx + dy * dy
        distance = sqrt(square)
        if distance >= reach:
            return 0
        if square > TINY:
            nx, ny = dx / distance, dy / distance
    middle = 0.5 * (radius_p - radius_q - distance)
    row[NX], row[NY] = (-nx, -ny) if swapped else (nx, ny)
    row[PX], row[PY] = centre_x + nx * middle, centre_y + ny * middle
    row[GAP] = distance - radius_p - radius_q
    return 1


def touch_plane(
    row: Array,
    plane: int,
    first_q: int,
    count_q: int,
    x: float,
    y: float,
    radius: float,
    margin: float,
    swapped: bool,
    turned: Array,
) -> tuple[int, int]:
    """Write the points between a half-plane and a shape; return their names, or 0.

    The shape's body is at (x, y) from the half-plane's, m; `swapped` says that the shape is A. The
    points are its lowest corner and the other end of the side that looks more at the half-plane:
    of a thin card the next lower corner may be at the same end.
    """
    nx, ny = turned[plane, 2], turned[plane, 3]
    base = nx * x + ny * y - turned[plane, 0] - radius
    low = 1e308
    at = 0
    for k in range(count_q):
        height = nx * turned[first_q + k, 0] + ny * turned[first_q + k, 1]
        if height < low:
            low = height
            at = k
    if base + low >= margin:
        return 0, 0
    row[NX], row[NY] = (-nx, -ny) if swapped else (nx, ny)
    if swapped:
        x, y = 0.0, 0.0
    touch_corner(row, 0, first_q + at, nx, ny, x, y, base + low, radius, turned)
    first = 1 + (at * NAMES if swapped else at)
    if count_q == 1:
        return first, 0
    beside = facing_side(first_q, count_q, at, nx, ny, turned)
    if beside == at:
        beside = at + 1 if at + 1 < count_q else 0
    low = nx * turned[first_q + beside, 0] + ny * turned[first_q + beside, 1]
    if base + low >= margin:
        return first, 0
    touch_corner(row, POINT, first_q + beside, nx, ny, x, y, base + low, radius, turned)
    return first, 1 + (beside * NAMES if swapped else beside)


def touch_corner(
    row: Array,
    at: int,
    corner: int,
    nx: float,
    ny: float,
    x: float,
    y: float,
    gap: float,
    radius: float,
    turned: Array,
) -> None:
    """Write the point under a corner of a shape at (x, y) from A, over a plane with normal n."""
    down = radius + 0.5 * gap
    row[PX + at] = x + turned[corner, 0] - nx * down
    row[PY + at] = y + turned[corner, 1] - ny * down
    row[GAP + at] = gap
