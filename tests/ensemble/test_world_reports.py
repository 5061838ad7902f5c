"""Worlds that step together tell of their joints and warnings what each of them tells alone."""

import re
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import fields

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.ensemble import simulators
from tamias2d.simulator.joint_reactions import Reactions
from tamias2d.simulator.told_only import REMEDIES

BREAKS = 20.0  # N
SURFACE = {"friction": 0.5, "restitution": 0.0}


def weights(world: int, random: np.random.Generator) -> t2.Scene:
    """A weight on a hook that bears two kilograms, and a wheel with a motor and a limit."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_body(None, mass=1.0 + 2.0 * world, position=(0.0, -1.0), name="weight")
    scene.add_body(None, mass=1.0, inertia=random.uniform(1, 2), position=(3.0, 0.0), name="wheel")
    scene.add_joint(t2.Distance(), (0.0, 0.0), "weight", name="hook", break_force=BREAKS)
    motor, limits = t2.Motor(speed=2.0, maximum=5.0), t2.Limits(upper=0.5, restitution=0.0)
    scene.add_joint(t2.Revolute(motor=motor, limits=limits), (3.0, 0.0), "wheel", name="drive")
    return scene


def hung(world: int, random: np.random.Generator) -> t2.Scene:  # noqa: ARG001
    """A weight on another joint in each of two worlds."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_body(None, mass=1.0, inertia=1.0, position=(0.0, -1.0), name="weight")
    kind, name = ((t2.Distance(), "rod"), (t2.Weld(), "beam"))[world]
    scene.add_joint(kind, (0.0, 0.0), "weight", other_anchor=(0.0, 1.0 * world), name=name)
    return scene


def crushed(world: int, random: np.random.Generator) -> t2.Scene:  # noqa: ARG001
    """A box under one that is too heavy for the steps, from the second world on."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    box = t2.Box(width=1.0, height=1.0)
    scene.add_body(box, mass=1.0, position=(0.0, 0.5), name="low", **SURFACE)
    heavy = 1e8 if world else 1.0
    scene.add_body(box, mass=heavy, position=(0.0, 1.5), name="high", **SURFACE)
    return scene


def stiff(world: int, random: np.random.Generator) -> t2.Scene:  # noqa: ARG001
    """A body under a force that is too fast for the steps in the second world."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    law = f"-{20000 * world + 1}[N/m]*x(position)"
    scene.add_body(None, mass=1.0, position=(1.0, 0.0), force=(law, 0.0), name="bob")
    return scene


@contextmanager
def heard() -> Iterator[list[warnings.WarningMessage]]:
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        yield told


def test_reactions_have_an_axis_of_worlds_and_the_bits_of_each() -> None:
    sims = t2.Simulators(weights, worlds=3, seed=1)
    assert sims.joints == sims.reactions.names == ("hook", "drive")
    for count in (0, 1, 90):
        sims.step(count)
        told = sims.reactions
        for world in range(3):
            alone = sims.world(world)
            rows = [sims.joints.index(name) for name in alone.joints]
            for field in fields(Reactions)[1:]:
                found, wanted = getattr(told, field.name), getattr(alone.reactions, field.name)
                np.testing.assert_array_equal(found[world][rows], wanted, strict=True)
    assert told.impulse.shape == told.force.shape == (3, 2, 3, 2)
    assert told.torque.shape == (3, 2, 3)
    assert told.limit[:, 1].tolist() == [1, 1, 1]
    with pytest.raises(t2.InputError, match="force of the reactions: found a value for a part"):
        told.force[0] = 0.0
    with pytest.raises(t2.InputError, match="reactions of the simulator: found"):
        sims.reactions = told  # type: ignore[misc]


def test_a_joint_that_broke_is_told_in_its_world_and_exerts_nothing_there() -> None:
    sims = t2.Simulators(weights, worlds=3, seed=1)
    sims.step(10)
    events = [[(event.joint, event.words) for event in each] for each in sims.joint_events]
    hooks = [[words for joint, words in each if joint == "hook"] for each in events]
    assert hooks == [[], ["breaks"], ["breaks"]]
    assert sims.joints == ("hook", "drive")
    told = sims.reactions
    np.testing.assert_allclose(told.force[0, 0, 1], [0.0, 10.0], atol=1e-12)
    assert np.isnan(told.force[1:, 0]).all()
    assert np.isnan(told.separation[1:, 0]).all()
    assert np.isfinite(told.force[:, 1]).all()
    sims.step()
    assert "breaks" not in [event.words for each in sims.joint_events for event in each]
    sims.reset(np.array([False, True, False]))
    assert np.isnan(sims.reactions.force[:, 0]).all(axis=(1, 2)).tolist() == [False, False, True]


