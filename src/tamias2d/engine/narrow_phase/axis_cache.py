"""Which two sides led to a manifold, and how far bodies may move until others could.

Serves: manifolds of bodies that rest, or pass slowly. Hides: how a relative pose is kept, and why
a search would find the same sides again.

In the axes of A, which turn with its first side, B has a place and a turn. Where the place has
changed by d and the turn by k, as a chord, no corner of B has moved by more than d + k times its
distance from B's centre, as seen from A, and no corner of A by more than d + k times its distance
from B's centre, as seen from B. So with `lever` the largest of these distances, the room that a
side leaves, and a corner's height over a side, have changed by at most d + k lever each. What was
ahead by `slack` is still ahead while that is less than half the slack: d and k lever may take a
quarter each.
"""

from math import sqrt

from tamias2d.engine.tables import AXIS_CACHE, CACHED_AXIS, Integers
from tamias2d.state import Array

NONE, APART, LED_BY_A, LED_BY_B, LED_BY_EITHER = 0, 1, 2, 3, 4
STATES, TURNS, SIDES = 8, 4, 1 << 12  # states, codes of a turn and sides that a hint has room for
FINE = 2.0**30  # units of a turn's room
STRAIGHT = 0.6  # of the cosine of the kept angle: bounds how fast its sine changes
ROUNDING = 2.0**-40  # of the lever: more than rounding does to a room
TOO_FAR_MOVED = 0.004  # of their distance, or as a sine: a motion after which no hint is kept
NOTHING = 1e308


def relative_pose(
    first_a: int, first_b: int, x: float, y: float, vertices: Array
) -> tuple[float, float, float, float]:
    """Return B's place, m, and the cosine and sine of its turn, in the axes of A's first side."""
    ax, ay = vertices[first_a, 2], vertices[first_a, 3]
    bx, by = vertices[first_b, 2], vertices[first_b, 3]
    return ax * x + ay * y, ax * y - ay * x, ax * bx + ay * by, ax * by - ay * bx


def recalled(
    row: Array,
    ids: Integers,
    along: float,
    across: float,
    cosine: float,
    sine: float,
    enough: float,
) -> tuple[int, int, int]:
    """Return the state of a hint and its sides of A and B; `NONE` where it may not hold.

    Its sides are a guess then.
    """
    hint = int(ids[CACHED_AXIS])
    state = hint % STATES
    code = hint // STATES % TURNS
    sides = hint // (STATES * TURNS)
    turn, other = (cosine, sine) if code % 2 == 1 else (sine, cosine)
    if code >= 2:
        other = -other
    moved = abs(along - row[AXIS_CACHE]) + abs(across - row[AXIS_CACHE + 1])
    if state == APART:
        moved += enough
    holds = (
        (other >= STRAIGHT)
        & (abs(turn - row[AXIS_CACHE + 2]) * FINE <= ids[CACHED_AXIS + 1])
        & (moved <= row[AXIS_CACHE + 3])
    )
    return state if holds else NONE, sides % SIDES, sides // SIDES


def moved_too_far(row: Array, ids: Integers, along: float, across: float, sine: float) -> bool:
    """Return whether a pair has moved so far since its last search that a hint is not worth it."""
    moved = abs(along - row[AXIS_CACHE]) + abs(across - row[AXIS_CACHE + 1])
    turned = (
        abs(sine - row[AXIS_CACHE + 2]) if int(ids[CACHED_AXIS]) // STATES % TURNS % 2 == 0 else 0.0
    )
    return bool(moved > TOO_FAR_MOVED * (abs(along) + abs(across)) or turned > TOO_FAR_MOVED)


def keep_guess(
    row: Array,
    ids: Integers,
    along: float,
    across: float,
    sine: float,
    side_a: int,
    side_b: int,
) -> None:
    """Keep two sides, and where they were found, as a hint that never holds."""
    row[AXIS_CACHE], row[AXIS_CACHE + 1], row[AXIS_CACHE + 2] = along, across, sine
    known = side_a < SIDES and side_b < SIDES
    ids[CACHED_AXIS] = APART + STATES * TURNS * (side_a + SIDES * side_b) if known else 0
    ids[CACHED_AXIS + 1] = -1


def cache_apart(
    row: Array,
    ids: Integers,
    along: float,
    across: float,
    cosine: float,
    sine: float,
    lever: float,
    side_a: int,
    side_b: int,
    room: float,
    enough: float,
) -> None:
    """Keep that one of two sides leaves a room, m, where enough would do."""
    half = 0.5 * (room - enough) - ROUNDING * lever
    cache_pose(row, ids, along, across, cosine, sine, APART, side_a, side_b, half / lever)
    row[AXIS_CACHE + 3] = enough + half


def cache_sides(
    row: Array,
    ids: Integers,
    along: float,
    across: float,
    cosine: float,
    sine: float,
    lever: float,
    state: int,
    side_a: int,
    side_b: int,
    slack: float,
) -> None:
    """Keep two sides that are ahead of all others by a slack, m."""
    quarter = 0.25 * slack - ROUNDING * lever
    cache_pose(row, ids, along, across, cosine, sine, state, side_a, side_b, quarter / lever)
    row[AXIS_CACHE + 3] = quarter


def cache_pose(
    row: Array,
    ids: Integers,
    along: float,
    across: float,
    cosine: float,
    sine: float,
    state: int,
    side_a: int,
    side_b: int,
    chord: float,
) -> None:
    """Keep a pose with the chord by which the turn may change, or a guess where there is none."""
    if chord <= 0.0 or side_a >= SIDES or side_b >= SIDES:
        keep_guess(row, ids, along, across, sine, side_a, side_b)
        return
    code, turn, other = 0, sine, cosine
    if abs(sine) > abs(cosine):
        code, turn, other = 1, cosine, sine
    if other < 0.0:
        code += 2
    ids[CACHED_AXIS] = state + STATES * (code + TURNS * (side_a + SIDES * side_b))
    ids[CACHED_AXIS + 1] = int(FINE * STRAIGHT * min(chord, 1.0))
    row[AXIS_CACHE], row[AXIS_CACHE + 1], row[AXIS_CACHE + 2] = along, across, turn


def largest_lever(
    first_a: int, count_a: int, first_b: int, count_b: int, x: float, y: float, vertices: Array
) -> float:
    """Return the largest distance of B's corners, and of A's from either centre, at most, m."""
    far = 0.0
    for k in range(first_b, first_b + count_b):
        far = max(far, vertices[k, 0] * vertices[k, 0] + vertices[k, 1] * vertices[k, 1])
    for k in range(first_a, first_a + count_a):
        vx, vy = vertices[k, 0], vertices[k, 1]
        far = max(far, vx * vx + vy * vy, (vx - x) * (vx - x) + (vy - y) * (vy - y))
    return sqrt(far)
