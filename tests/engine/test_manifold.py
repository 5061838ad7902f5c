"""Manifolds against exhaustive search, and under changes that keep or move them."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase import polygon
from tamias2d.engine.narrow_phase.clip import PARALLEL
from tamias2d.engine.narrow_phase.collide import collide
from tamias2d.engine.tables import Contacts, Shapes
from tamias2d.kernels import Library
from tamias2d.kernels.arrays import FloatRows
from tamias2d.kernels.groups import addresses
from tests.engine.cores import (
    Contact,
    Outline,
    box,
    capsule,
    contact_arrays,
    disc,
    half_plane,
    outside,
    regular,
    separation,
    shape_arrays,
    turn,
)

SHAPES = [
    disc(0.4),
    disc(0.3, at=(0.2, -0.1)),
    capsule(1.5, 0.25),
    capsule(2.0),
    capsule(0.7, 1.0),
    box(1.0, 1.0),
    box(2.0, 0.3),
    regular(3, 0.8),
    regular(5, 0.7),
    Outline(np.array([[-1.0, -0.5], [1.0, -0.5], [0.3, 0.5], [-0.3, 0.5]])),
    Outline(np.array([[-0.4, -0.4], [0.4, -0.5], [0.5, 0.4], [-0.3, 0.4]]), 0.1),
]
ROUND = 1e-12  # what rounding does to lengths near 1
ANGLES = st.floats(-7, 7)
PLACES = st.tuples(st.floats(-2.5, 2.5), st.floats(-2.5, 2.5)).map(np.array)
shapes = st.sampled_from(SHAPES)


@st.composite
def placed(draw: st.DrawFn) -> tuple[Outline, Outline, np.ndarray]:
    a, b = draw(shapes), draw(shapes)
    return a.turned(draw(ANGLES)), b.turned(draw(ANGLES)), draw(PLACES)


@st.composite
def plainly_placed(draw: st.DrawFn) -> tuple[Outline, Outline, np.ndarray]:
    """Placed, without lengths whose products are not exact when scaled."""
    a, b, delta = draw(placed())
    a, b = (Outline(np.round(each.vertices, 9), each.radius) for each in (a, b))
    return a, b, np.round(delta, 9)


@settings(max_examples=1000, deadline=None)
@given(placed())
def test_the_smallest_separation_is_the_distance(pair) -> None:
    a, b, delta = pair
    found = Contact()
    assert found.collide(a, b, delta) > 0
    assert np.hypot(*found.normal) == pytest.approx(1, abs=1e-14)
    cores = separation(a, b, delta)
    expected = pytest.approx(cores - a.radius - b.radius, abs=1e-9 + PARALLEL**2 * abs(cores))
    assert min(found.gaps) == expected
    if found.count == 1 and cores > 0:
        assert min(found.gaps) == pytest.approx(cores - a.radius - b.radius, abs=1e-9)


@settings(max_examples=500, deadline=None)
@given(placed())
def test_points_lie_midway_between_the_surfaces(pair) -> None:
    a, b, delta = pair
    found = Contact()
    found.collide(a, b, delta)
    if separation(a, b, delta) < 1e-9:
        return
    half = 0.5 * found.gaps[:, None] * found.normal
    assert outside(a, found.points - half) == pytest.approx(0, abs=1e-9) or found.count == 2
    assert (outside(a, found.points - half) < 1e-9).all()
    assert (outside(b, found.points + half - delta) < 1e-9).all()


@settings(max_examples=300, deadline=None)
@given(placed())
def test_swapping_the_shapes_mirrors_the_manifold(pair) -> None:
    a, b, delta = pair
    one, other = Contact(), Contact()
    one.collide(a, b, delta, 0.3)
    other.collide(b, a, -delta, 0.3)
    assert (one.count > 0) == (other.count > 0)
    if one.count and separation(a, b, delta) > 1e-9:  # else several sides may be as near
        assert one.count == other.count
        assert one.normal == pytest.approx(-other.normal, abs=2 * PARALLEL)
        assert min(one.gaps) == pytest.approx(min(other.gaps), abs=1e-9)


@settings(max_examples=300, deadline=None)
@given(plainly_placed(), st.sampled_from([2.0**-20, 2.0**20]))
def test_a_scaled_pair_has_the_scaled_manifold_to_the_bit(pair, factor: float) -> None:
    a, b, delta = pair
    one, other = Contact(), Contact()
    one.collide(a, b, delta, 0.3)
    other.collide(a.scaled(factor), b.scaled(factor), delta * factor, 0.3 * factor)
    assert one.features == other.features
    assert one.normal.tolist() == other.normal.tolist()
    assert (one.gaps * factor).tolist() == other.gaps.tolist()
    assert (one.points * factor).tolist() == other.points.tolist()


@settings(max_examples=200, deadline=None)
@given(placed(), ANGLES)
def test_a_turned_pair_has_the_turned_manifold(pair, angle: float) -> None:
    a, b, delta = pair
    one, other = Contact(), Contact()
    one.collide(a, b, delta)
    other.collide(a.turned(angle), b.turned(angle), turn(delta, angle))
    if separation(a, b, delta) > 1e-9 and one.features == other.features:
        assert other.normal == pytest.approx(turn(one.normal, angle), abs=1e-6)
        assert other.points == pytest.approx(turn(one.points, angle), abs=1e-6)
    assert min(one.gaps) == pytest.approx(min(other.gaps), abs=1e-9)


MOTIONS = np.array([(1, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1), (0, 0, 1, 1), (1, 1, 1, 1)])


def test_points_that_are_found_are_those_of_now_and_not_foreseen() -> None:
    found = Contact()
    found.manifold[tb.FORESEEN] = 1e-3
    assert found.collide(box(1.0, 1.0), box(1.0, 1.0), np.array([0.0, 1.0])) == 2
    assert found.manifold[tb.FORESEEN] == 0.0


@pytest.mark.parametrize("seed", range(4))
def test_a_cached_axis_gives_the_manifold_of_a_search(seed: int) -> None:
    rng = np.random.default_rng(seed)
    sided = [shape for shape in SHAPES if len(shape.vertices) > 1]
    cached = 0
    for _ in range(600):
        a, b = (sided[rng.integers(len(sided))].turned(rng.uniform(0, 6)) for _ in range(2))
        delta = rng.uniform(-1.5, 1.5, 2)
        margin = rng.uniform(-0.2, 0.5)
        remembers = Contact()
        for _ in range(2):  # nothing is cached in the first step of a contact
            remembers.collide(a, b, delta, margin)
        for _ in range(3):
            far = 10 ** rng.uniform(-3, 0) * MOTIONS[rng.integers(5)] * rng.uniform(-1, 1, 4)
            a, b, delta = a.turned(far[2]), b.turned(far[3]), delta + far[:2]
            searches = Contact()
            searches.collide(a, b, delta, margin)
            before = remembers.cached_axis.copy()
            remembers.collide(a, b, delta, margin)
            cached += (remembers.cached_axis == before).all()
            assert remembers.features == searches.features
            assert remembers.points == pytest.approx(searches.points, abs=1e-12)
            assert remembers.gaps == pytest.approx(searches.gaps, abs=1e-12)
            if searches.count:
                assert remembers.normal == pytest.approx(searches.normal, abs=1e-12)
    assert 400 < cached < 1600


def test_a_cached_separation_holds_no_longer_than_it_may() -> None:
    rng = np.random.default_rng(5)
    for _ in range(100):
        found, searches = Contact(), Contact()
        turned = rng.uniform(0, 6)
        found.collide(box(1, 1), box(1, 1).turned(turned), (0.0, 3.0), 0.1)
        start = found.cached_axis.copy()
        for height in np.arange(3.0, 1.0, -0.02):
            count = found.collide(box(1, 1), box(1, 1).turned(turned), (0.0, height), 0.1)
            assert count == searches.collide(
                box(1, 1), box(1, 1).turned(turned), (0.0, height), 0.1
            )
            searches = Contact()
        assert (start != found.cached_axis).any()


def test_pairs_at_rest_are_not_searched_for_an_axis(monkeypatch: pytest.MonkeyPatch) -> None:
    searched = []
    search = polygon.find_axis
    monkeypatch.setattr(polygon, "find_axis", lambda *a: searched.append(a) or search(*a))
    rng = np.random.default_rng(1)
    for b, height in (
        (box(1.0, 1.0), 1.0),
        (regular(6, 1.0), 1.5),
        (capsule(2.0, 0.2), 0.7),
        (box(1, 1), 1.2),
    ):
        found, searched[:] = Contact(), []
        for _ in range(100):
            shaken = b.turned(1e-3 * rng.normal())
            assert found.collide(
                box(5.0, 1.0), shaken, (0.3, height) + 1e-3 * rng.normal(size=2), 0.1
            ) in (
                0,
                1,
                2,
            )
        assert len(searched) == 2  # at first, and when it is seen to stay


@pytest.mark.parametrize("a", SHAPES)
@pytest.mark.parametrize("b", SHAPES)
def test_impulses_stay_with_points_that_stay(a: Outline, b: Outline) -> None:
    rng = np.random.default_rng(2)
    for _ in range(20):
        first, second = a.turned(rng.uniform(0, 6)), b.turned(rng.uniform(0, 6))
        delta = rng.uniform(-1, 1, 2)
        found = Contact()
        found.collide(first, second, delta)
        for k in range(found.count):
            found.impulses[k] = 1 + 2 * k, 2 + 2 * k
        kept = dict(zip(found.features, [(1, 2), (3, 4)], strict=False))
        found.collide(first, second, delta + 1e-9)
        for k, feature in enumerate(found.features):
            assert tuple(found.impulses[k]) == kept.get(feature, (0, 0))
        found.collide(first, second, delta + 100, 0.1)
        assert found.count == 0
        assert not found.impulses.any()


def test_features_stay_when_the_reference_side_changes() -> None:
    found = Contact()
    names = set()
    for tilt in (1e-3, -1e-3):
        for lean in (1e-3, -1e-3):
            found.collide(box(1.0, 1.0).turned(lean), box(1.0, 1.0).turned(tilt), (0.5, 1.0), 0.1)
            names.add(tuple(sorted(found.features)))
    assert len(names) == 1
    assert found.count == 2


FLAT = [
    (box(1, 1), box(2, 1), (0.2, 1.0)),
    (box(1, 1), capsule(3.0, 0.5), (0.2, 1.0)),
    (capsule(1.0), box(1, 1), (0.2, 0.5)),
    (capsule(1.0, 0.3), capsule(1.0, 0.2), (0.4, 0.5)),
    (capsule(1.0), capsule(1.0), (0.4, 0.0)),
    (half_plane(0.5), box(1, 1), (3.0, 1.0)),
    (half_plane(0.5), capsule(2.0, 0.25), (3.0, 0.75)),
    (box(1, 1), half_plane(-0.5).turned(np.pi), (3.0, 0.0)),
]


@pytest.mark.parametrize(("a", "b", "delta"), FLAT)
@pytest.mark.parametrize("gap", [0.0, 0.01, -0.01])
def test_side_on_side_has_two_points(a: Outline, b: Outline, delta, gap: float) -> None:
    found = Contact()
    assert found.collide(a, b, np.add(delta, (0.0, gap))) == 2
    if max(a.radius, b.radius) or len(a.rows()) > 2:
        assert found.normal == pytest.approx((0, 1), abs=1e-12)
        assert found.gaps == pytest.approx([gap, gap], abs=1e-12)


@pytest.mark.parametrize("tilt", [1e-3, -1e-3, 1e-9, -1e-12])
@pytest.mark.parametrize("slip", [0.0, 1e-9, -1e-6])
def test_capsules_in_line_rest_on_two_points(tilt: float, slip: float) -> None:
    for shape, height in ((capsule(1.0, 0.5), 1.0), (box(1.0, 1.0), 1.001)):
        found = Contact()
        assert found.collide(shape, shape.turned(tilt), (slip, height), 0.1) == 2


@pytest.mark.parametrize("a", SHAPES)
@pytest.mark.parametrize("b", SHAPES)
def test_shapes_with_equal_centres_have_a_normal_of_length_one(a: Outline, b: Outline) -> None:
    for delta in ((0.0, 0.0), (1e-300, 0.0), (1e-17, -1e-17)):
        found = Contact()
        assert found.collide(a, b, np.array(delta)) > 0
        assert np.hypot(*found.normal) == pytest.approx(1, abs=1e-12)
        assert np.isfinite(found.manifold).all()


def test_segments_in_line_do_not_touch() -> None:
    found = Contact()
    for angle in np.linspace(0, 6, 50):
        line = capsule(1.0).turned(angle)
        assert found.collide(line, line, turn(np.array([1.5, 0.0]), angle)) == 1
        assert found.gaps == pytest.approx([0.5])
        assert found.normal == pytest.approx(turn(np.array([1.0, 0.0]), angle))


def test_a_segment_without_length_collides_as_a_point() -> None:
    rows = np.array([[0.0, 0.0, 0.0, -1.0], [0.0, 0.0, 0.0, 1.0]])

    class Point(Outline):
        def rows(self) -> Any:
            return rows

    point = Point(np.zeros((2, 2)), 0.3)
    for other in SHAPES:
        found, expected = Contact(), Contact()
        for delta in ((1.5, 0.3), (0.2, 1.9)):
            found.collide(point, other, np.array(delta))
            expected.collide(disc(0.3), other, np.array(delta))
            assert min(found.gaps) == pytest.approx(min(expected.gaps), abs=1e-12)
            assert found.normal == pytest.approx(expected.normal, abs=1e-9)


@settings(max_examples=200, deadline=None)
@given(placed())
def test_a_half_plane_touches_the_lowest_vertices(pair) -> None:
    _, b, delta = pair
    plane = half_plane(0.1).turned(float(delta[1]))
    normal = np.array(plane.vertices[1])
    heights = np.sort((np.asarray(b.vertices) + delta) @ normal) - 0.1 - b.radius
    one, other = Contact(), Contact()
    one.collide(plane, b, delta)
    other.collide(b, plane, -delta)
    assert one.gaps == pytest.approx(heights[: one.count], abs=1e-12) or len(b.vertices) > 2
    assert min(one.gaps) == pytest.approx(heights[0], abs=1e-12)
    assert one.count == min(2, len(b.vertices))
    assert one.normal == pytest.approx(normal)
    assert one.normal == pytest.approx(-other.normal)
    assert one.points == pytest.approx(other.points + delta)
    half = 0.5 * one.gaps[:, None] * one.normal
    assert outside(plane, one.points - half) == pytest.approx(0, abs=1e-12)
    assert (outside(b, one.points + half - delta) < 1e-9).all()


@settings(max_examples=200, deadline=None)
@given(placed())
def test_arms_without_radius_and_half_a_gap_end_at_the_cores(pair) -> None:
    a, b, delta = pair
    found = Contact()
    for k in range(found.collide(a, b, delta)):
        half = 0.5 * found.gaps[k]
        of_a = found.points[k] @ found.normal - a.radius - half
        of_b = (found.points[k] - delta) @ found.normal + b.radius + half
        cores = of_b + found.normal @ delta - of_a
        assert cores - a.radius - b.radius == pytest.approx(found.gaps[k], abs=1e-12)
        if a.kind == 0:
            assert of_a == pytest.approx(found.normal @ a.vertices[0], abs=1e-12)
        if b.kind == 0:
            assert of_b == pytest.approx(found.normal @ b.vertices[0], abs=1e-12)


class Pairs(NamedTuple):
    shapes: Shapes
    contacts: Contacts
    delta: FloatRows


def collide_each(pairs: Pairs, margin: float) -> int:
    """Collide all pairs."""
    delta, listed, count = pairs.delta, pairs.contacts.pairs, 0
    for p in range(len(delta)):
        count += collide(
            p, listed[p, 0], listed[p, 1], delta[p, 0], delta[p, 1], margin, pairs.shapes,
            pairs.contacts,
        )  # fmt: skip
    return count


collide_each.__module__ = "tamias2d.engine.test"  # as in a module of the package


def test_compiled_and_plain_manifolds_have_the_same_bits() -> None:
    library = Library("narrow phase of the tests", (collide_each,))
    assert "forceinline=True)\ndef collide(" in library.source()
    rng = np.random.default_rng(3)
    outlines = [shape.turned(rng.uniform(0, 6)) for shape in (*SHAPES, half_plane(0.1))]
    listed = np.indices((len(outlines), len(outlines))).reshape(2, -1).T
    start = rng.uniform(-1.5, 1.5, (len(listed), 2))
    results: list[list[Any]] = []
    for is_compiled in (False, True):
        made = library.compiled() if is_compiled else library.plain()
        contacts, result = contact_arrays(listed), []
        for step in range(6):
            shapes = shape_arrays([outline.turned(0.01 * step) for outline in outlines])
            pairs = Pairs(shapes, contacts, start * (1 + 0.01 * step))
            count = made.collide_each(addresses(pairs) if is_compiled else pairs, 0.3)
            result += [count, contacts.manifolds.tobytes(), contacts.flags.tobytes()]
        results.append(result)
    assert results[0] == results[1]
    assert results[0][0] > 100
