"""Shapes against known solids, and against laws that hold for all of them."""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

from tamias2d.errors import InputError
from tamias2d.scene import Box, Capsule, Compound, Disc, HalfPlane, Part, Polygon, Scene, Segment


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
    assert HalfPlane(normal=(3, -4), offset=0).normal == (0.6, -0.8)
    typed = HalfPlane(normal=(0.707, 0.707), offset=2)
    assert math.hypot(*typed.normal) == pytest.approx(1.0, abs=1e-15)
    assert HalfPlane(normal=typed.normal, offset=2) == typed


def test_an_offset_of_a_normal_that_is_no_unit_vector_is_refused() -> None:
    """It could be a distance, or the right side of `normal . p <= offset`."""
    with pytest.raises(InputError, match=r"length 5 .* offset of 2 m.* Give \(0.6, -0.8\)"):
        HalfPlane(normal=(3, -4), offset=2)


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


def second_moment(shape: Capsule | Compound, points: np.ndarray) -> tuple[float, np.ndarray, float]:
    """Area, centre and inertia per mass of what holds points: sums over a fine grid."""
    size = shape.bounding_radius
    step = 2 * size / points
    line = -size + step * (np.arange(points) + 0.5)
    x, y = (axis.ravel() for axis in np.meshgrid(line, line))
    count = sum(within(part, x, y).astype(float) for part in parts_of(shape))
    area = count.sum() * step**2
    center = np.array([(count * x).sum(), (count * y).sum()]) / count.sum()
    return area, center, float((count * (x**2 + y**2)).sum() / count.sum())


def parts_of(shape: Capsule | Compound) -> tuple[Part, ...]:
    return shape.pieces if isinstance(shape, Compound) else (Part(shape=shape),)


def within(part: Part, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Which points are in a part, from its definition: near a line, or inside of all sides."""
    c, s = math.cos(part.orientation), math.sin(part.orientation)
    p, q = part.position
    u, v = c * (x - p) + s * (y - q), -s * (x - p) + c * (y - q)
    match part.shape:
        case Disc(radius=radius):
            return u**2 + v**2 <= radius**2
        case Capsule(length=length, radius=radius):
            along = np.clip(u, -length / 2, length / 2)
            return (u - along) ** 2 + v**2 <= radius**2
        case Box(width=width, height=height):
            return (abs(u) <= width / 2) & (abs(v) <= height / 2)
    raise TypeError(part)


@pytest.mark.parametrize(("length", "radius"), [(2, 0.3), (0.1, 1), (1, 1), (5, 1)])
def test_area_and_inertia_of_a_capsule_by_counting_points(length: float, radius: float) -> None:
    capsule, points = Capsule(length=length, radius=radius), 1500
    area, center, moment = second_moment(capsule, points)
    rim = 2 * length + 2 * math.pi * radius
    off = rim * capsule.bounding_radius / points / area  # half a cell along the whole rim
    assert capsule.area == pytest.approx(area, rel=off)
    assert center == pytest.approx((0, 0), abs=1e-9)
    assert capsule.inertia(3) == pytest.approx(3 * moment, rel=2 * off)


def test_a_capsule_lies_between_a_disc_and_a_segment() -> None:
    """Without length it is a disc, and without thickness a rod: m L^2/12 of any textbook."""
    disc, rod = Disc(radius=2).inertia(3), Segment(length=6).inertia(2)
    assert rod == 6
    assert Capsule(length=1e-9, radius=2).inertia(3) == pytest.approx(disc, rel=1e-8)
    assert Capsule(length=6, radius=1e-9).inertia(2) == pytest.approx(rod, rel=1e-8)


def test_several_parts_by_counting_points() -> None:
    parts = [
        Part(shape=Box(width=2, height=0.5), position=(3, 1), orientation=0.4),
        Part(shape=Disc(radius=0.6), position=(5, 2)),
        Part(shape=Capsule(length=1, radius=0.2), position=(3.5, 2), orientation=-1.1),
    ]
    body = Compound(parts=parts)
    area, center, moment = second_moment(body, 1500)
    assert body.area == pytest.approx(area, rel=1e-3)
    assert center == pytest.approx((0, 0), abs=2e-3)
    assert body.inertia(7) == pytest.approx(7 * moment, rel=1e-3)
    drawn = np.array([part.position for part in body.parts])
    kept = np.array([piece.position for piece in body.pieces])
    assert drawn - kept == pytest.approx(np.tile(body.centroid, (3, 1)))


@given(st.floats(0.1, 0.9), st.floats(0, 7), st.floats(-9, 9))
def test_a_box_cut_in_two_is_the_box(cut: float, turn: float, x: float) -> None:
    c, s = math.cos(turn), math.sin(turn)
    halves = [
        Part(shape=Box(width=w, height=2), position=(x + c * at, s * at), orientation=turn)
        for w, at in ((3 * cut, 1.5 * cut), (3 - 3 * cut, 1.5 * (1 + cut)))
    ]
    whole, body = Box(width=3, height=2), Compound(parts=halves)
    assert body.area == pytest.approx(whole.area)
    assert body.inertia(2) == pytest.approx(whole.inertia(2), rel=1e-12)
    assert body.centroid == pytest.approx((x + c * 1.5, s * 1.5), abs=1e-12)
    assert body.bounding_radius == pytest.approx(whole.bounding_radius)


def test_a_frame_of_segments_weighs_by_their_lengths() -> None:
    """A square of four rods: each m/4 (L^2/12 + L^2/4), together m L^2/3."""
    turns = [0, math.pi / 2]
    sides = [((0, 1), 0), ((0, -1), 0), ((1, 0), 1), ((-1, 0), 1)]
    frame = Compound(
        parts=[Part(shape=Segment(length=2), position=at, orientation=turns[k]) for at, k in sides]
    )
    assert frame.area == 0
    assert frame.centroid == (0, 0)
    assert frame.inertia(6) == pytest.approx(8)


def test_friction_of_a_pair() -> None:
    """The pair's own value first, then the mean of both, then the only one, then none (DD23)."""
    scene = Scene(gravity=(0, 0))
    for k, value in enumerate((0.9, 0.4, None, None, 0.0)):
        scene.add_body(Disc(radius=1), mass=1, position=(5.0 * k, 0), friction=value)
    assert scene.friction(0, 1) == scene.friction(1, 0) == pytest.approx(0.6)
    assert scene.friction(0, 2) == scene.friction(2, 0) == 0.9
    assert scene.friction(2, 3) == scene.friction(4, 0) == scene.friction(2, 4) == 0
    scene.set_friction("body1", 0, 1.7)
    assert scene.friction(0, 1) == scene.friction(1, 0) == 1.7
    assert scene.friction_of_pairs == {(0, 1): 1.7}


def test_a_kinematic_body_has_no_inverse_mass_and_keeps_its_velocity() -> None:
    scene = Scene(gravity=(0, -10))
    k = scene.add_kinematic(Box(width=1, height=1), position=(1, 2), velocity=(3, 4))
    body = scene.bodies[k]
    assert (body.dynamic, body.kinematic, body.static) == (False, True, False)
    assert (body.inverse_mass, body.inverse_inertia, body.velocity) == (0, 0, (3, 4))
