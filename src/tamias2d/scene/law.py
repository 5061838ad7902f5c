"""Forces and torques: a plain number, or a law of time in the language of the specification.

Serves: bodies whose loads vary with time. Hides: how an expression is read, checked and evaluated.
"""

import math
from dataclasses import dataclass, field
from functools import cache
from typing import TypeAlias

from tamias2d.errors import InputError
from tamias2d.generated.symbols import SYMBOLS
from tamias2d.scene.rules import RuleError, label, number
from tamias2d.spec.check import Type, expect
from tamias2d.spec.evaluate import evaluate
from tamias2d.spec.expression import Call, Node, parse, walk
from tamias2d.spec.messages import Code, SpecFault
from tamias2d.spec.symbols import SymbolTable, table_from

_NO_NUMBER = ("d", "integral", "sum")  # of the language, but they need more than an instant


@dataclass(frozen=True)
class TimeLaw:
    """An expression of `time`, e.g. ``10[N]*sin(2[rad/s]*time)``; `what` it is, for messages."""

    text: str
    what: str = field(compare=False, repr=False)
    node: Node = field(compare=False, repr=False)

    def __call__(self, time: float) -> float:
        """Return the value at a time in s, in SI units; raise `InputError` where there is none."""
        try:
            value = evaluate(self.node, {"time": time})
        except (ArithmeticError, ValueError):
            value = math.nan
        if isinstance(value, complex) or not math.isfinite(value):
            raise InputError(
                f"{self.what}: '{self.text}' has no finite value at time {time!r} s (R4). "
                "Give a law that has one at all times of the run."
            )
        return float(value)


Law: TypeAlias = float | TimeLaw


def checked_law(value: object, symbol: str, of: str, *, at: tuple[str | int, ...]) -> Law:
    """Return a number, or the law that a text states; raise `RuleError` if it is neither.

    A text in which `time` does not stand is a number.
    """
    unit = SYMBOLS[symbol].unit
    remedy = f"Give it in {unit}, or as text like '10[{unit}]*sin(2[rad/s]*time)'."
    if not isinstance(value, str):
        return number(value, symbol, of, remedy, at=at)
    what = f"{label(at)} of {of}"
    try:
        law = TimeLaw(" ".join(value.split()), what, _read(value, symbol))
    except SpecFault as fault:
        raise RuleError(
            f"{what}: {fault.message} (R4, column {fault.offset + 1}). {remedy}", *at
        ) from None
    try:
        at_start = law(0.0)
    except InputError as error:
        raise RuleError(str(error), *at) from None
    if "time" in {getattr(part, "name", None) for part in walk(law.node)}:
        return law
    return at_start + 0.0


def value_at(law: Law, time: float) -> float:
    """Return the value of a number or a law at a time in s."""
    return law if isinstance(law, float) else law(time)


def _read(text: str, symbol: str) -> Node:
    node = parse(text)
    expect(node, _time_only(), Type("scalar", SYMBOLS[symbol].dimension))
    for part in walk(node):
        if isinstance(part, Call) and part.function in _NO_NUMBER:
            raise SpecFault(
                Code.NOT_ALLOWED, f"'{part.function}' has no value at an instant", part.offset
            )
    return node


@cache
def _time_only() -> SymbolTable:
    return table_from({"time": SYMBOLS["time"]})
