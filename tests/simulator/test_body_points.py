"""Points of bodies are where turning and shifting put them, and move as a step moves them."""

import numpy as np
import pytest

import tamias2d as t2


def thrown(count: int) -> t2.Simulator:
    random = np.random.default_rng(4)
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), time_step=1e-6)
    sim.add(
        t2.Box(width=0.1, height=0.2),
        mass=1.0,
        position=np.column_stack((9.0 * np.arange(count), random.normal(size=count))),
        orientation=random.uniform(-9.0, 9.0, count),
        velocity=random.normal(size=(count, 2)),
        angular_velocity=random.normal(size=count),
        restitution=0.0,
        name=[f"box {k}" for k in range(count)],
    )
    return sim


def test_a_quarter_turn_is_known() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    rod = sim.add(
        t2.Box(width=2.0, height=0.1),
        mass=1.0,
        position=(3.0, 1.0),
        orientation=np.pi / 2,
        velocity=(1.0, 0.0),
        angular_velocity=2.0,
        restitution=0.0,
    )
    tip = sim.to_world(rod, (1.0, 0.25))
    assert tip.shape == (2,)
    assert tip.tolist() == pytest.approx([2.75, 2.0], abs=1e-15)
    assert sim.to_local(rod, tip).tolist() == pytest.approx([1.0, 0.25], abs=1e-15)
    assert sim.velocity_at(rod, tip).tolist() == pytest.approx([-1.0, -0.5], abs=1e-15)


def test_points_go_to_the_world_and_back_and_move_as_told() -> None:
    sim = thrown(50)
    points = np.random.default_rng(5).normal(size=(50, 2))
    rows = np.arange(50)
    before = sim.to_world(rows, points)
    np.testing.assert_allclose(sim.to_local(rows, before), points, rtol=0, atol=1e-13)
    speed = sim.velocity_at(rows, before)
    sim.step()
    moved = (sim.to_world(rows, points) - before) / sim.time_step
    # the path bends by half of |arm| w^2 dt, and places of 450 m are known to 6e-14 m
    np.testing.assert_allclose(moved, speed, rtol=0, atol=1e-4)


def test_one_and_many_agree() -> None:
    sim = thrown(6)
    points = np.random.default_rng(6).normal(size=(6, 2))
    for ask in (sim.to_world, sim.to_local, sim.velocity_at):
        each = [ask(k, point).tolist() for k, point in enumerate(points)]
        assert ask(range(6), points).tolist() == each  # type: ignore[arg-type]
        assert ask([f"box {k}" for k in range(6)], points).tolist() == each
        of_one = [ask("box 2", point).tolist() for point in points]
        assert ask("box 2", points).tolist() == of_one
        assert ask([2], points).tolist() == of_one
        assert ask([2, 2], points[0]).tolist() == [of_one[0]] * 2
        assert ask(2, points[:1]).shape == (1, 2)
        assert ask([2], points[0]).shape == (1, 2)
        assert ask(2, points[:0]).shape == (0, 2)
        assert ask([], points[0]).shape == (0, 2)


@pytest.mark.parametrize(
    ("bodies", "points", "says"),
    [
        (9, (0.0, 0.0), "has none such"),
        (0, (0.0, np.nan), r"points\[0\]\[1\] of the bodies: found nan"),
        (0, (0.0, 0.0, 0.0), r"points of the bodies: found an array of shape \(3,\)"),
        ([0, 1], [(0.0, 0.0)] * 3, r"points of the bodies: found an array of shape \(3, 2\)"),
        (0, "here", "points of the bodies: found 'here'"),
    ],
)
def test_bad_points_are_refused(bodies: object, points: object, says: str) -> None:
    sim = thrown(2)
    for ask in (sim.to_world, sim.to_local, sim.velocity_at):
        with pytest.raises(t2.InputError, match=says):
            ask(bodies, points)  # type: ignore[arg-type]
