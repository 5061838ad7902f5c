"""A mechanism whose joints have limits, motors or springs, or break (GD21, GD22, GD23, DD64, DD65).

Between two instants it is a mechanism like others, with a row more for each limit that holds and
each motor that keeps its speed.
"""

from bisect import bisect_left
from collections.abc import Mapping, Sequence
from itertools import count
from typing import Literal

import numpy as np

from tamias2d.generated import definitions
from tamias2d.motion.bounded_least import bounded_sum
from tamias2d.motion.constraint_rows import ConstraintRows
from tamias2d.motion.joint_code import JointCode, JointCodes, Pushes
from tamias2d.motion.joint_events import (
    BREAKS,
    STRIKES,
    JointEvent,
    Mode,
    Of,
    Timeline,
    changes,
    mode_at,
)
from tamias2d.motion.joint_instant import SLIGHT, Cause, Now, Side
from tamias2d.motion.joint_loads import Exerted, add_exerted
from tamias2d.motion.mechanism import JointError, Mechanism
from tamias2d.scene import Freedom, Scene
from tamias2d.scene.joints import Joint
from tamias2d.state import Array

Pusher = tuple[Literal["limit"], Side] | tuple[Literal["motor"], Of]


class LimitHeldError(JointError):
    """Impulses of either sign on a mechanism of which a limit holds: it answers some alone."""

    def __init__(self, name: str, time: float) -> None:
        super().__init__(
            f"joint '{name}' at {time!r} s: it is at its limit while bodies of its mechanism rub "
            "or meet together and something bounces, which is not solved yet (R13). End the run "
            "before, or take method=Stepped()."
        )
        self.time = time


