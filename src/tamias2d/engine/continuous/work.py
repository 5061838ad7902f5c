"""What forces give a body in flight on its way, and what is taken back where it goes another.

Serves: impacts in flight, and what waits. Hides: from where energy is seen.

A step gives a velocity what forces do to it in all of the step, and thus the energy that they give
on all of the way. Where the way is changed and no impulse changes the velocity as much, the
difference is taken back, so that kinetic energy rises by no more than the work of forces (DD36). It
is seen from what the body meets, which may move.
"""

from tamias2d.engine.continuous.trajectory import offset_at
from tamias2d.engine.solver.energy import mass_and_inertia
from tamias2d.engine.tables import (
    DANGLE,
    DX,
    DY,
    GRAVITY_X,
    GRAVITY_Y,
    SPIN,
    VX,
    VY,
    Bodies,
    Control,
)
from tamias2d.generated.definitions import kinetic_energy, point_velocity
from tamias2d.generated.island_energy import (
    angular_velocity_calmed,
    angular_velocity_seen,
    calm_share,
    velocity_calmed,
    velocity_seen,
    work,
)
from tamias2d.state import Array, Vector


def support_velocity(i: int, j: int, now: float, pose: Array, motion: Array) -> Vector:
    """Return the velocity that a body i would have as a part of j, m/s."""
    at = offset_at(j, i, now, pose, motion)
    return point_velocity((motion[j, VX], motion[j, VY]), motion[j, SPIN], at)


def energy_seen(i: int, support: Vector, spin: float, motion: Array, properties: Array) -> float:
    """Return the kinetic energy of a body as seen from its support, J."""
    mass, inertia = mass_and_inertia(i, properties)
    seen = velocity_seen((motion[i, VX], motion[i, VY]), support)
    return kinetic_energy(mass, seen, inertia, angular_velocity_seen(motion[i, SPIN], spin))


def work_ahead(i: int, left: float, control: Control, bodies: Bodies) -> float:
    """Return the work of forces on the way that a body has left of a step, J."""
    mass, _ = mass_and_inertia(i, bodies.properties)
    return work(
        mass,
        (control.settings[GRAVITY_X], control.settings[GRAVITY_Y]),
        (bodies.load[i, 0], bodies.load[i, 1]),
        bodies.load[i, 2],
        (left * bodies.motion[i, DX], left * bodies.motion[i, DY]),
        left * bodies.motion[i, DANGLE],
    )


def take_energy_back(
    i: int, surplus: float, support: Vector, spin: float, motion: Array, properties: Array
) -> None:
    """Take energy from a body, J, if that is positive, as far as it has some as seen from there."""
    energy = energy_seen(i, support, spin, motion, properties)
    if surplus > 0.0 and energy > 0.0:
        share = calm_share(energy, max(energy - surplus, 0.0), 0.0)
        now = motion[i]
        now[VX], now[VY] = velocity_calmed((now[VX], now[VY]), support, share)
        now[SPIN] = angular_velocity_calmed(now[SPIN], spin, share)
