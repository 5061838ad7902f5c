"""Manifolds against what trying everything finds, and against what does not change them."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from tests.stepped.outlines import (
    Outline,
    Pairing,
    box,
    capsule,
    disc,
    outside,
    regular,
    room,
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


@settings(max_examples=1000, deadline=None)
@given(placed())
def test_the_smallest_separation_is_the_distance(pair) -> None:
    a, b, delta = pair
    found = Pairing()
    assert found(a, b, delta) > 0
    assert np.hypot(*found.normal) == pytest.approx(1, abs=1e-14)
    assert min(found.gaps) == pytest.approx(room(a, b, delta) - a.radius - b.radius, abs=1e-9)


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
        assert one.normal == pytest.approx(-other.normal, abs=1e-6)
        assert min(one.gaps) == pytest.approx(min(other.gaps), abs=1e-9)


@settings(max_examples=300, deadline=None)
@given(placed(), st.sampled_from([2.0**-20, 2.0**20]))
def test_no_size_is_special(pair, factor: float) -> None:
    a, b, delta = pair
    one, other = Pairing(), Pairing()
    one(a, b, delta, 0.3)
    other(a.scaled(factor), b.scaled(factor), delta * factor, 0.3 * factor)
    assert one.features == other.features
    assert one.normal.tolist() == other.normal.tolist()
    assert (one.gaps * factor).tolist() == other.gaps.tolist()
    assert (one.points * factor).tolist() == other.points.tolist()
