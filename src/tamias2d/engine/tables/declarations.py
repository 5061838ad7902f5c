"""How the arrays of the engine are declared: their columns, sizes, and what is saved of them."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

from numpy.typing import NDArray

Integers: TypeAlias = NDArray[Any]
"""An array of whole numbers of any width."""


class Columns:
    """The columns of an array: each call returns the next one, or the first of several."""

    def __init__(self, each: int = 1) -> None:
        """Begin with none; each is so many numbers wide, unless a call says otherwise."""
        self.width, self.each = 0, each

    def __call__(self, width: int = 0) -> int:
        """Return the first number of the next column."""
        first = self.width
        self.width += width or self.each
        return first


@dataclass(frozen=True)
class Sized:
    """The length of an array along each axis: a number, or the name of a capacity in `world`."""

    shape: tuple[int | str, ...]

    def __init__(self, *shape: int | str) -> None:
        object.__setattr__(self, "shape", shape)


@dataclass(frozen=True)
class Saved:
    """Marks an array of the saved state; all others follow from these, or hold nothing for long.

    Whole numbers are from 0 on and less than `below`: a number, or the capacity whose rows they
    index. Where that is so in some columns only, `below` has the bound of each. Other numbers are
    finite, unless they may be infinite, or may be anything because each step looks at them first.
    """

    below: int | str | Mapping[int, int | str] | None = None
    numbers: str = "finite"  # or "infinite", "any"


class Rewritten:
    """Marks an array in which no step reads what it has not written since contacts were arranged.

    A world that begins anew needs nothing in it.
    """
