"""Every scene of the catalogue loads, and is set up as its oracle wants it."""

import cProfile
import math
from itertools import pairwise

import numpy as np
import pytest

from tamias2d.contact import steps_because
from tamias2d.contact.core import cores_of
from tamias2d.contact.overlap import _overlaps
from tamias2d.errors import SceneError
from tamias2d.scene import Disc, Polygon, Scene, catalogue, in_pieces, load, needs, scene_text
from tamias2d.state import State

EXPECTED = [
    *(f"tc{k}" for k in (*range(1, 12), 14)),
    *("tc10-meeting", "tc11-flat", "tc11-corner", "projectiles", "bouncing-disc"),
    *("bouncing-elastic", "oblique-discs", "oblique-discs-unequal", "spinning-square"),
    *("cradle", "cradle-touching", "billiard", "driven", "resting", "showcase"),
    *(f"galperin-{100**k}" for k in range(4)),
    *("drag-fall", "quadratic-drag", "oscillator", "damped-oscillator", "pendulum", "kepler"),
    *("two-body", "figure-eight", "solar", "spring-chain", "own-law"),
    *("pendulum-a01", "four-bars", "slider-crank", "andrews", "gear-train"),
    *("windmill", "walker", "bridge", "ball-and-chain"),
]
JOINTED = ["car", "ragdolls", "joint-grid"]
STEPPED = {
    "pyramid-30": 465,
    "pyramid-100": 5050,
    "stack-10-heavy": 10,
    "dominoes": 15,
    "card-house": 40,
    "arch": 21,
    "bullet-wall": 13,
    "incline": 5,
    "disc-pile": 1000,
    "tumbler": 1000,
    "free-discs": 1000,
    "hill": 15,
}
"""How many bodies move."""


def test_the_catalogue_is_complete() -> None:
    assert catalogue.names("located") == sorted(EXPECTED)
    assert catalogue.names("stepped") == sorted(STEPPED)
    assert catalogue.names("jointed") == sorted(JOINTED)
    assert catalogue.names() == sorted([*EXPECTED, *STEPPED, *JOINTED])


@pytest.mark.parametrize("name", [*JOINTED, "windmill", "walker", "bridge", "ball-and-chain"])
def test_a_scene_of_joints_says_what_it_needs(name: str) -> None:
    scene = catalogue.load(name)
    assert scene.says
    assert scene.duration
    assert "joints (TM7, GD17)" in needs(scene)
    if len(scene) < 100:  # YAML is read slowly
        assert scene_text(load(scene_text(scene))) == scene_text(scene)


@pytest.mark.parametrize("name", [*JOINTED, "windmill", "walker", "ball-and-chain", "andrews"])
def test_joints_are_stepped_where_they_cannot_be_solved_exactly(name: str) -> None:
    scene = catalogue.load(name)
    reason = steps_because(scene, scene.duration or 0.0)
    assert ("joint" in (reason or "")) == (name in JOINTED)


@pytest.mark.parametrize("name", [name for name in STEPPED if name != "pyramid-100"])
def test_a_scene_to_be_stepped_loads_back_and_has_all_it_needs(name: str) -> None:
    scene = catalogue.load(name)
    assert scene.name == name
    assert scene.says
    assert scene.duration
    assert sum(body.dynamic for body in scene.bodies) == STEPPED[name]
    again = load(catalogue.text(name)) if len(scene) < 100 else scene  # YAML is read slowly
    assert again.digest() == scene.digest()
    for i, j in needs(scene, 1.0).pairs:
        assert scene.restitution(i, j) == 0
        assert scene.friction(i, j) >= 0


@pytest.mark.parametrize("name", [name for name in STEPPED if STEPPED[name] < 500])
def test_nothing_overlaps_at_the_start(name: str) -> None:
    """All that rounding of the places to nanometres may do."""
    for a, b, depth in overlaps(catalogue.load(name)):
        assert depth < 2e-9, (a, b)


def overlaps(scene: Scene) -> list[tuple[str, str, float]]:
    states = [
        State(body.position, body.orientation, body.velocity, body.angular_velocity)
        for body in in_pieces(scene).bodies
    ]
    return [
        (a.name, b.name, depth) for a, b, depth in _overlaps(cores_of(in_pieces(scene)), states)
    ]


@pytest.mark.parametrize("name", ["disc-pile", "free-discs"])
def test_no_discs_overlap_at_the_start(name: str) -> None:
    discs = [body for body in catalogue.load(name).bodies if body.dynamic]
    x, y = np.array([disc.position for disc in discs]).T
    radius = np.array([disc.shape.bounding_radius for disc in discs])  # type: ignore[union-attr]
    apart = np.hypot(x[:, None] - x, y[:, None] - y) - radius[:, None] - radius
    assert apart[~np.eye(len(discs), dtype=bool)].min() > 0


def test_the_stones_of_the_tumbler_lie_apart_in_their_drum() -> None:
    drum, *stones = catalogue.load("tumbler").bodies
    assert drum.kinematic
    assert [len(stone.shape.vertices) for stone in stones[:6]] == [3, 4, 5, 6, 7, 8]  # type: ignore[union-attr]
    places = np.array([stone.position for stone in stones])
    assert np.abs(places).max() + 0.3 < 10
    assert len(np.unique(places, axis=0)) == 1000


