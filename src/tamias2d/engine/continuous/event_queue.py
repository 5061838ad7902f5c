"""The event that comes first: a tournament tree; and the contacts of each body.

An event is a body that leaves its bounds, or, numbered after the bodies, a contact whose shapes
meet. Of two at the same instant the first one counts.

Cost: linear for all events, then the logarithm of their number for each change.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import BroadPhase, Contacts, Events, Integers
from tamias2d.state import Array


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


def build_tournament(event_count: int, times: Array, queue: Integers) -> None:
    """Let all events play for being the first."""
    tournament = queue[tb.TOURNAMENT]
    leaf = first_tournament_leaf(event_count)
    for k in range(leaf):
        tournament[leaf + k] = min(k, event_count - 1)
    for node in range(leaf - 1, 0, -1):
        tournament[node] = sooner(tournament[2 * node], tournament[2 * node + 1], times)


def update_event(event: int, event_count: int, times: Array, queue: Integers) -> None:
    """Play the matches of an event anew, whose time has changed."""
    tournament = queue[tb.TOURNAMENT]
    node = (first_tournament_leaf(event_count) + event) // 2
    while node > 0:
        tournament[node] = sooner(tournament[2 * node], tournament[2 * node + 1], times)
        node //= 2


def sooner(one: int, other: int, times: Array) -> int:
    """Return which of two events is the first."""
    return other if times[other] < times[one] else one


def first_tournament_leaf(event_count: int) -> int:
    """Return the node of the first event in a tournament of some events."""
    leaf = 1
    while leaf < event_count:
        leaf *= 2
    return leaf
