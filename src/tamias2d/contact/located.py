"""A scene followed from one located impact to the next (R7, R8)."""

import heapq
import math
from collections import Counter
from collections.abc import Callable, Iterable, Sequence

import numpy as np

from tamias2d.contact.conservative_advancement import Pair
from tamias2d.contact.contact_loss import ContactLossWatch
from tamias2d.contact.core import cores_of, place
from tamias2d.contact.coupled_constraint import CoupledConstraint
from tamias2d.contact.coupled_loss import CoupledLossWatch
from tamias2d.contact.follower import Follower, Memory
from tamias2d.contact.gap import EPSILON, slight_opening
from tamias2d.contact.instant import Instant
from tamias2d.contact.instant_inputs import InstantInputs
from tamias2d.contact.manifold import Contact
from tamias2d.contact.overlap import refuse_overlap
from tamias2d.contact.refusal import LastingContactError, UndecidedContactError, named
from tamias2d.contact.rest_time import RestTimes
from tamias2d.contact.stepping_choice import MANY
from tamias2d.contact.stepwise import refuse_stepwise
from tamias2d.contact.swept_aabb import SweptAabbs
from tamias2d.contact.touching import ContactImpulse, PairOf
from tamias2d.path import Paths, Piece
from tamias2d.scene import Scene
from tamias2d.state import Acceleration, Array, Constraint, State, Vector
from tamias2d.work_limit import Work

RULED = "rule"
"""With this a note begins that tells of what was decided by rule."""
MOST_RULED = 500
"""Instants at which contacts last, after a rule decided something, of a run whose method was not
asked for: they take some seconds, and steps through contacts far less."""
_MAX_REPEATS = 32  # new paths for a body within a few units of the last place of time


