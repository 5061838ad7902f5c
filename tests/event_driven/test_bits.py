"""Compiled code has the bits of the same code as plain Python, and of the general way."""

import math
from collections.abc import Callable

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.event_driven import EventDriven, follower, tables
from tamias2d.solve import sampler
from tests.event_driven.conftest import Solving
from tests.event_driven.scenes import crowd, mixed_crowd
from tools.measurements.impacts import gas, polygon_gas


@pytest.mark.parametrize("way", ["compiled", "plain", "alternating"])
@pytest.mark.parametrize("seed", range(24))
def test_every_way_has_the_bits_of_the_general_one(solving: Solving, way: str, seed: int) -> None:
    """Impacts, rests, friction, corners, and what is refused: up to there, and why."""
    scene = crowd(seed)
    (wanted, why), (found, found_why) = (solving(scene, each, 1.5) for each in ("general", way))
    assert found_why == why
    assert found.digest() == wanted.digest()
    assert found.notes == wanted.notes


@pytest.mark.parametrize("way", ["compiled", "plain", "alternating"])
@pytest.mark.parametrize(
    ("seed", "duration"), [*((seed, 1.0) for seed in range(24)), (5, 1.5), (32, 1.0), (82, 1.0)]
)
def test_all_convex_shapes_have_these_bits_too(
    solving: Solving, way: str, seed: int, duration: float
) -> None:
    """Boxes, polygons, segments, capsules and discs, flying, sliding, tipping, resting."""
    scene = mixed_crowd(seed)
    (wanted, why), (found, found_why) = (
        solving(scene, each, duration) for each in ("general", way)
    )
    assert found_why == why
    assert found.digest() == wanted.digest()
    assert found.notes == wanted.notes


@pytest.mark.parametrize("made", [gas, polygon_gas])
def test_a_gas_has_these_bits_in_every_way(solving: Solving, made: Callable[..., t2.Scene]) -> None:
    runs = [solving(made(20, seed=3), way, 0.3)[0] for way in ("general", "plain", "compiled")]
    assert len(runs[0].impacts) > 60
    assert len({run.digest() for run in runs}) == 1


def test_a_body_may_come_before_what_it_meets(solving: Solving) -> None:
    """The point of an impact is on the corner or rim, whichever body that belongs to."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    for k, shape in enumerate((t2.Disc(radius=0.3), t2.Box(width=0.4, height=0.3))):
        scene.add_body(
            shape, mass=1.0, position=(k / 1.1, 1 / 3), orientation=0.3, restitution=0.9,
            angular_velocity=1.7, velocity=(0.1, 0.0),
        )  # fmt: skip
    slope = t2.HalfPlane(normal=(math.sin(0.1), math.cos(0.1)), offset=-0.7)
    scene.add_static(slope, restitution=0.9)
    (wanted, _), (found, _) = (solving(scene, way, 3.0) for way in ("general", "compiled"))
    assert len(found.impacts) > 6
    assert found.digest() == wanted.digest()


def test_what_rests_has_its_own_loads_when_it_leaves(
    solving: Solving, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A disc slides down a slope, and is taken over there, before it strikes a wall and flies."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    for normal, offset in (((0.6, 0.8), 0.0), ((-0.8, 0.6), -1.0)):
        plane = t2.HalfPlane(normal=normal, offset=offset)
        scene.add_static(plane, restitution=1.0, friction=0.3)
    disc = t2.Disc(radius=0.1)
    scene.add_body(disc, mass=1.0, position=(-0.5, 0.7), restitution=0.6, friction=0.3)
    wanted, _ = solving(scene, "general", 3.0)
    rests = next(float(n.split()[-2]) for n in wanted.notes if n.startswith("rest"))
    last = wanted.impacts.time[wanted.impacts.time <= rests].max()
    assert (wanted.impacts.time > rests).sum() > 2  # it leaves the slope again

    def pays(self: follower.EventDriven, time: float, until: float) -> bool:  # noqa: ARG001
        self.code = follower.compiled_code()
        return time >= last

    monkeypatch.setattr(follower.EventDriven, "pays", pays)
    found = t2.simulate(scene, duration=3.0, times=wanted.times, method=t2.ClosedForm())
    assert found.digest() == wanted.digest()
    assert found.notes == wanted.notes


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


@pytest.mark.parametrize("way", ["compiled", "plain"])
@pytest.mark.parametrize("slope", [0.0, 0.3])
def test_bounces_that_slide_end_with_the_same_bits(
    solving: Solving, way: str, slope: float
) -> None:
    """A disc that slides, and one that sticks, come to rest."""
    scene = t2.Scene(gravity=(9.81 * slope, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), restitution=0.5)
    for x, friction in ((0.0, 0.1), (-9.0, 1.0)):
        scene.add_body(
            t2.Disc(radius=0.3), mass=1.0, position=(x, 0.8), velocity=(20.0 + x, 0.0),
            restitution=0.5, friction=friction,
        )  # fmt: skip
    (wanted, _), (found, _) = (solving(scene, each, 2.0) for each in ("general", way))
    assert sum(note.startswith("rest:") for note in wanted.notes) == 2
    assert found.digest() == wanted.digest()
