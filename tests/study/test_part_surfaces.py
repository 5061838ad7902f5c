"""The balance of energy knows what parts of a compound state (R3)."""

from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.study.invariants import energy_drift, energy_error

BALL = t2.Disc(radius=0.2)


def bounced(upper: dict[str, float], lower: dict[str, float], **body: Any) -> t2.Run:
    """Return a run of two balls that are one body, and meet an elastic floor with the lower one."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), restitution=1.0)
    ends = [t2.Part(shape=BALL, position=(0.0, 0.5), **upper)]
    ends += [t2.Part(shape=BALL, position=(0.0, -0.5), **lower)]
    place: Any = {"position": (0.0, 2.0), "velocity": (1.0, 0.0), "orientation": 0.3}
    scene.add_body(t2.Compound(parts=ends), mass=1.0, **place, **body)
    return t2.simulate(scene, duration=0.65, times=(0.0, 0.65))  # steps, not within one


@pytest.mark.parametrize("restitution", [1.0, 0.3])
def test_impacts_are_known_where_all_parts_state_the_same(restitution: float) -> None:
    """As where the body states it; what it states besides counts nowhere."""
    part = {"restitution": restitution}
    drift = energy_drift(bounced({}, {}, restitution=restitution))
    assert drift is not None
    for body in ({}, {"restitution": 0.7}):
        assert energy_drift(bounced(part, part, **body)) == drift


def test_nobody_knows_which_part_met() -> None:
    assert energy_drift(bounced({"restitution": 1.0}, {"restitution": 0.3})) is None


@pytest.mark.parametrize(
    ("part", "taken"),
    [({}, False), ({"friction": 0.5}, True), ({"restitution": 0.3}, True)],
)
def test_a_part_may_take_energy(part: dict[str, float], taken: bool) -> None:
    """Where nothing can, a fall of the energy is an error; here one is made up."""
    scene = bounced({}, part, restitution=1.0).scene
    error = energy_error(scene, np.array([9.0, 8.0]), np.array([4.0, 4.0]))
    assert (error == 0.0) == taken
