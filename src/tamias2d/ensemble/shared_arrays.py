"""Arrays that many engines share, each of which has a row of them.

Serves: `Simulators`. Hides: how the arrays of engines are put there.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.arrays.memory import aligned_zeros
from tamias2d.engine.tables import GRAVITY_X, GRAVITY_Y, INVERSE_MASS
from tamias2d.simulator import Simulator
from tamias2d.state import Array, IntArray


@dataclass(frozen=True)
class SharedArrays:
    """What all engines work on: a row for each world, then for each body."""

    pose: Array
    velocity: Array
    load: Array
    gravity: Array
    counts: IntArray
    joint_counts: IntArray
    kind: NDArray[np.int8]
    inverse_mass: Array
    generation: IntArray
    sims: tuple[Simulator, ...]

    @property
    def asleep(self) -> NDArray[np.bool_]:
        """Which bodies sleep: a new array (w, n)."""
        return np.stack([sim.asleep for sim in self.sims])


def shared_arrays(sims: tuple[Simulator, ...]) -> SharedArrays:
    """Let all engines work on arrays that lie one after the other."""
    engines = [sim._engine for sim in sims]
    size, world = engines[0].size, engines[0].world
    pose, velocity, load, properties, settings, counts, joint_counts = (
        aligned_zeros((len(sims), *array.shape), array.dtype)
        for array in (
            world.state.pose,
            world.state.velocity,
            world.state.load,
            world.state.properties,
            world.control.settings,
            world.control.counts,
            world.joints.counts,
        )
    )
    for k, (sim, engine) in enumerate(zip(sims, engines, strict=True)):
        state, control = engine.world.state, engine.world.control
        pose[k], velocity[k], load[k] = state.pose, state.velocity, state.load
        properties[k] = state.properties
        settings[k], counts[k] = control.settings, control.counts
        joint_counts[k] = engine.world.joints.counts
        engine.replace(
            state__pose=pose[k],
            state__velocity=velocity[k],
            state__load=load[k],
            state__properties=properties[k],
            control__settings=settings[k],
            control__counts=counts[k],
            joints__counts=joint_counts[k],
        )
        sim._look()
    return SharedArrays(
        pose=pose[:, :size],
        velocity=velocity[:, :size],
        load=load[:, :size],
        gravity=settings[:, GRAVITY_X : GRAVITY_Y + 1],
        counts=counts,
        joint_counts=joint_counts,
        kind=np.stack([engine.kind for engine in engines]),
        inverse_mass=properties[:, :size, INVERSE_MASS],
        generation=np.stack([engine.generation for engine in engines]),
        sims=sims,
    )
