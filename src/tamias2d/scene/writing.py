"""A scene as YAML text that loads back to the same scene, bit for bit (`repr` of a float does)."""

import json
import re
from collections.abc import Iterator

from tamias2d.generated.symbols import SYMBOLS
from tamias2d.scene.bodies import Body
from tamias2d.scene.chain import Chain
from tamias2d.scene.compound import Compound, Part, Shape
from tamias2d.scene.fields import ForceField
from tamias2d.scene.filters import ALL
from tamias2d.scene.forms import SECTIONS
from tamias2d.scene.freedoms import Freedom, limit_symbols, motor_symbols, spring_symbols
from tamias2d.scene.joints import Joint
from tamias2d.scene.law import Law
from tamias2d.scene.rules import Vector
from tamias2d.scene.scene_data import SceneData, checked_scene
from tamias2d.scene.shapes import Box, Capsule, Disc, HalfPlane, Polygon, Segment
from tamias2d.scene.springs import Spring
from tamias2d.suggestions import suggests

_JOINT_KEYS = {
    "guide_a": "axis",
    "gear_ratio": "ratio",
    "joint_angle": "angle",
    "joint_length": "length",
}
_WORD = re.compile(r"[A-Za-z_][A-Za-z0-9_-]*")


@suggests
def scene_text(scene: SceneData) -> str:
    """Return the scene as YAML, every value with all its digits and its unit."""
    return "\n".join(_lines(checked_scene(scene))) + "\n"


def _lines(scene: SceneData) -> Iterator[str]:
    if scene.name:
        yield f"name: {_text(scene.name)}"
    if scene.says:
        yield f"says: {_text(scene.says)}"
    yield f"gravity: {_vector(scene.gravity, 'gravity')}"
    if scene.duration is not None:
        yield f"duration: {_quantity(scene.duration, 'duration')}"
    sections: dict[str, list[Body]] = {section: [] for section in SECTIONS}
    for body in scene.bodies:
        sections[_section(body)].append(body)
    for section, bodies in sections.items():
        if bodies:
            yield f"{section}:"
        for body in bodies:
            yield f"  {_text(body.name)}:"
            yield from (f"    {line}" for line in _body(body))
    yield from _pairs("restitution", scene, scene.restitution_of_pairs)
    yield from _pairs("friction", scene, scene.friction_of_pairs)
    yield from _acting(scene)
    yield from _joints(scene)
    if list(scene.bodies) != [body for bodies in sections.values() for body in bodies]:
        names = ", ".join(_text(body.name) for body in scene.bodies)
        yield f"order: [{names}]"


def _section(body: Body) -> str:
    return "bodies" if body.dynamic else "kinematics" if body.kinematic else "statics"


def _body(body: Body) -> Iterator[str]:
    yield from _shape(body.shape)
    if body.dynamic:
        yield f"mass: {_quantity(body.mass, 'mass')}"
    if body.inertia_stated:
        yield f"inertia: {_quantity(body.inertia, 'inertia')}"
    if not isinstance(body.shape, HalfPlane):
        yield f"position: {_vector(body.position, 'position')}"
    if body.orientation:
        yield f"orientation: {_quantity(body.orientation, 'orientation')}"
    if any(body.velocity):
        yield f"velocity: {_vector(body.velocity, 'velocity')}"
    if body.angular_velocity:
        yield f"angular_velocity: {_quantity(body.angular_velocity, 'angular_velocity')}"
    if any(body.force):
        yield _force(body.force)
    if body.torque:
        yield f"torque: {_law(body.torque, 'torque')}"
    for key in ("linear_drag", "quadratic_drag", "angular_drag"):
        if drag := getattr(body, key):
            yield f"{key}: {_quantity(drag, key)}"
    yield from _surface(body)


def _surface(body: Body) -> Iterator[str]:
    yield from _parting(body)
    if body.surface_speed:
        yield f"surface_speed: {_quantity(body.surface_speed, 'surface_speed')}"
    for key, usual in (("category", 1), ("mask", ALL), ("group", 0)):
        if (bits := getattr(body, key)) != usual:
            yield f"{key}: {bits}"
    if body.sensor:
        yield "sensor: true"


