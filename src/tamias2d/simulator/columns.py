"""Arguments for many bodies at once: one value for all, or an array with a row for each (R4).

The message about a value at fault is the one that it would get alone. Plain numbers, as games give
them body by body, are judged without arrays.
"""

from collections.abc import Callable
from typing import TypeGuard

import numpy as np
from numpy.typing import NDArray

from tamias2d.generated.symbols import SYMBOLS
from tamias2d.scene.rules import RuleError, label, number, refuse_masked, shown
from tamias2d.state import Array, IntArray

_MANY = {"body": "bodies", "ray": "rays", "world": "worlds"}


def numbers(value: object, key: str, of: str, remedy: str, *, count: int, symbol: str) -> Array:
    """Return a number for each of so many bodies (count,), or raise `RuleError`."""
    if _is_good(value, symbol):
        return np.full(count, value + 0.0)  # no negative zeros
    return judged(spread(value, key, of, remedy, (count,)), key, of, remedy, symbol)


def vectors(
    value: object, key: str, of: str, remedy: str, *, count: int, symbol: str, each: str = "body"
) -> Array:
    """Return a vector for each of so many bodies (count, 2), or for another `each`.

    Raises:
        RuleError: there are no such numbers, or not so many.
    """
    if type(value) is tuple and len(value) == 2:
        x, y = value
        if _is_good(x, symbol) and _is_good(y, symbol):
            return np.full((count, 2), (x + 0.0, y + 0.0))
    return judged(spread(value, key, of, remedy, (count, 2), each), key, of, remedy, symbol)


def wholes(value: object, key: str, of: str, *, count: int, check: Callable[..., int]) -> IntArray:
    """Return a whole number for each of so many bodies (count,); `check` judges one of them."""
    if type(value) is int:
        return np.full(count, check(value, key, of), dtype=np.int64)
    given = as_array(value, key, of, "Give whole numbers.")
    if given.ndim and given.shape != (count,):
        raise _misshapen(given, key, of, (count,), "Give one number, or one for each body.")
    items = given.ravel().tolist()
    if given.dtype == object:  # too large for an array, or no numbers at all
        judged = [check(item, key, of) for item in items]
    else:
        once = {item: check(item, key, of) for item in set(items)}
        judged = [once[item] for item in items]
    return np.full(count, judged, dtype=np.int64)


def stated(said: dict[str, object], of: str, *, rule: str) -> dict[str, object]:
    """Return what is not left out; refuse to change nothing."""
    found = {key: value for key, value in said.items() if value is not None}
    if not found:
        words = " or ".join((", ".join(list(said)[:-1]), list(said)[-1]))
        raise RuleError(f"{of}: found nothing to change ({rule}). Give {words}.", next(iter(said)))
    return found


def _is_good(value: object, symbol: str) -> TypeGuard[float]:
    """Return whether a value is a plain number that its symbol admits."""
    return type(value) is float and SYMBOLS[symbol].admits(value)


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
    limits = SYMBOLS[symbol].range
    good = np.isfinite(values)
    good &= values > limits.low if limits.low_open else values >= limits.low
    good &= values < limits.high if limits.high_open else values <= limits.high
    if not good.all():
        place = tuple(int(k) for k in np.argwhere(~good)[0])
        number(float(values[place]), symbol, of, remedy, at=(key, *place))
    return values
