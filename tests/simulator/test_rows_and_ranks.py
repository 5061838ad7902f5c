"""Bodies that come and go in any order have the same bits, and keep the rows that users know."""

import pickle
import random

import numpy as np
import pytest

import tamias2d as t2
from tests.simulator.crowd import SHAPES

Rows = dict[int, int]  # by name


def ground(*, sleeping: bool) -> t2.Simulator:
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=0.6, restitution=0.2)
    return t2.Simulator(scene, sleeping=sleeping)


def add(sim: t2.Simulator, rows: Rows, names: list[int]) -> None:
    """Add bodies, each of which follows from its name."""
    chances = {name: random.Random(name) for name in names}
    found = sim.add(
        [SHAPES[name % len(SHAPES)] for name in names],
        mass=[1.0 + name % 3 for name in names],
        position=[(chances[n].uniform(-3, 3), chances[n].uniform(0.5, 6)) for n in names],
        velocity=[(chances[n].uniform(-3, 3), 0.0) for n in names],
        friction=0.5,
        restitution=0.2,
    )
    rows.update(zip(names, found.tolist(), strict=True))


def assert_alike(one: t2.Simulator, first: Rows, other: t2.Simulator, second: Rows) -> None:
    """Compare two simulators, name by name."""
    mine, theirs = list(first.values()), [second[name] for name in first]
    for quantity in ("position", "velocity", "orientation", "angular_velocity", "mass", "asleep"):
        found = [getattr(sim, quantity)[rows] for sim, rows in ((one, mine), (other, theirs))]
        assert found[0].tobytes() == found[1].tobytes(), quantity
    name = {row: name for name, row in second.items()}
    there = [(first[name[i]], first[name[j]]) for i, j in other.contacts.bodies.tolist()]
    assert [tuple(pair) for pair in one.contacts.bodies.tolist()] == there
    assert one.contacts.impulse.tobytes() == other.contacts.impulse.tobytes()
    start, end = np.linspace((-3.0, 7.0), (3.0, 7.0), 9), np.linspace((3.0, -1.0), (-3.0, -1.0), 9)
    mine, theirs = one.ray_cast(start, end).body.tolist(), other.ray_cast(start, end).body.tolist()
    assert mine == [first[name[row]] if row >= 0 else row for row in theirs]


@pytest.mark.parametrize("seed", range(4))
def test_who_comes_and_goes_in_another_order_has_the_same_bits(seed: int) -> None:
    chance, other_order = random.Random(seed), random.Random(seed + 100)
    one, other = (ground(sleeping=seed % 2 == 0) for _ in range(2))
    first, second = {-1: 0}, {-1: 0}
    met = 0
    for turn in range(12):
        names = list(range(10 * turn, 10 * turn + chance.randint(1, 8)))
        gone = chance.sample(sorted(first)[1:], len(first) // 3)
        for sim, rows in ((one, first), (other, second)):
            if len(gone) > 1:
                sim.remove([rows.pop(name) for name in gone])
            add(sim, rows, names)
            other_order.shuffle(names)
            other_order.shuffle(gone)
        other = pickle.loads(pickle.dumps(other))
        for _ in range(chance.randint(1, 20)):
            one.step()
            other.step()
        assert_alike(one, first, other, second)
        met += len(one.contacts)
    assert met > 10
    rows = [(first[name], second[name]) for name in first]
    assert any(mine != theirs for mine, theirs in rows)


def test_neighbours_sit_beside_each_other() -> None:
    """Rows of discs that are added from left to right sit in columns."""
    sim = ground(sleeping=False)
    place = np.array([(0.9 * (k % 20), 0.5 + 0.9 * (k // 20)) for k in range(200)])
    sim.add(t2.Disc(radius=0.4), mass=1.0, position=place, friction=0.5, restitution=0.0)
    sim.step()
    world = sim._engine.world
    owner = world.state.body_of_slot
    seats = place[owner[1:201].astype(np.int64) - 1]
    apart = np.linalg.norm(np.diff(seats, axis=0), axis=1)
    assert np.median(apart) < 2.0
    order = world.broad_phase.canonical[0, 1:201].astype(np.int64)
    assert (world.state.body_of_shape[order] == owner[1:201]).all()
    assert (np.diff(order) == 1).all()


def test_what_goes_before_it_took_a_step_leaves_nothing() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)))

    def add() -> int:
        return sim.add(t2.Disc(radius=0.5), mass=1.0, position=(0.0, 0.0), friction=0.5,
                       restitution=0.0)  # fmt: skip

    sim.step()
    sim.remove(add())
    sim.step()
    add()
    sim.step()
    assert sorted(sim._engine._pool._order.tolist()) == [0]
