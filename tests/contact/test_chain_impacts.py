"""Impacts on chains are those on the same surface in one piece (IM16): also at their vertices.

While pieces took part one by one, a corner was struck twice, and of 147 whole runs over a corner 14
ended elsewhere, and 20 were refused.
"""

from typing import Any

import numpy as np
import pytest

import tamias2d as t2

SHAPES = {
    "disc": t2.Disc(radius=0.3),
    "box": t2.Box(width=0.8, height=0.4),
    "capsule": t2.Capsule(length=0.6, radius=0.15),
}


def run(ground: Any, at: tuple[float, float], seed: int, *, friction: float) -> t2.Run:
    """Return how a random body falls on static ground."""
    chance = np.random.default_rng(seed)
    surface = {"friction": friction, "restitution": float(chance.choice([0.0, 0.6]))}
    flat = chance.random() < 0.5
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_body(
        SHAPES[str(chance.choice(list(SHAPES)))],
        mass=1.0,
        position=(chance.uniform(-0.3, 0.3), chance.uniform(0.6, 1.2)),
        velocity=(chance.uniform(-1.0, 1.0), 0.0),
        orientation=0.0 if flat else chance.uniform(-0.4, 0.4),
        angular_velocity=0.0 if flat else chance.uniform(-2.0, 2.0),
        **surface,
    )
    scene.add_static(ground, position=at, **surface)
    return t2.simulate(scene, duration=0.7, method=t2.ClosedForm())


@pytest.mark.parametrize("friction", [0.0, 0.2])
@pytest.mark.parametrize("seed", range(9))  # the tenth lasts on both pieces: refused (GD8)
def test_a_corner_is_struck_as_that_of_a_polygon(seed: int, friction: float) -> None:
    left, right = np.random.default_rng(seed + 100).uniform(0.1, 1.0, 2)
    vertices = ((2.0, -float(right)), (0.0, 0.0), (-2.0, -float(left)))
    hill = t2.Polygon(vertices=(vertices[2], vertices[0], vertices[1]))
    whole = run(hill, hill.centroid, seed, friction=friction)
    chain = run(t2.Chain(vertices=vertices), (0.0, 0.0), seed, friction=friction)
    # rounding in gaps decides after how many ever smaller impacts bodies are at rest
    assert np.allclose(chain.position[:, 0], whole.position[:, 0], rtol=0.0, atol=1e-8)
    assert np.allclose(chain.impacts.impulse[:1], whole.impacts.impulse[:1], rtol=1e-9, atol=0.0)
    assert not any("A18" in note for note in chain.notes)


@pytest.mark.parametrize("friction", [0.0, 0.2])
@pytest.mark.parametrize("seed", range(10))
def test_a_level_chain_is_struck_as_a_half_plane(seed: int, friction: float) -> None:
    inner = np.sort(np.random.default_rng(seed + 100).uniform(-1.0, 1.0, 5))[::-1]
    vertices = ((20.0, 0.0), *((float(x), 0.0) for x in inner), (-20.0, 0.0))
    chain = run(t2.Chain(vertices=vertices), (0.0, 0.0), seed, friction=friction)
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    whole = run(floor, (0.0, 0.0), seed, friction=friction)
    assert np.allclose(chain.position[:, 0], whole.position[:, 0], rtol=0.0, atol=1e-8)
    assert not any("A18" in note for note in chain.notes)