class LimitedMechanism:
    """The joints of some bodies that they connect, and what they do at each time."""

    def __init__(
        self,
        scene: Scene,
        joints: Sequence[Joint],
        bodies: Sequence[int],
        timeline: Timeline,
    ) -> None:
        """Take the joints, the moving bodies in the order of their coordinates, and the events."""
        self._scene = scene
        self.joints = tuple(joints)
        self.bodies = tuple(bodies)
        place = {joint.name: k for k, joint in enumerate(scene.joints)}
        self._joint = {place[joint.name]: joint for joint in joints}
        self._timeline = timeline
        self._own = frozenset(self._joint)
        self._modes = timeline.modes(self._own)
        self._cause: Cause | None = None
        self.stepped_from = -np.inf
        """The start of the step that is taken, s: what joints did before is over for all its parts,
        also for those of Yoshida's that go back in time."""
        self.freedoms: dict[Of, Freedom] = {
            (number, k): each
            for number, joint in self._joint.items()
            for k, each in enumerate(joint.freedoms)
        }
        row_of = {body: k for k, body in enumerate(bodies)}
        measures = [self._joint[of[0]].measured(each, 0.0) for of, each in self.freedoms.items()]
        self.measures = ConstraintRows(scene, measures, row_of)
        first = {joint: rows[0] for joint, rows, _ in self.measures.of_joints()}
        self.row = {of: first[k] for k, of in enumerate(self.freedoms)}
        """The row of each freedom among the measures."""
        targets = [number for number, joint in self._joint.items() if joint.kind == "target"]
        self._pair = {(number, k): (number, 1 - k) for number in targets for k in (0, 1)}
        """Of each travel of a target the other one."""
        self.fastest = np.zeros(len(self.freedoms))
        """The largest speeds that have made up the rate of each, m/s or rad/s."""
        self._largest = 0.0
        self.noise = np.zeros(len(self.freedoms))
        """How large a rate counted as none where it last began."""
        self.inverse = np.array(
            [
                (body.inverse_mass, body.inverse_mass, body.inverse_inertia)
                for body in (scene.bodies[k] for k in bodies)
            ]
        )
        """Inverse masses and inertias (n, 3) of the bodies."""
        self._whole = Mechanism(scene, joints, bodies)
        self._known: dict[Mode, Mechanism] = {}
        self._codes: JointCodes | None = None

    def mode(self, time: float) -> Mode:
        """Return what its joints do at a time in s."""
        return mode_at(self._modes, time)

    def broken_before(self, time: float) -> frozenset[int]:
        """Return the joints that had broken before a time in s."""
        k = bisect_left(self._modes, time, key=lambda entry: entry[0])
        return self._modes[k - 1][1].broken if k else frozenset()

    def within(self, mode: Mode) -> Mechanism:
        """Return the mechanism that it is in a mode."""
        if mode not in self._known:
            joints = [self._joint[number] for number in self._kept(mode)]
            for of, side in sorted(mode.held):
                joint = self._joint[of[0]]
                joints.append(joint.measured(self.freedoms[of], self.end(of, side, mode)))
            speeds: dict[int, float] = {}
            for of in self._keeping(mode):
                speeds[len(joints)] = self.motor_speed(of)
                joints.append(self._joint[of[0]].measured(self.freedoms[of], 0.0))
            self._known[mode] = Mechanism(
                self._scene, joints, self.bodies, speeds=speeds, like=self.joints,
                pulled=lambda *now: self.pulled(Now(*now), mode),
            )  # fmt: skip
            if self._codes:
                kinds = {joint.functions.name for joint in self.joints if joint.rigid}
                self._known[mode].take_code(
                    self._codes, self._pushing(mode),
                    kinds=frozenset(kinds | {each.measure for each in self.freedoms.values()}),
                    pushed=frozenset(self.freedoms[of].measure for of in self._may_push()),
                )  # fmt: skip
        return self._known[mode]

    def code_at(self, time: float) -> JointCode | None:
        """Return what finds reactions and places faster from a time in s on, if anything does.

        Nothing does where only what joints exert tells how its mode ends.
        """
        mode = self.mode(time)
        return self.within(mode).code if self.is_measured(mode) else None

    def is_measured(self, mode: Mode) -> bool:
        """Return whether measures tell where a mode ends: nothing that may give way holds.

        Not so a distance that may turn around at its shortest.
        """
        may_slip = any(np.isfinite(self.most(of)) for of in self._keeping(mode))
        turns = any(
            side < 0 and self.freedoms[of].measure == "distance" for of, side in self.sides(mode)
        )
        return not (mode.held or may_slip or turns or self.breaking(mode))

    def take_code(self, codes: JointCodes) -> None:
        """Let code find reactions and places, in each mode."""
        self._codes = codes
        self._known.clear()

    def _may_push(self) -> list[Of]:
        """Return the freedoms with a spring, or with a motor that may slip."""
        return [
            of for of, each in self.freedoms.items() if each.spring or np.isfinite(self.most(of))
        ]

    def _pushing(self, mode: Mode) -> Pushes | None:
        """Return what springs and slipping motors exert in a mode."""
        driven = dict(mode.driven)
        laws: list[tuple[float, ...]] = []
        measures: list[Joint] = []
        for of in self._may_push():
            each, sense = self.freedoms[of], driven.get(of, 0)
            spring = each.spring
            if of[0] in mode.broken or not (spring or sense):
                continue
            law = (spring.stiffness, spring.rest or 0.0, spring.damping) if spring else (0.0,) * 3
            constant = sense * self.most(of) if sense else 0.0
            most = (spring.maximum or 0.0) if spring else 0.0
            way = self._pair[of][1] - of[1] if of in self._pair else 0
            laws.append((*law, constant, most, way))
            measures.append(self._joint[of[0]].measured(each, 0.0))
        if not measures:
            return None
        row_of = {body: k for k, body in enumerate(self.bodies)}
        return Pushes(rows=ConstraintRows(self._scene, measures, row_of), laws=np.array(laws))

    def parts(self, mode: Mode) -> tuple[Mechanism, list[int]]:
        """Return the mechanism of a mode, and for each of its joints the index in the scene."""
        numbers = [*self._kept(mode), *(of[0] for of, _ in sorted(mode.held))]
        return self.within(mode), [*numbers, *(of[0] for of in self._keeping(mode))]

    def _kept(self, mode: Mode) -> list[int]:
        return [k for k, joint in self._joint.items() if joint.rigid and k not in mode.broken]

    def _keeping(self, mode: Mode) -> list[Of]:
        return [of for of, sense in mode.driven if not sense and of[0] not in mode.broken]

    def end(self, of: Of, side: int, mode: Mode) -> float:
        """Return where a limit is, rad or m; endless where there is none."""
        each = self.freedoms[of]
        if each.pitch is not None and side < 0:
            return dict(mode.teeth).get(of, -np.inf)
        value = None
        if each.limits is not None:
            value = each.limits.lower if side < 0 else each.limits.upper
        return side * np.inf if value is None else value

    def sides(self, mode: Mode) -> list[Side]:
        """Return the limits that there are."""
        return [
            (of, side)
            for of, each in self.freedoms.items()
            if each.limits and of[0] not in mode.broken
            for side in (-1, 1)
            if np.isfinite(self.end(of, side, mode))
        ]

    def grow(self, positions: Array) -> None:
        """Note how large it is (k, n, 3) between two events: at one its places may be the same."""
        self._largest = max(self._largest, *map(self._whole.extent, positions))

    def length(self, position: Array) -> float:
        """Return a length that is not small, m: of the mechanism, now or where it was largest."""
        return max(self._largest, self._whole.extent(position)) or 1.0

    def slight(self, of: Of, position: Array) -> float:
        """Return how near a limit counts as touched, rad or m."""
        angle = self.freedoms[of].measure == "angle"
        return SLIGHT * (1.0 if angle else self.length(position))

    def motor_speed(self, of: Of) -> float:
        """Return the speed of a motor, rad/s or m/s; 0 where there is none."""
        motor = self.freedoms[of].motor
        return motor.speed if motor else 0.0

    def most(self, of: Of) -> float:
        """Return the most that a motor exerts, N m or N."""
        motor = self.freedoms[of].motor
        return np.inf if motor is None or motor.maximum is None else motor.maximum

    def breaking(self, mode: Mode) -> Mapping[int, Joint]:
        """Return the joints that may yet break, by their indices in the scene."""
        return {k: j for k, j in self._joint.items() if j.breaks and k not in mode.broken}

    # --- what a mechanism is asked -------------------------------------------------------------

    def accelerations(self, time: float, position: Array, velocity: Array, free: Array) -> Array:
        """Return the accelerations (n, 3) for those by the loads alone.

        Raises:
            JointError: no reactions keep the joints.
        """
        return self.accelerated(Now(time, position, velocity, free), self._mode_of_step(time))

    def pull(self, time: float, position: Array, velocity: Array, free: Array) -> Array:
        """Return the accelerations (n, 3) by the loads and by what springs and motors exert."""
        return self.pulled(Now(time, position, velocity, free), self._mode_of_step(time))

    def drifted(
        self, time: float, duration: float, position: Array, velocity: Array
    ) -> tuple[Array, Array]:
        """Return places after a drift from a time on, s, and the velocities (n, 3) along it (GD24).

        Raises:
            JointError: no place near by fits.
        """
        now = self.within(self._mode_of_step(time))
        return now.drifted(time, duration, position, velocity)

    def _mode_of_step(self, time: float) -> Mode:
        return self.mode(max(time, self.stepped_from))

    def accelerated(self, now: Now, mode: Mode) -> Array:
        """Return the accelerations (n, 3) in a mode."""
        return self.within(mode).accelerations(*now)

    def fitted(self, time: float, position: Array, velocity: Array) -> tuple[Array, Array]:
        """Return places and velocities (n, 3), moved to where the joints hold (GD18)."""
        return self.within(self.mode(time)).fitted(time, position, velocity)

    def examined(self, time: float, position: Array, velocity: Array, free: Array) -> str | None:
        """Return which joints depend on each other at the start, or None."""
        return self.within(self.mode(time)).examined(time, position, velocity, free)

    def struck(self, time: float, position: Array, impulses: Array) -> Array:
        """Return the changes of the velocities (n, 3) by impulses (n, 3), N s and N m s.

        Limits that hold answer where they are pressed; motors with a maximum do not.
        """
        mode = self.mode(time)
        change = self.inverse * impulses
        rows, ends = self.stiff(time, position, mode, sorted(mode.held))
        lower = np.array([0.0 if side else -np.inf for side in ends])
        answer, _ = bounded_sum(rows, self.inverse, -rows @ change.ravel(), lower)
        total: Array = change + answer
        return total

    def strikes_at(self, time: float) -> int:
        """Return how many limits were struck at a time in s."""
        struck = (STRIKES, STRIKES + 1)
        events = self._timeline.events
        return sum(e.time == time and e.joint in self._own and e.what in struck for e in events)

    def moved(
        self, time: float, position: Array, impulses: Array, *, in_turns: bool = False
    ) -> Array:
        """Return the changes (m, n, 3) of velocities by m impulses (m, n, 3) of either sign.

        Limits that hold give none: they are refused, or struck `in_turns` with what else meets.

        Raises:
            LimitHeldError: a limit holds.
        """
        mode = self.mode(time)
        if mode.held and not in_turns:
            raise LimitHeldError(self._joint[min(mode.held)[0][0]].name, time)
        rows, _ = self.stiff(time, position, mode, [])
        endless = np.full(len(rows), -np.inf)
        changes = self.inverse * impulses
        for change in changes:
            answer, _ = bounded_sum(rows, self.inverse, -rows @ change.ravel(), endless)
            change += answer
        return changes

    def pushed(self, time: float, position: Array, forces: Array) -> Array:
        """Return the accelerations (m, n, 3) by each of m forces (m, n, 3), N and N m.

        Limits that hold and motors that keep their speed answer whatever the sign.
        """
        return self.within(self.mode(time)).moved(time, position, forces)

    def stiff(
        self, time: float, position: Array, mode: Mode, limits: Sequence[Side]
    ) -> tuple[Array, list[Side | None]]:
        """Return the rows (m, 3 n) that answer impulses, and which limit each is.

        Those of limits count away from them.
        """
        own = self.within(Mode(broken=mode.broken)).rows.slopes(time, position)
        slopes = self.measures.slopes(time, position)
        endless = [
            slopes[row]
            for of, row in self.row.items()
            if self.freedoms[of].motor and self.most(of) == np.inf and of[0] not in mode.broken
        ]
        away = [-side * slopes[self.row[of]] for of, side in limits]
        rows = np.array([*own, *endless, *away]).reshape(-1, position.size)
        return rows, [*[None] * (len(own) + len(endless)), *limits]

    # --- what happens at an instant --------------------------------------------------------------

    def expect(self, cause: Cause) -> None:
        """Note why a path ends: it is looked at where the next begins."""
        self._cause = cause

    @property
    def begun(self) -> bool:
        """Whether it is known what its joints do."""
        return bool(self._modes)

    def rewind(self, time: float) -> Cause | None:
        """Forget what happens after a time in s; return what is expected to happen then.

        What was expected later was on a path that something else has ended before.
        """
        while self._modes and self._modes[-1][0] > time:
            self._modes.pop()
        self._timeline.drop(self._own, time)
        if self._cause and self._cause.time != time:
            self._cause = None
        return self._cause

    def enter(
        self,
        time: float,
        mode: Mode,
        strikes: Sequence[JointEvent[int]],
        borne: Mapping[int, float],
    ) -> None:
        """Do what a mode says from a time in s on, after limits were struck.

        Of joints that broke, `borne` has the shares of what they bear that were beyond it.
        """
        events = list(strikes)
        if self._modes and self._modes[-1][0] == time:  # it has begun here before
            struck = (STRIKES, STRIKES + 1)
            known = [e for e in self._timeline.events if e.time == time and e.joint in self._own]
            events = [*(e for e in known if e.what in struck), *events]
            borne = {e.joint: e.value for e in known if e.what == BREAKS} | dict(borne)
            self._modes.pop()
        before = self._modes[-1][1] if self._modes else Mode()
        self._modes.append((time, mode))
        self._timeline.replace(self._own, time, [*events, *changes(time, before, mode, borne)])

    # --- what it exerts --------------------------------------------------------------------------

    def pushes(self, now: Now, mode: Mode) -> dict[Of, float]:
        """Return what springs and slipping motors exert on their freedoms, N m or N."""
        if not self.freedoms:
            return {}
        values = self.measures.values(now.time, now.position)
        rates = self.measures.rates(*now[:3])
        found = {of: sense * self.most(of) for of, sense in mode.driven if sense}
        pulls = {
            of: _spring_pull(each, float(values[self.row[of]]), float(rates[self.row[of]]))
            for of, each in self.freedoms.items()
            if each.spring is not None
        }
        for of, pull in pulls.items():
            other = pulls[self._pair[of]] if of in self._pair else None
            found[of] = _bounded(self.freedoms[of], pull, other) + found.get(of, 0.0)
        return {of: push for of, push in found.items() if of[0] not in mode.broken}

    def pulled(self, now: Now, mode: Mode) -> Array:
        """Return the accelerations (n, 3) with what springs and slipping motors give."""
        pushes = self.pushes(now, mode)
        if not pushes:
            return now.free
        slopes = self.measures.slopes(now.time, now.position)
        total = np.zeros_like(now.free)
        for of, push in pushes.items():
            total += push * slopes[self.row[of]]
        pulled: Array = now.free + self.inverse * total
        return pulled

    def multipliers(self, now: Now, mode: Mode) -> Array:
        """Return the multipliers (m,) of the mechanism in a mode."""
        return self.within(mode).multipliers(*now)

    def shares(self, now: Now, mode: Mode) -> dict[Pusher, float]:
        """Return what limits and motors exert, N m or N; that of limits counts away from them."""
        multipliers = self.multipliers(now, mode)
        rows = {joint: own[0] for joint, own, _ in self.within(mode).rows.of_joints()}
        numbers = count(len(self._kept(mode)))
        found: dict[Pusher, float] = {}
        for of, side in sorted(mode.held):
            found["limit", (of, side)] = -side * float(multipliers[rows[next(numbers)]])
        for of in self._keeping(mode):
            found["motor", of] = float(multipliers[rows[next(numbers)]])
        for of, sense in mode.driven:
            if sense and of[0] not in mode.broken:
                found["motor", of] = sense * self.most(of)
        return found

    def exerted(self, now: Now, mode: Mode) -> Exerted:
        """Return what each joint exerts, by its index in the scene."""
        mechanism, numbers = self.parts(mode)
        multipliers = self.multipliers(now, mode)
        turns = dict(enumerate(body.orientation for body in self._scene.bodies))
        turns |= dict(zip(self.bodies, now.position[:, 2].tolist(), strict=True))
        found: Exerted = {}
        places = (now.time, now.position, turns)
        add_exerted(found, mechanism.rows, numbers, self._joint, multipliers, *places)
        pushes = np.zeros(self.measures.count)
        for of, push in self.pushes(now, mode).items():
            pushes[self.row[of]] = push
        owners = [number for number, _ in self.freedoms]
        add_exerted(found, self.measures, owners, self._joint, pushes, *places)
        return found

    def overloaded(self, now: Now, mode: Mode) -> dict[int, float]:
        """Return the joints whose reaction is beyond what they bear, and at which share of it."""
        return {number: 1 - spare for number, spare in self.spare(now, mode).items() if spare < 0}

    def spare(self, now: Now, mode: Mode) -> dict[int, float]:
        """Return what each joint that may break could still bear, as a share of what it bears.

        The larger of what it exerts on A and on B counts: a gear turns each by another torque.
        """
        chosen = self.breaking(mode)
        if not chosen:
            return {}
        exerted = self.exerted(now, mode)
        still = (np.zeros((3, 2)), np.zeros(3))
        found: dict[int, float] = {}
        for number, joint in chosen.items():
            force, torque = exerted.get(number, still)
            found[number] = 1 - _load(force, torque, joint)
        return found


