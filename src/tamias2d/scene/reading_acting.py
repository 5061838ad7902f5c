"""What acts on the bodies of a scene file: springs, attraction and fields."""

from collections.abc import Mapping
from typing import Any

from tamias2d.scene.forms import listed, mapping, two_names, within
from tamias2d.scene.quantities import read_quantity, read_value, scalar_text
from tamias2d.scene.rules import RuleError
from tamias2d.scene.scene import Scene

_SPRING_MUST = ("stiffness", "rest_length")
_SPRING_MAY = ("damping", "anchor", "other_anchor")
_NAMES = ("bodies", "body")
_SPRING_KEYS = (*_NAMES, "point", *_SPRING_MUST, *_SPRING_MAY)


def add_acting(scene: Scene, top: Mapping[str, object]) -> None:
    """Add what the top of a scene file says of springs, attraction and fields to its scene."""
    for k, entry in enumerate(listed(top.get("springs", []), "springs")):
        with within("springs", k):
            _add_spring(scene, entry)
    if "attraction" in top:
        with within("attraction"):
            _add_attraction(scene, top["attraction"])
    for k, entry in enumerate(listed(top.get("fields", []), "fields")):
        with within("fields", k):
            _add_field(scene, entry)


def _add_spring(scene: Scene, raw: object) -> None:
    spring = mapping(raw, "a spring", may=_SPRING_KEYS)
    between = "bodies" in spring
    if between == ("body" in spring):
        raise RuleError(
            "a spring: must hold either two 'bodies', or a 'body' and a 'point' (R2). Correct it.",
            *("bodies" if between else next(iter(spring), ""), "key"),
        )
    ends = ("bodies",) if between else ("body", "point")
    mapping(raw, "a spring", must=(*ends, *_SPRING_MUST), may=_SPRING_MAY)
    values: dict[str, Any] = {
        key: read_value(value, key, (key,)) for key, value in spring.items() if key not in _NAMES
    }
    if between:
        first, second = two_names(spring["bodies"], "a spring")
        scene.add_spring(first, second, **values)
    else:
        first = _body(scene, spring["body"])
        scene.add_spring(first, values.pop("point"), **values)


def _body(scene: Scene, raw: object) -> str:
    """Return the name of a body of the scene, or raise `RuleError` with the place of the name."""
    name = scalar_text(raw, ("body",))
    try:
        scene.index(name)
    except RuleError as error:
        error.path = ("body",)
        raise
    return name


def _add_attraction(scene: Scene, raw: object) -> None:
    key = "gravitational_constant"
    attraction = mapping(raw, "attraction", must=(key,), may=())
    scene.add_attraction(gravitational_constant=read_quantity(attraction[key], key, (key,)))


def _add_field(scene: Scene, raw: object) -> None:
    field = mapping(raw, "a field", may=("force", "torque", "bodies"))
    values: dict[str, Any] = {
        key: read_value(value, key, (key,)) for key, value in field.items() if key != "bodies"
    }
    if "bodies" in field:
        names = listed(field["bodies"], "bodies")
        values["bodies"] = [scalar_text(name, ("bodies", k)) for k, name in enumerate(names)]
    scene.add_field(**values)
