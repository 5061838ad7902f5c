"""Thin islands solved at once: stacks that stand, and the elimination against a dense solver."""

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.stepped.elimination import (
    BESIDE,
    CHANGE,
    DIAGONAL,
    assemble,
    factor,
    substitute,
)
from tamias2d.stepped.layout import THIN
from tamias2d.stepped.menu import CONTACT
from tamias2d.stepped.thin import I_KNOT, L_ONE, L_OTHER, T_COUNT, T_FIRST, TAPE


def tower(masses, *, aside=0.0, above=0.0, friction=0.5, substeps=4, reverse=False, plain=False):
    """A simulator of unit boxes on each other: moved aside by turns, with gaps between, m."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    sim = t2.Simulator(scene, time_step=1 / 60, substeps=substeps)
    if plain:
        sim._world._engine = CONTACT.plain()
    height = np.arange(len(masses))
    position = np.stack([aside * np.sin(7 * height), 0.5 + (1 + above) * height], axis=1)
    order = height[::-1] if reverse else height
    sim.add(
        t2.Box(width=1.0, height=1.0),
        mass=np.asarray(masses, dtype=float)[order],
        position=position[order],
        friction=friction,
        restitution=0.0,
    )
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=friction, restitution=0.0)
    return sim


def rows(sim, count, *, reverse=False):
    """Places and velocities of the boxes from below, (count, 3) each."""
    order = slice(count - 1, None, -1) if reverse else slice(count)
    return sim._world.pose[:count][order][:], sim._world.velocity[:count][order][:]


def assert_stands(sim, count, start):
    pose, motion = rows(sim, count)
    # overlaps and drift go down to rounding, which grows with the load; a fall is of the order 1
    assert np.abs(pose[:, :2] - start[:, :2]).max() < 1e-6
    assert np.abs(motion).max() < 1e-6


@pytest.mark.parametrize("count", [2, 10, 100])
def test_a_stack_of_equal_boxes_stands_ten_seconds_without_sag(count):
    sim = tower(np.ones(count))
    sim.step()
    start = rows(sim, count)[0].copy()
    sim.step(600)
    assert_stands(sim, count, start)


@pytest.mark.parametrize("top", [1e2, 1e3, 1e6])
def test_a_stack_stands_under_a_box_many_times_heavier(top):
    sim = tower([1.0] * 9 + [top])
    sim.step()
    start = rows(sim, 10)[0].copy()
    sim.step(600)
    assert_stands(sim, 10, start)


def test_boxes_that_fall_on_each_other_come_to_rest_as_a_stack():
    sim = tower(np.ones(10), aside=0.1, above=0.02)
    sim.step(300)
    pose, motion = rows(sim, 10)
    assert np.abs(motion).max() < 1e-9
    np.testing.assert_allclose(pose[:, 1], 0.5 + np.arange(10), atol=1e-9)


def test_a_smooth_stack_that_is_straight_stands_too():
    sim = tower(np.ones(5), friction=0.0)
    sim.step(300)
    pose, motion = rows(sim, 5)
    assert np.abs(motion).max() < 1e-9
    assert np.abs(pose[:, 0]).max() < 1e-9


def test_compiled_and_plain_solve_alike_to_the_bit():
    one, other = (tower(np.ones(4), aside=0.1, above=0.01, plain=plain) for plain in (True, False))
    for _ in range(20):
        one.step()
        other.step()
    np.testing.assert_array_equal(one._world.pose, other._world.pose)
    np.testing.assert_array_equal(one._world.motion, other._world.motion)


def test_the_order_of_adding_changes_no_bit():
    one, other = (tower(np.ones(6), aside=0.1, reverse=turned) for turned in (False, True))
    one.step(60)
    other.step(60)
    for first, second in zip(rows(one, 6), rows(other, 6, reverse=True), strict=True):
        np.testing.assert_array_equal(first, second)


def test_every_power_of_two_of_size_gives_the_same_stack():
    def grown(size):
        scene = t2.Scene(gravity=(0.0, -9.81 * size))
        sim = t2.Simulator(scene, time_step=1 / 60)
        height = np.arange(5)
        position = np.stack([0.1 * np.sin(7 * height), 0.5 + height], axis=1) * size
        box = t2.Box(width=size, height=size)
        sim.add(box, mass=np.ones(5), position=position, friction=0.5, restitution=0.0)
        sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=0.5, restitution=0.0)
        sim.step(30)
        return sim._world.pose[:5, :2] / size

    np.testing.assert_array_equal(grown(1.0), grown(2.0**-20))


def test_a_pair_that_meets_in_flight_keeps_its_momentum():
    scene = t2.Scene(gravity=(0.0, 0.0))
    sim = t2.Simulator(scene, time_step=1 / 60)
    mass = np.array([1.0, 50.0, 3.0])
    sim.add(
        t2.Box(width=1.0, height=1.0),
        mass=mass,
        position=[(-1.2, 0.1), (0.0, 0.0), (1.3, -0.2)],
        velocity=[(3.0, 0.0), (0.0, 0.0), (-3.0, 0.5)],
        orientation=[0.1, 0.0, 0.3],
        friction=0.4,
        restitution=0.0,
    )
    world = sim._world

    def energy():
        motion, body = world.motion[:3], world.body[:3]
        linear = (motion[:, :2] ** 2).sum(axis=1) / body[:, 0]
        return (linear + motion[:, 2] ** 2 / body[:, 1]).sum()

    sim.step()
    momentum = mass @ world.velocity[:3, :2]
    last = energy()
    met = 0
    for _ in range(60):
        sim.step()
        met += world.counts[THIN]
        # a sum of products of a few numbers of size 1 to 100
        np.testing.assert_allclose(mass @ world.velocity[:3, :2], momentum, atol=1e-12)
        assert energy() <= last * (1 + 1e-12)
        last = energy()
    assert met > 0


def test_elimination_solves_what_a_dense_solver_solves():
    scene = t2.Scene(gravity=(0.0, -9.81))
    sim = t2.Simulator(scene, time_step=1 / 60)
    plank, box = t2.Box(width=6.0, height=1.0), t2.Box(width=1.0, height=1.0)
    position = [(0.0, 1.5), (-2.0, 2.5), (0.0, 2.5), (2.0, 2.5), (2.0, 3.5), (0.0, 0.5)]
    sim.add(
        [plank, *[box] * 5],
        mass=np.arange(1.0, 7.0),
        position=position,
        friction=0.5,
        restitution=0.0,
    )
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=0.5, restitution=0.0)
    sim.step()
    world = sim._world
    assert world.counts[THIN] == 1
    web, weave = world.web, world.weave
    assemble(0, world.rows, world.lanes, web, weave)
    size = web[1, I_KNOT]
    assert size == 6
    dense = np.zeros((size, 3, size, 3))
    lower = np.tril_indices(3)
    for turn in range(size):
        block = np.zeros((3, 3))
        block[lower] = weave[turn, DIAGONAL : DIAGONAL + 6]
        dense[turn, :, turn] = block + block.T - np.diag(np.diag(block))
        start = web[turn, T_FIRST]
        for link in web[start : start + web[turn, T_COUNT], TAPE]:
            one, other = web[link, L_ONE], web[link, L_OTHER]
            block = weave[link, BESIDE : BESIDE + 9].reshape(3, 3)
            dense[other, :, one], dense[one, :, other] = block, block.T
    dense = dense.reshape(3 * size, 3 * size)
    truth = np.random.default_rng(1).normal(size=3 * size)
    weave[:size, CHANGE : CHANGE + 3] = (dense @ truth).reshape(size, 3)
    assert factor(0, web, weave)
    substitute(0, web, weave)
    # in the sense of the matrix: what it hardly sees is not determined any better
    error = weave[:size, CHANGE : CHANGE + 3].ravel() - truth
    assert np.abs(dense @ error).max() < 1e-13 * np.abs(dense).max() * np.abs(truth).max()
