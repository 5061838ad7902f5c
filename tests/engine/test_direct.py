"""The direct solver: stacks that stand, momentum and energy, and a dense matrix as oracle."""

from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine import tables as tb
from tamias2d.engine.direct.cholesky import factor, substitute
from tamias2d.engine.direct.matrix import assemble_matrix
from tamias2d.engine.tables import Direct
from tamias2d.simulator import Simulator
from tamias2d.state import Array
from tests.engine.scenes import ground, plain, tower


def simulator(*masses: float, **options: Any) -> Simulator:
    return Simulator(tower(masses, **options))


def state(sim: Simulator, count: int, *, reverse: bool = False) -> tuple[Array, Array]:
    """Poses and velocities of the boxes from below, (count, 3) each."""
    order = slice(count - 1, None, -1) if reverse else slice(count)
    bodies = sim._engine.world.state
    return bodies.pose[:count][order].copy(), bodies.velocity[:count][order].copy()


def assert_stands_for_ten_seconds(sim: Simulator, count: int) -> None:
    sim.step()
    start, _ = state(sim, count)
    sim.step(600)
    pose, velocity = state(sim, count)
    # overlaps and drift go down to rounding, which grows with the load; a fall is of the order 1
    assert np.abs(pose[:, :2] - start[:, :2]).max() < 1e-6
    assert np.abs(velocity).max() < 1e-6


@pytest.mark.parametrize("count", [2, 10, 100])
def test_a_stack_of_equal_boxes_stands_ten_seconds_without_sag(count: int) -> None:
    assert_stands_for_ten_seconds(simulator(*np.ones(count)), count)


@pytest.mark.parametrize("top", [1e2, 1e3, 1e6])
def test_a_stack_stands_under_a_box_many_times_heavier(top: float) -> None:
    assert_stands_for_ten_seconds(simulator(*np.ones(9), top), 10)


def test_boxes_that_fall_on_each_other_come_to_rest_as_a_stack() -> None:
    sim = simulator(*np.ones(10), aside=0.1, above=0.02)
    sim.step(300)
    pose, velocity = state(sim, 10)
    assert np.abs(velocity).max() < 1e-9
    np.testing.assert_allclose(pose[:, 1], 0.5 + np.arange(10), atol=1e-9)


def test_a_smooth_stack_that_is_straight_stands_too() -> None:
    sim = simulator(*np.ones(5), friction=0.0)
    sim.step(300)
    pose, velocity = state(sim, 5)
    assert np.abs(velocity).max() < 1e-9
    assert np.abs(pose[:, 0]).max() < 1e-9


def test_compiled_and_plain_solve_alike_to_the_bit() -> None:
    scene = tower(np.ones(4), aside=0.1, above=0.01)
    compiled, slow = Simulator(scene), plain(scene)
    for _ in range(20):
        compiled.step()
        slow.step()
    for group, field in (("state", "pose"), ("bodies", "motion")):
        first, second = (
            getattr(getattr(sim._engine.world, group), field) for sim in (compiled, slow)
        )
        np.testing.assert_array_equal(first, second)


def test_the_order_of_adding_changes_no_bit() -> None:
    one, other = (simulator(*np.ones(6), aside=0.1, reverse=turned) for turned in (False, True))
    one.step(60)
    other.step(60)
    for first, second in zip(state(one, 6), state(other, 6, reverse=True), strict=True):
        np.testing.assert_array_equal(first, second)


def test_every_power_of_two_of_size_gives_the_same_stack() -> None:
    def grown(size: float) -> Array:
        sim = simulator(*np.ones(5), aside=0.1, size=size)
        sim.step(30)
        places: Array = state(sim, 5)[0][:, :2] / size
        return places

    np.testing.assert_array_equal(grown(1.0), grown(2.0**-20))


def test_islands_that_meet_in_flight_keep_their_momentum_and_gain_no_energy() -> None:
    sim = Simulator(t2.Scene(gravity=(0.0, 0.0)), time_step=1 / 60)
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
    inertia = mass / 6  # of unit boxes

    def energy() -> float:
        velocity, spin = sim.velocity, sim.angular_velocity
        return float(mass @ (velocity**2).sum(axis=1) + inertia @ spin**2)

    sim.step()
    momentum = mass @ sim.velocity
    last = energy()
    solved = 0
    for _ in range(60):
        sim.step()
        solved += sim._engine.world.direct.counts[tb.TREES]
        # a sum of products of a few numbers of size 1 to 100
        np.testing.assert_allclose(mass @ sim.velocity, momentum, atol=1e-12)
        assert energy() <= last * (1 + 1e-12)
        last = energy()
    assert solved > 0


def dense_matrix(direct: Direct) -> Array:
    """The matrix of the first island as it was assembled, which is not factored yet."""
    sparse, factors = direct.sparse, direct.factors
    size = int(sparse[1, tb.I_NODE])
    dense = np.zeros((size, 3, size, 3))
    lower = np.tril_indices(3)
    for node in range(size):
        block = np.zeros((3, 3))
        block[lower] = factors[node, tb.DIAGONAL : tb.DIAGONAL + 6]
        dense[node, :, node] = block + block.T - np.diag(np.diag(block))
    for pivot in range(size):
        start = sparse[pivot, tb.PIVOT_FIRST]
        for edge in sparse[start : start + sparse[pivot, tb.PIVOT_COUNT], tb.FILL]:
            a, b = sparse[edge, tb.E_NODE_A], sparse[edge, tb.E_NODE_B]
            block = factors[edge, tb.OFF_DIAGONAL : tb.OFF_DIAGONAL + 9].reshape(3, 3)
            dense[b, :, a], dense[a, :, b] = block, block.T
    return dense.reshape(3 * size, 3 * size)


def test_the_factors_solve_what_a_dense_matrix_solves() -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    plank, box = t2.Box(width=6.0, height=1.0), t2.Box(width=1.0, height=1.0)
    places = [(0.0, 1.5), (-2.0, 2.5), (0.0, 2.5), (2.0, 2.5), (2.0, 3.5), (0.0, 0.5)]
    for k, place in enumerate(places):
        scene.add_body(
            box if k else plank, mass=1.0 + k, position=place, friction=0.5, restitution=0.0
        )
    ground(scene, friction=0.5)
    sim = Simulator(scene, time_step=1 / 60)
    sim.step()
    world = sim._engine.world
    direct = world.direct
    assert direct.counts[tb.TREES] == 1
    assemble_matrix(0, world.constraints, direct)
    dense = dense_matrix(direct)
    size = len(places)
    assert dense.shape == (3 * size, 3 * size)
    truth = np.random.default_rng(1).normal(size=3 * size)
    direct.factors[:size, tb.CHANGE : tb.CHANGE + 3] = (dense @ truth).reshape(size, 3)
    assert factor(0, direct.sparse, direct.factors)
    substitute(0, direct.sparse, direct.factors)
    # in the sense of the matrix: what it hardly sees is not determined any better
    error = direct.factors[:size, tb.CHANGE : tb.CHANGE + 3].ravel() - truth
    assert np.abs(dense @ error).max() < 1e-13 * np.abs(dense).max() * np.abs(truth).max()
