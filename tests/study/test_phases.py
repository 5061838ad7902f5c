"""Ensembles: the same motion, started later."""

import numpy as np
import pytest

from tamias2d.errors import InputError
from tamias2d.scene import Scene
from tamias2d.simulate import simulate
from tamias2d.study.phases import phases

FIRST = np.sqrt(2 / 9.81)


def test_phases_meet_their_first_impact_the_sooner_the_later_they_start(bounce: Scene) -> None:
    scenes = phases(bounce, 1.0, 32, first_impact=FIRST)
    met = [simulate(scene, duration=1.0).impacts.time[0] for scene in scenes]
    assert len(scenes) == 32
    assert scenes[0] is bounce
    assert np.all(np.diff(met) < 0)
    assert met[-1] > FIRST / 2 - 1e-12
    speeds = [simulate(scene, duration=1.0).impacts.normal_velocity[0] for scene in scenes]
    assert speeds == pytest.approx([-9.81 * FIRST] * 32, rel=1e-12)  # of one motion


def test_phases_are_the_same_each_time(bounce: Scene) -> None:
    one, other = (phases(bounce, 1.0, 5, first_impact=FIRST) for _ in range(2))
    assert [scene.digest() for scene in one] == [scene.digest() for scene in other]


def test_loads_that_follow_the_clock_cannot_start_later(bounce: Scene) -> None:
    bounce.add_field(force=("1[N]*sin(1[rad/s]*time)", 0.0))
    assert phases(bounce, 1.0, 32, first_impact=FIRST) == [bounce]


def test_no_phase_at_all_is_refused(bounce: Scene) -> None:
    with pytest.raises(InputError, match="phases 0: must be 1 or more"):
        phases(bounce, 1.0, 0, first_impact=FIRST)
