"""Every fault of a scene file is one SceneError that says where it is and what to do."""

import math
import re
from pathlib import Path

import pytest

import tamias2d as t2
from tamias2d.errors import SceneError
from tamias2d.scene import Box, Capsule, Compound, Part, Segment, load

GOOD = """\
name: pile
says: a crate above a floor
gravity: [0 m/s^2, -9.81 m/s^2]
duration: 4 s
bodies:
  crate:
    shape: box
    width: 2 m
    height: 1 m
    mass: 10 kg
    position: [0 m, 5 m]
    restitution: 0.5
  stone:
    shape: polygon
    vertices: [[0 m, 0 m], [2 m, 0 m], [2 m, 2 m], [0 m, 2 m]]
    mass: 1 kg
    position: [9 m, 5 m]
    force: ["2[N]*sin(3[rad/s]*time)", 0 N]
    torque: 1 N*m
statics:
  floor:
    shape: half-plane
    normal: [0, 1]
    offset: 0 m
restitution_of_pairs:
  - {bodies: [stone, floor], restitution: 0.1}
springs:
  - {bodies: [crate, stone], stiffness: 5 N/m, rest_length: 1 m, damping: 2 kg/s}
  - {body: crate, point: [0 m, 9 m], stiffness: 4 N/m, rest_length: 0 m, anchor: [1 m, 0.5 m]}
attraction:
  gravitational_constant: 3 m^3/(kg*s^2)
fields:
  - force: ["0.5[kg/s]*y(velocity)", 0 N]
    torque: -1[N*m]*sin(orientation)
    bodies: [stone]
"""
SQUARE = "[[0 m, 0 m], [2 m, 0 m], [2 m, 2 m], [0 m, 2 m]]"

