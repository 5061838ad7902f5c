"""What touches one body, and what is in a sensor, are parts of what is told of all."""

from copy import deepcopy

import numpy as np
import pytest

import tamias2d as t2
from tests.simulator.crowd import crowd
from tests.simulator.test_sensors_push_nothing import SEEDS, boxes_about_a_coin

SURFACE = {"friction": 0.5, "restitution": 0.0}


def test_contacts_of_a_body_are_those_of_all_seen_from_it() -> None:
    sim = t2.Simulator(crowd(40, seed=6, overlap=False))
    turned = 0
    for _ in range(40):
        sim.step(5)
        for body in range(sim.position.shape[0]):
            found = sim.touching(body)
            wanted = [
                (a, b, *point, *normal, impulse, *rub, gap)
                if a == body
                else (b, a, *point, *-normal, impulse, *-rub, gap)
                for (a, b), point, normal, impulse, rub, gap in zip(
                    *vars(sim.contacts).values(), strict=True
                )
                if body in (a, b)
            ]
            told = zip(*vars(found).values(), strict=True)
            assert [(*p, *at, *n, j, *rub, gap) for p, at, n, j, rub, gap in told] == wanted
            turned += sum(sim.contacts.bodies[:, 1] == body)
    assert turned > 50


def test_a_body_that_stands_pushes_down_and_is_told_by_name() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)))
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    place = [(0.0, 0.5), (0.0, 1.5)]
    crate = t2.Box(width=1.0, height=1.0)
    low, high = sim.add(
        crate, mass=2.0, position=place, name=["low", "high"], category=[2, 4], **SURFACE
    )
    sim.step(100)
    found = sim.touching("low")
    assert found.bodies.tolist() == [[low, 0]] * 2 + [[low, high]] * 2
    assert found.normal.tolist() == [[0.0, -1.0]] * 2 + [[0.0, 1.0]] * 2
    assert found.impulse[:2].sum() == pytest.approx(40.0 / 60, rel=1e-6)
    assert sim.touching("low", mask=4).bodies.tolist() == [[low, high]] * 2
    assert len(sim.touching("low", mask=8)) == 0
    with pytest.raises(t2.InputError, match="it would be lost"):
        found.impulse[0] = 1.0
    sim.remove("high")
    assert sim.touching("low").bodies.tolist() == [[low, 0]] * 2


@pytest.mark.parametrize("seed", SEEDS)
def test_in_a_sensor_is_what_began_to_be_and_did_not_end(seed: int) -> None:
    sim, coin = boxes_about_a_coin(seed)
    inside: set[int] = set()
    most = 0
    for _ in range(120):
        sim.step()
        began, ended = sim.began.bodies, sim.ended
        inside |= set(began[(began == coin).any(axis=1)].ravel().tolist()) - {coin}
        inside -= set(ended[(ended == coin).any(axis=1)].ravel().tolist())
        assert set(sim.inside(coin).tolist()) == inside
        assert deepcopy(sim).inside(coin).tolist() == sim.inside(coin).tolist()
        most = max(most, len(inside))
    assert most >= 1


def test_a_body_of_several_parts_is_in_a_sensor_once() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), sleeping=True)
    zone = sim.add_static(t2.Box(width=4.0, height=4.0), position=(0.0, 0.0), sensor=True)
    disc = t2.Disc(radius=0.2)
    parts = [t2.Part(shape=disc, position=(x, 0.0)) for x in (-0.5, 0.5)]
    pair = sim.add(t2.Compound(parts=parts), mass=1.0, position=(0.0, 0.0), **SURFACE)
    ball = sim.add(disc, mass=1.0, position=(0.0, 1.0), category=4, **SURFACE)
    far = sim.add(disc, mass=1.0, position=(9.0, 0.0), **SURFACE)
    assert sim.inside(zone).tolist() == []  # there was no step
    sim.step()
    assert sorted(sim.inside(zone).tolist()) == [pair, ball]
    assert sim.inside(zone, mask=4).tolist() == [ball]
    sim.step(100)
    assert sim.asleep[pair]
    assert sorted(sim.inside(zone).tolist()) == [pair, ball]
    sim.remove(pair)
    assert sim.inside(zone).tolist() == [ball]
    sim.position[far] = 0.0, -1.0
    assert sim.inside(zone).tolist() == [ball]
    sim.step()
    assert sorted(sim.inside(zone).tolist()) == sorted([ball, far])


def test_what_cannot_be_asked_is_refused() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    disc = t2.Disc(radius=0.2)
    ball = sim.add(disc, mass=1.0, position=(0.0, 1.0), name="ball", **SURFACE)
    gone = sim.add(disc, mass=1.0, position=(5.0, 1.0), **SURFACE)
    sim.remove(gone)
    for body in (gone, -1, 7, "none"):
        with pytest.raises(t2.InputError, match="has none such"):
            sim.touching(body)
    with pytest.raises(t2.InputError, match=r"body: found 2 of them: must be one \(R1\)"):
        sim.touching(np.array([ball, ball]))  # type: ignore[arg-type]
    with pytest.raises(t2.InputError, match=r"sensor: body 'ball' is none \(R3\)"):
        sim.inside(ball)
    with pytest.raises(t2.InputError, match="mask"):
        sim.touching(ball, mask=1.5)  # type: ignore[arg-type]
