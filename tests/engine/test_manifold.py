"""Manifolds against what trying everything finds, and against what does not change them."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from tamias2d.kernels import Engine
from tamias2d.kernels.arrays import Bytes, FloatRows, Floats, IndexRows, Indices
from tamias2d.stepped import polygons
from tamias2d.stepped.clip import PARALLEL
from tamias2d.stepped.layout import CACHE, POINT, PUSH, RUB, TOUCH
from tamias2d.stepped.manifold import collide
from tests.engine.outlines import (
    Outline,
    Pairing,
    box,
    capsule,
    disc,
    half_plane,
    outside,
    regular,
    room,
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
    a, b = (Outline(np.round(each.corners, 9), each.radius) for each in (a, b))
    return a, b, np.round(delta, 9)


@settings(max_examples=1000, deadline=None)
@given(placed())
def test_the_smallest_separation_is_the_distance(pair) -> None:
    a, b, delta = pair
    found = Pairing()
    assert found(a, b, delta) > 0
    assert np.hypot(*found.normal) == pytest.approx(1, abs=1e-14)
    cores = room(a, b, delta)
    expected = pytest.approx(cores - a.radius - b.radius, abs=1e-9 + PARALLEL**2 * abs(cores))
    assert min(found.gaps) == expected
    if found.count == 1 and cores > 0:
        assert min(found.gaps) == pytest.approx(cores - a.radius - b.radius, abs=1e-9)


@settings(max_examples=500, deadline=None)
@given(placed())
def test_points_lie_midway_between_the_surfaces(pair) -> None:
    a, b, delta = pair
    found = Pairing()
    found(a, b, delta)
    if room(a, b, delta) < 1e-9:
        return
    half = 0.5 * found.gaps[:, None] * found.normal
    assert outside(a, found.points - half) == pytest.approx(0, abs=1e-9) or found.count == 2
    assert (outside(a, found.points - half) < 1e-9).all()
    assert (outside(b, found.points + half - delta) < 1e-9).all()


@settings(max_examples=300, deadline=None)
@given(placed())
def test_swapping_the_shapes_mirrors_the_manifold(pair) -> None:
    a, b, delta = pair
    one, other = Pairing(), Pairing()
    one(a, b, delta, 0.3)
    other(b, a, -delta, 0.3)
    assert (one.count > 0) == (other.count > 0)
    if one.count and room(a, b, delta) > 1e-9:  # else several sides may be as near
        assert one.count == other.count
        assert one.normal == pytest.approx(-other.normal, abs=2 * PARALLEL)
        assert min(one.gaps) == pytest.approx(min(other.gaps), abs=1e-9)


@settings(max_examples=300, deadline=None)
@given(plainly_placed(), st.sampled_from([2.0**-20, 2.0**20]))
def test_no_size_is_special(pair, factor: float) -> None:
    a, b, delta = pair
    one, other = Pairing(), Pairing()
    one(a, b, delta, 0.3)
    other(a.scaled(factor), b.scaled(factor), delta * factor, 0.3 * factor)
    assert one.features == other.features
    assert one.normal.tolist() == other.normal.tolist()
    assert (one.gaps * factor).tolist() == other.gaps.tolist()
    assert (one.points * factor).tolist() == other.points.tolist()


@settings(max_examples=200, deadline=None)
@given(placed(), ANGLES)
def test_turning_both_turns_the_manifold(pair, angle: float) -> None:
    a, b, delta = pair
    one, other = Pairing(), Pairing()
    one(a, b, delta)
    other(a.turned(angle), b.turned(angle), turn(delta, angle))
    if room(a, b, delta) > 1e-9 and one.features == other.features:
        assert other.normal == pytest.approx(turn(one.normal, angle), abs=1e-6)
        assert other.points == pytest.approx(turn(one.points, angle), abs=1e-6)
    assert min(one.gaps) == pytest.approx(min(other.gaps), abs=1e-9)


MOTIONS = np.array([(1, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1), (0, 0, 1, 1), (1, 1, 1, 1)])


@pytest.mark.parametrize("seed", range(4))
def test_a_hint_finds_what_a_search_finds(seed: int) -> None:
    rng = np.random.default_rng(seed)
    sided = [shape for shape in SHAPES if len(shape.corners) > 1]
    hinted = 0
    for _ in range(600):
        a, b = (sided[rng.integers(len(sided))].turned(rng.uniform(0, 6)) for _ in range(2))
        delta = rng.uniform(-1.5, 1.5, 2)
        margin = rng.uniform(-0.2, 0.5)
        remembers = Pairing()
        for _ in range(2):  # what has just come is not remembered, what stays is
            remembers(a, b, delta, margin)
        for _ in range(3):
            far = 10 ** rng.uniform(-3, 0) * MOTIONS[rng.integers(5)] * rng.uniform(-1, 1, 4)
            a, b, delta = a.turned(far[2]), b.turned(far[3]), delta + far[:2]
            searches = Pairing()
            searches(a, b, delta, margin)
            before = remembers.touch[0, CACHE : CACHE + 4].copy()
            remembers(a, b, delta, margin)
            hinted += (remembers.touch[0, CACHE : CACHE + 4] == before).all()
            assert remembers.features == searches.features
            assert remembers.points == pytest.approx(searches.points, abs=1e-12)
            assert remembers.gaps == pytest.approx(searches.gaps, abs=1e-12)
            if searches.count:
                assert remembers.normal == pytest.approx(searches.normal, abs=1e-12)
    assert 400 < hinted < 1600


def test_shapes_that_come_together_are_seen() -> None:
    rng = np.random.default_rng(5)
    for _ in range(100):
        found, searches = Pairing(), Pairing()
        turned = rng.uniform(0, 6)
        found(box(1, 1), box(1, 1).turned(turned), (0.0, 3.0), 0.1)
        start = found.touch[0, CACHE : CACHE + 4].copy()
        for height in np.arange(3.0, 1.0, -0.02):
            count = found(box(1, 1), box(1, 1).turned(turned), (0.0, height), 0.1)
            assert count == searches(box(1, 1), box(1, 1).turned(turned), (0.0, height), 0.1)
            searches = Pairing()
        assert (start != found.touch[0, CACHE : CACHE + 4]).any()


def test_pairs_that_rest_are_not_searched(monkeypatch: pytest.MonkeyPatch) -> None:
    searched = []
    search = polygons.find_sides
    monkeypatch.setattr(polygons, "find_sides", lambda *a: searched.append(a) or search(*a))
    rng = np.random.default_rng(1)
    for b, height in (
        (box(1.0, 1.0), 1.0),
        (regular(6, 1.0), 1.5),
        (capsule(2.0, 0.2), 0.7),
        (box(1, 1), 1.2),
    ):
        found, searched[:] = Pairing(), []
        for _ in range(100):
            shaken = b.turned(1e-3 * rng.normal())
            assert found(box(5.0, 1.0), shaken, (0.3, height) + 1e-3 * rng.normal(size=2), 0.1) in (
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
        found = Pairing()
        found(first, second, delta)
        for k in range(found.count):
            found.touch[0, PUSH + POINT * k : PUSH + POINT * k + 2] = 1 + 2 * k, 2 + 2 * k
        kept = dict(zip(found.features, [(1, 2), (3, 4)], strict=False))
        found(first, second, delta + 1e-9)
        for k, name in enumerate(found.features):
            at = PUSH + POINT * k
            assert tuple(found.touch[0, at : at + 2]) == kept.get(name, (0, 0))
        found(first, second, delta + 100, 0.1)
        assert found.count == 0
        assert not found.touch[0].reshape(2, POINT)[:, PUSH : RUB + 1].any()


def test_names_stay_when_the_leading_side_changes() -> None:
    found = Pairing()
    names = set()
    for tilt in (1e-3, -1e-3):
        for lean in (1e-3, -1e-3):
            found(box(1.0, 1.0).turned(lean), box(1.0, 1.0).turned(tilt), (0.5, 1.0), 0.1)
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
    found = Pairing()
    assert found(a, b, np.add(delta, (0.0, gap))) == 2
    if max(a.radius, b.radius) or len(a.rows()) > 2:
        assert found.normal == pytest.approx((0, 1), abs=1e-12)
        assert found.gaps == pytest.approx([gap, gap], abs=1e-12)


@pytest.mark.parametrize("tilt", [1e-3, -1e-3, 1e-9, -1e-12])
@pytest.mark.parametrize("slip", [0.0, 1e-9, -1e-6])
def test_capsules_in_line_rest_on_two_points(tilt: float, slip: float) -> None:
    for shape, height in ((capsule(1.0, 0.5), 1.0), (box(1.0, 1.0), 1.001)):
        found = Pairing()
        assert found(shape, shape.turned(tilt), (slip, height), 0.1) == 2


@pytest.mark.parametrize("a", SHAPES)
@pytest.mark.parametrize("b", SHAPES)
def test_equal_centres_have_a_normal(a: Outline, b: Outline) -> None:
    for delta in ((0.0, 0.0), (1e-300, 0.0), (1e-17, -1e-17)):
        found = Pairing()
        assert found(a, b, np.array(delta)) > 0
        assert np.hypot(*found.normal) == pytest.approx(1, abs=1e-12)
        assert np.isfinite(found.touch).all()


def test_lines_in_line_do_not_touch() -> None:
    found = Pairing()
    for angle in np.linspace(0, 6, 50):
        line = capsule(1.0).turned(angle)
        assert found(line, line, turn(np.array([1.5, 0.0]), angle)) == 1
        assert found.gaps == pytest.approx([0.5])
        assert found.normal == pytest.approx(turn(np.array([1.0, 0.0]), angle))


def test_a_line_without_length_is_a_point() -> None:
    rows = np.array([[0.0, 0.0, 0.0, -1.0], [0.0, 0.0, 0.0, 1.0]])

    class Point(Outline):
        def rows(self) -> Any:
            return rows

    point = Point(np.zeros((2, 2)), 0.3)
    for other in SHAPES:
        found, expected = Pairing(), Pairing()
        for delta in ((1.5, 0.3), (0.2, 1.9)):
            found(point, other, np.array(delta))
            expected(disc(0.3), other, np.array(delta))
            assert min(found.gaps) == pytest.approx(min(expected.gaps), abs=1e-12)
            assert found.normal == pytest.approx(expected.normal, abs=1e-9)


@settings(max_examples=200, deadline=None)
@given(placed())
def test_half_planes_hold_the_lowest_corners(pair) -> None:
    _, b, delta = pair
    plane = half_plane(0.1).turned(float(delta[1]))
    normal = np.array(plane.corners[1])
    heights = np.sort((np.asarray(b.corners) + delta) @ normal) - 0.1 - b.radius
    one, other = Pairing(), Pairing()
    one(plane, b, delta)
    other(b, plane, -delta)
    assert one.gaps == pytest.approx(heights[: one.count], abs=1e-12) or len(b.corners) > 2
    assert min(one.gaps) == pytest.approx(heights[0], abs=1e-12)
    assert one.count == min(2, len(b.corners))
    assert one.normal == pytest.approx(normal)
    assert one.normal == pytest.approx(-other.normal)
    assert one.points == pytest.approx(other.points + delta)
    half = 0.5 * one.gaps[:, None] * one.normal
    assert outside(plane, one.points - half) == pytest.approx(0, abs=1e-12)
    assert (outside(b, one.points + half - delta) < 1e-9).all()


@settings(max_examples=200, deadline=None)
@given(placed())
def test_what_turns_reaches_along_the_normal_as_is_said(pair) -> None:
    a, b, delta = pair
    found = Pairing()
    for k in range(found(a, b, delta)):
        half = 0.5 * found.gaps[k]
        of_a = found.points[k] @ found.normal - a.radius - half
        of_b = (found.points[k] - delta) @ found.normal + b.radius + half
        cores = of_b + found.normal @ delta - of_a
        assert cores - a.radius - b.radius == pytest.approx(found.gaps[k], abs=1e-12)
        if a.kind == 0:
            assert of_a == pytest.approx(found.normal @ a.corners[0], abs=1e-12)
        if b.kind == 0:
            assert of_b == pytest.approx(found.normal @ b.corners[0], abs=1e-12)


def each(
    pairs: IndexRows,
    delta: FloatRows,
    margin: float,
    shape_kind: Bytes,
    shape_first: Indices,
    shape_count: Indices,
    shape_radius: Floats,
    surface: FloatRows,
    turned: FloatRows,
    touch: FloatRows,
    trace: IndexRows,
) -> int:
    """Collide all pairs."""
    count = 0
    for p in range(len(pairs)):
        count += collide(
            p,
            pairs[p, 0],
            pairs[p, 1],
            delta[p, 0],
            delta[p, 1],
            margin,
            shape_kind,
            shape_first,
            shape_count,
            shape_radius,
            surface,
            turned,
            touch,
            trace,
        )
    return count


each.__module__ = "tamias2d.stepped.test"  # as in a module of the package


def test_compiled_and_plain_manifolds_have_the_same_bits() -> None:
    engine = Engine("narrow phase of the tests", (each,))
    assert "forceinline=True)\ndef collide(" in engine.source()
    rng = np.random.default_rng(3)
    shapes = [*SHAPES, half_plane(0.1)]
    pairs = np.array([(i, j) for i in range(len(shapes)) for j in range(len(shapes))], np.int32)
    results: list[list[Any]] = [[], []]
    rows = [shape.turned(rng.uniform(0, 6)).rows() for shape in shapes]
    counts = np.array([len(each) for each in rows], np.int32)
    first = (np.cumsum(counts) - counts).astype(np.int32)
    start = rng.uniform(-1.5, 1.5, (len(pairs), 2))
    for result, made in zip(results, (engine.plain(), engine.compiled()), strict=True):
        touch = np.zeros((len(pairs), TOUCH))
        trace = np.zeros((len(pairs), 6), np.int32)
        for step in range(6):
            turned = np.vstack(rows)
            turned = np.hstack([turn(turned[:, :2], 0.01 * step), turn(turned[:, 2:], 0.01 * step)])
            turned[first[-1], 0:2] = 0.1, 0.0
            count = made.each(
                pairs,
                start * (1 + 0.01 * step),
                0.3,
                np.array([shape.kind for shape in shapes], np.int8),
                first,
                counts,
                np.array([shape.radius for shape in shapes]),
                np.array([shape.surface() for shape in shapes]),
                np.ascontiguousarray(turned),
                touch,
                trace,
            )
            result += [count, touch.tobytes(), trace.tobytes()]
    assert results[0] == results[1]
    assert results[0][0] > 100
