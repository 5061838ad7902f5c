"""The accelerations of a scene's bodies, from gravity and the sum of all loads (IM1, IM2, GD6)."""

from collections.abc import Callable, Mapping, Sequence
from typing import TypeAlias

import numpy as np

from tamias2d.errors import SimulationError
from tamias2d.generated import rotation, translation
from tamias2d.motion.joint_code import JointCode, JointCodes
from tamias2d.motion.joint_events import Mode, Timeline
from tamias2d.motion.limited_mechanism import LimitedMechanism
from tamias2d.motion.marching import HeldMarching, Marching
from tamias2d.motion.mechanisms import Mechanisms, Placed
from tamias2d.motion.terms import Term, terms
from tamias2d.scene import Scene
from tamias2d.scene.acting import groups, steady_load, varying_beside_joints, varying_loads
from tamias2d.state import Acceleration, Array, Constraint, State

Field: TypeAlias = Callable[[float, Array, Array], Array]
"""Accelerations (n, 3) from a time, the coordinates (n, 3) and their rates (n, 3)."""
MarchingOf: TypeAlias = Callable[[Sequence[int]], Marching | None]
"""What finds steps and accelerations of some bodies faster, if anything does."""
HeldMarchingOf: TypeAlias = Callable[
    [Sequence[int], Sequence[tuple[Sequence[int], JointCode]]], HeldMarching | None
]
"""What takes the steps of some bodies, and of mechanisms among them by their code, likewise."""
StateOf: TypeAlias = Callable[[int], State]
"""The state of a body now, given by its index."""

_STILL: Acceleration = (0.0, 0.0, 0.0)


