"""One call of a kernel that takes many steps.

Serves: the steps of smooth motion, of free bodies and of those that joints hold. Hides: the rows of
numbers that kernels take.
"""

from collections.abc import Callable
from dataclasses import astuple
from typing import Any, Protocol

import numpy as np

from tamias2d.kernels.choice import Kernel
from tamias2d.kernels.march_source import (
    DONE,
    ERROR,
    EVALUATIONS,
    KNOWN,
    REJECTED,
    SETTLED,
    STEP,
    March,
)
from tamias2d.motion.marching import Control, Start, Steps
from tamias2d.state import Array

_PLAIN = 32  # steps at once as plain Python, after which compiling may have come to pay
_TOLD = 6  # places in `told`


class Marched(Protocol):
    """What is stepped."""

    axes: int
    """How many coordinates of each body change."""
    tables: list[Any]

    @property
    def lists(self) -> list[list[Any]]:
        """The tables as plain Python takes them."""


class MarchCall:
    """One call of a kernel: its rows of numbers, and what they mean."""

    def __init__(
        self,
        owner: Marched,
        found: March,
        code: Kernel,
        compiled: Callable[..., Any] | None,
        start: Start,
        most: int,
        *,
        felt: bool,
    ) -> None:
        """Take what is stepped, from where, by which code, and whether it feels velocities."""
        self._code = code
        self.compiled = compiled
        self.most = most if self.compiled else min(most, _PLAIN)
        self._start = start
        self._slopes = found.slopes
        self._axes = owner.axes
        size = self._axes * len(start.position)
        states = (self._rows(self.most + 1, size) for _ in range(3))
        self.rows = [self.array([0.0] * (self.most + 1)), *states]
        self._reached = self._rows(self.most, 3, size) if found.returns else None
        self._dense = self._rows(self.most, found.slopes, size) if found.slopes else None
        self._told = self.array([0] * _TOLD)
        scheme = (self.array(part) if isinstance(part, list) else part for part in found.scheme)
        self.work = [self._rows(count, size) for count in found.work]
        tables = owner.tables if self.compiled else owner.lists
        self._rest = (*scheme, *self.work, self._told, felt, *tables)
        for row, given in zip(self.rows[1:], start, strict=True):
            if given is not None:
                row[0][:] = self.row(given)
        self._told[KNOWN] = int(start.acceleration is not None)

    def array(self, values: list[Any]) -> Any:
        """Return values as the code takes them."""
        return np.array(values) if self.compiled else values

    def row(self, given: Array) -> Any:
        """Return coordinates (n, 3), or their rates, as one row."""
        return self.array(given[:, : self._axes].T.ravel().tolist())

    def _rows(self, *shape: int) -> Any:
        rows = np.zeros(shape)
        return rows if self.compiled else rows.tolist()

    def go(self, *first: Any, control: Any = None) -> int:
        """Run the kernel; return how many steps it took."""
        reached = () if self._reached is None else (self._reached,)
        extra = () if self._dense is None else (self._dense, control)
        arguments = (*first, *self.rows, *reached, *extra, *self._rest)
        if self.compiled is not None:
            return int(self.compiled(*arguments))
        try:
            return self._code.plain(*arguments)
        except (ArithmeticError, ValueError):  # where compiled code goes on with what is not finite
            return int(self._told[DONE])

    def adaptive(self, time: float, limit: float, control: Control) -> Steps:
        """Take steps towards a limit, s, and set the control for what follows."""
        self.rows[0][0] = time
        numbers = self.array(list(astuple(control)))
        count = self.go(self.array([limit]), control=numbers)
        finished = count == self.most or bool(self.rows[0][count] >= limit)
        if count:
            control.step, control.error = float(numbers[STEP]), float(numbers[ERROR])
        return self.steps(count, finished=finished)

    def steps(self, count: int, *, finished: bool) -> Steps:
        """Return the steps; what one that was begun and not ended has cost is left out."""
        times, *states = self.rows
        told = self._told[SETTLED : SETTLED + 2]
        if finished:
            told = self._told[EVALUATIONS], self._told[REJECTED]
        position = self._start.position
        knots = np.zeros((count + 1, 3, len(position), 3))
        for part, rows in enumerate(states):
            knots[:, part, :, : self._axes] = self.bodies(np.array(rows[: count + 1]))
        if self._axes == 2:
            knots[:, 0, :, 2] = position[:, 2]
        dense = np.zeros((self._slopes, count, len(position), 3))
        if self._dense is not None and count:
            slopes = np.array(self._dense[:count])
            dense[..., : self._axes] = self.bodies(slopes.swapaxes(0, 1))
        reached = None
        if self._reached is not None:
            reached = self.bodies(np.array(self._reached[: self.most]))[:count]
        ends = np.array(times[: count + 1]).tolist()
        known = bool(self._told[KNOWN])
        return Steps(ends, knots, known, dense, int(told[0]), int(told[1]), reached)

    def bodies(self, rows: Array) -> Array:
        """Return rows (..., axes n) as (..., n, axes)."""
        return rows.reshape(*rows.shape[:-1], self._axes, -1).swapaxes(-1, -2)
