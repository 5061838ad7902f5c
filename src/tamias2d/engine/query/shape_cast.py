"""Shape casting: the first shape that another one meets, which is moved and is no body.

The gap is convex along a straight way, so that Newton's method finds its root from below. Sensors
are not solid, and nothing meets them. Cost: log n and the shapes along the way until the first.
"""

from math import sqrt
from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.bvh import BUNCH, first_leaf_node
from tamias2d.engine.narrow_phase.chain import is_normal, seen_from
from tamias2d.engine.narrow_phase.clip import PARALLEL
from tamias2d.engine.narrow_phase.core import core_of
from tamias2d.engine.query.gap import Gap, extent_across, gap_between, touching_point
from tamias2d.engine.query.overlap import SLACK, is_selected, next_node, side_of_half_plane
from tamias2d.engine.query.overlap_shape import place_corners
from tamias2d.engine.query.ray_cast import NO_HIT, Ray, crosses, next_crossed
from tamias2d.engine.rotation import cosine_sine
from tamias2d.engine.tables import BodyState, Integers, Shapes, World
from tamias2d.kernels.arrays import Bytes, FloatRows, Ranks
from tamias2d.state import Array, Vector

MOST_STEPS = 200  # of Newton's method: along a disc that is just touched each halves the gap
SLIDING = 1e-9  # of the way: what goes no deeper than that slides along


class Cast(NamedTuple):
    """A core (c, 2) that is moved, with a radius around it, and the shapes that it may meet."""

    core: Array
    radius: float  # m
    mask: int
    ignored: Integers  # (n,), 1 for bodies that are not met


def cast_core(
    world: World,
    ways: FloatRows,
    core: FloatRows,
    radius: float,
    mask: int,
    ignored: Bytes,
    room: FloatRows,
    met: Ranks,
    hits: FloatRows,
) -> None:
    """Find the first shape that all within a radius of a convex core meets on each way (k, 4), m.

    A way is the core's first place and its last. Written are the shape into `met` (k,), -1 for
    none, and into `hits` (k, 5) the fraction of the way, the outward normal and the point, m. Of
    shapes that are met at once it is the first in canonical order. `room` (v, 2) holds as many
    corners as a shape has.
    """
    low_x = high_x = core[0, 0]
    low_y = high_y = core[0, 1]
    for n in range(1, len(core)):
        low_x, high_x = min(low_x, core[n, 0]), max(high_x, core[n, 0])
        low_y, high_y = min(low_y, core[n, 1]), max(high_y, core[n, 1])
    cast = Cast(core, radius, mask, ignored)
    for k in range(len(ways)):
        x, y = ways[k, 0], ways[k, 1]
        ray = Ray(
            x + 0.5 * (low_x + high_x),
            y + 0.5 * (low_y + high_y),
            ways[k, 2] - x,
            ways[k, 3] - y,
            0.5 * (high_x - low_x) + radius,
            0.5 * (high_y - low_y) + radius,
        )
        met[k] = -1
        hits[k, 0] = NO_HIT
        for n in range(1, 5):
            hits[k, n] = 0.0
        cast_along(k, (x, y), ray, cast, world, room, met, hits)


def cast_along(
    k: int,
    start: Vector,
    ray: Ray,
    cast: Cast,
    world: World,
    room: Array,
    met: Integers,
    hits: Array,
) -> None:
    """Cast a core at half-planes, and along the tree as far as it has met nothing on the k-th way.

    The ray moves the box around it.
    """
    tree, shapes = world.tree, world.shapes
    leaves = tree.counts[tb.LEAVES]
    deep = first_leaf_node(leaves)
    begin, end = leaves, leaves + tree.counts[tb.PLANES]  # half-planes stand behind the leaves
    at = 1 if leaves > 0 else 0
    more = True
    while more:
        for m in range(begin, end):
            s = tree.morton[tb.LEAF, m]
            plane = shapes.kind[s] == tb.HALF_PLANE  # which has no box
            near = plane or crosses(tree.boxes[s, tb.FAT :], ray, min(hits[k, 0], 1.0))
            if near and is_selected(s, cast.mask, shapes.filters):
                meet(k, s, start, (ray.dx, ray.dy), cast, world, room, met, hits)
        at = next_crossed(at, deep, ray, min(hits[k, 0], 1.0), tree.nodes)
        more = at > 0
        begin = (at - deep) * BUNCH
        end = min(begin + BUNCH, leaves)
        at = next_node(at)


