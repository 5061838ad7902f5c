"""What a ray meets, and what lies at a point or in a box: asked of the places as they are now.

Serves: the simulator. Hides: the tree that it asks, which is not that of the step: users move
bodies between steps. Sensors are not solid, and no query finds them.

Cost: n log n for a tree where something moved, then log n and what is found for each question.
"""

from math import cos, sin, sqrt

from tamias2d.kernels.arrays import (
    Bytes,
    FloatRows,
    Floats,
    Indices,
    RankRows,
    Ranks,
)
from tamias2d.state import Array
from tamias2d.stepped.layout import (
    ABSENT,
    CATEGORY,
    DISC,
    FAT,
    HALF_PLANE,
    POLYGON,
    SENSOR,
    TURN,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.tree import BUNCH, grow_tree, lowest

NONE = 2.0  # the fraction of a ray that meets nothing
SLACK = 1e-12  # relative: how much larger boxes are than what is in them


def survey(
    kind: Bytes,
    pose: FloatRows,
    ranked: RankRows,
    shape_body: Indices,
    shape_kind: Indices,
    shape_first: Indices,
    shape_count: Indices,
    shape_radius: Floats,
    corner: FloatRows,
    box: FloatRows,
    curve: RankRows,
    node: FloatRows,
    sizes: Ranks,
) -> None:
    """Make the tree for all shapes where they are; half-planes stand behind its leaves.

    `sizes` (2,) are the numbers of both.
    """
    for s in range(len(shape_kind)):
        i = shape_body[s]
        if kind[i] != ABSENT and shape_kind[s] != HALF_PLANE:
            enclose_shape(s, pose[i], shape_first, shape_count, shape_radius, corner, box)
    leaves = grow_tree(shape_kind, shape_body, kind, ranked, box, curve, node)
    planes = 0
    for k in range(len(shape_kind)):
        s = ranked[0, k]
        if kind[shape_body[s]] != ABSENT and shape_kind[s] == HALF_PLANE:
            curve[0, leaves + planes] = s
            planes += 1
    sizes[0], sizes[1] = leaves, planes


def enclose_shape(
    s: int,
    place: Array,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    corner: Array,
    box: Array,
) -> None:
    """Put a box around a shape."""
    c, d = cos(place[TURN]), sin(place[TURN])
    first = shape_first[s]
    low_x = high_x = c * corner[first, 0] - d * corner[first, 1]
    low_y = high_y = d * corner[first, 0] + c * corner[first, 1]
    for k in range(first + 1, first + shape_count[s]):
        x, y = c * corner[k, 0] - d * corner[k, 1], d * corner[k, 0] + c * corner[k, 1]
        low_x, high_x = min(low_x, x), max(high_x, x)
        low_y, high_y = min(low_y, y), max(high_y, y)
    size = high_x - low_x + high_y - low_y + shape_radius[s]
    more = shape_radius[s] + SLACK * (size + abs(place[X]) + abs(place[Y]))
    box[s, FAT], box[s, FAT + 1] = place[X] + low_x - more, place[Y] + low_y - more
    box[s, FAT + 2], box[s, FAT + 3] = place[X] + high_x + more, place[Y] + high_y + more


def cast(
    rays: FloatRows,
    mask: int,
    pose: FloatRows,
    ranked: RankRows,
    shape_body: Indices,
    shape_kind: Indices,
    shape_first: Indices,
    shape_count: Indices,
    shape_radius: Floats,
    filters: RankRows,
    corner: FloatRows,
    box: FloatRows,
    curve: RankRows,
    node: FloatRows,
    sizes: Ranks,
    met: Ranks,
    hits: FloatRows,
    found: Ranks,
) -> None:
    """Find the first shape that each ray (k, 4), from a point to a point, enters.

    The bodies at its start are none of them. Written are the number of the shape into `met` (k,),
    -1 for none, and the fraction of the ray and the outward normal into `hits` (k, 3). Of shapes
    that it enters at once it is the first in canonical order. `found` (m,) is room to work in.
    """
    leaves = sizes[0]
    first = lowest(leaves)
    for k in range(len(rays)):
        x, y = rays[k, 0], rays[k, 1]
        by_x, by_y = rays[k, 2] - x, rays[k, 3] - y
        met[k] = -1
        hits[k, 0], hits[k, 1], hits[k, 2] = NONE, 0.0, 0.0
        held = gather(
            x,
            y,
            x,
            y,
            mask,
            pose,
            shape_body,
            shape_kind,
            shape_first,
            shape_count,
            shape_radius,
            filters,
            corner,
            box,
            curve,
            node,
            sizes,
            found,
        )
        for m in range(leaves, leaves + sizes[1]):
            cast_at(
                k,
                curve[0, m],
                x,
                y,
                by_x,
                by_y,
                mask,
                pose,
                ranked,
                shape_body,
                shape_kind,
                shape_first,
                shape_count,
                shape_radius,
                filters,
                corner,
                met,
                hits,
                held,
                found,
            )
        at = 1 if leaves > 0 else 0
        while at > 0:
            while at < first and crosses(node[at], x, y, by_x, by_y, min(hits[k, 0], 1.0)):
                at = 2 * at
            if at >= first:
                bunch = (at - first) * BUNCH
                for m in range(bunch, min(bunch + BUNCH, leaves)):
                    s = curve[0, m]
                    if crosses(box[s, FAT:], x, y, by_x, by_y, min(hits[k, 0], 1.0)):
                        cast_at(
                            k,
                            s,
                            x,
                            y,
                            by_x,
                            by_y,
                            mask,
                            pose,
                            ranked,
                            shape_body,
                            shape_kind,
                            shape_first,
                            shape_count,
                            shape_radius,
                            filters,
                            corner,
                            met,
                            hits,
                            held,
                            found,
                        )
            while at & 1:
                at >>= 1
            if at > 0:
                at += 1


def crosses(box: Array, x: float, y: float, by_x: float, by_y: float, most: float) -> bool:
    """Return whether a ray, up to a fraction of it, may cross a box: never no where it does."""
    end_x, end_y = x + most * by_x, y + most * by_y
    if max(x, end_x) < box[0] or min(x, end_x) > box[2]:
        return False
    if max(y, end_y) < box[1] or min(y, end_y) > box[3]:
        return False
    half_x, half_y = 0.5 * box[2] - 0.5 * box[0], 0.5 * box[3] - 0.5 * box[1]
    to_x, to_y = 0.5 * box[0] + 0.5 * box[2] - x, 0.5 * box[1] + 0.5 * box[3] - y
    aside = abs(by_y * to_x - by_x * to_y)
    room = abs(by_y) * (half_x + SLACK * abs(to_x)) + abs(by_x) * (half_y + SLACK * abs(to_y))
    return not aside > room


def cast_at(
    k: int,
    s: int,
    x: float,
    y: float,
    by_x: float,
    by_y: float,
    mask: int,
    pose: Array,
    ranked: Whole,
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    filters: Whole,
    corner: Array,
    met: Whole,
    hits: Array,
    held: int,
    found: Whole,
) -> None:
    """Let a ray meet a shape, and keep the hit if it is the first one."""
    if filters[s, SENSOR] != 0 or (filters[s, CATEGORY] & mask) == 0:
        return
    i = shape_body[s]
    for m in range(held):
        if shape_body[found[m]] == i:
            return
    first, count = shape_first[s], shape_count[s]
    if shape_kind[s] == HALF_PLANE:
        fraction, normal_x, normal_y = ray_plane(x, y, by_x, by_y, corner[first])
    else:
        c, d = cos(pose[i, TURN]), sin(pose[i, TURN])
        from_x, from_y = x - pose[i, X], y - pose[i, Y]
        start_x, start_y = c * from_x + d * from_y, c * from_y - d * from_x
        along_x, along_y = c * by_x + d * by_y, c * by_y - d * by_x
        if shape_kind[s] == POLYGON:
            fraction, x_in, y_in = ray_polygon(
                start_x, start_y, along_x, along_y, first, count, corner
            )
        elif shape_kind[s] == DISC:
            fraction, x_in, y_in = ray_disc(
                start_x,
                start_y,
                along_x,
                along_y,
                corner[first, 0],
                corner[first, 1],
                shape_radius[s],
            )
        else:
            fraction, x_in, y_in = ray_capsule(
                start_x,
                start_y,
                along_x,
                along_y,
                corner[first],
                corner[first + 1],
                shape_radius[s],
            )
        normal_x, normal_y = c * x_in - d * y_in, d * x_in + c * y_in
    if fraction > 1.0:
        return
    earlier = fraction == hits[k, 0] and met[k] >= 0 and ranked[1, s] < ranked[1, met[k]]
    if fraction < hits[k, 0] or earlier:
        met[k] = s
        hits[k, 0], hits[k, 1], hits[k, 2] = fraction, normal_x, normal_y


def ray_plane(
    x: float, y: float, by_x: float, by_y: float, side: Array
) -> tuple[float, float, float]:
    """Return where a ray enters a half-plane, as a fraction of it, and the normal there."""
    height = x * side[2] + y * side[3] - side[0]
    down = -(by_x * side[2] + by_y * side[3])
    fraction = height / down if 0.0 <= height <= down and down > 0.0 else NONE
    return fraction, side[2], side[3]


def ray_disc(
    x: float, y: float, by_x: float, by_y: float, center_x: float, center_y: float, radius: float
) -> tuple[float, float, float]:
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
    x: float, y: float, by_x: float, by_y: float, first: int, count: int, corner: Array
) -> tuple[float, float, float]:
    """Return where a ray enters a convex polygon, as a fraction of it, and the normal there."""
    enters, leaves = -1.0, NONE
    normal_x = normal_y = 0.0
    for k in range(first, first + count):
        height = (x - corner[k, 0]) * corner[k, 2] + (y - corner[k, 1]) * corner[k, 3]
        down = -(by_x * corner[k, 2] + by_y * corner[k, 3])
        if down > 0.0:  # towards this side
            at = height / down
            if at > enters:
                enters = at
                normal_x, normal_y = corner[k, 2], corner[k, 3]
        elif down < 0.0:
            leaves = min(leaves, height / down)
        elif height > 0.0:
            return NONE, 0.0, 0.0
    if enters < 0.0 or enters > leaves:
        return NONE, 0.0, 0.0
    return enters, normal_x, normal_y


