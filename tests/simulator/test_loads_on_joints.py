"""What rests on a body that a joint holds presses with its weight, and slides beyond friction."""

from typing import Any

import pytest

import tamias2d as t2

FRICTION, PULL = 0.5, 10.0
SURFACE: Any = {"friction": FRICTION, "restitution": 0.0}


def held_plank(*loads: float, held_by: Any) -> t2.Simulator:
    """Boxes that lie on each other on a plank of 2 kg, which a joint holds; after 5 s."""
    scene = t2.Scene(gravity=(0.0, -PULL))
    scene.add_body(t2.Box(width=6.0, height=0.2), mass=2.0, position=(0.0, 1.0), **SURFACE)
    scene.add_joint(held_by, (0.0, 1.0), 0)
    for k, mass in enumerate(loads):
        box = t2.Box(width=0.5, height=0.5)
        scene.add_body(box, mass=mass, position=(0.0, 1.35 + 0.5 * k), **SURFACE)
    sim = t2.Simulator(scene)
    sim.step(300)
    return sim


@pytest.mark.parametrize("loads", [(2.0,), (10.0,), (40.0,), (2.0, 2.0, 2.0, 2.0, 2.0)])
def test_a_joint_carries_the_weight_of_what_lies_on_its_body(loads: tuple[float, ...]) -> None:
    sim = held_plank(*loads, held_by=t2.Weld())
    weight = PULL * sum(loads)
    below = (sim.contacts.bodies == 0).any(axis=1)
    pressed = sim.contacts.impulse[below].sum() / sim.time_step
    assert pressed == pytest.approx(weight, rel=1e-3)  # what the sweeps of a step leave
    assert sim.reactions.force[0, 1, 1] == pytest.approx(weight + 2.0 * PULL, rel=1e-3)


@pytest.mark.parametrize("load", [2.0, 20.0])
@pytest.mark.parametrize("share", [0.9, 1.25])
def test_a_crate_on_a_held_plank_slides_beyond_friction(load: float, share: float) -> None:
    sim = held_plank(load, held_by=t2.Weld())
    sim.force[1] = (share * FRICTION * load * PULL, 0.0)
    start = sim.time
    sim.step(60)
    after = max(share - 1.0, 0.0) * FRICTION * PULL * (sim.time - start)
    assert sim.velocity[1, 0] == pytest.approx(after, abs=0.05)
