"""The reference: scipy's DOP853, as tight as asked.

Only this module of `motion` imports scipy.
"""

from dataclasses import replace
from functools import cache

import numpy as np

from tamias2d.errors import SimulationError
from tamias2d.motion.law_resolution import LawResolution
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.polynomial import DenseStep
from tamias2d.state import Array

_NODES = -np.cos(np.pi * np.arange(10) / 9)  # in x from -1 to 1, where the accelerations are taken

_STAGES = 12


class NoStepError(SimulationError):
    """The reference cannot step on; `run` is the history up to there."""

    code = "no-step"


class _Trials:
    """The rate of a state of bodies, which scipy asks for in the trials of a step.

    A trial that meets no finite state or force is no number: the step is taken again, shorter.
    """

    def __init__(self, field: MemoisedField, shape: tuple[int, ...]) -> None:
        self._field, self._shape = field, shape
        self.refusal: SimulationError | None = None
        """Why the last trial that met no finite force met none, if any did not."""

    def rate(self, time: float, y: Array) -> Array:
        """Return the rate of a state: velocities (n, 3), then accelerations, both in one row."""
        half = len(y) // 2
        q, v = y[:half].reshape(self._shape), y[half:].reshape(self._shape)
        return np.concatenate((y[half:], self._field(float(time), q, v).ravel()))

    def __call__(self, time: float, y: Array) -> Array:
        """Return the rate of a state, or no numbers."""
        if np.isfinite(y).all():
            try:
                return self.rate(time, y)
            except SimulationError as refusal:
                self.refusal = refusal
        return np.full_like(y, np.nan)


class ScipyDop853:
    """Adaptive steps of order 8.

    Between their ends DOP853 knows less than at them. So the path is taken from the accelerations
    at ten times of the step, integrated twice, which is better by two orders.

    `scale` is (length in m, time in s): what counts as not small, for the absolute tolerance of
    quantities that pass through 0.
    """

    best_at_ends = False

    def __init__(self, rtol: float, scale: tuple[float, float], resolution: LawResolution) -> None:
        self._rtol = rtol
        self._resolution = resolution
        self._scale = scale
        self._proposed: dict[int, float] = {}

    def step(
        self, field: MemoisedField, start: float, limit: float, position: Array, velocity: Array
    ) -> DenseStep:
        """Take one step, of the length that the tolerance and the laws allow."""
        if not position.size:
            return _dense_step(start, limit, position, velocity, np.zeros((10, *position.shape)))
        while True:
            step = self._step(field, start, limit, position, velocity)
            times = step.start, step.end
            missed = self._resolution.unresolved(
                field.bodies,
                times,
                step.states,
                relative=self._rtol,
                rate=self._rtol * self._scale[0] / self._scale[1],
            )
            if missed is None:
                return step
            limit = missed.time

    def _step(
        self, field: MemoisedField, start: float, limit: float, position: Array, velocity: Array
    ) -> DenseStep:
        """Take one step, of the length that the tolerance and finite forces allow."""
        from scipy.integrate import DOP853

        shape, size = position.shape, position.size
        trials = _Trials(field, shape)
        y = np.concatenate((position.ravel(), velocity.ravel()))
        if not np.isfinite(y).all():
            raise NoStepError(
                f"run at {start!r} s: its state is beyond what float64 holds, about 1e308 (R4). "
                "Give smaller loads, or a shorter duration."
            )
        trials.rate(start, y)  # where no force is finite here, no step is short enough
        hint = self._proposed.get(size)
        solver = DOP853(
            trials,
            start,
            y,
            limit,
            rtol=self._rtol,
            atol=self._tolerance(len(position)),  # type: ignore[arg-type]
            first_step=None if hint is None else min(hint, limit - start),
        )
        if not solver.h_abs > 0.0:  # DOP853 looks for a step for ever
            raise NoStepError(
                f"run at {start!r} s: its lengths or times are too small for float64 (R4). Give "
                "larger ones, or 0."
            )
        before = solver.nfev
        solver.step()
        if solver.status == "failed":
            raise self._failed(start, trials.refusal)
        field.tally.rejected += (solver.nfev - before) // _STAGES - 1
        self._proposed[size] = float(solver.h_abs)
        between = solver.dense_output()
        end = float(solver.t)
        times = start + (end - start) * (_NODES + 1) / 2
        states = [between(time) for time in times]
        second = np.stack([trials(t, y)[size:] for t, y in zip(times, states, strict=True)])
        if np.isfinite(states).all() and not np.isfinite(second).all():
            if not start < (middle := (start + end) / 2) < end:
                raise self._failed(start, trials.refusal)
            return self._step(field, start, middle, position, velocity)
        return _dense_step(start, end, position, velocity, second.reshape(-1, *shape))

    def _failed(self, start: float, refusal: SimulationError | None) -> SimulationError:
        """Return the error of no step at all: where a longer trial met no finite force, that."""
        if refusal is not None:
            return refusal
        return NoStepError(
            f"run at {start!r} s: no step of the reference meets its tolerance {self._rtol:g} "
            "(R5). Give loads that change less suddenly, or a larger rtol."
        )

    def _tolerance(self, bodies: int) -> Array:
        length, time = self._scale
        position = np.tile([length, length, 1.0], bodies)
        return self._rtol * np.concatenate((position, position / time))


def _dense_step(
    start: float, end: float, position: Array, velocity: Array, accelerations: Array
) -> DenseStep:
    """Return the path from a state on with given accelerations (10, n, 3) at the nodes."""
    half = (end - start) / 2
    changes = accelerations - accelerations[0]  # what is constant is kept to the bit
    second = np.tensordot(_fit(), changes, axes=1)
    second[0] += accelerations[0]
    power = np.arange(len(second))[:, None, None]
    bend = half**2 * second / ((power + 1) * (power + 2))
    sign = (-1.0) ** power
    slope = half * velocity + (bend * (power + 2) * sign).sum(axis=0)
    value = position + slope - (bend * sign).sum(axis=0)
    step = DenseStep(
        start, end, (position, velocity), (position, velocity), np.stack((value, slope, *bend))
    )
    last = (step.coefficients.sum(axis=0), (slope + (bend * (power + 2)).sum(axis=0)) / half)
    return replace(step, last=last)


@cache
def _fit() -> Array:
    """Return the matrix from the values at all nodes to the coefficients of the powers of x."""
    return np.asarray(np.linalg.inv(_NODES[:, None] ** np.arange(len(_NODES))), dtype=np.float64)
