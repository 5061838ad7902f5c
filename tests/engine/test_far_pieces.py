"""Pieces of terrain that a body does not touch leave it alone, whatever side of them it is on.

What touches a chain knows its side of all its pieces that follow. A shape may be below the line of
such a piece, beyond its end: only what has come through it is brought back.
"""

import math
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.conservative_advancement import measure_gap, measure_gap_of_piece
from tamias2d.engine.narrow_phase.core import core_of
from tamias2d.engine.narrow_phase.polygon import collide_polygons
from tamias2d.engine.narrow_phase.separation import BROUGHT_BACK
from tests.engine.cores import (
    Outline,
    box,
    capsule,
    regular,
    separation,
    shape_arrays,
)

FAR = 1e100  # m, a margin within which everything is
SURFACE: Any = {"friction": 0.4, "restitution": 0.0}
TRIANGLE = [(0.3 * math.cos(v), 0.3 * math.sin(v)) for v in (0.0, 2.0944, 4.1888)]
HOLLOW = [(2.0, 0.5), (0.0, 0.0), (-2.0, 0.5)]


def told_gap(shape: Outline, at: Any, held: tuple[float, float], length: float = 2.0) -> float:
    """The gap of a shape to a piece along x, whose right side is up, with a normal of before."""
    piece = Outline(np.array([[length / 2, 0.0], [-length / 2, 0.0]]))
    shapes = shape_arrays((piece, shape))
    shapes.kind[0] = tb.PIECE
    a, b, manifold = core_of(0, shapes), core_of(1, shapes), np.zeros(tb.MANIFOLD)
    first, second = collide_polygons(
        manifold, a, b, float(at[0]), float(at[1]), FAR, held, shapes.world_vertices
    )
    assert first > 0
    gap = float(manifold[tb.GAP])
    return min(gap, float(manifold[tb.GAP + tb.POINT])) if second else gap


@pytest.mark.parametrize("seed", range(100))
def test_what_is_beside_a_piece_is_as_far_from_it_as_it_is(seed: int) -> None:
    """Below its line or above it, and whatever normal was held."""
    chance = np.random.default_rng(seed)
    size = float(chance.uniform(0.1, 0.5))
    shapes = (regular(3, size), regular(5, size), box(size, 2 * size), capsule(size, 0.3 * size))
    shape = shapes[seed % 4].turned(float(chance.uniform(-3, 3)))
    at = (float(chance.choice((-1, 1)) * chance.uniform(1.6, 4.0)), float(chance.uniform(-2, 2)))
    lean = chance.uniform(-1.5, 1.5)
    piece = Outline(np.array([[1.0, 0.0], [-1.0, 0.0]]))
    apart = separation(piece, shape, np.array(at)) - shape.radius
    told = told_gap(shape, at, (math.sin(lean), math.cos(lean)))
    assert told == pytest.approx(apart, abs=1e-12)


def test_what_has_come_through_a_piece_is_on_the_side_from_which_it_came() -> None:
    board, up, down = box(0.5, 0.001), (0.0, 1.0), (0.0, -1.0)
    for depth in (1e-12, 1e-3, 0.9 * BROUGHT_BACK * 0.25):
        below = (0.3, -0.0005 - depth)
        assert told_gap(board, below, up) == pytest.approx(-0.001 - depth, abs=1e-12)
        assert told_gap(board, below, down) == pytest.approx(depth, abs=1e-12)
    assert told_gap(board, (0.3, -0.2), up) == pytest.approx(0.1995)  # too far to have done so
    assert told_gap(board, (1.3, -0.01), up) > 0.05  # nor has what is beyond its end


