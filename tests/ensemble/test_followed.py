"""Worlds that compiled code follows have the bits that they have alone."""

import math
from typing import Any

import numpy as np
import pytest
from scipy import stats

import tamias2d as t2
from tamias2d.ensemble import followed as following
from tamias2d.ensemble.followed import Followed, followed
from tamias2d.ensemble.request import request_of
from tamias2d.ensemble.worlds import worlds_of
from tamias2d.event_driven import tables
from tests.ensemble.scenes import bouncing
from tools.measurements.worlds import scattered


def crowd(seed: int) -> tuple[t2.Scene, dict[str, Any]]:
    """Discs that fly, fall and spin between walls and fixed discs, and what varies of them."""
    chance = np.random.default_rng(seed)
    still = chance.random() < 0.3
    scene = t2.Scene(gravity=(0.0, 0.0) if still else tuple(chance.normal(0, 5, 2)))
    for k in range(chance.integers(1, 4)):
        angle = chance.uniform(0, 2 * math.pi)
        normal = (math.cos(angle), math.sin(angle))
        wall = t2.HalfPlane(normal=normal, offset=-chance.uniform(2, 4))
        scene.add_static(wall, restitution=chance.choice([0.0, 0.5, 1.0]), name=f"wall{k}")
    if chance.random() < 0.5:
        post = t2.Disc(radius=0.3)
        scene.add_static(post, position=(0.9, 0.9), restitution=1.0, name="post")
    vary: dict[str, Any] = {"restitution_of_pairs.disc0.wall0": stats.uniform(0.0, 1.0)}
    for k in range(chance.integers(1, 4)):
        scene.add_body(
            t2.Disc(radius=chance.uniform(0.1, 0.3)),
            mass=chance.uniform(0.1, 10.0),
            position=(1.0 * k - 1.0, -0.5),
            velocity=tuple(chance.normal(0, 2, 2)),
            angular_velocity=chance.choice([0.0, 20.0]),
            torque=chance.choice([0.0, 0.3]),
            force=(chance.choice([0.0, 1.0]), 0.0),
            restitution=chance.uniform(0, 1),
            name=f"disc{k}",
        )
        vary[f"bodies.disc{k}.velocity"] = chance.normal(0, 2, (4, 2))
        vary[f"bodies.disc{k}.position.y"] = stats.uniform(-0.6, 0.5)
        vary[f"bodies.disc{k}.mass"] = stats.uniform(0.5, 2.0)
        vary[f"bodies.disc{k}.radius"] = stats.uniform(0.05, 0.2)
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), velocity=(1.0, 0.0), name="dust")
    vary["gravity.y"] = stats.norm(-3.0, 2.0)
    return scene, vary


def rough_crowd(seed: int) -> tuple[t2.Scene, dict[str, Any]]:
    """Bodies of all shapes that are thrown, spinning, onto a rough floor, and what varies."""
    chance = np.random.default_rng(seed)
    scene = t2.Scene(gravity=(0.0, -9.81))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=1.0, friction=0.5, name="floor")
    post = t2.Box(width=0.5, height=0.5)
    scene.add_static(post, position=(2.0, 1.0), restitution=0.9, friction=0.2, name="post")
    shapes = (
        t2.Disc(radius=0.2),
        t2.Box(width=0.5, height=0.3),
        t2.Polygon(vertices=[(-0.2, -0.2), (0.3, -0.1), (0.0, 0.3)]),
        t2.Capsule(length=0.4, radius=0.1),
    )
    vary: dict[str, Any] = {"friction_of_pairs.post.body1": stats.uniform(0.0, 2.0)}
    for k, shape in enumerate(chance.permutation(np.array(shapes, dtype=object))):
        scene.add_body(
            shape,
            mass=1.0,
            position=(1.0 * k - 1.0, 1.5),
            restitution=0.9,
            friction=chance.uniform(0.0, 1.0),
            name=f"body{k}",
        )
        body = f"bodies.body{k}"
        vary |= {
            f"{body}.velocity.x": stats.norm(0.0, 2.0),
            f"{body}.orientation": stats.uniform(0.0, 6.0),
            f"{body}.angular_velocity": stats.norm(0.0, 5.0),
            f"{body}.mass": stats.uniform(0.5, 2.0),
            f"{body}.friction": stats.uniform(0.0, 1.0),
        }
    return scene, vary


