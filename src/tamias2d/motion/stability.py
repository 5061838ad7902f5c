"""Whether a scheme is stable at a time step, found before it runs.

The accelerations are made linear at the start of the run, by differences. One step of the scheme
is then a matrix for each group of bodies that act on each other, and no eigenvalue of it may be
larger than what the exact motion does in that time.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from tamias2d.errors import SimulationError, TamiasError
from tamias2d.motion.fixed_steps import FixedSteps
from tamias2d.motion.loads import Field, Loads, coordinates, start_states
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.motion import Tally
from tamias2d.scene import Scene
from tamias2d.state import Array

_DIFFERENCE = 2.0**-17  # of what is not small: central differences are best there
_LARGEST_GROUP = 20  # bodies; of larger ones the fastest motion alone is found
_ITERATIONS = 16
_GROUPS = 16  # the stiffest ones are looked at
_EXCESS = 1e-6  # of growth, that rounding can bring about
_COARSE = 1.1  # of growth in a step
_RUINED = 100.0  # of growth in a run


class StabilityError(SimulationError):
    """A scheme is unstable at the time step that was asked for.

    `critical_step` is the longest stable one, s; 0 if there is none.
    """

    code = "unstable-step"

    def __init__(self, message: str, critical_step: float) -> None:
        super().__init__(message)
        self.critical_step = critical_step


@dataclass(frozen=True)
class Linear:
    """The accelerations of m bodies near the start, as a linear function."""

    bodies: tuple[int, ...]
    by_position: Array
    """(3m, 3m), 1/s^2"""
    by_velocity: Array
    """(3m, 3m), 1/s"""

    def __call__(self, _: float, position: Array, velocity: Array) -> Array:
        """Return the accelerations (..., m, 3), for one state or for many."""
        flat = (*position.shape[:-2], -1)
        rows = position.reshape(flat) @ self.by_position.T
        return (rows + velocity.reshape(flat) @ self.by_velocity.T).reshape(position.shape)

    @property
    def eigenvalues(self) -> NDArray[np.complex128]:
        """Of the motion, 1/s."""
        size = len(self.by_position)
        above = np.hstack((np.zeros((size, size)), np.eye(size)))
        below = np.hstack((self.by_position, self.by_velocity))
        return np.linalg.eigvals(np.vstack((above, below))).astype(np.complex128)

    def pace(self, time_step: float) -> float:
        """Return how much happens in a step, as a number to sort by."""
        faster = np.abs(self.by_position).sum(axis=1).max() * time_step**2
        return float(faster + np.abs(self.by_velocity).sum(axis=1).max() * time_step)


def check(
    scene: Scene, what: str, steps: FixedSteps, *, duration: float, time_step: float, scale: float
) -> tuple[str, ...]:
    """Return notes on growth that a run survives; `scale` is a length that is not small, m.

    Raises:
        StabilityError: a run would be ruined.
    """
    time_step = min(time_step, duration)
    found = sorted(linearised(scene, duration, scale), key=lambda one: -one.pace(time_step))
    distinct = {one.by_position.tobytes() + one.by_velocity.tobytes(): one for one in found}
    for linear in list(distinct.values())[:_GROUPS]:
        excess = partial(_excess, linear, steps)
        growth = excess(time_step)
        if growth <= 1 + _EXCESS:
            continue
        critical = _critical(excess, time_step)
        if critical * np.abs(linear.eigenvalues).max() < 2 * math.sqrt(2 * _EXCESS):
            critical = 0.0  # the growth is still there, and only too small to see
        total = math.exp(min(math.log(growth) * duration / time_step, 700.0))
        names = ", ".join(f"'{scene.bodies[i].name}'" for i in linear.bodies[:3])
        stable = f"up to {_rounded_down(critical):.4g} s" if critical else "at no step"
        said = (
            f"{what} at time_step {time_step:g} s: errors of {names} grow by the factor "
            f"{growth:.4g} in each step, {total:.3g} in the run: it is stable {stable}"
        )
        if growth <= _COARSE and total <= _RUINED:
            return (f"stability: {said}",)
        remedy = "Give that or less" if critical else "Use VelocityVerlet()"
        raise StabilityError(f"{said} (R5). {remedy}, or a method that adapts its steps.", critical)
    return ()


def _excess(linear: Linear, steps: FixedSteps, time_step: float) -> float:
    """Return by how much a step grows more than the motion does, or than 1."""
    count = 3 * len(linear.bodies)
    field = MemoisedField(linear, linear.bodies, [None] * len(linear.bodies), Tally())

    def after(states: Array) -> Array:
        q, rate = states.reshape(-1, 2, count // 3, 3).swapaxes(0, 1)
        ends = steps.advance(field, 0.0, time_step, q, rate)
        return np.stack(ends, axis=1).reshape(len(states), -1)

    def one_by_one(states: Array) -> Array:
        ends = (steps.advance(field, 0.0, time_step, *state.reshape(2, -1, 3)) for state in states)
        return np.stack([np.concatenate(end, axis=None) for end in ends])

    starts = np.concatenate((np.zeros((1, 2 * count)), np.eye(2 * count)))
    with np.errstate(over="ignore", invalid="ignore"):
        still, *moved = (after if steps.plain else one_by_one)(starts)  # still: of constant loads
        matrix = np.stack([row - still for row in moved], axis=1)
        exact = np.exp(time_step * linear.eigenvalues.real.max())
    if not np.isfinite(matrix).all():
        return math.inf
    return float(np.abs(np.linalg.eigvals(matrix)).max() / max(exact, 1.0))


def _critical(excess: Callable[[float], float], time_step: float) -> float:
    """Return the longest stable step below an unstable one, s."""
    low = high = time_step
    while excess(low) > 1 + _EXCESS and low > 1e-9 * time_step:
        low, high = low / 2, low
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (low, middle) if excess(middle) > 1 + _EXCESS else (middle, high)
    return low


def _rounded_down(value: float) -> float:
    """Return a positive number with four digits, none of them rounded up."""
    unit = 10.0 ** (math.floor(math.log10(value)) - 3)
    return math.floor(value / unit) * unit


def linearised(scene: Scene, duration: float, scale: float) -> list[Linear]:
    """Return the accelerations at the start, of each group of bodies whose loads vary.

    Nothing is returned where the loads near the start have no value.
    """
    loads = Loads(scene)
    groups = {min(loads.group_of[i]): tuple(loads.group_of[i]) for i in loads.varying}
    small = [group for group in groups.values() if len(group) <= _LARGEST_GROUP]
    try:
        found = _by_columns(scene, loads, small, duration, scale)
        for group in groups.values():
            if len(group) > _LARGEST_GROUP:
                found.append(_fastest(_near_start(scene, loads, group, duration, scale), group))
    except TamiasError:
        return []
    return found


@dataclass(frozen=True)
class _Near:
    """Accelerations around the start, as differences along directions (2, n, 3)."""

    field: Field
    start: Array
    sizes: Array
    """(2, 1, 3), of coordinates and rates that are not small"""

    def along(self, direction: Array) -> Array:
        """Return how the accelerations (n, 3) change along a direction."""
        step = _DIFFERENCE * direction * self.sizes
        after, before = self.start + step, self.start - step
        return (self.field(0.0, *after) - self.field(0.0, *before)) / (2 * _DIFFERENCE)


def _near_start(
    scene: Scene, loads: Loads, bodies: Sequence[int], duration: float, scale: float
) -> _Near:
    states = start_states(scene)
    start = np.stack(coordinates([states[i] for i in bodies]))
    speed = max(float(np.abs(start[1, :, :2]).max()), scale / duration)
    spin = max(float(np.abs(start[1, :, 2]).max()), 1 / duration)
    sizes = np.array([[[scale, scale, 1.0]], [[speed, speed, spin]]])
    return _Near(loads.field(bodies, [None] * len(bodies)), start, sizes)


def _by_columns(
    scene: Scene, loads: Loads, groups: Sequence[tuple[int, ...]], duration: float, scale: float
) -> list[Linear]:
    """Differences along each coordinate, of all groups at once: they do not feel each other."""
    if not groups:
        return []
    bodies = [body for group in groups for body in group]
    rows = np.split(np.arange(len(bodies)), np.cumsum([len(group) for group in groups])[:-1])
    near = _near_start(scene, loads, bodies, duration, scale)
    matrices = [np.zeros((2, 3 * len(group), 3 * len(group))) for group in groups]
    for place in range(max(map(len, groups))):
        for part, axis in np.ndindex(2, 3):
            direction = np.zeros_like(near.start)
            direction[part, [row[place] for row in rows if place < len(row)], axis] = 1.0
            change = near.along(direction) / near.sizes[part, 0, axis]
            for row, matrix in zip(rows, matrices, strict=True):
                if place < len(row):
                    matrix[part, :, 3 * place + axis] = change[row].ravel()
    return [Linear(group, *matrix) for group, matrix in zip(groups, matrices, strict=True)]


def _fastest(near: _Near, bodies: tuple[int, ...]) -> Linear:
    """Return one body that swings and decays as fast as anything in a large group."""
    fastest = []
    for part in range(2):
        direction = np.zeros_like(near.start)
        direction[part] = np.cos(np.arange(direction[part].size)).reshape(-1, 3)
        size = 0.0
        for _ in range(_ITERATIONS):
            direction /= np.linalg.norm(direction)
            direction[part] = near.along(direction / near.sizes)
            size = float(np.linalg.norm(direction))
            if size == 0:
                break
        fastest.append(size)
    return Linear(bodies[:1], -fastest[0] * np.eye(3), -fastest[1] * np.eye(3))
