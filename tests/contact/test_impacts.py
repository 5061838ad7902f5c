"""Impacts against exact answers: oracles B1 to B4, B8 and B11."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.contact.manifold import Contact
from tamias2d.contact.response import after_impulse, impulses
from tamias2d.state import State


def at_rest_scene() -> t2.Scene:
    return t2.Scene(gravity=(0.0, 0.0))


def test_oblique_pair_with_lever_arms():
    """B1, worked out by hand from the lever-arm formula."""
    cores = [
        SimpleNamespace(dynamic=True, inverse_mass=1 / 2, inverse_inertia=2.0),
        SimpleNamespace(dynamic=True, inverse_mass=1.0, inverse_inertia=5.0),
    ]
    a = State((0.0, 0.0), 0.0, (1.0, 0.5), 2.0)
    b = State((0.0, 0.0), 0.0, (-1.0, -0.25), -3.0)
    contact = Contact(
        0, 1, (0.6, 0.8), (0.3, -0.4), (-0.2, 0.5), (0.0, 0.0), None, None, (False, 0)
    )
    (impulse,) = impulses(cores, [contact], a, b, 0.7)
    assert impulse == pytest.approx(0.7771299854246722, rel=1e-15)
    a, b = after_impulse(cores, contact, impulse, a, b)
    assert a.velocity == pytest.approx((0.7668610043725983, 0.18914800583013114), rel=1e-14)
    assert b.velocity == pytest.approx((-0.5337220087451967, 0.3717039883397377), rel=1e-14)
    assert a.angular_velocity == pytest.approx(1.253955213992315, rel=1e-14)
    assert b.angular_velocity == pytest.approx(-4.787398966476745, rel=1e-14)


@pytest.mark.parametrize("ratio", [1e-12, 1e-3, 0.1, 1.0, 10.0, 1e6, 1e12])
@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
def test_central_impact_at_any_mass_ratio(ratio, restitution):
    """B2: v1' = (R - e)/(R + 1), v2' = R (1 + e)/(R + 1)."""
    scene = at_rest_scene()
    disc = t2.Disc(radius=0.5)
    scene.add_body(disc, mass=ratio, position=(-2, 0), velocity=(1, 0), restitution=restitution)
    scene.add_body(disc, mass=1, position=(0, 0))
    run = t2.simulate(scene, duration=2.0)
    first, second = run.velocity[-1, :, 0]
    assert len(run.impacts) == 1
    assert run.impacts.time[0] == pytest.approx(1.0, rel=1e-15)
    exact = (ratio - restitution) / (ratio + 1)
    assert first == pytest.approx(exact, rel=1e-14, abs=3e-16)
    assert second == pytest.approx(ratio * (1 + restitution) / (ratio + 1), rel=1e-14)


@pytest.mark.parametrize(
    ("mass", "restitution", "first", "second"),
    [
        (1.0, 1.0, (0.25, 0.4330127018922193), (0.75, -0.4330127018922193)),
        (3.0, 0.5, (0.15625, 0.4871392896287467), (0.28125, -0.16237976320958222)),
    ],
)
def test_oblique_discs(mass, restitution, first, second):
    """B3: equal elastic discs part at a right angle."""
    scene = at_rest_scene()
    disc = t2.Disc(radius=0.5)
    scene.add_body(disc, mass=1, position=(-3, 0), velocity=(1, 0), restitution=restitution)
    scene.add_body(disc, mass=mass, position=(0, -0.5))
    run = t2.simulate(scene, duration=4.0)
    np.testing.assert_allclose(run.velocity[-1], [first, second], rtol=0, atol=2e-15)


def test_spinning_square_hits_floor():
    """B4: a corner of a turning square, without and with gravity to the same instant."""
    angle, early = math.radians(30), 0.25
    low = 0.5 * (math.cos(angle) + math.sin(angle))
    scene = at_rest_scene()
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0))
    scene.add_body(
        t2.Box(width=1, height=1),
        mass=1,
        position=(-0.5 * early, low + 3 * early),
        velocity=(0.5, -3),
        orientation=angle - 4 * early,
        angular_velocity=4,
        restitution=0.8,
    )
    run = t2.simulate(scene, duration=0.3)
    assert run.impacts.time[0] == pytest.approx(early, abs=1e-15)
    assert run.impacts.impulse[0] == pytest.approx(5.593592507286775, rel=1e-14)
    np.testing.assert_allclose(run.velocity[-1, 1], (0.5, 2.5935925072867754), rtol=1e-14)
    assert run.angular_velocity[-1, 1] == pytest.approx(-2.14219086825576, rel=1e-13)
    assert run.energy[-1] == pytest.approx(3.870776190, abs=1e-9)


@pytest.mark.parametrize(("power", "count"), [(0, 3), (1, 31), (2, 314), (3, 3141)])
def test_galperin_counts_pi(power, count):
    """B8: digits of pi, and the last speeds in closed form."""
    scene = at_rest_scene()
    disc = t2.Disc(radius=0.1)
    heavy = 100.0**power
    scene.add_static(t2.HalfPlane(normal=(1, 0), offset=0))
    scene.add_body(disc, mass=1, position=(1, 0), restitution=1)
    scene.add_body(disc, mass=heavy, position=(2, 0), velocity=(-1, 0), restitution=1)
    run = t2.simulate(scene, duration=20.0, times=[0.0, 20.0])
    assert len(run.impacts) == count
    angle = math.atan(10.0**-power)
    turned = (count + 1) * angle - math.pi if count % 2 else math.pi - count * angle
    assert run.velocity[-1, 2, 0] == pytest.approx(math.cos(turned), abs=1e-12)
    assert run.velocity[-1, 1, 0] == pytest.approx(
        math.sqrt(heavy) * math.sin(turned), abs=1e-9 * math.sqrt(heavy)
    )
    assert run.energy[-1] == pytest.approx(run.energy[0], rel=1e-12)


@pytest.mark.parametrize(
    ("depth", "tolerance"), [(1e-2, 1e-12), (1e-6, 1e-9), (1e-8, 1e-7), (1e-10, 1e-5)]
)
def test_grazing_discs(depth, tolerance):
    """B11: seen however little they overlap; the tolerance is how ill-posed the question is."""
    scene = at_rest_scene()
    disc = t2.Disc(radius=0.5)
    scene.add_body(disc, mass=1, position=(-3, 0), velocity=(1, 0), restitution=1)
    scene.add_static(disc, position=(0, depth - 1))
    run = t2.simulate(scene, duration=6.0)
    approach = math.sqrt(depth * (2 - depth))
    assert -run.impacts.normal_velocity == pytest.approx(approach, rel=tolerance)
    turned = math.atan2(run.velocity[-1, 0, 1], run.velocity[-1, 0, 0])
    assert turned == pytest.approx(2 * math.asin(approach), rel=tolerance)


def test_discs_that_miss_by_little_do_not_touch():
    scene = at_rest_scene()
    disc = t2.Disc(radius=0.5)
    scene.add_body(disc, mass=1, position=(-3, 0), velocity=(1, 0), restitution=1)
    scene.add_static(disc, position=(0, -1 - 1e-12))
    assert len(t2.simulate(scene, duration=6.0).impacts) == 0


def test_boxes_head_on_do_not_spin():
    """Both ends of the common side answer alike, to the bit."""
    scene = at_rest_scene()
    box = t2.Box(width=1, height=1)
    scene.add_body(box, mass=1, position=(-3, 0), velocity=(1, 0), restitution=0.5)
    scene.add_body(box, mass=1, position=(3, 0), velocity=(-1, 0))
    run = t2.simulate(scene, duration=6.0)
    assert run.angular_velocity[-1].tolist() == [0.0, 0.0]
    assert run.velocity[-1].tolist() == [[-0.5, 0.0], [0.5, 0.0]]
    assert len(run.impacts) == 2
    assert run.impacts.impulse[0] == run.impacts.impulse[1]


def test_shifted_boxes_head_on_turn_alike():
    """Only part of the sides meets: angular momentum and energy say how both turn."""
    scene = at_rest_scene()
    box = t2.Box(width=1, height=1)
    scene.add_body(box, mass=1, position=(-3, 0.25), velocity=(1, 0), restitution=1)
    scene.add_body(box, mass=1, position=(3, -0.25), velocity=(-1, 0))
    run = t2.simulate(scene, duration=4.0)
    first, second = run.angular_velocity[-1]
    assert first == second
    assert first != 0
    assert run.energy[-1] == pytest.approx(run.energy[0], rel=1e-14)
    np.testing.assert_allclose(run.angular_momentum, run.angular_momentum[0], rtol=1e-14)


@pytest.mark.parametrize("speed", [1e1, 1e3, 1e6])
def test_no_tunnelling(speed):
    """X4: through a thin wall, at any speed, whether it can move or not."""
    for mass in (None, 1e3):
        scene = at_rest_scene()
        scene.add_body(
            t2.Disc(radius=0.1), mass=1, position=(0, 0), velocity=(speed, 0), restitution=1
        )
        wall = t2.Box(width=0.02, height=2)
        if mass is None:
            scene.add_static(wall, position=(5, 0))
        else:
            scene.add_body(wall, mass=mass, position=(5, 0))
        run = t2.simulate(scene, duration=10 / speed)
        assert len(run.impacts) == 1
        exact = -speed if mass is None else speed * (1 - mass) / (1 + mass)
        assert run.velocity[-1, 0, 0] == pytest.approx(exact, rel=1e-12)


@pytest.mark.parametrize("scale", [2.0**-40, 2.0**-20, 2.0**20])
def test_scaled_scenes_are_the_same_to_the_bit(scale):
    """X6: nothing in the search for impacts has a size of its own."""

    def states(size: float) -> np.ndarray:
        scene = t2.Scene(gravity=(0, -8 * size))
        scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0))
        scene.add_body(
            t2.Box(width=size, height=0.5 * size),
            mass=1,
            position=(0, 3 * size),
            orientation=0.5,
            angular_velocity=2,
            restitution=0.9,
        )
        run = t2.simulate(scene, duration=5.0)
        assert len(run.impacts) > 2
        return run.position / size

    assert np.array_equal(states(1.0), states(scale))


def test_a_particle_is_passed_through() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    disc = t2.Disc(radius=0.2)
    scene.add_body(disc, mass=1.0, position=(0.0, 0.0), velocity=(1.0, 0.0), restitution=1.0)
    scene.add_body(None, mass=1.0, position=(1.0, 0.05), name="dust")
    scene.add_body(disc, mass=1.0, position=(5.0, 0.0), restitution=1.0)
    run = t2.simulate(scene, duration=2.0)
    assert len(run.impacts) == 0
    assert run.velocity[-1].tolist() == [[1.0, 0.0], [0.0, 0.0], [0.0, 0.0]]
