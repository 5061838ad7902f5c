"""Scenes from YAML files: what each key means, and where it stands when it is wrong."""

import stat
from collections.abc import Mapping
from dataclasses import replace
from os import PathLike
from pathlib import Path
from typing import Any

from tamias2d.errors import SceneError, path_text
from tamias2d.scene.bodies import Body
from tamias2d.scene.forms import SECTIONS, listed, mapping, two_names, within
from tamias2d.scene.other_bodies import with_bodies
from tamias2d.scene.quantities import KeyPath, read_quantity, read_value, scalar_text
from tamias2d.scene.reading_acting import add_acting
from tamias2d.scene.reading_joints import add_joints
from tamias2d.scene.reading_shapes import optional_shape_keys, read_shape, shape_keys
from tamias2d.scene.rules import RuleError, shown
from tamias2d.scene.scene import Scene
from tamias2d.spec.markup import MAX_SIZE, MarkupError, Place, compose
from tamias2d.suggestions import suggests

_TOP_MAY = (
    *("name", "says", "duration", *SECTIONS, "restitution_of_pairs", "friction_of_pairs"),
    *("order", "springs", "attraction", "fields", "joints"),
)
_SURFACE = ("restitution", "friction", "category", "mask", "group", "sensor")
_MAY = {
    "bodies": (
        *("velocity", "orientation", "angular_velocity", "force", "torque", "inertia"),
        *("linear_drag", "quadratic_drag", "angular_drag", *_SURFACE),
    ),
    "kinematics": ("velocity", "orientation", "angular_velocity", "surface_speed", *_SURFACE),
    "statics": ("position", "orientation", "surface_speed", *_SURFACE),
}
_MUST = {
    "bodies": ("shape", "mass", "position"),
    "kinematics": ("shape", "position"),
    "statics": ("shape",),
}
_WHAT = {"bodies": "body", "kinematics": "kinematic body", "statics": "static body"}


@suggests
def load(source: str | Path) -> Scene:
    """Return the scene of a YAML file, or of YAML text (a text has more than one line).

    A scene is what its text says, wherever the file lies and whatever that is called.

    Raises:
        SceneError: the file or a value in it breaks a rule; the message says where.
    """
    if not isinstance(source, str | PathLike) or source == "":
        raise SceneError(
            f"scene file: found {shown(source)}: must be a path or YAML text (R2). Give one."
        )
    if isinstance(source, str) and "\n" in source:
        return read_scene(source, file="scene")
    path = Path(source)
    if path.suffix in (".npz", ".rrd"):
        raise SceneError(
            f"{path_text(path)}: suffix {path.suffix!r}: a scene is a file in YAML (R2). A "
            "recording of a run is read by Run.load(path), and shown by `tamias2d replay`; a saved "
            "simulator by Simulator.restore(path)."
        )
    return read_scene(_file_text(path), file=str(path))


def _file_text(path: Path) -> str:
    content = _file_bytes(path)
    try:
        return content.decode()
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        begin = error.object.rfind(b"\n", 0, error.start) + 1
        column = len(error.object[begin : error.start].decode()) + 1
        raise SceneError(
            f"{path}:{line}:{column}: found byte 0x{error.object[error.start]:02x}: must be UTF-8 "
            "(R2). Save the file in UTF-8."
        ) from None


def _file_bytes(path: Path) -> bytes:
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):
            kind = "a directory" if stat.S_ISDIR(status.st_mode) else "no regular file"
            fault = f"{kind} (R2). Give the path of a scene in YAML."
        elif status.st_size > 4 * MAX_SIZE:  # a character has up to four bytes
            fault = f"more than {MAX_SIZE} characters (R2). Split the scene."
        else:
            return path.read_bytes()
    except (FileNotFoundError, NotADirectoryError):
        fault = "no such file (R2). Give the path of a scene in YAML."
    except (OSError, ValueError) as error:
        said = error.strerror if isinstance(error, OSError) else error
        fault = f"{said} (R2). Give a file to read."
    raise SceneError(f"{path_text(path)}: {fault}")


