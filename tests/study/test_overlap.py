"""The overlap that engines are judged by, against support functions and known places.

Two convex hulls are apart by the largest gap between them along any direction, and overlap by the
least if that is negative; here the directions are sampled.
"""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

import tamias2d as t2
from tamias2d.study.engines.overlap import separations, worst

TURNS = np.linspace(0.0, math.tau, 20_000, endpoint=False)
DIRECTIONS = np.stack((np.cos(TURNS), np.sin(TURNS)))


def hull(sides, size, x, y, angle):
    turns = angle + math.tau * np.arange(sides) / sides
    return np.stack((x + size * np.cos(turns), y + size * np.sin(turns)), axis=1)


hulls = st.builds(
    hull,
    st.integers(1, 8),
    st.floats(0.1, 2.0),
    st.floats(-1.5, 1.5),
    st.floats(-1.5, 1.5),
    st.floats(0.0, 7.0),
)


@given(hulls, hulls)
def test_separation_is_the_largest_gap_along_any_direction(first, second):
    gaps = (second @ DIRECTIONS).min(axis=0) - (first @ DIRECTIONS).max(axis=0)
    found = separations(first[None], second[None])[0]
    # a gap changes with the angle by at most the distance of two points, below 8.3; half a step
    assert found == pytest.approx(gaps.max(), abs=8.3 * math.pi / len(TURNS))
    assert found == pytest.approx(separations(second[None], first[None])[0], abs=1e-12)


def state_of(scene):
    return np.array(
        [(*b.position, b.orientation, *b.velocity, b.angular_velocity) for b in scene.bodies]
    )


def test_the_deepest_pair_of_many_is_found():
    scene = t2.Scene(gravity=(0.0, 0.0))
    for k in range(200):
        scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(k % 20 * 1.1, k // 20 * 1.1))
    scene.add_body(t2.Disc(radius=0.25), mass=1.0, position=(-0.6, 5.5))
    found = worst(scene, state_of(scene))
    assert found.depth == pytest.approx(0.15)  # 0.5 + 0.25 - 0.6
    assert found.share == pytest.approx(0.6)


def test_what_lies_in_a_half_plane_is_measured_from_its_surface():
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(t2.HalfPlane(normal=(0.6, 0.8), offset=1.0))
    box = t2.Box(width=0.4, height=0.2)
    angle = math.atan2(4.0, 3.0) - math.pi / 2  # its lower side along the surface
    scene.add_body(box, mass=1.0, position=(0.6 * 1.05, 0.8 * 1.05), orientation=angle)
    found = worst(scene, state_of(scene))
    assert found.depth == pytest.approx(0.05)
    assert found.share == pytest.approx(0.5)


def test_parts_of_one_body_do_not_overlap_each_other_and_touch_others():
    scene = t2.Scene(gravity=(0.0, 0.0))
    parts = [t2.Part(shape=t2.Disc(radius=1.0), position=(x, 0.0)) for x in (-0.5, 0.5)]
    scene.add_body(t2.Compound(parts=parts), mass=1.0, position=(0.0, 0.0))
    scene.add_body(t2.Capsule(length=2.0, radius=0.3), mass=1.0, position=(2.7, 0.0))
    assert worst(scene, state_of(scene)).depth == pytest.approx(0.1)  # 0.5 + 1 - (2.7 - 1 - 0.3)
    for x in (9.0, 9.5):  # neither of them moves
        scene.add_static(t2.Box(width=1.0, height=1.0), position=(x, 0.0))
    assert worst(scene, state_of(scene)).depth == pytest.approx(0.1)
