"""Worlds that step together can be copied and pickled; the copy goes on with the same bits."""

import copy
import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.ensemble import simulators
from tests.ensemble.test_simulators import SCENE_NAMES, batch

COPIES: list[Callable[[Any], Any]] = [
    copy.copy,
    copy.deepcopy,
    lambda sims: pickle.loads(pickle.dumps(sims)),
]


def digests(sims: t2.Simulators) -> list[str]:
    return [sims.world(k).digest() for k in range(len(sims))]


@pytest.mark.parametrize("name", SCENE_NAMES)
@pytest.mark.parametrize("copied", COPIES, ids=["copy", "deepcopy", "pickle"])
@pytest.mark.parametrize("threads", [1, 2])
def test_a_copy_goes_on_alone_with_the_same_bits(
    name: str, copied: Callable[[Any], Any], threads: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(simulators, "_FEWEST", 1)
    sims, _ = batch(name, worlds=3, threads=threads)
    sims.step(20)
    sims.reset(np.array([True, False, False]))
    sims.apply_force(1, (3.0, 0.0))  # which waits for the next step
    other = copied(sims)
    before = digests(sims)
    other.step(20)
    assert digests(sims) == before
    sims.step(20)
    assert digests(other) == digests(sims)
    assert other.time.tolist() == sims.time.tolist() == [20 / 60, 40 / 60, 40 / 60]
    for each in (other, sims):
        each.reset()
        each.step(20)
    assert digests(other) == digests(sims)


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
def test_a_copy_goes_on_to_limits_that_jumped() -> None:
    """Worlds whose ropes come back, and one whose rope need not, are copied meanwhile."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_body(t2.Disc(radius=0.2), mass=2.0, position=(0.0, -2.0), name="load")
    rope = t2.Distance(limits=t2.Limits(upper=2.0, restitution=0.0))
    scene.add_joint(rope, (0.0, 0.0), "load", name="rope")
    sims = t2.Simulators(scene, worlds=3, threads=1)
    sims.step(5)
    sims.set_limits("rope", upper=[1.0, 2.0, 0.5], restitution=0.0)
    for _ in range(2):  # at once, and on its way
        others = [copied(sims) for copied in COPIES]
        alone = [sims.world(k) for k in range(3)]
        for each in (sims, *others, *alone):
            each.step(3)
        for other in others:
            assert digests(other) == digests(sims)
        assert [sim.digest() for sim in alone] == digests(sims)


def test_a_copy_keeps_joints_and_what_was_told() -> None:
    sims = t2.Simulators(t2.catalogue.load("car"), worlds=2, threads=1)
    sims.step(30)
    other = copy.copy(sims)
    assert other.joints == sims.joints
    assert other.warnings == sims.warnings
    np.testing.assert_array_equal(other.reactions.force, sims.reactions.force)
    np.testing.assert_array_equal(other.contacts.impulse, sims.contacts.impulse)
    for each in (other, sims):
        each.step(30)
    assert digests(other) == digests(sims)
    for each in (other, sims):
        each.reset()
        each.step(30)
    assert digests(other) == digests(sims)


def test_views_of_a_copy_are_its_own() -> None:
    sims, _ = batch("boxes", worlds=2)
    other = copy.copy(sims)
    other.velocity[:, 1] = 1.0
    other.gravity[:] = 0.0
    assert not sims.velocity[:, 1, 1].any()
    assert sims.gravity[:, 1].tolist() == [-9.81] * 2
    other.step()
    np.testing.assert_allclose(other.velocity[:, 1, 1], 1.0)
