"""The joints of a scene file (TM7)."""

from collections.abc import Callable
from typing import Any

from tamias2d.scene.forms import likely, listed, mapping, within
from tamias2d.scene.freedoms import (
    JointSpring,
    Limits,
    Measure,
    Motor,
    limit_symbols,
    motor_symbols,
    spring_symbols,
)
from tamias2d.scene.joint_kinds import (
    Distance,
    Equation,
    Gear,
    Groove,
    JointKind,
    Prismatic,
    Pulley,
    Ratchet,
    Revolute,
    Rotary,
    Target,
    Weld,
    Wheel,
)
from tamias2d.scene.quantities import read_quantity, read_value, scalar_text
from tamias2d.scene.rules import RuleError, shown
from tamias2d.scene.scene import Scene

KINDS: dict[str, Callable[..., JointKind]] = {
    "revolute": Revolute,
    "distance": Distance,
    "weld": Weld,
    "prismatic": Prismatic,
    "groove": Groove,
    "wheel": Wheel,
    "target": Target,
    "rotary": Rotary,
    "ratchet": Ratchet,
    "gear": Gear,
    "pulley": Pulley,
    "equation": Equation,
}
"""The kinds of joints, by the words that a scene file has for them."""
_MUST = {
    "prismatic": ("axis",),
    "groove": ("axis",),
    "wheel": ("axis", "spring"),
    "target": ("spring",),
    "ratchet": ("pitch", "restitution"),
    "gear": ("ratio",),
    "pulley": ("posts",),
}
_MEASURES: dict[str, Measure] = {
    "revolute": "angle",
    "distance": "distance",
    "prismatic": "travel",
    "groove": "travel",
    "wheel": "travel",
    "target": "travel",
    "rotary": "angle",
}
"""What a kind of joint leaves free, which may have limits, a motor and a spring."""
_GOVERNED = ("limits", "motor", "spring")
_MAY = {
    "distance": ("length",),
    "weld": ("angle",),
    "prismatic": ("angle",),
    "gear": ("angle",),
    "pulley": ("ratio", "length"),
}
_SYMBOLS = {
    "length": "joint_length",
    "angle": "joint_angle",
    "ratio": "gear_ratio",
    "pitch": "tooth_pitch",
    "restitution": "restitution",
    "break_force": "joint_force_most",
    "break_torque": "joint_torque_most",
}
_ANCHORS = {"at": "point", "anchor": "anchor", "other_anchor": "anchor", "third_anchor": "anchor"}
_BEARS = ("break_force", "break_torque")
_USUAL = (*_ANCHORS, *_BEARS, "third", "name", "collide")


def add_joints(scene: Scene, raw: object) -> None:
    """Add all joints of a scene file to its scene."""
    for k, entry in enumerate(listed(raw, "joints")):
        with within("joints", k):
            _add(scene, entry)


def _add(scene: Scene, raw: object) -> None:
    joint = mapping(raw, "a joint", must=("kind", "between"))
    word = scalar_text(joint["kind"], ("kind",))
    if word not in KINDS:
        raise RuleError(
            f"kind of a joint: found {shown(word)}{likely(word, KINDS)}: must be one of "
            f"{', '.join(KINDS)} (R2). Correct the word.",
            "kind",
        )
    own = ("equation",) if word == "equation" else _MUST.get(word, ())
    may = (*_MAY.get(word, ()), *_governed(word), *_USUAL)
    mapping(raw, f"a joint of kind {word}", must=("kind", "between", *own), may=may)
    ends = listed(joint["between"], "between")
    if not 1 <= len(ends) <= 2 or (len(ends) == 1 and word != "equation"):
        raise RuleError(
            f"between of a joint: found {len(ends)} ends: must be two, each the name of a body or "
            "a point [x, y] (R2). Write both.",
            "between",
        )
    places = [_end(scene, end, k) for k, end in enumerate(ends)]
    kind = KINDS[word](*_equations(joint), **_values(joint, word))
    values: dict[str, Any] = {
        key: read_value(joint[key], symbol, (key,))
        for key, symbol in _ANCHORS.items()
        if key in joint
    }
    for key in _BEARS:
        if key in joint:
            values[key] = read_quantity(joint[key], _SYMBOLS[key], (key,))
    for key in ("third", "name"):
        if key in joint:
            values[key] = scalar_text(joint[key], (key,))
    if "collide" in joint:
        values["collide"] = read_value(joint["collide"], "sensor", ("collide",))
    try:
        scene.add_joint(kind, *places, **values)
    except RuleError as error:
        if error.path[:1] == ("equations",):  # one expression need not stand in a list
            error.path = (
                "equation",
                *(error.path[1:] if isinstance(joint["equation"], list) else ()),
            )
        raise


def _end(scene: Scene, raw: object, k: int) -> Any:
    """Return the index of a body, or a point of the plane."""
    if isinstance(raw, list):
        return read_value(raw, "point", ("between", k))
    name = scalar_text(raw, ("between", k))
    try:
        return scene.index(name)
    except RuleError as error:
        error.path = ("between", k)
        raise


def _equations(joint: dict[str, object]) -> list[Any]:
    if "equation" not in joint:
        return []
    raw = joint["equation"]
    return [raw if isinstance(raw, list) else scalar_text(raw, ("equation",))]


def _values(joint: dict[str, object], word: str) -> dict[str, Any]:
    """Return what the kind of a joint takes, from its keys."""
    values: dict[str, Any] = {}
    for key in dict.fromkeys((*_MUST.get(word, ()), *_MAY.get(word, ()), *_governed(word))):
        if key not in joint:
            continue
        if key in _GOVERNED:
            values[key] = _part(joint[key], key, _measure(word, key))
        elif key == "axis":
            values[key] = read_value(joint[key], "guide", (key,))
        elif key == "posts":
            posts = listed(joint[key], key)
            values[key] = [read_value(post, "post", (key, k)) for k, post in enumerate(posts)]
        else:
            values[key] = read_quantity(joint[key], _SYMBOLS[key], (key,))
    return values


def _governed(word: str) -> tuple[str, ...]:
    """Return which of limits, a motor and a spring a kind of joint may have."""
    if word == "target":
        return ("spring",)
    return _GOVERNED if word in _MEASURES else ()


def _measure(word: str, key: str) -> Measure:
    """Return what limits, a motor or a spring of a kind of joint act on."""
    return "angle" if (word, key) == ("wheel", "motor") else _MEASURES[word]


def _part(raw: object, key: str, measure: Measure) -> Limits | Motor | JointSpring:
    """Return limits, a motor or a spring."""
    kinds: dict[str, Any] = {
        "limits": (Limits, limit_symbols, ("restitution",)),
        "motor": (Motor, motor_symbols, ("speed",)),
        "spring": (JointSpring, spring_symbols, ("stiffness",)),
    }
    kind, symbols_of, must = kinds[key]
    symbols = symbols_of(measure)
    with within(key):
        may = tuple(name for name in symbols if name not in must)
        part = mapping(raw, f"the {key} of a joint", must=must, may=may)
        found: Limits | Motor | JointSpring = kind(
            **{name: read_quantity(at, symbols[name], (name,)) for name, at in part.items()}
        )
    return found
