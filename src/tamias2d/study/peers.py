"""Pymunk as one more candidate: an independent engine that many would take instead.

It takes equal steps, as a game does; between two of them positions are interpolated linearly. An
impact happens for it at the end of the step that finds it.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tamias2d.balance import balance
from tamias2d.cost import Cost
from tamias2d.motion import Method
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.state import Array, History
from tamias2d.study.engines.deferred import deferred_interrupts
from tamias2d.study.pymunk_world import Push, World, version


@dataclass(frozen=True)
class Pymunk(Method):
    """Stands in a run for the engine that made it."""

    fixed_step = True


def simulate(
    scene: Scene,
    *,
    duration: float,
    steps: int,
    times: Iterable[float],
    push: Push | None = None,
) -> Run:
    """Run a scene by Pymunk in equal steps, and sample it at sorted times, s.

    Loads that vary are computed by the scene's own laws, which takes most of the time; `push`, from
    a body of Pymunk to force components and torque, is what a user of Pymunk would write instead.

    Raises:
        PeerError: Pymunk is not installed, or cannot do what the scene asks; the message says what.
    """
    world = World(scene, push)
    dt = duration / steps
    grid = np.linspace(0.0, duration, steps + 1)
    wanted = np.array(list(times))
    before = np.clip(np.searchsorted(grid, wanted, side="right") - 1, 0, steps - 1)
    needed = np.unique(np.concatenate((before, before + 1))).tolist()
    states = {0: world.state()}
    struck = np.zeros(steps, dtype=bool)
    with deferred_interrupts() as raise_interrupt:
        for k in range(steps):
            struck[k] = world.step(float(grid[k + 1]), dt)
            if needed[0] <= k + 1 <= needed[-1]:
                states[k + 1] = world.state()
            raise_interrupt()
    first, second = (np.array([states[k] for k in (before + n).tolist()]) for n in (0, 1))
    history = between_steps(first, second, (wanted - grid[before]) / dt, struck[before])
    energy, momentum, angular_momentum = balance(scene, history)
    return Run(
        scene=scene,
        method=Pymunk(),
        duration=duration,
        time_step=dt,
        times=wanted,
        **history._asdict(),
        impacts=world.hits.impacts(),
        energy=energy,
        momentum=momentum,
        angular_momentum=angular_momentum,
        notes=(f"Pymunk {version()}: {steps} equal steps",),
        cost=Cost(steps=steps, rejected=0, force_evaluations=steps, impacts=len(world.hits.time)),
    )


def between_steps(first: Array, second: Array, share: Array, struck: NDArray[np.bool_]) -> History:
    """Return states between the ends of steps (k, n, 6): straight lines, but for velocities in
    steps in which something was struck (k,), which jump at the end.
    """
    along = np.clip(share, 0.0, 1.0)[:, None, None] * np.ones(6)
    jumps = np.broadcast_to(np.arange(6) >= 3, along.shape) & struck[:, None, None]
    rows = first + np.where(jumps, np.floor(along), along) * (second - first)
    return History(rows[..., :2], rows[..., 2], rows[..., 3:5], rows[..., 5])