class Loads:
    """The accelerations of a scene's bodies, free or held by lasting contacts."""

    def __init__(self, scene: Scene, codes: JointCodes | None = None) -> None:
        self._scene = scene
        self.varying = varying_loads(scene)
        """Why the loads of a body vary, for each body whose loads do."""
        self._varying_beside_joints = varying_beside_joints(scene)
        self.group_of = {body: group for group in groups(scene) for body in group}
        """The bodies that act on each other, for each body that moves."""
        self._steady = [self._steadily(k) for k in range(len(scene))]
        self.inverse = np.array(
            [(b.inverse_mass, b.inverse_mass, b.inverse_inertia) for b in scene.bodies]
        )
        """Inverse masses and inertias (n, 3) of the bodies."""
        self._fields: dict[int, Field] = {}
        self.timeline = Timeline()
        """What has happened in joints."""
        self._mechanisms = Mechanisms(scene, self.timeline, codes)
        self._among: dict[tuple[int, ...], list[Placed]] = {}
        self._marching: MarchingOf = lambda _: None
        self._held: HeldMarchingOf = lambda *_: None

    def steady(self, body: int) -> Acceleration:
        """Return what gravity and all constant forces and torques give a body."""
        return self._steady[body]

    def acceleration(self, body: int, time: float, state: StateOf) -> Acceleration:
        """Return the acceleration of an unconstrained body, at a time in s."""
        if body not in self.varying:
            return self._steady[body]
        group = self.group_of[body]
        if group[0] not in self._fields:
            self._fields[group[0]] = self.field(group, [None] * len(group))
        rows = self._fields[group[0]](time, *coordinates([state(k) for k in group]))
        x, y, turn = rows[group.index(body)].tolist()
        return x, y, turn

    def field(self, bodies: Sequence[int], constraints: Sequence[Constraint | None]) -> Field:
        """Return the accelerations of some bodies as a function, for the schemes.

        Who acts on one of the bodies must be among them (`group_of`).
        """
        return _held(self._jointed(bodies, self.free_field(bodies)), constraints)

    def loaded_field(
        self, bodies: Sequence[int], constraints: Sequence[Constraint | None]
    ) -> Field:
        """Return likewise what loads, springs and motors give, without reactions of joints."""
        free, found = self.free_field(bodies), self.mechanisms(bodies)

        def field(time: float, position: Array, velocity: Array) -> Array:
            rows = free(time, position, velocity).copy()
            for own, mechanism in found:
                rows[own] = mechanism.pull(time, position[own], velocity[own], rows[own])
            return rows

        return _held(field, constraints)

    def mechanisms(self, bodies: Sequence[int]) -> list[Placed]:
        """Return the mechanisms among some bodies, each with the places of its own in `bodies`."""
        if not self._scene.joints:
            return []
        if (key := tuple(bodies)) not in self._among:
            self._among[key] = self._mechanisms.among(bodies)
        return self._among[key]

    def take_codes(self, codes: JointCodes, makers: MarchingOf, held: HeldMarchingOf) -> None:
        """Let code that is made for mechanisms find reactions, loads and steps."""
        self._held = held
        self._mechanisms = Mechanisms(self._scene, self.timeline, codes)
        self._marching = makers
        self._among.clear()
        self._fields.clear()

    def marching(self, bodies: Sequence[int], time: float) -> HeldMarching | None:
        """Return what takes steps from a time in s on, of some bodies that joints hold."""
        placed: list[tuple[Sequence[int], JointCode]] = []
        for own, mechanism in self.mechanisms(bodies):
            code = mechanism.code_at(time)
            if code is None:
                return None
            placed.append((own, code))
        return self._held(bodies, placed) if placed else None

    def struck(
        self, time: float, impulses: Mapping[int, Acceleration], state: StateOf
    ) -> dict[int, Acceleration]:
        """Return the changes of all velocities by impulses on jointed bodies, N s and N m s."""
        found: dict[int, Acceleration] = {}
        for _, mechanism in self.mechanisms(sorted(self.group_of)):
            own = mechanism.bodies
            if not any(k in impulses for k in own):
                continue
            struck = np.array([impulses.get(k, _STILL) for k in own])
            position, _ = coordinates([state(k) for k in own])
            changes = mechanism.struck(time, position, struck)
            found |= {
                k: (x, y, turn) for k, (x, y, turn) in zip(own, changes.tolist(), strict=True)
            }
        return found

    def moved(
        self,
        time: float,
        bodies: Sequence[int],
        impulses: Array,
        state: StateOf,
        *,
        in_turns: bool = False,
    ) -> Array:
        """Return the changes (m, n, 3) of the velocities of whole mechanisms, and of other bodies.

        They are by impulses (m, n, 3), N s and N m s, each with what joints answer.
        """
        changes: Array = impulses * self.inverse[list(bodies)]
        for own, mechanism in self.mechanisms(bodies):
            position, _ = coordinates([state(bodies[k]) for k in own])
            changes[:, own] = mechanism.moved(time, position, impulses[:, own], in_turns=in_turns)
        return changes

    def pushed(self, time: float, bodies: Sequence[int], forces: Array, state: StateOf) -> Array:
        """Return the accelerations (m, n, 3) by forces (m, n, 3) on mechanisms and other bodies.

        They are in N and N m, each with what joints answer as they do now.
        """
        changes: Array = forces * self.inverse[list(bodies)]
        for own, mechanism in self.mechanisms(bodies):
            position, _ = coordinates([state(bodies[k]) for k in own])
            changes[:, own] = mechanism.pushed(time, position, forces[:, own])
        return changes

    def joint_changes(self, bodies: Sequence[int], time: float) -> list[tuple[Mode, int]]:
        """Return what joints of some bodies do at a time, s, and how many limits were struck."""
        found = [mechanism for _, mechanism in self.mechanisms(bodies)]
        limited = [one for one in found if isinstance(one, LimitedMechanism)]
        return [(one.mode(time), one.strikes_at(time)) for one in limited]

    def joint_notes(self, bodies: Sequence[int]) -> tuple[str, ...]:
        """Return what is to be told of the joints among some bodies at the start (GD19).

        Raises:
            JointError: no reactions keep them.
        """
        found = self.mechanisms(bodies)
        if not found:
            return ()
        states = start_states(self._scene)
        q, rate = coordinates([states[k] for k in bodies])
        pull = self.free_field(bodies)(0.0, q, rate)
        notes = (m.examined(0.0, q[own], rate[own], pull[own]) for own, m in found)
        return tuple(note for note in notes if note)

    def _jointed(self, bodies: Sequence[int], free: Field) -> Field:
        """Return the accelerations with the reactions of joints (GD17)."""
        found = self.mechanisms(bodies)
        if not found:
            return free

        def field(time: float, position: Array, velocity: Array) -> Array:
            rows = free(time, position, velocity).copy()
            for own, mechanism in found:
                rows[own] = mechanism.accelerations(time, position[own], velocity[own], rows[own])
            return rows

        return field

    def free_field(self, bodies: Sequence[int]) -> Field:
        """Return the accelerations by the loads alone, whatever holds the bodies."""
        if self._varying_beside_joints.isdisjoint(bodies):
            fixed = np.array([self._steady[body] for body in bodies]).reshape(-1, 3)
            return lambda time, position, velocity: fixed  # noqa: ARG005
        return quicker(self._summed(bodies), self._marching(bodies))

    def _summed(self, bodies: Sequence[int]) -> Field:
        scene = self._scene
        gravity = scene.gravity
        mass = np.array([scene.bodies[body].mass for body in bodies])
        inertia = np.array([scene.bodies[body].inertia for body in bodies])
        steady = np.array([steady_load(scene, body) for body in bodies]).reshape(-1, 3)
        found = terms(scene, bodies)

        def field(time: float, position: Array, velocity: Array) -> Array:
            loads = steady.copy()
            with np.errstate(all="ignore"):  # what is not finite is refused below
                for term in found:
                    term.add(time, position, velocity, loads)
            rows = np.empty_like(loads)
            force = (loads[:, 0], loads[:, 1])
            rows[:, 0], rows[:, 1] = translation.acceleration(gravity, force, mass)
            rows[:, 2] = rotation.angular_acceleration(loads[:, 2], inertia)
            if not np.isfinite(rows).all():
                self._refuse(found, bodies, time, position, velocity)
            return rows

        return field

    def _refuse(
        self,
        found: Sequence[Term],
        bodies: Sequence[int],
        time: float,
        position: Array,
        velocity: Array,
    ) -> None:
        """Raise an error that names the term and the body without a finite force."""
        for term in found:
            loads = np.zeros_like(position)
            with np.errstate(all="ignore"):
                term.add(time, position, velocity, loads)
            if not (good := np.isfinite(loads).all(axis=1)).all():
                name = self._scene.bodies[bodies[int(np.argmin(good))]].name
                raise SimulationError(
                    f"{term.says.replace('_', ' ')} at {time!r} s: no finite force on '{name}' "
                    "(R4): bodies are at one place, or float64 cannot hold it. End the run "
                    "before, or change the scene."
                )
        raise SimulationError(
            f"state at {time!r} s: not finite (R4). End the run before, or take a smaller step."
        )

    def _steadily(self, k: int) -> Acceleration:
        body = self._scene.bodies[k]
        if not body.dynamic:
            return _STILL
        fx, fy, torque = steady_load(self._scene, k)
        x, y = translation.acceleration(self._scene.gravity, (fx, fy), body.mass)
        return float(x), float(y), float(rotation.angular_acceleration(torque, body.inertia))


