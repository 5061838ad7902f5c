"""What happens next in a flight, and which pairs are those of a body.

Serves: flight. Hides: that what happens first is the winner of a tournament, of which a change
plays anew one path only, and that pairs are listed by their bodies.

An event is a body that leaves its room, or after the bodies a pair that meets. Of two at the same
instant the first one counts.

Cost: for all events a pass over them, then for each change the logarithm of their number.
"""

from tamias2d.engine.tables import (
    CONTACT_OF_BODY,
    CONTACTS,
    FIRST_OF_BODY,
    SLOT_A,
    SLOT_B,
    TOURNAMENT,
    BroadPhase,
    Contacts,
    Events,
    Integers,
)
from tamias2d.state import Array

# rows of the agenda: where the pairs of each body begin, these pairs, and the tournament, which has
# its winner first


def list_contacts_by_body(
    broad_phase: BroadPhase, contacts: Contacts, events: Events, body_count: int
) -> None:
    """List the pairs of each body, in their order: by counting."""
    starts, listed = events.queue[FIRST_OF_BODY], events.queue[CONTACT_OF_BODY]
    for i in range(body_count + 2):
        starts[i] = 0
    for p in range(broad_phase.counts[CONTACTS]):
        starts[contacts.pairs[p, SLOT_A] + 2] += 1
        starts[contacts.pairs[p, SLOT_B] + 2] += 1
    for i in range(2, body_count + 2):
        starts[i] += starts[i - 1]
    for p in range(broad_phase.counts[CONTACTS]):
        for i in (contacts.pairs[p, SLOT_A], contacts.pairs[p, SLOT_B]):
            listed[starts[i + 1]] = p
            starts[i + 1] += 1


def build_tournament(event_count: int, times: Array, queue: Integers) -> None:
    """Let all events play for being the first."""
    tournament = queue[TOURNAMENT]
    half = first_tournament_leaf(event_count)
    for k in range(half):
        tournament[half + k] = min(k, event_count - 1)
    for node in range(half - 1, 0, -1):
        tournament[node] = sooner(tournament[2 * node], tournament[2 * node + 1], times)


def update_event(event: int, event_count: int, times: Array, queue: Integers) -> None:
    """Let an event play anew, whose time is another."""
    tournament = queue[TOURNAMENT]
    node = (first_tournament_leaf(event_count) + event) // 2
    while node > 0:
        tournament[node] = sooner(tournament[2 * node], tournament[2 * node + 1], times)
        node //= 2


def sooner(one: int, other: int, times: Array) -> int:
    """Return which of two events is the first."""
    return other if times[other] < times[one] else one


def first_tournament_leaf(event_count: int) -> int:
    """Return the first leaf of a tournament of so many events."""
    half = 1
    while half < event_count:
        half *= 2
    return half
