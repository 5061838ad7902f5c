"""Shapes against known solids, and against laws that hold for all of them."""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

from tamias2d.scene import Box, Disc, HalfPlane, Polygon, Scene


def ring(corners: int, radius: float = 1.0) -> list[tuple[float, float]]:
    turns = [2 * math.pi * k / corners for k in range(corners)]
    return [(radius * math.cos(turn), radius * math.sin(turn)) for turn in turns]


def test_inertia_of_known_solids() -> None:
    """Tables of any textbook: m r^2/2, m (w^2 + h^2)/12; right triangle with legs b, h."""
    assert Disc(radius=2).inertia(3) == 6
    assert Box(width=3, height=4).inertia(12) == 25
    assert Polygon(vertices=[(0, 0), (3, 0), (0, 4)]).inertia(18) == pytest.approx(25, rel=1e-15)
    side = math.sqrt(3)  # equilateral: m s^2/12
    assert Polygon(vertices=ring(3)).inertia(4) == pytest.approx(side**2 / 3, rel=1e-14)


def test_a_polygon_of_many_corners_is_nearly_a_disc() -> None:
    """The inertia of the inscribed polygon falls short by a term of order 1/n^2."""
    disc = Disc(radius=1).inertia(1)
    short = [disc - Polygon(vertices=ring(n)).inertia(1) for n in (100, 200)]
    assert 0 < short[1] < short[0]
    assert short[0] / short[1] == pytest.approx(4, rel=1e-3)


def test_a_polygon_is_stored_about_its_centroid() -> None:
    triangle = Polygon(vertices=[(1, 1), (4, 1), (1, 7)])
    assert triangle.centroid == pytest.approx((2, 3))
    assert np.array(triangle.vertices) == pytest.approx(np.array([(-1, -2), (2, -2), (-1, 4)]))
    assert triangle.bounding_radius == pytest.approx(math.sqrt(17))


def test_the_sense_of_the_outline_does_not_matter() -> None:
    corners = [(0, 0), (4, 0), (5, 2), (1, 3)]
    one, other = Polygon(vertices=corners), Polygon(vertices=corners[::-1])
    assert {(round(x, 12), round(y, 12)) for x, y in one.vertices} == {
        (round(x, 12), round(y, 12)) for x, y in other.vertices
    }
    for shape in (one, other):
        x, y = np.array(shape.vertices).T
        assert np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y) > 0


@given(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6), st.floats(0, 7))
def test_inertia_does_not_depend_on_where_the_outline_was_drawn(
    x: float, y: float, turn: float
) -> None:
    corners = np.array([(0, 0), (4, 0), (5, 2), (1, 3)])
    rotation = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
    there = Polygon(vertices=corners @ rotation.T + (x, y))
    here = Polygon(vertices=corners)
    assert there.inertia(2.0) == pytest.approx(here.inertia(2.0), rel=1e-8)
    assert there.bounding_radius == pytest.approx(here.bounding_radius, rel=1e-8)


def test_a_box_is_a_polygon() -> None:
    box = Box(width=3, height=2)
    same = Polygon(vertices=box.vertices)
    assert same.vertices == box.vertices
    assert same.inertia(5) == pytest.approx(box.inertia(5), rel=1e-15)


def test_a_half_plane_has_a_unit_normal() -> None:
    wall = HalfPlane(normal=(3, -4), offset=2)
    assert wall.normal == (0.6, -0.8)
    assert HalfPlane(normal=wall.normal, offset=2) == wall


def test_arrays_and_numpy_numbers_are_taken() -> None:
    scene = Scene(gravity=np.array([0, -10]))
    k = scene.add_body(Disc(radius=np.float32(0.5)), mass=np.int64(2), position=np.zeros(2))
    body = scene.bodies[k]
    assert (body.mass, body.position, body.inertia) == (2.0, (0.0, 0.0), 0.25)
    assert all(type(value) is float for value in (body.mass, *body.position, *scene.gravity))


def test_what_cannot_be_moved_has_no_inverse_mass() -> None:
    scene = Scene(gravity=(0, 0))
    floor = scene.add_static(Box(width=1, height=1))
    particle = scene.add_body(None, mass=4, position=(0, 0))
    assert (scene.bodies[floor].inverse_mass, scene.bodies[floor].inverse_inertia) == (0, 0)
    assert (scene.bodies[particle].inverse_mass, scene.bodies[particle].inverse_inertia) == (
        0.25,
        0,
    )


def test_restitution_of_a_pair() -> None:
    """The pair's own value first, then the smaller of both, then the only one (DD17)."""
    scene = Scene(gravity=(0, 0))
    for k, value in enumerate((0.9, 0.4, None)):
        scene.add_body(Disc(radius=1), mass=1, position=(5.0 * k, 0), restitution=value)
    assert scene.restitution(0, 1) == scene.restitution(1, 0) == 0.4
    assert scene.restitution(0, 2) == 0.9
    scene.set_restitution("body1", 0, 0.7)
    assert scene.restitution(0, 1) == scene.restitution(1, 0) == 0.7
