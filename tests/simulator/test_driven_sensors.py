"""Sensors tell kinematic bodies, and static ones where they move themselves, not those that stand.

Times come from the geometry: two discs of 0.5 m and 0.3 m, 2 m apart, that approach at 1 m/s,
overlap from 1.2 s to 2.8 s.
"""

import copy
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine.tables import CONTACTS
from tests.engine.scenes import plain

SURFACE: Any = {"friction": 0.6, "restitution": 0.0}
BODY, SENSOR = t2.Disc(radius=0.5), t2.Disc(radius=0.3)
KINDS = [
    ("kinematic", "static"),
    ("kinematic", "kinematic"),
    ("static", "kinematic"),
    ("static", "static"),
    ("dynamic", "static"),
]


def put(sim: t2.Simulator, kind: str, shape: t2.Disc, x: float, u: float, **more: Any) -> int:
    if kind == "static":
        return int(sim.add_static(shape, position=(x, 0.0), **more))
    if kind == "kinematic":
        return int(sim.add_kinematic(shape, position=(x, 0.0), velocity=(u, 0.0), **more))
    more = {"restitution": 0.0, **more}
    return int(sim.add(shape, mass=1.0, position=(x, 0.0), velocity=(u, 0.0), **more))


def approach(
    who: str, sensor: str, *, others: int = 0, sleeping: bool = False, **filters: Any
) -> t2.Simulator:
    """A body and a sensor that pass each other, and others far away that make a tree of pairs."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), sleeping=sleeping)
    put(sim, who, BODY, 0.0, 0.0 if who == "static" else 1.0)
    drive = -1.0 if who == "static" else 0.0
    put(sim, sensor, SENSOR, 2.0, drive, sensor=True, **filters)
    for k in range(others):
        put(sim, "dynamic", SENSOR, 100.0 + 2.0 * k, 0.0)
    return sim


@pytest.mark.parametrize("sleeping", [False, True])
@pytest.mark.parametrize("others", [0, 20])
@pytest.mark.parametrize(("who", "sensor"), KINDS)
def test_each_kind_is_told_by_each_once(who: str, sensor: str, others: int, sleeping: bool) -> None:
    sim = approach(who, sensor, others=others, sleeping=sleeping)
    began: list[float] = []
    ended: list[float] = []
    for _ in range(240):
        sim.step()
        assert len(sim.contacts) == 0
        assert not sim.began.impulse.any()
        began += [sim.time] * len(sim.began)
        ended += [sim.time] * len(sim.ended)
    both_stand = who == sensor == "static"
    assert (len(began), len(ended)) == ((0, 0) if both_stand else (1, 1))
    for told, time in zip((began, ended), (1.2, 2.8), strict=True):
        assert told == [] or told[0] == pytest.approx(time, abs=2.5 * sim.time_step)


def test_one_call_tells_what_single_steps_do() -> None:
    one, other = (approach("kinematic", "kinematic", others=20) for _ in range(2))
    one.step(240)
    told = []
    for _ in range(240):
        other.step()
        told += other.began.bodies.tolist()
    assert one.began.bodies.tolist() == told == [[0, 1]]
    assert one.ended.tolist() == [[0, 1]]
    assert one.digest() == other.digest()


def test_filters_keep_them_apart() -> None:
    sim = approach("kinematic", "kinematic", mask=2)
    sim.step(240)
    assert len(sim.began) == 0
    sim.position[0] = 0.0, 0.0
    sim.set_filters(1, mask=1)
    sim.step(240)
    assert sim.began.bodies.tolist() == [[0, 1]]


def test_solid_bodies_that_nothing_pushes_are_no_pair() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    for shape in (BODY, SENSOR):
        put(sim, "kinematic", shape, 0.0, 1.0)
        put(sim, "static", shape, 0.2, 0.0)
    sim.step(60)
    assert len(sim.began) == len(sim.contacts) == 0
    assert sim._engine.world.broad_phase.counts[CONTACTS] == 0


TERRAIN = {
    "chain": t2.Chain(vertices=[(-4.0, 1.0), (0.0, 0.0), (4.0, 1.0)]),
    "one-sided chain": t2.Chain(vertices=[(4.0, 1.0), (0.0, 0.0), (-4.0, 1.0)], one_sided=True),
    "segment": t2.Segment(length=4.0),
    "box": t2.Box(width=2.0, height=1.0),
    "compound": t2.Compound(
        parts=[t2.Part(shape=t2.Disc(radius=0.5)), t2.Part(shape=t2.Box(width=2.0, height=0.2))]
    ),
}


LOWEST = {"segment": 0.0, "box": -0.5, "compound": -0.5}


@pytest.mark.parametrize("name", TERRAIN)
def test_water_senses_what_sinks(name: str) -> None:
    """A half-plane tells a shape once its lowest point is in it."""
    sim = plain(t2.Scene(gravity=(0.0, 0.0)))
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=3.0), sensor=True)
    sim.add_kinematic(TERRAIN[name], position=(0.0, 5.0), velocity=(0.0, -2.0), **SURFACE)
    began = []
    for _ in range(120):
        sim.step()
        began += [sim.time] * len(sim.began)
    assert len(began) == 1
    assert began[0] == pytest.approx((2.0 + LOWEST.get(name, 0.0)) / 2.0, abs=2.5 * sim.time_step)


@pytest.mark.parametrize("name", TERRAIN)
@pytest.mark.parametrize("driven", TERRAIN)
def test_shapes_of_all_kinds_sense_each_other(name: str, driven: str) -> None:
    """They pass crosswise, so that their sides overlap for a while."""
    sim = plain(t2.Scene(gravity=(0.0, 0.0)))
    sim.add_static(TERRAIN[name], sensor=True)
    sim.add_kinematic(
        TERRAIN[driven], position=(0.3, 8.0), velocity=(0.0, -4.0), orientation=1.3, **SURFACE
    )
    began = ended = 0
    for _ in range(240):
        sim.step()
        began += len(sim.began)
        ended += len(sim.ended)
    assert began == ended >= 1


def slept(*, sleeping: bool = True) -> t2.Simulator:
    """A box that sleeps beside a coin and in a field of view, which stand."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)), sleeping=sleeping)
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    sim.add(t2.Box(width=1.0, height=1.0), mass=1.0, position=(0.0, 0.5), **SURFACE)
    sim.add_static(SENSOR, position=(4.0, 0.5), sensor=True)
    return sim


