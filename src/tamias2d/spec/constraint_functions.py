"""What a constraint is to a solver: its formulas as functions of arrays, by the names of values.

Serves: printed constraints and those that scenes state, which a solver treats alike.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

Value = Any  # a float, an array, or a pair of these


@dataclass(frozen=True)
class Formula:
    """A function, and the names of the values that it takes."""

    function: Callable[..., tuple[Value, ...]]
    arguments: tuple[str, ...]

    def __call__(self, values: Mapping[str, Value]) -> tuple[Value, ...]:
        """Return one scalar for each row."""
        return self.function(*[values[name] for name in self.arguments])


@dataclass(frozen=True)
class ConstraintFunctions:
    """All that a solver asks of a constraint. Rows are scalars; a vector equation has two."""

    name: str
    """By which kernels know it."""
    parameters: tuple[str, ...]
    """What must be given, besides coordinates."""
    bodies: tuple[str, ...]
    """The indices of the bodies whose coordinates it takes."""
    units: tuple[str, ...]
    """Of each row."""
    constraint: Formula
    """The rows: zero where it holds."""
    slopes: Mapping[str, Formula]
    """For each body the slopes of the rows by x, y and orientation, three for each row."""
    rate: Formula
    """The rates of the rows along the motion."""
    convective: Formula
    """The rates of those, as far as no acceleration makes them."""
