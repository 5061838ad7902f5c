"""Worlds that step in one call have the bits of each alone, and tell of the same."""

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine.step_calls import StepCalls
from tamias2d.engine.tables import EVENTS_TOLD
from tamias2d.simulator.stepping import Stepping
from tests.ensemble.test_simulators import batch, check

WORLDS = 6


def swing(world: int, random: np.random.Generator) -> t2.Scene:
    """A rod that strikes the limits of its hinge, above a floor; odd worlds lose theirs."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=-0.85)
    scene.add_static(floor, restitution=0.3, friction=0.2, name="floor")
    rod = t2.Box(width=1.0, height=0.1)
    scene.add_body(rod, mass=1.0, position=(0.5, 0.0), restitution=0.3, friction=0.2, name="rod")
    limits = t2.Limits(lower=-0.9 - 0.01 * world, upper=0.4, restitution=0.2)
    hinge = t2.Revolute(limits=limits)
    breaks = {"break_force": 12.0} if world % 2 else {}
    scene.add_joint(hinge, (0.0, 0.0), "rod", at=(0.0, 0.0), name="hinge", **breaks)
    scene.add_body(
        t2.Disc(radius=0.1),
        mass=0.5,
        position=(random.uniform(0.3, 0.7), 0.6),
        restitution=0.3,
        friction=0.2,
        name="ball",
    )
    return scene


def worlds() -> tuple[t2.Simulators, list[t2.Simulator]]:
    """Return swings together, and the same ones alone."""
    together = t2.Simulators(swing, worlds=WORLDS, seed=3, threads=1)
    return together, [t2.Simulator(swing(k, t2.random_stream(3, k))) for k in range(WORLDS)]


@pytest.mark.parametrize("steps", [1, 2, 5, 33])
def test_what_happens_to_joints_and_contacts_is_told_as_alone(steps: int) -> None:
    together, alone = worlds()
    happened = 0
    for _ in range(200 // steps):
        together.step(steps)
        for sim in alone:
            sim.step(steps)
        check(together, alone)
        wanted = [list(sim.joint_events) for sim in alone]
        assert [list(each) for each in together.joint_events] == wanted
        happened += sum(map(len, wanted))
    assert happened > WORLDS


def test_worlds_that_are_written_into_go_on_as_alone() -> None:
    together, alone = worlds()
    random = np.random.default_rng(5)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for k in range(60):
            world, body = int(random.integers(WORLDS)), together.index("ball")
            for each, row in ((together.velocity[world], body), (alone[world].velocity, body)):
                each[row] += (0.1, 0.2)
            if k % 7 == 0:
                together.position[world, body, 0] += 0.01
                alone[world].position[body, 0] += 0.01
            together.step()
            for sim in alone:
                sim.step()
            check(together, alone)
    assert sum(map(len, (sim.warnings for sim in alone))) == len(together.warnings)


@pytest.mark.parametrize("steps", [1, 3])
def test_a_value_that_is_none_stops_its_world_alone(steps: int) -> None:
    together, _ = batch("crowded", worlds=WORLDS, threads=1)
    together.step(10)
    together.velocity[2, 3, 0] = np.nan
    before = together.time
    with pytest.raises(t2.InputError, match="world 2: velocity"):
        together.step(steps)
    went = (together.time - before) * 60
    np.testing.assert_allclose(went, [0 if k == 2 else steps for k in range(WORLDS)])
    together.velocity[2, 3, 0] = 0.0
    together.step(steps)


def test_lists_that_get_longer_do_so_in_a_step_of_all() -> None:
    together, alone = batch("crowded", worlds=WORLDS, threads=1)
    for _ in range(90):
        together.step()
        for sim in alone:
            sim.step()
    check(together, alone)


@pytest.mark.parametrize("act", ["step", "push"])
def test_what_needs_nothing_else_steps_in_one_call(
    act: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    together, _ = batch("boxes", worlds=WORLDS, threads=1)
    together.step()
    called: list[int] = []
    plain: Callable[..., None] = Stepping.step

    def step(self: Any, count: int = 1) -> None:
        called.append(count)
        plain(self, count)

    monkeypatch.setattr(Stepping, "step", step)
    if act == "push":
        together.apply_force(1, (0.1, 0.0))
    together.step()
    assert called == ([1] * WORLDS if act == "push" else [])


def test_worlds_with_joints_step_in_one_call(monkeypatch: pytest.MonkeyPatch) -> None:
    together = t2.Simulators(t2.catalogue.load("pendulum-a01"), worlds=WORLDS, threads=1)
    together.step()
    together.step()
    monkeypatch.setattr(Stepping, "step", None)
    together.step()
    together.step(3)


def test_what_was_put_beyond_a_limit_is_told_of_its_world() -> None:
    together, _ = worlds()
    together.step()
    together.step()
    rod = together.index("rod")
    together.position[2, rod] = 0.0, 0.5
    together.orientation[2, rod] = np.pi / 2
    with pytest.warns(t2.StepWarning, match="world 2: joint 'hinge'.*beyond its upper limit by"):
        together.step()


def thrown(world: int, random: np.random.Generator) -> t2.Scene:
    """Boxes, discs and capsules on strings between walls: near nothing for a while."""
    del world
    scene = t2.Scene(gravity=(0.0, -9.81))
    for normal, offset in (((0.0, 1.0), 0.0), ((1.0, 0.0), -2.0), ((-1.0, 0.0), -2.0)):
        wall = t2.HalfPlane(normal=normal, offset=offset)
        scene.add_static(wall, restitution=0.6, friction=0.4)
    shapes = t2.Disc(radius=0.15), t2.Box(width=0.3, height=0.2), t2.Capsule(length=0.2, radius=0.1)
    velocity = tuple(random.normal(0.0, 2.0, 2).tolist())
    for k in range(4):
        scene.add_body(
            shapes[k % 3],
            mass=1.0 + k,
            position=(random.uniform(-1.5, 1.5), 0.4 + 0.4 * k),
            velocity=velocity,
            restitution=0.5,
            friction=0.4,
        )
    if random.random() < 0.5:
        scene.add_joint(t2.Distance(), 3, 4, anchor=(0.0, 0.0), other_anchor=(0.0, 0.0))
    return scene


def test_worlds_that_are_near_nothing_have_the_bits_of_each_alone(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """They are ballistic as alone: other steps leave something else for later ones."""
    for seed in range(8):
        together = t2.Simulators(thrown, worlds=WORLDS, seed=seed, threads=1)
        alone = [t2.Simulator(thrown(k, t2.random_stream(seed, k))) for k in range(WORLDS)]
        for steps in (1, 1, 2, 4, 1, 1, 4, 1, 1, 2, 33, 1, 33):
            together.step(steps)
            for sim in alone:
                sim.step(steps)
            check(together, alone)
    scene = t2.Scene(gravity=(0.0, 0.0))
    for k in range(24):  # of few bodies, all pairs are listed
        scene.add_body(
            t2.Box(width=0.2, height=0.2),
            mass=1.0,
            position=(10.0 * k, 0.0),
            velocity=(1.0, 0.0),
            restitution=1.0,
        )
    flying = t2.Simulators(scene, worlds=WORLDS, threads=1)
    flying.step()
    called: list[int] = []
    plain: Callable[..., None] = Stepping.step

    def step(self: Any, count: int = 1) -> None:
        called.append(count)
        plain(self, count)

    monkeypatch.setattr(Stepping, "step", step)
    flying.step()
    assert called == [1] * WORLDS


def test_events_are_not_logged_on_after_ctrl_c(monkeypatch: pytest.MonkeyPatch) -> None:
    """A log that fills up ends steps early."""
    together, _ = batch("boxes", worlds=WORLDS, threads=1)
    together.step()
    together.step()

    def interrupted(*_: object) -> int:
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(StepCalls, "step_function", property(lambda _: interrupted))
        with pytest.raises(KeyboardInterrupt):
            together.step(3)
    counts = [sim._engine.world.control.counts for sim in together._sims]
    assert any(each[EVENTS_TOLD] for each in counts)
    together.step()
    assert not any(each[EVENTS_TOLD] for each in counts)
