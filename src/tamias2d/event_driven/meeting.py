"""When a pair meets, of whatever shapes."""

from math import inf

from tamias2d.event_driven.advancement import time_of_hull_impact
from tamias2d.event_driven.approach import MARGIN, state_at, time_of_impact
from tamias2d.event_driven.kinds import has_hull
from tamias2d.event_driven.tables import (
    AX,
    AY,
    DISC,
    HELD_BY,
    LOOKED_AT,
    PLANE,
    RADIUS,
    START,
    World,
)
from tamias2d.kernels.assembled import inlined


@inlined
def meets(i: int, j: int, world: World) -> bool:
    """Return whether two bodies can meet at all: one is pushed, and neither rests on the other."""
    one, other = world.kinds[i], world.kinds[j]
    solid, pushed = min(one, other) >= PLANE, max(one, other) >= DISC
    held = world.notes[i, HELD_BY] == j + 1 or world.notes[j, HELD_BY] == i + 1
    return bool(i != j and solid and pushed and not held)


@inlined
def time_of_meeting(i: int, j: int, limit: float, world: World) -> float:
    """Return when a pair meets, s: later than the limit or infinity if not until then.

    It is below 0 where that is not decided.
    """
    world.counts[LOOKED_AT] += 1
    start = max(world.paths[i, START], world.paths[j, START])
    if passes(i, j, start, limit, world):
        return inf
    if has_hull(i, j, world):
        return time_of_hull_impact(i, j, start, limit, world)
    return time_of_impact(i, j, start, limit, world)


@inlined
def passes(i: int, j: int, start: float, limit: float, world: World) -> bool:
    """Return whether circles around two bodies on which the same acts stay well apart, until a
    limit, s.

    One moves on a straight line before the other, so that no search is needed.
    """
    a, b = world.paths[i], world.paths[j]
    plane = world.kinds[i] == PLANE or world.kinds[j] == PLANE
    if plane or a[AX] != b[AX] or a[AY] != b[AY]:
        return False
    p, q = state_at(i, start, world.paths), state_at(j, start, world.paths)
    x, y, u, v = q[0] - p[0], q[1] - p[1], q[3] - p[3], q[4] - p[4]
    closing, square = -(x * u + y * v), u * u + v * v
    left = min(closing / square, limit - start) if closing > 0.0 and square > 0.0 else 0.0
    x_least, y_least = x + u * left, y + v * left
    apart = (world.bodies[i, RADIUS] + world.bodies[j, RADIUS]) * (1.0 + MARGIN)
    return bool(x_least * x_least + y_least * y_least > apart * apart)