def _parting(of: Body | Part) -> Iterator[str]:
    for key in ("restitution", "friction"):
        if (value := getattr(of, key)) is not None:
            yield f"{key}: {value!r}"


def _shape(shape: Shape | None) -> Iterator[str]:
    match shape:
        case None:
            yield "shape: none"
        case Disc(radius=radius):
            yield "shape: disc"
            yield f"radius: {_quantity(radius, 'radius')}"
        case Box(width=width, height=height):
            yield "shape: box"
            yield f"width: {_quantity(width, 'width')}"
            yield f"height: {_quantity(height, 'height')}"
        case Polygon(outline=outline):
            yield "shape: polygon"
            yield "vertices:"
            yield from (f"  - {_vector(vertex, 'vertex')}" for vertex in outline)
        case Capsule(length=length, radius=radius):
            yield "shape: capsule"
            yield f"length: {_quantity(length, 'length')}"
            yield f"radius: {_quantity(radius, 'radius')}"
        case Segment(length=length):
            yield "shape: segment"
            yield f"length: {_quantity(length, 'length')}"
        case Compound(parts=parts):
            yield "shape: compound"
            yield "parts:"
            for part in parts:
                yield from _listed(_part(part))
        case Chain():
            yield "shape: chain"
            yield "vertices:"
            yield from (f"  - {_vector(vertex, 'vertex')}" for vertex in shape.vertices)
            yield from (f"{key}: true" for key in ("loop", "one_sided") if getattr(shape, key))
        case HalfPlane(normal=normal, offset=offset):
            yield "shape: half-plane"
            yield f"normal: {_vector(normal, 'normal')}"
            yield f"offset: {_quantity(offset, 'offset')}"


def _listed(lines: Iterator[str]) -> Iterator[str]:
    """Make one entry of a list of some lines."""
    first, *others = lines
    yield f"  - {first}"
    yield from (f"    {line}" for line in others)


def _part(part: Part) -> Iterator[str]:
    yield from _shape(part.shape)
    if any(part.position):
        yield f"position: {_vector(part.position, 'position')}"
    if part.orientation:
        yield f"orientation: {_quantity(part.orientation, 'orientation')}"
    yield from _parting(part)


def _pairs(key: str, scene: SceneData, values: dict[tuple[int, int], float]) -> Iterator[str]:
    if values:
        yield f"{key}_of_pairs:"
    for (i, j), value in values.items():
        names = f"{_text(scene.bodies[i].name)}, {_text(scene.bodies[j].name)}"
        yield f"  - {{bodies: [{names}], {key}: {value!r}}}"


def _acting(scene: SceneData) -> Iterator[str]:
    if scene.springs:
        yield "springs:"
    for spring in scene.springs:
        yield f"  - {{{', '.join(_spring(scene, spring))}}}"
    if scene.attraction is not None:
        yield "attraction:"
        constant = _quantity(scene.attraction, "gravitational_constant")
        yield f"  gravitational_constant: {constant}"
    if scene.fields:
        yield "fields:"
    for field in scene.fields:
        yield from _listed(_field(scene, field))


def _spring(scene: SceneData, spring: Spring) -> Iterator[str]:
    names = [_text(scene.bodies[k].name) for k in spring.bodies]
    if spring.second is None:
        yield f"body: {names[0]}"
        yield f"point: {_vector(spring.point, 'position')}"
    else:
        yield f"bodies: [{', '.join(names)}]"
    yield f"stiffness: {_quantity(spring.stiffness, 'stiffness')}"
    yield f"rest_length: {_quantity(spring.rest_length, 'rest_length')}"
    if spring.damping:
        yield f"damping: {_quantity(spring.damping, 'damping')}"
    if any(spring.anchor):
        yield f"anchor: {_vector(spring.anchor, 'arm')}"
    if any(spring.other_anchor):
        yield f"other_anchor: {_vector(spring.other_anchor, 'arm')}"


