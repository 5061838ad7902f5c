"""Worlds that share a simulator have the bits that each has alone, whatever differs in them."""

from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.ensemble import stepped as stepped_worlds
from tamias2d.ensemble.request import STATE, request_of
from tamias2d.ensemble.stepped import stepped
from tamias2d.ensemble.worlds import worlds_of
from tests.ensemble.scenes import bouncing

pytestmark = pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")  # bodies start overlapping

METHOD: dict[str, Any] = {"duration": 0.8, "method": t2.Stepped(), "time_step": 1 / 60}
TIMES = (0.0, 0.31, 0.8)
SHAPES = (t2.Disc(radius=0.2), t2.Box(width=0.5, height=0.3), t2.Capsule(length=0.3, radius=0.1))
WORLDS = 12


def crowd(bodies: int) -> t2.Scene:
    """Bodies of all kinds over a floor with a wall and a paddle, each able to meet others."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.4, friction=0.5, name="floor")
    scene.add_static(t2.Box(width=0.2, height=2.0), position=(2.0, 1.0), restitution=1.0,
                     friction=0.1, name="wall")  # fmt: skip
    scene.add_kinematic(t2.Box(width=1.0, height=0.1), position=(0.0, 0.2), orientation=0.1,
                        restitution=0.3, friction=0.3, name="paddle")  # fmt: skip
    for k in range(bodies):
        scene.add_body(
            SHAPES[k % 3], mass=1.0 + k, position=(0.25 * (k % 3), 0.6 + 0.45 * k),
            restitution=0.1 * k, friction=0.2, linear_drag=0.3 * (k == 0), name=f"body{k}",
        )  # fmt: skip
    return scene


def varied(bodies: int, seed: int) -> dict[str, Any]:
    """Everything that a shared simulator can be told, at random."""
    random = np.random.default_rng(seed)
    vary: dict[str, Any] = {
        "gravity.y": random.uniform(-12.0, -5.0, WORLDS),
        "bodies.floor.restitution": random.uniform(0.0, 1.0, WORLDS),
        "bodies.wall.position.x": random.uniform(0.8, 1.5, WORLDS),
        "bodies.paddle.angular_velocity": random.normal(0.0, 5.0, WORLDS),
    }
    for k in range(bodies):
        vary[f"bodies.body{k}.position.x"] = random.normal(0.0, 1.0, WORLDS)
        vary[f"bodies.body{k}.velocity"] = random.normal(0.0, 4.0, (WORLDS, 2))
        vary[f"bodies.body{k}.orientation"] = random.uniform(-3.0, 3.0, WORLDS)
        vary[f"bodies.body{k}.angular_velocity"] = random.normal(0.0, 6.0, WORLDS)
        vary[f"bodies.body{k}.friction"] = random.uniform(0.0, 1.0, WORLDS)
        vary[f"bodies.body{k}.force.y"] = random.normal(0.0, 3.0, WORLDS)
        vary[f"bodies.body{k}.torque"] = random.normal(0.0, 0.1, WORLDS)
        if k > 0:
            vary[f"bodies.body{k}.mass"] = random.uniform(0.5, 4.0, WORLDS)
    return vary


@pytest.mark.parametrize(("bodies", "seed"), [(1, 0), (2, 1), (5, 2), (9, 3)])
def test_a_world_has_the_bits_that_it_has_alone(bodies: int, seed: int) -> None:
    scene = crowd(bodies)
    worlds = worlds_of(scene, varied(bodies, seed), None, None, None)
    request = request_of(scene, times=TIMES, bodies=range(len(scene)), **METHOD)
    found = stepped(worlds, request, 0, WORLDS)
    assert found is not None
    assert found.done.all()
    later = stepped(worlds, request, 7, WORLDS)  # in another block
    assert later is not None
    for name in STATE:
        assert later.arrays[name].tobytes() == found.arrays[name][7:].tobytes()
    for world in range(WORLDS):
        run = t2.simulate(worlds.scene(world), times=TIMES, **METHOD)
        for name in STATE:
            assert found.arrays[name][world].tobytes() == getattr(run, name).tobytes(), (
                world,
                name,
            )


def test_a_world_follows_one_that_needed_longer_arrays() -> None:
    """The contacts of the first world grow beyond what a simulator begins with."""
    scene = crowd(9)
    together = {
        f"bodies.body{k}.position": [(0.02 * k, 0.3 + 0.1 * k), (3.0 * k, 9.0)] for k in range(9)
    }
    worlds = worlds_of(scene, together, None, None, None)
    request = request_of(scene, bodies=range(len(scene)), **METHOD)
    found = stepped(worlds, request, 0, 2)
    assert found is not None
    assert found.done.all()
    for world in (0, 1):
        run = t2.simulate(worlds.scene(world), times=(0.8,), **METHOD)
        assert found.arrays["position"][world].tobytes() == run.position.tobytes()


def test_a_world_with_something_to_tell_tells_it() -> None:
    """In the middle of a block; the worlds beside it are stepped all the same."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_body(t2.Disc(radius=0.2), mass=1.0, position=(0.0, 0.0), name="disc")
    worlds = worlds_of(scene, {"gravity.y": [-9.81, -1e9, -5.0]}, None, None, None)
    with pytest.warns(t2.StepWarning, match="gravity of 1e\\+09"):
        found = stepped(worlds, request_of(scene, **METHOD), 0, 3)
    assert found is not None
    assert found.done.all()
    for world in range(3):
        run = t2.simulate(worlds.scene(world), times=(0.8,), **METHOD)
        assert found.arrays["position"][world].tobytes() == run.position[:, :1].tobytes()


