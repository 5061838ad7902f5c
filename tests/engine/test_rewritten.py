"""What a world that begins anew need not restore: arrays that no step reads before it writes."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine.arrays.world import gathered, named_arrays
from tamias2d.simulator import Simulator

SHAPES = (t2.Disc(radius=0.2), t2.Box(width=0.4, height=0.3), t2.Capsule(length=0.4, radius=0.1))
REWRITTEN = (
    "constraints.blocks", "constraints.scratch", "constraints.colour_counts", "islands.energy",
    "events.scratch", "events.met_points", "events.due", "events.touched", "events.ahead",
    "events.partners", "events.reaches", "bodies.path", "chunks.course", "chunks.stream",
    "chunks.asleep", "log.rows", "log.manifolds",
)  # fmt: skip


def heap(seed: int) -> Simulator:
    """Discs alone, or of all kinds, that fall on a floor and a block, bounce and rest."""
    random = np.random.default_rng(seed)
    scene = t2.Scene(gravity=(0.0, -9.81))
    for shape, place in ((t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), (0.0, 0.0)),
                         (t2.Box(width=1.0, height=1.0), (3.0, 0.5)))[: 1 + seed % 2]:  # fmt: skip
        scene.add_static(shape, position=place, restitution=0.3, friction=0.5)
    for k in range(3 + 2 * seed):
        scene.add_body(
            SHAPES[k % 3 if seed % 2 else 0], mass=1.0, position=(0.5 * k - 1.0, 1.0 + 0.3 * k),
            velocity=random.normal(0.0, 2.0, 2), restitution=(0.0, 0.5, 0.9)[k % 3], friction=0.4,
        )  # fmt: skip
    return Simulator(scene, time_step=1 / 60)


@pytest.mark.parametrize("name", REWRITTEN)
def test_what_is_in_them_before_changes_no_bit(name: str) -> None:
    for seed in range(4):
        digests = set()
        for poison in (None, 7.0, math.nan):
            sim = heap(seed)
            sim._settle_between()
            _ = sim._engine.argument  # which may make arrays longer
            values = named_arrays(sim._engine.world)[name]
            if poison is not None:
                values[...] = poison if values.dtype.kind == "f" else 7
            sim.step(150)
            digests.add(sim.digest())
        assert len(digests) == 1


def test_these_are_all_that_lie_behind_what_matters() -> None:
    sim = heap(1)
    sim._settle_between()
    _ = sim._engine.argument
    world, memory, needed = gathered(sim._engine.world)
    begin = memory.__array_interface__["data"][0] + needed
    behind = {
        name
        for name, values in named_arrays(world).items()
        if values.size and values.__array_interface__["data"][0] >= begin
    }
    assert behind == set(REWRITTEN)
