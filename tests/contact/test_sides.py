"""Bodies that touch stay on the side on which they are, whatever comes later on their paths."""

import numpy as np
import pytest

import tamias2d as t2

_RADIUS = 0.5  # m


@pytest.mark.parametrize("speed", [0.1, 1.0, 5.0])
@pytest.mark.parametrize("gap", [1e-12, 1e-10, 1e-8])
@pytest.mark.parametrize("apart", [1.6, 2.0, 3.0])
def test_a_blow_soon_after_two_part_keeps_them_apart(gap, speed, apart):
    """The upper disc leaves the lower one, and is hit while float64 cannot tell them apart yet.

    Its path led past the other one, to below the floor, where it would lie on the other side.
    """
    run = t2.simulate(_hit_from_above(gap, speed, apart), duration=2.0, times=_TIMES)
    assert run.method == t2.ClosedForm()
    assert _least_gap(run) > -1e-13  # rounding; discs that passed were in each other by 0.3 m


def test_frictionless_discs_on_each_other_do_not_sink():
    """What bounces leave of their velocity, 1e-8 m/s, is taken off all that rest together."""
    scene = _hit_from_above(1e-12, 1.0, 3.0)
    run = t2.simulate(scene, duration=20.0, times=np.linspace(0.0, 20.0, 201))
    assert run.method == t2.ClosedForm()
    assert _least_gap(run) > -1e-13


_TIMES = np.linspace(0.0, 2.0, 2001)


def _hit_from_above(gap: float, speed: float, apart: float) -> t2.Scene:
    scene = t2.Scene(gravity=(0.0, -9.81))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.0, friction=0.0, name="floor")
    for name, height, velocity in (
        ("low", _RADIUS, (-apart, 0.0)),
        ("high", 3 * _RADIUS, (apart, 0.0)),
        ("top", 5 * _RADIUS + gap, (apart, -speed)),
    ):
        scene.add_body(
            t2.Disc(radius=_RADIUS),
            mass=1.0,
            position=(0.0, height),
            velocity=velocity,
            restitution=0.0,
            friction=0.0,
            name=name,
        )
    return scene


def _least_gap(run: t2.Run) -> float:
    """Return the least gap of two of the discs at any sample, m."""
    discs = run.position[:, 1:]
    ways = np.linalg.norm(discs[:, [0, 0, 1]] - discs[:, [1, 2, 2]], axis=-1)
    return float(ways.min()) - 2 * _RADIUS
