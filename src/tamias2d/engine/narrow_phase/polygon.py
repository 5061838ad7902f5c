"""Where two shapes with sides touch: the sides that lead, by search or by hint, and their points.

Serves: manifolds and sweeps. Hides: when a search is needed.
"""

from tamias2d.engine.narrow_phase.axis_cache import (
    APART,
    LED_BY_A,
    LED_BY_B,
    LED_BY_EITHER,
    NONE,
    cache_apart,
    cache_sides,
    keep_guess,
    largest_lever,
    moved_too_far,
    recalled,
    relative_pose,
)
from tamias2d.engine.narrow_phase.clip import touch_sides
from tamias2d.engine.narrow_phase.separation import (
    find_sides,
    inner_radius,
    most_facing,
    side_slack,
)
from tamias2d.engine.tables import CACHED_AXIS, Integers
from tamias2d.state import Array


def touch_cached(
    row: Array,
    ids: Integers,
    first_a: int,
    count_a: int,
    first_b: int,
    count_b: int,
    x: float,
    y: float,
    radius_a: float,
    radius_b: float,
    inner_a: float,
    inner_b: float,
    margin: float,
    vertices: Array,
) -> tuple[int, int]:
    """Write the points between two shapes with sides, by a hint where it holds."""
    enough = margin + radius_a + radius_b
    along, across, cosine, sine = relative_pose(first_a, first_b, x, y, vertices)
    state, side_a, side_b = recalled(row, ids, along, across, cosine, sine, enough)
    if state == NONE:
        if ids[CACHED_AXIS] == 0:
            side_a = most_facing(first_a, count_a, x, y, vertices)
            side_b = most_facing(first_b, count_b, -x, -y, vertices)
        state, side_a, side_b = search(
            row,
            ids,
            first_a,
            count_a,
            side_a,
            first_b,
            count_b,
            side_b,
            inner_a,
            inner_b,
            x,
            y,
            along,
            across,
            cosine,
            sine,
            enough,
            vertices,
        )
    if state == APART:
        return 0, 0
    return touch_led(
        row,
        state,
        first_a,
        count_a,
        side_a,
        first_b,
        count_b,
        side_b,
        x,
        y,
        radius_a,
        radius_b,
        margin,
        vertices,
    )


def search(
    row: Array,
    ids: Integers,
    first_a: int,
    count_a: int,
    guess_a: int,
    first_b: int,
    count_b: int,
    guess_b: int,
    inner_a: float,
    inner_b: float,
    x: float,
    y: float,
    along: float,
    across: float,
    cosine: float,
    sine: float,
    enough: float,
    vertices: Array,
) -> tuple[int, int, int]:
    """Return who leads, and the sides of A and B, and keep them as a hint for the pose seen."""
    state, side_a, side_b, room, other = find_sides(
        first_a,
        count_a,
        guess_a,
        first_b,
        count_b,
        guess_b,
        inner_a,
        inner_b,
        x,
        y,
        enough,
        vertices,
    )
    if moved_too_far(row, ids, along, across, sine):
        keep_guess(row, ids, along, across, sine, side_a, side_b)
        return state, side_a, side_b
    lever = largest_lever(first_a, count_a, first_b, count_b, x, y, vertices)
    if state == APART:
        cache_apart(row, ids, along, across, cosine, sine, lever, side_a, side_b, room, enough)
        return state, side_a, side_b
    if state == LED_BY_A:
        either, slack = side_slack(
            first_a,
            count_a,
            side_a,
            first_b,
            count_b,
            side_b,
            x,
            y,
            lever,
            room,
            other,
            vertices,
        )
    else:
        either, slack = side_slack(
            first_b,
            count_b,
            side_b,
            first_a,
            count_a,
            side_a,
            -x,
            -y,
            lever,
            room,
            other,
            vertices,
        )
    if either:
        state = LED_BY_EITHER
    cache_sides(row, ids, along, across, cosine, sine, lever, state, side_a, side_b, slack)
    return state, side_a, side_b


def touch_polygons(
    row: Array,
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
    """Write the points between two shapes with sides; return their names, or 0."""
    inner_a, inner_b = (
        inner_radius(first_a, count_a, vertices),
        inner_radius(first_b, count_b, vertices),
    )
    state, side_a, side_b, _, _ = find_sides(
        first_a,
        count_a,
        most_facing(first_a, count_a, x, y, vertices),
        first_b,
        count_b,
        most_facing(first_b, count_b, -x, -y, vertices),
        inner_a,
        inner_b,
        x,
        y,
        margin + radius_a + radius_b,
        vertices,
    )
    if state == APART:
        return 0, 0
    return touch_led(
        row,
        state,
        first_a,
        count_a,
        side_a,
        first_b,
        count_b,
        side_b,
        x,
        y,
        radius_a,
        radius_b,
        margin,
        vertices,
    )


def touch_led(
    row: Array,
    state: int,
    first_a: int,
    count_a: int,
    side_a: int,
    first_b: int,
    count_b: int,
    side_b: int,
    x: float,
    y: float,
    radius_a: float,
    radius_b: float,
    margin: float,
    vertices: Array,
) -> tuple[int, int]:
    """Write the points between two sides that face each other; the state says which leads."""
    next_a = side_a + 1 if side_a + 1 < count_a else 0
    next_b = side_b + 1 if side_b + 1 < count_b else 0
    swapped = state == LED_BY_B
    if state == LED_BY_EITHER:
        swapped = side_length(
            first_b, side_b, first_a, side_a, next_a, -x, -y, vertices
        ) > side_length(first_a, side_a, first_b, side_b, next_b, x, y, vertices)
    bare = count_a == 2 and count_b == 2
    if swapped:
        first_a, first_b = first_b, first_a
        side_a, side_b = side_b, side_a
        next_a, next_b = next_b, next_a
        radius_a, radius_b = radius_b, radius_a
        x, y = -x, -y
    return touch_sides(
        row,
        first_a,
        side_a,
        next_a,
        first_b,
        side_b,
        next_b,
        x,
        y,
        radius_a,
        radius_b,
        margin,
        bare,
        swapped,
        vertices,
    )


def side_length(
    first_p: int,
    side: int,
    first_q: int,
    one: int,
    other: int,
    x: float,
    y: float,
    vertices: Array,
) -> float:
    """Return the room that a side of P leaves to the nearer of two corners of Q, m."""
    p = first_p + side
    q, r = first_q + one, first_q + other
    nx, ny = vertices[p, 2], vertices[p, 3]
    low = min(nx * vertices[q, 0] + ny * vertices[q, 1], nx * vertices[r, 0] + ny * vertices[r, 1])
    room: float = nx * (x - vertices[p, 0]) + ny * (y - vertices[p, 1]) + low
    return room
