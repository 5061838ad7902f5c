"""Sums over bodies that meet in flight, from which their motion as one follows (IM17)."""

from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.step_energy import mass_and_inertia
from tamias2d.engine.tables import Bodies
from tamias2d.generated.definitions import angular_momentum, kinetic_energy, momentum
from tamias2d.generated.island_energy import inertia_origin, mass_moment
from tamias2d.state import Vector


class MotionSums(NamedTuple):
    """Sums over bodies at the end of the step, about some origin."""

    mass: float  # kg
    moment: Vector  # kg m, of the masses
    along: Vector  # kg m/s, momentum
    about: float  # kg m^2, inertia about the origin
    turning: float  # kg m^2/s, angular momentum about it
    energy: float  # J, kinetic


def place_at_end(i: int, origin: Vector, bodies: Bodies) -> Vector:
    """Return where a body is at the end of the step from some place, m."""
    pose, now = bodies.pose[i], bodies.motion[i]
    return (pose[tb.X] - origin[0]) + now[tb.DX], (pose[tb.Y] - origin[1]) + now[tb.DY]


def no_motion() -> MotionSums:
    """Return the sums over no body."""
    return MotionSums(0.0, (0.0, 0.0), (0.0, 0.0), 0.0, 0.0, 0.0)


def with_motion_of(
    k: int, turned: bool, origin: Vector, sums: MotionSums, bodies: Bodies
) -> MotionSums:
    """Return sums to which a body is added, with or without its spin."""
    mass, inertia = mass_and_inertia(k, bodies.properties)
    inertia = inertia if turned else 0.0
    now, place = bodies.motion[k], place_at_end(k, origin, bodies)
    velocity = (now[tb.VX], now[tb.VY])
    along, moment = momentum(mass, velocity), mass_moment(mass, place)
    return MotionSums(
        sums.mass + mass,
        (sums.moment[0] + moment[0], sums.moment[1] + moment[1]),
        (sums.along[0] + along[0], sums.along[1] + along[1]),
        sums.about + inertia_origin(mass, place, inertia),
        sums.turning + angular_momentum(mass, place, velocity, inertia, now[tb.SPIN]),
        sums.energy + kinetic_energy(mass, velocity, inertia, now[tb.SPIN]),
    )
