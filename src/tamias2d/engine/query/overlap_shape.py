"""Region queries by a shape: which shapes overlap another one that is no body.

Cost: that of the box around it, then the sides of both for each shape that overlaps the box.
"""

from math import sqrt

from tamias2d.engine import tables as tb
from tamias2d.engine.query.overlap import shapes_in_box, side_of_half_plane
from tamias2d.engine.rotation import cosine_sine
from tamias2d.engine.tables import BodyState, Shapes, World
from tamias2d.kernels.arrays import FloatRows, Places
from tamias2d.state import Array, Vector


def shapes_in_shape(
    world: World,
    core: FloatRows,
    radius: float,
    mask: int,
    room: FloatRows,
    found: Places,
) -> int:
    """Write the shapes that overlap all within a radius of a convex core, m; return how many.

    The core has corners (c, 2), counter-clockwise where there are three; touching counts. `room`
    (v, 2) holds as many corners as a shape has.
    """
    low_x = high_x = core[0, 0]
    low_y = high_y = core[0, 1]
    for k in range(1, len(core)):
        low_x, high_x = min(low_x, core[k, 0]), max(high_x, core[k, 0])
        low_y, high_y = min(low_y, core[k, 1]), max(high_y, core[k, 1])
    low_x, low_y, high_x, high_y = low_x - radius, low_y - radius, high_x + radius, high_y + radius
    total = shapes_in_box(world, low_x, low_y, high_x, high_y, mask, found)
    kept = 0
    for k in range(total):
        if overlaps_core(found[k], core, radius, world.state, world.shapes, room):
            found[kept] = found[k]
            kept += 1
    return kept


def overlaps_core(
    s: int, core: Array, radius: float, state: BodyState, shapes: Shapes, room: Array
) -> bool:
    """Return whether a shape comes as near as a radius to a convex core."""
    if shapes.kind[s] == tb.HALF_PLANE:
        offset, nx, ny = side_of_half_plane(s, state, shapes)
        nearest = core[0, 0] * nx + core[0, 1] * ny
        for k in range(1, len(core)):
            nearest = min(nearest, core[k, 0] * nx + core[k, 1] * ny)
        return bool(nearest - offset <= radius)
    place_corners(s, 0.0, 0.0, state, shapes, room)
    return cores_within(core, room[: shapes.vertex_count[s]], radius + shapes.radius[s])


def place_corners(
    s: int, x: float, y: float, state: BodyState, shapes: Shapes, room: Array
) -> None:
    """Write where the corners of a shape are from a place, m."""
    pose = state.pose[state.body_of_shape[s]]
    c, d = cosine_sine(pose[tb.ANGLE])
    from_x, from_y = pose[tb.X] - x, pose[tb.Y] - y
    for k in range(shapes.vertex_count[s]):
        corner = shapes.local_vertices[shapes.first[s] + k]
        room[k, 0] = from_x + (c * corner[0] - d * corner[1])
        room[k, 1] = from_y + (d * corner[0] + c * corner[1])


def cores_within(a: Array, b: Array, distance: float) -> bool:
    """Return whether two convex cores are no farther from each other than a distance, m."""
    if holds_point(a, b[0, 0], b[0, 1]) or holds_point(b, a[0, 0], a[0, 1]):
        return True
    for k in range(len(a)):
        x, y = a[k, 0], a[k, 1]
        end = (k + 1) % len(a)
        by = (a[end, 0] - x, a[end, 1] - y)
        for m in range(len(b)):
            end = (m + 1) % len(b)
            to = (b[m, 0] - x, b[m, 1] - y)
            if lines_within(by, to, (b[end, 0] - x, b[end, 1] - y), distance):
                return True
    return False


def holds_point(core: Array, x: float, y: float) -> bool:
    """Return whether a core of three corners or more holds a point."""
    inside = len(core) > 2
    for k in range(len(core)):
        end = (k + 1) % len(core)
        by_x, by_y = core[end, 0] - core[k, 0], core[end, 1] - core[k, 1]
        inside = inside and by_x * (y - core[k, 1]) - by_y * (x - core[k, 0]) >= 0.0
    return bool(inside)


def lines_within(by: Vector, start: Vector, end: Vector, distance: float) -> bool:
    """Return whether two lines are no farther from each other than a distance, m.

    One goes from the origin by (x, y), the other from a start to an end; either may be a point.
    """
    one, other = (0.0, 0.0), (end[0] - start[0], end[1] - start[1])
    if distance_to_line(start, one, by) <= distance or distance_to_line(end, one, by) <= distance:
        return True
    if distance_to_line(one, start, other) <= distance:
        return True
    if distance_to_line(by, start, other) <= distance:
        return True
    left = (by[0] * start[1] - by[1] * start[0], by[0] * end[1] - by[1] * end[0])
    before = other[0] * -start[1] - other[1] * -start[0]
    after = other[0] * (by[1] - start[1]) - other[1] * (by[0] - start[0])
    return left[0] * left[1] < 0.0 and before * after < 0.0


def distance_to_line(point: Vector, start: Vector, by: Vector) -> float:
    """Return how far a point is from a line that goes from a start by (x, y)."""
    x, y = from_line(point, start, by)
    return sqrt(x * x + y * y)


def from_line(point: Vector, start: Vector, by: Vector) -> Vector:
    """Return the way to a point from the nearest one of a line, from a start by (x, y)."""
    x, y = point[0] - start[0], point[1] - start[1]
    size = by[0] * by[0] + by[1] * by[1]
    share = (x * by[0] + y * by[1]) / size if size > 0.0 else 0.0
    share = min(max(share, 0.0), 1.0)
    return x - share * by[0], y - share * by[1]
