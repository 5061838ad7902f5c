"""What touched is told as geometry and mechanics have it."""

import numpy as np
import pytest

import tamias2d as t2
from tests.simulator.crowd import crowd

FLOOR = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)


def bouncing(restitution: float) -> t2.Simulator:
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_body(t2.Disc(radius=0.5), mass=2.0, position=(0.0, 1.5), restitution=restitution)
    scene.add_static(FLOOR, friction=0.0, name="floor")
    return t2.Simulator(scene)


def test_a_bounce_begins_and_ends_once_and_its_impulse_is_the_change_of_momentum() -> None:
    sim = bouncing(0.5)
    told = []
    for step in range(40):
        before = sim.velocity[0, 1]
        sim.step()
        change = 2.0 * (sim.velocity[0, 1] - before + 10.0 / 60)
        assert sim.contacts.impulse.sum() == pytest.approx(change, abs=1e-12)
        if len(sim.began):
            told.append(("began", step))
            assert sim.began.bodies.tolist() == [[1, 0]]
            assert sim.began.normal.tolist() == [[0.0, 1.0]]
            assert sim.began.impulse[0] == pytest.approx(change, abs=1e-12)
            assert sim.began.point[0] == pytest.approx((0.0, 0.0), abs=0.1)
        if len(sim.ended):
            told.append(("ended", step))
            assert sim.ended.tolist() == [[1, 0]]
    assert [what for what, _ in told] == ["began", "ended"]
    fall = np.sqrt(2 * 1.0 / 10.0) * 60  # steps until it touches
    assert told[0][1] == pytest.approx(fall, abs=1.0)


def test_a_stack_carries_its_weight() -> None:
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(FLOOR, restitution=0.0, friction=0.5)
    for k in range(3):
        scene.add_body(
            t2.Box(width=1.0, height=1.0), mass=1.0, position=(0.0, 0.5 + k), restitution=0.0
        )
    sim = t2.Simulator(scene)
    sim.step(200)
    found = sim.contacts
    pairs = [tuple(sorted(pair)) for pair in found.bodies.tolist()]
    assert sorted(set(pairs)) == [(0, 1), (1, 2), (2, 3)]
    for pair, weight in (((0, 1), 30.0), ((1, 2), 20.0), ((2, 3), 10.0)):
        here = [k for k, p in enumerate(pairs) if p == pair]
        assert len(here) == 2
        # at rest a step of gravity is carried; what is left of the settling is far below
        assert found.impulse[here].sum() == pytest.approx(weight / 60, rel=1e-3)
        assert np.abs(found.point[here, 0]) == pytest.approx(0.5, abs=1e-2)
        assert found.point[here, 1] == pytest.approx(pair[0], abs=1e-2)
        assert np.abs(found.normal[here, 1]) == pytest.approx(1.0, abs=1e-6)
        assert (np.abs(found.separation[here]) < 1e-2).all()
    sim.step()
    assert (len(sim.began), len(sim.ended)) == (0, 0)


def test_what_began_and_did_not_end_is_what_touches() -> None:
    sim = t2.Simulator(crowd(40, seed=6, overlap=False))
    touching: set[tuple[int, int]] = set()
    for _ in range(200):
        sim.step()
        began = {tuple(sorted(pair)) for pair in sim.began.bodies.tolist()}
        ended = {tuple(sorted(pair)) for pair in sim.ended.tolist()}
        assert not began & touching
        for k, pair in enumerate(sim.began.bodies.tolist()):
            here = np.flatnonzero((sim.contacts.bodies == pair).all(axis=1))
            most = here[np.argmax(sim.contacts.impulse[here])]
            total = sim.contacts.impulse[here].sum()
            assert sim.began.impulse[k] == pytest.approx(total, rel=1e-14)
            assert sim.began.point[k].tolist() == sim.contacts.point[most].tolist()
        assert ended <= touching
        touching = (touching | began) - ended
        assert touching == {tuple(sorted(pair)) for pair in sim.contacts.bodies.tolist()}
    assert len(touching) > 30


def test_bodies_that_touch_in_two_places_begin_once() -> None:
    """Beams with two feet land beside discs, so that pairs of one and of two contacts begin."""
    foot = t2.Disc(radius=0.2)
    beam = t2.Compound(parts=[t2.Part(shape=foot, position=(x, 0.0)) for x in (-1.0, 1.0)])
    scene = t2.Scene(gravity=(0.0, -10.0))
    for k in range(4):
        shape = foot if k % 2 else beam
        scene.add_body(shape, mass=1.0 + k, position=(4.0 * k, 0.3), restitution=0.0)
    scene.add_static(FLOOR, friction=0.0)
    sim = t2.Simulator(scene)
    while not len(sim.began):
        sim.step()
    assert sim.began.bodies.min(axis=1).tolist() == [0, 1, 2, 3]
    gained = sim.mass[:4] * (sim.velocity[:4, 1] + 10.0 * sim.time)
    np.testing.assert_allclose(sim.began.impulse, gained, rtol=1e-12)