def quicker(field: Field, marching: Marching | None) -> Field:
    """Return accelerations from where they are found faster; what is wrong with them is told."""
    if marching is None:
        return field

    def found(time: float, position: Array, velocity: Array) -> Array:
        rows = marching.accelerations(time, position, velocity)
        return field(time, position, velocity) if rows is None else rows

    return found


def _held(free: Field, constraints: Sequence[Constraint | None]) -> Field:
    """Return accelerations as the constraints on bodies leave them."""
    held = [(row, constraint) for row, constraint in enumerate(constraints) if constraint]
    if not held:
        return free

    def field(time: float, position: Array, velocity: Array) -> Array:
        rows = free(time, position, velocity).copy()
        for row, constraint in held:
            x, y, turn = rows[row].tolist()
            rows[row] = constraint((x, y, turn), state_of(position[row], velocity[row]))
        return rows

    return field


def start_states(scene: Scene) -> list[State]:
    """Return the states in which the bodies of a scene start."""
    return [State(b.position, b.orientation, b.velocity, b.angular_velocity) for b in scene.bodies]


def coordinates(states: Sequence[State]) -> tuple[Array, Array]:
    """Return states as coordinates (n, 3), x y orientation, and their rates (n, 3)."""
    position = [(*state.position, state.orientation) for state in states]
    velocity = [(*state.velocity, state.angular_velocity) for state in states]
    return np.array(position).reshape(-1, 3), np.array(velocity).reshape(-1, 3)


def state_of(position: Array, velocity: Array) -> State:
    """Return coordinates (3,) and their rates (3,) as a state."""
    x, y, orientation = position.tolist()
    u, v, angular_velocity = velocity.tolist()
    return State((x, y), orientation, (u, v), angular_velocity)
