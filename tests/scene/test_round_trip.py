"""A scene's text is the scene: it loads back bit for bit."""

import math
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, reject, settings, strategies as st

from tamias2d.errors import InputError
from tamias2d.scene import (
    Body,
    Box,
    Capsule,
    Compound,
    Disc,
    HalfPlane,
    Part,
    Polygon,
    Scene,
    Segment,
    load,
    pieces_of,
    scene_text,
)
from tamias2d.scene.filters import ALL

numbers = st.floats(allow_nan=False, allow_infinity=False)
sizes = st.floats(1e-6, 1e6)
pairs = st.tuples(numbers, numbers)
fractions = st.none() | st.floats(0, 1)
laws = numbers | st.sampled_from(
    ["10[N]*sin(2[rad/s]*time)", " 1[N/s] *\n time ", "3[N]", "1[m/s^2]*mass", "orientation*1[N]"]
)
torques = numbers | st.sampled_from(["-2[N*m]*sin(orientation)", "1[N*m]*min(orientation, 1)"])
words = st.none() | st.text(
    st.characters(codec="utf-8", exclude_categories=("C", "Z")), min_size=1, max_size=20
)


@st.composite
def polygons(draw: st.DrawFn) -> Polygon:
    """Corners on an ellipse are convex."""
    angles = np.sort(draw(st.lists(st.integers(0, 71), min_size=3, max_size=9, unique=True)))
    turns, (x, y) = np.radians(5 * angles), draw(st.tuples(st.floats(1, 9), st.floats(1, 9)))
    ring = np.column_stack([x * np.cos(turns), y * np.sin(turns)])
    ordered = ring[:: draw(st.sampled_from([1, -1]))]
    return Polygon(vertices=(ordered + draw(st.floats(-1e3, 1e3))) * draw(sizes))


singles = st.one_of(
    sizes.map(lambda radius: Disc(radius=radius)),
    st.tuples(sizes, sizes).map(lambda size: Box(width=size[0], height=size[1])),
    st.tuples(sizes, sizes).map(lambda size: Capsule(length=size[0], radius=size[1])),
    sizes.map(lambda length: Segment(length=length)),
    polygons(),
)
places_near = st.tuples(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6))
parts = st.builds(
    Part,
    shape=singles,
    position=places_near,
    orientation=numbers,
    restitution=fractions,
    friction=st.none() | st.floats(0, 3),
)


@st.composite
def compounds(draw: st.DrawFn) -> Compound:
    """Parts whose sides are not lost in rounding, that far from each other."""
    many = draw(st.lists(parts, min_size=1, max_size=4))
    try:
        return Compound(parts=many)
    except InputError:
        reject()


shapes = singles | compounds()
surface = {
    "restitution": fractions,
    "friction": st.none() | st.floats(0, 3),
    "category": st.integers(0, ALL),
    "mask": st.none() | st.integers(0, ALL),
    "group": st.integers(-(2**63), ALL),
    "sensor": st.booleans(),
}


def unit(x: float, y: float) -> tuple[float, float]:
    """Return the unit vector along another one, to rounding."""
    size = math.hypot(x, y)
    return x / size, y / size


half_planes = st.tuples(st.floats(0.1, 9), numbers, numbers).map(
    lambda v: HalfPlane(normal=unit(v[0], max(-9, min(9, v[1]))), offset=v[2])
)
moving = st.fixed_dictionaries(
    {"shape": st.none() | shapes, "mass": sizes, "position": pairs, "inertia": sizes},
    optional={
        "velocity": pairs,
        "orientation": numbers,
        "angular_velocity": numbers,
        "force": st.tuples(laws, laws),
        "torque": torques,
        "linear_drag": sizes,
        "quadratic_drag": sizes | st.just(0),
        "angular_drag": sizes | st.just(0),
        **surface,
    },
)
springs = st.fixed_dictionaries(
    {"stiffness": sizes, "rest_length": st.just(0) | sizes},
    optional={"damping": sizes, "anchor": pairs, "other_anchor": pairs},
)
fields = st.fixed_dictionaries({"force": st.tuples(laws, laws)}, optional={"torque": torques})
static = st.one_of(
    st.fixed_dictionaries(
        {"shape": shapes, "position": pairs},
        optional={"orientation": numbers, **surface},
    ),
    st.fixed_dictionaries({"shape": half_planes}, optional=surface),
)
kinematic = st.fixed_dictionaries(
    {"shape": shapes, "position": pairs},
    optional={"velocity": pairs, "orientation": numbers, "angular_velocity": numbers, **surface},
)


def build(bodies: list[tuple[str, dict[str, Any]]], names: list[str | None], **top: Any) -> Scene:
    scene = Scene(**top)
    used: set[str | None] = {f"body{k}" for k in range(20)}
    for (kind, values), name in zip(bodies, names, strict=True):
        free = None if name in used else name
        used.add(free)
        getattr(scene, f"add_{kind}")(name=free, **values)
    return scene


