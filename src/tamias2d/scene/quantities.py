"""Values of a scene file: text with units, turned into numbers in SI units.

Every function raises `RuleError` with the path of the value; the caller adds its place.
"""

import math
import re
from typing import Any

from tamias2d.generated.symbols import SYMBOLS
from tamias2d.scene.law import VARYING
from tamias2d.scene.rules import RuleError, label, shown
from tamias2d.spec.messages import SpecFault
from tamias2d.spec.symbols import Symbol
from tamias2d.spec.units import parse_quantity

_ANGLE = re.compile(r"\b(rad|deg)\b")
_ZERO = re.compile(r"[+-]?0*\.?0*")
_INFINITE = re.compile(r"inf\b")
_EXPRESSION = re.compile(rf"[\[(]|\b({'|'.join((*VARYING, 'mass'))})\b")
_SYMBOL = {"anchor": "arm", "other_anchor": "arm", "point": "position"}

KeyPath = tuple[str | int, ...]


def read_value(raw: object, key: str, path: KeyPath) -> Any:
    """Return the value of a body's key as `Scene` takes it: number, pair, law or list of pairs."""
    if key in ("category", "mask", "group"):
        return _whole(raw, path)
    if key in ("sensor", "loop", "one_sided"):
        return _truth(raw, path)
    if key == "vertices":
        corners = _items(raw, "a list of corners", path)
        return [_pair(corner, SYMBOLS["vertex"], (*path, k)) for k, corner in enumerate(corners)]
    symbol = SYMBOLS[_SYMBOL.get(key, key)]
    return _pair(raw, symbol, path) if symbol.shape == "vector" else _component(raw, symbol, path)


def scalar_text(raw: object, path: KeyPath) -> str:
    """Return a scalar's text, or raise `RuleError` for a list, a mapping or nothing."""
    if isinstance(raw, str) and raw:
        return raw
    found = "a list" if isinstance(raw, list) else "a mapping" if raw else "nothing"
    raise RuleError(f"{label(path[-1:])}: found {found}: must be one value (R2). Write one.", *path)


def _whole(raw: object, path: KeyPath) -> int:
    """Return a whole number, which may be written like 0b101 or 0xff."""
    text = scalar_text(raw, path)
    try:
        return int(text if text.isascii() else "", 0)
    except ValueError:
        raise RuleError(
            f"{label(path[-1:])}: found {shown(text)}: must be a whole number (R3). "
            "Write it like 5 or 0b101.",
            *path,
        ) from None


def _truth(raw: object, path: KeyPath) -> bool:
    text = scalar_text(raw, path)
    if text not in ("true", "false"):
        raise RuleError(
            f"{label(path[-1:])}: found {shown(text)}: must be true or false (R3). Write one.",
            *path,
        )
    return text == "true"


def _items(raw: object, wanted: str, path: KeyPath) -> list[object]:
    if isinstance(raw, list):
        return raw
    found = "a mapping" if isinstance(raw, dict) else shown(raw) if raw else "nothing"
    raise RuleError(
        f"{label(_named(path))}: found {found}: must be {wanted} (R2). Write it in brackets [ ].",
        *path,
    )


def _pair(raw: object, symbol: Symbol, path: KeyPath) -> tuple[object, object]:
    items = _items(raw, "a list of two, x and y", path)
    if len(items) != 2:
        raise RuleError(
            f"{label(_named(path))}: found {len(items)} component{'s' * (len(items) != 1)}: "
            "a vector has two, x and y (R2). Write both.",
            *path,
        )
    x, y = (_component(item, symbol, (*path, k)) for k, item in enumerate(items))
    return x, y


def _component(raw: object, symbol: Symbol, path: KeyPath) -> object:
    text = scalar_text(raw, path)
    if symbol.name in ("force", "torque") and _EXPRESSION.search(text):
        return text
    return read_quantity(text, symbol.name, path)


def read_quantity(raw: object, name: str, path: KeyPath) -> float:
    """Return a number in SI units from ``848.5 m/s``; a bare zero fits any unit.

    An inertia may be ``inf kg*m^2``.
    """
    text, symbol = " ".join(scalar_text(raw, path).split()), SYMBOLS[name]
    if _ZERO.fullmatch(text) and "0" in text:
        return 0.0
    what = label(_named(path))
    pure = symbol.unit == "1"
    example = "Write it like 0.8." if pure else f"Write it like '1.5 {symbol.unit}'."
    endless = name == "inertia" and _INFINITE.match(text) is not None
    try:
        quantity = parse_quantity(_INFINITE.sub("1", text, count=1) if endless else text)
    except SpecFault as fault:
        raise RuleError(f"{what}: {fault.message} (R2). {example}", *path) from None
    if quantity.dimension != symbol.dimension:
        raise RuleError(
            f"{what}: found {shown(text)}, of unit {quantity.dimension}: "
            f"must be {'a pure number' if pure else f'in {symbol.dimension}'} "
            f"(symbol {symbol.name}). {example}",
            *path,
        )
    if bool(_ANGLE.search(text)) != bool(_ANGLE.search(symbol.unit)):
        rule = "must say rad or deg" if _ANGLE.search(symbol.unit) else "is no angle"
        raise RuleError(
            f"{what}: found {shown(text)}: {rule} (symbol {symbol.name}). {example}", *path
        )
    return math.inf if endless else quantity.value


def _named(path: KeyPath) -> KeyPath:
    """Return the end of a path that starts with a word: ``("velocity", 1)``."""
    start = max(k for k, step in enumerate(path) if isinstance(step, str))
    return path[start:]
