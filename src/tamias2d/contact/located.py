"""A scene followed from one located impact to the next (R7, R8)."""

import math
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from itertools import chain

import numpy as np

from tamias2d.contact.active_contacts import ActiveContacts
from tamias2d.contact.body_paths import BodyPaths
from tamias2d.contact.chattering import Chattering
from tamias2d.contact.contact_loads import contact_loads
from tamias2d.contact.core import cores_of
from tamias2d.contact.event_queue import Event, EventQueue
from tamias2d.contact.follower import Follower, Memory
from tamias2d.contact.impact_search import ImpactSearch
from tamias2d.contact.instant import Instant
from tamias2d.contact.instant_inputs import InstantInputs
from tamias2d.contact.loss_search import LossSearch
from tamias2d.contact.mobility import Mobility
from tamias2d.contact.overlap import refuse_overlap
from tamias2d.contact.refusal import JointedContactError, LastingContactError, named
from tamias2d.contact.ruled_instants import RuledInstants
from tamias2d.contact.saltation import SingleImpact
from tamias2d.contact.stepping_choice import MANY
from tamias2d.contact.stepwise import refuse_stepwise
from tamias2d.contact.touching import ContactImpulse, PairOf
from tamias2d.path import PathPiece, Paths
from tamias2d.scene import Scene
from tamias2d.state import Array, ExertingConstraint, History, SharedConstraint, State
from tamias2d.work_limit import Work

