"""Where a shape may be while its body is within its fat bounds: its box, its circle, its sides."""

from math import sqrt

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.bvh import FAR
from tamias2d.engine.tables import Bodies, BroadPhase, Shapes, Tree
from tamias2d.state import Array

SPECULATIVE_MARGIN = 0.12  # of the bounding radius: how far around a shape others are known
LONGER = 3.0  # than another shape: how long one is whose sides are tested, and not only its circle
MOST_DISPLACED = 2.0  # distances from the centre: a vertex that turns is displaced by no more


def fatten_box(s: int, bodies: Bodies, shapes: Shapes, tree: Tree, broad_phase: BroadPhase) -> None:
    """Write the fat box of a shape: where it may be, and the speculative margin around that."""
    i = shapes.slot[s]
    if shapes.kind[s] == tb.HALF_PLANE or bodies.kind[i] == tb.ABSENT:
        return
    vertices, bounds, box = shapes.world_vertices, broad_phase.fat_bounds[i], tree.boxes[s]
    low_x, low_y, high_x, high_y = FAR, FAR, -FAR, -FAR
    farthest = 0.0
    for k in range(shapes.first[s], shapes.first[s] + shapes.vertex_count[s]):
        x, y = vertices[k, 0], vertices[k, 1]
        low_x, high_x = min(low_x, x), max(high_x, x)
        low_y, high_y = min(low_y, y), max(high_y, y)
        farthest = max(farthest, x * x + y * y)
    margin = shapes.radius[s]
    if bodies.kind[i] == tb.DYNAMIC:
        margin += SPECULATIVE_MARGIN * bodies.properties[i, tb.BOUNDING_RADIUS]
    if farthest > 0.0:
        margin += min(bounds[tb.ANGLE_MARGIN], MOST_DISPLACED) * sqrt(farthest)
    box[tb.FAT], box[tb.FAT + 2] = (
        bounds[tb.LOW_X] + low_x - margin,
        bounds[tb.HIGH_X] + high_x + margin,
    )
    box[tb.FAT + 1], box[tb.FAT + 3] = (
        bounds[tb.LOW_Y] + low_y - margin,
        bounds[tb.HIGH_Y] + high_y + margin,
    )


def note_centre(
    k: int, s: int, bodies: Bodies, shapes: Shapes, tree: Tree, broad_phase: BroadPhase
) -> None:
    """Write where the body of the shape of leaf k may be, with the speculative margin."""
    i, centre = shapes.slot[s], tree.centres[k]
    bounds, dynamic = broad_phase.fat_bounds[i], bodies.kind[i] == tb.DYNAMIC
    margin = SPECULATIVE_MARGIN * bodies.properties[i, tb.BOUNDING_RADIUS] if dynamic else 0.0
    centre[tb.CENTRE_X] = 0.5 * (bounds[tb.LOW_X] + bounds[tb.HIGH_X])
    centre[tb.CENTRE_Y] = 0.5 * (bounds[tb.LOW_Y] + bounds[tb.HIGH_Y])
    centre[tb.HALF_WIDTH] = 0.5 * (bounds[tb.HIGH_X] - bounds[tb.LOW_X]) + margin
    centre[tb.HALF_HEIGHT] = 0.5 * (bounds[tb.HIGH_Y] - bounds[tb.LOW_Y]) + margin
    centre[tb.CENTRE_RADIUS] = shapes.material[s, tb.SHAPE_RADIUS]


def circles_apart(one: Array, other: Array) -> bool:
    """Return whether the bounding circles of two leaves stay apart."""
    x = abs(other[tb.CENTRE_X] - one[tb.CENTRE_X]) - (one[tb.HALF_WIDTH] + other[tb.HALF_WIDTH])
    y = abs(other[tb.CENTRE_Y] - one[tb.CENTRE_Y]) - (one[tb.HALF_HEIGHT] + other[tb.HALF_HEIGHT])
    reach = one[tb.CENTRE_RADIUS] + other[tb.CENTRE_RADIUS]
    x, y = max(x, 0.0), max(y, 0.0)
    return bool(x * x + y * y > reach * reach)


def sides_apart(
    k: int, m: int, bodies: Bodies, shapes: Shapes, tree: Tree, broad_phase: BroadPhase
) -> bool:
    """Return whether a side of the longer of two leaves always separates the other from it."""
    if tree.centres[k, tb.CENTRE_RADIUS] < tree.centres[m, tb.CENTRE_RADIUS]:
        k, m = m, k
    one, other = tree.centres[k], tree.centres[m]
    s = tree.morton[tb.LEAF, k]
    if one[tb.CENTRE_RADIUS] < LONGER * other[tb.CENTRE_RADIUS] or shapes.vertex_count[s] == 1:
        return False
    i, vertices = shapes.slot[s], shapes.world_vertices
    x, y = other[tb.CENTRE_X] - one[tb.CENTRE_X], other[tb.CENTRE_Y] - one[tb.CENTRE_Y]
    width = one[tb.HALF_WIDTH] + other[tb.HALF_WIDTH]
    height = one[tb.HALF_HEIGHT] + other[tb.HALF_HEIGHT]
    turn = largest_turn(bodies.pose[i], bodies.motion[i], broad_phase.fat_bounds[i])
    reach = other[tb.CENTRE_RADIUS] + shapes.radius[s] + turn * (abs(x) + abs(y) + width + height)
    for c in range(shapes.first[s], shapes.first[s] + shapes.vertex_count[s]):
        normal_x, normal_y = vertices[c, 2], vertices[c, 3]
        distance = normal_x * (x - vertices[c, 0]) + normal_y * (y - vertices[c, 1])
        if distance - abs(normal_x) * width - abs(normal_y) * height > reach:
            return True
    return False


def largest_turn(pose: Array, motion: Array, bounds: Array) -> float:
    """Return how far a body may be turned from where its vertices are, rad."""
    turned = abs(pose[tb.ANGLE] - bounds[tb.BASE_ANGLE])
    turn: float = bounds[tb.ANGLE_MARGIN] + turned + abs(motion[tb.DANGLE])
    return turn


def half_plane_offset(s: int, shapes: Shapes, broad_phase: BroadPhase) -> float:
    """Return how far a half-plane may reach along its normal, m from the origin."""
    bounds, side = broad_phase.fat_bounds[shapes.slot[s]], shapes.world_vertices[shapes.first[s]]
    x = bounds[tb.HIGH_X] if side[2] > 0.0 else bounds[tb.LOW_X]
    y = bounds[tb.HIGH_Y] if side[3] > 0.0 else bounds[tb.LOW_Y]
    offset: float = side[0] + side[2] * x + side[3] * y
    return offset


def reaches_half_plane(t: int, offset: float, side: Array, boxes: Array) -> bool:
    """Return whether the fat box of a shape reaches into a half-plane."""
    x = boxes[t, tb.FAT] if side[2] > 0.0 else boxes[t, tb.FAT + 2]
    y = boxes[t, tb.FAT + 1] if side[3] > 0.0 else boxes[t, tb.FAT + 3]
    return bool(side[2] * x + side[3] * y <= offset)
