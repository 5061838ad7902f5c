"""A scene followed step by step: its states at given times, and what began to touch."""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from tamias2d.engine.reports.contact_report import Contacts
from tamias2d.generated import impact
from tamias2d.motion.joint_events import JointEvent
from tamias2d.scene import Scene
from tamias2d.simulator.simulator import Simulator
from tamias2d.state import Array, History, place_between

SAME_STEP = 1e-9
"""Of a step: a time that is as near to its end is at it."""


class Overlap(NamedTuple):
    """How deep two bodies are in each other."""

    share: float
    """of the size of the smaller one: the radius around it"""
    depth: float
    """m"""
    bodies: tuple[int, int]
    time: float
    """s"""


class Met(NamedTuple):
    """Pairs that began to touch in one step."""

    time: float
    """The end of the step, s"""
    contacts: Contacts
    normal_velocity: Array
    """(m,), as the step began, m/s"""


class Stepper:
    """A scene on its way by steps: `go` to the end, then read what there was.

    The state at the end of a step is the engine's; between two ends velocities change linearly, and
    places as `place_between` says.
    """

    def __init__(self, scene: Scene, *, time_step: float, substeps: int, times: Array) -> None:
        """Prepare to tell the states at sorted times (k,), s, in steps of `time_step`, s."""
        self._sim = Simulator(scene, time_step=time_step, substeps=substeps)
        self._times = times
        count, bodies = len(times), len(scene)
        self._rows = np.zeros((count, 6, bodies))
        self._told = 0
        self._sizes = np.array([_size(body.shape) for body in scene.bodies])
        self.steps = 0
        self.contacts = 0
        """Points of contact that were solved, summed over all steps."""
        self.met: list[Met] = []
        self.joint_events: list[JointEvent[str]] = []
        self.deepest: Overlap | None = None
        """The deepest overlap of all steps."""
        self.split, self.most_parts = 0, 1
        """Steps that were taken in parts, and in how many at most."""
        self.last: Overlap | None = None
        """The deepest overlap as the last step began."""
        self._tell(self._state(), self._state(), 0.0)

    def go(self, duration: float, *, told: Callable[[float], None] = lambda _: None) -> None:
        """Step until a duration in s is over; `told` hears of every time that is reached.

        Raises:
            SimulationError: a force that varies has no finite value.
        """
        step = self._sim.time_step
        for _ in range(math.ceil(duration / step - SAME_STEP)):
            before = self._state()
            self._sim.step()
            self.steps += 1
            self.joint_events += self._sim.joint_events
            self.split += self._sim.parts > 1
            self.most_parts = max(self.most_parts, self._sim.parts)
            self._tell(before, self._state(), self._sim.time)
            self._look(before, min(self._sim.time, duration))
            told(self._sim.time)

    @property
    def time(self) -> float:
        """Which was reached, s."""
        return self._sim.time

    @property
    def warnings(self) -> tuple[str, ...]:
        """What was warned of on the way."""
        return self._sim.warnings

    def history(self) -> History:
        """Return the states at all times that were reached."""
        return _history(self._rows[: self._told])

    def _state(self) -> Array:
        return _state(self._sim)

    def _tell(self, before: Array, after: Array, end: float) -> None:
        """Write down the states at all times up to the end of a step, s."""
        step = self._sim.time_step
        while self._told < len(self._times):
            left = (end - float(self._times[self._told])) / step
            if left < -SAME_STEP:
                return
            self._rows[self._told] = _between(before, after, left, step)
            self._told += 1

    def _look(self, before: Array, time: float) -> None:
        """Note what touched in a step that ended at a time, s."""
        found, began = self._sim.contacts, self._sim.began
        self.contacts += len(found)
        if len(began):
            self.met.append(Met(time, began, _approach(before, began)))
        self.last = self._worst(found)
        if self.last and (self.deepest is None or self.last.share > self.deepest.share):
            self.deepest = self.last

    def _worst(self, found: Contacts) -> Overlap | None:
        if not len(found):
            return None
        share = -found.separation / self._sizes[found.bodies].min(axis=1)
        k = int(np.argmax(share))
        if share[k] <= 0.0:
            return None
        a, b = found.bodies[k].tolist()
        began = self._sim.time - self._sim.time_step
        return Overlap(float(share[k]), float(-found.separation[k]), (a, b), began)


