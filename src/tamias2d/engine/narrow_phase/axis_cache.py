"""The separating axis of a pair, cached from step to step, and how far it holds.

In the axes of A, which turn with its first side, B has a place and a turn. Where the place has
changed by d and the turn by k, as a chord, no vertex of B has moved by more than d + k times its
distance from B's centre, as seen from A, and no vertex of A by more than d + k times its distance
from B's centre, as seen from B. So with `lever` the largest of these distances, the separation
along a side, and a vertex's height over a side, have changed by at most d + k lever each. A side
that was ahead by `slack` is still ahead while that is less than half the slack: d and k lever may
take a quarter each.
"""

from math import sqrt
from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.core import Core
from tamias2d.engine.narrow_phase.separation import SEPARATED, Axis
from tamias2d.engine.tables import Integers
from tamias2d.state import Array

NOT_CACHED = 0  # beside the states of an axis
STATES, TURNS, SIDES = 8, 4, 1 << 12  # how many states, codes of a turn and sides fit a cached axis
CHORD_UNITS = 2.0**30  # of a chord, in flags
LEAST_COSINE = 0.6  # of the change of the cached angle: bounds how fast its sine changes
ROUNDING = 2.0**-40  # of the lever: more than rounding does to a separation
TOO_FAR_MOVED = 0.004  # of the distance, or as a sine: a motion after which no axis is cached


class RelativePose(NamedTuple):
    """Where B is from A, in the axes of the world and in those of A's first side."""

    x: float  # m
    y: float
    along: float  # m
    across: float
    cosine: float
    sine: float


def relative_pose(first_a: int, first_b: int, x: float, y: float, vertices: Array) -> RelativePose:
    """Return the pose of B, which is at (x, y) from A, m, by their first sides."""
    ax, ay = vertices[first_a, 2], vertices[first_a, 3]
    bx, by = vertices[first_b, 2], vertices[first_b, 3]
    along, across = ax * x + ay * y, ax * y - ay * x
    return RelativePose(x, y, along, across, ax * bx + ay * by, ax * by - ay * bx)


def cached_sides(
    cache: Array, flags: Integers, pose: RelativePose, cutoff: float
) -> tuple[int, int, int]:
    """Return the state of the cached axis and its sides of A and B.

    `NOT_CACHED` where it may not hold; its sides are guesses then.
    """
    cached = int(flags[tb.CACHED_AXIS])
    state = cached % STATES
    code = cached // STATES % TURNS
    sides = cached // (STATES * TURNS)
    turn, other = (pose.cosine, pose.sine) if code % 2 == 1 else (pose.sine, pose.cosine)
    if code >= 2:
        other = -other
    moved = abs(pose.along - cache[tb.CACHED_ALONG]) + abs(pose.across - cache[tb.CACHED_ACROSS])
    if state == SEPARATED:
        moved += cutoff
    holds = (
        (other >= LEAST_COSINE)
        & (abs(turn - cache[tb.CACHED_TURN]) * CHORD_UNITS <= flags[tb.CACHED_AXIS + 1])
        & (moved <= cache[tb.CACHED_WAY])
    )
    return state if holds else NOT_CACHED, sides % SIDES, sides // SIDES


def moved_too_far(cache: Array, flags: Integers, pose: RelativePose) -> bool:
    """Return whether a pair has moved so far since its last search that a cache is not worth it."""
    moved = abs(pose.along - cache[tb.CACHED_ALONG]) + abs(pose.across - cache[tb.CACHED_ACROSS])
    turned = 0.0
    if int(flags[tb.CACHED_AXIS]) // STATES % TURNS % 2 == 0:
        turned = abs(pose.sine - cache[tb.CACHED_TURN])
    far = moved > TOO_FAR_MOVED * (abs(pose.along) + abs(pose.across))
    return bool(far or turned > TOO_FAR_MOVED)


def cache_guess(
    cache: Array, flags: Integers, pose: RelativePose, side_a: int, side_b: int
) -> None:
    """Keep two sides, and where they were found, as a guess for the next search."""
    cache[tb.CACHED_ALONG], cache[tb.CACHED_ACROSS] = pose.along, pose.across
    cache[tb.CACHED_TURN] = pose.sine
    known = side_a < SIDES and side_b < SIDES
    sides = side_a + SIDES * side_b
    flags[tb.CACHED_AXIS] = SEPARATED + STATES * TURNS * sides if known else 0
    flags[tb.CACHED_AXIS + 1] = -1


def cache_separation(
    cache: Array, flags: Integers, pose: RelativePose, lever: float, axis: Axis, cutoff: float
) -> None:
    """Cache an axis with a separation that is larger than the cutoff, m."""
    half = 0.5 * (axis.separation - cutoff) - ROUNDING * lever
    cache_axis(cache, flags, pose, SEPARATED, axis.side_a, axis.side_b, half / lever)
    cache[tb.CACHED_WAY] = cutoff + half


def cache_sides(
    cache: Array,
    flags: Integers,
    pose: RelativePose,
    lever: float,
    state: int,
    axis: Axis,
    slack: float,
) -> None:
    """Cache two sides that are ahead of all others by a slack, m."""
    quarter = 0.25 * slack - ROUNDING * lever
    cache_axis(cache, flags, pose, state, axis.side_a, axis.side_b, quarter / lever)
    cache[tb.CACHED_WAY] = quarter


def cache_axis(
    cache: Array,
    flags: Integers,
    pose: RelativePose,
    state: int,
    side_a: int,
    side_b: int,
    chord: float,
) -> None:
    """Cache two sides with the chord by which B may turn, or as a guess if that is not positive."""
    if chord <= 0.0 or side_a >= SIDES or side_b >= SIDES:
        cache_guess(cache, flags, pose, side_a, side_b)
        return
    code, turn, other = 0, pose.sine, pose.cosine
    if abs(pose.sine) > abs(pose.cosine):
        code, turn, other = 1, pose.cosine, pose.sine
    if other < 0.0:
        code += 2
    flags[tb.CACHED_AXIS] = state + STATES * (code + TURNS * (side_a + SIDES * side_b))
    flags[tb.CACHED_AXIS + 1] = int(CHORD_UNITS * LEAST_COSINE * min(chord, 1.0))
    cache[tb.CACHED_ALONG], cache[tb.CACHED_ACROSS] = pose.along, pose.across
    cache[tb.CACHED_TURN] = turn


def largest_lever(a: Core, b: Core, x: float, y: float, vertices: Array) -> float:
    """Return the largest distance of a vertex of B from its centre, or of A from either, m."""
    far = 0.0
    for k in range(b.first, b.first + b.vertex_count):
        far = max(far, vertices[k, 0] * vertices[k, 0] + vertices[k, 1] * vertices[k, 1])
    for k in range(a.first, a.first + a.vertex_count):
        vx, vy = vertices[k, 0], vertices[k, 1]
        far = max(far, vx * vx + vy * vy, (vx - x) * (vx - x) + (vy - y) * (vy - y))
    return sqrt(far)
