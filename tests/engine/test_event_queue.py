"""The event that comes first, and the contacts of each body, against looking at everything."""

import numpy as np
from hypothesis import given, strategies as st
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.world import Capacities, allocated
from tamias2d.engine.continuous.event_queue import (
    NO_EVENT,
    build_queue,
    first_event,
    list_contacts_by_body,
    update_event,
)
from tamias2d.engine.tables import Contacts

TIMES = st.sampled_from([0.0, 0.25, 0.5, 1.0, 2.0])


@given(st.lists(TIMES, min_size=1, max_size=40), st.lists(st.tuples(st.integers(0, 39), TIMES)))
def test_the_first_of_the_soonest_events_comes_first_after_each_change(
    start: list[float], changes: list[tuple[int, float]]
) -> None:
    """Whatever places are noted of events of an earlier step."""
    times, queue = np.array(start), np.full((4, 2 * len(start) + 2), 3, np.int32)
    build_queue(len(times), times, queue)
    assert first_event(queue) == wanted(times)
    for event, time in changes:
        times[event % len(times)] = time
        update_event(event % len(times), times, queue)
        assert first_event(queue) == wanted(times)


def wanted(times: NDArray[np.float64]) -> int:
    """Return the first of the soonest events, if it comes in this step."""
    return int(np.argmin(times)) if times.min() <= 1.0 else NO_EVENT


@given(st.integers(2, 12), st.data())
def test_each_body_has_its_contacts_in_their_order(bodies: int, data: st.DataObject) -> None:
    one = st.integers(0, bodies - 1)
    drawn = data.draw(st.lists(st.tuples(one, one).filter(lambda p: p[0] != p[1]), max_size=30))
    pairs = np.zeros((len(drawn), 4), np.uint32)
    for p, both in enumerate(drawn):
        pairs[p, tb.SLOT_A], pairs[p, tb.SLOT_B] = both
    broad_phase = allocated(Capacities()).broad_phase
    broad_phase.counts[tb.CONTACTS] = len(drawn)
    rows = np.zeros((len(drawn), 0))
    contacts = Contacts(pairs, rows, rows, rows.astype(np.int32))
    queue = np.zeros((4, 2 * (bodies + len(pairs)) + 2), np.int32)
    events = allocated(Capacities()).events._replace(queue=queue)
    list_contacts_by_body(broad_phase, contacts, events, bodies)
    for i in range(bodies):
        listed = queue[
            tb.CONTACT_OF_BODY, queue[tb.FIRST_OF_BODY, i] : queue[tb.FIRST_OF_BODY, i + 1]
        ]
        assert listed.tolist() == [p for p, both in enumerate(drawn) if i in both]
