"""Compare generated functions, called with plain numbers, with values worked out by hand."""

import math
from collections.abc import Iterator, Mapping
from importlib import import_module
from inspect import signature
from typing import Any

import numpy as np

from tamias2d.errors import SpecError
from tamias2d.generated.symbols import SYMBOLS
from tamias2d.verify.case import Case
from tamias2d.verify.formula import distance, measure
from tamias2d.verify.outcome import Outcome

_TRUTH = {"true": True, "false": False}


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """The worst call for each function. What one function gives, the next ones can take."""
    module = import_module(f"tamias2d.generated.{given['module']}")
    worst: dict[str, float] = {}
    for call in given["calls"]:
        values = _arguments(call["given"])
        for name, expected in call["expect"].items():
            function = getattr(module, name)
            values[name] = function(
                *(values[argument] for argument in signature(function).parameters)
            )
            error = _error(name, values[name], expected)
            worst[name] = max(worst.get(name, 0.0), error)
    for name, error in worst.items():
        yield case.outcome(given, name.replace("_", " "), error)


def _arguments(given: Mapping[str, Any]) -> dict[str, Any]:
    """Return the arguments by name, those of many parts as arrays over the parts (`mass_i`).

    `vertices` become the pairs of neighbours of an outline.
    """
    values = {name: _value(name, value) for name, value in given.items() if name != "vertices"}
    for name, value in values.items():
        if name.endswith("_i"):
            parts = np.array(value)
            values[name] = parts if parts.ndim == 1 else tuple(parts.T)
    if "vertices" in given:
        corners = np.array([_value("vertex", corner) for corner in given["vertices"]])
        values["vertex_i"] = tuple(corners.T)
        values["vertex_j"] = tuple(np.roll(corners, -1, axis=0).T)
    return values


def _value(name: str, value: Any) -> Any:
    if name.endswith("_i"):
        return [measure(part, _symbol(name)) for part in value]
    return measure(value, _symbol(name))


def _error(name: str, found: Any, expected: Any) -> float:
    if isinstance(expected, str) and expected in _TRUTH:
        return 0.0 if bool(found) is _TRUTH[expected] else math.inf
    return distance(np.asarray(found), np.asarray(_value(name, expected)))


def _symbol(name: str) -> str:
    """Return the longest symbol that a name begins with: `arm_first` is an arm."""
    words = name.split("_")
    for length in range(len(words), 0, -1):
        symbol = "_".join(words[:length])
        if symbol in SYMBOLS:
            return symbol
    raise SpecError(f"{name}: begins with no symbol. Correct the name.")
