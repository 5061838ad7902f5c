"""The rules for values of a scene, and the errors that name them (R2, R3, R4).

One wording serves Python arguments and YAML files: a `RuleError` says which argument is wrong and
why, and the reader of files puts the place before it.
"""

import math
from collections.abc import Iterable, Sequence
from numbers import Real
from operator import index
from typing import Any, TypeAlias, TypeGuard

import numpy as np
from numpy.typing import NDArray

from tamias2d.errors import InputError, printable
from tamias2d.generated.symbols import SYMBOLS

Vector: TypeAlias = tuple[float, float]
_LONGEST = 60  # characters of a value that a message repeats whole
_LARGEST = 2**63 - 1
VectorLike: TypeAlias = Sequence[float] | NDArray[np.floating | np.integer]


class RuleError(InputError):
    """A broken rule, with the `path` of the argument that broke it, e.g. ``("vertices", 2)``."""

    def __init__(self, message: str, *path: str | int) -> None:
        super().__init__(printable(message))
        self.path = path


def number(value: object, symbol: str, of: str, remedy: str, *, at: tuple[str | int, ...]) -> float:
    """Return a plain number that is finite and in the range of its symbol, or raise `RuleError`.

    Truth values are no numbers. `of` says whose value it is, `remedy` what to do about a bad one.
    """
    meaning = SYMBOLS[symbol]
    if type(value) is float and meaning.admits(value):
        return value + 0.0  # no negative zero: equal scenes have equal texts
    unit = "" if meaning.unit == "1" else f" {meaning.unit}"
    what = f"{label(at)} of {of}"
    if not is_number(value):
        raise RuleError(
            f"{what}: found {shown(value)}: must be a number{_in(unit)} (R4). {remedy}", *at
        )
    try:
        plain = float(value)
    except OverflowError:
        plain = math.inf
    if not math.isfinite(plain):
        raise RuleError(f"{what}: found {shown(value)}: must be finite (R4). {remedy}", *at)
    if not meaning.admits(plain):
        found = repr(plain).removesuffix(".0")
        raise RuleError(f"{label(at)} {found}{unit} of {of}: {meaning.rule}. {remedy}", *at)
    return plain + 0.0


def is_number(value: object) -> TypeGuard[float]:
    """Return whether a value is a real number; truth values are none."""
    return isinstance(value, Real) and not isinstance(value, bool)


def checked_count(value: Any, key: str, least: int, *, remedy: str = "Give one.") -> int:
    """Return a whole number that is at least some other one, or raise `RuleError`."""
    try:
        count = least - 1 if isinstance(value, bool) else index(value)
    except TypeError:
        count = least - 1
    if count < least:
        raise RuleError(
            f"{key} {shown(value)}: must be a whole number of at least {least} (R4). {remedy}", key
        )
    if count > _LARGEST:
        raise RuleError(f"{key} {shown(value)}: must be less than 2**63 (R4). Give fewer.", key)
    return count


def checked_flag(
    value: object,
    key: str,
    of: str | None = None,
    *,
    rule: str = "R4",
    remedy: str = "Give one of them.",
) -> bool:
    """Return a truth value, or raise `RuleError`; `of` says whose it is."""
    if not isinstance(value, bool):
        whose = key if of is None else f"{key} of {of}"
        raise RuleError(
            f"{whose}: found {shown(value)}: must be True or False ({rule}). {remedy}", key
        )
    return value


def vector(
    value: object, symbol: str, of: str, remedy: str, *, at: tuple[str | int, ...]
) -> Vector:
    """Return a pair of plain finite numbers, or raise `RuleError`."""
    x, y = pair(value, of, remedy, at=at)
    return (
        number(x, symbol, of, remedy, at=(*at, 0)),
        number(y, symbol, of, remedy, at=(*at, 1)),
    )


def pair(
    value: object, of: str, remedy: str, *, at: tuple[str | int, ...]
) -> tuple[object, object]:
    """Return the two items of a pair, or raise `RuleError`."""
    items = sequence(value, of, remedy, at=at)
    if len(items) != 2:
        raise RuleError(
            f"{label(at)} of {of}: found {len(items)} component{'s' * (len(items) != 1)} in "
            f"{shown(value)}: "
            f"a vector has two, x and y (R4). {remedy}",
            *at,
        )
    return items[0], items[1]


def sequence(
    value: object, of: str, remedy: str, *, at: tuple[str | int, ...]
) -> tuple[object, ...]:
    """Return the items of a list, tuple or array, or raise `RuleError`."""
    try:
        if isinstance(value, Iterable) and not isinstance(value, str | bytes | dict | set):
            return tuple(value)
    except TypeError:  # an array without dimensions says that it can be iterated, and cannot
        pass
    raise RuleError(
        f"{label(at)} of {of}: found {shown(value)}: must be a list (R4). {remedy}", *at
    )


def refuse_masked(value: object, of: str, remedy: str, *, at: tuple[str | int, ...]) -> None:
    """Refuse an array of which something is masked: NumPy would take what is below the mask."""
    masked = getattr(value, "mask", False)
    if masked is not False and np.any(masked):
        raise RuleError(
            f"{label(at)} of {of}: found a masked value: must be there (R4). {remedy}", *at
        )


def label(at: tuple[str | int, ...]) -> str:
    """Return how a message names an argument: ``velocity[1]``."""
    first, *rest = at
    return str(first).replace("_", " ") + "".join(f"[{step}]" for step in rest)


def shown(value: object) -> str:
    """Return a value as a message prints it: short, on one line."""
    try:
        text = " ".join(repr(value).split())
    except ValueError:  # Python writes no whole number that is longer
        return f"{type(value).__name__} with a number of more than 4300 digits"
    if len(text) <= _LONGEST:
        return text
    if isinstance(value, int):
        return f"{text[:20]}... ({len(text.removeprefix('-'))} digits)"
    return text[: _LONGEST - 3] + "..."


def _in(unit: str) -> str:
    return f" in{unit}" if unit else ""
