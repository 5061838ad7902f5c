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

from tamias2d.engine.narrow_phase.clip import NAMES, TINY
from tamias2d.engine.narrow_phase.polygon import touch_cached, touch_polygons
from tamias2d.engine.narrow_phase.separation import facing_side
from tamias2d.engine.tables import (
    FEATURE,
    GAP,
    HALF_PLANE,
    NORMAL_IMPULSE,
    NX,
    NY,
    POINT,
    POINT_COUNT,
    PRELOAD,
    PX,
    PY,
    SHAPE_INRADIUS,
    TANGENT_IMPULSE,
    Contacts,
    Integers,
    Shapes,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array


@inlined
def collide(
    slot: int,
    a: int,
    b: int,
    delta_x: float,
    delta_y: float,
    margin: float,
    shapes: Shapes,
    contacts: Contacts,
) -> int:
    """Write the manifold of shapes a and b to a row of `touch` and `trace`; return its points.

    B's body is at (delta_x, delta_y) from A's, m. Points with a separation below the margin, m,
    count; impulses of points that were there before are kept, others are 0. A row of
    `trace` starts with zeros, and serves one pair of shapes.
    """
    row, ids = contacts.manifolds[slot], contacts.flags[slot]
    kind_a, kind_b = int(shapes.kind[a]), int(shapes.kind[b])
    first_a, first_b = int(shapes.first[a]), int(shapes.first[b])
    count_a, count_b = int(shapes.count[a]), int(shapes.count[b])
    radius_a, radius_b = float(shapes.radius[a]), float(shapes.radius[b])
    x, y = float(delta_x), float(delta_y)
    if count_a > 1 and count_b > 1:
        first, second = touch_cached(
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
            float(shapes.material[a, SHAPE_INRADIUS]),
            float(shapes.material[b, SHAPE_INRADIUS]),
            margin,
            shapes.world_vertices,
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
            shapes.world_vertices,
        )
    return match_impulses(row, ids, first, second)


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
    vertices: Array,
) -> tuple[int, int]:
    """Write normal, points and separations of two shapes to a row of `touch`.

    Return the names of the points, 0 for one that is not within the margin.
    """
    if kind_a == HALF_PLANE:
        if kind_b == HALF_PLANE:
            return 0, 0
        return touch_plane(row, first_a, first_b, count_b, x, y, radius_b, margin, False, vertices)
    if kind_b == HALF_PLANE:
        return touch_plane(row, first_b, first_a, count_a, -x, -y, radius_a, margin, True, vertices)
    if count_a > 1:
        if count_b > 1:
            return touch_polygons(
                row, first_a, count_a, first_b, count_b, x, y, radius_a, radius_b, margin, vertices
            )
        name = touch_disc(
            row, first_a, count_a, first_b, x, y, radius_a, radius_b, margin, False, vertices
        )
    elif count_b > 1:
        name = touch_disc(
            row, first_b, count_b, first_a, -x, -y, radius_b, radius_a, margin, True, vertices
        )
    else:
        name = touch_discs(row, first_a, first_b, x, y, radius_a, radius_b, margin, vertices)
    return name, 0


def match_impulses(row: Array, ids: Integers, first: int, second: int) -> int:
    """Move impulses to where their points are now, set those of new points to 0, count points."""
    before, other = ids[FEATURE], ids[FEATURE + 1]
    if first != before or second != other:
        push, rub = row[NORMAL_IMPULSE], row[TANGENT_IMPULSE]
        push_other, rub_other = row[NORMAL_IMPULSE + POINT], row[TANGENT_IMPULSE + POINT]
        preload, preload_other = row[PRELOAD], row[PRELOAD + POINT]
        for k in range(2):
            name = second if k else first
            at = POINT * k
            is_first = name > 0 and name == before
            is_second = name > 0 and name == other
            row[NORMAL_IMPULSE + at] = push if is_first else push_other if is_second else 0.0
            row[TANGENT_IMPULSE + at] = rub if is_first else rub_other if is_second else 0.0
            row[PRELOAD + at] = preload if is_first else preload_other if is_second else 0.0
        ids[FEATURE], ids[FEATURE + 1] = first, second
    count = (first > 0) + (second > 0)
    ids[POINT_COUNT] = count
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
    vertices: Array,
) -> int:
    """Write the point between two discs to a row of `touch`; return its name, or 0."""
    ax, ay = vertices[first_a, 0], vertices[first_a, 1]
    dx, dy = x + vertices[first_b, 0] - ax, y + vertices[first_b, 1] - ay
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
    vertices: Array,
) -> int:
    """Write the point between a shape with sides and a disc; return its name, or 0.

    The disc's body is at (x, y) from the other, m; `swapped` says that the disc is A.
    """
    centre_x, centre_y = vertices[first_q, 0], vertices[first_q, 1]
    x, y = x + centre_x, y + centre_y
    if not swapped:
        centre_x, centre_y = x, y
    reach = radius_p + radius_q + margin
    best = -1e308
    i = 0
    for k in range(count_p):
        p = first_p + k
        room = vertices[p, 2] * (x - vertices[p, 0]) + vertices[p, 3] * (y - vertices[p, 1])
        if room > best:
            best = room
            i = k
    if best >= reach:
        return 0
    p = first_p + i
    next_p = first_p + (i + 1 if i + 1 < count_p else 0)
    nx, ny = vertices[p, 2], vertices[p, 3]
    vx, vy = vertices[p, 0], vertices[p, 1]
    length = nx * (vertices[next_p, 1] - vy) - ny * (vertices[next_p, 0] - vx)
    along = nx * (y - vy) - ny * (x - vx)
    distance = best
    if best >= 0.0 and (along < 0.0 or along > length):
        at = first_p + (i if along < 0.0 else (i + 1 if i + 1 < count_p else 0))
        dx, dy = x - vertices[at, 0], y - vertices[at, 1]
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
    vertices: Array,
) -> tuple[int, int]:
    """Write the points between a half-plane and a shape; return their names, or 0.

    The shape's body is at (x, y) from the half-plane's, m; `swapped` says that the shape is A. The
    points are its lowest corner and the other end of the side that looks more at the half-plane:
    of a thin card the next lower corner may be at the same end.
    """
    nx, ny = vertices[plane, 2], vertices[plane, 3]
    base = nx * x + ny * y - vertices[plane, 0] - radius
    low = 1e308
    at = 0
    for k in range(count_q):
        height = nx * vertices[first_q + k, 0] + ny * vertices[first_q + k, 1]
        if height < low:
            low = height
            at = k
    if base + low >= margin:
        return 0, 0
    row[NX], row[NY] = (-nx, -ny) if swapped else (nx, ny)
    if swapped:
        x, y = 0.0, 0.0
    touch_corner(row, 0, first_q + at, nx, ny, x, y, base + low, radius, vertices)
    first = 1 + (at * NAMES if swapped else at)
    if count_q == 1:
        return first, 0
    beside = facing_side(first_q, count_q, at, nx, ny, vertices)
    if beside == at:
        beside = at + 1 if at + 1 < count_q else 0
    low = nx * vertices[first_q + beside, 0] + ny * vertices[first_q + beside, 1]
    if base + low >= margin:
        return first, 0
    touch_corner(row, POINT, first_q + beside, nx, ny, x, y, base + low, radius, vertices)
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
    vertices: Array,
) -> None:
    """Write the point under a corner of a shape at (x, y) from A, over a plane with normal n."""
    down = radius + 0.5 * gap
    row[PX + at] = x + vertices[corner, 0] - nx * down
    row[PY + at] = y + vertices[corner, 1] - ny * down
    row[GAP + at] = gap