def test_a_pyramid_of_5050_boxes_is_built_from_the_floor_up() -> None:
    """Row by row a box less, each row half a box higher and in the middle of the one below."""
    _, *boxes = catalogue.load("pyramid-100").bodies
    places = np.array([box.position for box in boxes])
    for row in range(100):
        x = places[places[:, 1] == row + 0.5, 0]
        assert len(x) == 100 - row
        assert x.sum() == pytest.approx(0, abs=1e-6)


def test_the_work_of_adding_a_body_does_not_grow_with_their_number() -> None:
    """Counted in calls, not timed: the last hundred of thousands take as many as the first."""
    scene = Scene(gravity=(0, 0))

    def calls() -> int:
        profile = cProfile.Profile()
        profile.enable()
        for k in range(100):
            scene.add_body(Disc(radius=0.1), mass=1.0, position=(k, 0))
        profile.disable()
        return sum(entry.callcount for entry in profile.getstats())

    first = calls()
    for _ in range(30):
        last = calls()
    assert last < 1.01 * first  # a few are not the scene's


@pytest.mark.parametrize("name", EXPECTED)
def test_a_scene_loads_says_what_it_shows_and_has_all_it_needs(name: str) -> None:
    scene = catalogue.load(name)
    assert scene.name == name
    assert scene.says
    assert scene.duration
    assert load(scene_text(scene)) == scene
    for i, j in needs(scene).pairs:
        scene.restitution(i, j)


def test_an_unknown_scene_is_refused_with_a_hint() -> None:
    with pytest.raises(SceneError, match="Did you mean 'bouncing-disc'"):
        catalogue.load("bouncing-disk")
    with pytest.raises(SceneError, match="not in the catalogue"):
        catalogue.load("../catalogue/tc1")


def at(scene: Scene, name: str, time: float) -> tuple[float, float]:
    """Where a body would be if nothing were hit: x0 + v t + a t^2/2, worked out anew here."""
    body = scene.bodies[scene.index(name)]
    force = body.force_at(0.0)
    x, y = (
        body.position[k]
        + body.velocity[k] * time
        + (scene.gravity[k] + force[k] / body.mass) * time**2 / 2
        for k in (0, 1)
    )
    return x, y


@pytest.mark.parametrize("mass", [1, 100, 10_000, 1_000_000])
def test_galperins_balls_stand_as_points_at_1_and_2(mass: int) -> None:
    """The gap to the wall is 1, and what both balls leave of the way is 2 (oracle B8)."""
    small, large, wall = catalogue.load(f"galperin-{mass}").bodies
    assert small.position[0] - small.shape.radius == 1  # type: ignore[union-attr]
    gap = large.position[0] - small.position[0]
    assert gap - small.shape.radius - large.shape.radius == 1  # type: ignore[union-attr]
    assert (small.mass, large.mass, large.velocity) == (1, mass, (-1, 0))
    assert wall.shape.normal == (1, 0)  # type: ignore[union-attr]


def test_the_spinning_square_lands_as_its_oracle_says() -> None:
    """At 0.25 s: 30 degrees, (0.5, -3) m/s, 4 rad/s, a corner on the floor (oracle B4)."""
    scene = catalogue.load("spinning-square")
    square = scene.bodies[0]
    assert square.velocity[1] - 9.81 * 0.25 == -3
    assert square.orientation + square.angular_velocity * 0.25 == pytest.approx(math.pi / 6)
    x, y = at(scene, "square", 0.25)
    assert x == pytest.approx(0, abs=1e-16)
    assert y == pytest.approx((math.sqrt(3) + 1) / 4, abs=1e-15)


def test_the_discs_of_the_showcase_fall_for_one_second() -> None:
    scene = catalogue.load("showcase")
    discs = [body for body in scene.bodies if body.name.startswith("bounce")]
    assert [body.restitution for body in discs] == [1, 0.9, 0.8, 0.7, 0.6, 0.5]
    for body in discs:
        assert at(scene, body.name, 1.0)[1] == pytest.approx(0.5, abs=1e-15)


def test_the_upper_bodies_of_the_showcase_are_carried() -> None:
    scene = catalogue.load("showcase")
    for name in ("striker", "second", "third", "fourth", "last", "twisted", "turning"):
        body = scene.bodies[scene.index(name)]
        assert body.force_at(0.0)[1] / body.mass + scene.gravity[1] == 0
    twisted = scene.bodies[scene.index("twisted")]
    assert twisted.torque_at(0.0) / twisted.inertia == 1
    turning = scene.bodies[scene.index("turning")].shape
    assert isinstance(turning, Polygon)
    assert len(turning.vertices) == 6


@pytest.mark.parametrize(("name", "gap"), [("cradle", 0.1), ("cradle-touching", 0.0)])
def test_the_gaps_of_the_cradle(name: str, gap: float) -> None:
    x = [body.position[0] for body in catalogue.load(name).bodies[1:]]
    assert [b - a - 1 for a, b in pairwise(x)] == pytest.approx([gap] * 3)


def test_nothing_overlaps_in_the_break_shot() -> None:
    balls = [body for body in catalogue.load("billiard").bodies if body.dynamic]
    assert len(balls) == 16
    for k, one in enumerate(balls):
        assert all(0.05 < p < size - 0.05 for p, size in zip(one.position, (2.8, 1.4), strict=True))
        for other in balls[:k]:
            assert math.dist(one.position, other.position) > 0.1
