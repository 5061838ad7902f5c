"""Forces and torques: a plain number, or a law in the language of the specification.

A law says how a load follows from the time and from the state of the body that feels it.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from typing import Any, TypeAlias

import numpy as np

from tamias2d.errors import InputError, SimulationError
from tamias2d.generated.symbols import SYMBOLS
from tamias2d.scene.rules import RuleError, label, number, pair
from tamias2d.spec.check import Type, expect, refuse_not_stated
from tamias2d.spec.expression import Binary, Call, Node, Power, names, parse, walk
from tamias2d.spec.kinks import has_kinks
from tamias2d.spec.messages import SpecFault
from tamias2d.spec.printed import law_function, shape_of
from tamias2d.spec.symbols import SymbolTable, table_from

VARYING = ("time", "position", "velocity", "orientation", "angular_velocity")
"""What a law may use and what changes during a run; `mass` may stand in it too."""
_EVEN, _PEAKED = ("x", "y", "sin", "cos"), 4
"""What is called by laws that go on evenly; the power from which on what is called has peaks."""
_NOTHING = dict.fromkeys((*VARYING, "mass"), math.nan) | dict.fromkeys(
    ("position", "velocity"), (math.nan, math.nan)
)
"""What a law is given of that on which it does not depend."""

Value: TypeAlias = Any
"""A float or an array of n, for n bodies; a vector is a pair of these."""


class LawValueError(InputError, SimulationError):
    """A law has no finite value where it is asked for: where a run goes, or where a trial did."""


@dataclass(frozen=True)
class StateLaw:
    """An expression, e.g. ``10[N]*sin(2[rad/s]*time)``; `what` it is, for messages."""

    text: str
    what: str = field(compare=False, repr=False)
    node: Node = field(compare=False, repr=False)

    @cached_property
    def names(self) -> frozenset[str]:
        """What the law uses of time, state and mass."""
        return frozenset(names(self.node))

    @property
    def varies(self) -> bool:
        """Whether the law can change during a run."""
        return bool(self.names & set(VARYING))

    @cached_property
    def kinked(self) -> bool:
        """Whether the law has a derivative that jumps, or jumps itself, where it can change."""
        return has_kinks(self.node, VARYING)

    @cached_property
    def brief(self) -> bool:
        """Whether the law may do something for a moment: no polynomial in it, sine or cosine is."""
        return self.varies and any(_brief(part) for part in walk(self.node))

    @cached_property
    def shape(self) -> tuple[str, tuple[float, ...]]:
        """The law as source, and the numbers in it: laws of one shape share compiled code."""
        return shape_of(self.node, _known())

    def __call__(self, state: Mapping[str, Value]) -> Value:
        """Return the value in SI units for given `names`: one, or one a body where these are.

        Raises:
            LawValueError: there is no finite value; the message says where.
            InputError: a name is not given.
        """
        if missing := self.names - state.keys():
            raise InputError(
                f"{self.what}: '{self.text}' depends on '{min(missing)}', which is not given (R4). "
                "Give the state in which it is asked for."
            )
        value = self.values(state)
        if isinstance(value, complex) or not np.all(np.isfinite(value)):
            raise LawValueError(
                f"{self.what}: '{self.text}' has no finite value at {self._place(state, value)} "
                "(R4). Give a law that has one wherever the run goes."
            )
        return value if isinstance(value, np.ndarray) else float(value)

    def values(self, state: Mapping[str, Value]) -> Value:
        """Return the value in SI units for all of `names`; not finite where there is none."""
        shape, numbers = self.shape
        try:
            with np.errstate(all="ignore"):
                return law_function(shape)(numbers, **{**_NOTHING, **state})
        except (ArithmeticError, ValueError):
            return math.nan

    def _place(self, state: Mapping[str, Value], value: Value) -> str:
        bad = int(np.argmin(np.isfinite(value))) if isinstance(value, np.ndarray) else 0
        used = sorted(self.names, key=(*VARYING, "mass").index)
        return ", ".join(_shown(name, state[name], bad) for name in used) or "any time"


Law: TypeAlias = float | StateLaw


def checked_law(value: object, symbol: str, of: str, *, at: tuple[str | int, ...]) -> Law:
    """Return a number, or the law that a text states; raise `RuleError` if it is neither.

    A text in which nothing stands that varies from body to body or in time is a number.
    """
    unit = SYMBOLS[symbol].unit
    remedy = f"Give it in {unit}, or as text like '10[{unit}]*sin(2[rad/s]*time)'."
    _refuse_function(value, symbol, of, at=at)
    if not isinstance(value, str):
        return number(value, symbol, of, remedy, at=at)
    what = f"{label(at)} of {of}"
    try:
        law = StateLaw(" ".join(value.split()), what, _read(value, symbol))
    except SpecFault as fault:
        raise RuleError(
            f"{what}: {fault.message} (R4, column {fault.offset + 1}). {remedy}", *at
        ) from None
    return law if law.names else first_value(law, {}, at=at) + 0.0


def checked_force(value: object, of: str) -> tuple[Law, Law]:
    """Return both components of a force, each a number in N or a law; or raise `RuleError`."""
    _refuse_function(value, "force", of, at=("force",))
    x, y = pair(value, of, "Give (x, y) in N.", at=("force",))
    return (
        checked_law(x, "force", of, at=("force", 0)),
        checked_law(y, "force", of, at=("force", 1)),
    )


def _refuse_function(value: object, symbol: str, of: str, *, at: tuple[str | int, ...]) -> None:
    if callable(value):
        unit = SYMBOLS[symbol].unit
        law = f"'10[{unit}]*sin(2[rad/s]*time)'"
        written = f"({law}, 0)" if at == ("force",) else law
        raise RuleError(
            f"{label(at)} of {of}: found a function, which a recording could not keep: must be "
            f"a number or an expression (R4). Write it as text like {written}; it may use "
            f"{', '.join(VARYING)} and mass.",
            *at,
        )


def first_value(law: Law, state: Mapping[str, Value], *, at: tuple[str | int, ...]) -> float:
    """Return the value of a law at the start; raise `RuleError` where it has none."""
    try:
        return float(value_at(law, state))
    except InputError as error:
        raise RuleError(str(error), *at) from None


def value_at(law: Law, state: Mapping[str, Value]) -> Value:
    """Return the value of a number or a law for a state."""
    return law if isinstance(law, float) else law(state)


def varies(law: Law) -> bool:
    """Whether a number or a law can change during a run."""
    return isinstance(law, StateLaw) and law.varies


def _read(text: str, symbol: str) -> Node:
    node = parse(text)
    expect(node, _known(), Type("scalar", SYMBOLS[symbol].dimension))
    refuse_not_stated(node)
    return node


def _brief(part: Node) -> bool:
    match part:
        case Call():
            return part.function not in _EVEN
        case Power():
            peaked = part.exponent > _PEAKED and any(isinstance(n, Call) for n in walk(part.base))
            return part.exponent < 0 or part.exponent.denominator > 1 or peaked
        case Binary():
            return part.operator == "/" and any(names(part.right))
    return False


@cache
def _known() -> SymbolTable:
    return table_from({name: SYMBOLS[name] for name in (*VARYING, "mass")})


def _shown(name: str, value: Value, k: int) -> str:
    """Return ``position (1.0 m, 2.0 m)`` of the k-th body."""
    parts = value if isinstance(value, tuple) else (value,)
    numbers = [float(np.ravel(part)[min(k, np.size(part) - 1)]) for part in parts]
    texts = ", ".join(f"{number!r} {SYMBOLS[name].unit}" for number in numbers)
    return f"{name.replace('_', ' ')} {f'({texts})' if len(parts) > 1 else texts}"
