"""The located way: follow the paths from one impact to the next (R7, R8)."""

import heapq
import math
from collections.abc import Callable, Collection, Iterable, Sequence

import numpy as np

from tamias2d.contact.advance import Pair
from tamias2d.contact.core import Core, place
from tamias2d.contact.forecast import Forecasts
from tamias2d.contact.gap import axes, resolution
from tamias2d.contact.instant import Hit, Instant, PairOf, Surroundings
from tamias2d.contact.manifold import Contact
from tamias2d.contact.near import Swept
from tamias2d.contact.path import Motion, Piece
from tamias2d.contact.refusal import OverlapError, named
from tamias2d.contact.release import Support
from tamias2d.scene import Scene
from tamias2d.scene.acting import groups, timed_loads, varying_loads
from tamias2d.state import Acceleration, Array, Hold, State


class Located:
    """The bodies of a scene under way: `go` to a time, then read `tracks` and `impacts`."""

    def __init__(self, scene: Scene, motion: Motion) -> None:
        self._scene = scene
        self._motion = motion
        self._cores = [Core(i, body) for i, body in enumerate(scene.bodies)]
        solid = [core for core in self._cores if core.solid]
        self.can_meet = len(solid) > 1 and any(core.dynamic for core in solid)
        self.time = 0.0
        self.tracks: list[list[Piece]] = [[] for _ in self._cores]
        """The pieces that each body has gone through, in order."""
        self.notes: tuple[str, ...] = ()
        self._hits: list[tuple[float, Hit]] = []
        self._holds: list[Hold | None] = [None for _ in self._cores]
        self._held: dict[PairOf, list[Contact]] = {}
        self._resume: dict[PairOf, float] = {}
        self._approached: dict[PairOf, tuple[int, int]] = {}
        self._version = [0 for _ in self._cores]
        self._events: list[tuple[float, int, int, int, int]] = []
        self._swept = Swept(self._cores)
        self._forecasts = Forecasts()
        self._varying = varying_loads(scene)
        self._timed = timed_loads(scene)
        self._group_of = {i: group for group in groups(scene) for i in group}

    def go(self, duration: float, *, told: Callable[[float], None] = lambda time: None) -> None:
        """Go on to a time in s; `told` hears of every time that is reached.

        Raises:
            OverlapError: bodies overlap at the start.
            Refusal: what follows is not unique, or not within the models.
        """
        states = [
            State(b.position, b.orientation, b.velocity, b.angular_velocity)
            for b in self._scene.bodies
        ]
        self._refuse_overlap(states)
        while self.time < duration:
            end = self._segment(states)
            while self._events and self._events[0][0] <= end:
                self._next_event(end)
                told(self.time)
            self.time = end
            states = [self._state(i) for i in range(len(self._cores))]
            told(end)

    def impacts(self) -> dict[str, Array]:
        """Return what the run's `Impacts` hold."""
        hits = [(time, *hit) for time, hit in self._hits]
        return {
            "time": np.array([time for time, *_ in hits]),
            "bodies": np.array([(c.a, c.b) for _, c, *_ in hits], dtype=np.int64).reshape(-1, 2),
            "point": np.array([c.point for _, c, *_ in hits]).reshape(-1, 2),
            "normal": np.array([c.normal for _, c, *_ in hits]).reshape(-1, 2),
            "impulse": np.array([impulse for *_, impulse, _ in hits]),
            "normal_velocity": np.array([rate for *_, rate in hits]),
        }

    def _segment(self, states: list[State]) -> float:
        """Lay the paths of all bodies from now on, and look for what meets on them."""
        self._events.clear()
        self._resume.clear()
        end, paths = self._motion.segment(self.time, states, self._holds)
        for body, path in enumerate(paths):
            self._lay(body, path)
        if self.time == 0:
            self._happens(0.0, [core.index for core in self._cores if core.dynamic], end)
        self._predict(range(len(self._cores)))
        self._watch(range(len(self._cores)), end)
        return end

    def _lay(self, body: int, path: Piece) -> None:
        self.tracks[body].append(path)
        self._version[body] += 1
        self._swept.put(body, path)

    def _state(self, body: int) -> State:
        return self.tracks[body][-1].at(self.time)

    def _predict(self, bodies: Iterable[int]) -> None:
        """Put the next meeting of each pair with one of the bodies on the list."""
        seen = set()
        for body in bodies:
            for other in self._swept.near(body):
                pair = (min(body, other), max(body, other))
                if pair not in seen and pair not in self._held:
                    seen.add(pair)
                    self._predict_pair(pair)

    def _predict_pair(self, pair: PairOf) -> None:
        i, j = pair
        path_i, path_j = self.tracks[i][-1], self.tracks[j][-1]
        start = self._resume.get(pair, self.time)
        end = min(path_i.end, path_j.end)
        time = Pair(self._cores[i], self._cores[j], path_i, path_j).meets(start, end)
        if time is not None:
            heapq.heappush(self._events, (time, i, j, self._version[i], self._version[j]))

    def _watch(self, bodies: Iterable[int], end: float, decided: Collection[int] = ()) -> None:
        """Put the end of each held body's contacts on the list, if its loads vary."""
        for body in bodies:
            if body not in self._varying or self._holds[body] is None:
                continue
            contacts = [c for pair, held in self._held.items() if body in pair for c in held]
            if sum(self._cores[i].dynamic for i in {i for c in contacts for i in (c.a, c.b)}) > 1:
                continue  # in equilibrium with others, which lasts
            support = Support(self._cores, body, contacts, self._state_at, self._free)
            time = support.ends(self.time, end, decided=body in decided)
            if time is not None and time < end:  # what ends there is for the next segment
                i, j = contacts[0].a, contacts[0].b
                heapq.heappush(self._events, (time, i, j, self._version[i], self._version[j]))

    def _state_at(self, body: int, time: float) -> State:
        return self.tracks[body][-1].at(time)

    def _free(self, body: int, time: float) -> Acceleration:
        return self._motion.free(body, time, lambda i: self._state_at(i, time))

    def _steady(self, bodies: Sequence[int], resting: bool) -> bool:
        """Whether loads stay: they do not vary, or only with the state of these bodies at rest."""
        return all(
            body not in self._varying
            or (resting and body not in self._timed and set(self._group_of[body]) <= set(bodies))
            for body in bodies
        )

    def _next_event(self, end: float) -> None:
        time, i, j, version_i, version_j = heapq.heappop(self._events)
        if (version_i, version_j) != (self._version[i], self._version[j]):
            return
        if self._approached.get((i, j)) == (version_i, version_j) or not self._approach(time, i, j):
            self.time = time
            self._happens(time, [i, j], end)

    def _approach(self, time: float, i: int, j: int) -> bool:
        """Lay better paths for a meeting, if there are any; it is then found again on them."""
        paths = self._motion.approach((i, j), time, lambda k: self.tracks[k][-1], self._holds)
        for body, path in paths.items():
            self.tracks[body].pop()
            self._lay(body, path)
        self._approached[i, j] = (self._version[i], self._version[j])
        self._predict(paths)
        return bool(paths)

    def _happens(self, time: float, bodies: list[int], end: float) -> None:
        """Let an instant happen around some bodies, and lay the paths from it on."""
        world = Surroundings(
            self._cores,
            self._state,
            self._swept.near,
            lambda body, state: self._motion.free(body, time, state),
            self._held.__contains__,
            self._scene.restitution,
            self._steady,
        )
        instant = Instant(time, world, [i for i in bodies if self._cores[i].dynamic])
        self._hits += [(time, hit) for hit in instant.hits]
        self._forecasts.hear(instant)
        for touch in instant.touches.values():
            if touch.staying and touch.pair not in self._held:
                names = named(*(self._cores[i].name for i in touch.pair))
                since = self._forecasts.rest_of(touch.pair, time)
                self.notes += (f"rest: {names} stay in contact from {since!r} s",)
            self._held.pop(touch.pair, None)
            if touch.staying:
                self._held[touch.pair] = touch.staying
        for body in instant.changed:
            self._holds[body] = instant.holds.get(body)
        paths = self._motion.restart(sorted(instant.changed), time, instant.state, end, self._holds)
        for body, path in paths.items():
            self._lay(body, path)
        self._depart(instant)
        self._predict(paths or bodies)
        self._watch(paths, end, decided=instant.changed)

    def _depart(self, instant: Instant) -> None:
        """Find out from when on pairs that part without normal velocity are seen to be apart."""
        for pair, bend in instant.opening.items():
            tolerance = instant.touches[pair].tolerance
            if self._varying.keys() & set(pair):
                self._resume[pair] = self._apart(pair, 4 * tolerance)
                continue
            step = math.sqrt(8 * tolerance / bend)
            self._resume[pair] = min(instant.time + step, self._end(pair))

    def _end(self, pair: PairOf) -> float:
        return min(self.tracks[i][-1].end for i in pair)

    def _apart(self, pair: PairOf, distance: float) -> float:
        """Return a time in s at which a pair that parts ever faster is a distance in m apart."""
        end = self._end(pair)
        step = 1e-6 * (end - self.time)
        while self.time + step < end:
            a, b = (place(self._cores[i], self._state_at(i, self.time + step)) for i in pair)
            if max(axis.gap for axis in axes(a, b)) > distance:
                return self.time + step
            step *= 2
        return end

    def _refuse_overlap(self, states: list[State]) -> None:
        placed = [place(core, state) for core, state in zip(self._cores, states, strict=True)]
        for a in placed:
            for b in placed[a.core.index + 1 :]:
                if not (a.core.solid and b.core.solid and (a.core.dynamic or b.core.dynamic)):
                    continue
                gap = max(axis.gap for axis in axes(a, b))
                if gap < -resolution(a, b, 0.0):
                    raise OverlapError(
                        f"{named(a.core.name, b.core.name)}: they overlap by {-gap:.6g} m at the "
                        "start: bodies must not (R4). Move them apart."
                    )
