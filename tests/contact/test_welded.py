"""Bodies that are welded together and meet another one at one point, or along a face of both."""

import math

import numpy as np
import pytest

import tamias2d as t2

HALVES = [((-0.3, -0.2), (0.3, -0.2), (0.3, 0.2)), ((-0.3, -0.2), (0.3, 0.2), (-0.3, 0.2))]
"""Triangles that a diagonal cuts out of a box: it has both their centres of mass on a line."""


def world(gravity: float = -9.81) -> t2.Scene:
    scene = t2.Scene(gravity=(0, gravity))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), restitution=0.8)
    return scene


def triangles(scene: t2.Scene, turn: float, restitution: tuple[float, float] = (0.8, 0.8)) -> None:
    """Add the box in two halves, with its centre at (0, 1)."""
    c, s = math.cos(turn), math.sin(turn)
    for vertices, each in zip(HALVES, restitution, strict=True):
        x, y = np.mean(vertices, axis=0)
        scene.add_body(
            t2.Polygon(vertices=[(u - x, v - y) for u, v in vertices]),
            mass=1.0,
            position=(c * x - s * y, 1 + s * x + c * y),
            orientation=turn,
            restitution=each,
        )
    scene.add_joint(t2.Weld(), 1, 2, at=(0, 1))


@pytest.mark.parametrize("turn", [math.atan2(2, 3) - 1.5, 0.4, -2.7])
def test_two_halves_of_a_box_fall_on_a_vertex_of_both_as_one(turn: float) -> None:
    whole, halves = world(), world()
    whole.add_body(
        t2.Box(width=0.6, height=0.4), mass=2.0, position=(0, 1), orientation=turn, restitution=0.8
    )
    triangles(halves, turn)
    method = t2.Dop853(rtol=1e-12)
    one = t2.simulate(whole, duration=1.0, times=[1.0], method=method)
    two = t2.simulate(halves, duration=1.0, times=[1.0], method=method)
    assert len(one.impacts) == len(two.impacts) > 0
    assert two.impacts.impulse == pytest.approx(one.impacts.impulse, rel=1e-9)
    assert two.orientation[0, 1] == pytest.approx(one.orientation[0, 1], abs=1e-9)
    centre = two.position[0, 1:].mean(axis=0)
    np.testing.assert_allclose(centre, one.position[0, 1], rtol=0, atol=1e-9)


def test_two_boxes_fall_flat_on_a_face_of_both() -> None:
    """They bounce as one body does: the speed turns round, by the restitution, without a turn."""
    scene = world()
    for x, mass in ((-0.2, 1.0), (0.2, 3.0)):
        box = t2.Box(width=0.4, height=0.2)
        scene.add_body(box, mass=mass, position=(x, 0.6), restitution=0.8)
    scene.add_joint(t2.Weld(), 1, 2, at=(0, 0.6))
    met = math.sqrt(2 * 0.5 / 9.81)
    run = t2.simulate(scene, duration=0.5, times=[0.5], method=t2.Dop853(rtol=1e-12))
    speed = 0.8 * 9.81 * met - 9.81 * (0.5 - met)
    np.testing.assert_allclose(run.velocity[0, 1:], [(0, speed)] * 2, rtol=0, atol=1e-10)
    np.testing.assert_allclose(run.angular_velocity[0, 1:], 0, atol=1e-10)
    assert run.impacts.impulse.sum() == pytest.approx(4 * 1.8 * 9.81 * met, rel=1e-12)


def test_a_disc_meets_the_vertex_of_both_halves_once() -> None:
    """It is elastic and comes along the diagonal, so that nothing turns: equal masses swap."""
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(t2.Disc(radius=0.1), mass=2.0, position=(3, 3), velocity=(-3, -2), restitution=1)
    triangles(scene, 0.0, (1.0, 1.0))
    run = t2.simulate(scene, duration=2.0, times=[2.0], method=t2.Dop853(rtol=1e-12))
    assert len(run.impacts) == 1
    np.testing.assert_allclose(run.velocity[0], [(0, 0), (-3, -2), (-3, -2)], rtol=0, atol=1e-11)


def test_halves_of_which_each_has_another_restitution_meet_by_a_rule() -> None:
    scene = world()
    triangles(scene, 0.4, (0.8, 0.5))
    run = t2.simulate(scene, duration=1.0, method=t2.Dop853(rtol=1e-12))
    assert any(note.startswith("rule: ") for note in run.notes)
    assert run.energy[-1] < run.energy[0] * (1 - 1e-3)


def test_halves_whose_weld_may_break_meet_by_a_rule() -> None:
    """From then on each of them would have an impulse of its own."""
    scene = world()
    for x in (-0.2, 0.2):
        scene.add_body(t2.Box(width=0.4, height=0.2), mass=1, position=(x, 0.6), restitution=0.8)
    scene.add_joint(t2.Weld(), 1, 2, at=(0, 0.6), break_force=1e3)
    run = t2.simulate(scene, duration=1.0, method=t2.Dop853(rtol=1e-12))
    assert any(note.startswith("rule: ") for note in run.notes)
    np.testing.assert_allclose(run.velocity[-1, 1], run.velocity[-1, 2], rtol=0, atol=1e-12)
