"""Chains that fall on a floor without restitution are told what its contacts give them.

The impulse of the blow was given again as the next step began: it set links in motion, and the
bound on energy took back what nobody was told of.
"""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.simulator import Simulator

G = 9.81


def falling_chain(seed: int) -> t2.Scene:
    """Two to four boxes on hinges, above a floor."""
    rng = np.random.default_rng(seed)
    scene = t2.Scene(gravity=(0.0, -G))
    count, friction = int(rng.integers(2, 5)), float(rng.choice([0.0, 0.3, 0.8]))
    surface = {"friction": friction, "restitution": 0.0}
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    length, width = rng.uniform(0.3, 1.0), rng.uniform(0.1, 0.25)
    high, turned = rng.uniform(0.5, 2.0), rng.uniform(-1.0, 1.0)
    c, s = math.cos(turned), math.sin(turned)
    for k in range(count):
        place = (k * length * c, high + count * length + k * length * s)
        scene.add_body(
            t2.Box(width=length, height=width),
            mass=rng.uniform(0.5, 2.0),
            position=place,
            orientation=turned,
            **surface,
        )
    for k in range(count - 1):
        at = ((k + 0.5) * length * c, high + count * length + (k + 0.5) * length * s)
        scene.add_joint(t2.Revolute(), k + 1, k + 2, at=at)
    return scene


def told(sim: Simulator) -> np.ndarray:
    """Return the impulse that the floor is told to have given in the last step (2,), N s."""
    contacts, total = sim.contacts, np.zeros(2)
    for k, (first, second) in enumerate(contacts.bodies.tolist()):
        if 0 in (first, second):
            x, y = contacts.normal[k]
            given = contacts.impulse[k] * np.array((x, y))
            given += contacts.friction_impulse[k] * np.array((y, -x))
            total += given if first == 0 else -given
    return total


@pytest.mark.parametrize("seed", [28, 29, 53])
def test_a_chain_that_strikes_a_floor_is_told_what_it_got(seed: int) -> None:
    sim = Simulator(falling_chain(seed), time_step=1 / 60)
    mass = np.array([sim.body(k).mass for k in range(1, len(sim.mass))])
    struck = False
    for _ in range(55):
        before = mass @ sim.velocity[1:]
        sim.step()
        got = mass @ sim.velocity[1:] - before + np.array((0.0, G * mass.sum() / 60))
        np.testing.assert_allclose(told(sim), got, rtol=0, atol=1e-9)
        struck = struck or len(sim.contacts) > 0
    assert struck
