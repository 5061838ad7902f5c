"""Compiled code has the bits of the same code as plain Python, and of the general way."""

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.event_driven import EventDriven, follower, tables
from tamias2d.solve import sampler
from tests.event_driven.conftest import Solving
from tests.event_driven.scenes import crowd
from tools.measurements.impacts import gas


@pytest.mark.parametrize("way", ["compiled", "plain", "alternating"])
@pytest.mark.parametrize("seed", range(24))
def test_every_way_has_the_bits_of_the_general_one(solving: Solving, way: str, seed: int) -> None:
    """Impacts, rests, friction, corners, and what is refused: up to there, and why."""
    scene = crowd(seed)
    (wanted, why), (found, found_why) = (solving(scene, each, 1.5) for each in ("general", way))
    assert found_why == why
    assert found.digest() == wanted.digest()
    assert found.notes == wanted.notes


def test_a_gas_has_these_bits_in_every_way(solving: Solving) -> None:
    runs = [solving(gas(20, seed=3), way, 0.3)[0] for way in ("general", "plain", "compiled")]
    assert len(runs[0].impacts) > 60
    assert len({run.digest() for run in runs}) == 1


def test_a_search_that_is_not_decided_is_left_to_the_general_way(
    solving: Solving, monkeypatch: pytest.MonkeyPatch
) -> None:
    code, calls = follower.compiled_code(), iter((tables.DONE, tables.DONE))

    def undecided(world: tables.World) -> int:
        world.numbers[tables.LIMIT] = min(world.numbers[tables.NOW] + 0.05, 0.3)
        code(world)
        return next(calls, tables.SEARCH)

    monkeypatch.setattr(follower, "compiled_code", lambda: undecided)
    found, _ = solving(gas(20, seed=3), "compiled", 0.3)
    assert next(calls, None) is None
    wanted, _ = solving(gas(20, seed=3), "general", 0.3)
    assert found.digest() == wanted.digest()


def test_paths_at_any_time_are_those_of_the_general_way(
    solving: Solving, monkeypatch: pytest.MonkeyPatch
) -> None:
    scene, times = gas(12, seed=1), np.linspace(0.0, 0.5, 23)
    run, _ = solving(scene, "compiled", 0.5)
    assert len(run.impacts) > 40
    found = sampler(run)(times, range(len(scene)))
    monkeypatch.setattr(EventDriven, "pays", lambda *_: False)
    wanted = sampler(run)(times, range(len(scene)))
    for name, values in found._asdict().items():
        np.testing.assert_array_equal(values, getattr(wanted, name))


def test_the_work_limit_ends_a_run_at_the_same_impact(solving: Solving) -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    for x in (-1.0, 1.0):
        wall = t2.HalfPlane(normal=(-x, 0.0), offset=-1.0)
        scene.add_static(wall, restitution=1.0, name=f"wall at {x}")
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(0.0, 0.0), velocity=(10.0, 0.0))
    given = {"duration": 300.0, "work_limit": 1200, "times": np.linspace(0.0, 300.0, 50)}
    general, compiled = (solving(scene, way, **given) for way in ("general", "compiled"))
    assert general[1].startswith("run at")
    assert compiled[1] == general[1]
    assert compiled[0].digest() == general[0].digest()
