"""A motion ahead of a path comes through an impact as the closed form of a bounce says."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.contact import Passing, SingleImpact, after_impact
from tamias2d.contact.core import cores_of, place
from tamias2d.contact.manifold import manifold
from tamias2d.state import State

G, RADIUS, RESTITUTION = 10.0, 0.5, 0.8
WEIGHT = (0.0, -G, 0.0)


def impact_of(speed: float) -> tuple[list[object], SingleImpact, dict[int, Passing]]:
    """A disc that meets the floor at a speed, in m/s, at 1 s: a path in closed form."""
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_body(
        t2.Disc(radius=RADIUS), mass=2.0, position=(0.0, RADIUS), restitution=RESTITUTION
    )
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0))
    cores = cores_of(scene)
    before = State((0.0, RADIUS), 0.0, (3.0, -speed), 2.0)
    after = before._replace(velocity=(3.0, RESTITUTION * speed))
    still = State((0.0, 0.0), 0.0, (0.0, 0.0), 0.0)
    (contact,) = manifold(place(cores[0], before), place(cores[1], still), 1e-12, 1.0)
    paths = {
        0: Passing(before, WEIGHT, after, WEIGHT),
        1: Passing(still, (0.0,) * 3, still, (0.0,) * 3),
    }
    return cores, SingleImpact(1.0, contact, RESTITUTION, 0.0), paths  # type: ignore[return-value]


@pytest.mark.parametrize("height", [-0.02, 1e-6, 0.02])
@pytest.mark.parametrize("rise", [-0.1, 0.0, 0.1])
def test_it_is_that_of_the_closed_form(height: float, rise: float) -> None:
    """Not to the first order alone: under a constant weight to rounding."""
    cores, met, paths = impact_of(4.0)
    ahead = np.array([[0.01, height, 0.2], [0.3, rise, -0.4]])
    found = after_impact(cores, met, paths, {0: ahead})  # type: ignore[arg-type]
    assert found is not None
    delay, now = found
    fall = 4.0 - rise
    later = (-fall + math.sqrt(fall**2 + 2 * G * height)) / G
    assert delay == pytest.approx(later, abs=1e-14)
    up = RESTITUTION * (fall + G * later) + G * later  # at the time of the path's impact
    place_then = -up * later + G * later**2 / 2
    exact = [[0.01, place_then, 0.2], [0.3, up - RESTITUTION * 4.0, -0.4]]
    assert now[0] == pytest.approx(np.array(exact), abs=1e-13)
    assert set(now) == {0}


def test_one_that_may_not_meet_says_nothing() -> None:
    cores, met, paths = impact_of(0.1)
    ahead = np.array([[0.0, -1e-3, 0.0], [0.0, 0.08, 0.0]])
    assert after_impact(cores, met, paths, {0: ahead}) is None  # type: ignore[arg-type]
