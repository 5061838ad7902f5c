"""The parts by which discs are followed: the queue, the cells, and lengths."""

import math

import numpy as np

from tamias2d.event_driven import queue, tables
from tamias2d.event_driven.arrangement import states_at, with_cells, world_of
from tamias2d.event_driven.cells import enter, gather
from tamias2d.event_driven.length import hypot
from tamias2d.motion import ClosedForm
from tamias2d.motion.loads import start_states
from tamias2d.scene import Scene
from tools.measurements.impacts import gas


def world_at_start(scene: Scene) -> tables.World:
    """The tables of a scene at its start, all bodies in their cells."""
    _, paths = (
        ClosedForm().motion(scene, 1.0, 1.0).segment(0.0, start_states(scene), [None] * len(scene))
    )
    world = with_cells(world_of(scene, paths, np.zeros(0), keeps_paths=False), 0.0)
    for body in np.flatnonzero(world.leaving == tables.NOWHERE).tolist():
        enter(body, 0.0, world)
    return world


def test_lengths_are_those_of_the_interpreter() -> None:
    chance = np.random.default_rng(3)
    for x, y in (chance.normal(size=(3000, 2)) * 10 ** chance.uniform(-8, 8, (3000, 2))).tolist():
        assert hypot(x, y) == math.hypot(x, y)
    assert hypot(0.0, 0.0) == 0.0


def test_events_come_in_order_and_void_ones_are_dropped() -> None:
    world, chance = world_at_start(gas(40)), np.random.default_rng(1)
    wanted = []
    for time in chance.integers(0, 50, 300).tolist():
        i, j = sorted(chance.choice(44, 2, replace=False).tolist())
        queue.push(float(time), i, j, world)
        wanted.append((float(time), i, j))
    world.notes[7, tables.VERSION] += 1
    queue.drop_void(world)
    found = []
    while world.counts[tables.EVENTS]:
        found.append((world.queue[0], *world.events[0, : tables.FIRST_VERSION].tolist()))
        queue.pop(world)
    assert found == sorted(event for event in wanted if 7 not in event[1:])


def test_all_in_reach_of_a_cell_are_near() -> None:
    world = world_at_start(gas(300, share=0.5))
    assert world.cells.size > 100
    assert world.numbers[tables.CELL] - 2 * world.numbers[tables.SLACK] > 0.02  # a diameter
    everybody = np.arange(len(world.kinds))
    places, found = states_at(world, everybody, 0.0)[:, :2], 0
    for body in np.flatnonzero(world.kinds == tables.DISC).tolist():
        near = set(world.near[: gather(body, world)].tolist())
        assert len(near) < 60
        close = np.abs(places - places[body]).max(axis=1) < world.numbers[tables.CELL]
        close &= (everybody != body) & (world.kinds == tables.DISC)
        found += int(close.sum())
        assert set(np.flatnonzero(close).tolist()) <= near
    assert found > 300
