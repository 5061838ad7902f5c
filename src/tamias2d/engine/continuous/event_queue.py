"""The event that comes first: a heap of those that come in this step; and the contacts of a body.

An event is a body that leaves its bounds, or, numbered after the bodies, a contact whose shapes
meet. Of two at the same instant the one with the lower number counts. A place that is noted for an
event tells whether it waits: what the heap holds there does.

Cost: a look at each event, then the logarithm of the number that wait for each change.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import BroadPhase, Contacts, Events, Integers
from tamias2d.state import Array

NO_EVENT = -1


def begin_queue(
    broad_phase: BroadPhase, contacts: Contacts, events: Events, body_count: int
) -> None:
    """List the contacts of each body, and let the events wait that come in this step."""
    list_contacts_by_body(broad_phase, contacts, events, body_count)
    build_queue(body_count + broad_phase.counts[tb.CONTACTS], events.times, events.queue)


def list_contacts_by_body(
    broad_phase: BroadPhase, contacts: Contacts, events: Events, body_count: int
) -> None:
    """List the contacts of each body, in their order: by counting."""
    starts, listed = events.queue[tb.FIRST_OF_BODY], events.queue[tb.CONTACT_OF_BODY]
    for i in range(body_count + 2):
        starts[i] = 0
    for p in range(broad_phase.counts[tb.CONTACTS]):
        starts[contacts.pairs[p, tb.SLOT_A] + 2] += 1
        starts[contacts.pairs[p, tb.SLOT_B] + 2] += 1
    for i in range(2, body_count + 2):
        starts[i] += starts[i - 1]
    for p in range(broad_phase.counts[tb.CONTACTS]):
        for i in (contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]):
            listed[starts[i + 1]] = p
            starts[i + 1] += 1


def build_queue(event_count: int, times: Array, queue: Integers) -> None:
    """Let the events wait that come in this step, those whose time is at most 1."""
    queue[tb.WAITING, 0] = 0
    for event in range(event_count):
        if times[event] <= 1.0:
            update_event(event, times, queue)


def first_event(queue: Integers) -> int:
    """Return the event that comes first, or `NO_EVENT`."""
    return queue[tb.WAITING, 1] if queue[tb.WAITING, 0] > 0 else NO_EVENT


def update_event(event: int, times: Array, queue: Integers) -> None:
    """Give an event its place, whose time has changed; it waits no more if that is beyond 1.

    Each event is given its place before the time of another one changes.
    """
    waiting, size, at = queue[tb.WAITING], queue[tb.WAITING, 0], queue[tb.PLACE, event]
    waits = 0 < at <= size and waiting[at] == event
    if times[event] <= 1.0:
        if not waits:
            size += 1
            waiting[0], at = size, size
        settle(event, at, size, times, queue)
    elif waits:
        waiting[0] = size - 1
        if at < size:
            settle(waiting[size], at, size - 1, times, queue)


def settle(event: int, at: int, size: int, times: Array, queue: Integers) -> None:
    """Put an event where it belongs, from a free place in the heap on."""
    waiting, place = queue[tb.WAITING], queue[tb.PLACE]
    while at > 1 and is_sooner(event, waiting[at // 2], times):
        waiting[at] = waiting[at // 2]
        place[waiting[at]] = at
        at //= 2
    below = sooner_below(at, size, times, waiting)
    while below <= size and is_sooner(waiting[below], event, times):
        waiting[at] = waiting[below]
        place[waiting[at]] = at
        at = below
        below = sooner_below(at, size, times, waiting)
    waiting[at], place[event] = event, at


def sooner_below(at: int, size: int, times: Array, waiting: Integers) -> int:
    """Return which of the two places below one has the sooner event; beyond the last for none."""
    below = 2 * at
    return (
        below + 1
        if below < size and is_sooner(waiting[below + 1], waiting[below], times)
        else below
    )


def is_sooner(one: int, other: int, times: Array) -> bool:
    """Return whether an event comes before another one."""
    if times[one] == times[other]:
        return one < other
    return bool(times[one] < times[other])
