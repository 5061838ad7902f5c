"""Steps of smooth motion by kernels: all forces of a group of bodies, by any generated scheme.

Serves: `solve`, which lets a motion step by it. Hides: the rows of numbers that kernels take, and
whether they are compiled.
"""

from collections.abc import Callable, Sequence
from dataclasses import astuple
from typing import Any

import numpy as np

from tamias2d.kernels.choice import kernel
from tamias2d.kernels.force_demand import ForceDemand, Tables, forces_on
from tamias2d.kernels.force_source import arguments
from tamias2d.kernels.march_source import (
    DONE,
    ERROR,
    EVALUATIONS,
    KNOWN,
    REJECTED,
    SETTLED,
    STEP,
    march,
)
from tamias2d.motion.integrated import IntegratedMotion
from tamias2d.motion.loads import Loads
from tamias2d.motion.marching import Control, Marching, Start, Steps
from tamias2d.motion.motion import Motion
from tamias2d.scene import Scene
from tamias2d.scene.acting import felt_velocity
from tamias2d.state import Array

_PLAIN = 32  # steps at once as plain Python, after which compiling may have come to pay
_TOLD = 6  # places in `told`


def march_by_kernels(motion: Motion, scene: Scene) -> None:
    """Let a motion by a generated scheme take its steps by kernels."""
    if isinstance(motion, IntegratedMotion):
        motion.marching = _makers(scene)


def _makers(scene: Scene) -> Callable[[Sequence[int]], Marching | None]:
    felt = bool(Loads(scene).varying) and felt_velocity(scene)

    def marching(bodies: Sequence[int]) -> Marching | None:
        found = forces_on(scene, bodies) if bodies else None
        return None if found is None else KernelMarching(*found, felt=felt)

    return marching


class KernelMarching:
    """Steps of some bodies by kernels (`Marching`)."""

    def __init__(self, demand: ForceDemand, tables: Tables, *, felt: bool) -> None:
        self._demand = demand
        self._tables = [tables[name] for name in arguments(demand)]
        self._lists = [table.tolist() for table in self._tables]
        self._felt = felt

    def fixed(self, scheme: str, times: Sequence[float], start: Start, ahead: float) -> Steps:
        """Step from each of the times to the next."""
        call = _Call(self, scheme, start, len(times) - 1, ahead)
        call.rows[0][:] = times[: call.most + 1]
        count = call.go()
        return call.steps(count, finished=count == call.most)

    def adaptive(
        self, scheme: str, time: float, limit: float, most: int, start: Start, control: Control
    ) -> Steps:
        """Take at most some steps towards a limit."""
        ahead = (limit - time) / control.step
        call = _Call(self, scheme, start, most, ahead)
        call.rows[0][0] = time
        numbers = np.array(astuple(control)) if call.compiled else list(astuple(control))
        count = call.go(limit, control=numbers)
        finished = count == call.most or bool(call.rows[0][count] >= limit)
        if count:
            control.step, control.error = float(numbers[STEP]), float(numbers[ERROR])
        return call.steps(count, finished=finished)


class _Call:
    """One call of a kernel: its rows of numbers, and what they mean."""

    def __init__(
        self, owner: KernelMarching, scheme: str, start: Start, most: int, ahead: float
    ) -> None:
        found = march(scheme, owner._demand)
        self._code = kernel(found.text, found.plain, "advance")
        self.compiled = self._code.compiled(ahead)
        self.most = most if self.compiled else min(most, _PLAIN)
        self._start = start
        self._slopes = found.slopes
        self._axes = owner._demand.axes
        self._size = self._axes * len(start.position)
        shape = (self.most + 1, self._size)
        make = _empty if self.compiled else _lists
        self.rows = [make((self.most + 1,)), *(make(shape) for _ in range(3))]
        self._dense = make((self.most, found.slopes * self._size)) if found.slopes else None
        work = make((found.rows, self._size))
        self._told = np.zeros(_TOLD, dtype=np.int64) if self.compiled else [0] * _TOLD
        tables = owner._tables if self.compiled else owner._lists
        self._rest = (work, self._told, owner._felt, *tables)
        for row, given in zip(self.rows[1:], start, strict=True):
            if given is not None:
                flat = given[:, : self._axes].T.ravel()
                row[0][:] = flat if self.compiled else flat.tolist()
        self._told[KNOWN] = int(start.acceleration is not None)

    def go(self, *first: Any, control: Any = None) -> int:
        """Run the kernel; return how many steps it took."""
        if self._axes == 2 and self._start.velocity[:, 2].any():
            return 0  # what turned them is unknown here
        extra = () if self._dense is None else (self._dense, control)
        arguments = (*first, *self.rows, *extra, *self._rest)
        if self.compiled is not None:
            return int(self.compiled(*arguments))
        try:
            return self._code.plain(*arguments)
        except (ArithmeticError, ValueError):  # where compiled code goes on with what is not finite
            return int(self._told[DONE])

    def steps(self, count: int, *, finished: bool) -> Steps:
        """Return the steps; what one that was begun and not ended has cost is left out."""
        times, *states = self.rows
        told = self._told[SETTLED : SETTLED + 2]
        if finished:
            told = self._told[EVALUATIONS], self._told[REJECTED]
        position, velocity, _ = self._start
        knots = np.zeros((count + 1, 3, len(position), 3))
        for part, rows in enumerate(states):
            knots[:, part, :, : self._axes] = self._bodies(np.array(rows[: count + 1]))
        if self._axes == 2:
            knots[:, 0, :, 2] = position[:, 2]
        dense = np.zeros((self._slopes, count, len(position), 3))
        if self._dense is not None and count:
            slopes = np.array(self._dense[:count]).reshape(count, self._slopes, self._size)
            dense[..., : self._axes] = self._bodies(slopes.swapaxes(0, 1))
        ends = np.array(times[: count + 1]).tolist()
        return Steps(ends, knots, bool(self._told[KNOWN]), dense, int(told[0]), int(told[1]))

    def _bodies(self, rows: Array) -> Array:
        """Return rows (..., axes n) as (..., n, axes)."""
        return rows.reshape(*rows.shape[:-1], self._axes, -1).swapaxes(-1, -2)


def _empty(shape: tuple[int, ...]) -> Array:
    return np.zeros(shape)


def _lists(shape: tuple[int, ...]) -> list[Any]:
    if len(shape) == 1:
        return [0.0] * shape[0]
    return [[0.0] * shape[1] for _ in range(shape[0])]
