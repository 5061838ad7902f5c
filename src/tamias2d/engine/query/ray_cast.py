"""Ray casting: the first shape that a ray enters, with bodies where they are now.

Sensors are not solid, and no ray meets them. Cost: log n and the shapes along the ray until the
first that it enters.
"""

from math import sqrt
from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.bvh import BUNCH, first_leaf_node
from tamias2d.engine.query.overlap import (
    SLACK,
    is_selected,
    next_node,
    shapes_in_box,
    side_of_half_plane,
)
from tamias2d.engine.rotation import cosine_sine
from tamias2d.engine.tables import BodyState, Integers, Shapes, World
from tamias2d.kernels.arrays import FloatRows, Places, Ranks
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

NO_HIT = 2.0  # the fraction of a ray that meets nothing
ALONG = 1e-12  # sine of the angle to a line that a ray runs along, but for rounding
Entry = tuple[float, float, float]  # where a ray enters, as a fraction of it, and the normal there


class Ray(NamedTuple):
    """Where a ray starts, and its displacement to the end, m."""

    x: float
    y: float
    dx: float
    dy: float
    half_x: float  # of a box that is moved in place of a point, or 0
    half_y: float


def cast_rays(
    world: World,
    rays: FloatRows,
    mask: int,
    shape_hit: Ranks,
    entries: FloatRows,
    found: Places,
) -> None:
    """Find the first shape that each ray (k, 4), from a point to a point, enters.

    The bodies at its start do not count. Written are the shape into `shape_hit` (k,), -1 for none,
    and the fraction of the ray and the outward normal into `entries` (k, 3). Of shapes that a ray
    enters at once it is the first in canonical order. `found` (m,) is room to work in.
    """
    for k in range(len(rays)):
        x, y = rays[k, 0], rays[k, 1]
        ray = Ray(x, y, rays[k, 2] - x, rays[k, 3] - y, 0.0, 0.0)
        shape_hit[k] = -1
        entries[k, 0], entries[k, 1], entries[k, 2] = NO_HIT, 0.0, 0.0
        inside = shapes_in_box(world, x, y, x, y, mask, found)
        cast_ray(k, ray, mask, world, shape_hit, entries, inside, found)


@inlined
def cast_ray(
    k: int,
    ray: Ray,
    mask: int,
    world: World,
    shape_hit: Integers,
    entries: Array,
    inside: int,
    found: Integers,
) -> None:
    """Cast the k-th ray at the half-planes, and along the tree as far as it has met nothing.

    It starts inside of the first shapes of `found`.
    """
    tree = world.tree
    leaves = tree.counts[tb.LEAVES]
    deep = first_leaf_node(leaves)
    begin, end = leaves, leaves + tree.counts[tb.PLANES]  # half-planes stand behind the leaves
    at = 1 if leaves > 0 else 0
    more = True
    while more:
        cast_among(k, begin, end, ray, mask, world, shape_hit, entries, inside, found)
        at = next_crossed(at, deep, ray, min(entries[k, 0], 1.0), tree.nodes)
        more = at > 0
        begin = (at - deep) * BUNCH
        end = min(begin + BUNCH, leaves)
        at = next_node(at)


def next_crossed(at: int, deep: int, ray: Ray, most: float, nodes: Array) -> int:
    """Return the next node above shapes that a ray may cross, from a node on, or 0."""
    while at > 0:
        while at < deep and crosses(nodes[at], ray, most):
            at = 2 * at
        if at >= deep:
            return at
        at = next_node(at)
    return 0


@inlined
def cast_among(
    k: int,
    begin: int,
    end: int,
    ray: Ray,
    mask: int,
    world: World,
    shape_hit: Integers,
    entries: Array,
    inside: int,
    found: Integers,
) -> None:
    """Cast the k-th ray at some shapes that follow each other in Morton order, or half-planes."""
    state, shapes, tree = world.state, world.shapes, world.tree
    for m in range(begin, end):
        s = tree.morton[tb.LEAF, m]
        plane = shapes.kind[s] == tb.HALF_PLANE  # which has no box
        near = plane or crosses(tree.boxes[s, tb.FAT :], ray, min(entries[k, 0], 1.0))
        if (
            near
            and is_selected(s, mask, shapes.filters)
            and not starts_in(s, state.body_of_shape, inside, found)
        ):
            entry = enter(s, ray, state, shapes)
            keep_first(k, s, entry, world.broad_phase.canonical, shape_hit, entries)