def read_scene(text: str, *, file: str, name: str = "", longest: float = MAX_SIZE) -> Scene:
    """Return the scene of a text of at most `longest` characters.

    `name` is its name unless the text gives one.

    Raises:
        SceneError: as `load`.
    """
    try:
        tree, marks = compose(text, file=file, longest=longest)
    except MarkupError as error:
        raise SceneError(str(error)) from None
    try:
        scene = _scene(tree, name)
    except RuleError as error:
        line, column = _place(marks, error.path)
        raise SceneError(f"{file}:{line}:{column}: {error}") from None
    return with_bodies(scene, (_located(body, marks, file) for body in scene.bodies))


def _located(body: Body, marks: Mapping[KeyPath, Place], file: str) -> Body:
    """Return a body with the place where a file has it, for what is said of it later."""
    places = (marks.get((section, body.name, "key")) for section in SECTIONS)
    line, column = next(filter(None, places), (1, 1))
    return replace(body, where=f"{file}:{line}:{column}")


def _place(marks: Mapping[KeyPath, Place], path: KeyPath) -> Place:
    """Return the place of the value at a path, or of the nearest thing around it."""
    if path in marks:
        return marks[path]
    while path:
        path = path[:-1]
        if path and isinstance(path[-1], int):
            return marks[path]
        if (*path, "key") in marks:
            return marks[*path, "key"]
    return 1, 1


def _scene(tree: object, name: str) -> Scene:
    top = mapping(tree, "a scene", must=("gravity",), may=_TOP_MAY)
    texts = {key: scalar_text(top[key], (key,)) for key in ("name", "says") if key in top}
    duration = (
        read_quantity(top["duration"], "duration", ("duration",)) if "duration" in top else None
    )
    gravity = read_value(top["gravity"], "gravity", ("gravity",))
    scene = Scene(gravity=gravity, duration=duration, **{"name": name, **texts})
    for section, body, raw in _in_order(top):
        with within(section, body):
            _add(scene, section, body, raw)
    for key in ("restitution", "friction"):
        pairs = f"{key}_of_pairs"
        entries = listed(top.get(pairs, []), pairs)
        with within(pairs):
            _set_pairs(scene, key, entries)
    add_acting(scene, top)
    add_joints(scene, top.get("joints", []))
    return scene


def _in_order(top: Mapping[str, object]) -> list[tuple[str, str, object]]:
    """Return section, name and value of all bodies: first what moves, unless `order` says else."""
    sections = {key: mapping(top[key], f"'{key}'") for key in SECTIONS if key in top}
    found = [(key, name, body) for key, part in sections.items() for name, body in part.items()]
    if "order" not in top:
        return found
    order = listed(top["order"], "order")
    names = [name for _, name, _ in found]
    if not all(isinstance(name, str) for name in order) or sorted(order) != sorted(names):  # type: ignore[type-var]
        raise RuleError(
            f"order: found {shown(order)}: must name each body once (R1). Name all of {names}.",
            "order",
        )
    return sorted(found, key=lambda entry: order.index(entry[1]))


def _add(scene: Scene, section: str, name: str, raw: object) -> None:
    what = f"{_WHAT[section]} '{name}'"
    keys, optional = shape_keys(raw, what), optional_shape_keys(raw, what)
    body = mapping(raw, what, must=(*_MUST[section], *keys), may=(*_MAY[section], *optional))
    values: dict[str, Any] = {
        key: read_value(value, key, (key,))
        for key, value in body.items()
        if key not in ("shape", *keys, *optional)
    }
    add = {
        "bodies": scene.add_body,
        "kinematics": scene.add_kinematic,
        "statics": scene.add_static,
    }[section]
    add(read_shape(body, what), name=name, **values)  # type: ignore[operator]


def _set_pairs(scene: Scene, key: str, entries: list[object]) -> None:
    """Set the restitution or the friction of pairs."""
    known = getattr(scene, f"{key}_of_pairs")
    for k, entry in enumerate(entries):
        with within(k):
            pair = mapping(entry, "a pair", must=("bodies", key), may=())
            first, second = two_names(pair["bodies"], "a pair")
            i, j = sorted((scene.index(first), scene.index(second)))
            if (i, j) in known:
                raise RuleError(
                    f"pair '{first}' and '{second}': stands twice (R3). Remove one entry.", "bodies"
                )
            known[i, j] = value = read_quantity(pair[key], key, (key,))
            set_value = scene.set_restitution if key == "restitution" else scene.set_friction
            set_value(i, j, value)
