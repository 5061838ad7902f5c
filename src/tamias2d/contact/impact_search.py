"""The search for the next impacts of pairs on their paths (IM4)."""

import math
from collections.abc import Collection, Iterable, Sequence

from tamias2d.contact.active_contacts import ActiveContacts
from tamias2d.contact.body_paths import BodyPaths
from tamias2d.contact.conservative_advancement import Pair
from tamias2d.contact.core import Core
from tamias2d.contact.event_queue import EventQueue
from tamias2d.contact.instant import Instant
from tamias2d.contact.manifold import Contact
from tamias2d.contact.touching import PairOf
from tamias2d.state import Vector


class ImpactSearch:
    """Schedules the impacts of pairs that may meet."""

    def __init__(
        self, cores: Sequence[Core], paths: BodyPaths, active: ActiveContacts, queue: EventQueue
    ) -> None:
        self._cores = cores
        self._paths = paths
        self._active = active
        self._queue = queue
        self._apart: dict[PairOf, list[tuple[float, Vector]]] = {}
        self.resume: dict[PairOf, float] = {}
        """From when on pairs that separate without normal velocity are resolved as apart, s."""

    def schedule(self, bodies: Iterable[int], now: float, *, anew: bool = False) -> None:
        """Schedule the next impact, from now on, of each pair with one of the bodies.

        Where it is done `anew`, a search begins where it did before: with the later of two paths.
        """
        seen = set()
        for body in bodies:
            for other in self._paths.near(body):
                pair = (min(body, other), max(body, other))
                if pair not in seen:
                    seen.add(pair)
                    later = max(self._paths.tracks[k][-1].start for k in pair) if anew else now
                    self._schedule_pair(pair, later)

    def _schedule_pair(self, pair: PairOf, now: float) -> None:
        lasting = self._active.of.get(pair, ())
        if lasting and not self._active.state_dependent(pair):
            return
        start = max(self.resume.get(pair, 0.0), now)
        end = min(self._paths.tracks[k][-1].end for k in pair)
        search = self._pair(pair, lasting, now)
        time = search.time_of_impact(start, end)
        before = [known for known in self._apart.get(pair, ()) if known[0] <= now]
        if search.apart:
            self._apart[pair] = before[-1:] + search.apart
        if time is not None:
            self._queue.schedule(time, *pair)

    def separating_direction(self, pair: PairOf, now: float) -> Vector | None:
        """Return the direction in which a pair was last apart before a time, s, if that is known.

        A search looks far ahead: where a pair is apart later on, it need not be so now.
        """
        known = [direction for time, direction in self._apart.get(pair, ()) if time <= now]
        return known[-1] if known else None

    def update(self, instant: Instant) -> None:
        """Note in which directions pairs that touch at an instant leave one another."""
        for pair, touch in instant.touching_pairs.items():
            self._apart[pair] = [(instant.time, touch.contacts[0].normal)]

    def keep_directions(self, pairs: Collection[PairOf]) -> None:
        """Forget the directions of all but some pairs, which may turn round."""
        self._apart = {pair: self._apart[pair] for pair in self._apart.keys() & pairs}

    def resume_after(self, instant: Instant, until: float, moved: Collection[int]) -> None:
        """Find from when on pairs that separate without normal velocity are resolved as apart.

        What was found for bodies that have `moved` to other paths holds no more.
        """
        for pair in [pair for pair in self.resume if not set(pair).isdisjoint(moved)]:
            del self.resume[pair]
        for pair, acceleration in instant.separating.items():
            touch = instant.touching_pairs[pair]
            longest = 2.0**-20 * (until - instant.time)
            step = min(math.sqrt(8 * touch.tolerance / acceleration), longest)
            search = self._pair(pair, touch.staying, instant.time)
            self.resume[pair] = search.separation_time(
                instant.time, step, acceleration, touch.contacts
            )

    def _pair(self, pair: PairOf, lasting: Sequence[Contact], now: float) -> Pair:
        (i, j), direction = pair, self.separating_direction(pair, now)
        paths = self._paths.path(i), self._paths.path(j)
        return Pair(self._cores[i], self._cores[j], *paths, lasting, direction)