# what is replaced in the good file, by what, where the fault is reported, words of the message
BAD = [
    # numbers out of range
    ("mass: 10 kg", "mass: -1 kg", "10:11", "mass -1 kg of body 'crate': must be > 0"),
    ("mass: 10 kg", "mass: 0 kg", "10:11", "make the body static"),
    ("mass: 10 kg", "mass: 1e400 kg", "10:11", "finite"),
    ("mass: 10 kg", "mass: 1e-320 kg", "10:11", "inverse"),
    ("mass: 10 kg", "mass: 1e-300 kg\n    inertia: 1e-310 kg*m^2", "11:14", "inertia"),
    ("mass: 10 kg", "mass: 10 kg\n    inertia: 0 kg*m^2", "11:14", "inertia"),
    ("mass: 10 kg", "mass: nan kg", "10:11", "nan"),
    ("mass: 10 kg", "mass: inf kg", "10:11", "inf"),
    ("width: 2 m", "width: 0 m", "8:12", "width 0 m of a box: must be > 0"),
    ("height: 1 m", "height: -1 m", "9:13", "height"),
    ("width: 2 m", "width: 1e200 m", "6:3", "inertia"),
    ("restitution: 0.5", "restitution: 1.0000000000000002", "12:18", "1.0000000000000002"),
    ("restitution: 0.5", "restitution: -0.1", "12:18", "restitution -0.1 of body 'crate'"),
    ("restitution: 0.1", "restitution: 2", "26:43", "the pair 'stone' and 'floor'"),
    ("duration: 4 s", "duration: 0 s", "4:11", "duration"),
    ("duration: 4 s", "duration: -4 s", "4:11", "duration"),
    # units
    ("mass: 10 kg", "mass: 10 N", "10:11", "must be in kg"),
    ("mass: 10 kg", "mass: 10", "10:11", "must be in kg"),
    ("mass: 10 kg", "mass: 10 pounds", "10:11", "pounds"),
    ("mass: 10 kg", "mass: ten kg", "10:11", "ten kg"),
    ("mass: 10 kg", "mass: 10 kg kg", "10:11", "kg"),
    ("mass: 10 kg", "mass: yes", "10:11", "yes"),
    ("position: [0 m, 5 m]", "position: [0 m, 5 s]", "11:21", "must be in m"),
    ("position: [0 m, 5 m]", "position: [0 m, 5 m]\n    orientation: 45", "12:18", "rad or deg"),
    ("position: [0 m, 5 m]", "position: [0 m, 5 m]\n    angular_velocity: 3 Hz", "12:23", "rad/s"),
    ("restitution: 0.5", "restitution: 0.5 rad", "12:18", "is no angle (symbol restitution)"),
    ("restitution: 0.5", "restitution: 50 %", "12:18", "%"),
    ("gravity: [0 m/s^2, -9.81 m/s^2]", "gravity: [0 m/s, -9.81 m/s]", "3:11", "must be in m s^-2"),
    ("offset: 0 m", "offset: 1 kg", "24:13", "offset"),
    ("torque: 1 N*m", "torque: 1 N", "19:13", "torque"),
    # counts and forms
    ("position: [0 m, 5 m]", "position: [0 m]", "11:15", "two"),
    ("position: [0 m, 5 m]", "position: [0 m, 5 m, 6 m]", "11:15", "two"),
    ("position: [0 m, 5 m]", "position: 5 m", "11:15", "found '5 m'"),
    ("position: [0 m, 5 m]", "position:", "11:14", "nothing"),
    ("position: [0 m, 5 m]", "position: [[0 m, 5 m]]", "11:15", "two"),
    ("position: [0 m, 5 m]", "position: [[0 m], 5 m]", "11:16", "list"),
    ("position: [0 m, 5 m]", "position: {x: 0 m, y: 5 m}", "11:15", "mapping"),
    ("mass: 10 kg", "mass: [10 kg]", "10:11", "list"),
    ("mass: 10 kg", "mass:", "10:10", "nothing"),
    ("name: pile", "name: [pile]", "1:7", "list"),
    ("duration: 4 s", "duration: {s: 4}", "4:11", "mapping"),
    ("normal: [0, 1]", "normal: [0, 0]", "23:13", "no direction"),
    ("normal: [0, 1]", "normal: [0 m, 1 m]", "23:14", "pure number"),
    # polygons
    (SQUARE, "[[0 m, 0 m], [2 m, 0 m]]", "15:15", "at least 3"),
    (SQUARE, "[[0 m, 0 m], [2 m, 0 m], [1 m, 0.5 m], [0 m, 2 m]]", "15:40", "vertices[2]"),
    (SQUARE, "[[0 m, 0 m], [2 m, 2 m], [2 m, 0 m], [0 m, 2 m]]", "15:28", "convex"),
    (SQUARE, "[[0 m, 0 m], [1 m, 0 m], [2 m, 0 m], [0 m, 2 m]]", "15:28", "in line"),
    (SQUARE, "[[0 m, 0 m], [2 m, 0 m], [2 m, 0 m], [0 m, 2 m]]", "15:40", "same"),
    (SQUARE, "[[0 m, 0 m], [2 m], [2 m, 2 m]]", "15:28", "two"),
    (SQUARE, "none", "15:15", "list"),
    # keys and words
    ("mass: 10 kg", "mas: 10 kg", "10:5", "did you mean 'mass'"),
    ("mass: 10 kg", "angle: 45 deg", "10:5", "orientation"),
    ("    mass: 10 kg\n", "", "6:3", "'mass' is missing"),
    ("    width: 2 m\n", "", "6:3", "'width' is missing"),
    ("    shape: box\n", "", "6:3", "'shape' is missing"),
    ("gravity: [0 m/s^2, -9.81 m/s^2]\n", "", "1:1", "'gravity' is missing"),
    ("shape: box", "shape: boxx", "7:12", "did you mean 'box'"),
    ("shape: box", "shape: circle", "7:12", "disc, box, polygon, capsule, segment"),
    ("shape: box", "shape: half-plane", "8:5", "width"),
    ("box\n    width: 2 m\n    height: 1 m", "none\n    torque: 1 N*m", "6:3", "inertia"),
    ("    offset: 0 m", "    offset: 0 m\n    mass: 1 kg", "25:5", "key 'mass'"),
    ("    offset: 0 m", "    offset: 0 m\n    position: [1 m, 0 m]", "25:15", "half-plane"),
    ("bodies:\n  crate", "boddies:\n  crate", "5:1", "did you mean 'bodies'"),
    ("  floor:", "  crate:", "21:3", "another body has it"),
    ("  stone:", "  crate:", "13:3", "twice"),
    ("  stone:", '  "":', "13:3", "characters"),
    ("  stone:", '  "a\\tb":', "13:3", "printable"),
    ("[stone, floor]", "[stone, flor]", "26:14", "flor"),
    ("[stone, floor]", "[stone, stone]", "26:14", "itself"),
    ("[stone, floor]", "[stone]", "26:14", "two names"),
    ("pairs:\n", "pairs:\n  - {bodies: [floor, stone], restitution: 0}\n", "27:14", "twice"),
    ("  - {bodies: [stone, floor], restitution: 0.1}", "  stone: 0.1", "26:3", "list"),
    ("duration: 4 s", "order: [crate, stone]", "4:8", "each body once"),
    ("duration: 4 s", "order: [crate, stone, [floor]]", "4:8", "each body once"),
    # laws
    ("sin(3[rad/s]*time)", "sin(3[rad/s]*tim)", "18:13", "tim"),
    ("sin(3[rad/s]*time)", "sin(3[m]*time)", "18:13", "pure number"),
    ("2[N]*sin", "2[kg]*sin", "18:13", "wanted"),
    ("2[N]*sin", "__import__('os')*sin", "18:13", "not allowed"),
    ("2[N]*sin(3[rad/s]*time)", "2[N*s]/time", "18:13", "no finite value at time 0"),
    ("2[N]*sin(3[rad/s]*time)", "2[N]*d(time, time)", "18:13", "instant"),
    ("2[N]*sin(3[rad/s]*time)", "vector(2[N], 3[N])*time/1[s]", "18:13", "vector"),
    ("2[N]*sin(3[rad/s]*time)", "2[N]*velocity", "18:13", "velocity"),
    # drag, springs, attraction, fields
    ("    torque: 1 N*m", "    linear_drag: -1 kg/s", "19:18", "must be >= 0"),
    ("    torque: 1 N*m", "    linear_drag: 1 kg/m", "19:18", "must be in"),
    ("    torque: 1 N*m", "    quadratic_drag: 1 kg/s", "19:21", "quadratic drag"),
    ("    torque: 1 N*m", "    drag: 1 kg/s", "19:5", "linear_drag"),
    ("torque: 1 N*m", "torque: 2[N*m]*sin(position)", "19:13", "a scalar"),
    ("stiffness: 5 N/m", "stiffness: 0 N/m", "28:41", "must be > 0"),
    ("stiffness: 5 N/m", "stiffness: 5 N", "28:41", "must be in"),
    ("stiffness: 5 N/m, ", "", "28:5", "'stiffness' is missing"),
    ("{bodies: [crate, stone], s", "{between: [crate, stone], s", "28:6", "key 'between' of"),
    ("  gravitational_constant: 3", "  3", "31:3", "Write 'gravitational_constant: value' lines"),
    ("  - {body: crate, point: [0 m, 9 m]", "  - 3 N/m  #", "29:5", "'bodies: value'"),
    ("stiffness: 5 N/m", "stifness: 5 N/m", "28:30", "did you mean 'stiffness'"),
    ("rest_length: 1 m", "rest_length: -1 m", "28:61", "rest length -1 m of spring 0"),
    ("damping: 2 kg/s", "damping: -2 kg/s", "28:75", "damping"),
    ("[crate, stone]", "[crate, stoned]", "28:14", "stoned"),
    ("[crate, stone]", "[crate, crate]", "28:14", "one body"),
    ("[crate, stone]", "[floor, floor]", "28:14", "no body that moves"),
    ("[crate, stone]", "[crate]", "28:14", "two names"),
    ("body: crate", "body: crates", "29:12", "crates"),
    ("body: crate, ", "", "29:6", "either two 'bodies'"),
    ("body: crate", "body: crate, bodies: [crate, stone]", "29:19", "either two 'bodies'"),
    ("point: [0 m, 9 m], ", "", "29:5", "'point' is missing"),
    ("point: [0 m, 9 m]", "point: [0 m, 9 s]", "29:32", "must be in m"),
    ("point: [0 m, 9 m]", "point: stone", "29:26", "list"),
    ("anchor: [1 m, 0.5 m]", "anchor: [1 m]", "29:82", "two"),
    ("anchor: [1 m, 0.5 m]", "other_anchor: [1 m, 0 m]", "29:88", "a point has none"),
    ("  gravitational_constant: 3 m^3/(kg*s^2)", "  gravity: 3 N", "31:3", "unknown"),
    ("3 m^3/(kg*s^2)", "3 m^3", "31:27", "must be in"),
    ("\n  gravitational_constant: 3 m^3/(kg*s^2)", " 3 N", "30:13", "mapping"),
    ("0.5[kg/s]*y(velocity)", "0.5[kg/s]*velocity", "33:13", "a scalar"),
    ("0.5[kg/s]*y(velocity)", "0.5[kg/s]*y(speed)", "33:13", "speed"),
    ("0.5[kg/s]*y(velocity)", "0.5[kg*m/s]*y(velocity)/x(velocity)", "33:13", "wanted"),
    ("0.5[kg/s]*y(velocity)", "0.5[N]*y(velocity)/x(velocity)", "33:13", "no finite value"),
    ("sin(orientation)", "sin(orientaton)", "34:13", "orientation"),
    ("bodies: [stone]", "bodies: stone", "35:13", "list"),
    ("bodies: [stone]", "bodies: [floor]", "35:13", "static"),
    ("bodies: [stone]", "bodies: [[stone]]", "35:14", "one value"),
    ("bodies: [stone]", "body: stone", "35:5", "did you mean 'bodies'"),
    # YAML
    ("mass: 10 kg", "mass: &m 10 kg", "10:11", "anchor"),
    ("mass: 10 kg", "mass: *m", "10:11", "alias"),
    ("mass: 10 kg", "mass: !!python/object:os.system 10 kg", "10:11", "tag"),
    ("mass: 10 kg", "mass: 10 kg\n    mass: 11 kg", "11:5", "twice"),
    ("mass: 10 kg", "mass: 10 kg\n   width: 3 m", "11:4", "YAML"),
    ("mass: 10 kg", "? [mass, weight]\n    : 10 kg", "10:7", "key"),
    ("mass: 10 kg", "mass: 10 kg\n\tx: 1", "11:1", "YAML"),
    ("mass: 10 kg", "mass: 10 kg: 3", "10:16", "YAML"),
    ("force: [\"2[N]*sin(3[rad/s]*time)\", 0 N]", "force: [2[N]*time, 0 N]", "18:", "YAML"),
    ("says: a crate above a floor", "says: a\x00b", "2:8", "U+0000"),
]  # fmt: skip


