"""What happens next in a flight, and which pairs are those of a body.

Serves: flight. Hides: that what happens first is the winner of a tournament, of which a change
plays anew one path only, and that pairs are listed by their bodies.

An event is a body that leaves its room, or after the bodies a pair that meets. Of two at the same
instant the first one counts.

Cost: for all events a pass over them, then for each change the logarithm of their number.
"""

from tamias2d.state import Array
from tamias2d.stepped.layout import OF_A, OF_B, PAIRS, Whole

# rows of the agenda: where the pairs of each body begin, these pairs, and the tournament, which has
# its winner first
STARTS_OF, PAIRS_OF, TOURNAMENT = 0, 1, 2
WINNER = 1


def list_by_body(counts: Whole, bodies: int, pair: Whole, agenda: Whole) -> None:
    """List the pairs of each body, in their order: by counting."""
    starts, listed = agenda[STARTS_OF], agenda[PAIRS_OF]
    for i in range(bodies + 2):
        starts[i] = 0
    for p in range(counts[PAIRS]):
        starts[pair[p, OF_A] + 2] += 1
        starts[pair[p, OF_B] + 2] += 1
    for i in range(2, bodies + 2):
        starts[i] += starts[i - 1]
    for p in range(counts[PAIRS]):
        for i in (pair[p, OF_A], pair[p, OF_B]):
            listed[starts[i + 1]] = p
            starts[i + 1] += 1


def play_all(events: int, times: Array, agenda: Whole) -> None:
    """Let all events play for being the first."""
    tree = agenda[TOURNAMENT]
    half = half_of(events)
    for k in range(half):
        tree[half + k] = min(k, events - 1)
    for node in range(half - 1, 0, -1):
        tree[node] = sooner(tree[2 * node], tree[2 * node + 1], times)


def play_again(event: int, events: int, times: Array, agenda: Whole) -> None:
    """Let an event play anew, whose time is another."""
    tree = agenda[TOURNAMENT]
    node = (half_of(events) + event) // 2
    while node > 0:
        tree[node] = sooner(tree[2 * node], tree[2 * node + 1], times)
        node //= 2


def sooner(one: int, other: int, times: Array) -> int:
    """Return which of two events is the first."""
    return other if times[other] < times[one] else one


def half_of(events: int) -> int:
    """Return the first leaf of a tournament of so many events."""
    half = 1
    while half < events:
        half *= 2
    return half