def crosses(bounds: Array, ray: Ray, most: float) -> bool:
    """Return whether a ray, up to a fraction of it, may cross a box: never no where it does."""
    x, y, dx, dy = ray.x, ray.y, ray.dx, ray.dy
    to_x, to_y = 0.5 * bounds[0] + 0.5 * bounds[2] - x, 0.5 * bounds[1] + 0.5 * bounds[3] - y
    slack = SLACK * (abs(to_x) + abs(to_y))  # rounding in a body's axes displaces a ray from afar
    more_x, more_y = slack + ray.half_x, slack + ray.half_y
    end_x, end_y = x + most * dx, y + most * dy
    if max(x, end_x) < bounds[0] - more_x or min(x, end_x) > bounds[2] + more_x:
        return False
    if max(y, end_y) < bounds[1] - more_y or min(y, end_y) > bounds[3] + more_y:
        return False
    half_x, half_y = 0.5 * bounds[2] - 0.5 * bounds[0], 0.5 * bounds[3] - 0.5 * bounds[1]
    aside = abs(dy * to_x - dx * to_y)
    most_aside = abs(dy) * (half_x + more_x) + abs(dx) * (half_y + more_y)
    return not aside > most_aside


def starts_in(s: int, body_of_shape: Integers, inside: int, found: Integers) -> bool:
    """Return whether a ray starts in or on the body of a shape."""
    starts = False
    for m in range(inside):
        starts = starts or body_of_shape[found[m]] == body_of_shape[s]
    return starts


def keep_first(
    k: int, s: int, entry: Entry, canonical: Integers, shape_hit: Integers, entries: Array
) -> None:
    """Keep where a ray enters a shape if that is before all others, or at once and by rank."""
    fraction, normal_x, normal_y = entry
    if fraction > 1.0:
        return
    rank, tied = canonical[tb.RANK], fraction == entries[k, 0] and shape_hit[k] >= 0
    if fraction < entries[k, 0] or (tied and rank[s] < rank[shape_hit[k]]):
        shape_hit[k] = s
        entries[k, 0], entries[k, 1], entries[k, 2] = fraction, normal_x, normal_y


@inlined
def enter(s: int, ray: Ray, state: BodyState, shapes: Shapes) -> Entry:
    """Return where a ray enters a shape, as a fraction of it, and the normal there."""
    first, i = shapes.first[s], state.body_of_shape[s]
    if shapes.kind[s] == tb.HALF_PLANE:
        return enter_half_plane(ray, side_of_half_plane(s, state, shapes))
    c, d = cosine_sine(state.pose[i, tb.ANGLE])
    from_x, from_y = ray.x - state.pose[i, tb.X], ray.y - state.pose[i, tb.Y]
    local = Ray(
        c * from_x + d * from_y,
        c * from_y - d * from_x,
        c * ray.dx + d * ray.dy,
        c * ray.dy - d * ray.dx,
        0.0,
        0.0,
    )
    fraction, x, y = enter_bounded(
        local,
        shapes.kind[s],
        first,
        shapes.vertex_count[s],
        shapes.radius[s],
        shapes.local_vertices,
    )
    return fraction, c * x - d * y, d * x + c * y


def enter_bounded(
    ray: Ray, kind: int, first: int, count: int, radius: float, vertices: Array
) -> Entry:
    """Return where a ray in the axes of a body enters one of its shapes, and the normal there."""
    if count > 2:
        return enter_polygon(ray, first, count, vertices)
    if kind == tb.DISC:
        return enter_disc(ray, vertices[first, 0], vertices[first, 1], radius)
    if radius == 0.0:
        one_sided = kind == tb.ONE_SIDED_PIECE
        return enter_segment(ray, one_sided, vertices[first], vertices[first + 1])
    return enter_capsule(ray, vertices[first], vertices[first + 1], radius)


def enter_half_plane(ray: Ray, side: tuple[float, float, float]) -> Entry:
    """Return where a ray enters a half-plane, as a fraction of it, and the normal there."""
    offset, nx, ny = side
    height = ray.x * nx + ray.y * ny - offset
    down = -(ray.dx * nx + ray.dy * ny)
    fraction = height / down if 0.0 <= height <= down and down > 0.0 else NO_HIT
    return fraction, nx, ny


def enter_disc(ray: Ray, centre_x: float, centre_y: float, radius: float) -> Entry:
    """Return where a ray enters a disc, as a fraction of it, and the normal there."""
    x, y = ray.x - centre_x, ray.y - centre_y
    length = sqrt(ray.dx * ray.dx + ray.dy * ray.dy)
    along_x, along_y = ray.dx / length, ray.dy / length
    until = -(x * along_x + y * along_y)  # to where it is nearest
    aside = x * along_y - y * along_x
    deep = (radius - aside) * (radius + aside)
    if deep < 0.0 or until < 0.0:
        return NO_HIT, 0.0, 0.0
    path = until - sqrt(deep)
    path = path if path > 0.0 else 0.0
    normal_x, normal_y = (x + path * along_x) / radius, (y + path * along_y) / radius
    return (path / length if path <= length else NO_HIT), normal_x, normal_y


