"""A joint as the engine is told of it."""

import math
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

from tamias2d.engine.tables import KEPT, MOTOR, SPRING
from tamias2d.generated.constraints import CONSTRAINTS
from tamias2d.generated.joint_rows import KINDS, ROWS_OF_KIND
from tamias2d.spec.row_program import RowProgram

LawNumbers: TypeAlias = tuple[float, float, float, float, float]
"""Rate, maximum, stiffness, damping and restitution."""


def rubs(law: int, numbers: Sequence[float]) -> bool:
    """Return whether a law only rubs, with these numbers: gives at most a maximum, for a rate."""
    _, most, stiffness, *_ = numbers
    return law in (MOTOR, SPRING) and stiffness == 0.0 and most < math.inf


class JointRow(NamedTuple):
    """A joint of up to three bodies, given by rows, or None for the plane."""

    kind: str
    """One of `generated.joint_rows`, if it has no program."""
    ends: tuple[int | None, int | None, int | None]
    given: tuple[float, ...]
    """Its parameters, SI units."""
    apart: bool
    """Whether its bodies may not touch each other."""
    law: int = KEPT
    """What governs it, one of those in `tables`."""
    numbers: LawNumbers = (0.0, math.inf, 0.0, 0.0, 0.0)
    """Of its law."""
    program: RowProgram | None = None
    """Its row, if it has an equation of its own; `given` are its anchors then."""
    steepness: tuple[float, float] = (1.0, 1.0)
    """By how much the value of that row changes for each m, and for each rad, about."""
    across: bool | None = None
    """Of a target, whether it is the travel across; None of what has one row to pull."""

    @property
    def number(self) -> int:
        """Of its kind, one more than the last for an equation of its own."""
        return len(KINDS) if self.program else KINDS.index(self.kind)

    @property
    def row_count(self) -> int:
        """How many rows it has."""
        return 1 if self.program else ROWS_OF_KIND[self.number]

    @property
    def bodies(self) -> tuple[str, ...]:
        """The indices of the bodies whose places it takes."""
        return self.program.bodies if self.program else CONSTRAINTS[self.kind].bodies

    @property
    def units(self) -> tuple[str, ...]:
        """Of its rows: "m" where these move bodies, "1" where they only turn them."""
        if self.program:
            return ("m" if self.steepness[0] > 0.0 else "1",)
        return CONSTRAINTS[self.kind].units

    @property
    def per_unit(self) -> float:
        """By how much the value of a row changes for one of these units."""
        return (self.steepness[0] or self.steepness[1] or 1.0) if self.program else 1.0

    @property
    def bound(self) -> bool:
        """Whether it is bound to the plane, though its bodies may all move."""
        return self.program is not None and not self.program.free

    @property
    def timed(self) -> bool:
        """Whether it changes with time."""
        return self.program is not None and self.program.timed

    @property
    def driven(self) -> bool:
        """Whether it may give energy that no step counts where contacts act."""
        return self.law == SPRING or self.timed

    @property
    def turned(self) -> bool:
        """Whether it is a motor that does not stand still."""
        return self.law == MOTOR and self.numbers[0] != 0

    @property
    def bounded(self) -> bool:
        """Whether it is a spring with a maximum."""
        return self.law == SPRING and self.numbers[1] < math.inf

    @property
    def firm(self) -> bool:
        """Whether it does more than rub."""
        return not rubs(self.law, self.numbers)

    @property
    def governed(self) -> bool:
        """Whether it is a limit, a motor or a spring."""
        return self.law != KEPT
