"""Ray casting: what a ray meets first, asked of the places as they are now.

Serves: the simulator. Hides: how a ray enters a shape of each kind, and that it looks along the
tree only as far as nothing has been met. Sensors are not solid, and no ray meets them.
"""

from math import sqrt

from tamias2d.engine.broad_phase.bvh import BUNCH, first_leaf_node
from tamias2d.engine.motion.rotation import cosine_sine
from tamias2d.engine.query.overlap import SLACK, is_asked, next_node, shapes_in_box
from tamias2d.engine.tables import (
    ANGLE,
    DISC,
    FAT,
    HALF_PLANE,
    LEAF,
    LEAVES,
    PLANES,
    POLYGON,
    BodyState,
    Integers,
    Shapes,
    World,
    X,
    Y,
)
from tamias2d.kernels.arrays import (
    FloatRows,
    Places,
    Ranks,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

NONE = 2.0  # the fraction of a ray that meets nothing
Way = tuple[float, float, float, float]  # of a ray: where it starts, x and y, and how far it goes
Entry = tuple[float, float, float]  # where it enters, as a fraction of it, and the normal there


def cast_rays(
    world: World,
    rays: FloatRows,
    mask: int,
    met: Ranks,
    hits: FloatRows,
    found: Places,
) -> None:
    """Find the first shape that each ray (k, 4), from a point to a point, enters.

    The bodies at its start are none of them. Written are the number of the shape into `met` (k,),
    -1 for none, and the fraction of the ray and the outward normal into `hits` (k, 3). Of shapes
    that it enters at once it is the first in canonical order. `found` (m,) is room to work in.
    """
    for k in range(len(rays)):
        x, y = rays[k, 0], rays[k, 1]
        way = (x, y, rays[k, 2] - x, rays[k, 3] - y)
        met[k] = -1
        hits[k, 0], hits[k, 1], hits[k, 2] = NONE, 0.0, 0.0
        held = shapes_in_box(world, x, y, x, y, mask, found)
        cast_ray(k, way, mask, world, met, hits, held, found)


@inlined
def cast_ray(
    k: int,
    way: Way,
    mask: int,
    world: World,
    met: Integers,
    hits: Array,
    held: int,
    found: Integers,
) -> None:
    """Let a ray meet the half-planes, and along the tree what it may reach before its hit."""
    tree = world.tree
    leaves = tree.counts[LEAVES]
    deep = first_leaf_node(leaves)
    begin, end = leaves, leaves + tree.counts[PLANES]  # half-planes stand behind the leaves
    at = 1 if leaves > 0 else 0
    more = True
    while more:
        cast_among(k, begin, end, way, mask, world, met, hits, held, found)
        at = next_crossed(at, deep, way, min(hits[k, 0], 1.0), tree.nodes)
        more = at > 0
        begin = (at - deep) * BUNCH
        end = min(begin + BUNCH, leaves)
        at = next_node(at)


def next_crossed(at: int, deep: int, way: Way, most: float, nodes: Array) -> int:
    """Return the next node above shapes that a ray may cross, from a node on, or 0."""
    while at > 0:
        while at < deep and crosses(nodes[at], way, most):
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
    way: Way,
    mask: int,
    world: World,
    met: Integers,
    hits: Array,
    held: int,
    found: Integers,
) -> None:
    """Let a ray meet some shapes that follow each other along the curve, or half-planes."""
    state, shapes, tree = world.state, world.shapes, world.tree
    for m in range(begin, end):
        s = tree.morton[LEAF, m]
        plane = shapes.kind[s] == HALF_PLANE  # without a box
        near = plane or crosses(tree.boxes[s, FAT:], way, min(hits[k, 0], 1.0))
        if (
            near
            and is_asked(s, mask, shapes.filters)
            and not starts_in(s, state.body_of_shape, held, found)
        ):
            fraction, normal_x, normal_y = enter(s, way, state, shapes)
            keep_first(k, s, fraction, normal_x, normal_y, world.broad_phase.canonical, met, hits)


def crosses(boxes: Array, way: Way, most: float) -> bool:
    """Return whether a ray, up to a fraction of it, may cross a box: never no where it does."""
    x, y, by_x, by_y = way
    end_x, end_y = x + most * by_x, y + most * by_y
    if max(x, end_x) < boxes[0] or min(x, end_x) > boxes[2]:
        return False
    if max(y, end_y) < boxes[1] or min(y, end_y) > boxes[3]:
        return False
    half_x, half_y = 0.5 * boxes[2] - 0.5 * boxes[0], 0.5 * boxes[3] - 0.5 * boxes[1]
    to_x, to_y = 0.5 * boxes[0] + 0.5 * boxes[2] - x, 0.5 * boxes[1] + 0.5 * boxes[3] - y
    aside = abs(by_y * to_x - by_x * to_y)
    room = abs(by_y) * (half_x + SLACK * abs(to_x)) + abs(by_x) * (half_y + SLACK * abs(to_y))
    return not aside > room


def starts_in(s: int, shape_body: Integers, held: int, found: Integers) -> bool:
    """Return whether a ray starts in or on the body of a shape."""
    inside = False
    for m in range(held):
        inside = inside or shape_body[found[m]] == shape_body[s]
    return inside


def keep_first(
    k: int,
    s: int,
    fraction: float,
    normal_x: float,
    normal_y: float,
    canonical: Integers,
    met: Integers,
    hits: Array,
) -> None:
    """Keep where a ray enters a shape if that is before all others, or at once and by rank."""
    if fraction > 1.0:
        return
    earlier = fraction == hits[k, 0] and met[k] >= 0 and canonical[1, s] < canonical[1, met[k]]
    if fraction < hits[k, 0] or earlier:
        met[k] = s
        hits[k, 0], hits[k, 1], hits[k, 2] = fraction, normal_x, normal_y