def _load(force: Array, torque: Array, joint: Joint) -> float:
    """Return which share of what a joint bears it exerts on A and B (GD23), by (3, 2) and (3,)."""
    x, y = force[:2].T
    found = [0.0]
    if joint.break_force is not None:
        found += definitions.force_load((x, y), joint.break_force).tolist()
    if joint.break_torque is not None:
        found += definitions.torque_load(torque[:2], joint.break_torque).tolist()
    return float(np.max(found))  # no number where one is none


def _bounded(each: Freedom, pull: float, other: float | None) -> float:
    """Return what a spring exerts that would exert a pull, N m or N, by itself (DD103).

    That of the other travel of a target comes with it.
    """
    assert each.spring is not None
    most = each.spring.maximum
    if most is None:
        return pull
    if each.measure == "angle":
        return float(definitions.torque_share(most, abs(pull))) * pull
    size = abs(pull) if other is None else definitions.joint_pull(pull, other)
    return float(definitions.force_share(most, size)) * pull


def _spring_pull(each: Freedom, value: float, rate: float) -> float:
    """Return what the spring of a freedom exerts on it without a maximum, N m or N (DD64, DD65)."""
    spring = each.spring
    assert spring is not None
    angle = each.measure == "angle"
    law = definitions.joint_spring_torque if angle else definitions.joint_spring_force
    return float(law(spring.stiffness, value - (spring.rest or 0.0), spring.damping, rate))
