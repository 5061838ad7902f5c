"""A time before which two bodies cannot meet, from the circles around them alone (DD46, DD80).

The circles are taken larger by a share that rounding does not reach. On the same acceleration the
bound is when they meet; else it is that of the gap along the axis of now.
"""

from math import inf, sqrt

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.approach import MARGIN, resolution, root, size_of, state_at
from tamias2d.event_driven.kinds import has_hull
from tamias2d.event_driven.tables import Moving, Pair, World
from tamias2d.generated.continuous_collision import (
    advance_opening,
    centre_acceleration_least,
    discriminant,
    reach_gap,
    reach_gap_acceleration,
    reach_gap_rate,
)
from tamias2d.kernels.assembled import inlined

BLURRED = 8.0  # resolutions within the margin, so that this is so


@inlined
def earliest_meeting(i: int, j: int, start: float, limit: float, world: World) -> float:
    """Return a time, s, before which two bodies do not meet from a start on, up to a limit.

    It is the start itself where they may touch there, and infinity if they meet never.
    """
    a, b = state_at(i, start, world.paths), state_at(j, start, world.paths)
    blur = BLURRED * resolution(a, b, size_of(i, world), size_of(j, world), limit)
    if world.kinds[i] == tb.PLANE:
        return start + before_plane(i, j, b, blur, world)
    if world.kinds[j] == tb.PLANE:
        return start + before_plane(j, i, a, blur, world)
    base = world.bodies[i, tb.RADIUS] + world.bodies[j, tb.RADIUS]
    if blur > base * MARGIN:
        return start
    one, other = world.paths[i], world.paths[j]
    pull = (other[tb.AX] - one[tb.AX], other[tb.AY] - one[tb.AY])
    return start + before_disc(a, b, pull, base * (1.0 + MARGIN), may_part(i, j, world))


@inlined
def may_part(i: int, j: int, world: World) -> bool:
    """Return whether a pair that touches and parts does not meet: one with corners may turn."""
    return bool(world.counts[tb.AT_START] == 0 and not has_hull(i, j, world))


@inlined
def before_plane(plane: int, k: int, state: Moving, blur: float, world: World) -> float:
    """Return how long a body in a state does not meet a half-plane, s."""
    wall, path, radius = world.bodies[plane], world.paths[k], world.bodies[k, tb.RADIUS]
    ux, uy = wall[tb.NORMAL_X], wall[tb.NORMAL_Y]
    x, y = state[0] - world.paths[plane, 0], state[1] - world.paths[plane, 1]
    gap = ux * x + uy * y - wall[tb.OFFSET] - radius * (1.0 + MARGIN)
    rate, least = ux * state[3] + uy * state[4], ux * path[tb.AX] + uy * path[tb.AY]
    if blur > radius * MARGIN:
        return 0.0
    if gap > 0.0:
        return root(gap, rate, least)
    parting = rate > MARGIN * (abs(state[3]) + abs(state[4]))
    if not (parting and may_part(plane, k, world)):
        return 0.0
    if least >= 0.0:
        return inf
    inside = discriminant(gap, rate, least)
    return float(advance_opening(rate, least, inside)) if inside > 0.0 else 0.0


@inlined
def before_disc(a: Moving, b: Moving, pull: Pair, reach: float, may: bool) -> float:
    """Return how long two centres on a relative acceleration are not in reach, s."""
    span, going = (b[0] - a[0], b[1] - a[1]), (b[3] - a[3], b[4] - a[4])
    gap, rate = reach_gap(span, reach), reach_gap_rate(span, going)
    if pull[0] == 0.0 and pull[1] == 0.0:
        if gap > 0.0:
            return root(gap, rate, reach_gap_acceleration(going))
        parting = rate > MARGIN * reach * (abs(going[0]) + abs(going[1]))
        return inf if parting and may else 0.0
    if gap <= 0.0:
        return 0.0
    distance = sqrt(span[0] * span[0] + span[1] * span[1])
    axis = (span[0] / distance, span[1] / distance)
    rate = axis[0] * going[0] + axis[1] * going[1]
    least = centre_acceleration_least((0.0, 0.0), pull, axis, 0.0)
    return root(distance - reach, rate, least)