def test_worlds_may_have_other_joints() -> None:
    sims = t2.Simulators(hung, worlds=2, seed=1)
    sims.step()
    assert sims.joints == ("rod", "beam")
    up = sims.reactions.force[:, :, 1, 1]
    np.testing.assert_allclose(up, [(10.0, np.nan), (np.nan, 10.0)], atol=1e-9)


def test_worlds_without_joints_tell_of_none() -> None:
    sims = t2.Simulators(crushed, worlds=2, seed=1)
    sims.step()
    assert (sims.joints, sims.joint_events) == ((), ((), ()))
    assert sims.reactions.force.shape == (2, 0, 3, 2)


@pytest.mark.parametrize("scene", [crushed, stiff])
@pytest.mark.parametrize("threads", [1, 2])
def test_a_warning_names_its_world_and_is_at_the_line_of_the_caller(
    scene: Callable[..., t2.Scene], threads: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(simulators, "_FEWEST", 1)
    sims = t2.Simulators(scene, worlds=2, seed=1, threads=threads)
    with heard() as told:
        sims.step(60)
        sims.step(60)  # each once
    (one,) = told
    assert str(one.message).startswith("world 1: ")
    assert (one.category, one.filename) == (t2.StepWarning, __file__)
    assert sims.warnings == (str(one.message),)
    assert sims.world(1).warnings == (str(one.message).removeprefix("world 1: "),)
    sims.reset()
    assert sims.warnings == ()


def test_a_warning_of_what_is_set_names_its_world_and_is_at_the_line_of_the_caller() -> None:
    sims = t2.Simulators(weights, worlds=2, seed=1)
    with heard() as told:
        sims.set_limits("drive", upper=[0.5, -2.0], restitution=0.0)
    (one,) = told
    assert str(one.message).startswith(
        "world 1: joint 'drive' (revolute), at 0 s: its upper limit jumped"
    )
    assert one.filename == __file__


def test_all_worlds_step_where_a_warning_is_an_error() -> None:
    sims = t2.Simulators(crushed, worlds=4, seed=1)
    with warnings.catch_warnings():
        warnings.simplefilter("error", t2.StepWarning)
        with pytest.raises(t2.StepWarning, match=r"^world 1: body 'low'"):
            sims.step(120)
    assert sims.time.tolist() == [2.0] * 4
    assert [text[:7] for text in sims.warnings] == ["world 1", "world 2", "world 3"]


def test_a_world_that_was_taken_out_warns_for_itself() -> None:
    one = t2.Simulators(crushed, worlds=2, seed=1).world(1)
    with heard() as told:
        one.step(120)
    assert [str(each.message)[:10] for each in told] == ["body 'low'"]


def public_properties() -> list[str]:
    of_class = {name: getattr(t2.Simulators, name) for name in dir(t2.Simulators)}
    return [name for name, value in of_class.items() if isinstance(value, property)]


@pytest.mark.parametrize("name", public_properties())
def test_what_worlds_tell_can_be_read(name: str) -> None:
    sims = t2.Simulators(weights, worlds=3, seed=1)
    told = getattr(sims, name)
    if isinstance(told, np.ndarray) and name != "ended":
        assert len(told) == 3
    if name in ("asleep", "dynamic", "generation", "mass", "present"):
        alone = [getattr(sims.world(world), name) for world in range(3)]
        np.testing.assert_array_equal(told, np.stack(alone), strict=True)


@pytest.mark.parametrize("name", sorted({*REMEDIES} & {*public_properties()}))
def test_a_message_names_what_worlds_have(name: str) -> None:
    sims = t2.Simulators(weights, worlds=2, seed=1)
    with pytest.raises(t2.InputError, match=r"it is told, and cannot be set \(R4\)\. \w") as raised:
        setattr(sims, name, 1)
    remedy = str(raised.value).partition("(R4). ")[2]
    words = re.findall(r"\w+", remedy.partition("that Simulator has")[0])
    assert not [word for word in words if hasattr(t2.Simulator, word) and not hasattr(sims, word)]
    told = getattr(sims, name)
    if isinstance(told, np.ndarray) and told.size:
        with pytest.raises(t2.InputError, match=re.escape(remedy)):
            told[0] = 1
