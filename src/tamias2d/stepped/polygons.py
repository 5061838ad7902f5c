"""Where two shapes with sides touch: the sides that lead, by search or by hint, and their points.

Serves: manifolds and sweeps. Hides: when a search is needed.
"""

from tamias2d.state import Array
from tamias2d.stepped.clip import touch_sides
from tamias2d.stepped.hint import (
    APART,
    LED_BY_A,
    LED_BY_B,
    LED_BY_EITHER,
    NONE,
    keep_apart,
    keep_guess,
    keep_sides,
    lever_of,
    pose_seen,
    recalled,
    roves,
)
from tamias2d.stepped.layout import HINT, Whole
from tamias2d.stepped.separation import find_sides, inner_radius, most_facing, slack_of


def touch_again(
    row: Array,
    ids: Whole,
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
    turned: Array,
) -> tuple[int, int]:
    """Write the points between two shapes with sides, by a hint where it holds."""
    enough = margin + radius_a + radius_b
    along, across, cosine, sine = pose_seen(first_a, first_b, x, y, turned)
    state, side_a, side_b = recalled(row, ids, along, across, cosine, sine, enough)
    if state == NONE:
        if ids[HINT] == 0:
            side_a = most_facing(first_a, count_a, x, y, turned)
            side_b = most_facing(first_b, count_b, -x, -y, turned)
        state, side_a, side_b = search(
            row, ids, first_a, count_a, side_a, first_b, count_b, side_b,
            inner_a, inner_b, x, y, along, across, cosine, sine, enough, turned,
        )  # fmt: skip
    if state == APART:
        return 0, 0
    return touch_led(
        row, state, first_a, count_a, side_a, first_b, count_b, side_b,
        x, y, radius_a, radius_b, margin, turned,
    )  # fmt: skip


def search(
    row: Array,
    ids: Whole,
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
    turned: Array,
) -> tuple[int, int, int]:
    """Return who leads, and the sides of A and B, and keep them as a hint for the pose seen."""
    state, side_a, side_b, room, other = find_sides(
        first_a, count_a, guess_a, first_b, count_b, guess_b, inner_a, inner_b, x, y, enough,
        turned,
    )  # fmt: skip
    if roves(row, ids, along, across, sine):
        keep_guess(row, ids, along, across, sine, side_a, side_b)
        return state, side_a, side_b
    lever = lever_of(first_a, count_a, first_b, count_b, x, y, turned)
    if state == APART:
        keep_apart(row, ids, along, across, cosine, sine, lever, side_a, side_b, room, enough)
        return state, side_a, side_b
    if state == LED_BY_A:
        either, slack = slack_of(
            first_a, count_a, side_a, first_b, count_b, side_b,
            x, y, lever, room, other, turned,
        )  # fmt: skip
    else:
        either, slack = slack_of(
            first_b, count_b, side_b, first_a, count_a, side_a,
            -x, -y, lever, room, other, turned,
        )  # fmt: skip
    if either:
        state = LED_BY_EITHER
    keep_sides(row, ids, along, across, cosine, sine, lever, state, side_a, side_b, slack)
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
    turned: Array,
) -> tuple[int, int]:
    """Write the points between two shapes with sides; return their names, or 0."""
    inner_a, inner_b = (
        inner_radius(first_a, count_a, turned),
        inner_radius(first_b, count_b, turned),
    )
    state, side_a, side_b, _, _ = find_sides(
        first_a, count_a, most_facing(first_a, count_a, x, y, turned),
        first_b, count_b, most_facing(first_b, count_b, -x, -y, turned),
        inner_a, inner_b, x, y, margin + radius_a + radius_b, turned,
    )  # fmt: skip
    if state == APART:
        return 0, 0
    return touch_led(
        row, state, first_a, count_a, side_a, first_b, count_b, side_b,
        x, y, radius_a, radius_b, margin, turned,
    )  # fmt: skip


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
    turned: Array,
) -> tuple[int, int]:
    """Write the points between two sides that face each other; the state says which leads."""
    next_a = side_a + 1 if side_a + 1 < count_a else 0
    next_b = side_b + 1 if side_b + 1 < count_b else 0
    swapped = state == LED_BY_B
    if state == LED_BY_EITHER:
        swapped = room_of(first_b, side_b, first_a, side_a, next_a, -x, -y, turned) > room_of(
            first_a, side_a, first_b, side_b, next_b, x, y, turned
        )
    bare = count_a == 2 and count_b == 2
    if swapped:
        first_a, first_b = first_b, first_a
        side_a, side_b = side_b, side_a
        next_a, next_b = next_b, next_a
        radius_a, radius_b = radius_b, radius_a
        x, y = -x, -y
    return touch_sides(
        row, first_a, side_a, next_a, first_b, side_b, next_b,
        x, y, radius_a, radius_b, margin, bare, swapped, turned,
    )  # fmt: skip


def room_of(
    first_p: int,
    side: int,
    first_q: int,
    one: int,
    other: int,
    x: float,
    y: float,
    turned: Array,
) -> float:
    """Return the room that a side of P leaves to the nearer of two corners of Q, m."""
    p = first_p + side
    q, r = first_q + one, first_q + other
    nx, ny = turned[p, 2], turned[p, 3]
    low = min(nx * turned[q, 0] + ny * turned[q, 1], nx * turned[r, 0] + ny * turned[r, 1])
    room: float = nx * (x - turned[p, 0]) + ny * (y - turned[p, 1]) + low
    return room