@inlined
def enter(s: int, way: Way, state: BodyState, shapes: Shapes) -> Entry:
    """Return where a ray enters a shape, as a fraction of it, and the normal there."""
    x, y, by_x, by_y = way
    first, i = shapes.first[s], state.body_of_shape[s]
    if shapes.kind[s] == HALF_PLANE:
        return ray_plane(x, y, by_x, by_y, shapes.local_vertices[first])
    c, d = cosine_sine(state.pose[i, ANGLE])
    from_x, from_y = x - state.pose[i, X], y - state.pose[i, Y]
    start_x, start_y = c * from_x + d * from_y, c * from_y - d * from_x
    along_x, along_y = c * by_x + d * by_y, c * by_y - d * by_x
    fraction, x_in, y_in = enter_bounded(
        (start_x, start_y, along_x, along_y),
        shapes.kind[s],
        first,
        shapes.count[s],
        shapes.radius[s],
        shapes.local_vertices,
    )
    return fraction, c * x_in - d * y_in, d * x_in + c * y_in


def enter_bounded(
    way: Way, kind: int, first: int, count: int, radius: float, local_vertices: Array
) -> Entry:
    """Return where a ray in the axes of a body enters one of its shapes, and the normal there."""
    x, y, by_x, by_y = way
    if kind == POLYGON:
        return ray_polygon(x, y, by_x, by_y, first, count, local_vertices)
    if kind == DISC:
        return ray_disc(
            x, y, by_x, by_y, local_vertices[first, 0], local_vertices[first, 1], radius
        )
    return ray_capsule(x, y, by_x, by_y, local_vertices[first], local_vertices[first + 1], radius)


def ray_plane(x: float, y: float, by_x: float, by_y: float, side: Array) -> Entry:
    """Return where a ray enters a half-plane, as a fraction of it, and the normal there."""
    height = x * side[2] + y * side[3] - side[0]
    down = -(by_x * side[2] + by_y * side[3])
    fraction = height / down if 0.0 <= height <= down and down > 0.0 else NONE
    return fraction, side[2], side[3]


def ray_disc(
    x: float, y: float, by_x: float, by_y: float, center_x: float, center_y: float, radius: float
) -> Entry:
    """Return where a ray enters a disc, as a fraction of it, and the normal there."""
    x, y = x - center_x, y - center_y
    size = sqrt(by_x * by_x + by_y * by_y)
    along_x, along_y = by_x / size, by_y / size
    until = -(x * along_x + y * along_y)  # to where it is nearest
    aside = x * along_y - y * along_x
    deep = (radius - aside) * (radius + aside)
    if deep < 0.0 or until < 0.0:
        return NONE, 0.0, 0.0
    path = until - sqrt(deep)
    path = path if path > 0.0 else 0.0
    normal_x, normal_y = (x + path * along_x) / radius, (y + path * along_y) / radius
    return (path / size if path <= size else NONE), normal_x, normal_y


def ray_polygon(
    x: float, y: float, by_x: float, by_y: float, first: int, count: int, local_vertices: Array
) -> Entry:
    """Return where a ray enters a convex polygon, as a fraction of it, and the normal there."""
    enters, leaves = -1.0, NONE
    normal_x = normal_y = 0.0
    for k in range(first, first + count):
        height = (x - local_vertices[k, 0]) * local_vertices[k, 2] + (
            y - local_vertices[k, 1]
        ) * local_vertices[k, 3]
        down = -(by_x * local_vertices[k, 2] + by_y * local_vertices[k, 3])
        if down > 0.0:  # towards this side
            at = height / down
            if at > enters:
                enters = at
                normal_x, normal_y = local_vertices[k, 2], local_vertices[k, 3]
        elif down < 0.0:
            leaves = min(leaves, height / down)
        elif height > 0.0:
            return NONE, 0.0, 0.0
    if enters < 0.0 or enters > leaves:
        return NONE, 0.0, 0.0
    return enters, normal_x, normal_y


def ray_capsule(
    x: float, y: float, by_x: float, by_y: float, one: Array, other: Array, radius: float
) -> Entry:
    """Return where a ray enters a capsule, as a fraction of it, and the normal there.

    Without a radius it is a line, which is met from both sides.
    """
    side_x, side_y = one[2], one[3]
    height = (x - one[0]) * side_x + (y - one[1]) * side_y
    if height < 0.0:  # look at it from the side of the start
        height, side_x, side_y = -height, -side_x, -side_y
    down = -(by_x * side_x + by_y * side_y)
    best, normal_x, normal_y = NONE, 0.0, 0.0
    if down > 0.0 and height >= radius and height - radius <= down:
        at = (height - radius) / down
        on_x, on_y = x + at * by_x - one[0], y + at * by_y - one[1]
        line_x, line_y = other[0] - one[0], other[1] - one[1]
        along = on_x * line_x + on_y * line_y
        if 0.0 <= along <= line_x * line_x + line_y * line_y:
            best, normal_x, normal_y = at, side_x, side_y
    if radius > 0.0:
        at, end_x, end_y = ray_disc(x, y, by_x, by_y, one[0], one[1], radius)
        if at < best:
            best, normal_x, normal_y = at, end_x, end_y
        at, end_x, end_y = ray_disc(x, y, by_x, by_y, other[0], other[1], radius)
        if at < best:
            best, normal_x, normal_y = at, end_x, end_y
    return best, normal_x, normal_y
