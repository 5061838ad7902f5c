"""What forces give a body in flight along its path, and what is taken back where that changes.

A step gives a velocity what forces do to it in all of the step, and thus the energy that they give
along all of the path. Where the path is changed and no impulse changes the velocity as much, the
difference is taken back, so that kinetic energy rises by no more than the work of forces (DD36). It
is seen from the other body, which may move.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.trajectory import relative_place
from tamias2d.engine.energy.step_energy import can_be_turned, mass_and_inertia
from tamias2d.engine.energy.support import share_left
from tamias2d.engine.energy.velocity_change import product_with_motion, reduce_along
from tamias2d.engine.tables import Bodies, Control
from tamias2d.generated.definitions import kinetic_energy, point_velocity
from tamias2d.generated.island_energy import (
    angular_velocity_damped,
    angular_velocity_seen,
    damped_share,
    energy_along_given,
    velocity_damped,
    velocity_seen,
    work,
)
from tamias2d.state import Array, Vector


def support_velocity(i: int, j: int, now: float, pose: Array, motion: Array) -> Vector:
    """Return the velocity that a body i would have as a part of j, m/s."""
    at = relative_place(j, i, now, pose, motion)
    return point_velocity((motion[j, tb.VX], motion[j, tb.VY]), motion[j, tb.SPIN], at)


def energy_seen(
    i: int, velocity: Vector, turning: float, support: Vector, spin: float, properties: Array
) -> float:
    """Return the kinetic energy of a body as seen from its support, J.

    It has a velocity, m/s, and a spin, rad/s.
    """
    mass, inertia = mass_and_inertia(i, properties)
    seen = velocity_seen(velocity, support)
    return kinetic_energy(mass, seen, inertia, angular_velocity_seen(turning, spin))


def work_ahead(i: int, left: float, control: Control, bodies: Bodies) -> float:
    """Return the work of forces along the path that a body has left of a step, J."""
    mass, _ = mass_and_inertia(i, bodies.properties)
    return work(
        mass,
        (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y]),
        (bodies.load[i, 0], bodies.load[i, 1]),
        bodies.load[i, 2],
        (left * bodies.motion[i, tb.DX], left * bodies.motion[i, tb.DY]),
        left * bodies.motion[i, tb.DANGLE],
    )


def take_impulse_back(
    i: int,
    surplus: float,
    given: Vector,
    turned: float,
    support: Vector,
    spin: float,
    motion: Array,
    properties: Array,
) -> float:
    """Take a surplus from what an impact gave a body; return what of it is left (DD88), J.

    The impact changed its velocity, m/s, and its spin, rad/s. Nothing else is taken: what a smooth
    surface does not push keeps its velocity along it.
    """
    mass, inertia = mass_and_inertia(i, properties)
    product = product_with_motion(i, given, turned, support, spin, motion, properties)
    change = kinetic_energy(mass, given, inertia, turned)
    if not (surplus > 0.0 and product > 0.0 and change > 0.0):
        return surplus
    along = energy_along_given(product, change)
    share = share_left(along, max(along - surplus, 0.0))
    reduce_along(given, turned, share, product, change, motion[i])
    return max(surplus - along, 0.0)


def take_energy_back(
    i: int, surplus: float, support: Vector, spin: float, motion: Array, properties: Array
) -> None:
    """Take a surplus from a body's energy as seen from its support, J, if it is positive."""
    row = motion[i]
    energy = energy_seen(i, (row[tb.VX], row[tb.VY]), row[tb.SPIN], support, spin, properties)
    if surplus > 0.0 and energy > 0.0:
        share = damped_share(energy, max(energy - surplus, 0.0), 0.0)
        row[tb.VX], row[tb.VY] = velocity_damped((row[tb.VX], row[tb.VY]), support, share)
        if can_be_turned(i, properties):
            row[tb.SPIN] = angular_velocity_damped(row[tb.SPIN], spin, share)
