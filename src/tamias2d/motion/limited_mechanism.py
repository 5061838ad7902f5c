"""A mechanism whose joints have limits, motors or springs, or break (GD21, GD22, GD23, DD61, DD62).

Between two instants it is a mechanism like others, with a row more for each limit that holds and
each motor that keeps its speed. What happens at an instant is decided here.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from tamias2d.generated import definitions, impact, rest
from tamias2d.motion.bounded_least import bounded_shares
from tamias2d.motion.constraint_rows import ConstraintRows
from tamias2d.motion.joint_events import (
    STRIKES,
    JointEvent,
    Mode,
    Of,
    Timeline,
    changes,
    mode_at,
)
from tamias2d.motion.joint_loads import Exerted, add_exerted
from tamias2d.motion.mechanism import JointError, Mechanism
from tamias2d.scene import Freedom, Scene
from tamias2d.scene.joints import Joint
from tamias2d.state import Array

Side = tuple[Of, int]
"""A limit of a freedom: -1 for the lower one, 1 for the upper."""
_SLIGHT = 1e-12  # of the mechanism's length, or rad: so near a limit is touched
_NOISE = 1e-10  # of the speeds that make up a rate
_ROUNDING = 1e-14  # of the speeds that there have been


@dataclass(frozen=True)
class Cause:
    """Why a path ends at a time, s, and what that says of the next."""

    time: float
    reached: frozenset[Side] = frozenset()
    left: frozenset[Side] = frozenset()
    slips: Mapping[Of, int] = field(default_factory=dict)
    clicks: Mapping[Of, float] = field(default_factory=dict)
    breaks: frozenset[int] = frozenset()


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
        self.numbers = tuple(place[joint.name] for joint in joints)
        """The indices of its joints in the scene."""
        self._own = frozenset(self.numbers)
        self._timeline = timeline
        self._modes = timeline.modes(self._own)
        self._cause: Cause | None = None
        self._row_of = {body: k for k, body in enumerate(bodies)}
        self._joint = dict(zip(self.numbers, joints, strict=True))
        self.freedoms: dict[Of, Freedom] = {
            (number, k): each
            for number, joint in self._joint.items()
            for k, each in enumerate(joint.freedoms)
        }
        measures = [self._joint[of[0]].measured(each, 0.0) for of, each in self.freedoms.items()]
        self.measures = ConstraintRows(scene, measures, self._row_of)
        order = {joint: rows[0] for joint, rows, _ in self.measures.of_joints()}
        self.row = {of: order[k] for k, of in enumerate(self.freedoms)}
        """The row of each freedom among the measures."""
        self._fastest = np.zeros(len(self.freedoms))
        self._known: dict[Mode, Mechanism] = {}
        self._reversible: dict[frozenset[int], Mechanism] = {}
        self._whole = Mechanism(scene, joints, bodies)
        weights = [
            (body.inverse_mass, body.inverse_mass, body.inverse_inertia)
            for body in (scene.bodies[k] for k in bodies)
        ]
        self._inverse = np.array(weights)

    # --- what it is between instants -------------------------------------------------------

    def mode(self, time: float) -> Mode:
        """Return what its joints do at a time in s."""
        return mode_at(self._modes, time)

    def at(self, time: float) -> Mechanism:
        """Return the mechanism that it is at a time in s."""
        return self._in(self.mode(time))

    def _in(self, mode: Mode) -> Mechanism:
        if mode not in self._known:
            joints = self._kept(mode.broken)
            speeds: dict[int, float] = {}
            for of, side in sorted(mode.held):
                joints.append(self._limit(of, side, mode))
            for of, sense in mode.driven:
                if not sense and of[0] not in mode.broken:
                    motor = self.freedoms[of].motor
                    assert motor is not None
                    speeds[len(joints)] = motor.speed
                    joints.append(self._joint[of[0]].measured(self.freedoms[of], 0.0))
            self._known[mode] = Mechanism(
                self._scene, joints, self.bodies, speeds=speeds, like=self.joints
            )
        return self._known[mode]

    def _kept(self, broken: frozenset[int]) -> list[Joint]:
        return [j for number, j in self._joint.items() if j.rigid and number not in broken]

    def _limit(self, of: Of, side: int, mode: Mode) -> Joint:
        joint = self._joint[of[0]]
        return joint.measured(self.freedoms[of], self.end(of, side, mode))

    def end(self, of: Of, side: int, mode: Mode) -> float:
        """Return where a limit is, rad or m; endless where there is none."""
        each = self.freedoms[of]
        if each.pitch is not None:
            return dict(mode.teeth).get(of, -np.inf) if side < 0 else np.inf
        limits = each.limits
        value = limits and (limits.lower if side < 0 else limits.upper)
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

    def slight(self, of: Of, position: Array) -> float:
        """Return how near a limit counts as touched, rad or m."""
        angle = self.freedoms[of].measure == "angle"
        return _SLIGHT * (1.0 if angle else self._whole.length(position))

    def pushes(self, time: float, position: Array, velocity: Array, mode: Mode) -> dict[Of, float]:
        """Return what springs and slipping motors exert on their freedoms, N m or N."""
        if not self.freedoms:
            return {}
        values = self.measures.values(time, position)
        rates = self.measures.rates(time, position, velocity)
        driven = dict(mode.driven)
        found: dict[Of, float] = {}
        for of, each in self.freedoms.items():
            if of[0] in mode.broken:
                continue
            total = driven.get(of, 0) * ((each.motor and each.motor.maximum) or 0.0)
            if each.spring is not None:
                total += spring_push(each, values[self.row[of]], rates[self.row[of]])
            if total:
                found[of] = float(total)
        return found

    def pulled(
        self, time: float, position: Array, velocity: Array, free: Array, mode: Mode
    ) -> Array:
        """Return the accelerations (n, 3) with what springs and slipping motors give."""
        pushes = self.pushes(time, position, velocity, mode)
        if not pushes:
            return free
        slopes = self.measures.slopes(time, position)
        total = np.zeros_like(free)
        for of, push in pushes.items():
            total += push * slopes[self.row[of]]
        return free + self._inverse * total

    # --- what a mechanism is asked -----------------------------------------------------------

    def accelerations(self, time: float, position: Array, velocity: Array, free: Array) -> Array:
        """Return the accelerations (n, 3) for those by the loads alone.

        Raises:
            JointError: no reactions keep the joints.
        """
        mode = self.mode(time)
        free = self.pulled(time, position, velocity, free, mode)
        return self._in(mode).accelerations(time, position, velocity, free)

    def fitted(self, time: float, position: Array, velocity: Array) -> tuple[Array, Array]:
        """Return places and velocities (n, 3), moved to where the joints hold (GD18)."""
        return self.at(time).fitted(time, position, velocity)

    def examined(self, time: float, position: Array, velocity: Array, free: Array) -> str | None:
        """Return which joints depend on each other at the start, or None."""
        return self.at(time).examined(time, position, velocity, free)

    def struck(self, time: float, position: Array, impulses: Array) -> Array:
        """Return the changes of the velocities (n, 3) by impulses (n, 3), N s and N m s.

        Limits that hold answer where they are pressed, motors with a maximum do not.
        """
        mode = self.mode(time)
        change = self._inverse * impulses
        rows, ends = self._stiff(time, position, mode, sorted(mode.held))
        lower = np.array([0.0 if side else -np.inf for side in ends])
        wanted = -rows @ change.ravel()
        return change + self._given(rows, wanted, lower, np.full(len(rows), np.inf))[0]

    # --- what happens at an instant ------------------------------------------------------------

    def expect(self, cause: Cause) -> None:
        """Note why a path ends: it is looked at where the next begins."""
        self._cause = cause

    def begin(self, time: float, position: Array, velocity: Array, free: Array) -> Array:
        """Decide what the joints do from a time in s on; return the velocities (n, 3) after it.

        What was decided for later is forgotten: a path may be found anew after an impact.

        Raises:
            JointError: limits and motors leave no answer.
        """
        while self._modes and self._modes[-1][0] > time:
            self._modes.pop()
        self._timeline.drop(self._own, time)
        quiet = self._cause is None or self._cause.time != time
        cause = Cause(time) if quiet or self._cause is None else self._cause
        now = self._modes[-1][1] if self._modes else None
        noise = self._noises(time, position, velocity, free)
        if now is not None and quiet and not self._disturbed(now, time, position, velocity, noise):
            return velocity
        before = Mode()
        events: list[JointEvent] = []
        if self._modes and self._modes[-1][0] == time:
            events = [e for e in self._timeline.events if e.time == time and e.joint in self._own]
            events = [e for e in events if e.what in (STRIKES, STRIKES + 1)]
            self._modes.pop()
        if self._modes:
            before = self._modes[-1][1]
        base = self._base(now or Mode(), cause, time, position)
        velocity, strikes, resting = self._impacts(
            time, position, velocity, free, base, cause, noise
        )
        mode = self._resolved(time, position, velocity, free, base, cause, resting, noise)
        self._modes.append((time, mode))
        events += [*strikes, *changes(time, before, mode)]
        self._timeline.replace(self._own, time, events)
        return self._in(mode).paced(time, position, velocity)

    def _base(self, now: Mode, cause: Cause, time: float, position: Array) -> Mode:
        """Return the mode with what has broken and clicked."""
        teeth = {**dict(now.teeth), **cause.clicks}
        for of, each in self.freedoms.items():
            if each.pitch is not None and of not in teeth:
                value = self.measures.values(time, position)[self.row[of]]
                teeth[of] = float(np.floor(value / each.pitch + 1e-9)) * each.pitch
        return replace(now, broken=now.broken | cause.breaks, teeth=tuple(teeth.items()))

    def _disturbed(
        self, mode: Mode, time: float, position: Array, velocity: Array, noise: Array
    ) -> bool:
        """Whether a limit is struck or left, or a motor lost, by something beside the joints."""
        rates = self.measures.rates(time, position, velocity)
        values = self.measures.values(time, position)
        for of, side in self.sides(mode):
            k = self.row[of]
            if (of, side) in mode.held:
                if abs(rates[k]) > noise[k]:
                    return True
            elif (
                side * (values[k] - self.end(of, side, mode)) >= -self.slight(of, position)
                and side * rates[k] > noise[k]
            ):
                return True
        return any(
            not sense and abs(rates[self.row[of]] - self._motor_speed(of)) > noise[self.row[of]]
            for of, sense in mode.driven
            if of[0] not in mode.broken
        )

    def _motor_speed(self, of: Of) -> float:
        motor = self.freedoms[of].motor
        return motor.speed if motor else 0.0

    def _noises(self, time: float, position: Array, velocity: Array, free: Array) -> Array:
        """Return how large a rate of each freedom counts as none.

        It is a share of the speeds that make it up, and of those that there have been, or that the
        loads give over its length.
        """
        slopes = np.abs(self.measures.slopes(time, position))
        size = np.einsum("ijk,jk->i", slopes, np.abs(velocity))
        reach = np.array([self.slight(of, position) / _SLIGHT for of in self.freedoms])
        rows = [self.row[of] for of in self.freedoms]
        size[rows] += [abs(self._motor_speed(of)) for of in self.freedoms]
        pull = np.einsum("ijk,jk->i", slopes, np.abs(free))
        pull[rows] *= reach
        self._fastest = np.maximum(self._fastest, size)
        return _NOISE * size + _ROUNDING * (self._fastest + np.sqrt(pull)) + 1e-300

    def _touched(self, time: float, position: Array, mode: Mode, cause: Cause) -> list[Side]:
        values = self.measures.values(time, position)
        return [
            (of, side)
            for of, side in self.sides(mode)
            if (of, side) in cause.reached
            or side * (values[self.row[of]] - self.end(of, side, mode))
            >= -self.slight(of, position)
        ]

    def _impacts(
        self,
        time: float,
        position: Array,
        velocity: Array,
        free: Array,
        base: Mode,
        cause: Cause,
        noise: Array,
    ) -> tuple[Array, list[JointEvent], list[Side]]:
        """Return the velocities after limits were struck, the events, and what came to rest."""
        touched = self._touched(time, position, base, cause)
        rates = self.measures.rates(time, position, velocity)
        if not any(side * rates[self.row[of]] > noise[self.row[of]] for of, side in touched):
            return (
                velocity,
                [],
                [s for s in touched if abs(rates[self.row[s[0]]]) <= noise[self.row[s[0]]]],
            )
        after, shares = self._rebound(time, position, velocity, base, touched, frozenset())
        low = self._low(time, position, after, free, base, touched)
        if low:
            after, shares = self._rebound(time, position, velocity, base, touched, low)
        strikes = [
            JointEvent(time, of[0], of[1], STRIKES + (side > 0), share)
            for (of, side), share in zip(touched, shares, strict=True)
            if share > 0
        ]
        rates = self.measures.rates(time, position, after)
        return (
            after,
            strikes,
            [s for s in touched if abs(rates[self.row[s[0]]]) <= noise[self.row[s[0]]]],
        )

    def _rebound(
        self,
        time: float,
        position: Array,
        velocity: Array,
        base: Mode,
        touched: Sequence[Side],
        low: frozenset[Side],
    ) -> tuple[Array, list[float]]:
        """Return the velocities after impacts on limits, and their impulses (GD21)."""
        rows, ends = self._stiff(time, position, base, touched)
        rates = rows @ velocity.ravel()
        wanted = np.zeros(len(rows))
        for k, side in enumerate(ends):
            if side is None:
                continue
            limits = self.freedoms[side[0]].limits
            left = 0.0 if limits is None or side in low else limits.restitution
            rate = float(rates[k])
            wanted[k] = impact.impulse(left, rate, 1.0) if rate < 0 else -rate
        lower = np.array([0.0 if side else -np.inf for side in ends])
        change, shares = self._given(rows, wanted, lower, np.full(len(rows), np.inf))
        of_limits = [
            float(share) for share, side in zip(shares, ends, strict=True) if side is not None
        ]
        return velocity + change, of_limits

    def _low(
        self,
        time: float,
        position: Array,
        velocity: Array,
        free: Array,
        base: Mode,
        touched: Sequence[Side],
    ) -> frozenset[Side]:
        """Return the limits whose next bounce is too low to be told from none."""
        mode = replace(base, held=frozenset())
        pull = self.pulled(time, position, velocity, free, mode)
        by = self._in(mode).accelerations(time, position, velocity, pull)
        slopes = self.measures.slopes(time, position)
        bend = np.einsum("ijk,jk->i", slopes, by)
        bend = bend + self.measures.convective(time, position, velocity)
        rates = self.measures.rates(time, position, velocity)
        found: set[Side] = set()
        for of, side in touched:
            rate, falls = -side * rates[self.row[of]], -side * bend[self.row[of]]
            if rate > 0 > falls:
                height = float(rest.bounce_height(rate, falls))
                if height <= self.slight(of, position):
                    found.add((of, side))
        return frozenset(found)

    def _stiff(
        self, time: float, position: Array, mode: Mode, limits: Sequence[Side]
    ) -> tuple[Array, list[Side | None]]:
        """Return the rows (m, 3 n) that answer impulses; those of limits count away from them."""
        if mode.broken not in self._reversible:
            joints = self._kept(mode.broken)
            self._reversible[mode.broken] = Mechanism(
                self._scene, joints, self.bodies, like=self.joints
            )
        own = self._reversible[mode.broken].rows.slopes(time, position)
        slopes = self.measures.slopes(time, position)
        endless = [
            slopes[self.row[of]]
            for of, each in self.freedoms.items()
            if each.motor and each.motor.maximum is None and of[0] not in mode.broken
        ]
        away = [-side * slopes[self.row[of]] for of, side in limits]
        rows = np.array([*own, *endless, *away]).reshape(-1, 3 * len(self.bodies))
        return rows, [*[None] * (len(own) + len(endless)), *limits]

    def _given(self, rows: Array, wanted: Array, lower: Array, upper: Array) -> tuple[Array, Array]:
        """Return the changes (n, 3) that rows make, weighed by mass and inertia, and their shares.

        Found are the bounds that count; with these the changes are computed to rounding.
        """
        weights = np.sqrt(self._inverse).ravel()
        weighed = rows * weights
        shares, at = bounded_shares(weighed, wanted, lower, upper)
        free = at == 0
        bound = np.where(free, 0.0, shares)
        left = wanted - weighed @ (bound @ weighed)
        if free.any():
            exact = np.linalg.lstsq(weighed[free], left[free], rcond=1e-12)[0]
            shares = bound.copy()
            shares[free] = np.linalg.lstsq(weighed[free].T, exact, rcond=1e-12)[0]
            total = exact + bound @ weighed
        else:
            total = bound @ weighed
        return (weights * total).reshape(self._inverse.shape), shares

    def _resolved(
        self,
        time: float,
        position: Array,
        velocity: Array,
        free: Array,
        base: Mode,
        cause: Cause,
        resting: Sequence[Side],
        noise: Array,
    ) -> Mode:
        """Return which limits hold and what motors do from here on, and what breaks at once."""
        for _ in range(len(self.joints) + 1):
            mode = self._balanced(time, position, velocity, free, base, cause, resting, noise)
            broken = self.overloaded(time, position, velocity, free, mode)
            if not broken:
                return mode
            base = replace(base, broken=base.broken | broken)
            resting = [side for side in resting if side[0][0] not in broken]
        raise JointError(
            f"joints at {time!r} s: all have broken, and still more should (GD23). End the run "
            "before."
        )

    def _balanced(
        self,
        time: float,
        position: Array,
        velocity: Array,
        free: Array,
        base: Mode,
        cause: Cause,
        resting: Sequence[Side],
        noise: Array,
    ) -> Mode:
        """Return the limits that hold and what motors do by Gauss's principle."""
        rates = self.measures.rates(time, position, velocity)
        resting = [side for side in resting if side not in cause.left]
        driven: dict[Of, int] = {}
        kept: list[Of] = []
        for of, each in self.freedoms.items():
            if each.motor is None or of[0] in base.broken:
                continue
            lag = each.motor.speed - rates[self.row[of]]
            if of in cause.slips:
                driven[of] = cause.slips[of]
            elif each.motor.maximum is None or abs(lag) <= noise[self.row[of]]:
                kept.append(of)
            else:
                driven[of] = 1 if lag > 0 else -1
        if not resting and not kept:
            return replace(base, held=frozenset(), driven=tuple(sorted(driven.items())))
        bare = replace(base, held=frozenset(), driven=tuple(driven.items()))
        at = self._bounds_met(time, position, velocity, free, bare, resting, kept)
        held = {side for side, met in zip(resting, at, strict=False) if not met}
        driven |= dict(zip(kept, at[len(resting) :], strict=True))
        return replace(base, held=frozenset(held), driven=tuple(sorted(driven.items())))

    def _bounds_met(
        self,
        time: float,
        position: Array,
        velocity: Array,
        free: Array,
        bare: Mode,
        resting: Sequence[Side],
        kept: Sequence[Of],
    ) -> list[int]:
        """Return at which of their bounds the pushes of limits, then of motors, are."""
        own = self._in(bare).rows
        slopes = self.measures.slopes(time, position)
        bends = self.measures.convective(time, position, velocity)
        away = [-side * slopes[self.row[of]] for of, side in resting]
        rows = np.array(
            [*own.slopes(time, position), *away, *(slopes[self.row[of]] for of in kept)]
        ).reshape(-1, 3 * len(self.bodies))
        convective = np.array(
            [
                *own.convective(time, position, velocity),
                *(-side * bends[self.row[of]] for of, side in resting),
                *(bends[self.row[of]] for of in kept),
            ]
        )
        most = [self._most(of) for of in kept]
        stiff = [-np.inf] * own.count
        lower = np.array([*stiff, *[0.0] * len(resting), *(-m for m in most)])
        upper = np.array([*(-s for s in stiff), *[np.inf] * len(resting), *most])
        pull = self.pulled(time, position, velocity, free, bare)
        weights = np.sqrt(self._inverse).ravel()
        wanted = -(rows @ pull.ravel() + convective)
        _, at = bounded_shares(rows * weights, wanted, lower, upper)
        found: list[int] = at[own.count :].tolist()
        return found

    def _most(self, of: Of) -> float:
        motor = self.freedoms[of].motor
        return np.inf if motor is None or motor.maximum is None else motor.maximum

    # --- what it exerts -----------------------------------------------------------------------

    def shares(
        self, time: float, position: Array, velocity: Array, free: Array, mode: Mode
    ) -> dict[tuple[Any, ...], float]:
        """Return what limits exert, by their side, and motors, by ("motor", of), N m or N.

        A limit counts away from itself: it never is negative where it holds.
        """
        mechanism = self._in(mode)
        pull = self.pulled(time, position, velocity, free, mode)
        multipliers = mechanism.multipliers(time, position, velocity, pull)
        rows = {joint: own for joint, own, _ in mechanism.rows.of_joints()}
        number = len(self._kept(mode.broken))
        found: dict[tuple[Any, ...], float] = {}
        for of, side in sorted(mode.held):
            found[of, side] = -side * float(multipliers[rows[number]][0])
            number += 1
        for of, sense in mode.driven:
            if of[0] in mode.broken:
                continue
            if sense:
                found["motor", of] = sense * self._most(of)
            else:
                found["motor", of] = float(multipliers[rows[number]][0])
                number += 1
        return found

    def overloaded(
        self, time: float, position: Array, velocity: Array, free: Array, mode: Mode
    ) -> frozenset[int]:
        """Return the joints whose reaction has reached what they bear."""
        loads = self.burdens(time, position, velocity, free, mode)
        return frozenset(number for number, spare in loads.items() if spare < 0)

    def burdens(
        self, time: float, position: Array, velocity: Array, free: Array, mode: Mode
    ) -> dict[int, float]:
        """Return what each joint that may break could still bear, as a share of what it bears."""
        chosen = [n for n, j in self._joint.items() if j.breaks and n not in mode.broken]
        if not chosen:
            return {}
        forces = self.exerted(time, position, velocity, free, mode)
        found: dict[int, float] = {}
        for number in chosen:
            joint, (force, torque) = self._joint[number], forces[number]
            spare = [np.inf]
            if joint.break_force is not None:
                spare.append(1 - float(np.hypot(*force[0])) / joint.break_force)
            if joint.break_torque is not None:
                spare.append(1 - abs(float(torque[0])) / joint.break_torque)
            found[number] = min(spare)
        return found

    def exerted(
        self, time: float, position: Array, velocity: Array, free: Array, mode: Mode
    ) -> Exerted:
        """Return what each joint exerts, by its index in the scene."""
        mechanism, numbers = self.parts(mode)
        pull = self.pulled(time, position, velocity, free, mode)
        multipliers = mechanism.multipliers(time, position, velocity, pull)
        turns = self._turns(position)
        found: Exerted = {}
        joints = self._joint
        add_exerted(found, mechanism.rows, numbers, joints, multipliers, time, position, turns)
        pushes = np.zeros(self.measures.count)
        for of, push in self.pushes(time, position, velocity, mode).items():
            pushes[self.row[of]] = push
        owners = [number for number, _ in self.freedoms]
        add_exerted(found, self.measures, owners, joints, pushes, time, position, turns)
        return found

    def _turns(self, position: Array) -> dict[int, float]:
        moving = {body: float(position[row, 2]) for body, row in self._row_of.items()}
        still = {k for joint in self.joints for k in joint.bodies if k not in moving}
        return moving | {k: self._scene.bodies[k].orientation for k in still}

    def parts(self, mode: Mode) -> tuple[Mechanism, list[int]]:
        """Return the mechanism of a mode, and for each of its joints the index in the scene."""
        numbers = [n for n, j in self._joint.items() if j.rigid and n not in mode.broken]
        numbers += [of[0] for of, _ in sorted(mode.held)]
        numbers += [of[0] for of, sense in mode.driven if not sense and of[0] not in mode.broken]
        return self._in(mode), numbers


def spring_push(each: Freedom, value: float, rate: float) -> float:
    """Return what the spring of a freedom exerts on it, N m or N (DD61, DD62)."""
    spring = each.spring
    assert spring is not None
    law = (
        definitions.joint_spring_torque
        if each.measure == "angle"
        else definitions.joint_spring_force
    )
    beyond = value - (spring.rest or 0.0)
    return float(law(spring.stiffness, beyond, spring.damping, rate))
