"""Every bad argument is one InputError that names the argument; nothing is added to the scene."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.errors import InputError
from tamias2d.scene import Box, Capsule, Compound, Disc, HalfPlane, Part, Polygon, Scene, Segment

NAN, INF = float("nan"), float("inf")
GOOD: dict[str, Any] = {
    "shape": Disc(radius=1.0),
    "mass": 1.0,
    "position": (0.0, 0.0),
    "name": "it",
}
BODY = [
    {"mass": None},
    {"mass": True},
    {"mass": np.True_},
    {"mass": "1 kg"},
    {"mass": 1j},
    {"mass": [1.0]},
    {"mass": np.array(1.0)},
    {"mass": 0},
    {"mass": -1},
    {"mass": NAN},
    {"mass": INF},
    {"mass": 10**400},
    {"mass": 5e-324},
    {"inertia": 0.0},
    {"inertia": -1.0},
    {"inertia": "1 kg*m^2"},
    {"inertia": -INF},
    {"position": None},
    {"position": 1.0},
    {"position": (1.0,)},
    {"position": (1.0, 2.0, 3.0)},
    {"position": (1.0, NAN)},
    {"position": (True, 0)},
    {"position": "xy"},
    {"position": {0: 1.0, 1: 2.0}},
    {"position": np.zeros((2, 2))},
    {"position": np.float64(3.0)},
    {"velocity": (INF, 0.0)},
    {"velocity": [[0.0], [1.0]]},
    {"orientation": NAN},
    {"orientation": (0.0, 1.0)},
    {"angular_velocity": "fast"},
    {"angular_velocity": None},
    {"force": 3.0},
    {"force": lambda _: (0, 0)},
    {"force": (lambda _: 0, 0)},
    {"torque": lambda _: 0},
    {"position": np.ma.array([1.0, 2.0], mask=[False, True])},
    {"force": "10[N]"},
    {"force": ("10 N", 0.0)},
    {"force": ("10[m]*time", 0.0)},
    {"force": ("", 0.0)},
    {"force": ("x" * 2000, 0.0)},
    {"force": ("10[N]*sqrt(time/1[s] - 1)", 0.0)},
    {"force": (0.0, "velocity*3[kg/s]")},
    {"force": (0.0, "time == 0[s]")},
    {"force": (0.0, None)},
    {"torque": "exec('1')"},
    {"torque": "(lambda: 1)()"},
    {"torque": "time.__class__"},
    {"torque": "2[N*m]*time"},
    {"torque": "integral(2[N*m/s], time)"},
    {"torque": NAN},
    {"force": ("1[N]*x(position)", 0.0)},
    {"force": ("1[N/m]*position", 0.0)},
    {"force": ("1[N/m^2]/x(position)", 0.0)},
    {"force": ("1[N*m]/x(position)", 0.0)},  # none where the body starts
    {"force": ("1[N]*position_a/1[m]", 0.0)},
    {"torque": "1[N*m]*orientation_start"},
    {"torque": "1[N*m]*norm(orientation)"},
    {"torque": "1[N*m]*exp(1000*(1 + angular_velocity/1[rad/s]))"},
    {"linear_drag": -0.1},
    {"linear_drag": "0.1 kg/s"},
    {"linear_drag": INF},
    {"linear_drag": None},
    {"quadratic_drag": -1e-300},
    {"quadratic_drag": NAN},
    {"quadratic_drag": True},
    {"restitution": 1.1},
    {"restitution": -0.1},
    {"restitution": "0.5"},
    {"restitution": False},
    {"friction": -0.1},
    {"friction": INF},
    {"friction": "0.5"},
    {"friction": True},
    {"angular_drag": -1e-9},
    {"angular_drag": None},
    {"name": 3},
    {"name": ""},
    {"name": "a\nb"},
    {"name": "x" * 101},
    {"name": "taken"},
    {"shape": "disc"},
    {"shape": Disc},
    {"shape": HalfPlane(normal=(0, 1), offset=0)},
    {"shape": None, "torque": 1.0},
    {"shape": None, "torque": "1[N*m/s]*time"},
    {"shape": None, "angular_velocity": 1.0},
    {"shape": Disc(radius=1e200), "mass": 1e200},
    {"shape": Disc(radius=1e-200)},
]


@pytest.mark.parametrize("bad", BODY, ids=lambda bad: " ".join(bad))
def test_a_body_with_a_bad_value_is_refused(bad: dict[str, Any]) -> None:
    scene = Scene(gravity=(0, 0))
    scene.add_body(Disc(radius=1.0), mass=1.0, position=(9.0, 0.0), name="taken")
    with pytest.raises(InputError) as caught:
        scene.add_body(**{**GOOD, **bad})
    message = str(caught.value)
    assert any(key.replace("_", " ") in message for key in (*bad, "inertia"))
    assert "\n" not in message
    assert len(scene) == 1
    assert scene.add_body(**GOOD) == 1  # the name is still free


def corners(count: int) -> np.ndarray:
    """Return the corners of a regular polygon."""
    angle = 2 * np.pi * np.arange(count) / count
    return np.column_stack((np.cos(angle), np.sin(angle)))


SHAPES: list[Callable[[], object]] = [
    lambda: Disc(radius=0),
    lambda: Disc(radius=-1),
    lambda: Disc(radius=None),  # type: ignore[arg-type]
    lambda: Disc(radius=True),
    lambda: Disc(radius=NAN),
    lambda: Box(width=0, height=1),
    lambda: Box(width=1, height=INF),
    lambda: Polygon(vertices=3),
    lambda: Polygon(vertices="abc"),
    lambda: Polygon(vertices=[]),
    lambda: Polygon(vertices=[(0, 0), (1, 0)]),
    lambda: Polygon(vertices=[(0, 0), (1, 0), (0, NAN)]),
    lambda: Polygon(vertices=[(0, 0), (1, 0), None]),
    lambda: Polygon(vertices=np.zeros(6)),
    lambda: Polygon(vertices=np.zeros((3, 3))),
    lambda: Polygon(vertices=np.zeros((3, 2))),
    lambda: Polygon(vertices=[(0, 0), (1e-200, 0), (0, 1e-200)]),
    lambda: Polygon(vertices=[(0, 0), (1e200, 0), (0, 1e200)]),
    lambda: Polygon(vertices=[(0, 0), (1e308, 0), (-1e308, 1e308)]),
    lambda: Polygon(vertices=[(0, 0), (3, 0), (3, 3), (2, 1)]),
    lambda: HalfPlane(normal=(0, 0), offset=0),
    lambda: HalfPlane(normal=(1e308, 1.7e308), offset=0),
    lambda: HalfPlane(normal=(0, 1), offset=NAN),
    lambda: HalfPlane(normal=1, offset=0),  # type: ignore[arg-type]
    lambda: Capsule(length=0, radius=1),
    lambda: Capsule(length=1, radius=0),
    lambda: Capsule(length=NAN, radius=1),
    lambda: Segment(length=-1),
    lambda: Segment(length="1 m"),  # type: ignore[arg-type]
    lambda: Part(shape=HalfPlane(normal=(0, 1), offset=0)),  # type: ignore[arg-type]
    lambda: Part(shape=Compound(parts=[Part(shape=Disc(radius=1))])),  # type: ignore[arg-type]
    lambda: Part(shape=None),  # type: ignore[arg-type]
    lambda: Part(shape=Disc(radius=1), position=(0, NAN)),
    lambda: Part(shape=Disc(radius=1), orientation=INF),
    lambda: Compound(parts=[]),
    lambda: Compound(parts=3),
    lambda: Compound(parts=[Disc(radius=1)]),
    lambda: Compound(parts=[Part(shape=Disc(radius=1)), None]),
    lambda: Compound(parts=[Part(shape=Disc(radius=1e300))]),
    lambda: Compound(parts=[Part(shape=Disc(radius=1), position=(x, 0)) for x in (9e307, -1e308)]),
    lambda: Segment(length=5e-324),
    lambda: Box(width=5e-324, height=1),
    lambda: Box(width=1, height=5e-324),
    lambda: Capsule(length=5e-324, radius=1),
    lambda: Compound(
        parts=[
            Part(shape=Disc(radius=1)),
            Part(shape=Segment(length=1e-9), position=(1e8, 0)),
        ]
    ),
    lambda: Compound(parts=[Part(shape=Box(width=1, height=1e-20), orientation=0.3)]),
    lambda: Polygon(vertices=np.ma.array(np.eye(3)[:, :2], mask=np.eye(3)[:, :2])),
    lambda: Polygon(vertices=corners(1001)),
]


@pytest.mark.parametrize("make", SHAPES, ids=[str(k) for k in range(len(SHAPES))])
def test_a_bad_shape_is_refused(make: Callable[[], object]) -> None:
    with pytest.raises(InputError):
        make()


def test_a_thousand_corners_are_not_too_many() -> None:
    assert len(Polygon(vertices=corners(1000)).vertices) == 1000


@pytest.mark.parametrize("size", [1e-323, 1e-310, 1e-160])
def test_a_thin_side_that_float64_can_hold_is_taken(size: float) -> None:
    assert Box(width=1, height=size).vertices[1][1] < 0 < Box(width=1, height=size).vertices[2][1]
    part = Part(shape=Box(width=1, height=1e-9), position=(1e3, 0), orientation=0.3)
    assert len(Compound(parts=[part, Part(shape=Disc(radius=1))]).pieces) == 2


SCENES: list[Callable[[Scene], object]] = [
    lambda _: Scene(gravity=9.81),
    lambda _: Scene(gravity=(0, NAN)),
    lambda _: Scene(gravity=(0, 0), duration=0),
    lambda _: Scene(gravity=(0, 0), duration="4 s"),  # type: ignore[arg-type]
    lambda _: Scene(gravity=(0, 0), name=None),  # type: ignore[arg-type]
    lambda _: Scene(gravity=(0, 0), says=3),  # type: ignore[arg-type]
    lambda scene: scene.set_restitution(0, 0, 0.5),
    lambda scene: scene.set_restitution(0, 7, 0.5),
    lambda scene: scene.set_restitution(0, -1, 0.5),
    lambda scene: scene.set_restitution(0, True, 0.5),
    lambda scene: scene.set_restitution(0, 1.0, 0.5),  # type: ignore[arg-type]
    lambda scene: scene.set_restitution("disc", "flor", 0.5),
    lambda scene: scene.set_restitution(0, 1, 2),
    lambda scene: scene.restitution(0, 1),
    lambda scene: scene.add_static(None),  # type: ignore[arg-type]
    lambda scene: scene.add_static(HalfPlane(normal=(0, 1), offset=0), position=(0, 1)),
    lambda scene: scene.add_static(HalfPlane(normal=(0, 1), offset=0), orientation=1),
    lambda scene: scene.add_static(Disc(radius=1), restitution=3),
    lambda scene: scene.set_friction(0, 0, 0.5),
    lambda scene: scene.set_friction(0, "flor", 0.5),
    lambda scene: scene.set_friction(0, 1, -0.5),
    lambda scene: scene.add_kinematic(None, position=(0, 0)),  # type: ignore[arg-type]
    lambda scene: scene.add_kinematic(HalfPlane(normal=(0, 1), offset=0), position=(0, 0)),
    lambda scene: scene.add_kinematic(Disc(radius=1), position=(0, 0), velocity=3),  # type: ignore[arg-type]
    lambda scene: scene.add_kinematic(Disc(radius=1), position=(0, 0), angular_velocity=NAN),
    lambda scene: scene.add_kinematic(Disc(radius=1), position=(0, 0), friction=-1),
    lambda scene: scene.add_kinematic(Disc(radius=1), position=(0, 0), name="floor"),
]


@pytest.mark.parametrize("act", SCENES, ids=[str(k) for k in range(len(SCENES))])
def test_a_bad_scene_is_refused(act: Callable[[Scene], object]) -> None:
    scene = Scene(gravity=(0, 0))
    scene.add_body(Disc(radius=1.0), mass=1.0, position=(0, 0), name="disc")
    scene.add_static(Box(width=1, height=1), position=(5, 0), name="floor")
    with pytest.raises(ValueError, match=r"R\d|symbol"):
        act(scene)
    assert len(scene) == 2


SPRING: dict[str, Any] = {"first": "disc", "second": (3, 0), "stiffness": 1.0, "rest_length": 1.0}
SPRINGS = [
    {"first": "dics"},
    {"first": "floor"},  # from a static body to a point
    {"second": "disc"},
    {"second": 0},
    {"second": 7},
    {"second": True},
    {"second": 1.0},
    {"second": None},
    {"second": (1.0,)},
    {"second": (NAN, 0.0)},
    {"second": (0.0, 0.0)},  # where the disc is
    {"second": "floor", "other_anchor": (-5.0, 0.0)},  # likewise
    {"stiffness": 0.0},
    {"stiffness": -1.0},
    {"stiffness": "1 N/m"},
    {"rest_length": -1e-9},
    {"rest_length": None},
    {"damping": -1.0},
    {"damping": NAN},
    {"anchor": 3.0},
    {"anchor": (0.0, INF)},
    {"other_anchor": (1.0, 0.0)},  # of a point
    {"first": "particle", "anchor": (0.0, 1.0)},
    {"second": "particle", "other_anchor": (0.0, 1.0)},
]


@pytest.mark.parametrize("bad", SPRINGS, ids=lambda bad: " ".join(bad))
def test_a_bad_spring_is_refused(bad: dict[str, Any]) -> None:
    scene = small_scene()
    values = {**SPRING, **bad}
    with pytest.raises(InputError) as caught:
        scene.add_spring(values.pop("first"), values.pop("second"), **values)
    assert "\n" not in str(caught.value)
    assert not scene.springs


FIELDS = [
    {},
    {"force": 3.0},
    {"force": "1[N]"},
    {"force": (1.0,)},
    {"force": ("1[m]", 0.0)},
    {"force": (0.0, "1[N*m]/norm(position)")},  # none where the disc is
    {"force": (NAN, 0.0)},
    {"torque": "1[N]"},
    {"torque": "1[N*m]*log(orientation)"},
    {"torque": (0.0, 0.0)},
    {"force": ("0*position + 5[N]", 0.0)},  # a zero of a vector is a vector
    {"force": ("5[N] - 0*velocity", 0.0)},
    {"force": ("max(1[N], 0*position)", 0.0)},
    {"force": ("0*vector(1, 2) + 1[N]", 0.0)},
    {"torque": "1[N*m]*phi1(orientation - 1)"},
    {"torque": 1.0, "bodies": []},
    {"torque": 1.0, "bodies": "disc"},
    {"torque": 1.0, "bodies": ["disk"]},
    {"torque": 1.0, "bodies": ["disc", "floor"]},
    {"torque": 1.0, "bodies": 3},
]


@pytest.mark.parametrize("bad", FIELDS, ids=lambda bad: " ".join(bad))
def test_a_bad_field_is_refused(bad: dict[str, Any]) -> None:
    scene = small_scene()
    with pytest.raises(InputError) as caught:
        scene.add_field(**bad)
    assert "\n" not in str(caught.value)
    assert not scene.fields


@pytest.mark.parametrize("bad", [None, "6.7e-11", INF, True])
def test_a_bad_constant_of_gravitation_is_refused(bad: Any) -> None:
    scene = small_scene()
    with pytest.raises(InputError, match="gravitational constant"):
        scene.add_attraction(gravitational_constant=bad)
    assert scene.attraction is None


def test_attraction_is_stated_once() -> None:
    scene = small_scene()
    scene.add_attraction(gravitational_constant=1.0)
    with pytest.raises(InputError, match="twice"):
        scene.add_attraction(gravitational_constant=2.0)
    assert scene.attraction == 1.0


def small_scene() -> Scene:
    scene = Scene(gravity=(0, 0))
    scene.add_body(Disc(radius=1.0), mass=1.0, position=(0, 0), name="disc")
    scene.add_static(Box(width=1, height=1), position=(5, 0), name="floor")
    scene.add_body(None, mass=1.0, position=(0, 5), name="particle")
    return scene


def test_a_law_of_the_state_is_asked_with_the_state() -> None:
    scene = Scene(gravity=(0, 0))
    force = ("-2[N/m]*x(position)", "3[kg/s]*y(velocity)")
    scene.add_body(None, mass=1, position=(1, 0), force=force)
    body = scene.bodies[0]
    assert body.force_at(0.5, position=(4.0, 0.0), velocity=(0.0, 5.0)) == (-8.0, 15.0)
    assert not body.constant
    with pytest.raises(InputError, match=r"force\[0\] of body 'body0'.*'position'.* not given"):
        body.force_at(0.5)


@pytest.mark.parametrize("key", ["torque", "angular_velocity"])
def test_a_particle_needs_an_inertia_to_turn(key: str) -> None:
    scene = Scene(gravity=(0, 0))
    with pytest.raises(InputError, match=f"inertia of body 'p': found none, though its {key} is"):
        scene.add_body(None, mass=1, position=(0, 0), name="p", **{key: 2.0})
    scene.add_body(None, mass=1, position=(0, 0), name="p", inertia=3.0, **{key: 2.0})
    assert scene.bodies[0].inverse_inertia == 1 / 3


def test_a_star_is_refused_where_it_has_turned_once_around() -> None:
    """A pentagram turns the same way at every corner, but twice around."""
    turns = [4 * math.pi * k / 5 for k in range(5)]
    with pytest.raises(InputError, match=r"vertices\[2\].*crosses itself"):
        Polygon(vertices=[(math.cos(turn), math.sin(turn)) for turn in turns])
    with pytest.raises(InputError, match=r"vertices\[2\].*crosses itself"):
        Polygon(vertices=[(math.cos(turn), -math.sin(turn)) for turn in turns])


def test_a_text_without_time_is_a_number() -> None:
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, position=(0, 0), force=("2[N]*sqrt(9)", "-0[N]"))
    assert repr(scene.bodies[0].force) == "(6.0, 0.0)"
    assert scene.bodies[0].constant


def test_a_fault_in_a_law_has_its_column() -> None:
    scene = Scene(gravity=(0, 0))
    with pytest.raises(InputError, match=r"column 8\)"):
        scene.add_body(None, mass=1, position=(0, 0), force=("2[N] + [3]", 0))


def test_a_law_without_a_value_is_refused_at_its_time() -> None:
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, position=(0, 0), force=("1[N*s]/(1[s] - time)", 0))
    body = scene.bodies[0]
    assert body.force_at(0.5) == (2.0, 0.0)
    with pytest.raises(InputError, match=r"no finite value at time 1\.0 s"):
        body.force_at(1.0)


@pytest.mark.parametrize("constant", [0, -6.6743e-11])
def test_attraction_has_a_positive_constant(constant: float) -> None:
    with pytest.raises(InputError, match="must be > 0"):
        Scene(gravity=(0, 0)).add_attraction(gravitational_constant=constant)


def test_a_function_is_refused_with_how_to_write_a_law() -> None:
    scene = Scene(gravity=(0, 0))
    with pytest.raises(InputError) as body:
        scene.add_body(None, mass=1, position=(0, 0), force=lambda t: (t, 0))  # type: ignore[arg-type]
    with pytest.raises(InputError, match="found a function"):
        scene.add_field(torque=math.sin)  # type: ignore[arg-type]
    said = str(body.value)
    assert "Write it as text like ('10[N]*sin(2[rad/s]*time)', 0)" in said
    law = ("10[N]*sin(2[rad/s]*time)", 0)  # what it says works
    scene.add_body(None, mass=1, position=(0, 0), force=law)


@pytest.mark.parametrize("value", [[], None, "tc1", Scene])
@pytest.mark.parametrize("ask", ["simulate", "recommend", "needs", "scene_text", "Simulator"])
def test_what_is_no_scene_is_refused(ask: str, value: object) -> None:
    more = {"simulate": {"duration": 1}, "recommend": {"duration": 1, "tolerance": 1e-3}}
    with pytest.raises(InputError, match=r"scene: found .*: must be a Scene \(R1\)"):
        getattr(t2, ask)(value, **more.get(ask, {}))


def test_what_is_no_run_is_refused() -> None:
    with pytest.raises(InputError, match=r"run: found \[\]: must be a Run"):
        t2.certify([])  # type: ignore[arg-type]


def test_an_array_is_no_index() -> None:
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, position=(0, 0))
    for bad in (np.array([0]), np.array([0.0]), 0.0):
        with pytest.raises(InputError, match="the scene has none such"):
            scene.index(bad)  # type: ignore[arg-type]
    assert scene.index(np.int64(0)) == 0  # type: ignore[arg-type]
