"""The parts by which discs are followed: the queue, the cells, and lengths."""

import math
from typing import TypeAlias

import numpy as np
import pytest
from numpy.typing import NDArray

import tamias2d as t2
from tamias2d.event_driven import bound, queue, tables
from tamias2d.event_driven.arrangement import states_at, with_cells, world_of
from tamias2d.event_driven.cells import enter, gather
from tamias2d.event_driven.length import hypot, power_of_two
from tamias2d.motion import ClosedForm
from tamias2d.motion.loads import start_states
from tamias2d.scene import Scene
from tools.measurements.impacts import gas

Path: TypeAlias = NDArray[np.float64]
"""Position, velocity and acceleration (3, 2) at the start."""


def world_at_start(scene: Scene) -> tables.World:
    """The tables of a scene at its start, all bodies in their cells."""
    _, paths = (
        ClosedForm().motion(scene, 1.0, 1.0).segment(0.0, start_states(scene), [None] * len(scene))
    )
    world = with_cells(world_of(scene, paths, np.zeros(0), keeps_paths=False), 0.0)
    for body in np.flatnonzero(world.leaving == tables.NOWHERE).tolist():
        enter(body, 0.0, world)
    return world


def test_lengths_are_those_of_the_interpreter() -> None:
    chance = np.random.default_rng(3)
    for x, y in (chance.normal(size=(3000, 2)) * 10 ** chance.uniform(-8, 8, (3000, 2))).tolist():
        assert hypot(x, y) == math.hypot(x, y)
    assert hypot(0.0, 0.0) == 0.0
    for x, y in ((1e308, 1e308), (1.7e308, 1e300), (1e-305, 2e-305), (1e-306, 1e-290)):
        assert hypot(x, y) == math.hypot(x, y)


def test_the_power_of_two_of_a_number_is_that_of_its_exponent() -> None:
    chance = np.random.default_rng(4)
    exponents = chance.integers(-1073, 1023, 3000).tolist()
    for share in (1.0, 1.0 + 2.0**-52, 1.5, 2.0 - 2.0**-52):
        for exponent in exponents:
            x = math.ldexp(share, exponent)
            assert power_of_two(x) == math.ldexp(1.0, math.frexp(x)[1] - 1)


def test_events_come_in_order_and_void_ones_are_dropped() -> None:
    world, chance = world_at_start(gas(40)), np.random.default_rng(1)
    wanted = []
    for time in chance.integers(0, 50, 300).tolist():
        i, j = sorted(chance.choice(44, 2, replace=False).tolist())
        queue.push(float(time), i, j, world)
        wanted.append((float(time), i, j))
    world.notes[7, tables.VERSION] += 1
    queue.drop_void(world)
    found = []
    while world.counts[tables.EVENTS]:
        found.append((world.queue[0], *world.events[0, : tables.FIRST_VERSION].tolist()))
        queue.pop(world)
    assert found == sorted(event for event in wanted if 7 not in event[1:])


def test_all_in_reach_of_a_cell_are_near() -> None:
    world = world_at_start(gas(300, share=0.5))
    assert world.cells.size > 100
    assert world.numbers[tables.CELL] - 2 * world.numbers[tables.SLACK] > 0.02  # a diameter
    everybody = np.arange(len(world.kinds))
    places, found = states_at(world, everybody, 0.0)[:, :2], 0
    for body in np.flatnonzero(world.kinds == tables.DISC).tolist():
        near = set(world.near[: gather(body, world)].tolist())
        assert len(near) < 60
        close = np.abs(places - places[body]).max(axis=1) < world.numbers[tables.CELL]
        close &= (everybody != body) & (world.kinds == tables.DISC)
        found += int(close.sum())
        assert set(np.flatnonzero(close).tolist()) <= near
    assert found > 300


def pair_of(shape: t2.Disc | t2.HalfPlane, fixed: bool, seed: int) -> tuple[t2.Scene, list[Path]]:
    """A disc that flies, and a body that flies as well or is fixed; and how both go."""
    chance = np.random.default_rng(seed)
    scene = t2.Scene(gravity=tuple(chance.normal(0.0, 3.0, 2)))
    place = chance.normal(0.0, 1.0, 2)
    given: list[dict[str, object]] = [{"position": tuple(place.tolist())}]
    given.append({} if isinstance(shape, t2.HalfPlane) else {"position": (3.0, 0.0)})
    for k, body in enumerate((t2.Disc(radius=0.2), shape)):
        if k and fixed:
            scene.add_static(body, restitution=1.0, **given[k])  # type: ignore[arg-type]
            continue
        velocity = chance.normal(0.0, 0.7, 2) + (0 if k else (3.0 - place[0], -place[1]))
        going = {"velocity": tuple(velocity.tolist()), "mass": 1.0}
        scene.add_body(body, restitution=1.0, **given[k], **going)  # type: ignore[arg-type]
    paths = [
        np.array([body.position, body.velocity, scene.gravity if body.dynamic else (0.0, 0.0)])
        for body in scene.bodies
    ]
    return scene, paths


PLANE = t2.HalfPlane(normal=(0.6, 0.8), offset=-4.0)


@pytest.mark.parametrize(
    ("shape", "fixed", "sharp"),
    [(t2.Disc(radius=0.5), False, True), (t2.Disc(radius=0.5), True, False), (PLANE, True, True)],
)
def test_no_pair_meets_before_its_bound(
    shape: t2.Disc | t2.HalfPlane, fixed: bool, sharp: bool
) -> None:
    """Places by numpy, at many times; where the acceleration is alike the bound is the impact."""
    met, limit = 0, 3.0
    for seed in range(60):
        scene, paths = pair_of(shape, fixed, seed)
        early = bound.earliest_meeting(0, 1, 0.0, limit, world_at_start(scene))
        times = np.linspace(0.0, limit, 30_001)
        powers = np.stack((np.ones_like(times), times, times**2 / 2), axis=1)
        span = powers @ paths[0] - powers @ paths[1]
        if isinstance(shape, t2.Disc):
            gap = np.hypot(*span.T) - 0.7
        else:
            gap = span @ shape.normal - shape.offset - 0.2
        if gap[0] <= 0.0:
            continue
        touching = np.flatnonzero(gap <= 0.0)
        assert (gap[times < early] > 0.0).all()
        assert early > 0.0
        if len(touching):
            met += 1
            # circles larger by 1e-6 that only graze overlap for 1 mm of way more; and the grid
            assert not sharp or early > times[touching[0]] - 3e-3
        else:
            assert not sharp or early > limit
    assert met > 10