def test_the_file_that_is_spoilt_is_good() -> None:
    assert len(load(GOOD)) == 3


@pytest.mark.parametrize(("good", "bad", "place", "words"), BAD, ids=[row[1][:40] for row in BAD])
def test_a_fault_is_named_at_its_place(
    good: str, bad: str, place: str, words: str, tmp_path: Path
) -> None:
    assert GOOD.count(good) == 1
    file = tmp_path / "pile.yaml"
    file.write_text(GOOD.replace(good, bad), encoding="utf-8", newline="")
    with pytest.raises(SceneError) as caught:
        load(file)
    message = str(caught.value)
    assert message.startswith(f"{file}:{place}")
    assert words in message
    assert "\n" not in message
    assert re.search(r"\. [A-Z]", message), "no remedy"


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "nothing"),
        (b"\n# only a comment\n", "nothing"),
        (b"- a\n- b\n", "must be a mapping"),
        (b"just text\n", "must be a mapping"),
        (b"gravity: [\xff m/s^2, 0 m/s^2]\n", ":1:11: found byte 0xff: must be UTF-8"),
        ("a: 1\nße".encode() + b"\xff\n", ":2:3: found byte 0xff: must be UTF-8"),
        (b"a: 1\nsays: \0\n", ":2:7: yaml: character U+0000 is none of YAML"),
        ("gravity: 1\n\ufeffsays: x\n".encode(), r":2:1: key '\ufeffsays' of a scene"),
        ("gravity: [1\u200b m/s^2, 0]\n".encode(), r"gravity[0]: '1\u200b m/s^2': must be"),
        ("s\u202e: 1\ns\u202e: 1\n".encode(), r":2:1: duplicate-key: 's\u202e' stands twice"),
        ("gravity: [0 m/s^2, 0 m/s^2]\n".encode("utf-16"), "UTF-8"),
        (b"says: " + b"x" * 5_000_000, "1000000 characters"),
        (b"says: " + b"x" * 2_000_000 + b"\n", "1000000 characters"),
        (b"gravity: " + b"[" * 5000, "nest"),
        (b"gravity: [0 m/s^2, 0 m/s^2]\n---\ngravity: [0 m/s^2, 0 m/s^2]\n", "document"),
    ],
)
def test_a_file_that_is_no_scene(content: bytes, words: str, tmp_path: Path) -> None:
    file = tmp_path / "x.yaml"
    file.write_bytes(content)
    with pytest.raises(SceneError) as caught:
        load(file)
    assert words in str(caught.value)
    assert str(file) in str(caught.value)