def _field(scene: SceneData, field: ForceField) -> Iterator[str]:
    yield _force(field.force)
    if field.torque:
        yield f"torque: {_law(field.torque, 'torque')}"
    if field.bodies is not None:
        yield f"bodies: [{', '.join(_text(scene.bodies[k].name) for k in field.bodies)}]"


def _joints(scene: SceneData) -> Iterator[str]:
    if scene.joints:
        yield "joints:"
    for joint in scene.joints:
        yield from _listed(_joint(scene, joint))


def _joint(scene: SceneData, joint: Joint) -> Iterator[str]:
    yield f"kind: {joint.kind}"
    between = (
        _vector(at, "position") if k is None else _text(scene.bodies[k].name)
        for k, at in zip(joint.ends[:2], joint.anchors[:2], strict=True)
    )
    yield f"between: [{', '.join(between)}]"
    keys = ("anchor", "other_anchor", "third_anchor")
    for key, k, at in zip(keys, joint.ends, joint.anchors, strict=True):
        if k is not None and any(at):
            yield f"{key}: {_vector(at, 'anchor')}"
    if joint.ends[2] is not None:
        yield f"third: {_text(scene.bodies[joint.ends[2]].name)}"
    yield f"name: {_text(joint.name)}"
    if joint.collide:
        yield "collide: true"
    for key, bears in (("force", joint.break_force), ("torque", joint.break_torque)):
        if bears is not None:
            yield f"break_{key}: {_quantity(bears, f'joint_{key}_most')}"
    yield from _parameters(joint)
    for freedom in joint.freedoms:
        if not freedom.across:
            yield from _freedom(freedom)


def _freedom(freedom: Freedom) -> Iterator[str]:
    """Write down what a joint limits, drives or springs."""
    measure, limits = freedom.measure, freedom.limits
    if freedom.pitch is not None and limits is not None:
        yield f"pitch: {_quantity(freedom.pitch, 'tooth_pitch')}"
        yield f"restitution: {_quantity(limits.restitution, 'restitution')}"
        return
    for key, part, symbols in (
        ("limits", limits, limit_symbols(measure)),
        ("motor", freedom.motor, motor_symbols(measure)),
        ("spring", freedom.spring, spring_symbols(measure)),
    ):
        if part is not None:
            values = ((name, getattr(part, name), symbol) for name, symbol in symbols.items())
            told = (f"{name}: {_quantity(at, by)}" for name, at, by in values if at is not None)
            yield f"{key}: {{{', '.join(told)}}}"


def _parameters(joint: Joint) -> Iterator[str]:
    given = {} if joint.kind == "target" else dict(joint.parameters)
    posts = [_vector(given.pop(key), "post") for key in ("post_a", "post_b") if key in given]  # type: ignore[arg-type]
    if posts:
        yield f"posts: [{', '.join(posts)}]"
    for symbol, value in given.items():
        key = _JOINT_KEYS[symbol]
        if isinstance(value, tuple):
            yield f"{key}: {_vector(value, symbol.removesuffix('_a'))}"
        else:
            yield f"{key}: {_quantity(value, symbol)}"
    if joint.equations:
        yield f"equation: [{', '.join(json.dumps(text) for text in joint.equations)}]"


def _force(force: tuple[Law, Law]) -> str:
    x, y = force
    return f"force: [{_law(x, 'force')}, {_law(y, 'force')}]"


def _quantity(value: float, symbol: str) -> str:
    unit = SYMBOLS[symbol].unit
    return repr(value) if unit == "1" else f"{value!r} {unit}"


def _vector(value: Vector, symbol: str) -> str:
    x, y = value
    return f"[{_quantity(x, symbol)}, {_quantity(y, symbol)}]"


def _law(law: Law, symbol: str) -> str:
    return _quantity(law, symbol) if isinstance(law, float) else json.dumps(law.text)


def _text(text: str) -> str:
    return text if _WORD.fullmatch(text) else json.dumps(text, ensure_ascii=False)