_MOST_ASKED = 200  # times that contacts are decided again at one instant, as limits bounce
_REFINEMENTS = 8  # of an impact: of bodies that act on each other one may undo that of another


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
        self._alone = alone
        self._begun = False
        self.cores = cores_of(scene)
        """Of all bodies, in their order."""
        solid = [core for core in self.cores if core.solid]
        self.can_meet = len(solid) > 1 and any(core.dynamic for core in solid)
        self.time = 0.0
        self._until = 0.0
        self._impacts: list[Array] = []
        self.single: list[SingleImpact] | None = []
        """All impacts, in order; None once bodies met at several points at once, or stayed."""
        self._refined: dict[PairOf, tuple[int, int]] = {}
        self._refinements: dict[PairOf, int] = {}  # since the last event
        self._asked_at, self._asked = -1.0, 0
        bounces = [body.restitution for body in scene.bodies], scene.restitution_of_pairs.values()
        self._inelastic = not any(chain(*bounces))
        self._queue = EventQueue(len(self.cores))
        self._paths = BodyPaths(self.cores, scene.kept_apart)
        self._active = ActiveContacts(self.cores)
        self._chattering = Chattering(self.cores)
        self._ruled = RuledInstants(self.cores, most_ruled)
        self._search = ImpactSearch(self.cores, self._paths, self._active, self._queue)
        self._losses = LossSearch(self.cores, self._paths, self._active, motion, scene.friction)

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
        refuse_overlap(self.cores, states, self._scene.kept_apart)
        self._until = duration
        while self.time < duration:
            end = self._segment(states)
            while True:
                if self._may_follow(end):
                    self._follow(end, told)
                elif self._queue.next_time <= end:
                    self._next_event(end)
                    told(self.time)
                else:
                    break
            self.time = end
            states = [self._state(i) for i in range(len(self.cores))]
            told(end)

    @property
    def tracks(self) -> list[list[PathPiece]]:
        """The paths of each body so far, in order."""
        return self._paths.tracks

    def contact_loads(self, times: Array, history: History) -> Array | None:
        """Return what contacts that last exert on n bodies (k, n, 3), N and N m, at k times, s.

        None where they press nothing that joints hold. `history` are the states at the times.
        """
        if not self._active.on_joints:
            return None
        return contact_loads(self.cores, self._active, self._motion, times, history)

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
        return self._active.notes if self.ruled is None else (*self._active.notes, self.ruled)

    @property
    def ruled(self) -> str | None:
        """What was decided by rule (A18), if anything."""
        return self._ruled.note

    # -- with a follower

    def _may_follow(self, end: float) -> bool:
        """Whether there is a follower, which knows all that lasts, and whether it pays."""
        if self._follower is None or not self.time < end or not self._is_simple():
            return False
        return self._follower.pays(self.time, self._until)

    def _is_simple(self) -> bool:
        """Whether a follower knows all that lasts."""
        return self._active.are_simple() and not self._search.resume

    def _follow(self, end: float, told: Callable[[float], None]) -> None:
        """Let a follower go on, and resolve what it leaves open, while it knows all that lasts."""
        follower = self._follower
        assert follower is not None
        follower.take(self.time, self._until, self.tracks, begun=self._begun)
        follower.remember(range(len(self.cores)), self._memory())
        self._paths.follower = follower
        self._queue.drop_pairs()
        while self.time < end and self._is_simple():
            bodies = self._advance(follower, min(end, self._queue.next_time))
            told(self.time)
            if bodies is None:
                while self._queue.next_time <= self.time:
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
        self._search.keep_directions(self._active.of.keys())
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
        self._paths.take_back()
        self._take_memory(memory)
        if self.time < end and not self._may_follow(end):
            self._refuse_alone()
            self._paths.update_boxes()
            self._search.schedule(range(len(self.cores)), self.time, anew=True)

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
        stalled = dict(enumerate(self._chattering.stalled))
        return Memory(self._active.supports, self._active.rest_times.of, stalled)

    def _take_memory(self, memory: Memory) -> None:
        self._active.rest_times.of = memory.bounces
        for body, repeats in memory.stalled.items():
            self._chattering.stalled[body] = repeats

    # -- from event to event

    def _segment(self, states: list[State]) -> float:
        """Set the next paths of all bodies, and schedule the events on them."""
        self._queue.clear()
        self._search.resume.clear()
        end, paths = self._motion.segment(self.time, states, self._active.constraints)
        for body, path in enumerate(paths):
            self._set_path(body, path)
        self._schedule_ends(range(len(self.cores)), end)
        if self._may_follow(end):
            return end
        if self.time == 0:
            self._resolve_start(end)
        self._search.schedule(range(len(self.cores)), self.time)
        return end

    def _resolve_start(self, end: float) -> None:
        """Resolve the instant at which the run begins, for all bodies."""
        self._begun = True
        self._resolve_instant(0.0, [core.index for core in self.cores if core.dynamic], end)

    def _set_path(self, body: int, path: PathPiece) -> None:
        """Set the path of a body from now on."""
        self._queue.leave_path(body)
        self._paths.set_path(body, path)

    def _state(self, body: int) -> State:
        return self._paths.state(body, self.time)

    def _schedule_ends(self, bodies: Iterable[int], end: float) -> None:
        """Schedule the ends of paths before a time, s, and the changes of contacts on them."""
        for body in bodies:
            before = self._paths.path(body).end
            if before < end:
                self._queue.schedule(before, body, body)
            time = self._losses.first_loss(body, self.time, self._until)
            if time is not None:
                self._queue.schedule(time, body, body)

    def _schedule_impacts(self, bodies: Iterable[int]) -> None:
        """Schedule the impacts of bodies, unless a follower finds them."""
        if self._paths.follower is None:
            self._search.schedule(bodies, self.time)

    def _next_event(self, end: float) -> None:
        event = self._queue.pop()
        if event is None or self._refine(event, end):
            return
        time, i, j = event
        self._refinements.clear()
        self._chattering.count_event(time, i, j)
        self.time = time
        self._resolve_instant(time, self._held_with(i, j), end)

    def _held_with(self, i: int, j: int) -> list[int]:
        """Return two bodies, and all whose accelerations are found together with one of theirs."""
        found = dict.fromkeys((i, j))
        for body in (i, j):
            constraint = self._active.constraints[body]
            if isinstance(constraint, SharedConstraint):
                found |= dict.fromkeys(constraint.bodies)
        return list(found)

    def _refine(self, event: Event, end: float) -> bool:
        """Set more accurate paths for an impact, if any; it is then found again on them."""
        time, i, j = event
        known = self._refined.get((i, j)) == self._queue.versions(i, j)
        if i == j or known or self._refinements.get((i, j)) == _REFINEMENTS:
            return False
        paths = self._motion.approach((i, j), time, self._paths.path, self._active.constraints)
        for body, path in paths.items():
            self.tracks[body].pop()
            self._set_path(body, path)
        self._refined[i, j] = self._queue.versions(i, j)
        self._refinements[i, j] = self._refinements.get((i, j), 0) + 1
        self._schedule_ends(paths, end)
        self._schedule_impacts(paths)
        return bool(paths)

    def _resolve_instant(self, time: float, bodies: list[int], end: float) -> None:
        """Resolve an instant around some bodies, and set the paths after it."""
        if self._paths.follower:
            self._take_memory(self._paths.follower.recall())
        instant = self._instant(time, bodies)
        if instant.contact_impulses:
            self._impacts.append(_rows(time, instant.contact_impulses))
            met = {(contact.a, contact.b) for contact, *_ in instant.contact_impulses}
            self._work.impacts(len(met), time)
        self._note_single(instant)
        self._ruled.update(instant)
        self._active.update(instant)
        self._search.update(instant)
        ended = {i for i in bodies if self._paths.path(i).end == time and time < end}
        changed = sorted(instant.changed | ended)
        self._active.constrain(changed, instant)
        pressing = self._pressing(changed)
        before = self._motion.joint_changes(pressing, time)
        paths = self._motion.restart(changed, time, instant.state, end, self._active.constraints)
        for body, path in paths.items():
            if body in changed:
                self._chattering.count_path(body, self._paths.path(body).start, path.start)
            self._set_path(body, path)
        self._schedule_ends(paths, end)
        if before != self._motion.joint_changes(pressing, time):
            self._ask_again(time, pressing)
        self._search.resume_after(instant, self._until, paths.keys())
        self._schedule_impacts(paths or bodies)
        if self._paths.follower:
            touched = {i for pair in instant.touching_pairs for i in pair}
            self._paths.follower.remember(touched | set(changed), self._memory())

    def _pressing(self, bodies: Iterable[int]) -> list[int]:
        """Return those of some bodies on which contacts last beside joints."""
        held = self._active.constraints
        return [body for body in bodies if isinstance(held[body], ExertingConstraint)]

    def _ask_again(self, time: float, bodies: Sequence[int]) -> None:
        """Let contacts be decided again at once, as joints do something else beside them."""
        self._asked = self._asked + 1 if self._asked_at == time else 0
        self._asked_at = time
        if self._asked > _MOST_ASKED:
            raise JointedContactError(
                f"{named(*(self.cores[i].name for i in bodies))} at {time!r} s: what limits, "
                "motors or breaking joints and contacts that last do together is not found (GD20). "
                "End the run before, take method=Stepped(), or change the scene.",
                time=time,
            )
        self._chattering.forget(bodies)
        self._queue.schedule(time, bodies[0], bodies[0])

    def _note_single(self, instant: Instant) -> None:
        """Note the impacts of an instant, if each is the only thing that happens to its bodies."""
        contacts = [contact for contact, *_ in instant.contact_impulses]
        met = [i for c in contacts for i in (c.a, c.b) if self.cores[i].dynamic]
        touching = {pair for pair, touch in instant.touching_pairs.items() if touch.staying}
        if instant.time > 0:
            touching |= instant.touching_pairs.keys() - {(c.a, c.b) for c in contacts}
        if touching or instant.parted or instant.ruled or len(set(met)) < len(met):
            self.single = None
        elif self.single is not None:
            of = self._scene.restitution, self._scene.friction
            self.single += [
                SingleImpact(instant.time, c, *(law(c.a, c.b) for law in of)) for c in contacts
            ]

    def _instant(self, time: float, bodies: list[int]) -> Instant:
        """Return an instant around some bodies."""
        in_turns = self._inelastic or time == self._asked_at
        moved = partial(self._motion.moved, in_turns=in_turns)
        world = InstantInputs(
            self.cores,
            self._state,
            self._paths.near,
            lambda body, state: self._motion.free(body, time, state),
            lambda impulses: self._motion.struck(time, impulses, self._state),
            Mobility(self.cores, moved, time, self._state),
            Mobility(self.cores, self._motion.pushed, time, self._state),
            self._active.of,
            self._active.sticking,
            lambda pair: self._search.separating_direction(pair, time),
            self._scene.restitution,
            self._scene.friction,
            self._until,
            self._chattering.is_again(time, bodies),
        )
        return Instant(time, world, [i for i in bodies if self.cores[i].dynamic])


def _rows(time: float, impulses: Sequence[ContactImpulse]) -> Array:
    """Return impulses at a time, s, as `Located.impacts` has them."""
    rows = [
        (time, c.a, c.b, *c.point, *c.normal, impulse, normal_velocity)
        for c, impulse, normal_velocity in impulses
    ]
    return np.array(rows, dtype=np.float64)
