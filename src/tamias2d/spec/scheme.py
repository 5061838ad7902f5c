"""Integration schemes as coefficients.

Serves: the check of order, and the generator. Hides: how a scheme item spells its family.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain

from tamias2d.spec.chapter import Item
from tamias2d.spec.equations import Report
from tamias2d.spec.messages import Code

Row = tuple[Fraction, ...]

_NEEDS = {
    "runge_kutta": ("a", "b", "c"),
    "splitting": ("kick", "drift"),
    "exponential": ("kick", "drift"),  # drift: the exact motion under a part of the forces
    "two_level": ("position", "velocity"),
}
_TOGETHER = (("error", "error_orders"), ("dense", "dense_order"))
_LEVELS = {"position": ("velocity", "previous", "current"), "velocity": ("previous", "current")}


@dataclass(frozen=True)
class Scheme:
    """One scheme: its family and the coefficients of that family."""

    name: str
    family: str
    order: int
    a: tuple[Row, ...] = ()
    b: Row = ()
    c: Row = ()
    error: tuple[Row, ...] = ()
    """Weights that give the result's difference from one of lower order."""
    error_orders: tuple[int, ...] = ()
    dense: tuple[Row, ...] = ()
    """Of each stage, the weight as a polynomial without constant in the share of the step."""
    dense_order: int = 0
    kick: Row = ()
    drift: Row = ()
    position: Row = ()
    """Of v h, and of a h^2: with a of the step before, and of the start of this one."""
    velocity: Row = ()
    """Of a h, likewise."""

    @property
    def coefficients(self) -> Iterator[Fraction]:
        """All coefficients of one step."""
        rows = (*self.a, self.b, self.c, self.kick, self.drift, self.position, self.velocity)
        return chain.from_iterable(rows)

    def weights(self, share: Fraction) -> Row:
        """The weights of the dense output at a share of the step."""
        return tuple(
            sum((w * share**k for k, w in enumerate(row, 1)), Fraction(0)) for row in self.dense
        )


def scheme_of(item: Item, report: Report) -> Scheme | None:
    """Read a scheme item; a fault is reported at its place."""
    family = item.data["family"]
    keys = [*_NEEDS[family], *(b for a, b in _TOGETHER if a in item.data)]
    for key in keys:
        if key not in item.data:
            text = f"a {family} scheme like this needs '{key}'. Give it"
            report(item.diagnostic(Code.BAD_KEY, text, "family"))
            return None
    try:
        scheme = _coefficients(item)
    except (ValueError, ZeroDivisionError, OverflowError):
        text = "a coefficient is no number like 1/2 or 0.5. Correct it"
        report(item.diagnostic(Code.BAD_VALUE, text, keys[0]))
        return None
    if not _shapes_fit(scheme):
        text = "the coefficients do not fit together in number. Count them"
        report(item.diagnostic(Code.BAD_VALUE, text, keys[0]))
        return None
    return scheme


def _coefficients(item: Item) -> Scheme:
    data = item.data

    def row(key: str) -> Row:
        return tuple(_number(text) for text in data.get(key, []))

    def rows(key: str) -> tuple[Row, ...]:
        return tuple(tuple(_number(text) for text in line) for line in data.get(key, []))

    def levels(key: str) -> Row:
        weights = data.get(key, {})
        if set(weights) - set(_LEVELS[key]):
            raise ValueError(key)
        return tuple(_number(weights.get(name, "0")) for name in _LEVELS[key])

    return Scheme(
        item.id,
        data["family"],
        int(data["order"]),
        a=rows("a"),
        b=row("b"),
        c=row("c"),
        error=rows("error"),
        error_orders=tuple(int(text) for text in data.get("error_orders", [])),
        dense=rows("dense"),
        dense_order=int(data.get("dense_order", 0)),
        kick=row("kick"),
        drift=row("drift"),
        position=levels("position"),
        velocity=levels("velocity"),
    )


def _number(text: str) -> Fraction:
    """A coefficient, exactly. Raises: ArithmeticError or ValueError, if float64 holds none such."""
    number = Fraction(text)
    float(number)
    return number


def _shapes_fit(scheme: Scheme) -> bool:
    if scheme.family == "runge_kutta":
        stages = len(scheme.b)
        lower = all(len(line) == k for k, line in enumerate(scheme.a))
        known = all(len(line) == stages for line in scheme.error)
        dense = not scheme.dense or len(scheme.dense) == stages
        paired = len(scheme.error) == len(scheme.error_orders)
        square = len(scheme.c) == stages == len(scheme.a)
        return stages > 0 and square and lower and known and dense and paired
    if scheme.family in ("splitting", "exponential"):
        return len(scheme.drift) > 0 and len(scheme.kick) - len(scheme.drift) in (0, 1)
    return True