def meet(
    k: int,
    s: int,
    start: Vector,
    way: Vector,
    cast: Cast,
    world: World,
    room: Array,
    met: Integers,
    hits: Array,
) -> None:
    """Keep where a core that is moved from a start by a way meets a shape, if that is the first."""
    state, shapes, broad_phase = world.state, world.shapes, world.broad_phase
    rank = broad_phase.canonical[tb.RANK]
    if cast.ignored[state.body_of_shape[s]] != 0:
        return
    if shapes.kind[s] == tb.HALF_PLANE:
        fraction, gap, point = meet_half_plane(s, start, way, cast, state, shapes)
    else:
        fraction, gap, point = meet_bounded(s, start, way, cast, state, shapes, room)
    tied = fraction == hits[k, 0] and met[k] >= 0
    if fraction <= 1.0 and (fraction < hits[k, 0] or (tied and rank[s] < rank[met[k]])):
        met[k] = s
        hits[k, 0], hits[k, 1], hits[k, 2] = fraction, gap.nx, gap.ny
        hits[k, 3], hits[k, 4] = start[0] + point[0], start[1] + point[1]


def meet_half_plane(
    s: int, start: Vector, way: Vector, cast: Cast, state: BodyState, shapes: Shapes
) -> tuple[float, Gap, Vector]:
    """Return the fraction of its way at which a core meets a half-plane, the gap there, the point.

    The point is from the start.
    """
    offset, nx, ny = side_of_half_plane(s, state, shapes)
    low, high, most = extent_across(cast.core, -nx, -ny)
    level = offset - nx * start[0] - ny * start[1]
    gap = Gap(-level - most - cast.radius, nx, ny)
    fraction = fraction_left(gap, way, SLACK * (abs(level) + abs(most) + cast.radius))
    across = fraction * (nx * way[1] - ny * way[0]) - 0.5 * (low + high)
    return fraction, gap, (level * nx - across * ny, level * ny + across * nx)


def meet_bounded(
    s: int,
    start: Vector,
    way: Vector,
    cast: Cast,
    state: BodyState,
    shapes: Shapes,
    room: Array,
) -> tuple[float, Gap, Vector]:
    """Return the same for a shape with corners."""
    place_corners(s, start[0], start[1], state, shapes, room)
    corners, radius = room[: shapes.vertex_count[s]], shapes.radius[s]
    both = radius + cast.radius
    touching = SLACK * (both + farthest(corners) + farthest(cast.core))
    now, by, gap = 0.0, (0.0, 0.0), Gap(0.0, 0.0, 0.0)
    for _ in range(MOST_STEPS):
        found = gap_between(cast.core, by, corners, touching)
        gap = Gap(found.size - both, found.nx, found.ny)
        left = fraction_left(gap, way, touching)
        if now + left > 1.0:
            return NO_HIT, gap, by
        if now + left == now:
            break
        now += left
        by = (now * way[0], now * way[1])
    if shapes.kind[s] == tb.ONE_SIDED_PIECE and not is_solid(s, gap, touching, state, shapes):
        return NO_HIT, gap, by
    return now, gap, touching_point(cast.core, by, corners, radius, gap)


def is_solid(s: int, gap: Gap, touching: float, state: BodyState, shapes: Shapes) -> bool:
    """Return whether a one-sided piece of a chain is solid for what it has a gap to.

    It is from its right side, at corners that stick out there and at ends; where it is overlapped,
    if the way out leads to its right side.
    """
    c, d = cosine_sine(state.pose[state.body_of_shape[s], tb.ANGLE])
    ux, uy = c * gap.nx + d * gap.ny, c * gap.ny - d * gap.nx
    core, vertices = core_of(s, shapes), shapes.local_vertices
    side = seen_from(0, s, core, vertices, shapes)
    along, up = side.nx * uy - side.ny * ux, side.nx * ux + side.ny * uy
    straight = gap.size < -touching or abs(along) <= PARALLEL * up
    return bool((up > 0.0 and straight) or is_normal(ux, uy, side, False))


def fraction_left(gap: Gap, way: Vector, touching: float) -> float:
    """Return the fraction of a way, m, that closes a gap if its normal stays, or `NO_HIT`.

    What is nearer than what counts as touching, m, is met where the way leads into it.
    """
    closing = -(gap.nx * way[0] + gap.ny * way[1])
    touches = gap.size <= touching
    least = SLIDING * sqrt(way[0] * way[0] + way[1] * way[1]) if touches else 0.0
    if not closing > least:
        return NO_HIT
    return 0.0 if touches else gap.size / closing


def farthest(corners: Array) -> float:
    """Return a length, m, that no corner is farther away than."""
    most = 0.0
    for k in range(len(corners)):
        most = max(most, abs(corners[k, 0]) + abs(corners[k, 1]))
    return most