@pytest.mark.parametrize("path", ["no-such.yaml", "", ".", "/dev/zero", "a\0b", "x" * 5000])
def test_a_path_that_leads_to_no_file(path: str) -> None:
    with pytest.raises(SceneError):
        load(path)


SHAPES = """\
gravity: [0 m/s^2, 0 m/s^2]
bodies:
  bar:
    shape: capsule
    length: 2 m
    radius: 25 cm
    mass: 1 kg
    position: [0 m, 5 m]
    friction: 0.5
    angular_drag: 2 kg*m^2/s
    category: 0b10
    mask: 0xff
    group: -3
    sensor: true
kinematics:
  drum:
    shape: compound
    parts:
      - {shape: box, width: 2 m, height: 10 cm, position: [0 m, 1 m]}
      - {shape: segment, length: 2 m, position: [1 m, 0 m], orientation: 90 deg}
    position: [0 m, 0 m]
    angular_velocity: 30 deg/s
statics:
  wall:
    shape: segment
    length: 3 m
friction_of_pairs:
  - {bodies: [bar, wall], friction: 0.25}
"""
BAD_SHAPES = [
    ("radius: 25 cm", "radius: 0 cm", "6:13", "radius 0 m of a capsule: must be > 0"),
    ("    length: 2 m\n", "", "3:3", "'length' is missing"),
    ("friction: 0.5", "friction: -1", "9:15", "friction -1 of body 'bar': must be >= 0"),
    ("friction: 0.5", "friction: 1 m", "9:15", "must be a pure number"),
    ("2 kg*m^2/s", "2 kg/s", "10:19", "must be in kg m^2 s^-1"),
    ("0b10", "two", "11:15", "found 'two': must be a whole number (R3). Write it like 5"),
    ("0xff", "-1", "12:11", "mask -1 of body 'bar': must be from 0 to"),
    ("group: -3", "group: 1.5", "13:12", "found '1.5'"),
    ("sensor: true", "sensor: yes", "14:13", "must be true or false"),
    ("height: 10 cm", "height: 0 m", "19:42", "height 0 m of a box"),
    ("shape: segment, length: 2 m,", "shape: segment,", "20:9", "'length' is missing"),
    (
        "shape: segment, length: 2 m,",
        "shape: compound, parts: [],",
        "20:34",
        "parts of a compound: found none",
    ),
    ("shape: segment, length: 2 m,", "shape: sgment, length: 2 m,", "20:17", "'segment'"),
    ("orientation: 90 deg}", "orientation: 90}", "20:74", "rad or deg"),
    ("orientation: 90 deg}", "turn: 90 deg}", "20:61", "turn"),
    ("30 deg/s", "30 m/s", "22:23", "angular velocity"),
    ("    angular_velocity", "    mass: 1 kg\n    angular_velocity", "22:5", "key 'mass'"),
    ("friction: 0.25", "restitution: 0.25", "28:27", "friction"),
]


