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


@pytest.mark.parametrize("far", [0.0, 1e2, 1e6])
@pytest.mark.parametrize("size", [0.01, 1.0])
@pytest.mark.parametrize("shape", ["disc", "box"])
def test_a_corner_is_struck_once_wherever_it_is(shape: str, size: float, far: float) -> None:
    """What is one point is so by the resolution of positions there, not by their size."""
    core = {"disc": t2.Disc(radius=0.3 * size), "box": t2.Box(width=0.8 * size, height=0.4 * size)}
    surface = {"friction": 0.4, "restitution": 0.5}
    vertices = ((2.0 * size, -0.5 * size), (0.0, 0.0), (-2.0 * size, -0.3 * size))
    for aside in np.linspace(-0.01, 0.01, 7) * size:
        scene = t2.Scene(gravity=(0.0, -9.81 * size))
        at = (far + float(aside), 0.7 * far + size)
        scene.add_body(core[shape], mass=1.0, position=at, orientation=0.05, **surface)
        scene.add_static(t2.Chain(vertices=vertices), position=(far, 0.7 * far), **surface)
        first = t2.simulate(scene, duration=0.45, method=t2.ClosedForm()).impacts
        assert (first.time < first.time[0] + 1e-9).sum() == 1


def test_what_a_joint_holds_strikes_a_corner() -> None:
    """It was refused: two impacts of one body, with a joint between."""
    vertices = ((2.0, -1.0), (0.0, 0.0), (-2.0, -1.0))
    hill = t2.Polygon(vertices=(vertices[2], vertices[0], vertices[1]))
    found = []
    for ground, at in ((t2.Chain(vertices=vertices), (0.0, 0.0)), (hill, hill.centroid)):
        scene = t2.Scene(gravity=(0.0, -9.81))
        for y in (1.0, 2.0):
            scene.add_body(t2.Disc(radius=0.2), mass=1.0, position=(0.02, y), restitution=0.5)
        scene.add_joint(t2.Distance(), 0, 1)
        scene.add_static(ground, position=at, restitution=0.5)
        found.append(t2.simulate(scene, duration=0.5, method=t2.Reference()))
    assert len(found[0].impacts) == len(found[1].impacts) == 1
    assert np.allclose(found[0].position[:, :2], found[1].position[:, :2], rtol=0.0, atol=1e-9)
