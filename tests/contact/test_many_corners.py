"""Bodies of many corners: what numpy finds for all of them at once has the bits of a loop."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.contact import gap
from tamias2d.contact.core import cores_of, place
from tamias2d.state import State


def scene_of(corners: int) -> t2.Scene:
    """Two wheels, one above the other, above the ground."""
    angles = np.linspace(0.0, math.tau, corners + 1)[:-1]
    wheel = t2.Polygon(vertices=np.column_stack((np.cos(angles), np.sin(angles))))
    scene = t2.Scene(gravity=(0.0, -10.0))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, friction=0.5, restitution=0.3)
    for position in ((0.0, 1.2), (0.05, 3.5)):
        scene.add_body(wheel, mass=1.0, position=position, restitution=0.3, friction=0.5)
    return scene


@pytest.mark.parametrize("turn", [0.0, 0.3, 2.0])
def test_gaps_along_all_sides_have_the_bits_of_a_loop(
    turn: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    bodies = cores_of(scene_of(100))[1:]
    at = (State((0.1, 0.2), 0.1, (0.0, 0.0), 0.0), State((0.4, 2.3), turn, (0.0, 0.0), 0.0))
    a, b = (place(core, state) for core, state in zip(bodies, at, strict=True))
    found = gap.axes(a, b)
    monkeypatch.setattr(gap, "_MANY", math.inf)
    assert found == gap.axes(a, b)
