"""Many simulators that step together have the bits of each alone, however they are stepped."""

from typing import Any

import numpy as np
import pytest
from scipy import stats

import tamias2d as t2
from tamias2d.ensemble import simulators
from tests.ensemble.scenes import stack

VARY = {
    "bodies.box0.position.x": stats.uniform(-0.2, 0.4),
    "bodies.box1.velocity.x": stats.norm(0.0, 2.0),
    "bodies.box1.mass": stats.uniform(0.5, 2.0),
}


def crowded(world: int, random: np.random.Generator) -> t2.Scene:
    """Discs and boxes that fall on each other, more of them than the first lists hold."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.2, friction=0.4, name="floor")
    for k in range(10):
        shape = t2.Disc(radius=0.2) if k % 2 else t2.Box(width=0.5, height=0.3)
        scene.add_body(
            shape,
            mass=1.0 + 0.1 * world,
            position=(random.uniform(-0.3, 0.3), 0.5 + 0.45 * k),
            velocity=(0.0, random.normal(0.0, 1.0)),
            restitution=0.2,
            friction=0.4,
            name=f"body{k}",
        )
    return scene


def sprung(world: int, random: np.random.Generator) -> t2.Scene:
    """A weight on a spring, under a drag that steps see as a kick, above a floor."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.5, name="floor")
    disc = t2.Disc(radius=0.1)
    place = (0.1 * world, random.uniform(0.4, 0.8))
    scene.add_body(disc, mass=1.0, position=place, restitution=0.5, quadratic_drag=0.3, name="bob")
    scene.add_spring("bob", (0.0, 1.0), stiffness=200.0, rest_length=0.5)
    return scene


SCENES = {"boxes": stack(), "crowded": crowded, "sprung": sprung}
SCENE_NAMES = list(SCENES)


def batch(name: str, worlds: int = 5, **more: Any) -> tuple[t2.Simulators, list[t2.Simulator]]:
    """Return worlds together, and the same ones alone."""
    scene: Any = SCENES[name]
    varied = {"vary": VARY} if isinstance(scene, t2.Scene) else {}
    together = t2.Simulators(scene, worlds=worlds, seed=3, substeps=3, **varied, **more)
    if callable(scene):
        scenes = [scene(k, t2.random_stream(3, k)) for k in range(worlds)]
    else:
        drawn = t2.ensemble(scene, duration=1 / 60, worlds=worlds, seed=3, workers=1, **varied)
        scenes = [t2.world_scene(drawn, k) for k in range(worlds)]
    return together, [t2.Simulator(one, substeps=3) for one in scenes]


def check(together: t2.Simulators, alone: list[t2.Simulator]) -> None:
    """Demand that both hold the same bits, and tell of the same contacts."""
    for name in ("position", "orientation", "velocity", "angular_velocity", "force", "mass"):
        wanted = np.stack([getattr(sim, name) for sim in alone])
        np.testing.assert_array_equal(getattr(together, name), wanted, strict=True)
    for name in ("contacts", "began"):
        found = getattr(together, name)
        for column in ("bodies", "point", "normal", "impulse", "separation"):
            parts = [getattr(getattr(sim, name), column) for sim in alone]
            np.testing.assert_array_equal(getattr(found, column), np.concatenate(parts))
        counts = [len(getattr(sim, name)) for sim in alone]
        np.testing.assert_array_equal(found.world, np.repeat(np.arange(len(alone)), counts))
    ended = [(k, *pair) for k, sim in enumerate(alone) for pair in sim.ended.tolist()]
    assert together.ended.tolist() == [list(row) for row in ended]
    assert together.time.tolist() == [sim.time for sim in alone]