def test_what_a_sensor_tells_wakes_nothing() -> None:
    sim = slept()
    lift = sim.add_kinematic(BODY, position=(2.5, 0.5), **SURFACE)
    sim.step(60)
    assert sim.asleep[1]
    sim.velocity[lift] = 1.0, 0.0
    told = []
    for _ in range(120):
        sim.step()
        assert sim.asleep[1]
        told += sim.began.bodies.tolist()
    assert sorted(told[0]) == [2, lift]
    assert len(told) == 1


def test_a_sensor_that_moves_over_what_sleeps_tells_it_and_does_not_wake_it() -> None:
    sim = slept()
    eye = sim.add_kinematic(t2.Disc(radius=1.0), position=(-3.0, 0.5), sensor=True)
    sim.step(60)
    assert sim.asleep[1]
    sim.velocity[eye] = 2.0, 0.0
    began: list[list[int]] = []
    ended: list[list[int]] = []
    for frame in range(180):
        if frame == 90:  # it stands for a while, in the box
            sim.velocity[eye] = 0.0, 0.0
        if frame == 120:
            sim.velocity[eye] = 2.0, 0.0
        sim.step()
        assert sim.asleep[1]
        began += [pair for pair in sim.began.bodies.tolist() if 1 in pair]
        ended += [pair for pair in sim.ended.tolist() if 1 in pair]
    assert [sorted(pair) for pair in began] == [[1, eye]]
    assert [sorted(pair) for pair in ended] == [[1, eye]]


def test_many_worlds_tell_it_too() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_kinematic(BODY, position=(0.0, 0.0), velocity=(1.0, 0.0), name="lift")
    scene.add_static(SENSOR, position=(2.0, 0.0), sensor=True)
    sims = t2.Simulators(scene, vary={"bodies.lift.position.y": [0.0, 5.0, 0.2]})
    sims.step(120)
    assert sims.began.world.tolist() == [0, 2]
    assert sims.began.bodies.tolist() == [[1, 0], [1, 0]]


def test_what_is_saved_in_between_goes_on(tmp_path: Path) -> None:
    sim = approach("kinematic", "kinematic", others=20)
    sim.step(100)
    sim.save(tmp_path / "game.npz")
    others = [copy.deepcopy(sim), t2.Simulator.restore(tmp_path / "game.npz")]
    sim.step(140)
    assert sim.ended.tolist() == [[0, 1]]
    for other in others:
        other.step(140)
        assert other.ended.tolist() == [[0, 1]]
        assert other.digest() == sim.digest()


def test_a_scene_does_not_move_otherwise_with_driven_sensors() -> None:
    """A twin without them has the same bits of all that is pushed."""
    twins = []
    for sensing in (True, False):
        sim = slept(sleeping=False)
        for k in range(5):
            sim.add(BODY, mass=1.0, position=(0.3 * k, 2.0 + 1.1 * k), **SURFACE)
        rows = np.flatnonzero(sim.dynamic)
        for k in range(3 if sensing else 0):
            at = (-3.0 + k, 0.5)
            sim.add_kinematic(BODY, position=at, velocity=(1.0, 0.0), sensor=True)
        sim.step(120)
        twins.append((sim.position[rows].tobytes(), sim.orientation[rows].tobytes()))
    assert twins[0] == twins[1]