def slopes(seed: int) -> tuple[t2.Scene, dict[str, Any]]:
    """Rough discs that fall on slopes and floors, rough or not, spin, and come to rest there."""
    chance = np.random.default_rng(seed)
    scene = t2.Scene(
        gravity=(0.0, -9.81) if chance.random() < 0.5 else tuple(chance.normal(0, 5, 2))
    )
    for k in range(chance.integers(1, 4)):
        angle = math.pi / 2 + chance.uniform(-0.6, 0.6) if k else chance.uniform(0, 2 * math.pi)
        wall = t2.HalfPlane(
            normal=(math.cos(angle), math.sin(angle)), offset=-chance.uniform(0.5, 4)
        )
        scene.add_static(
            wall,
            restitution=chance.choice([0.0, 0.5, 1.0]),
            friction=chance.choice([0.0, 0.3, 1.0]),
            name=f"wall{k}",
        )
    vary: dict[str, Any] = {
        "restitution_of_pairs.disc0.wall0": stats.uniform(0.0, 1.0),
        "friction_of_pairs.disc0.wall0": stats.uniform(0.0, 1.0),
    }
    for k in range(chance.integers(1, 4)):
        scene.add_body(
            t2.Disc(radius=0.2),
            mass=chance.uniform(0.1, 10.0),
            position=(1.0 * k - 1.0, -0.2),
            torque=chance.choice([0.0, 0.3]),
            force=(chance.choice([0.0, 1.0]), 0.0),
            restitution=chance.uniform(0, 1),
            friction=chance.uniform(0, 1),
            name=f"disc{k}",
        )
        vary[f"bodies.disc{k}.velocity.x"] = stats.norm(0.0, 3.0)
        vary[f"bodies.disc{k}.angular_velocity"] = stats.norm(0.0, 20.0)
        vary[f"bodies.disc{k}.position.y"] = stats.uniform(-0.6, 0.5)
        vary[f"bodies.disc{k}.radius"] = stats.uniform(0.05, 0.2)
    return scene, vary


def heap(seed: int) -> tuple[t2.Scene, dict[str, Any]]:
    """Unequal discs that come to rest on a floor between walls and strike each other there."""
    chance = np.random.default_rng(seed)
    scene = t2.Scene(gravity=(chance.normal(0.0, 0.2), -9.81))
    rough = chance.choice([0.0, 0.3, 1.0])
    for name, normal, offset in (("floor", (0.0, 1.0), 0.0), ("left", (1.0, 0.0), 0.0)):
        wall = t2.HalfPlane(normal=normal, offset=offset)
        scene.add_static(wall, restitution=1.0, friction=rough, name=name)
    scene.add_static(
        t2.HalfPlane(normal=(-0.8, 0.6), offset=-3.2), restitution=0.9, friction=0.2, name="slope"
    )
    vary: dict[str, Any] = {}
    for k in range(chance.integers(2, 5)):
        scene.add_body(
            t2.Disc(radius=0.1 + 0.05 * k),
            mass=10 ** chance.uniform(-1, 1),
            position=(0.3 + 0.45 * k, 0.4),
            restitution=chance.uniform(0.4, 0.9),
            friction=rough * chance.uniform(0, 1),
            name=f"disc{k}",
        )
        vary[f"bodies.disc{k}.velocity.x"] = stats.norm(0.0, 1.5)
        vary[f"bodies.disc{k}.position.y"] = stats.uniform(0.4, 0.4)
    return scene, vary


@pytest.fixture(autouse=True)
def _few_are_worth_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(following, "_WORTH", 1)


