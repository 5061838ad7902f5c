"""What lands on a side in a mirror does what it does here: the deeper of two points comes first."""

from typing import Any

import numpy as np
import pytest

import tamias2d as t2

FLOORS: dict[str, Any] = {
    "half-plane": t2.HalfPlane(normal=(0.0, 1.0), offset=0.0),
    "box": t2.Box(width=32.0, height=1.0),
    "segment": t2.Segment(length=32.0),
    "chain": t2.Chain(vertices=[(16.0, 0.0), (-16.0, 0.0)], one_sided=True),
}
RARE = 2  # of 30: two corners that land in one step, or at one depth, have no order in a mirror


def thrown(floor: Any, seed: int, side: float) -> t2.Simulator:
    chance = np.random.default_rng(seed)
    vx, vy = chance.normal() * 2.0, -chance.uniform(0.0, 3.0)
    spin, angle, friction = chance.normal() * 2.0, chance.uniform(-3.0, 3.0), chance.uniform()
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))
    place = (0.0, -0.5 if isinstance(floor, t2.Box) else 0.0)
    if isinstance(floor, t2.HalfPlane):
        sim.add_static(floor, friction=friction, restitution=0.0)
    else:
        sim.add_static(floor, position=place, friction=friction, restitution=0.0)
    sim.add(
        t2.Box(width=0.8, height=0.5),
        mass=2.0,
        position=(0.0, 1.2),
        velocity=(side * vx, vy),
        orientation=side * angle,
        angular_velocity=side * spin,
        friction=friction,
        restitution=0.0,
    )
    return sim


@pytest.mark.parametrize("floor", FLOORS)
def test_a_landing_in_a_mirror_is_the_mirror_image(floor: str) -> None:
    others = 0
    for seed in range(30):
        here, there = (thrown(FLOORS[floor], seed, side) for side in (1.0, -1.0))
        apart = 0.0
        for _ in range(150):
            here.step()
            there.step()
            x, y = here.velocity[1] - there.velocity[1] * (-1.0, 1.0)
            apart = max(apart, abs(x), abs(y))
        others += apart > 1e-3  # m/s, where rounding has 1e-12
    assert others <= RARE