def states_at(
    scene: Scene, *, time_step: float, substeps: int, times: Array, duration: float
) -> History:
    """Return the states at sorted times (k,), s, that a `Stepper` tells, without its contacts."""
    sim = Simulator(scene, time_step=time_step, substeps=substeps)
    sampling = Sampling(times.tolist(), duration, time_step)
    return sampling.history(states_of(sim, sampling))


class Sampling:
    """After how many steps states are needed, to tell those at sorted times, s, up to an end, s."""

    def __init__(self, times: Sequence[float], duration: float, time_step: float) -> None:
        self._time_step = time_step
        self._told: list[tuple[int, int, float]] = []  # steps before and after, share left
        steps = before = after = 0
        for time in times:
            last = _steps_until(time, time_step)
            if last > steps:
                if (last * time_step - time) / time_step >= SAME_STEP:
                    before = last - 1
                steps = after = last
            self._told.append((before, after, (steps * time_step - time) / time_step))
        end = max(math.ceil(duration / time_step - SAME_STEP), steps)
        self.stops = sorted({0, end, *(k for told in self._told for k in told[:2])})

    def history(self, states: Array) -> History:
        """Return the history of states (..., s, 6, n) at the stops."""
        place = {step: k for k, step in enumerate(self.stops)}
        rows = [
            _between(
                states[..., place[before], :, :], states[..., place[after], :, :], left,
                self._time_step,
            )
            for before, after, left in self._told
        ]  # fmt: skip
        return _history(np.stack(rows, axis=-3))


def states_of(sim: Simulator, sampling: Sampling) -> Array:
    """Return the states (s, 6, n) of a simulator, which has taken no step, at the stops.

    Raises:
        InputError: a number goes beyond float64 on the way.
        SimulationError: a force that varies has no finite value.
    """
    states = []
    for stop in sampling.stops:
        sim.step(stop - sim._engine.steps)
        states.append(_state(sim))
    return np.stack(states)


def _steps_until(time: float, time_step: float) -> int:
    """Return how many steps there are until one ends at a time, or beyond it."""
    steps = max(math.ceil(time / time_step - SAME_STEP) - 1, 0)
    while (steps * time_step - time) / time_step < -SAME_STEP:
        steps += 1
    return steps


def _between(before: Array, after: Array, left: float, time_step: float) -> Array:
    """Return the state at a time that is a share `left` of a step, s, before its end."""
    if left < SAME_STEP:
        return after
    share = np.array(1.0 - left)
    place, rate = np.split(before, 2, axis=-2)
    next_place, next_rate = np.split(after, 2, axis=-2)
    places = place_between(place, next_place, rate, next_rate, time_step, share)
    return np.concatenate((places, rate + share * (next_rate - rate)), axis=-2)


def _state(sim: Simulator) -> Array:
    """Return (6, n): place, orientation, velocity and angular velocity now."""
    return np.concatenate((sim._engine.pose.T, sim._engine.velocity.T))


def _history(rows: Array) -> History:
    """Return the history of states (..., k, 6, n)."""
    x, y, turn, u, v, spin = np.moveaxis(rows, -2, 0)
    return History(np.stack((x, y), axis=-1), turn, np.stack((u, v), axis=-1), spin)


def _size(shape: object) -> float:
    radius: float = getattr(shape, "bounding_radius", math.inf)
    return radius


def _approach(before: Array, began: Contacts) -> Array:
    """Return how fast points of contact opened (m,), m/s, with the motion before a step."""
    place, turning = before[:2].T, before[5]
    a, b = began.bodies.T
    rates: Array = impact.normal_velocity(
        tuple(before[3:5, a]),
        turning[a],
        tuple((began.point - place[a]).T),
        tuple(before[3:5, b]),
        turning[b],
        tuple((began.point - place[b]).T),
        tuple(began.normal.T),
    )
    return rates
