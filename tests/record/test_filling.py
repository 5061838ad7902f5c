"""What fills an area: by points drawn at random, all of it is covered, and nothing beside it."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.record import drawing

SEED = 20261129
SHAPES = {
    "square": t2.Box(width=1.0, height=1.0),
    "plank": t2.Box(width=4.0, height=0.2),
    "post": t2.Box(width=0.2, height=4.0),
    "triangle": t2.Polygon(vertices=[(0.0, 0.0), (1.0, 0.0), (0.5, 0.9)]),
    "heptagon": t2.Polygon(
        vertices=[(math.cos(angle), math.sin(angle)) for angle in np.arange(7) * 2 * math.pi / 7]
    ),
    "bevelled": t2.Polygon(vertices=[(0.0, 0.0), (2.0, 0.0), (2.0, 0.9), (1.9, 1.0), (0.0, 1.0)]),
}


def covered(shape: t2.Box | t2.Polygon, points: np.ndarray, *, coarse: bool) -> np.ndarray:
    """Whether points (p, 2) are on a line as a viewer draws it: wide, and ended by half a disc."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(shape, mass=1.0, position=(0.0, 0.0))
    view = drawing.View(center=(0.0, 0.0), half=(1.0, 1.0))
    found = np.zeros(len(points), dtype=bool)
    for lines, half in drawing.look(scene.bodies[0], view, coarse=coarse).areas:
        for a, b in zip(lines[:, :-1].reshape(-1, 2), lines[:, 1:].reshape(-1, 2), strict=True):
            along = b - a
            share = np.clip((points - a) @ along / max(along @ along, 1e-300), 0, 1)
            found |= np.hypot(*(points - a - share[:, None] * along).T) <= half
    return found


def inside(shape: t2.Box | t2.Polygon, points: np.ndarray) -> np.ndarray:
    found = np.ones(len(points), dtype=bool)
    corners = np.array(shape.vertices)
    for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        (dx, dy), (x, y) = b - a, (points - a).T
        found &= dx * y - dy * x > -1e-12
    return found


@pytest.mark.parametrize("coarse", [False, True])
@pytest.mark.parametrize("name", SHAPES)
def test_all_of_a_shape_is_filled_and_nothing_else(name: str, coarse: bool) -> None:
    shape = SHAPES[name]
    size = 1.2 * np.abs(shape.vertices).max(axis=0)
    points = np.random.default_rng(SEED).uniform(-size, size, (20_000, 2))
    within, drawn = inside(shape, points), covered(shape, points, coarse=coarse)
    if not coarse or isinstance(shape, t2.Box):  # lines that end at a slope leave it a little
        assert not (drawn & ~within).any()
    # round ends leave the corners of a few lines; those of rings, as wide as the rim is drawn
    assert drawn[within].mean() > (0.8 if coarse else 0.997)


def test_a_crowd_has_fewer_points_to_send() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(SHAPES["square"], mass=1.0, position=(0.0, 0.0))
    view = drawing.View(center=(0.0, 0.0), half=(1.0, 1.0))
    fine, coarse = (
        sum(lines.shape[0] * lines.shape[1] for lines, _ in look.areas)
        for look in (drawing.look(scene.bodies[0], view, coarse=c) for c in (False, True))
    )
    assert (fine, coarse) == (15, 6)
