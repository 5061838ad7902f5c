"""Arguments for many bodies at once: one value for all, or an array with a row for each (R4).

The message about a value at fault is the one that it would get alone. Plain numbers, as games give
them body by body, are judged without arrays.
"""

import math
from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from tamias2d.generated.symbols import SYMBOLS
from tamias2d.scene.rules import RuleError, label, number, refuse_masked, shown
from tamias2d.state import Array, IntArray

Column: TypeAlias = float | Array
"""One number for all bodies, or an array with one for each."""
WholeColumn: TypeAlias = int | list[int]
"""One whole number for all bodies, or a list of one for each."""
_MANY = {"body": "bodies", "ray": "rays", "world": "worlds"}
_EXACT = 2**53  # whole numbers up to it are numbers of float64
_LIMITS = {name: (known.range.least, known.range.most) for name, known in SYMBOLS.items()}


def numbers(value: object, key: str, of: str, remedy: str, *, count: int, symbol: str) -> Array:
    """Return a number for each of so many bodies (count,), or raise `RuleError`."""
    found = column(value, key, of, remedy, count=count, symbol=symbol)
    return np.full(count, found)


def column(value: object, key: str, of: str, remedy: str, *, count: int, symbol: str) -> Column:
    """Return a number for all of so many bodies, or one for each, or raise `RuleError`."""
    plain = value if type(value) is float else _plain(value)
    least, most = _LIMITS[symbol]
    if plain is not None and least <= plain <= most:
        return plain + 0.0  # no negative zeros
    return judged(spread(value, key, of, remedy, (count,)), key, of, remedy, symbol)


def vectors(
    value: object, key: str, of: str, remedy: str, *, count: int, symbol: str, each: str = "body"
) -> Array:
    """Return a vector for each of so many bodies (count, 2), or for another `each`.

    Raises:
        RuleError: there are no such numbers, or not so many.
    """
    found = two_columns(value, key, of, remedy, count=count, symbol=symbol, each=each)
    return table(found, count)


def two_columns(
    value: object, key: str, of: str, remedy: str, *, count: int, symbol: str, each: str = "body"
) -> tuple[Column, Column]:
    """Return the components of a vector for all, or for each, as `vectors` does."""
    plain = plain_pair(value)
    if plain is not None:
        (x, y), (least, most) = plain, _LIMITS[symbol]
        if least <= x <= most and least <= y <= most:
            return x + 0.0, y + 0.0
    rows = judged(spread(value, key, of, remedy, (count, 2), each), key, of, remedy, symbol)
    return rows[:, 0], rows[:, 1]


def table(columns: Sequence[Column], count: int) -> Array:
    """Return columns side by side (count, k)."""
    if count == 1 and set(map(type, columns)) == {float}:
        found: Array = np.array((columns,))
        return found
    found = np.empty((count, len(columns)))
    for k, values in enumerate(columns):
        found[:, k] = values
    return found


def whole_table(columns: Sequence[WholeColumn], count: int) -> IntArray:
    """Return columns of whole numbers side by side (count, k)."""
    if count == 1 and set(map(type, columns)) == {int}:
        return np.array((columns,), dtype=np.int64)
    found = np.empty((count, len(columns)), dtype=np.int64)
    for k, values in enumerate(columns):
        found[:, k] = values
    return found


def is_finite(values: Column) -> bool:
    """Return whether all numbers of a column are finite."""
    return math.isfinite(values) if isinstance(values, float) else bool(np.isfinite(values).all())


def wholes(value: object, key: str, of: str, *, count: int, check: Callable[..., int]) -> IntArray:
    """Return a whole number for each of so many bodies (count,); `check` judges one of them."""
    return np.full(count, whole_column(value, key, of, count=count, check=check), dtype=np.int64)


def whole_column(
    value: object, key: str, of: str, *, count: int, check: Callable[..., int]
) -> WholeColumn:
    """Return a whole number for all of so many bodies, or one for each, as `wholes` does."""
    if type(value) is int:
        return check(value, key, of)
    given = as_array(value, key, of, "Give whole numbers.")
    if given.ndim and given.shape != (count,):
        raise _misshapen(given, key, of, (count,), "Give one number, or one for each body.")
    items = given.ravel().tolist()
    if given.dtype == object:  # too large for an array, or no numbers at all
        judged = [check(item, key, of) for item in items]
    else:
        once = {item: check(item, key, of) for item in set(items)}
        judged = [once[item] for item in items]
    return judged if given.ndim else judged[0]


def stated(said: dict[str, object], of: str, *, rule: str) -> dict[str, object]:
    """Return what is not left out; refuse to change nothing."""
    found = {key: value for key, value in said.items() if value is not None}
    if not found:
        words = " or ".join((", ".join(list(said)[:-1]), list(said)[-1]))
        raise RuleError(f"{of}: found nothing to change ({rule}). Give {words}.", next(iter(said)))
    return found


def plain_pair(value: object) -> tuple[float, float] | None:
    """Return the numbers of a pair of plain ones, or None if it is anything else."""
    if type(value) is np.ndarray and value.shape == (2,):
        value = value.tolist()
    if (type(value) is tuple or type(value) is list) and len(value) == 2:
        x, y = value
        if type(x) is float and type(y) is float:
            return x, y
        x, y = _plain(x), _plain(y)
        return None if x is None or y is None else (x, y)
    return None


def _plain(value: object) -> float | None:
    """Return a plain number, as float64 holds it, or None if it is anything else."""
    if type(value) is float:
        return value
    if type(value) is np.float64 or (type(value) is int and -_EXACT <= value <= _EXACT):
        return float(value)
    return None


def spread(
    value: object, key: str, of: str, remedy: str, shape: tuple[int, ...], each: str = "body"
) -> Array:
    """Return real numbers, each row for one body, or for another `each`; one alone is for all."""
    given = as_array(value, key, of, remedy)
    if given.dtype.kind not in "fiu":
        raise RuleError(
            f"{label((key,))} of {of}: found {shown(value)}: must be real numbers (R4). {remedy}",
            key,
        )
    if given.shape not in (shape, shape[1:]):
        raise _misshapen(given, key, of, shape, remedy, each)
    return np.broadcast_to(given, shape).astype(np.float64) + 0.0  # no negative zeros


def as_array(value: object, key: str, of: str, remedy: str) -> NDArray[np.generic]:
    """Return an array of whatever numbers, or raise `RuleError` if its rows differ in length."""
    refuse_masked(value, of, remedy, at=(key,))
    try:
        return np.asarray(value)
    except ValueError:  # rows of different lengths
        raise RuleError(
            f"{label((key,))} of {of}: found {shown(value)}: its rows must have one length (R4). "
            f"{remedy}",
            key,
        ) from None


def _misshapen(
    given: NDArray[np.generic],
    key: str,
    of: str,
    shape: tuple[int, ...],
    remedy: str,
    each: str = "body",
) -> RuleError:
    one = "one number" if len(shape) == 1 else "two components"
    return RuleError(
        f"{label((key,))} of {of}: found an array of shape {given.shape}: must be {one}, or "
        f"{shape} for {shape[0]} {each if shape[0] == 1 else _MANY[each]} (R4). {remedy}",
        key,
    )


def judged(values: Array, key: str, of: str, remedy: str, symbol: str) -> Array:
    """Return the values if each is finite and in the range of its symbol."""
    least, most = _LIMITS[symbol]
    good = (values >= least) & (values <= most)  # nan is neither
    if not good.all():
        place = tuple(int(k) for k in np.argwhere(~good)[0])
        number(float(values[place]), symbol, of, remedy, at=(key, *place))
    return values