def test_a_file_with_all_shapes_says_what_it_says() -> None:
    bar, drum, wall = load(SHAPES)
    assert (bar.shape, wall.shape) == (Capsule(length=2, radius=0.25), Segment(length=3))
    assert (bar.friction, bar.angular_drag, bar.sensor) == (0.5, 2, True)
    assert (bar.category, bar.mask, bar.group) == (2, 255, -3)
    assert drum.kinematic
    assert drum.angular_velocity == pytest.approx(math.pi / 6)
    assert drum.shape == Compound(
        parts=[
            Part(shape=Box(width=2, height=0.1), position=(0, 1)),
            Part(shape=Segment(length=2), position=(1, 0), orientation=math.pi / 2),
        ]
    )
    assert load(SHAPES).friction(0, 2) == 0.25


@pytest.mark.parametrize(
    ("good", "bad", "place", "words"), BAD_SHAPES, ids=[row[1][:40] for row in BAD_SHAPES]
)
def test_a_fault_of_a_shape_is_named_at_its_place(
    good: str, bad: str, place: str, words: str
) -> None:
    assert SHAPES.count(good) == 1
    with pytest.raises(SceneError) as caught:
        load(SHAPES.replace(good, bad))
    message = str(caught.value)
    assert message.startswith(f"scene:{place}: "), message
    assert words in message


