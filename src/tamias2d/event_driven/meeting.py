"""When a pair meets, of whatever shapes."""

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.advancement import time_of_hull_impact
from tamias2d.event_driven.approach import time_of_impact
from tamias2d.event_driven.bound import earliest_meeting
from tamias2d.event_driven.kinds import has_hull
from tamias2d.event_driven.queue import push
from tamias2d.event_driven.tables import World
from tamias2d.kernels.assembled import inlined


@inlined
def meets(i: int, j: int, world: World) -> bool:
    """Return whether two bodies can meet at all: one is pushed, and neither rests on the other."""
    one, other = world.kinds[i], world.kinds[j]
    solid, pushed = min(one, other) >= tb.PLANE, max(one, other) >= tb.DISC
    held = world.notes[i, tb.HELD_BY] == j + 1 or world.notes[j, tb.HELD_BY] == i + 1
    return bool(i != j and solid and pushed and not held)


@inlined
def look(i: int, j: int, limit: float, world: World) -> bool:
    """Schedule when a pair meets, if it does up to a limit, s; return whether that can be told.

    Where bodies without corners are well apart, a time before which they cannot meet is noted: most
    pairs have other paths before it comes, and need no search.
    """
    world.counts[tb.LOOKED_AT] += 1
    start = max(world.paths[i, tb.START], world.paths[j, tb.START])
    early = earliest_meeting(i, j, start, limit, world)
    if early > limit:
        return True
    if early > start and not has_hull(i, j, world):
        push(early, j, i, world)
        return True
    return search(i, j, limit, world)


@inlined
def search(i: int, j: int, limit: float, world: World) -> bool:
    """Schedule when a pair meets, if it does up to a limit, s; return whether that can be told."""
    start = max(world.paths[i, tb.START], world.paths[j, tb.START])
    if has_hull(i, j, world):
        meeting = time_of_hull_impact(i, j, start, limit, world)
    else:
        meeting = time_of_impact(i, j, start, limit, world)
    if 0.0 <= meeting <= limit:
        push(meeting, i, j, world)
    return meeting >= 0.0