def ray_capsule(
    x: float, y: float, by_x: float, by_y: float, one: Array, other: Array, radius: float
) -> tuple[float, float, float]:
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


def gather(
    low_x: float,
    low_y: float,
    high_x: float,
    high_y: float,
    mask: int,
    pose: FloatRows,
    shape_body: Indices,
    shape_kind: Indices,
    shape_first: Indices,
    shape_count: Indices,
    shape_radius: Floats,
    filters: RankRows,
    corner: FloatRows,
    box: FloatRows,
    curve: RankRows,
    node: FloatRows,
    sizes: Ranks,
    found: Ranks,
) -> int:
    """Write the shapes that overlap a box, which may be a point, into `found`; return how many."""
    leaves, total = sizes[0], 0
    first = lowest(leaves)
    for m in range(leaves, leaves + sizes[1]):
        s = curve[0, m]
        side = corner[shape_first[s]]
        x = low_x if side[2] > 0.0 else high_x
        y = low_y if side[3] > 0.0 else high_y
        solid = filters[s, SENSOR] == 0 and (filters[s, CATEGORY] & mask) != 0
        if solid and x * side[2] + y * side[3] <= side[0]:
            found[total] = s
            total += 1
    at = 1 if leaves > 0 else 0
    while at > 0:
        while at < first and meets_box(node[at], low_x, low_y, high_x, high_y):
            at = 2 * at
        if at >= first:
            bunch = (at - first) * BUNCH
            for m in range(bunch, min(bunch + BUNCH, leaves)):
                s = curve[0, m]
                solid = filters[s, SENSOR] == 0 and (filters[s, CATEGORY] & mask) != 0
                if (
                    solid
                    and meets_box(box[s, FAT:], low_x, low_y, high_x, high_y)
                    and overlaps(
                        low_x,
                        low_y,
                        high_x,
                        high_y,
                        pose[shape_body[s]],
                        shape_kind[s],
                        shape_radius[s],
                        corner[shape_first[s] : shape_first[s] + shape_count[s]],
                    )
                ):
                    found[total] = s
                    total += 1
        while at & 1:
            at >>= 1
        if at > 0:
            at += 1
    return total


