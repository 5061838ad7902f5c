"""What is wrong with a run by steps through contacts, against runs of shorter steps.

Places are compared up to the horizon, where these agree. Overlap and energy need nothing to compare
with, and count over the whole run. What is left after the horizon are the means of a number of runs
with starts next to each other (`statistics`).
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tamias2d.balance import balance, kinetic_energy
from tamias2d.scene import Scene
from tamias2d.state import Array, History
from tamias2d.study.engines.engine import Pair
from tamias2d.study.error import distance
from tamias2d.study.invariants import energy_error
from tamias2d.study.scale import radii

_SLOW = 0.02  # of the speed of a fall by half the radius: what is slower is at rest, as in sleep
_FAST = 0.1  # of the same: what is faster must get on
_HANGS = 0.2  # of its way by its own velocity, and less, goes what hangs


@dataclass(frozen=True, kw_only=True)
class ContactErrors:
    """None where a measure does not apply."""

    position: float
    """Distance of any point of any body up to the horizon, relative to the length there."""
    centre: float
    """The same of the common centre of mass."""
    event_time: float | None
    """Of the first contact of each pair up to the horizon, relative to the horizon."""
    missed: int | None
    """Pairs that should have touched up to there, and did not."""
    extra: int | None
    """Pairs that touched up to there, and should not."""
    overlap: float
    """The deepest of the whole run, relative to the radius of the smaller body."""
    energy: float | None
    """Change of the energy that no impact, friction or joint accounts for, relative."""
    momentum: float | None
    """Change of the momentum less that by weight, relative; where nothing stands in the way."""
    hang: float
    """Share of fast bodies that go less than a fifth of the way that their velocity says."""
    rest: float | None
    """By how much the time differs when all has come to rest, relative to the duration."""

    @property
    def size(self) -> float:
        """That of places."""
        return self.position

    @property
    def quality(self) -> float:
        """The larger of overlap and energy."""
        return max(self.overlap, self.energy or 0.0)


@dataclass(frozen=True)
class Followed:
    """A run by any engine, as it was looked at."""

    history: History
    """At the common times"""
    hang: float
    met: dict[Pair, float] | None
    """When pairs first touched, s; None if nobody listened"""
    overlap: float
    """Relative to the radius of the smaller body"""


@dataclass(frozen=True)
class Answer:
    """What others are compared with: a run of short steps, as far as it is one."""

    history: History
    times: Array
    """(k,), s"""
    horizon: float
    """s"""
    length: float
    """m: what errors up to there are relative to"""
    met: dict[Pair, float]


def contact_errors(scene: Scene, found: Followed, answer: Answer) -> ContactErrors:
    """Return how far what was found is from the answer."""
    known = answer.times <= answer.horizon
    history, true = _until(found.history, known), _until(answer.history, known)
    off = np.linalg.norm(_centre(scene, history) - _centre(scene, true), axis=-1)
    energy, _, _ = balance(scene, found.history)
    kinetic = kinetic_energy(scene, found.history.velocity, found.history.angular_velocity)
    late, missed, extra = _events(found, answer)
    return ContactErrors(
        position=_finite(float(distance(scene, history, true).max()) / answer.length),
        centre=_finite(float(off.max()) / answer.length),
        event_time=late,
        missed=missed,
        extra=extra,
        overlap=found.overlap,
        energy=energy_error(scene, energy, kinetic),
        momentum=_momentum(scene, found.history, answer.times),
        hang=found.hang,
        rest=_rest(scene, found.history, answer),
    )


def hanging(scene: Scene, before: Array, after: Array, time_step: float) -> tuple[int, int]:
    """Return how many fast bodies hang in a step between states (n, 6), and how many are fast."""
    moving = np.array([body.dynamic for body in scene.bodies], dtype=bool)
    speed = np.hypot(before[:, 3], before[:, 4])
    went = np.hypot(*(after - before)[:, :2].T)
    fast = moving & (speed > _FAST * _usual_speed(scene))
    return int((fast & (went < _HANGS * speed * time_step)).sum()), int(fast.sum())


def statistics(scene: Scene, histories: list[History]) -> dict[str, tuple[float, float]]:
    """Return the mean at the end over runs, and half the width of its 95 % interval.

    Of the height of the centre of mass, m, of how far bodies extend across the fall, m, and of the
    kinetic energy, J.
    """
    down = np.array(scene.gravity)
    down = down / np.hypot(*down) if np.hypot(*down) else np.array([0.0, -1.0])
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    values: dict[str, list[float]] = {"height": [], "extent": [], "kinetic": []}
    for history in histories:
        across = history.position[-1, moving] @ np.array([-down[1], down[0]])
        values["height"].append(float(-_centre(scene, history)[-1] @ down))
        values["extent"].append(float(np.ptp(across)))
        spin = history.angular_velocity[-1:]
        values["kinetic"].append(float(kinetic_energy(scene, history.velocity[-1:], spin)[0]))
    return {name: _mean(found) for name, found in values.items()}


def _mean(values: list[float]) -> tuple[float, float]:
    from scipy.stats import t

    count = len(values)
    if count < 2:
        return float(np.mean(values)), math.inf
    width = float(t.ppf(0.975, count - 1)) * float(np.std(values, ddof=1)) / math.sqrt(count)
    return float(np.mean(values)), width


def _until(history: History, known: NDArray[np.bool_]) -> History:
    return History(*(part[known] for part in history))


def _centre(scene: Scene, history: History) -> Array:
    """Return (k, 2), m: the centre of mass of all that moves."""
    mass = np.array([body.mass if body.dynamic else 0.0 for body in scene.bodies])
    found: Array = np.einsum("n,knx->kx", mass, history.position) / mass.sum()
    return found


def _events(found: Followed, answer: Answer) -> tuple[float | None, int | None, int | None]:
    """Return how late first contacts are, and how many pairs are missed and extra."""
    if found.met is None:
        return None, None, None
    true = {pair for pair, time in answer.met.items() if time <= answer.horizon}
    ours = {pair for pair, time in found.met.items() if time <= answer.horizon}
    late = [abs(found.met[p] - answer.met[p]) for p in true if p in found.met]
    missed = len(true - found.met.keys())
    extra = len(ours - answer.met.keys())
    return max(late, default=0.0) / answer.horizon, missed, extra


def _momentum(scene: Scene, history: History, times: Array) -> float | None:
    """Return the change of the momentum that no weight accounts for, relative to the largest."""
    if any(not body.dynamic for body in scene.bodies) or scene.joints or scene.fields:
        return None
    _, momentum, _ = balance(scene, history)
    mass = sum(body.mass for body in scene.bodies)
    weight = mass * np.outer(times, scene.gravity)
    speeds = np.linalg.norm(history.velocity, axis=-1)
    largest = float((speeds @ np.array([body.mass for body in scene.bodies])).max())
    off = float(np.linalg.norm(momentum - momentum[0] - weight, axis=-1).max())
    return off / largest if largest else 0.0


def _rest(scene: Scene, history: History, answer: Answer) -> float | None:
    ours, true = (_at_rest(scene, one, answer.times) for one in (history, answer.history))
    if true is None:
        return None
    end = float(answer.times[-1])
    return abs((end if ours is None else ours) - true) / end


def _at_rest(scene: Scene, history: History, times: Array) -> float | None:
    """Return the time, s, from which on all bodies are slow; None if some is not at the end."""
    speed = np.linalg.norm(history.velocity, axis=-1)
    speed = speed + np.abs(history.angular_velocity) * radii(scene)
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    fast = np.flatnonzero((speed[:, moving] > _SLOW * _usual_speed(scene)).any(axis=1))
    if not len(fast):
        return 0.0
    return float(times[fast[-1] + 1]) if fast[-1] + 1 < len(times) else None


def _usual_speed(scene: Scene) -> float:
    """Return the speed of a fall by half the smallest radius, m/s, or the largest at the start."""
    reach = radii(scene)
    smallest = float(reach[reach > 0].min(initial=math.inf))
    pull = math.hypot(*scene.gravity)
    if pull and math.isfinite(smallest):
        return math.sqrt(pull * smallest)
    return max((math.hypot(*body.velocity) for body in scene.bodies), default=0.0)


def _finite(value: float) -> float:
    return value if math.isfinite(value) else math.inf
