"""The kinetic share of the energy of a run, which the run itself keeps only in the whole.

Serves: pictures and the viewer. Hides: how the share is found.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tamias2d.generated import definitions

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tamias2d.run import Run


def kinetic_energy(run: Run, part: slice) -> NDArray[np.float64]:
    """Kinetic energy of all bodies together at a part of the samples, (samples,), J."""
    moving = [i for i, body in enumerate(run.scene.bodies) if body.dynamic]
    mass = np.array([run.scene.bodies[i].mass for i in moving])
    inertia = np.array([run.scene.bodies[i].inertia for i in moving])
    inertia[~np.isfinite(inertia)] = 0.0  # what cannot turn has no energy of rotation
    velocity = (run.velocity[part, moving, 0], run.velocity[part, moving, 1])
    energies = definitions.kinetic_energy(
        mass, velocity, inertia, run.angular_velocity[part, moving]
    )
    total: NDArray[np.float64] = energies.sum(axis=-1)
    return total