def compare(scene: t2.Scene, vary: Any, worlds: int, duration: float, seed: int) -> Followed:
    """Follow some worlds, and solve alone those that were; all bits must agree."""
    described = worlds_of(scene, vary, worlds, seed, None)
    times = np.linspace(0.0, duration, 5)
    request = request_of(scene, duration=duration, times=times)
    found = followed(described, request, 0, worlds)
    assert found is not None
    for world in np.flatnonzero(found.done).tolist():
        run = t2.simulate(described.scene(world), duration=duration, times=times)
        assert isinstance(run.method, t2.ClosedForm)
        for name in request.keep:
            wanted = getattr(run, name)[:, list(request.bodies)]
            np.testing.assert_array_equal(found.arrays[name][world], wanted, strict=True)
    return found


@pytest.mark.parametrize("seed", range(6))
def test_worlds_that_are_followed_have_the_bits_of_the_ordinary_way(seed: int) -> None:
    compare(*crowd(seed), worlds=4, duration=1.5, seed=seed)


@pytest.mark.parametrize("seed", range(4))
def test_worlds_of_all_shapes_with_friction_have_the_bits_of_the_ordinary_way(seed: int) -> None:
    found = compare(*rough_crowd(seed), worlds=8, duration=1.0, seed=seed)
    assert found.done.any()


def test_discs_that_are_struck_at_rest_have_the_bits_of_the_ordinary_way() -> None:
    ruled = 0
    for seed in range(4):
        scene, vary = heap(seed)
        found = compare(scene, vary, 12, 4.0, seed=seed)
        described = worlds_of(scene, vary, 12, seed, None)
        for world in np.flatnonzero(found.done).tolist():
            ruled += t2.simulate(described.scene(world), duration=4.0).ruled is not None
    assert ruled > 8  # of most, one at rest was driven into what it rests on


@pytest.mark.parametrize("seed", range(6))
def test_bodies_with_corners_that_strike_discs_or_come_to_rest_have_their_bits(seed: int) -> None:
    """One that comes to rest on a corner may tip: it is no disc, and is handed over."""
    scene, vary = heap(seed)
    chance = np.random.default_rng(seed)
    for k, shape in enumerate((t2.Box(width=0.3, height=0.2), t2.Capsule(length=0.3, radius=0.08))):
        scene.add_body(
            shape,
            mass=10 ** chance.uniform(-1, 1),
            position=(0.5 + 0.8 * k, 1.6),
            restitution=chance.uniform(0.6, 1),
            friction=0.0,
            name=f"hull{k}",
        )
        vary[f"bodies.hull{k}.velocity.x"] = stats.norm(0.0, 1.5)
        vary[f"bodies.hull{k}.orientation"] = stats.uniform(0.0, 3.0)
    compare(scene, vary, 12, 2.0, seed=seed)


