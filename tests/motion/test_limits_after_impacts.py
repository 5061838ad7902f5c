"""Joints that expect something, and an impact that comes before it, against closed forms."""

import math
from typing import Any

import numpy as np
import pytest

import tamias2d as t2

RADIUS, LIGHT, MET, STOP = 0.1, 0.5, 0.499, 0.5
WAYS: list[dict[str, Any]] = [
    {"method": t2.Reference()},
    {"method": t2.Dop853(rtol=1e-9)},
    {"method": t2.RungeKutta4(), "time_step": 0.05},
]


def bob(joint: t2.Revolute | t2.Rotary | t2.Ratchet) -> t2.Scene:
    """A disc at 1 m from its hinge, which turns at 1 rad/s and meets a free one at 0.499 rad."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    disc = t2.Disc(radius=RADIUS)
    scene.add_body(
        disc, mass=1.0, position=(1, 0), velocity=(0, 1), angular_velocity=1.0, restitution=1.0
    )
    outwards = np.array([math.cos(MET), math.sin(MET)])
    ahead = np.array([-outwards[1], outwards[0]])
    scene.add_body(disc, mass=LIGHT, position=outwards + 2 * RADIUS * ahead, restitution=1.0)
    scene.add_joint(t2.Revolute(), (0.0, 0.0), 0, other_anchor=(-1.0, 0.0))
    scene.add_joint(joint, (0.0, 0.0), 0)
    return scene


def turned_on() -> float:
    """The angular velocity after the impact: of an elastic one with an inertia about the hinge."""
    inertia = 1.0 + RADIUS**2 / 2
    return 1 - 2 / (1 / inertia + 1 / LIGHT) / inertia


def near(way: dict[str, Any]) -> float:
    """Of an angle or a time: steps of 0.05 s err by the fourth power of them."""
    return 1e-8 if "time_step" in way else 1e-10


@pytest.mark.parametrize("way", [*WAYS, {"tolerance": 1e-6}])
def test_a_stop_is_met_as_late_as_the_impact_before_it_says(way: dict[str, Any]) -> None:
    scene = bob(t2.Rotary(limits=t2.Limits(upper=STOP, restitution=1.0)))
    run = t2.simulate(scene, duration=0.52, times=[0.0, 0.52], **way)
    met = MET + (STOP - MET) / turned_on()
    assert run.joint_events.time == pytest.approx([met], abs=near(way))
    angle = STOP - (0.52 - met) * turned_on()
    assert run.orientation[-1, 0] == pytest.approx(angle, abs=near(way))


@pytest.mark.parametrize("way", WAYS)
def test_a_ratchet_clicks_as_late_as_the_impact_before_says(way: dict[str, Any]) -> None:
    run = t2.simulate(bob(t2.Ratchet(pitch=STOP, restitution=0.0)), duration=0.52, **way)
    late = MET + (STOP - MET) / turned_on()
    assert run.joint_events.time == pytest.approx([0.0, late], abs=near(way))
