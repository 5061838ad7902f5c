"""Units and dimensions: the text of a unit, read into powers of kilogram, metre and second.

Serves: quantities in scenes and chapters. Hides: the table of units. Radian counts as a
dimensionless unit with a name (SI Brochure, 9th edition, section 2.3.3).
"""

import math
import re
from dataclasses import dataclass
from fractions import Fraction

from tamias2d.spec.messages import Code, SpecFault, excerpt

BASES = ("kg", "m", "s")


@dataclass(frozen=True)
class Dimension:
    """Powers of kg, m and s."""

    powers: tuple[Fraction, Fraction, Fraction] = (Fraction(0), Fraction(0), Fraction(0))

    def __mul__(self, other: "Dimension") -> "Dimension":
        a, b = self.powers, other.powers
        return Dimension((a[0] + b[0], a[1] + b[1], a[2] + b[2]))

    def __truediv__(self, other: "Dimension") -> "Dimension":
        return self * other**-1

    def __pow__(self, power: Fraction | int) -> "Dimension":
        a = self.powers
        return Dimension((a[0] * power, a[1] * power, a[2] * power))

    def __str__(self) -> str:
        parts = [
            base if power == 1 else f"{base}^{power}"
            for base, power in zip(BASES, self.powers, strict=True)
            if power
        ]
        return " ".join(parts) or "1"


ONE = Dimension()
KILOGRAM, METRE, SECOND = (
    Dimension((Fraction(k == 0), Fraction(k == 1), Fraction(k == 2))) for k in range(3)
)
NEWTON = KILOGRAM * METRE / SECOND**2


@dataclass(frozen=True)
class Unit:
    """A unit: its text, its dimension and the factor that takes a value to SI."""

    text: str
    dimension: Dimension
    factor: float = 1.0


@dataclass(frozen=True)
class Quantity:
    """A value in SI units with its dimension."""

    value: float
    dimension: Dimension


UNITS = {
    unit.text: unit
    for unit in (
        Unit("1", ONE),
        Unit("rad", ONE),
        Unit("deg", ONE, math.pi / 180),
        Unit("kg", KILOGRAM),
        Unit("g", KILOGRAM, 1e-3),
        Unit("t", KILOGRAM, 1e3),
        Unit("m", METRE),
        Unit("km", METRE, 1e3),
        Unit("cm", METRE, 1e-2),
        Unit("mm", METRE, 1e-3),
        Unit("s", SECOND),
        Unit("ms", SECOND, 1e-3),
        Unit("min", SECOND, 60.0),
        Unit("h", SECOND, 3600.0),
        Unit("Hz", SECOND**-1),
        Unit("N", NEWTON),
        Unit("kN", NEWTON, 1e3),
        Unit("J", NEWTON * METRE),
        Unit("kJ", NEWTON * METRE, 1e3),
    )
}

_TOKEN = re.compile(r"\s*([A-Za-z]+|1(?![0-9.])|\*\*|[*/^()]|-?[0-9]+)")
_QUANTITY = re.compile(
    r"\s*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)(?:\s+(.*\S))?\s*\Z", re.DOTALL
)
_MAX_TEXT = 100
_MAX_POWER = 8


class _UnitReader:
    """Reads `factor {(*|/) factor}` with integer powers and brackets."""

    def __init__(self, text: str) -> None:
        if len(text) > _MAX_TEXT:
            raise SpecFault(Code.TOO_LARGE, f"a unit may have {_MAX_TEXT} characters. Shorten it")
        self.text = text
        self.position = 0

    def fault(self, found: str) -> SpecFault:
        known = ", ".join(UNITS)
        return SpecFault(
            Code.UNKNOWN_UNIT,
            f"'{found}' in unit '{self.text}': must be made of {known} with * / ^. Correct it",
            self.position,
        )

    def peek(self) -> str:
        match = _TOKEN.match(self.text, self.position)
        return match.group(1) if match else self.text[self.position :].strip()

    def take(self) -> str:
        match = _TOKEN.match(self.text, self.position)
        if match is None:
            raise self.fault(self.text[self.position :] or "nothing")
        self.position = match.end()
        return match.group(1)

    def product(self) -> tuple[Dimension, float]:
        dimension, factor = self.power()
        while self.peek() in ("*", "/"):
            sign = 1 if self.take() == "*" else -1
            other, scale = self.power()
            dimension, factor = dimension * other**sign, factor * scale**sign
        return dimension, factor

    def power(self) -> tuple[Dimension, float]:
        dimension, factor = self.atom()
        if self.peek() not in ("^", "**"):
            return dimension, factor
        self.take()
        token = self.take()
        if not re.fullmatch(r"-?[0-9]", token) or abs(int(token)) > _MAX_POWER:
            raise self.fault(token)
        return dimension ** int(token), factor ** int(token)

    def atom(self) -> tuple[Dimension, float]:
        start = self.position
        token = self.take()
        if token == "(":
            inner = self.product()
            if self.take() != ")":
                raise self.fault("(")
            return inner
        if token not in UNITS:
            self.position = start
            raise self.fault(token)
        return UNITS[token].dimension, UNITS[token].factor


def parse_unit(text: str) -> Unit:
    """Read a unit such as `kg*m^2/s`.

    Raises:
        SpecFault: a name is unknown, or the text is not a product of powers.
    """
    refuse_other_digits(text)
    reader = _UnitReader(text)
    dimension, factor = reader.product()
    if reader.peek():
        raise reader.fault(reader.peek())
    return Unit(text.strip(), dimension, factor)


def refuse_other_digits(text: str) -> None:
    """Refuse digits of other scripts, wide ones and raised ones, which look like others.

    Raises:
        SpecFault: there is one; says where.
    """
    for place, sign in enumerate(text):
        if sign.isdigit() and not sign.isascii():
            raise SpecFault(
                Code.BAD_VALUE,
                f"'{sign}' in '{excerpt(text)}': digits are 0 to 9, and powers as in m^2. "
                "Write it so",
                place,
            )


def parse_quantity(text: str) -> Quantity:
    """Read `848.5 m/s`, `45 deg` or a bare number, into SI units.

    Raises:
        SpecFault: no finite number stands in front, or the unit is unknown.
    """
    refuse_other_digits(text)
    match = _QUANTITY.match(text)
    if match is None:
        raise SpecFault(
            Code.BAD_VALUE,
            f"'{excerpt(text)}': must be a number, a space and a unit, as in '9.81 m/s^2'. "
            "Write it so",
        )
    value = float(match.group(1))
    unit = parse_unit(match.group(2)) if match.group(2) else UNITS["1"]
    if not math.isfinite(value * unit.factor):
        raise SpecFault(
            Code.TOO_LARGE, f"'{excerpt(text)}': must be finite in float64. Give a smaller number"
        )
    return Quantity(value * unit.factor, unit.dimension)
