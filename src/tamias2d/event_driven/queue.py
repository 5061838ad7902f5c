"""The queue of events: a heap by time, then by body, whose entries may have become void.

An event is void when one of its bodies has gone on another path since. It is dropped when it comes
up, or when the queue is full. Cost: O(log n) for an event.
"""

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.tables import World
from tamias2d.kernels.assembled import inlined


def has_room(count: int, world: World) -> bool:
    """Return whether some events more have room, after void ones were dropped if need be."""
    if world.counts[tb.EVENTS] + count > len(world.queue):
        drop_void(world)
    return bool(world.counts[tb.EVENTS] + count <= len(world.queue))


@inlined
def push(time: float, i: int, j: int, world: World) -> None:
    """Add an event of two bodies, or of one twice."""
    place = world.counts[tb.EVENTS]
    world.counts[tb.EVENTS] += 1
    world.queue[place] = time
    row = world.events[place]
    row[tb.FIRST], row[tb.SECOND] = i, j
    row[tb.FIRST_VERSION], row[tb.SECOND_VERSION] = (
        world.notes[i, tb.VERSION],
        world.notes[j, tb.VERSION],
    )
    rise(place, world)


@inlined
def pop(world: World) -> None:
    """Remove the first event."""
    world.counts[tb.EVENTS] -= 1
    last = world.counts[tb.EVENTS]
    if last > 0:
        move(last, 0, world)
        sink(0, world)


@inlined
def is_void(place: int, world: World) -> bool:
    """Return whether a body of an event has another path by now."""
    event = world.events[place]
    first = world.notes[event[tb.FIRST], tb.VERSION] != event[tb.FIRST_VERSION]
    return bool(first or world.notes[event[tb.SECOND], tb.VERSION] != event[tb.SECOND_VERSION])


def drop_void(world: World) -> None:
    """Remove all events that have become void."""
    count = 0
    for place in range(world.counts[tb.EVENTS]):
        if not is_void(place, world):
            move(place, count, world)
            count += 1
    world.counts[tb.EVENTS] = count
    for place in range(count // 2 - 1, -1, -1):
        sink(place, world)


def rise(place: int, world: World) -> None:
    """Move an event up to where it belongs."""
    while place > 0:
        above = (place - 1) // 2
        if not before(place, above, world):
            break
        swap(place, above, world)
        place = above


def sink(place: int, world: World) -> None:
    """Move an event down to where it belongs."""
    count = world.counts[tb.EVENTS]
    while True:
        below = 2 * place + 1
        if below >= count:
            break
        if below + 1 < count and before(below + 1, below, world):
            below += 1
        if not before(below, place, world):
            break
        swap(place, below, world)
        place = below


@inlined
def before(one: int, other: int, world: World) -> bool:
    """Return whether an event comes before another one."""
    if world.queue[one] != world.queue[other]:
        return bool(world.queue[one] < world.queue[other])
    first, second = world.events[one], world.events[other]
    if first[tb.FIRST] != second[tb.FIRST]:
        return bool(first[tb.FIRST] < second[tb.FIRST])
    return bool(first[tb.SECOND] < second[tb.SECOND])


@inlined
def swap(one: int, other: int, world: World) -> None:
    """Exchange two events."""
    world.queue[one], world.queue[other] = world.queue[other], world.queue[one]
    first, second = world.events[one], world.events[other]
    for column in range(tb.EVENT_COLUMNS):
        first[column], second[column] = second[column], first[column]


def move(one: int, other: int, world: World) -> None:
    """Put an event into another place."""
    world.queue[other] = world.queue[one]
    source, target = world.events[one], world.events[other]
    for column in range(tb.EVENT_COLUMNS):
        target[column] = source[column]
