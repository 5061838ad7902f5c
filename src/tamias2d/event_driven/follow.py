"""From event to event: impacts, and bodies that go from cell to cell.

Cost of an event: O(log n), and a search for each body that is near to those of the event.
"""

from math import inf

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.cells import enter, gather, leave, time_of_leaving
from tamias2d.event_driven.departure import tell
from tamias2d.event_driven.few import are_few, follow_few
from tamias2d.event_driven.instant import is_full, meet, seems_endless, stop_sliding
from tamias2d.event_driven.kinds import is_pushed
from tamias2d.event_driven.meeting import look, meets, search
from tamias2d.event_driven.queue import has_room, is_void, pop, push
from tamias2d.event_driven.tables import World, Worlds
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

MOST_EVENTS = 100_000  # of one call, so that Ctrl-C is heard


def follow(world: World) -> int:
    """Go on from event to event up to the limit; return why it ended.

    What is not decided is left as it is, for others to decide: the paths are those before it, and
    `counts` say who meets.
    """
    status = set_out_changed(world)
    if status != tb.DONE:
        return status
    world.counts[tb.AT_START] = 0
    for _ in range(MOST_EVENTS):
        if world.counts[tb.EVENTS] == 0 or world.queue[0] > world.numbers[tb.LIMIT]:
            world.numbers[tb.NOW] = world.numbers[tb.LIMIT]
            return tb.DONE
        if not has_room(most_events(world), world):
            return tb.CROWDED
        if is_full(world):
            return tb.FULL
        status = happen(world)
        if status != tb.DONE or seems_endless(world):
            return tb.FULL if status == tb.DONE else status
    return tb.FULL


def set_out_changed(world: World) -> int:
    """Schedule what happens to the bodies whose paths are new; return why that ends."""
    while world.counts[tb.CHANGED] > 0:
        if not has_room(most_events(world), world):
            return tb.CROWDED
        world.counts[tb.CHANGED] -= 1
        if not set_out(world.changed[world.counts[tb.CHANGED]], -1, world.numbers[tb.NOW], world):
            return tb.SEARCH
    return tb.DONE


@inlined
def happen(world: World) -> int:
    """Let the first event happen, unless it is void."""
    time, void = world.queue[0], is_void(0, world)
    i, j = world.events[0, tb.FIRST], world.events[0, tb.SECOND]
    pop(world)
    if void:
        return tb.DONE
    if i > j:
        return tb.DONE if search(j, i, limit_of(j, i, world), world) else tb.SEARCH
    world.numbers[tb.NOW] = time
    if i == j:
        if time < world.leaving[i]:
            return set_out_changed(world) if stop_sliding(i, time, world) else tb.INSTANT
        leave(i, world)
        world.leaving[i] = tb.NOWHERE
        return tb.DONE if set_out(i, -1, time, world) else tb.SEARCH
    if not meet(i, j, time, world):
        world.counts[tb.MEETING], world.counts[tb.OTHER] = i, j
        return tb.INSTANT
    if world.counts[tb.CHANGED] > 0:
        return set_out_changed(world)
    first, second = (i, j) if is_pushed(i, world) else (j, i)
    both = is_pushed(second, world)  # when both leave their cells is known to the second search
    good = set_out(first, second if both else -1, time, world)
    if good and both:
        good = set_out(second, -1, time, world)
    return tb.DONE if good else tb.SEARCH


def most_events(world: World) -> int:
    """Return how many events may come of one."""
    return 2 * (len(world.kinds) + 2)


def set_out(k: int, but: int, time: float, world: World) -> bool:
    """Schedule what happens to a body, but for one other; return whether that can be told.

    It is put into its cell where it is in none yet.
    """
    if world.leaving[k] == tb.NOWHERE:
        enter(k, time, world)
    world.leaving[k] = time_of_leaving(k, time, world)
    if world.leaving[k] < inf:
        push(world.leaving[k], k, k, world)
    if world.sliding[k] < inf:
        push(world.sliding[k], k, k, world)
    for place in range(gather(k, world)):
        other = world.near[place]
        i, j = min(k, other), max(k, other)
        if other == but or not meets(i, j, world):
            continue
        if not look(i, j, limit_of(i, j, world), world):
            return False
    return True


@inlined
def limit_of(i: int, j: int, world: World) -> float:
    """Return until when a pair is searched, s: another search follows where a body leaves."""
    return float(min(world.leaving[i], world.leaving[j], world.numbers[tb.END]))


def follow_worlds(worlds: Worlds) -> int:
    """Follow worlds, one after the other; return how many were followed to the end."""
    done, few = 0, are_few(worlds.world)
    for w in range(len(worlds.status)):
        begin(worlds.bodies[w], worlds.laws[w], worlds.world)
        worlds.status[w] = 0
        ended = follow_few(worlds.world, worlds.few) if few else follow(worlds.world)
        if ended == tb.DONE:
            finish(worlds.world, worlds.samples[w])
            worlds.status[w] = 1
            done += 1
    return done


def begin(bodies: Array, laws: Array, world: World) -> None:
    """Set a world to the start of one of many; none of its bodies is in a cell."""
    copy(bodies, world.bodies, tb.COLUMNS)
    copy(laws, world.laws, 2)
    copy(bodies, world.paths, tb.START)
    world.paths[:, tb.START] = 0.0
    world.notes[:, :] = 0
    world.notes[:, tb.ACROSS] = -1
    world.bounces[:, :] = 0.0
    world.leaving[:] = inf
    world.sliding[:] = inf
    world.numbers[tb.NOW] = 0.0
    world.counts[tb.EVENTS] = world.counts[tb.IMPACTS] = 0
    world.counts[tb.RULED] = world.counts[tb.STAYED] = 0
    world.counts[tb.AT_START] = 1
    world.counts[tb.CHANGED] = len(world.kinds)
    for k in range(len(world.kinds)):
        world.changed[k] = k


def finish(world: World, samples: Array) -> None:
    """Write down all samples that are left, and hand them out."""
    for k in range(len(world.kinds)):
        tell(k, inf, world)
    copy(world.samples, samples, tb.AX)  # the states


def copy(source: Array, target: Array, columns: int) -> None:
    """Copy the first columns of a table."""
    for row in range(len(source)):
        for column in range(columns):
            target[row, column] = source[row, column]