class Located:
    """A scene in simulation: `go` to a time, then read `tracks` and `impacts`."""

    def __init__(
        self,
        scene: Scene,
        motion: Paths,
        work: Work,
        follower: Follower | None = None,
        *,
        alone: bool = True,
        most_ruled: float = math.inf,
    ) -> None:
        """Take a scene, what makes the paths of its bodies, and what counts its impacts.

        A `follower` goes on from impact to impact where it can and that pays, with the same bits;
        where it must be given up and `alone` says so, the rest is done without it. Once a rule
        decided something, contacts may last at `most_ruled` more instants.
        """
        refuse_stepwise(scene)
        self._scene = scene
        self._motion = motion
        self._work = work
        self._follower = follower
        self._following: Follower | None = None
        self._alone = alone
        self._begun = False
        self._cores = cores_of(scene)
        solid = [core for core in self._cores if core.solid]
        self.can_meet = len(solid) > 1 and any(core.dynamic for core in solid)
        self.time = 0.0
        self._until = 0.0
        self.tracks: list[list[Piece]] = [[] for _ in self._cores]
        """The paths of each body so far, in order."""
        self._rests: tuple[str, ...] = ()
        self._ruled: list[tuple[float, frozenset[int]]] = []
        self._most_ruled, self._lasting_since = most_ruled, 0
        self._impacts: list[Array] = []
        self._constraints: list[Constraint | None] = [None for _ in self._cores]
        self._lasting: dict[PairOf, list[Contact]] = {}
        self._senses: dict[PairOf, int] = {}
        self._separating_direction: dict[PairOf, Vector] = {}
        self._resume: dict[PairOf, float] = {}
        self._version = [0 for _ in self._cores]
        self._events: list[tuple[float, int, int, int, int]] = []
        self._stalled = [0 for _ in self._cores]
        self._repeats: tuple[float, Counter[PairOf]] = (0.0, Counter())
        self._aabbs = SweptAabbs(self._cores, scene.kept_apart)
        self._rest_times = RestTimes()
        self._refined: dict[PairOf, tuple[int, int]] = {}

    def go(self, duration: float, *, told: Callable[[float], None] = lambda _: None) -> None:
        """Go on to a time in s; `told` hears of every time that is reached.

        Raises:
            OverlapError: bodies overlap at the start.
            Refusal: what follows is not unique, or not within the models.
            WorkLimitError: the run takes too many steps and impacts.
        """
        states = [
            State(b.position, b.orientation, b.velocity, b.angular_velocity)
            for b in self._scene.bodies
        ]
        refuse_overlap(self._cores, states, self._scene.kept_apart)
        self._until = duration
        while self.time < duration:
            end = self._segment(states)
            while True:
                if self._may_follow(end):
                    self._follow(end, told)
                elif self._events and self._events[0][0] <= end:
                    self._next_event(end)
                    told(self.time)
                else:
                    break
            self.time = end
            states = [self._state(i) for i in range(len(self._cores))]
            told(end)

    @property
    def impacts(self) -> Array:
        """All impulses so far, in order (m, 9).

        Columns: time, s; bodies A and B; point (x, y), m; normal (x, y); impulse, N s; normal
        velocity before it, m/s.
        """
        return np.concatenate([np.zeros((0, 9)), *self._impacts])

    @property
    def notes(self) -> tuple[str, ...]:
        """Which bodies came to rest on which, and what was decided by rule (A18)."""
        if not self._ruled:
            return self._rests
        (first, bodies), (last, _) = self._ruled[0], self._ruled[-1]
        names = named(*(self._cores[i].name for i in sorted(bodies)))
        when = f"at {first!r} s, {names}" if first == last else f"at {first!r} s first, {names}"
        until = "" if first == last else f", and at {last!r} s last"
        return (
            *self._rests,
            f"{RULED}: {len(self._ruled)} instants at which impacts acted on one another were "
            f"decided by A18: {when}{until}",
        )

    def _may_follow(self, end: float) -> bool:
        """Whether there is a follower, which knows all that lasts, and whether it pays."""
        if self._follower is None or not self.time < end or not self._is_simple():
            return False
        return self._follower.pays(self.time, self._until)

    def _is_simple(self) -> bool:
        """Whether all that lasts are single bodies, each on one that stands still."""
        held = [i for pair in self._lasting for i in pair if self._cores[i].dynamic]
        single = len(held) == len(self._lasting) == len(set(held))
        steady = not any(self._state_dependent(pair) for pair in self._lasting)
        return single and steady and not self._resume

    def _follow(self, end: float, told: Callable[[float], None]) -> None:
        """Let a follower go on, and resolve what it leaves open, while it knows all that lasts."""
        follower = self._follower
        assert follower is not None
        follower.take(self.time, self._until, self.tracks, begun=self._begun)
        follower.remember(range(len(self._cores)), self._memory())
        self._following = follower
        self._events = [event for event in self._events if event[1] == event[2]]
        heapq.heapify(self._events)
        while self.time < end and self._is_simple():
            bodies = self._advance(follower, min([end, *(event[0] for event in self._events)]))
            told(self.time)
            if bodies is None:
                while self._events and self._events[0][0] <= self.time:
                    self._next_event(end)
            elif bodies:
                self._resolve_instant(self.time, list(bodies), end)
            elif self._begun or self.time > 0:
                self._follower = None  # it cannot tell when a pair meets
                break
            else:  # some touch at the start
                self._resolve_start(end)
                break
        self._give_back(follower, end)

    def _advance(self, follower: Follower, limit: float) -> tuple[int, ...] | None:
        """Let a follower go on to a time, s, and count the impacts."""
        kept = self._separating_direction.keys() & self._lasting.keys()  # others may turn round
        self._separating_direction = {pair: self._separating_direction[pair] for pair in kept}
        try:
            return follower.go(limit)
        finally:
            self.time, impacts = follower.now, follower.impacts()
            fitting = self._work.fitting(impacts[:, 0])
            self._impacts.append(impacts[: fitting + 1])
            if fitting < len(impacts):
                self.time = float(impacts[fitting, 0])
                self._work.impacts(1, self.time)

    def _give_back(self, follower: Follower, end: float) -> None:
        """Take all bodies back from a follower, and go on without it where it does not."""
        memory = follower.recall()
        follower.give_back()
        self._following = None
        self._take_memory(memory)
        if self.time < end and not self._may_follow(end):
            self._refuse_alone()
            for body, track in enumerate(self.tracks):
                self._aabbs.update(body, track[-1])
            self._schedule_impacts(range(len(self._cores)), anew=True)

    def _refuse_alone(self) -> None:
        """Refuse to go on without a follower, where so it was asked."""
        if not self._alone:
            raise LastingContactError(
                f"contacts at {self.time!r} s: they last, or part too slowly, and of more than "
                f"{MANY} moving bodies impacts alone are located (R12). End the run before, take "
                "method=Stepped(), or change the scene.",
                time=self.time,
            )

    def _memory(self) -> Memory:
        """Return what is known of the bodies besides their paths."""
        supports = {
            i: j
            for pair in self._lasting
            for i, j in (pair, pair[::-1])
            if self._cores[i].dynamic and not self._cores[j].dynamic
        }
        return Memory(supports, self._rest_times.of, dict(enumerate(self._stalled)))

    def _take_memory(self, memory: Memory) -> None:
        self._rest_times.of = memory.bounces
        for body, repeats in memory.stalled.items():
            self._stalled[body] = repeats

    def _segment(self, states: list[State]) -> float:
        """Set the next paths of all bodies, and schedule the impacts on them."""
        self._events.clear()
        self._resume.clear()
        end, paths = self._motion.segment(self.time, states, self._constraints)
        for body, path in enumerate(paths):
            self._set_path(body, path)
        for body in range(len(self._cores)):
            self._schedule_contact_loss(body, end)
        if self._may_follow(end):
            return end
        if self.time == 0:
            self._resolve_start(end)
        self._schedule_impacts(range(len(self._cores)))
        return end

    def _resolve_start(self, end: float) -> None:
        """Resolve the instant at which the run begins, for all bodies."""
        self._begun = True
        self._resolve_instant(0.0, [core.index for core in self._cores if core.dynamic], end)

    def _set_path(self, body: int, path: Piece) -> None:
        """Set the path of a body from now on."""
        self._version[body] += 1
        if self._following is not None:
            self._following.set_path(body, path)
            return
        self.tracks[body].append(path)
        self._aabbs.update(body, path)

    def _refuse_stalled(self, body: int, path: Piece) -> None:
        """Refuse a body whose new paths no longer advance in time."""
        stalled = self._path(body).start >= path.start * (1 - 4 * EPSILON)
        self._stalled[body] = self._stalled[body] + 1 if stalled else 0
        if self._stalled[body] > _MAX_REPEATS:
            raise UndecidedContactError(
                f"'{self._cores[body].name}' at {path.start!r} s: float64 cannot tell whether its "
                "contacts last or open (R7). End the run before, or change the scene a little.",
                time=path.start,
            )

    def _state(self, body: int) -> State:
        return self._path(body).at(self.time)

    def _schedule_impacts(self, bodies: Iterable[int], *, anew: bool = False) -> None:
        """Schedule the next impact of each pair with one of the bodies.

        Where it is done `anew`, a search begins where it did before: with the later of two paths.
        """
        if self._following is not None:
            return
        seen = set()
        for body in bodies:
            for other in self._aabbs.overlapping(body):
                pair = (min(body, other), max(body, other))
                if pair not in seen:
                    seen.add(pair)
                    self._schedule_impact(pair, anew=anew)

    def _schedule_impact(self, pair: PairOf, *, anew: bool) -> None:
        i, j = pair
        lasting = self._lasting.get(pair, ())
        if lasting and not self._state_dependent(pair):
            return
        now = max(self.tracks[k][-1].start for k in pair) if anew else self.time
        start = max(self._resume.get(pair, 0.0), now)
        end = min(self.tracks[k][-1].end for k in pair)
        pair_search = self._pair(pair, lasting)
        time = pair_search.time_of_impact(start, end)
        if pair_search.separating_direction:
            self._separating_direction[pair] = pair_search.separating_direction
        if time is not None:
            self._schedule(time, i, j)

    def _pair(self, pair: PairOf, lasting: Sequence[Contact]) -> Pair:
        (i, j), separating_direction = pair, self._separating_direction.get(pair)
        paths = self._path(i), self._path(j)
        return Pair(self._cores[i], self._cores[j], *paths, lasting, separating_direction)

    def _state_dependent(self, pair: PairOf) -> bool:
        return any(
            (constraint := self._constraints[i]) and constraint.state_dependent for i in pair
        )

    def _schedule(self, time: float, i: int, j: int) -> None:
        heapq.heappush(self._events, (time, i, j, self._version[i], self._version[j]))

    def _next_event(self, end: float) -> None:
        time, i, j, version_i, version_j = heapq.heappop(self._events)
        if (version_i, version_j) != (self._version[i], self._version[j]):
            return
        known = i == j or self._refined.get((i, j)) == (version_i, version_j)
        if known or not self._refine(time, i, j, end):
            self._refuse_repeated(time, i, j)
            self.time = time
            self._resolve_instant(time, [i] if i == j else [i, j], end)

    def _refuse_repeated(self, time: float, i: int, j: int) -> None:
        """Refuse a pair that comes into contact again and again at one instant."""
        if time > self._repeats[0]:
            self._repeats = (time, Counter())
        self._repeats[1][i, j] += 1
        if self._repeats[1][i, j] > _MAX_REPEATS:
            raise UndecidedContactError(
                f"{named(*(self._cores[k].name for k in dict.fromkeys((i, j))))} at {time!r} s: "
                "they meet again and again without getting on (R7). End the run before, or change "
                "the scene a little.",
                time=time,
            )

    def _is_again(self, time: float, bodies: Iterable[int]) -> bool:
        """Whether bodies come into contact at an instant so often that they seem not to get on."""
        met = max(self._repeats[1].values(), default=0) if self._repeats[0] == time else 0
        return max(met, *(self._stalled[body] for body in bodies)) > _MAX_REPEATS // 2

    def _refine(self, time: float, i: int, j: int, end: float) -> bool:
        """Set more accurate paths for an impact, if any; it is then found again on them."""
        paths = self._motion.approach((i, j), time, self._path, self._constraints)
        for body, path in paths.items():
            self.tracks[body].pop()
            self._set_path(body, path)
        self._refined[i, j] = (self._version[i], self._version[j])
        for body in paths:
            self._schedule_contact_loss(body, end)
        self._schedule_impacts(paths)
        return bool(paths)

    def _path(self, body: int) -> Piece:
        if self._following is not None:
            return self._following.path(body)
        return self.tracks[body][-1]

    def _resolve_instant(self, time: float, bodies: list[int], end: float) -> None:
        """Resolve an instant around some bodies, and set the paths after it."""
        if self._following is not None:
            self._take_memory(self._following.recall())
        world = InstantInputs(
            self._cores,
            self._state,
            self._near,
            lambda body, state: self._motion.free(body, time, state),
            lambda impulses: self._motion.struck(time, impulses, self._state),
            self._lasting,
            [pair for pair, sense in self._senses.items() if not sense],
            self._separating_direction,
            self._scene.restitution,
            self._scene.friction,
            self._until,
            self._is_again(time, bodies),
        )
        instant = Instant(time, world, [i for i in bodies if self._cores[i].dynamic])
        if instant.contact_impulses:
            self._impacts.append(_rows(time, instant.contact_impulses))
            self._work.impacts(len(instant.contact_impulses), time)
        if instant.ruled:
            self._ruled.append((time, frozenset(instant.ruled)))
        self._refuse_many(instant)
        self._rest_times.update(instant)
        self._update_lasting(instant)
        ended = {i for i in bodies if self._path(i).end == time and time < end}
        changed = sorted(instant.changed | ended)
        for body in changed:
            self._constraints[body] = instant.constraints.get(body)
        paths = self._motion.restart(changed, time, instant.state, end, self._constraints)
        for body, path in paths.items():
            if body in changed:
                self._refuse_stalled(body, path)
            self._set_path(body, path)
        for body in paths:
            self._schedule_contact_loss(body, end)
        self._schedule_resumption(instant)
        self._schedule_impacts(paths or bodies)
        if self._following is not None:
            touched = {i for pair in instant.touching_pairs for i in pair}
            self._following.remember(touched | set(changed), self._memory())

    def _refuse_many(self, instant: Instant) -> None:
        """Refuse to go on by rule through more instants with lasting contacts than are worth it."""
        coupled = any(isinstance(each, CoupledConstraint) for each in instant.constraints.values())
        lasts = any(touch.staying for touch in instant.touching_pairs.values())
        if self._ruled or self._lasting_since or coupled:
            self._lasting_since += lasts
        if self._lasting_since > self._most_ruled:
            names = named(*(self._cores[i].name for i in sorted(instant.changed)))
            raise LastingContactError(
                f"{names} at {instant.time!r} s: contacts have changed {self._most_ruled} times "
                "since a rule decided them (A18). End the run before, take method=ClosedForm(), "
                "which goes on, or method=Stepped(), which is quick.",
                time=instant.time,
            )

    def _near(self, body: int) -> list[int]:
        """Return the bodies that may touch a body now."""
        if self._following is not None:
            return self._following.near(body)
        return self._aabbs.overlapping(body)

    def _named(self, pair: PairOf) -> str:
        return named(*(self._cores[i].name for i in pair))

    def _update_lasting(self, instant: Instant) -> None:
        """Replace the lasting contacts by those of an instant, and note the new ones."""
        before = {self._named(pair) for pair in self._lasting}
        for pair in instant.parted:
            self._lasting.pop(pair, None)
            self._senses.pop(pair, None)
        for pair, touch in instant.touching_pairs.items():
            self._separating_direction[pair] = touch.contacts[0].normal
            names = self._named(pair)
            if touch.staying and names not in before:
                before.add(names)  # a chain may have more pieces that it touches
                since = self._rest_times.time_of(pair, instant.time)
                self._rests += (f"rest: {names} stay in contact from {since!r} s",)
            self._lasting.pop(pair, None)
            self._senses.pop(pair, None)
            if touch.staying:
                self._lasting[pair] = touch.staying
        self._senses.update(instant.senses)

    def _schedule_contact_loss(self, body: int, end: float) -> None:
        """Schedule the end of a path before its time, and the loss of the contacts of a body."""
        path, constraint = self._path(body), self._constraints[body]
        if path.end < end:
            self._schedule(path.end, body, body)
        if isinstance(constraint, CoupledConstraint):
            if body == constraint.bodies[0]:
                self._schedule_coupled_loss(constraint)
            return
        contacts = [c for pair, lasting in self._lasting.items() if body in pair for c in lasting]
        supports = {i: self._state(i) for c in contacts for i in (c.a, c.b) if i != body}
        if constraint and not any(self._cores[i].dynamic for i in supports):
            placed = place(self._cores[body], self._state(body))
            slight = min(
                slight_opening(placed, place(self._cores[i], state), self.time, self._until)
                for i, state in supports.items()
            )
            watch = ContactLossWatch(
                self._cores,
                body,
                contacts,
                supports,
                lambda time: self._motion.free(body, time, lambda i: self._path(i).at(time)),
                slight,
                (self._scene.friction, self._senses),
            )
            time = watch.first_loss(path, constraint)
            if time is not None:
                self._schedule(time, body, body)

    def _schedule_coupled_loss(self, constraint: CoupledConstraint) -> None:
        """Schedule the change of the contacts of several moving bodies."""
        held = set(constraint.bodies)
        contacts = [c for pair, own in self._lasting.items() if held & set(pair) for c in own]
        paths = {i: self._path(i) for i in sorted(held | {i for c in contacts for i in (c.a, c.b)})}

        def free(body: int, time: float) -> Acceleration:
            return self._motion.free(body, time, lambda i: self._path(i).at(time))

        watch = CoupledLossWatch(self._cores, constraint, contacts, paths, free)
        time = watch.first_loss()
        if time is not None:
            self._schedule(time, constraint.bodies[0], constraint.bodies[0])

    def _schedule_resumption(self, instant: Instant) -> None:
        """Find from when on pairs that separate without normal velocity are resolved as apart."""
        struck = {i for c, *_ in instant.contact_impulses for i in (c.a, c.b)}
        struck = {i for i in struck if self._cores[i].dynamic}
        for pair in [pair for pair in self._resume if set(pair) & struck]:
            del self._resume[pair]  # it was found on paths that are no more
        for pair, acceleration in instant.separating.items():
            pair_search = self._pair(pair, instant.touching_pairs[pair].staying)
            longest = 2.0**-20 * (self._until - instant.time)
            step = min(
                math.sqrt(8 * instant.touching_pairs[pair].tolerance / acceleration), longest
            )
            self._resume[pair] = pair_search.separation_time(instant.time, step, acceleration)


def _rows(time: float, impulses: Sequence[ContactImpulse]) -> Array:
    """Return impulses at a time, s, as `Located.impacts` has them."""
    rows = [
        (time, c.a, c.b, *c.point, *c.normal, impulse, normal_velocity)
        for c, impulse, normal_velocity in impulses
    ]
    return np.array(rows, dtype=np.float64)
