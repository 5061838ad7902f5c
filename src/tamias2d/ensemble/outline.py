"""A scene as a tree of plain values, in the words of scene files, and the scene of such a tree.

Serves: whoever changes single values of a scene. Hides: how a scene is taken apart and put
together again, every value checked as in any other scene.
"""

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from typing import Any

from tamias2d.ensemble.joint_values import values_of, with_values
from tamias2d.scene import Body, Box, Capsule, Compound, Disc, HalfPlane, Scene, Segment
from tamias2d.scene.law import StateLaw

Outline = dict[str, Any]
"""Keys are those of scene files; bodies and joints by name, pairs by both names, springs listed."""

_SURFACE = ("restitution", "friction", "category", "mask", "group", "sensor")
_OF_PART = ("restitution", "friction")
_PLACE = ("position", "orientation")
_MOTION = ("velocity", "angular_velocity")
_LOADS = ("force", "torque", "linear_drag", "quadratic_drag", "angular_drag")
_SIZES: dict[type, tuple[str, ...]] = {
    Disc: ("radius",),
    Box: ("width", "height"),
    Capsule: ("length", "radius"),
    Segment: ("length",),
    HalfPlane: ("normal", "offset"),
}


def outline_of(scene: Scene) -> Outline:
    """Return the values of a scene."""
    names = [body.name for body in scene.bodies]
    return {
        "gravity": scene.gravity,
        "bodies": {body.name: _values(body) for body in scene.bodies},
        "restitution_of_pairs": _of_pairs(scene.restitution_of_pairs, names),
        "friction_of_pairs": _of_pairs(scene.friction_of_pairs, names),
        "springs": [_attributes(spring) for spring in scene.springs],
        "joints": {joint.name: values_of(joint) for joint in scene.joints},
        "attraction": {}
        if scene.attraction is None
        else {"gravitational_constant": scene.attraction},
    }


def scene_of(outline: Outline, like: Scene) -> Scene:
    """Return the scene of an outline; what an outline does not hold is as in another scene.

    Raises:
        InputError: a value breaks a rule (R4).
    """
    scene = Scene(
        gravity=outline["gravity"], name=like.name, says=like.says, duration=like.duration
    )
    for body in like.bodies:
        _add(scene, body, outline["bodies"][body.name])
    for (first, second), value in outline["restitution_of_pairs"].items():
        scene.set_restitution(first, second, value)
    for (first, second), value in outline["friction_of_pairs"].items():
        scene.set_friction(first, second, value)
    for values in outline["springs"]:
        point = values["point"] if values["second"] is None else values["second"]
        ends = {"first": values["first"], "second": point}
        scene.add_spring(**ends, **_without(values, "first", "second", "point"))
    if outline["attraction"]:
        scene.add_attraction(**outline["attraction"])
    for field in like.fields:
        scene.add_field(**_attributes(field))
    for joint in like.joints:
        scene.repeat_joint(with_values(joint, outline["joints"][joint.name]))
    return scene


def _values(body: Body) -> dict[str, Any]:
    """Return what can be said of a body, its sizes beside the rest, as scene files have it."""
    keys: tuple[str, ...] = _SURFACE
    if not isinstance(body.shape, HalfPlane):
        keys += _PLACE
    if not body.static:
        keys += _MOTION
    if not body.dynamic:
        keys += ("surface_speed",)
    else:
        keys += ("mass", "inertia", *_LOADS)
    values = {key: _stated(getattr(body, key)) for key in keys}
    if not body.inertia_stated and body.dynamic:
        values["inertia"] = None
    if isinstance(body.shape, Compound):
        values["parts"] = [
            {key: getattr(part, key) for key in _OF_PART} for part in body.shape.parts
        ]
    return values | {size: getattr(body.shape, size) for size in _SIZES.get(type(body.shape), ())}


def _add(scene: Scene, body: Body, values: Mapping[str, Any]) -> None:
    sizes = _SIZES.get(type(body.shape), ())
    shape: Any = body.shape
    if sizes:
        shape = type(shape)(**{size: values[size] for size in sizes})
    if isinstance(shape, Compound):
        shape = _with_surfaces(shape, values["parts"])
    rest = _without(values, *sizes, "parts")
    add: Any = scene.add_static
    if body.dynamic:
        add = scene.add_body
    elif body.kinematic:
        add = scene.add_kinematic
    add(shape, name=body.name, **rest)


def _with_surfaces(shape: Compound, parts: Sequence[Mapping[str, Any]]) -> Compound:
    """Return a compound whose parts state other surfaces; the same one where they are equal."""
    changed = tuple(replace(part, **own) for part, own in zip(shape.parts, parts, strict=True))
    return shape if changed == shape.parts else Compound(parts=changed)


def _of_pairs(values: Mapping[tuple[int, int], float], names: list[str]) -> dict[Any, float]:
    return {(names[i], names[j]): value for (i, j), value in values.items()}


def _attributes(item: Any) -> dict[str, Any]:
    return {field.name: _stated(getattr(item, field.name)) for field in fields(item)}


def _stated(value: Any) -> Any:
    """Return a value as it is given to a scene: laws as text."""
    if isinstance(value, tuple):
        return tuple(_stated(item) for item in value)
    return value.text if isinstance(value, StateLaw) else value


def _without(values: Mapping[str, Any], *keys: str) -> dict[str, Any]:
    return {key: value for key, value in values.items() if key not in keys}
