"""Ground that is moved and turned by hand between steps is where it is, for whatever asks."""

import math
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tests.engine.scenes import plain

G = 9.81
SMOOTH: dict[str, Any] = {"restitution": 0.0, "friction": 0.0}


def ground(**settings: Any) -> t2.Simulator:
    """A box of 1 m on a half-plane."""
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SMOOTH)
    scene.add_body(t2.Box(width=1.0, height=1.0), mass=1.0, position=(0.0, 0.5), **SMOOTH)
    return plain(scene, **settings)


@pytest.mark.parametrize("angle", [0.1, -0.2])
def test_a_box_slides_down_a_half_plane_that_was_turned_below_it(angle: float) -> None:
    sim = ground()
    sim.step(10)
    sim.orientation[0] = sim.orientation[1] = angle
    along, out = np.array([math.cos(angle), math.sin(angle)]), np.array([-math.sin(angle), 0.0])
    sim.position[1] = 0.5 * np.array([out[0], math.cos(angle)])
    sim.step(60)
    assert sim.velocity[1] @ along == pytest.approx(-G * math.sin(angle), rel=1e-6)
    height = sim.position[1] @ (-math.sin(angle), math.cos(angle))
    assert height == pytest.approx(0.5, abs=1e-3)
    assert sim.orientation[1] == pytest.approx(angle, abs=1e-6)


def test_a_half_plane_that_is_turned_back_is_as_it_was() -> None:
    sim, still = ground(), ground()
    for angle in (0.3, 0.0):
        sim.orientation[0] = angle
        sim.velocity[1] = 0.0, 50.0
        sim.position[1] = 0.0, 9.0
        sim.step(2)
    for one in (sim, still):
        one.position[1], one.velocity[1], one.orientation[1] = (0.0, 0.6), (1.0, 0.0), 0.0
        one.step(40)
    np.testing.assert_array_equal(sim.velocity[1], still.velocity[1])


def test_what_sleeps_on_ground_that_is_turned_wakes() -> None:
    sim = ground(sleeping=True)
    sim.step(60)
    assert sim.asleep[1]
    sim.orientation[0] = -0.1
    sim.step(30)
    assert not sim.asleep[1]
    assert sim.velocity[1, 0] > 0.1


@pytest.mark.parametrize("place", [(0.0, 0.0), (1.0, -2.0)])
@pytest.mark.parametrize("angle", [0.0, 0.5, 2.0])
def test_rays_points_and_boxes_find_a_half_plane_where_it_is(
    angle: float, place: tuple[float, float]
) -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.5), **SMOOTH)
    sim = plain(scene)
    sim.position[0], sim.orientation[0] = place, angle
    normal = np.array([-math.sin(angle), math.cos(angle)])
    side = np.array(place) + 0.5 * normal
    hit = sim.ray_cast(tuple(side + 3.0 * normal), tuple(side - 1.0 * normal))
    np.testing.assert_allclose(hit.point[0], side, atol=1e-12)
    np.testing.assert_allclose(hit.normal[0], normal, atol=1e-12)
    for depth, found in ((1e-6, [0]), (-1e-6, [])):
        point = side - depth * normal
        assert sim.at_point(tuple(point)).tolist() == found
        corner = np.sign(normal) * 0.1  # of the box, the one that is lowest
        low = np.minimum(point, point + 2 * corner)
        assert sim.in_box(tuple(low), tuple(low + 0.2)).tolist() == found