def meets_box(box: Array, low_x: float, low_y: float, high_x: float, high_y: float) -> bool:
    """Return whether two boxes overlap."""
    return bool((box[0] <= high_x) & (box[2] >= low_x) & (box[1] <= high_y) & (box[3] >= low_y))


def overlaps(
    low_x: float,
    low_y: float,
    high_x: float,
    high_y: float,
    place: Array,
    kind: int,
    radius: float,
    corners: Array,
) -> bool:
    """Return whether a shape overlaps a box of the world; touching counts.

    Convex shapes are apart if a side of one of them has all of the other beyond it.
    """
    c, d = cos(place[TURN]), sin(place[TURN])
    mid_x, mid_y = 0.5 * low_x + 0.5 * high_x - place[X], 0.5 * low_y + 0.5 * high_y - place[Y]
    half_x, half_y = 0.5 * high_x - 0.5 * low_x, 0.5 * high_y - 0.5 * low_y
    if kind == POLYGON:
        for k in range(len(corners)):
            x, y = c * corners[k, 2] - d * corners[k, 3], d * corners[k, 2] + c * corners[k, 3]
            on_x = c * corners[k, 0] - d * corners[k, 1]
            on_y = d * corners[k, 0] + c * corners[k, 1]
            height = (mid_x - on_x) * x + (mid_y - on_y) * y
            if height > half_x * abs(x) + half_y * abs(y):
                return False
        return True  # its own box has been looked at
    one_x, one_y = c * corners[0, 0] - d * corners[0, 1], d * corners[0, 0] + c * corners[0, 1]
    last = len(corners) - 1
    end_x = c * corners[last, 0] - d * corners[last, 1]
    end_y = d * corners[last, 0] + c * corners[last, 1]
    return reaches(
        one_x - mid_x, one_y - mid_y, end_x - one_x, end_y - one_y, half_x, half_y, radius
    )