@pytest.mark.parametrize("order", ["[[a]]", "[{a: b}]", "[~]", "[]"])
def test_an_order_names_bodies(order: str) -> None:
    """A list has the text of a name that looks like a list."""
    name = {"[[a]]": "['a']", "[{a: b}]": "{'a': 'b'}", "[~]": "None", "[]": "x"}[order]
    body = "{shape: none, mass: 1 kg, position: [0 m, 0 m]}"
    text = f'gravity: [0, 0]\nbodies:\n  "{name}": {body}\norder: {order}\n'
    with pytest.raises(SceneError, match=r"scene:4:8: order: .*must name each body once"):
        load(text)


@pytest.mark.parametrize("text", ['"1[N]*time/1[s] # why"', "'1[N]*(time/1[s])#'"])
def test_an_expression_has_no_comments(text: str) -> None:
    with pytest.raises(SceneError, match="has no comments"):
        load(GOOD.replace('["2[N]*sin(3[rad/s]*time)", 0 N]', f"[{text}, 0 N]"))


def test_a_block_of_lines_is_one_line_in_a_message() -> None:
    with pytest.raises(SceneError) as refusal:
        load(GOOD.replace("duration: 4 s", "duration: |\n  four\n  s"))
    assert "\n" not in str(refusal.value)
    assert load(GOOD.replace("duration: 4 s", "duration: |\n  4\n  s")).duration == 4


def test_a_folder_and_a_missing_file_are_told_apart(tmp_path: Path) -> None:
    with pytest.raises(SceneError) as folder:
        load(tmp_path)
    with pytest.raises(SceneError) as missing:
        load(tmp_path / "a.yaml")
    assert str(folder.value) == f"{tmp_path}: a directory (R2). Give the path of a scene in YAML."
    assert str(missing.value).startswith(f"{tmp_path}/a.yaml: no such file (R2).")


@pytest.mark.parametrize("source", [None, [], 3, b"x"])
def test_what_is_no_path_is_refused(source: object) -> None:
    with pytest.raises(SceneError, match="must be a path or YAML text"):
        load(source)  # type: ignore[arg-type]


def test_a_bare_zero_fits_any_unit() -> None:
    scene = load(GOOD.replace("[0 m, 5 m]", "[0, -0.0]").replace("offset: 0 m", "offset: 0"))
    assert scene.bodies[0].position == (0, 0)


def test_a_typo_in_a_text_is_placed_too() -> None:
    with pytest.raises(SceneError, match=r"^scene:10:11: mass"):
        load(GOOD.replace("10 kg", "-10 kg"))


def test_a_missing_restitution_is_told_where_the_file_has_the_body() -> None:
    scene = t2.load(
        "gravity: [0 m/s^2, -9.81 m/s^2]\n"
        "bodies:\n"
        "  ball: {shape: disc, radius: 1 m, mass: 1 kg, position: [0 m, 3 m]}\n"
        "statics:\n"
        "  floor: {shape: half-plane, normal: [0, 1], offset: 0 m}\n"
    )
    told = r"^scene:3:3: restitution of the pair 'ball' and 'floor': not stated"
    with pytest.raises(t2.SceneError, match=told):
        t2.simulate(scene, duration=2.0)
    with pytest.raises(t2.SceneError, match=told):
        t2.Simulator(scene)
    assert scene == t2.load(t2.scene_text(scene))  # wherever its bodies were written
