"""Box2D v3, by way of pyb2d3, as one more candidate: the engine that most 2D games are made with.

It takes equal steps of 4 substeps, and slow impacts bounce, too. Between two steps positions are
interpolated linearly. An impact happens for it at the end of the step that finds it, and it tells
no impulses.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from tamias2d.balance import balance
from tamias2d.cost import Cost
from tamias2d.motion import Method
from tamias2d.run import Impacts, Run
from tamias2d.scene import Scene
from tamias2d.state import Array
from tamias2d.study.engines.box2d import Box2D
from tamias2d.study.peers import between_steps


@dataclass(frozen=True)
class Pyb2d3(Method):
    """Stands in a run for the engine that made it."""

    fixed_step = True


def simulate(scene: Scene, *, duration: float, steps: int, times: Iterable[float]) -> Run:
    """Run a scene by Box2D in equal steps, and sample it at sorted times, s.

    Raises:
        PeerError: pyb2d3 is not installed, or is not told what the scene asks.
    """
    dt = duration / steps
    world = Box2D(scene, dt, listens=True, slowest_bounce=0.0)
    wanted = np.array(list(times))
    before = np.clip(np.floor(wanted / dt).astype(np.int64), 0, steps - 1)
    states = _states(world, np.unique(np.concatenate((before, before + 1))).tolist())
    first, second = (np.array([states[k] for k in (before + n).tolist()]) for n in (0, 1))
    ends = np.array([round(time / dt) for time, _ in world.hits], dtype=np.int64)
    history = between_steps(first, second, wanted / dt - before, np.isin(before + 1, ends))
    energy, momentum, angular_momentum = balance(scene, history)
    return Run(
        scene=scene,
        method=Pyb2d3(),
        duration=duration,
        time_step=dt,
        times=wanted,
        **history._asdict(),
        impacts=_impacts(world),
        energy=energy,
        momentum=momentum,
        angular_momentum=angular_momentum,
        notes=(f"Box2D by pyb2d3: {steps} equal steps",),
        cost=Cost(steps=steps, rejected=0, force_evaluations=steps, impacts=len(world.hits)),
    )


def _states(world: Box2D, needed: list[int]) -> dict[int, Array]:
    """Return the states (n, 6) after so many steps; angles are next to the last ones seen."""
    done, found = 0, {}
    state = world.state()
    for count in needed:
        world.step(count - done)
        now = world.state()
        now[:, 2] -= math.tau * np.round((now[:, 2] - state[:, 2]) / math.tau)
        done, state = count, now
        found[count] = now
    return found


def _impacts(world: Box2D) -> Impacts:
    count = len(world.hits)
    unknown = np.full(count, math.nan)
    return Impacts(
        time=np.array([time for time, _ in world.hits]),
        bodies=np.array([pair for _, pair in world.hits], dtype=np.int64).reshape(-1, 2),
        point=np.full((count, 2), math.nan),
        normal=np.full((count, 2), math.nan),
        impulse=unknown,
        normal_velocity=unknown,
    )
