"""Kept manifolds have the gaps of those that are found anew, but for the square of the motion."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st

import tamias2d as t2
from tamias2d.engine.narrow_phase.reuse import move_gaps, note_pose
from tamias2d.engine.tables import FORESEEN, KNOWN_WAY
from tests.engine.cores import Contact, box

BOX = box(1.0, 1.0)
RADII = 2.0**0.5  # of two such boxes, m
ROUND = 1e-14  # what rounding does to gaps near 1 m
SMALL = st.floats(-1e-3, 1e-3)


def found(dx: float, gap: float, angle_a: float, angle_b: float) -> Contact:
    """Return the contact of one box above another one, which are turned by small angles."""
    contact = Contact()
    contact.collide(BOX.turned(angle_a), BOX.turned(angle_b), np.array([dx, 1.0 + gap]))
    return contact


def moved(contact: Contact, dx: float, gap: float, turns: tuple[float, float], most: float) -> bool:
    return move_gaps(dx, 1.0 + gap, *turns, RADII, most, contact.manifold)


@given(st.floats(-0.8, 0.8), SMALL, SMALL, SMALL, SMALL, SMALL, st.floats(0.0, 1.0))
def test_gaps_follow_the_bodies_to_first_order(
    dx: float, gap: float, lean: float, by: float, turn_a: float, turn_b: float, size: float
) -> None:
    kept = found(dx, gap, lean, 0.0)
    by, turn_a, turn_b = size * by, size * turn_a, size * turn_b
    new = found(dx + by, gap - by, lean + turn_a, turn_b)
    if kept.count < 2 or new.features != kept.features or (new.normal @ kept.normal < 0.999):
        return
    note_pose(dx, 1.0 + gap, lean, 0.0, 0.0, kept.manifold)
    assert moved(kept, dx + by, gap - by, (lean + turn_a, turn_b), 1.0)
    way = kept.manifold[KNOWN_WAY]
    most = (abs(by) + abs(turn_a) + abs(turn_b)) * (way + abs(lean))  # slopes times motions
    assert np.abs(kept.gaps - new.gaps).max() <= 4.0 * most + ROUND


@pytest.mark.parametrize("change", [(1.1e-3, 0.0), (0.0, 1.1e-3), (float("nan"), 0.0)])
def test_a_manifold_is_found_anew_after_its_way(change: tuple[float, float]) -> None:
    kept = found(0.2, 0.0, 0.0, 0.0)
    note_pose(0.2, 1.0, 0.0, 0.0, 0.0, kept.manifold)
    before = kept.gaps.copy()
    assert not moved(kept, 0.2 + change[0], 0.0, (change[1], 0.0), 1e-3)
    assert np.array_equal(kept.gaps, before)


def test_the_ways_of_steps_add_up() -> None:
    kept = found(0.2, 0.0, 0.0, 0.0)
    note_pose(0.2, 1.0, 0.0, 0.0, 0.0, kept.manifold)
    taken = [moved(kept, 0.2 + 3e-4 * k, 0.0, (0.0, 0.0), 1e-3) for k in range(1, 6)]
    assert taken == [True, True, True, False, False]


def test_manifolds_of_another_instant_or_pose_are_not_kept() -> None:
    kept = found(0.2, 0.0, 0.0, 0.0)
    assert not moved(kept, 0.2, 0.0, (0.0, 0.0), 1e-3)  # its pose was never noted
    note_pose(0.2, 1.0, 0.0, 0.0, 0.0, kept.manifold)
    kept.manifold[FORESEEN] = 1e-3
    assert not moved(kept, 0.2, 0.0, (0.0, 0.0), 1e-3)


def test_boxes_at_rest_keep_their_manifolds(monkeypatch: pytest.MonkeyPatch) -> None:
    kept: list[bool] = []

    def noted(*given: Any) -> bool:
        kept.append(move_gaps(*given))
        return kept[-1]

    monkeypatch.setattr("tamias2d.engine.narrow_phase.manifold.move_gaps", noted)
    scene = t2.Scene(gravity=(0.0, -9.81))
    surface = {"friction": 0.5, "restitution": 0.0}
    scene.add_static(t2.Box(width=9.0, height=1.0), position=(0.0, -0.5), **surface)
    for k in range(3):
        shape = t2.Box(width=1.0, height=1.0)
        scene.add_body(shape, mass=1.0, position=(0.0, 0.5 + k), **surface)
    sim = t2.Simulator(scene, time_step=1 / 60, compiled=False)
    sim.step(60)
    kept.clear()
    sim.step(4)
    assert kept == [True] * 12