@st.composite
def scenes(draw: st.DrawFn) -> Scene:
    kinds = {"body": moving, "static": static, "kinematic": kinematic}
    any_kind = st.one_of(st.tuples(st.just(kind), values) for kind, values in kinds.items())
    bodies = draw(st.lists(any_kind, max_size=5))
    scene = build(
        bodies,
        draw(st.lists(words, min_size=len(bodies), max_size=len(bodies))),
        gravity=draw(pairs),
        name=draw(words) or "",
        says=draw(words) or "",
        duration=draw(st.none() | sizes),
    )
    if len(bodies) > 1:
        for i in draw(st.sets(st.integers(1, len(bodies) - 1))):
            scene.set_restitution(i, 0, draw(st.floats(0, 1)))
        for i in draw(st.sets(st.integers(1, len(bodies) - 1))):
            scene.set_friction(i, 0, draw(st.floats(0, 3)))
    add_acting(scene, draw)
    return scene


def add_acting(scene: Scene, draw: st.DrawFn) -> None:
    """Add springs, attraction and fields; what the rules refuse is left out."""
    places = st.integers(0, max(len(scene) - 1, 0))
    for _ in range(draw(st.integers(0, 3))):
        with suppress(InputError):
            scene.add_spring(draw(places), draw(places | pairs), **draw(springs))
    if draw(st.booleans()):
        scene.add_attraction(gravitational_constant=draw(sizes))
    for _ in range(draw(st.integers(0, 2))):
        with suppress(InputError):
            scene.add_field(**draw(fields), bodies=draw(st.none() | st.lists(places)))


@given(scenes())
@settings(max_examples=200, deadline=None)
def test_text_loads_back_bit_for_bit(scene: Scene) -> None:
    text = scene_text(scene)
    again = load(text)
    assert again == scene
    assert scene_text(again) == text
    assert again.digest() == scene.digest()
    assert again.bodies == scene.bodies
    assert (again.springs, again.attraction, again.fields) == (
        *(scene.springs, scene.attraction, scene.fields),
    )
    assert [corners(body) for body in again.bodies] == [corners(body) for body in scene.bodies]
    assert again.friction_of_pairs == scene.friction_of_pairs


@pytest.mark.parametrize("name", ["", "drop"])
def test_a_file_holds_the_scene_whatever_it_is_called(name: str, tmp_path: Path) -> None:
    scene = Scene(gravity=(0.0, -9.81), name=name)
    scene.add_body(None, mass=1.0, position=(0.0, 1.0), name="stone")
    for file in ("one.yaml", "other.yml"):
        (tmp_path / file).write_text(scene_text(scene), encoding="utf-8")
        again = load(tmp_path / file)
        assert again == scene
        assert again.digest() == scene.digest()


def corners(body: Body) -> object:
    """The corners of all that a body is made of, to the last bit."""
    if body.shape is None or isinstance(body.shape, HalfPlane):
        return None
    return [piece.core for piece in pieces_of(body.shape)]


@given(scenes(), st.integers(0, 4), st.floats(1e-3, 1e3))
@settings(deadline=None)
def test_another_body_is_another_scene(scene: Scene, k: int, mass: float) -> None:
    other = load(scene_text(scene))
    other.add_body(Disc(radius=1), mass=mass, position=(0, k))
    assert other != scene
    assert other.digest() != scene.digest()


def test_a_change_in_the_last_digit_is_another_scene() -> None:
    def one(x: float) -> Scene:
        scene = Scene(gravity=(0, 0))
        scene.add_body(None, mass=1, position=(x, 0))
        return scene

    assert one(0.1 + 0.2) != one(0.3)
    assert one(0.1 + 0.2).digest() != one(0.3).digest()
    assert one(-0.0) == one(0.0)
    assert one(-0.0).digest() == one(0.0).digest()


def test_what_acts_makes_another_scene() -> None:
    def one() -> Scene:
        scene = Scene(gravity=(0, 0))
        scene.add_body(Disc(radius=1), mass=1, position=(2, 0))
        scene.add_body(Disc(radius=1), mass=1, position=(5, 0))
        return scene

    scenes = [one() for _ in range(7)]
    scenes[1].add_spring(0, 1, stiffness=1, rest_length=0)
    scenes[2].add_spring(0, 1, stiffness=1, rest_length=0, anchor=(0.5, 0))
    scenes[3].add_spring(0, (0, 0), stiffness=1, rest_length=0)
    scenes[4].add_attraction(gravitational_constant=1)
    scenes[5].add_field(force=(1, 0))
    scenes[6].add_field(force=(1, 0), bodies=[0])
    assert len({scene.digest() for scene in scenes}) == len(scenes)
    for k, scene in enumerate(scenes):
        assert [other == scene for other in scenes] == [j == k for j in range(len(scenes))]


def test_a_nearly_level_floor_has_no_negative_zero() -> None:
    """Its slope underflows; -0.0 and 0.0 are equal, so their texts must be."""
    floor = HalfPlane(normal=(-5e-324, 9), offset=-0.0)
    assert repr(floor) == "HalfPlane(normal=(0.0, 1.0), offset=0.0)"
