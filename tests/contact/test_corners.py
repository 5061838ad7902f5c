"""Two corners that meet: the normal is the line of their approach, or near it (GD11)."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings, strategies as st

import tamias2d as t2
from tamias2d.contact import Refusal
from tamias2d.contact.core import cores_of, place
from tamias2d.contact.gap import axes, resolution
from tamias2d.contact.manifold import manifold
from tamias2d.state import State

BOX = t2.Box(width=1, height=1)


def corner_on_corner(velocity: tuple[float, float], spin: float, restitution: float) -> t2.Scene:
    """A square whose lower left corner is at the upper right one of a static square in 1 s."""
    scene = t2.Scene(gravity=(0, 0))
    scene.add_static(BOX, position=(-0.5, -0.5))
    x, y = (0.5 - v for v in velocity)
    scene.add_body(
        BOX,
        mass=1,
        position=(x, y),
        velocity=velocity,
        orientation=-spin,
        angular_velocity=spin,
        restitution=restitution,
    )
    return scene


@pytest.mark.parametrize("angle", [0.1, 0.5, math.pi / 4, 1.2])
def test_the_normal_is_the_line_of_approach(angle: float) -> None:
    speed = 2 * math.cos(angle), 2 * math.sin(angle)
    run = t2.simulate(corner_on_corner((-speed[0], -speed[1]), 0.0, 1.0), duration=1.5)
    np.testing.assert_allclose(run.impacts.normal[0], (speed[0] / 2, speed[1] / 2), atol=1e-12)
    assert run.impacts.time[0] == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize("velocity", [(1.0, -1.0), (-1.0, 1.0)])
def test_corners_that_pass_each_other_do_not_meet(velocity: tuple[float, float]) -> None:
    """They touch at one instant, and nothing hinders them."""
    run = t2.simulate(corner_on_corner(velocity, 0.0, 1.0), duration=1.5)
    assert len(run.impacts) == 0
    assert (run.velocity[-1, 1] == velocity).all()


@settings(max_examples=300, deadline=None, derandomize=True)
@given(
    st.floats(-3, -0.01),
    st.floats(-3, -0.01),
    st.floats(-0.3, 0.3),
    st.floats(0.1, 1),
)
def test_no_energy_is_gained(u: float, v: float, spin: float, restitution: float) -> None:
    try:
        run = t2.simulate(
            corner_on_corner((u, v), spin, restitution), duration=1.2, method=t2.ClosedForm()
        )
    except Refusal as refusal:
        run = refusal.run
    assume(len(run.impacts))
    assert (np.diff(run.energy) <= 1e-13 * run.energy[0]).all()


@pytest.mark.parametrize("tilt", [1e-3, 1e-8])
def test_a_corner_that_has_lasted_on_a_side_keeps_it_at_its_end(tilt: float) -> None:
    """A tilted box slides down beside another one, and ends where corner is upon corner."""
    scene = t2.Scene(gravity=(0, 0))
    for x in (0.0, 1.0):
        scene.add_body(BOX, mass=1, position=(x, 0))
    left, right = cores_of(scene)
    stands = place(left, State((0.0, 0.0), 0.0, (0.0, 0.0), 0.0))
    x, y = place(right, State((0.0, 0.0), -tilt, (0.0, 0.0), 0.0)).corners[0]
    lasting = []
    for height in (0.0, -0.5):
        slides = place(right, State((0.5 - x, height - y), -tilt, (0.0, -1.0), 0.0))
        tolerance = resolution(stands, slides, 1.0)
        lasting = manifold(stands, slides, tolerance, 1.0, lasting)
        (contact,) = lasting
        assert contact.normal == (1.0, 0.0)
        assert contact.axis.side == left.sides[1]


@pytest.mark.parametrize("tilt", [2e-9, 1e-8])
def test_a_corner_lies_on_the_side_beside_it_where_sides_are_nearly_parallel(tilt: float) -> None:
    """The other side touches as well as float64 can tell, but ends short of the other corner."""
    scene = t2.Scene(gravity=(0, 0))
    for x in (0.0, 1.0):
        scene.add_body(BOX, mass=1, position=(x, 0))
    left, right = cores_of(scene)
    stands = place(left, State((0.0, 0.0), 0.0, (0.0, 0.0), 0.0))
    x, y = place(right, State((0.0, 0.0), -tilt, (0.0, 0.0), 0.0)).corners[0]
    for above in (1e-7, -1e-7):
        leans = place(right, State((0.5 - x, above - 0.5 - y), -tilt, (0.0, 0.0), 0.0))
        touching = [axis for axis in axes(stands, leans) if axis.gap > -1e-14]
        assert len(touching) == 2
        (contact,) = manifold(stands, leans, resolution(stands, leans, 1.0), 1.0)
        side = (left.sides[1], False) if above > 0 else (right.sides[3], True)
        assert (contact.axis.side, contact.axis.swapped) == side
