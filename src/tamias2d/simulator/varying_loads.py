"""Loads that vary with time or state, but for springs: attraction, fields, laws, quadratic drag.

They are evaluated at both ends of a step: what acts at its beginning is held through it, and its
end puts the velocities right by half of the change (DD53). Quadratic drag slows for half a step
before all else and for half a step after it (DD55). Source: Verlet (1967), Strang (1968).
"""

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.engine import Engine
from tamias2d.engine.state import LARGEST
from tamias2d.errors import SimulationError
from tamias2d.generated import quadratic_step, spring_step
from tamias2d.motion.terms import Attraction, LawTerm
from tamias2d.scene import Scene
from tamias2d.scene.acting import varying_laws
from tamias2d.simulator.warned import Warned
from tamias2d.state import Array

_MOST_ROUNDS = 20  # in which velocities and the forces that depend on them agree
_AGREED = 1e-13  # of the velocities
_VELOCITIES = {"velocity", "angular_velocity"}
_OTHERS = {"time", *_VELOCITIES}  # than places, on which a force may depend
_RESOLVED = 1e-10  # of a coordinate: changes below it say nothing of a force


class _State(NamedTuple):
    time: float
    pose: Array
    velocity: Array
    loads: list[Array]
    """(n, 3) of each term"""


class VaryingLoads:
    """The loads on bodies that move: of a scene, or as it would have them (`acting_scene`)."""

    def __init__(
        self,
        scene: Scene,
        bodies: Mapping[int, int],
        name_of: Callable[[int], str],
        warned: Warned,
    ) -> None:
        """Take the indices in the scene of bodies, by their rows, in canonical order.

        So no sum depends on another order. `warned` tells of forces that are too fast for the step.
        """
        indices = list(bodies.values())
        self._name_of = name_of
        self._rows = np.array(list(bodies), dtype=np.int64)
        self._terms = _terms(scene, indices)
        self._pulls = next((term for term in self._terms if isinstance(term, Attraction)), None)
        self._of_velocity = any(term.names & _VELOCITIES for term in self._terms)
        self._drag = np.array([scene.bodies[k].quadratic_drag for k in indices])
        self._warned = warned
        self._begun: _State | None = None
        self._ended: _State | None = None

    @property
    def put_right(self) -> bool:
        """Whether some load is put right at the end of a step: any but quadratic drag."""
        return bool(self._terms)

    @property
    def empty(self) -> bool:
        """Whether no load varies."""
        return not self._terms and not self._drag.any()

    def begin(self, engine: Engine, time: float, time_step: float) -> None:
        """Let quadratic drag act for half a step, and add what acts at a time, s, to all loads.

        Raises:
            SimulationError: a force is not finite; names it and a body.
        """
        self._slow_down(engine, time_step)
        pose, velocity = engine.pose[self._rows], engine.velocity[self._rows]
        last = self._ended
        if (
            last is None
            or last.time != time
            or not np.array_equal(last.pose, pose)
            or not np.array_equal(last.velocity, velocity)
        ):
            last = _State(time, pose, velocity, self._loads(time, pose, velocity))
        self._begun = last
        for load in last.loads:
            engine.load[self._rows] += load

    def end(self, engine: Engine, time: float, time_step: float) -> None:
        """Put the velocities right at the end of a step, a time in s; what sleeps is left alone.

        Raises:
            SimulationError: a force is not finite; names it and a body.
        """
        assert self._begun is not None
        awake = ~engine.asleep[self._rows]
        if self._terms:
            self._ended = self._put_right(engine, self._begun, awake, time, time_step)
        self._slow_down(engine, time_step, awake)

    def _put_right(
        self,
        engine: Engine,
        before: _State,
        awake: NDArray[np.bool_],
        time: float,
        time_step: float,
    ) -> _State | None:
        """Put the velocities right, and return the state; None where loads are not yet its own.

        Loads that depend on velocities are found together with these. Where both agree to a few
        digits, the next step asks for them anew, as one that was restored does.
        """
        pose, reached = engine.pose[self._rows], engine.velocity[self._rows]
        velocity, last = reached, reached
        for _ in range(_MOST_ROUNDS):
            last, loads = velocity, self._loads(time, pose, velocity)
            after = _State(time, pose, last, loads)
            velocity = self._later(engine, reached, before, after, time_step)
            velocity[~awake] = reached[~awake]
            close = np.all(np.abs(velocity - last) <= _AGREED * np.abs(velocity))
            if close or not self._of_velocity:
                break
        self._look(engine, before, loads, pose, time_step)
        engine.velocity[self._rows] = velocity
        known = not self._of_velocity or np.array_equal(velocity, last)
        return _State(time, pose, velocity, loads) if known else None

    def _slow_down(
        self, engine: Engine, time_step: float, awake: NDArray[np.bool_] | None = None
    ) -> None:
        """Let quadratic drag act alone for half a step (DD55)."""
        if not self._drag.any():
            return
        velocity = engine.velocity[self._rows, :2].T
        mass = engine.inverse_mass[self._rows]
        with np.errstate(all="ignore"):
            slower = quadratic_step.velocity_later(tuple(velocity), self._drag, mass, time_step)
        slows = self._drag > 0.0 if awake is None else (self._drag > 0.0) & awake
        engine.velocity[self._rows[slows], :2] = np.stack(slower, axis=-1)[slows]

    def _later(
        self, engine: Engine, velocity: Array, before: _State, after: _State, time_step: float
    ) -> Array:
        """Return velocities (n, 3) with what the change of the loads puts right (DD53)."""
        by_pairs = self._pulls is not None and np.ptp(engine.early[self._rows]) > 0.0
        count = len(self._terms) - by_pairs
        was, now = (sum(state.loads[:count], np.zeros_like(velocity)) for state in (before, after))
        later = self._later_alone(engine, velocity, was, now, time_step)
        return self._later_by_pairs(engine, later, before, after, time_step) if by_pairs else later

    def _later_by_pairs(
        self, engine: Engine, velocity: Array, before: _State, after: _State, time_step: float
    ) -> Array:
        """Return velocities with what the change of pulls puts right, on both bodies alike."""
        assert self._pulls is not None
        early, mass = engine.early[self._rows], engine.inverse_mass[self._rows]
        ends = self._pulls.first, self._pulls.second
        share = spring_step.early_share(*(early[end] for end in ends))
        was, now = self._pulls.pulls(before.pose).T, self._pulls.pulls(after.pose).T
        later = velocity.copy()
        for end, side in zip(ends, (1.0, -1.0), strict=True):
            change = spring_step.velocity_later(
                (0.0, 0.0), mass[end], tuple(side * was), tuple(side * now), time_step, share
            )
            np.add.at(later[:, :2], end, np.stack(change, axis=-1))
        return later

    def _later_alone(
        self, engine: Engine, velocity: Array, was: Array, now: Array, time_step: float
    ) -> Array:
        """Return velocities with what the change of loads on each body puts right."""
        mass, inertia = engine.inverse_mass[self._rows], engine.inverse_inertia[self._rows]
        early = engine.early[self._rows]
        x, y = spring_step.velocity_later(
            tuple(velocity[:, :2].T), mass, tuple(was[:, :2].T), tuple(now[:, :2].T), time_step,
            early,
        )  # fmt: skip
        spin = spring_step.angular_velocity_later(
            velocity[:, 2], inertia, was[:, 2], now[:, 2], time_step, early
        )
        return np.stack((x, y, spin), axis=-1)

    def _look(
        self, engine: Engine, before: _State, after: Sequence[Array], pose: Array, time_step: float
    ) -> None:
        """Warn of forces that this step is too long for (DD54), each once; after it they are these.

        What is asked is how they change with the place alone.
        """
        moved = pose - before.pose
        mass, inertia = engine.inverse_mass[self._rows], engine.inverse_inertia[self._rows]
        far = np.abs(moved) > _RESOLVED * np.abs(pose)
        for term, was, now in zip(self._terms, before.loads, after, strict=True):
            if term.says in self._warned:
                continue
            if term.names & _OTHERS:
                now = self._load(term, before.time, pose, before.velocity)
            shortest = spring_step.critical_step(
                mass, tuple(was[:, :2].T), tuple(now[:, :2].T), tuple(moved[:, :2].T)
            )
            turning = spring_step.critical_step_turning(inertia, was[:, 2], now[:, 2], moved[:, 2])
            shortest = np.where(far[:, :2].any(axis=1), shortest, np.inf)
            shortest = np.minimum(shortest, np.where(far[:, 2], turning, np.inf))
            k = int(np.argmin(shortest))
            if shortest[k] < time_step:
                name = self._name_of(int(self._rows[k]))
                text = (
                    f"{term.says.replace('_', ' ')} at {before.time:.6g} s: the time step of "
                    f"{time_step:.6g} s is longer than {shortest[k]:.3g} s, beyond which the "
                    f"motion of {name} gains energy (DD54). Give a shorter step."
                )
                self._warned.tell([(term.says, text)])

    def _loads(self, time: float, pose: Array, velocity: Array) -> list[Array]:
        return [self._load(term, time, pose, velocity) for term in self._terms]

    def _load(self, term: LawTerm | Attraction, time: float, pose: Array, velocity: Array) -> Array:
        """Return the forces and torques (n, 3) of a term, or raise `SimulationError`."""
        found = np.zeros_like(pose)
        with np.errstate(all="ignore"):
            term.add(time, pose, velocity, found)
        if not (good := (np.abs(found) <= LARGEST).all(axis=1)).all():
            name = self._name_of(int(self._rows[np.argmin(good)]))
            raise SimulationError(
                f"{term.says.replace('_', ' ')} at {time!r} s: no finite force on "
                f"{name}, or one beyond {LARGEST:.2g} (R4): bodies are at one place, or float64 "
                "cannot hold what follows. Move it, or change the scene."
            )
        return found


def _terms(scene: Scene, bodies: Sequence[int]) -> list[LawTerm | Attraction]:
    found: list[LawTerm | Attraction] = [
        LawTerm(scene, bodies, component, law, places)
        for (component, law), places in varying_laws(scene, bodies).items()
    ]
    if scene.attraction is not None and len(bodies) > 1:
        found.append(Attraction(scene, bodies))
    return found
