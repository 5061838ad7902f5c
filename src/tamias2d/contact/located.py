"""The located way: follow the paths from one impact to the next (R7, R8).

Serves: `simulate`. Hides: how bodies change paths, and when they rest.
"""

import heapq
import math
from collections import Counter
from collections.abc import Callable, Iterable, Sequence

from tamias2d.contact.advance import Pair
from tamias2d.contact.core import cores_of, place
from tamias2d.contact.forecast import Forecasts
from tamias2d.contact.gap import EPSILON, slight_opening
from tamias2d.contact.instant import Hit, Instant, PairOf, Surroundings
from tamias2d.contact.manifold import Contact
from tamias2d.contact.near import Swept
from tamias2d.contact.overlap import refuse_overlap
from tamias2d.contact.refusal import UndecidedContactError, named
from tamias2d.contact.stepwise import refuse_stepwise
from tamias2d.contact.watch import Watch
from tamias2d.path import Paths, Piece
from tamias2d.scene import Scene
from tamias2d.state import Hold, State, Vector

_TRIES = 32  # new paths for a body within a few units of the last place of time


class Located:
    """The bodies of a scene under way: `go` to a time, then read `tracks` and `impacts`."""

    def __init__(self, scene: Scene, motion: Paths) -> None:
        refuse_stepwise(scene)
        self._scene = scene
        self._motion = motion
        self._cores = cores_of(scene)
        solid = [core for core in self._cores if core.solid]
        self.can_meet = len(solid) > 1 and any(core.dynamic for core in solid)
        self.time = 0.0
        self._until = 0.0
        self.tracks: list[list[Piece]] = [[] for _ in self._cores]
        """The pieces that each body has gone through, in order."""
        self.notes: tuple[str, ...] = ()
        self._hits: list[tuple[float, Hit]] = []
        self._holds: list[Hold | None] = [None for _ in self._cores]
        self._held: dict[PairOf, list[Contact]] = {}
        self._senses: dict[PairOf, int] = {}
        self._ahead: dict[PairOf, Vector] = {}
        self._resume: dict[PairOf, float] = {}
        self._version = [0 for _ in self._cores]
        self._events: list[tuple[float, int, int, int, int]] = []
        self._stuck = [0 for _ in self._cores]
        self._repeats: tuple[float, Counter[PairOf]] = (0.0, Counter())
        self._swept = Swept(self._cores)
        self._forecasts = Forecasts()
        self._approached: dict[PairOf, tuple[int, int]] = {}

    def go(self, duration: float, *, told: Callable[[float], None] = lambda _: None) -> None:
        """Go on to a time in s; `told` hears of every time that is reached.

        Raises:
            OverlapError: bodies overlap at the start.
            Refusal: what follows is not unique, or not within the models.
        """
        states = [
            State(b.position, b.orientation, b.velocity, b.angular_velocity)
            for b in self._scene.bodies
        ]
        refuse_overlap(self._cores, states)
        self._until = duration
        while self.time < duration:
            end = self._segment(states)
            while self._events and self._events[0][0] <= end:
                self._next_event(end)
                told(self.time)
            self.time = end
            states = [self._state(i) for i in range(len(self._cores))]
            told(end)

    @property
    def hits(self) -> list[tuple[float, Hit]]:
        """All impulses so far, with their times in s, in order."""
        return self._hits

    def _segment(self, states: list[State]) -> float:
        """Lay the paths of all bodies from now on, and look for what meets on them."""
        self._events.clear()
        self._resume.clear()
        end, paths = self._motion.segment(self.time, states, self._holds)
        for body, path in enumerate(paths):
            self._lay(body, path)
        for body in range(len(self._cores)):
            self._watch(body, end)
        if self.time == 0:
            self._happens(0.0, [core.index for core in self._cores if core.dynamic], end)
        self._predict(range(len(self._cores)))
        return end

    def _lay(self, body: int, path: Piece) -> None:
        """Send a body along a path."""
        self.tracks[body].append(path)
        self._version[body] += 1
        self._swept.put(body, path)

    def _refuse_stuck(self, body: int, path: Piece) -> None:
        """Refuse a body whose new paths have stopped it from getting on."""
        stuck = self.tracks[body] and self.tracks[body][-1].start >= path.start * (1 - 4 * EPSILON)
        self._stuck[body] = self._stuck[body] + 1 if stuck else 0
        if self._stuck[body] > _TRIES:
            raise UndecidedContactError(
                f"'{self._cores[body].name}' at {path.start!r} s: float64 cannot tell whether its "
                "contacts last or open (R7). End the run before, or change the scene a little.",
                time=path.start,
            )

    def _state(self, body: int) -> State:
        return self.tracks[body][-1].at(self.time)

    def _predict(self, bodies: Iterable[int]) -> None:
        """Put the next meeting of each pair with one of the bodies on the list."""
        seen = set()
        for body in bodies:
            for other in self._swept.near(body):
                pair = (min(body, other), max(body, other))
                if pair not in seen:
                    seen.add(pair)
                    self._predict_pair(pair)

    def _predict_pair(self, pair: PairOf) -> None:
        i, j = pair
        kept = self._held.get(pair, ())
        if kept and not self._bends(pair):
            return
        start = max(self._resume.get(pair, 0.0), self.time)
        end = min(self.tracks[k][-1].end for k in pair)
        meeting = self._pair(pair, kept)
        time = meeting.meets(start, end)
        if meeting.ahead:
            self._ahead[pair] = meeting.ahead
        if time is not None:
            self._put(time, i, j)

    def _pair(self, pair: PairOf, kept: Sequence[Contact]) -> Pair:
        (i, j), ahead = pair, self._ahead.get(pair)
        paths = self.tracks[i][-1], self.tracks[j][-1]
        return Pair(self._cores[i], self._cores[j], *paths, kept, ahead)

    def _bends(self, pair: PairOf) -> bool:
        return any((hold := self._holds[i]) and hold.bends for i in pair)

    def _put(self, time: float, i: int, j: int) -> None:
        heapq.heappush(self._events, (time, i, j, self._version[i], self._version[j]))

    def _next_event(self, end: float) -> None:
        time, i, j, version_i, version_j = heapq.heappop(self._events)
        if (version_i, version_j) != (self._version[i], self._version[j]):
            return
        known = i == j or self._approached.get((i, j)) == (version_i, version_j)
        if known or not self._approach(time, i, j, end):
            self._refuse_repeated(time, i, j)
            self.time = time
            self._happens(time, [i] if i == j else [i, j], end)

    def _refuse_repeated(self, time: float, i: int, j: int) -> None:
        """Refuse a pair that meets again and again at one instant, changed or not."""
        if time > self._repeats[0]:
            self._repeats = (time, Counter())
        self._repeats[1][i, j] += 1
        if self._repeats[1][i, j] > _TRIES:
            raise UndecidedContactError(
                f"{named(*(self._cores[k].name for k in dict.fromkeys((i, j))))} at {time!r} s: "
                "they meet again and again without getting on (R7). End the run before, or change "
                "the scene a little.",
                time=time,
            )

    def _approach(self, time: float, i: int, j: int, end: float) -> bool:
        """Lay better paths for a meeting, if there are any; it is then found again on them."""
        paths = self._motion.approach((i, j), time, self._path, self._holds)
        for body, path in paths.items():
            self.tracks[body].pop()
            self._lay(body, path)
        self._approached[i, j] = (self._version[i], self._version[j])
        for body in paths:
            self._watch(body, end)
        self._predict(paths)
        return bool(paths)

    def _path(self, body: int) -> Piece:
        return self.tracks[body][-1]

    def _happens(self, time: float, bodies: list[int], end: float) -> None:
        """Let an instant happen around some bodies, and lay the paths from it on."""
        world = Surroundings(
            self._cores,
            self._state,
            self._swept.near,
            lambda body, state: self._motion.free(body, time, state),
            self._held,
            [pair for pair, sense in self._senses.items() if not sense],
            self._ahead,
            self._scene.restitution,
            self._scene.friction,
            self._until,
        )
        instant = Instant(time, world, [i for i in bodies if self._cores[i].dynamic])
        self._hits += [(time, hit) for hit in instant.hits]
        self._forecasts.hear(instant)
        self._keep(instant)
        ended = {i for i in bodies if self.tracks[i][-1].end == time and time < end}
        changed = sorted(instant.changed | ended)
        for body in changed:
            self._holds[body] = instant.holds.get(body)
        paths = self._motion.restart(changed, time, instant.state, end, self._holds)
        for body, path in paths.items():
            if body in changed:
                self._refuse_stuck(body, path)
            self._lay(body, path)
        for body in paths:
            self._watch(body, end)
        self._depart(instant)
        self._predict(paths or bodies)

    def _keep(self, instant: Instant) -> None:
        """Take over which contacts last, and note those that are new."""
        for pair, touch in instant.touches.items():
            self._ahead[pair] = touch.contacts[0].normal
            if touch.staying and pair not in self._held:
                names = named(*(self._cores[i].name for i in pair))
                since = self._forecasts.rest_of(pair, instant.time)
                self.notes += (f"rest: {names} stay in contact from {since!r} s",)
            self._held.pop(pair, None)
            self._senses.pop(pair, None)
            if touch.staying:
                self._held[pair] = touch.staying
        self._senses.update(instant.senses)

    def _watch(self, body: int, end: float) -> None:
        """Put on the list when a path ends before its time, and when what holds a body does."""
        path, hold = self.tracks[body][-1], self._holds[body]
        if path.end < end:
            self._put(path.end, body, body)
        contacts = [c for pair, held in self._held.items() if body in pair for c in held]
        supports = {i: self._state(i) for c in contacts for i in (c.a, c.b) if i != body}
        if hold and not any(self._cores[i].dynamic for i in supports):
            placed = place(self._cores[body], self._state(body))
            slight = min(
                slight_opening(placed, place(self._cores[i], state), self.time, self._until)
                for i, state in supports.items()
            )
            watch = Watch(
                self._cores,
                body,
                contacts,
                supports,
                lambda time: self._motion.free(body, time, lambda i: self._path(i).at(time)),
                slight,
                (self._scene.friction, self._senses),
            )
            time = watch.ends(path, hold)
            if time is not None:
                self._put(time, body, body)

    def _depart(self, instant: Instant) -> None:
        """Find out from when on pairs that part without normal velocity are seen to be apart."""
        for pair, bend in instant.opening.items():
            meeting = self._pair(pair, instant.touches[pair].staying)
            longest = 2.0**-20 * (self._until - instant.time)
            step = min(math.sqrt(8 * instant.touches[pair].tolerance / bend), longest)
            self._resume[pair] = meeting.seen_apart(instant.time, step)
