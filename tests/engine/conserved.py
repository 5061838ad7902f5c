"""What is conserved by all that moves in a simulator."""

import numpy as np

from tamias2d.engine.tables import INVERSE_INERTIA
from tamias2d.simulator import Simulator
from tamias2d.state import Array


def totals(sim: Simulator) -> tuple[Array, float, float]:
    """Momentum, angular momentum about the origin and kinetic energy of all dynamic bodies."""
    sim.step(0)
    free = sim.dynamic
    mass = sim.mass[free]
    inertia = 1.0 / sim._engine.world.state.properties[: len(free)][free, INVERSE_INERTIA]
    place, velocity, spin = sim.position[free], sim.velocity[free], sim.angular_velocity[free]
    turning = mass * (place[:, 0] * velocity[:, 1] - place[:, 1] * velocity[:, 0])
    energy = 0.5 * (mass * (velocity**2).sum(axis=1) + inertia * spin**2).sum()
    return mass @ velocity, float((turning + inertia * spin).sum()), float(np.asarray(energy))
