"""Every scene of the catalogue loads, and is set up as its oracle wants it."""

import math
from itertools import pairwise

import pytest

from tamias2d.errors import SceneError
from tamias2d.scene import Polygon, Scene, catalogue, load, needs, scene_text

EXPECTED = [
    *(f"tc{k}" for k in (*range(1, 12), 14)),
    *("tc10-meeting", "tc11-flat", "tc11-corner", "projectiles", "bouncing-disc"),
    *("bouncing-elastic", "oblique-discs", "oblique-discs-unequal", "spinning-square"),
    *("cradle", "cradle-touching", "billiard", "driven", "resting", "showcase"),
    *(f"galperin-{100**k}" for k in range(4)),
    *("drag-fall", "quadratic-drag", "oscillator", "damped-oscillator", "pendulum", "kepler"),
    *("two-body", "figure-eight", "solar", "spring-chain", "own-law"),
]


def test_the_catalogue_is_complete() -> None:
    assert catalogue.names() == sorted(EXPECTED)


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
