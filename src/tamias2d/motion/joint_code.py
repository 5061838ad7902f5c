"""The protocol of code that is made for the joints of one mechanism."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol, TypeAlias

from tamias2d.motion.constraint_rows import ConstraintRows
from tamias2d.state import Array


@dataclass(frozen=True, kw_only=True)
class Pushes:
    """What springs and slipping motors exert along rows (DD64, DD65, DD103, GD22)."""

    rows: ConstraintRows
    laws: Array
    """(k, 6) for the joints of the rows: stiffness, rest, damping, a constant push, and the most
    of the spring, 0 for any, with how much farther on the other travel of a target is."""


@dataclass(frozen=True, kw_only=True)
class JointRows:
    """A mechanism as code for it knows it."""

    rows: ConstraintRows
    weights: Array
    """(n, 3), roots of the inverse masses and inertias of its bodies."""
    speeds: Array
    """(m,), the rate that each row keeps."""
    placed: Array
    """(m,), 1 for each row that keeps a place."""
    fixed: Array
    """(k, 2), where it holds what stands still, m."""
    length: float
    """How far joints reach at most, m."""
    reach: Array
    """(n, 3), one over how far they reach on each body, 1/m, for its orientation; else 1."""
    pushes: Pushes | None = None
    kinds: frozenset[str] = frozenset()
    """Of rows that it may have at other times; those of pushes likewise."""
    pushed: frozenset[str] = frozenset()


class JointCode(Protocol):
    """The reactions of a mechanism.

    Where rows depend on each other their reactions fade (GD19), and no multipliers are returned.
    Nothing is returned where joints contradict each other, and where a number is not finite or too
    near to rounding.
    """

    def react(
        self, time: float, position: Array, velocity: Array, free: Array
    ) -> tuple[Array, Array | None] | None:
        """Return the accelerations (n, 3) for those by the loads, and the multipliers (m,)."""

    def drift(
        self, time: float, duration: float, position: Array, velocity: Array
    ) -> tuple[Array, Array] | None:
        """Return places (n, 3) after a drift, and velocities along it (GD24)."""

    def fit(self, time: float, position: Array, velocity: Array) -> tuple[Array, Array] | None:
        """Return places and velocities (n, 3), moved to where the joints hold (GD18)."""


JointCodes: TypeAlias = Callable[[JointRows], JointCode | None]
"""What makes code for a mechanism, if it can."""