def test_beyond_a_hollow_nothing_is_deep_in_a_piece_that_it_does_not_touch() -> None:
    """A ledge goes up by a step, beyond which the ground goes down: what is there is below it."""
    ledge, up = Outline(np.array([[1.0, 0.0], [-1.0, 0.0]])), (0.0, 1.0)
    shapes = shape_arrays((ledge, regular(3, 0.3)))
    shapes.kind[0] = tb.ONE_SIDED_PIECE
    shapes.material[0, tb.START_COSINE : tb.END_SINE + 1] = 1.0, 0.0, math.cos(1.2), -math.sin(1.2)
    a, b, manifold = core_of(0, shapes), core_of(1, shapes), np.zeros(tb.MANIFOLD)
    for at in ((-1.6, -0.2), (-1.5, -0.6), (-2.5, -0.1), (-1.4, -0.31), (-1.4, 0.1), (-1.7, 0.14)):
        gap = measure_gap(manifold, a, b, *at, up, shapes.world_vertices)
        assert gap == pytest.approx(separation(ledge, regular(3, 0.3), np.array(at)), abs=1e-12)
        _, told = measure_gap_of_piece(
            0, 1, a, b, at, gap, up, manifold, shapes.world_vertices, shapes
        )
        assert told >= gap


def rest(vertices: Any, angle: float, at: float, one_sided: bool) -> t2.Simulator:
    """A triangle that has fallen on a terrain."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.Chain(vertices=vertices, one_sided=one_sided), **SURFACE)
    place: Any = {"position": (at, 1.2), "orientation": angle}
    scene.add_body(t2.Polygon(vertices=TRIANGLE), mass=1.0, **place, **SURFACE)
    sim = t2.Simulator(scene)
    sim.step(240)
    return sim


@pytest.mark.parametrize("one_sided", [True, False])
def test_a_triangle_in_a_hollow_rests_as_if_nothing_were_beyond_the_crest(one_sided: bool) -> None:
    for angle, at in ((-0.65, 0.03), (0.4, 0.3), (2.0, -0.4), (-2.4, 0.8), (1.3, 0.0)):
        sims = [rest([*HOLLOW, *more], angle, at, one_sided) for more in ((), ((-4.0, 0.0),))]
        assert sims[0].contacts.point == pytest.approx(sims[1].contacts.point, abs=1e-6)
        assert sims[0].position[1] == pytest.approx(sims[1].position[1], abs=1e-6)
        assert np.hypot(*sims[1].velocity[1]) < 1e-3


@pytest.mark.parametrize("one_sided", [True, False])
def test_no_contact_with_a_hill_is_far_from_its_body(one_sided: bool) -> None:
    """Triangles, boxes and compounds at up to some m/s: ghosts were up to 4.4 m away."""
    for seed in range(24):
        chance = np.random.default_rng(50_000 + seed)
        places = np.linspace(6, -6, int(chance.integers(4, 12)))
        hill = list(zip(places.tolist(), chance.uniform(0, 1, len(places)).tolist(), strict=True))
        scene = t2.Scene(gravity=(0.0, -9.81))
        scene.add_static(t2.Chain(vertices=hill, one_sided=one_sided), **SURFACE)
        knob = t2.Part(shape=t2.Box(width=0.3, height=0.2), position=(0.2, 0.1))
        bodies = (
            t2.Polygon(vertices=TRIANGLE),
            t2.Box(width=0.4, height=0.25),
            t2.Compound(parts=[t2.Part(shape=t2.Polygon(vertices=TRIANGLE)), knob]),
        )
        for k, shape in enumerate(bodies):
            scene.add_body(
                shape,
                mass=1.0,
                position=(3.0 * k - 3.0 + float(chance.uniform(-0.5, 0.5)), 2.0),
                orientation=float(chance.uniform(-3, 3)),
                velocity=chance.normal(0, 1, 2),
                angular_velocity=float(chance.normal(0, 2)),
                group=-1,
                **SURFACE,
            )
        sim = t2.Simulator(scene)
        for _ in range(150):
            sim.step()
            told = sim.contacts
            pushed = told.impulse > 1e-9
            ways = told.point[pushed] - sim.position[told.bodies[pushed].max(axis=1)]
            speeds = np.hypot(*sim.velocity[told.bodies[pushed].max(axis=1)].T)
            assert (np.hypot(*ways.T) < 0.5 + speeds / 60).all(), seed
