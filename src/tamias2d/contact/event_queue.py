"""The queue of the events to come: impacts of pairs, ends of paths, changes of contacts.

An event that was found on a path that its body has left is void.
"""

import heapq
import math

Event = tuple[float, int, int]
"""Its time, s, and its two bodies, which are one where it is about one path."""


class EventQueue:
    """Events of n bodies, in order of time."""

    def __init__(self, count: int) -> None:
        self._versions = [0] * count  # of the paths of bodies
        self._events: list[tuple[float, int, int, int, int]] = []

    @property
    def next_time(self) -> float:
        """When the next event is, s; infinite where there is none."""
        return self._events[0][0] if self._events else math.inf

    def schedule(self, time: float, i: int, j: int) -> None:
        """Add an event of the paths that two bodies have now."""
        heapq.heappush(self._events, (time, i, j, *self.versions(i, j)))

    def pop(self) -> Event | None:
        """Take the next event out, and return it unless it is void."""
        time, i, j, *versions = heapq.heappop(self._events)
        return (time, i, j) if tuple(versions) == self.versions(i, j) else None

    def versions(self, i: int, j: int) -> tuple[int, int]:
        """Return numbers that tell the paths of two bodies from those before and after them."""
        return self._versions[i], self._versions[j]

    def leave_path(self, body: int) -> None:
        """Make all events of a body void."""
        self._versions[body] += 1

    def drop_pairs(self) -> None:
        """Drop all events of two bodies."""
        self._events = [event for event in self._events if event[1] == event[2]]
        heapq.heapify(self._events)

    def clear(self) -> None:
        """Drop all events."""
        self._events.clear()