@pytest.mark.parametrize("name", SCENE_NAMES)
@pytest.mark.parametrize("threads", [1, 2])
def test_worlds_that_step_together_have_the_bits_of_each_alone(
    name: str, threads: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(simulators, "_FEWEST", 1)
    together, alone = batch(name, threads=threads)
    for k in range(12):
        together.force[:, 1, 0] = k  # a view, written between steps
        for sim in alone:
            sim.force[1, 0] = k
        together.step(1 + 3 * (k % 3))
        for sim in alone:
            sim.step(1 + 3 * (k % 3))
        check(together, alone)


@pytest.mark.parametrize("name", SCENE_NAMES)
def test_a_world_that_is_reset_goes_the_way_it_went(name: str) -> None:
    together, _ = batch(name, worlds=4)
    start = together.position.copy()
    together.step(35)
    first = [together.world(k).digest() for k in range(4)]
    mask = np.array([True, False, True, False])
    together.velocity[0] = 1.0  # forgotten, and so is what pushes
    together.force[2] = 3.0
    together.gravity[0] = 0.0
    together.reset(mask)
    np.testing.assert_array_equal(together.position[mask], start[mask])
    assert together.time.tolist() == [0.0, 35 / 60, 0.0, 35 / 60]
    together.step(35)
    again = [together.world(k).digest() for k in range(4)]
    assert [a == b for a, b in zip(first, again, strict=True)] == mask.tolist()
    together.reset()
    together.step(35)
    assert [together.world(k).digest() for k in range(4)] == first


@pytest.mark.parametrize("name", ["ragdolls", "joint-grid", "car"])
def test_a_world_with_joints_that_is_reset_goes_the_way_it_went(name: str) -> None:
    """What joints start from in a step, too, is that of the first one."""
    together = t2.Simulators(t2.catalogue.load(name), worlds=1)
    together.step(30)
    first = together.world(0).digest()
    together.reset()
    together.step(30)
    assert together.world(0).digest() == first


def test_a_world_can_be_taken_out_and_goes_on() -> None:
    together, alone = batch("boxes")
    together.step(20)
    one = together.world(2)
    one.step(20)
    together.step(20)
    np.testing.assert_array_equal(one.position, together.position[2])
    assert one.index("box1") == together.index("box1") == 2
    assert len(together) == len(alone) == 5
    assert repr(together) == "<Simulators of 5 worlds of 3 bodies>"


def test_views_can_be_written_as_a_whole() -> None:
    together, _ = batch("boxes", worlds=3)
    together.gravity = [(0.0, -1.0), (0.0, -2.0), (0.0, 0.0)]
    together.velocity = np.zeros((3, 3, 2))
    together.position[:, 1:, 1] += 5.0
    together.step()
    np.testing.assert_allclose(together.velocity[:, 2, 1], np.array([-1.0, -2.0, 0.0]) / 60)
    assert not together.asleep.any()
    assert together.dynamic.tolist() == [[False, True, True]] * 3
    with pytest.raises(t2.InputError, match=r"velocity of the simulator: found \(4,\)"):
        together.velocity = np.zeros(4)


def test_a_world_at_fault_is_named_and_the_others_step() -> None:
    together, _ = batch("boxes", worlds=3)
    start = together.position.copy()
    together.velocity[1, 2, 0] = np.nan
    with pytest.raises(t2.InputError, match=r"^world 1: velocity.* of body 'box1'"):
        together.step()
    assert together.time.tolist() == [1 / 60, 0.0, 1 / 60]
    np.testing.assert_array_equal(together.position[1], start[1])
    together.reset(np.array([False, True, False]))
    together.step()


def unlike(world: int, random: np.random.Generator) -> t2.Scene:  # noqa: ARG001
    """Another name in each world."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), name=f"body{world}")
    return scene


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: t2.Simulators(stack()), "worlds None: must be a whole number of at least 1"),
        (lambda: t2.Simulators(stack(), worlds=2, seed=1), "seed: found one, but nothing varies"),
        (lambda: t2.Simulators(stack(), worlds=1, threads=0), "threads 0: must be a whole number"),
        (lambda: t2.Simulators(stack(), worlds=1, time_step=-1), "time_step|time step"),
        (lambda: t2.Simulators(stack(), worlds=1).step(-1), "count -1: must be a whole number"),
        (lambda: t2.Simulators(stack(), worlds=2).reset([1, 0]), r"mask: found int64 of shape"),
        (lambda: t2.Simulators(stack(), worlds=2).world(2), r"world 2: there are 2 \(R15\)"),
        (lambda: t2.Simulators(unlike, worlds=2, seed=1), "must be those of world 0, body0"),
        (lambda: t2.Simulators("scene", worlds=2), "scene"),
    ],
)
def test_what_cannot_be_asked_is_refused(call: Any, message: str) -> None:
    with pytest.raises(t2.InputError, match=message):
        call()
