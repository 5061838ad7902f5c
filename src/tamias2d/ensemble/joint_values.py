"""The numbers of joints in the words of scene files, such as `motor.maximum` or `limits.lower`.

Serves: whoever changes single values of a scene. Hides: of which freedom of a joint each number is.
Teeth of ratchets, ratios, axes and places stay as they are.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from tamias2d.scene.freedoms import (
    Freedom,
    freedom,
    limit_symbols,
    motor_symbols,
    spring_symbols,
)
from tamias2d.scene.joints import Joint

Values = dict[str, Any]
"""Of a joint: numbers, and its parts with numbers of their own and with what they measure."""

_PARAMETERS = {"joint_length": "length", "joint_angle": "angle"}
_SYMBOLS = {
    "length": "joint_length",
    "angle": "joint_angle",
    "break_force": "joint_force_most",
    "break_torque": "joint_torque_most",
}
_PARTS = {"limits": limit_symbols, "motor": motor_symbols, "spring": spring_symbols}
_MEASURE = "measure"


def values_of(joint: Joint) -> Values:
    """Return the numbers of a joint that can be changed."""
    values: Values = {
        _PARAMETERS[symbol]: value for symbol, value in joint.parameters if symbol in _PARAMETERS
    }
    for key in ("break_force", "break_torque"):
        if getattr(joint, key) is not None:
            values[key] = getattr(joint, key)
    for each in joint.freedoms:
        if each.pitch is None:
            values |= _parts(each)
    if joint.kind == "target":
        del values["spring"]["rest"]  # it pulls to the point itself
    return values


def with_values(joint: Joint, values: Mapping[str, Any]) -> Joint:
    """Return a joint with other numbers; that it holds at the start is not checked.

    Raises:
        InputError: the numbers of a part break a rule (GD21, GD22, DD64).
    """
    if values == values_of(joint):
        return joint
    of = f"joint '{joint.name}'"
    return replace(
        joint,
        parameters=tuple(
            (symbol, values.get(_PARAMETERS.get(symbol, ""), value))
            for symbol, value in joint.parameters
        ),
        freedoms=tuple(_with_parts(each, values, of) for each in joint.freedoms),
        break_force=values.get("break_force"),
        break_torque=values.get("break_torque"),
    )


def numbers_in(values: Mapping[str, Any]) -> Iterator[tuple[tuple[str, ...], str]]:
    """Yield the keys that lead to each number in the values of a joint, and its symbol."""
    for key, value in values.items():
        if key in _PARTS:
            symbols = _PARTS[key](value[_MEASURE])
            yield from (((key, name), symbols[name]) for name in value if name in symbols)
        else:
            yield (key,), _SYMBOLS[key]


def _parts(each: Freedom) -> Values:
    """Return the parts of a freedom, with all of their numbers."""
    parts = ((key, getattr(each, key), symbols_of) for key, symbols_of in _PARTS.items())
    return {
        key: {
            _MEASURE: each.measure,
            **{name: getattr(part, name) for name in symbols_of(each.measure)},
        }
        for key, part, symbols_of in parts
        if part is not None
    }


def _with_parts(each: Freedom, values: Mapping[str, Any], of: str) -> Freedom:
    """Return a freedom with the parts that it has, of other numbers."""
    if each.pitch is not None:
        return each
    given = {
        key: replace(part, **{name: at for name, at in values[key].items() if name != _MEASURE})
        for key in _PARTS
        if (part := getattr(each, key)) is not None
    }
    (checked,) = freedom(each.measure, of, **given)
    return replace(checked, across=each.across)
