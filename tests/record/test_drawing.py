"""Lines, views and words of a recording, against geometry that is known without it."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.record import document, drawing

from .conftest import with_impacts


def area(line: np.ndarray) -> float:
    (x0, y0), (x1, y1) = line[:-1].T, line[1:].T
    return float((x0 * y1 - x1 * y0).sum() / 2)


def test_outlines_enclose_their_shapes(run: t2.Run) -> None:
    disc, _, box, triangle, speck, _ = run.scene.bodies
    for body, whole in ((disc, math.pi * 0.3**2), (box, 0.5), (triangle, 0.5)):
        (rim,) = drawing.outlines(body)
        assert area(rim) == pytest.approx(whole, rel=2e-3)
    assert drawing.outlines(speck) == []


def test_each_piece_of_a_body_has_its_outline() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    capsule = t2.Capsule(length=2.0, radius=0.5)
    parts = [
        t2.Part(shape=capsule, position=(0.0, 3.0), orientation=math.pi / 2),
        t2.Part(shape=t2.Segment(length=1.0), position=(0.0, -1.0)),
    ]
    scene.add_kinematic(t2.Compound(parts=parts), position=(1.0, 1.0))
    scene.add_body(capsule, mass=1.0, position=(9.0, 0.0), sensor=True)
    body, sensor = scene.bodies
    rim, line = drawing.outlines(body)
    assert area(rim) == pytest.approx(capsule.area, rel=2e-3)
    assert rim.mean(axis=0) == pytest.approx((0.0, 0.0), abs=0.05)  # the segment weighs nothing
    assert np.ptp(rim, axis=0) == pytest.approx((1.0, 3.0), rel=2e-3)
    assert line == pytest.approx(np.array([(-0.5, -4.0), (0.5, -4.0), (-0.5, -4.0)]))
    view = drawing.View(center=(0.0, 0.0), half=(1.0, 1.0))
    look = drawing.look(body, view, balls=True)
    ((ends, half),) = look.bands
    assert half == 0.5
    assert np.ptp(ends, axis=0) == pytest.approx((0.0, 2.0))
    assert [radius for _, radius in look.discs] == [0.5, 0.5]
    assert np.array([center for center, _ in look.discs]) == pytest.approx(ends)
    empty = drawing.look(sensor, view)
    assert [empty.discs, empty.bands, empty.areas] == [[], [], []]
    *_, spoke = empty.lines
    assert spoke[1] == pytest.approx((1.5, 0.0), abs=2e-3)


def test_a_sensor_has_dashes_and_no_solid_line() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(t2.Disc(radius=1.0), position=(0.0, 1.0), sensor=True)
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), sensor=True)
    scene.add_kinematic(t2.Chain(vertices=[(0, 0), (4, 0)]), position=(0, 0), sensor=True)
    view = drawing.View(center=(0.0, 0.0), half=(3.0, 2.0))
    disc, edge, chain = (drawing.strokes(body, view) for body in scene.bodies)
    assert np.hypot(*np.array(disc).reshape(-1, 2).T) == pytest.approx(1.0, rel=2e-3)
    for dashes, whole in ((disc, 2 * math.pi), (edge, 6 * view.reach), (chain, 4.0)):
        assert {dash.shape for dash in dashes} == {(2, 2)}
        drawn = sum(float(np.hypot(*(end - start))) for start, end in dashes)
        assert drawn == pytest.approx(whole / 2, rel=5e-3)
        assert len(dashes) >= 8


def test_a_line_that_is_solid_from_one_side_has_ticks_where_the_ground_is() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    for one_sided in (True, False):
        scene.add_static(t2.Chain(vertices=[(4, 1), (0, 0), (-4, 1)], one_sided=one_sided))
    view = drawing.View(center=(0.0, 0.0), half=(4.0, 3.0))
    ground, line = (drawing.strokes(body, view) for body in scene.bodies)
    assert len(line) == 1
    assert len(ground) > 8
    for foot, end in ground[1:]:
        assert foot[1] == pytest.approx(abs(foot[0]) / 4)  # on the line
        assert end[1] < abs(end[0]) / 4  # below it: one stands above


def test_the_spoke_of_a_disc_points_along_its_x_axis(run: t2.Run) -> None:
    _, spoke = drawing.strokes(run.scene.bodies[0], drawing.view_of(run))
    assert spoke[0] == pytest.approx((0, 0))
    assert spoke[1] == pytest.approx((0.3, 0.0), abs=1e-3)


def test_the_view_holds_every_body_at_all_times(run: t2.Run) -> None:
    view = drawing.view_of(run)
    for index, body in enumerate(run.scene.bodies):
        if body.name != "floor":
            reach = body.shape.bounding_radius if body.shape else 0.0
            off = np.abs(run.position[:, index] - view.center) + reach
            assert np.all(off <= view.half), body.name


def test_the_view_of_nothing_has_a_size() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(1e6, 2.0))
    view = drawing.view_of(t2.simulate(scene, duration=1.0))
    assert view.center == (1e6, 2.0)
    assert view.reach > 0.1


@pytest.mark.parametrize("angle", [0.0, 1.0, -2.0])
def test_the_ground_lies_on_its_line_and_its_hatching_below(angle: float) -> None:
    normal = (-math.sin(angle), math.cos(angle))
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(t2.HalfPlane(normal=normal, offset=-0.5))
    view = drawing.View(center=(3.0, 4.0), half=(1.0, 2.0))
    edge, *hatches = drawing.strokes(scene.bodies[0], view)
    assert edge @ normal == pytest.approx(-0.5)
    assert np.hypot(*(edge[1] - edge[0])) == pytest.approx(6 * view.reach)
    assert all(hatch[0] @ normal == pytest.approx(-0.5) for hatch in hatches)
    assert all(hatch[1] @ normal < -0.5 for hatch in hatches)


@pytest.mark.parametrize(
    ("length", "rounded"), [(1.0, 1.0), (1.99, 1.0), (0.3, 0.2), (7e5, 5e5), (5e-4, 5e-4)]
)
def test_round_lengths(length: float, rounded: float) -> None:
    assert drawing.round_length(length) == pytest.approx(rounded)


def test_about_tells_the_run(run: t2.Run) -> None:
    text = document.about(with_impacts(run))
    for words in ("# throw", "Things in the air.", "ClosedForm()", "3 impacts", "9.81", *run.notes):
        assert words in text
    assert "| red ball / 1 | Disc | 1 kg | 0.045 kg m² |" in text
    assert "| floor | HalfPlane | static | static |" in text


def test_models_have_their_equations() -> None:
    text = document.models()
    for words in ("## IM1 ", "## IM2 ", "## IM3 ", "acceleration = gravity + force/mass"):
        assert words in text


def test_an_impact_in_words(run: t2.Run) -> None:
    assert document.impact_line(with_impacts(run), 0) == (
        "0.0333333 s: red ball / 1 meets floor at (0.3333, 0.3333) m, approaching at 1 m/s, "
        "impulse 1 N s"
    )


def test_the_view_holds_the_points_at_which_bodies_without_shape_are_held() -> None:
    """A rod that hangs from its upper end, and a spring at the lower one."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    rod = scene.add_body(None, mass=1.0, inertia=0.1, position=(0.0, -1.0))
    scene.add_joint(t2.Revolute(), (0.0, 0.0), rod, at=(0.0, 0.0))
    scene.add_spring(rod, (0.0, -2.5), stiffness=1.0, rest_length=0.5, anchor=(0.0, -1.0))
    run = t2.simulate(scene, duration=0.1, times=[0.0, 0.1])
    for points in ((0.0, 0.0), (0.0, -2.0), (0.0, -2.5)):
        view = drawing.view_of(run)
        assert np.all(np.abs(np.array(points) - view.center) <= view.half)
    mill = t2.Scene(gravity=(0.0, 0.0))
    mill.add_body(None, mass=1.0, inertia=0.1, position=(0.0, 0.0), angular_velocity=np.pi)
    mill.add_spring(0, (9.0, 0.0), stiffness=1e-9, rest_length=0.0, anchor=(3.0, 0.0))
    view = drawing.view_of(t2.simulate(mill, duration=1.0, times=np.linspace(0.0, 1.0, 21)))
    assert view.center[0] - view.half[0] < -3.0 < 3.0 < view.center[1] + view.half[1]
