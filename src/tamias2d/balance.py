"""Energy, momentum and angular momentum of all bodies that move (DD15, DD16)."""

import numpy as np

from tamias2d.generated import definitions
from tamias2d.motion.energy import energy_between
from tamias2d.scene import Scene
from tamias2d.state import Array, History


def balance(scene: Scene, history: History) -> tuple[Array, Array, Array]:
    """Return energy (k,), J, momentum (k, 2), kg m/s, and angular momentum (k,), kg m^2/s."""
    moving, mass, inertia = _inertial(scene)
    position = _components(history.position, moving)
    velocity = _components(history.velocity, moving)
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


def kinetic_energy(scene: Scene, velocity: Array, angular_velocity: Array) -> Array:
    """Return (k,), J, from the velocities (k, n, 2), m/s, and (k, n), rad/s, of all bodies."""
    moving, mass, inertia = _inertial(scene)
    spin = angular_velocity[:, moving]
    energies = definitions.kinetic_energy(mass, _components(velocity, moving), inertia, spin)
    total: Array = energies.sum(axis=-1)
    return total


def uniform_potential_energy(scene: Scene, position: Array) -> Array:
    """Return (k, m), J: of each moving body in uniform gravity, from positions (k, n, 2), m."""
    moving, mass, _ = _inertial(scene)
    energy: Array = definitions.potential_energy(mass, scene.gravity, _components(position, moving))
    return energy


def _inertial(scene: Scene) -> tuple[list[int], Array, Array]:
    """Return the bodies that move, with their masses and inertias."""
    moving = [i for i, body in enumerate(scene.bodies) if body.dynamic]
    mass = np.array([scene.bodies[i].mass for i in moving])
    inertia = np.array([scene.bodies[i].inertia for i in moving])
    inertia[~np.isfinite(inertia)] = 0.0  # it cannot turn, and 0 times infinity is no number
    return moving, mass, inertia


def _components(rows: Array, moving: list[int]) -> tuple[Array, Array]:
    return rows[:, moving, 0], rows[:, moving, 1]