def test_bodies_that_are_alike_stand_in_for_each_other(monkeypatch: pytest.MonkeyPatch) -> None:
    """Discs in any order need one simulator; a box among them stands for no other body."""
    made, prepare = [], stepped_worlds._Prepared

    def prepared(*given: Any) -> Any:
        made.append(given)
        return prepare(*given)

    monkeypatch.setattr(stepped_worlds, "_Prepared", prepared)
    scene, random = t2.Scene(gravity=(0.0, -9.81)), np.random.default_rng(5)
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.5, friction=0.3, name="floor")
    vary: dict[str, Any] = {}
    for k in range(6):
        scene.add_body(
            t2.Disc(radius=0.2), mass=1.0 + k, position=(0.5 * k, 1.0), velocity=(1.0 - k, 0.0),
            restitution=0.1 * k, friction=0.2, force=(0.3 * k, 0.0), name=f"disc{k}",
        )  # fmt: skip
        vary[f"bodies.disc{k}.position"] = random.uniform((-1.5, 0.3), (1.5, 3.0), (WORLDS, 2))
    for boxes, engines in ((0, 1), (1, None)):
        if boxes:
            box = t2.Box(width=0.3, height=0.3)
            scene.add_body(box, mass=1.0, position=(0.1, 0.5), restitution=0.2, friction=0.2,
                           name="box")  # fmt: skip
        worlds = worlds_of(scene, vary, None, None, None)
        request = request_of(scene, times=TIMES, bodies=range(len(scene)), **METHOD)
        made.clear()
        found = stepped(worlds, request, 0, WORLDS)
        assert found is not None
        assert found.done.all()
        assert len(made) == engines or (boxes and 1 < len(made) <= 7)  # places for the box
        for world in range(WORLDS):
            run = t2.simulate(worlds.scene(world), times=TIMES, **METHOD)
            for name in STATE:
                assert found.arrays[name][world].tobytes() == getattr(run, name).tobytes()


def test_discs_that_differ_in_what_a_start_does_not_tell_stand_for_themselves() -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.5, friction=0.3, name="floor")
    given: list[dict[str, Any]] = [
        {}, {"linear_drag": 0.5}, {"linear_drag": 0.5, "mass": 2.0}, {"group": -1}, {"mask": 0},
        {"radius": 0.3}, {"mass": 3.0}, {"inertia": 1.0},
    ]  # fmt: skip
    for k, other in enumerate(given):
        disc = t2.Disc(radius=other.pop("radius", 0.2))
        known = {"mass": 1.0, "restitution": 0.5, "friction": 0.2} | other
        scene.add_body(disc, position=(0.7 * k, 1.0), name=f"disc{k}", **known)
    assert stepped_worlds._kinds(scene) == [0, 1, 2, 3, 4, 5, 6, 1, 1]
    scene.set_restitution("disc0", "floor", 0.1)
    assert stepped_worlds._kinds(scene) == list(range(9))


def test_bodies_that_only_what_varies_orders_are_left_to_the_ordinary_way() -> None:
    """Two discs in one place, of which now one, now the other is the faster one."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    for name in ("a", "b"):
        scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(0.0, 0.0), restitution=0.5,
                       friction=0.1, name=name)  # fmt: skip
    vary = {"bodies.a.velocity.x": [1.0, -1.0, 2.0], "bodies.b.position.x": [0.0, 0.0, 1.0]}
    found = stepped(worlds_of(scene, vary, None, None, None), request_of(scene, **METHOD), 0, 3)
    assert found is not None
    assert found.done.tolist() == [False, False, True]
    kept = t2.ensemble(scene, vary=vary, workers=1, **METHOD)
    assert kept.outcome.values.tolist() == [2, 2, 2]
    for world in range(3):
        run = t2.simulate(t2.world_scene(kept, world), times=(0.8,), **METHOD)
        assert kept.position[world].values.tobytes() == run.position.tobytes()


def test_springs_joints_sizes_and_quantities_are_left_to_the_ordinary_way() -> None:
    scene = crowd(2)
    request = request_of(scene, **METHOD)
    sizes = worlds_of(scene, {"bodies.body0.radius": [0.1, 0.2]}, None, None, None)
    assert stepped(sizes, request, 0, 2) is None
    speeds = worlds_of(scene, {"bodies.body0.velocity.x": [0.1, 0.2]}, None, None, None)
    assert stepped(speeds, request_of(scene, duration=1.0), 0, 2) is None
    peak = request_of(scene, quantities={"peak": lambda run: run.position.max()}, **METHOD)
    assert stepped(speeds, peak, 0, 2) is None
    sprung = worlds_of(bouncing(), {"gravity.y": [-1.0, -2.0]}, None, None, None)
    assert stepped(sprung, request_of(bouncing(), **METHOD), 0, 2) is None
