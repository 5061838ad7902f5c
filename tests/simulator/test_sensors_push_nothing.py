"""A sensor is told in `began` and `ended`, and pushes nothing, however bodies lie in it."""

from copy import deepcopy

import numpy as np
import pytest

import tamias2d as t2

SEEDS = [115, 121, 143, 212]  # in which boxes come to the sensor after others touched, and leave it
SURFACE = {"friction": 0.5, "restitution": 0.0}


def boxes_about_a_coin(seed: int) -> tuple[t2.Simulator, int]:
    """Eight boxes that fall about a disc that senses, and the index of that."""
    random = np.random.default_rng(seed)
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    coin = sim.add_static(t2.Disc(radius=0.5), position=(0.0, 0.6), sensor=True)
    for _ in range(8):
        sim.add(
            t2.Box(width=0.5, height=0.5),
            mass=1.0,
            position=(random.uniform(-3.0, 3.0), random.uniform(0.5, 2.0)),
            velocity=(random.normal(0.0, 2.0), 0.0),
            **SURFACE,
        )
    return sim, int(coin)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_sensor_among_boxes_is_in_no_contact(seed: int) -> None:
    sim, coin = boxes_about_a_coin(seed)
    began = ended = 0
    for _ in range(120):
        sim.step()
        assert not (sim.contacts.bodies == coin).any()
        sensed = (sim.began.bodies == coin).any(axis=1)
        assert not sim.began.impulse[sensed].any()
        began += int(sensed.sum())
        ended += int((sim.ended == coin).any(axis=1).sum())
    assert 1 <= ended <= began


@pytest.mark.parametrize("seed", SEEDS)
def test_a_copy_tells_the_same_contacts_about_a_sensor(seed: int) -> None:
    """What was in memory before, which a copy need not have, is not told."""
    sim, _ = boxes_about_a_coin(seed)
    for _ in range(120):
        other = deepcopy(sim)
        sim.step()
        other.step()
        for column in ("bodies", "point", "normal", "impulse", "separation"):
            for one, same in ((sim.contacts, other.contacts), (sim.began, other.began)):
                np.testing.assert_array_equal(getattr(one, column), getattr(same, column))
        np.testing.assert_array_equal(sim.ended, other.ended)
