"""Energy, momentum and angular momentum of all that moves.

Serves: runs, for their energy and momenta. Hides: which bodies count, and how their shares are
summed.
"""

import numpy as np

from tamias2d.generated import definitions
from tamias2d.motion.energy import energy_between
from tamias2d.scene import Scene
from tamias2d.state import Array, History


def balance(scene: Scene, history: History) -> tuple[Array, Array, Array]:
    """Return energy (k,), momentum (k, 2) and angular momentum (k,) of all that moves."""
    moving = [i for i, body in enumerate(scene.bodies) if body.dynamic]
    mass = np.array([scene.bodies[i].mass for i in moving])
    inertia = np.array([scene.bodies[i].inertia for i in moving])
    inertia[~np.isfinite(inertia)] = 0.0  # it cannot turn, and 0 times infinity is nothing
    position = (history.position[:, moving, 0], history.position[:, moving, 1])
    velocity = (history.velocity[:, moving, 0], history.velocity[:, moving, 1])
    spin = history.angular_velocity[:, moving]
    kinetic = definitions.kinetic_energy(mass, velocity, inertia, spin)
    potential = definitions.potential_energy(mass, scene.gravity, position)
    momentum = definitions.momentum(mass, velocity)
    turning = definitions.angular_momentum(mass, position, velocity, inertia, spin)
    return (
        (kinetic + potential).sum(axis=-1) + energy_between(scene, history),
        np.stack([part.sum(axis=-1) for part in momentum], axis=-1),
        turning.sum(axis=-1),
    )