def at_once(places: list[tuple[float, float]], tilt: float = 0.0) -> t2.Scene:
    """Discs of 25 cm above two planes that meet in the origin, each at an angle to the ground."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    for side in (-1.0, 1.0):
        normal = (-side * math.sin(tilt), math.cos(tilt))
        plane = t2.HalfPlane(normal=normal, offset=0.0)
        scene.add_static(plane, restitution=1.0, friction=0.0, name=f"plane at {side}")
        if not tilt:
            break
    for k, place in enumerate(places):
        disc = t2.Disc(radius=0.25)
        scene.add_body(disc, mass=1.0, position=place, restitution=0.5, friction=0.3, name=f"d{k}")
    return scene


@pytest.mark.parametrize(
    ("places", "tilt"),
    [
        ([(-0.3, 0.25), (0.3, 0.25), (0.0, 1.5)], 0.0),  # the third meets both at rest at once
        ([(0.0, 1.0)], 0.5),  # it meets both planes at once, and comes to rest on both
    ],
)
def test_what_happens_at_one_instant_is_not_answered_one_by_one(
    places: list[tuple[float, float]], tilt: float
) -> None:
    vary = {"bodies.d0.angular_velocity": [0.0]}
    found = compare(at_once(places, tilt), vary, 1, 2.0, seed=0)
    assert not found.done.any()


def test_discs_in_a_row_that_hardly_touch_pass_a_blow_on() -> None:
    """Gaps of some 1e-13 m are a thousand times what float64 resolves there, and are gaps."""
    scene = at_once([(-1.0, 1.0), (0.0, 1.0), (0.5 + 3e-13, 1.0), (1.0 + 9e-13, 1.0)])
    vary = {"bodies.d0.velocity.x": np.linspace(0.5, 2.0, 8), "gravity.y": np.zeros(8)}
    found = compare(scene, vary, 8, 2.0, seed=0)
    assert found.done.all()
    assert (found.arrays["velocity"][:, -1, 3, 0] > 0.1).all()


def test_discs_that_lean_on_each_other_are_handed_over() -> None:
    scene, vary = heap(3)
    vary["gravity.x"] = np.full(8, -3.0)  # they roll to the wall on the left, and stay there
    found = compare(scene, vary, 8, 6.0, seed=1)
    assert not found.done.any()


@pytest.mark.parametrize("seed", range(12))
def test_worlds_that_come_to_rest_with_friction_have_the_bits_of_the_ordinary_way(
    seed: int,
) -> None:
    compare(*slopes(seed), worlds=8, duration=3.0, seed=seed)


def test_discs_that_slide_roll_and_stand_are_followed() -> None:
    scene = t2.Scene(gravity=(1.0, -9.81))
    floor = t2.HalfPlane(normal=(0.6, 0.8), offset=0.0)
    scene.add_static(floor, restitution=1.0, friction=0.5, name="floor")
    ball = t2.Disc(radius=0.2)
    scene.add_body(ball, mass=1.0, position=(0.0, 1.0), restitution=0.5, friction=0.1, name="ball")
    vary = {
        "bodies.ball.friction": stats.uniform(0.0, 1.0),
        "bodies.ball.velocity.x": stats.norm(0.0, 5.0),
        "bodies.ball.angular_velocity": stats.norm(0.0, 30.0),
    }
    found = compare(scene, vary, 32, 4.0, seed=1)
    assert found.done.all()
    velocity, spin = found.arrays["velocity"][:, -1, 0], found.arrays["angular_velocity"][:, -1, 0]
    slip = np.abs(0.8 * velocity[:, 0] - 0.6 * velocity[:, 1] + 0.2 * spin)
    assert 4 < (slip < 1e-9).sum() < 28  # some roll, and some slide on


def test_rough_discs_between_walls_are_followed() -> None:
    worlds = scattered(5, 0.9, 64, seed=1, friction=0.5)
    found = followed(worlds, request_of(worlds.base, duration=4.0), 0, 64)
    assert found is not None
    assert found.done.mean() > 0.9


@pytest.mark.parametrize("friction", [0.0, 0.5])
def test_a_table_of_pairs_finds_what_a_queue_of_events_does(friction: float) -> None:
    """Discs far away, behind a wall, make the bodies too many for the table."""
    worlds = scattered(10, 0.9, 30, seed=3, friction=friction)
    values = {place.path: rows for place, rows in worlds.values.items()}
    request = request_of(worlds.base, duration=2.0)
    few = followed(worlds, request, 0, 30)
    for k in range(4):
        post, place = t2.Disc(radius=0.1), (-100.0, 1.0 + k)
        worlds.base.add_static(post, position=place, restitution=1.0, name=f"post{k}")
    assert len(worlds.base) > tables.LANES
    more = worlds_of(worlds.base, values, None, None, None)
    many = followed(more, request_of(worlds.base, duration=2.0), 0, 30)
    assert few is not None
    assert many is not None
    assert few.done.mean() > 0.8
    np.testing.assert_array_equal(few.done, many.done)
    for name in request.keep:
        np.testing.assert_array_equal(few.arrays[name][few.done], many.arrays[name][few.done])


def test_a_world_of_too_many_impacts_is_handed_over() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    for x in (-1.0, 1.0):
        wall = t2.HalfPlane(normal=(-x, 0.0), offset=-1.0)
        scene.add_static(wall, restitution=1.0, name=f"wall at {x}")
    disc = t2.Disc(radius=0.5)
    scene.add_body(disc, mass=1.0, position=(0.0, 0.0), restitution=1.0, name="disc")
    vary = {"bodies.disc.velocity.x": [9600.0, 11_000.0, 200_000.0]}  # impacts in a second
    found = followed(
        worlds_of(scene, vary, None, None, None), request_of(scene, duration=1.0), 0, 3
    )
    assert found is not None
    assert found.done.tolist() == [True, False, False]


def test_a_disc_that_bounces_and_comes_to_rest_is_followed() -> None:
    scene = t2.Scene(gravity=(1.0, -9.81))
    floor = t2.HalfPlane(normal=(0.6, 0.8), offset=0.0)
    scene.add_static(floor, restitution=1.0, name="floor")
    scene.add_body(t2.Disc(radius=0.2), mass=1.0, position=(0.0, 1.0), restitution=0.5, name="ball")
    vary = {"bodies.ball.position.y": stats.uniform(1.0, 1.0), "bodies.ball.restitution": [0.4] * 8}
    found = compare(scene, vary, 8, 3.0, seed=1)
    assert found.done.all()
    assert (found.arrays["velocity"][:, -1] != 0).any()  # it slides down


def test_what_is_not_of_this_kind_is_left_to_the_ordinary_way() -> None:
    worlds = worlds_of(bouncing(), {"gravity.y": [-1.0]}, None, None, None)
    assert followed(worlds, request_of(worlds.base, duration=0.1), 0, 1) is None
    scene, _ = rough_crowd(1)
    box = next(
        body.name for body in scene.bodies if isinstance(body.shape, t2.Box) and body.dynamic
    )
    worlds = worlds_of(scene, {f"bodies.{box}.width": [0.4]}, None, None, None)
    assert followed(worlds, request_of(scene, duration=0.1), 0, 1) is None


def test_a_world_in_which_more_happens_is_handed_over() -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.0, name="floor")
    for k in range(2):  # the second falls onto the first, which rests
        place = (0.0, 0.3 + 0.8 * k)
        disc = t2.Disc(radius=0.25)
        scene.add_body(disc, mass=1.0, position=place, restitution=0.5, name=f"disc{k}")
    worlds = worlds_of(scene, {"bodies.disc1.position.x": [0.0, 3.0]}, None, None, None)
    found = followed(worlds, request_of(scene, duration=1.0), 0, 2)
    assert found is not None
    assert found.done.tolist() == [False, True]


def test_an_ensemble_is_followed_on_threads_and_those_left_over_are_solved() -> None:
    scene, vary = crowd(12)
    given: dict[str, Any] = {"duration": 1.0, "times": (0.3, 1.0), "seed": 1}
    vary |= {path: np.tile(v, (10, 1)) for path, v in vary.items() if isinstance(v, np.ndarray)}
    one = t2.ensemble(scene, vary=vary, workers=1, **given)
    two = t2.ensemble(scene, vary=vary, workers=2, chunk=3, **given)
    assert one.identical(two)
    worlds = worlds_of(scene, vary, None, 1, None)
    done = followed(worlds, request_of(scene, duration=1.0), 0, len(worlds)).done  # type: ignore[union-attr]
    assert done.any()
    for world in (int(np.argmax(done)), int(np.argmin(done))):
        run = t2.simulate(t2.world_scene(one, world), duration=1.0, times=(0.3, 1.0))
        moving = [k for k, body in enumerate(run.scene.bodies) if body.dynamic]
        np.testing.assert_array_equal(one.position[world], run.position[:, moving])


def test_worlds_with_joints_are_left_to_the_ordinary_way() -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    disc = t2.Disc(radius=0.1)
    scene.add_body(disc, mass=1.0, position=(1.0, 0.0), restitution=0.5, name="bob")
    scene.add_joint(t2.Distance(), (0.0, 0.0), "bob", name="rod")
    masses = {"bodies.bob.mass": np.linspace(1.0, 2.0, 150)}
    worlds = worlds_of(scene, masses, None, None, None)
    assert followed(worlds, request_of(scene, duration=0.2), 0, 150) is None
    end = t2.ensemble(scene, duration=0.2, vary=masses, workers=1).position.values[:, -1, 0]
    np.testing.assert_allclose(np.hypot(*end.T), 1.0, atol=1e-9)  # the rod holds