def test_a_point_is_told_where_the_step_began() -> None:
    """A disc on a platform that takes it along, a tenth of a metre a step."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    wide = t2.Box(width=50.0, height=1.0)
    scene.add_kinematic(wide, position=(0.0, -0.5), velocity=(6.0, 0.0), friction=1.0)
    box = t2.Box(width=1.0, height=1.0)
    rider = scene.add_body(
        box, mass=1.0, position=(0.0, 0.5), velocity=(6.0, 0.0), friction=1.0, restitution=0.0
    )
    sim = t2.Simulator(scene)
    for _ in range(60):
        before = sim.position[rider, 0]
        sim.step()
        assert sim.contacts.point[:, 0].mean() == pytest.approx(before, abs=1e-3)
    assert before == pytest.approx(5.9, abs=1e-2)


def test_a_body_of_several_shapes_touches_once() -> None:
    """Both feet of a table on the floor are one touch, though not one point."""
    foot = t2.Box(width=0.2, height=1.0)
    table = t2.Compound(
        parts=[t2.Part(shape=foot, position=(x, 0.0)) for x in (-1.0, 1.0)]
        + [t2.Part(shape=t2.Box(width=2.2, height=0.2), position=(0.0, 0.6))]
    )
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(FLOOR, restitution=0.0, friction=0.5)
    low = min(y for part in table.pieces for _, y in part.core)
    scene.add_body(table, mass=1.0, position=(0.0, -low + 0.1), restitution=0)
    sim = t2.Simulator(scene)
    begun = 0
    for _ in range(120):
        sim.step()
        begun += len(sim.began)
    assert begun == 1
    assert len(sim.contacts) == 4


def test_who_does_not_touch_by_filter() -> None:
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(FLOOR, restitution=0.0, category=2)
    ghost = scene.add_body(
        t2.Disc(radius=0.5), mass=1.0, position=(0.0, 2.0), mask=1, restitution=0
    )
    ball = scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(3.0, 2.0), mask=3, restitution=0)
    one = scene.add_body(
        t2.Disc(radius=0.5), mass=1.0, position=(6.0, 0.5), group=-1, restitution=0
    )
    two = scene.add_body(
        t2.Disc(radius=0.5), mass=1.0, position=(6.2, 0.5), group=-1, restitution=0
    )
    sim = t2.Simulator(scene)
    sim.step(120)
    assert sim.position[ghost, 1] < -1.0
    assert sim.position[ball, 1] == pytest.approx(0.5, abs=1e-2)
    assert sim.position[[one, two], 0].tolist() == [6.0, 6.2]


def test_a_sensor_tells_and_pushes_nothing() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    zone = scene.add_static(t2.Box(width=2.0, height=2.0), position=(5.0, 0.0), sensor=True)
    ball = scene.add_body(
        t2.Disc(radius=0.5), mass=1.0, position=(0.0, 0.0), velocity=(6.0, 0.0), restitution=0.0
    )
    sim = t2.Simulator(scene)
    began = ended = None
    for _ in range(120):
        sim.step()
        assert len(sim.contacts) == 0
        if len(sim.began):
            assert sorted(sim.began.bodies[0].tolist()) == [zone, ball]
            assert sim.began.impulse.tolist() == [0.0]
            began = sim.position[ball, 0]
        if len(sim.ended):
            ended = sim.position[ball, 0]
    assert sim.velocity[ball].tolist() == [6.0, 0.0]
    assert began == pytest.approx(3.5, abs=0.2)  # two steps of 0.1 m
    assert ended == pytest.approx(6.5, abs=0.2)


def test_what_meets_in_flight_is_told_with_its_impulse() -> None:
    """A bullet goes 50 m in a step, and meets a plate of 2 cm on its way."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    plate = scene.add_static(t2.Box(width=0.02, height=2.0), position=(20.0, 0.0), friction=0.0)
    bullet = scene.add_body(
        t2.Disc(radius=0.05), mass=0.5, position=(0.0, 0.0), velocity=(3000.0, 0.0), restitution=0.5
    )
    sim = t2.Simulator(scene)
    sim.step()
    assert sim.velocity[bullet].tolist() == pytest.approx([-1500.0, 0.0], rel=1e-12)
    assert sim.began.impulse == pytest.approx([0.5 * 4500.0], rel=1e-12)
    sense = 1.0 if sim.began.bodies[0, 0] == bullet else -1.0
    assert sim.began.normal[0] == pytest.approx([sense, 0.0], abs=1e-12)
    assert sim.began.point[0] == pytest.approx([19.99, 0.0], abs=1e-3)
    assert len(sim.contacts) == 1
    sim.step()
    assert sorted(sim.ended[0].tolist()) == [plate, bullet]
    assert len(sim.contacts) == 0


def test_the_normal_leads_from_the_first_to_the_second_in_flight_too() -> None:
    """A floor that came after the bullet is the second of the pair."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    bullet = sim.add(
        t2.Disc(radius=0.05), mass=1.0, position=(0.0, 9.0), velocity=(0.0, 0.0), restitution=0.0
    )
    sim.step()
    floor = sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0))
    sim.velocity[bullet] = 0.0, -3000.0
    sim.step()
    assert sim.began.bodies.tolist() == [[bullet, floor]]
    assert sim.began.normal[0].tolist() == [0.0, -1.0]


def test_who_is_taken_far_away_ceases_to_touch() -> None:
    sim = bouncing(0.0)
    sim.step(60)
    assert len(sim.contacts) == 1
    sim.position[0] = 1e4, 1e4
    sim.step()
    assert sim.ended.tolist() == [[1, 0]]
    assert len(sim.contacts) == 0
