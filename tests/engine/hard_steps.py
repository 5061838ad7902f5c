"""Hard steps, counted, and compared with a located run."""

from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine import step as engine_step, tables as tb
from tamias2d.engine.motion.hard_discs import take_hard_steps
from tamias2d.engine.tables import World
from tamias2d.simulator import Simulator

STEP = 1 / 60  # s


@contextmanager
def counted(taken: list[int]) -> Iterator[None]:
    """Note how many hard steps each call of plain code takes within this."""

    def noted(world: World) -> None:
        before = int(world.control.counts[tb.STEPS_LEFT])
        take_hard_steps(world)
        taken.append(before - int(world.control.counts[tb.STEPS_LEFT]))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(engine_step, "take_hard_steps", noted)
        yield


def assert_as_located(scene: t2.Scene, steps: int, *, place: float, speed: float) -> t2.Run:
    """Assert that all steps are hard, and within so many m and m/s of a run, which is returned."""
    run = t2.simulate(scene, duration=(steps + 1) * STEP, times=np.arange(steps + 2) * STEP)
    sim = Simulator(scene, time_step=STEP, compiled=False)
    taken: list[int] = []
    with counted(taken):
        for k in range(1, steps + 1):
            sim.step()
            np.testing.assert_allclose(sim.position, run.position[k], rtol=0.0, atol=place)
            np.testing.assert_allclose(sim.velocity, run.velocity[k], rtol=0.0, atol=speed)
    assert sum(taken) == steps
    return run
