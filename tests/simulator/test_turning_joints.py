"""A joint that turns too far in a substep costs energy and is not apart: that is told (IM15)."""

import math
import warnings

import numpy as np
import pytest

import tamias2d as t2

G = 9.81


def machine(light: float) -> t2.Scene:
    """Two bobs that hang 2 m below the posts of a rope, 0.3 rad aside: one of 1 kg, one lighter.

    The heavy one pulls the light one up to its post, around which it whirls.
    """
    scene = t2.Scene(gravity=(0.0, -G))
    aside, down = 2.0 * math.sin(0.3), -2.0 * math.cos(0.3)
    scene.add_body(None, mass=light, inertia=1.0, position=(-1.0 + aside, down))
    scene.add_body(None, mass=1.0, inertia=1.0, position=(1.0 + aside, down))
    scene.add_joint(t2.Pulley(posts=[(-1.0, 0.0), (1.0, 0.0)]), 0, 1, name="rope")
    return scene


def lost_and_told(light: float, time_step: float) -> tuple[float, list[str]]:
    """Return which part of the largest kinetic energy is gone after 0.8 s, and what was told."""
    scene = machine(light)
    sim = t2.Simulator(scene, time_step=time_step, compiled=False)
    mass = np.array([light, 1.0])
    energies = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", t2.StepWarning)
        for _ in range(round(0.8 / time_step) + 1):
            kinetic = 0.5 * float(mass @ (sim.velocity**2).sum(axis=1))
            energies.append((kinetic, kinetic + G * float(mass @ sim.position[:, 1])))
            sim.step()
    found = np.array(energies)
    lost = float(found[0, 1] - found[-1, 1]) / float(found[:, 0].max())
    return lost, [text for text in sim.warnings if "'rope'" in text and "turned" in text]


@pytest.mark.parametrize(("light", "time_step"), [(0.1, 1 / 60), (1 / 30, 1 / 60), (0.01, 1 / 240)])
def test_a_bob_that_whirls_around_its_post_faster_than_steps_is_told(
    light: float, time_step: float
) -> None:
    lost, told = lost_and_told(light, time_step)
    assert lost > 0.02  # twice what those lose that steps can follow
    assert len(told) == 1


@pytest.mark.parametrize(("light", "time_step"), [(1 / 3, 1 / 60), (0.2, 1 / 60), (0.1, 1 / 240)])
def test_one_that_steps_can_follow_is_not(light: float, time_step: float) -> None:
    lost, told = lost_and_told(light, time_step)
    assert lost < 0.01
    assert told == []