def enter_polygon(ray: Ray, first: int, count: int, vertices: Array) -> Entry:
    """Return where a ray enters a convex polygon, as a fraction of it, and the normal there."""
    enters, leaves = -1.0, NO_HIT
    normal_x = normal_y = 0.0
    for k in range(first, first + count):
        nx, ny = vertices[k, 2], vertices[k, 3]
        height = (ray.x - vertices[k, 0]) * nx + (ray.y - vertices[k, 1]) * ny
        down = -(ray.dx * nx + ray.dy * ny)
        if down > 0.0:  # towards this side
            fraction = height / down
            if fraction > enters:
                enters = fraction
                normal_x, normal_y = nx, ny
        elif down < 0.0:
            leaves = min(leaves, height / down)
        elif height > 0.0:
            return NO_HIT, 0.0, 0.0
    if enters < 0.0 or enters > leaves:
        return NO_HIT, 0.0, 0.0
    return enters, normal_x, normal_y


def enter_segment(ray: Ray, one_sided: bool, one: Array, other: Array) -> Entry:
    """Return where a ray meets a segment, and the normal there: against the ray if it runs along.

    One that is one-sided is met from its right side alone. Pieces of a chain share a vertex to the
    bit, and both ask the same on which side of the ray it is. So the ray meets one of them, or
    both: there is no gap between them.
    """
    nx, ny = one[2], one[3]
    height = (ray.x - one[0]) * nx + (ray.y - one[1]) * ny
    down = -(ray.dx * nx + ray.dy * ny)
    length = sqrt(ray.dx * ray.dx + ray.dy * ray.dy)
    at_one, at_other = fraction_beside(ray, one), fraction_beside(ray, other)
    first, last = min(at_one, at_other), max(at_one, at_other)
    parallel = abs(down) <= ALONG * length
    if one_sided and (down < 0.0 or parallel):
        return NO_HIT, 0.0, 0.0
    if parallel and abs(height) <= ALONG * length * max(1.0, abs(first), abs(last)):
        return (first if first >= 0.0 else NO_HIT), -ray.dx / length, -ray.dy / length
    aside_one, aside_other = aside_of_ray(ray, one), aside_of_ray(ray, other)
    if max(aside_one, aside_other) < 0.0 or min(aside_one, aside_other) > 0.0:
        return NO_HIT, 0.0, 0.0
    if down < 0.0:  # the side that is towards the start
        height, down, nx, ny = -height, -down, -nx, -ny
    # rounding may take a ray that is nearly parallel to the segment past its ends
    fraction = min(max(height / down, first), last) if down > 0.0 else first
    return (fraction if fraction >= 0.0 else NO_HIT), nx, ny


def aside_of_ray(ray: Ray, vertex: Array) -> float:
    """Return how far a vertex is to the right of a ray, times its length, m^2."""
    return float((vertex[0] - ray.x) * ray.dy - (vertex[1] - ray.y) * ray.dx)


def fraction_beside(ray: Ray, vertex: Array) -> float:
    """Return the fraction of a ray, or of the line that it is on, nearest to a vertex."""
    along = (vertex[0] - ray.x) * ray.dx + (vertex[1] - ray.y) * ray.dy
    return float(along / (ray.dx * ray.dx + ray.dy * ray.dy))


def enter_capsule(ray: Ray, one: Array, other: Array, radius: float) -> Entry:
    """Return where a ray enters a capsule, as a fraction of it, and the normal there."""
    best, normal_x, normal_y = enter_capsule_side(ray, one, other, radius)
    fraction, end_x, end_y = enter_disc(ray, one[0], one[1], radius)
    if fraction < best:
        best, normal_x, normal_y = fraction, end_x, end_y
    fraction, end_x, end_y = enter_disc(ray, other[0], other[1], radius)
    if fraction < best:
        best, normal_x, normal_y = fraction, end_x, end_y
    return best, normal_x, normal_y


def enter_capsule_side(ray: Ray, one: Array, other: Array, radius: float) -> Entry:
    """Return where a ray enters the straight part of a capsule, and the normal there."""
    nx, ny = one[2], one[3]
    height = (ray.x - one[0]) * nx + (ray.y - one[1]) * ny
    if height < 0.0:  # the side that is towards the start
        height, nx, ny = -height, -nx, -ny
    down = -(ray.dx * nx + ray.dy * ny)
    if not (down > 0.0 and height >= radius and height - radius <= down):
        return NO_HIT, 0.0, 0.0
    fraction = (height - radius) / down
    on_x, on_y = ray.x + fraction * ray.dx - one[0], ray.y + fraction * ray.dy - one[1]
    line_x, line_y = other[0] - one[0], other[1] - one[1]
    along = on_x * line_x + on_y * line_y
    if 0.0 <= along <= line_x * line_x + line_y * line_y:
        return fraction, nx, ny
    return NO_HIT, 0.0, 0.0