def reaches(
    x: float, y: float, by_x: float, by_y: float, half_x: float, half_y: float, radius: float
) -> bool:
    """Return whether a line from a point comes as near as a radius to a box around the origin."""
    if outside(x, y, half_x, half_y) <= radius:
        return True
    if outside(x + by_x, y + by_y, half_x, half_y) <= radius:
        return True
    size = by_x * by_x + by_y * by_y
    if size == 0.0:
        return False
    beside = far = False  # of the line are corners of the box
    for k in range(4):
        to_x = (half_x if k % 2 else -half_x) - x
        to_y = (half_y if k // 2 else -half_y) - y
        share = (to_x * by_x + to_y * by_y) / size
        aside = by_x * to_y - by_y * to_x
        beside = beside or aside >= 0.0
        far = far or aside <= 0.0
        if 0.0 <= share <= 1.0 and aside * aside <= radius * radius * size:
            return True
    crossing = beside and far
    left, right = min(x, x + by_x), max(x, x + by_x)
    down, up = min(y, y + by_y), max(y, y + by_y)
    return crossing and left <= half_x and right >= -half_x and down <= half_y and up >= -half_y


def outside(x: float, y: float, half_x: float, half_y: float) -> float:
    """Return the distance of a point to a box around the origin."""
    x, y = max(abs(x) - half_x, 0.0), max(abs(y) - half_y, 0.0)
    return sqrt(x * x + y * y)
