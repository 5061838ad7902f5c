"""A segment that slides along a piece of terrain into a hollow stays on the next piece."""

import math

import pytest

import tamias2d as t2


@pytest.mark.parametrize("one_sided", [True, False])
def test_a_segment_that_slides_into_a_hollow_does_not_pass_the_floor(one_sided: bool) -> None:
    """It goes five eighths of its length a step, so that its tip is past the corner at once."""
    slope, length, speed = 1.158, 0.264, 9.89
    x, y = math.cos(slope), math.sin(slope)
    scene = t2.Scene(gravity=(0, -9.81))
    vertices = [(4 * x, 4 * y), (0, 0), (-4, -0.15)]
    ground = t2.Chain(vertices=vertices, one_sided=one_sided)
    scene.add_static(ground, friction=0, restitution=0)
    body = scene.add_body(
        t2.Segment(length=length), mass=1, position=(x - 1e-4 * y, y + 1e-4 * x),
        orientation=slope, velocity=(-speed * x, -speed * y), friction=0, restitution=0,
    )  # fmt: skip
    sim = t2.Simulator(scene)
    for _ in range(40):
        sim.step()
        below = 0.15 / 4 * sim.position[body, 0]
        assert sim.position[body, 1] > below - 0.5 * length
