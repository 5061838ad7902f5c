"""Times of impact against the poses before them, and where they are known."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from tamias2d.engine.arrays.world import Capacities, allocated
from tamias2d.engine.continuous import conservative_advancement
from tamias2d.engine.continuous.conservative_advancement import MISSED, NEAR, time_of_impact
from tamias2d.engine.continuous.trajectory import RelativePath
from tamias2d.engine.narrow_phase.clip import PARALLEL
from tamias2d.engine.tables import Events, Shapes
from tamias2d.kernels import Library
from tamias2d.kernels.arrays import FloatRows, Floats, IndexRows
from tamias2d.kernels.groups import addresses
from tests.engine.cores import Contact, Outline, box, capsule, disc, half_plane, shape_arrays
from tests.engine.test_manifold import ANGLES, SHAPES, placed, plainly_placed

MOVES = st.tuples(st.floats(-9, 9), st.floats(-9, 9)).map(np.array)
TURNS = st.one_of(st.just(0.0), st.floats(-4, 4), st.floats(-200, 200))


def event_arrays() -> Events:
    """Room for the vertices of two shapes."""
    return allocated(Capacities(clip=64)).events


def swept(
    a: Outline, b: Outline, delta: Any, move: Any, turn_a: float = 0.0, turn_b: float = 0.0
) -> float:
    path = RelativePath(*map(float, delta), *map(float, move), turn_a, turn_b)
    return float(
        time_of_impact(0, 1, False, path, (0.0, 0.0), shape_arrays((a, b)), event_arrays())
    )


def gap_at(a: Outline, b: Outline, delta: Any, move: Any, turns: Any, at: float) -> float:
    found = Contact()
    found.collide(a.turned(turns[0] * at), b.turned(turns[1] * at), delta + at * np.array(move))
    return float(min(found.gaps))


def size(*outlines: Outline) -> float:
    def one(outline: Outline) -> float:
        vertices = np.asarray(outline.vertices)
        return float(max(np.hypot(*(vertices - vertices[0]).T)) / 2 + outline.radius)

    return min(one(outline) for outline in outlines if not outline.plane)


@settings(max_examples=300, deadline=None)
@given(placed(), MOVES, TURNS, TURNS)
def test_shapes_are_apart_before_the_time_of_impact_and_close_at_it(
    pair, move, turn_a, turn_b
) -> None:
    a, b, delta = pair
    turns = turn_a, turn_b
    near = NEAR * size(a, b)
    start = gap_at(a, b, delta, move, turns, 0.0)
    at = swept(a, b, delta, move, turn_a, turn_b)
    if start <= near:
        return
    until = min(at, 1.0)
    before = [gap_at(a, b, delta, move, turns, f) for f in np.linspace(0, until, 150)]
    assert min(before) > 0
    if at != MISSED:
        nearly = PARALLEL**2 * (a.radius + b.radius)
        assert 0 < gap_at(a, b, delta, move, turns, at) <= near * (1 + 1e-9) + nearly


@settings(max_examples=200, deadline=None)
@given(st.sampled_from(SHAPES), ANGLES, ANGLES, MOVES, TURNS, st.sampled_from([0.0, 0.3, -20.0]))
def test_a_shape_is_above_a_half_plane_before_the_time_of_impact(
    b, angle, turned, move, turn_b, turn_a
) -> None:
    plane, b = half_plane(-1.2).turned(angle), b.turned(turned)
    delta = 0.8 * np.array(plane.vertices[1])
    turns = turn_a, turn_b
    at = swept(plane, b, delta, move, turn_a, turn_b)
    assert at == swept(b, plane, -delta, -move, turn_b, turn_a)
    until = min(at, 1.0)
    before = [gap_at(plane, b, delta, move, turns, f) for f in np.linspace(0, until, 150)]
    assert min(before) > 0
    if at != MISSED:
        assert 0 < gap_at(plane, b, delta, move, turns, at) <= NEAR * size(b) * (1 + 1e-9)


@pytest.mark.parametrize("speed", [1e1, 1e2, 1e4, 1e6])
@pytest.mark.parametrize("thickness", [0.02, 0.0])
@pytest.mark.parametrize("spin", [0.0, 1e4])
def test_a_fast_disc_meets_a_thin_wall_where_it_must(speed, thickness, spin) -> None:
    wall = box(thickness, 4.0) if thickness else capsule(4.0).turned(np.pi / 2)
    move = speed / 60
    at = swept(wall, disc(0.1), (-0.3 * move, 0.5), (move, 0.0), 0.0, spin / 60)
    room = 0.3 * move - 0.1 - thickness / 2
    if room > 0:
        assert at * move == pytest.approx(room, abs=1e-4)
    assert swept(wall, disc(0.1), (-0.3 * move, 2.2), (move, 0.0), 0.0, spin / 60) == MISSED


@pytest.mark.parametrize("miss", [1e-3, 1e-6])
def test_grazing_is_told_from_missing(miss) -> None:
    for shape in (disc(0.1), box(0.2, 0.2)):
        ball = disc(0.1)
        passed = swept(ball, shape, (-50.0, 0.2 + 0.2 * NEAR + miss), (100.0, 0.0))
        met = swept(ball, shape, (-50.0, 0.2 - miss), (100.0, 0.0))
        assert passed == MISSED
        assert met == pytest.approx(0.5, abs=2e-3)


@pytest.mark.parametrize("gap", [1e-1, 1e-2, 1e-3])
def test_a_bar_that_spins_fast_beside_a_wall_does_not_meet_it(gap) -> None:
    bar, wall = box(2.0, 0.01), box(0.02, 50.0)
    tip = np.hypot(1.0, 0.005)
    turn = 1e4 / 60
    assert swept(wall, bar, (tip + gap + 0.01, 0.0), (0.0, 3.0), 0.0, turn) == MISSED
    at = swept(wall, bar.turned(np.pi / 2), (tip - gap + 0.01, 0.0), (0.0, 3.0), 0.0, turn)
    assert at * turn == pytest.approx(np.pi / 2 - np.arccos(1 - gap), abs=0.02)


@pytest.mark.parametrize("x", [0.0, 4.0])
@pytest.mark.parametrize("raised", [-0.05, 0.0, 1e-3])
@pytest.mark.parametrize("upper", [box(0.4, 0.4), capsule(0.4, 0.2)])
def test_bodies_that_turn_together_do_not_meet_and_take_few_poses(
    x, raised, upper, monkeypatch: pytest.MonkeyPatch
) -> None:
    looked: list[Any] = []
    found = conservative_advancement.measure_gap
    monkeypatch.setattr(
        conservative_advancement, "measure_gap", lambda *a: looked.append(a) or found(*a)
    )
    turn, y = 0.2, 0.7 + raised
    assert swept(box(10.0, 1.0), upper, (x, y), (-turn * y, turn * x), turn, turn) == MISSED
    assert 0 < len(looked) < 30  # of a search along axes that stay 65, or hundreds


def test_boards_that_turn_beside_boxes_that_hardly_do_are_apart_until_they_meet() -> None:
    """Without the arcs of corners in the bound along a normal that turns, 7 pairs go too far."""
    rng, met = np.random.default_rng(1), 0
    for _ in range(400):
        a, b = (one.turned(rng.uniform(0, 6.3)) for one in (box(2.0, 1.0), box(1.0, 0.1)))
        angle, far = rng.uniform(0, 6.3), rng.uniform(0.7, 1.7)
        delta, move = far * np.array([np.cos(angle), np.sin(angle)]), 0.2 * rng.normal(size=2)
        turns = rng.choice([-1, 1]) * 10 ** rng.uniform(-3, 0), rng.uniform(-3, 3)
        if gap_at(a, b, delta, move, turns, 0.0) > 1e-3:
            at = swept(a, b, delta, move, *turns)
            until = np.linspace(0, min(at, 1.0), 40)
            assert min(gap_at(a, b, delta, move, turns, f) for f in until) > 0
            met += at != MISSED
    assert met > 50


def test_shapes_close_at_the_start_meet_when_closer_or_close_again() -> None:
    floor, ball = box(10.0, 1.0), disc(0.5)
    assert swept(floor, ball, (0.0, 1.0), (0.0, -3.0)) < 2 * NEAR  # deeper is met at once
    assert swept(floor, ball, (0.0, 1.0), (3.0, 0.0)) == MISSED
    bar = box(2.0, 0.1)  # lies on the floor, and turns up faster or slower than it rises
    assert swept(floor, bar, (0.0, 0.55), (0.0, 2.0), 0.0, 7.0) < 2 * NEAR
    assert swept(floor, bar, (0.0, 0.55), (0.0, 2.0), 0.0, 1.5) == MISSED


@settings(max_examples=100, deadline=None)
@given(
    plainly_placed(),
    MOVES.map(lambda move: np.round(move, 9)),
    TURNS,
    st.sampled_from([2.0**-20, 2.0**20]),
)
def test_scaled_shapes_meet_at_the_same_time_to_the_bit(pair, move, turn, factor) -> None:
    a, b, delta = pair
    one = swept(a, b, delta, move, turn, 0.0)
    assert one == swept(a.scaled(factor), b.scaled(factor), delta * factor, move * factor, turn)


class Sweeps(NamedTuple):
    shapes: Shapes
    events: Events
    pairs: IndexRows
    paths: FloatRows
    found: Floats


def sweep_each(sweeps: Sweeps) -> None:
    """Find the times of impact of all pairs."""
    for p in range(len(sweeps.pairs)):
        row = sweeps.paths[p]
        path = RelativePath(row[0], row[1], row[2], row[3], row[4], row[5])
        s, t = sweeps.pairs[p, 0], sweeps.pairs[p, 1]
        sweeps.found[p] = time_of_impact(
            s, t, False, path, (0.0, 0.0), sweeps.shapes, sweeps.events
        )


sweep_each.__module__ = "tamias2d.engine.test"  # as in a module of the package


def test_compiled_and_plain_sweeps_have_the_same_bits() -> None:
    library = Library("sweeps of the tests", (sweep_each,))
    rng = np.random.default_rng(4)
    shapes = shape_arrays([*SHAPES, half_plane(-2.0)])
    pairs = rng.integers(len(shapes.kind), size=(300, 2)).astype(np.int32)
    paths = rng.normal(size=(300, 6)) * [2, 2, 5, 5, 9, 9]
    results = []
    for is_compiled in (False, True):
        made = library.compiled() if is_compiled else library.plain()
        sweeps = Sweeps(shapes, event_arrays(), pairs, paths, np.zeros(300))
        made.sweep_each(addresses(sweeps) if is_compiled else sweeps)
        results.append(sweeps.found.tolist())
    assert results[0] == results[1]
    assert 30 < sum(value <= 1 for value in results[0]) < 270
