"""Two bodies that meet in flight keep their angular momentum (IM17).

Those that had contacts do not end a step with the velocity of their path, and then an impact on the
path is not quite one of the velocities. What it gives both is taken from their motion as one, and
from what is left of their energy, if it has risen by that (IM11).
"""

from typing import NamedTuple

from tamias2d.engine.solver.energy import GRACE, mass_and_inertia
from tamias2d.engine.tables import DX, DY, FORCE_GAIN, INVERSE_INERTIA, SPIN, VX, VY, Bodies, X, Y
from tamias2d.generated.definitions import (
    angular_momentum,
    kinetic_energy,
    momentum,
    point_velocity,
)
from tamias2d.generated.island_energy import (
    angular_velocity_damped,
    angular_velocity_island,
    angular_velocity_returned,
    damped_share,
    inertia_island,
    inertia_origin,
    mass_moment,
    position_island,
    velocity_damped,
    velocity_island,
)
from tamias2d.state import Vector

ROUNDED = 1e-15  # of what an angular momentum is the sum of


class TwoAsOne(NamedTuple):
    """What two bodies are together, at the end of the step."""

    mass: float  # kg
    place: Vector  # m, of their centre of mass
    inertia: float  # kg m^2
    velocity: Vector  # m/s
    turning: float  # kg m^2/s, angular momentum about the origin
    size: float  # kg m^2/s, of what that is the sum of
    energy: float  # J


def keeps_turning(i: int, j: int, bodies: Bodies) -> bool:
    """Return whether nothing but each other changes the angular momentum of two bodies."""
    flight, properties = bodies.flight, bodies.properties
    pushed = abs(flight[i, FORCE_GAIN] - flight[j, FORCE_GAIN])
    pushed += abs(flight[i, FORCE_GAIN + 1] - flight[j, FORCE_GAIN + 1])
    turns = properties[i, INVERSE_INERTIA] * properties[j, INVERSE_INERTIA]
    return bool((pushed == 0.0) & (turns > 0.0))


def place_at_end(i: int, origin: Vector, bodies: Bodies) -> Vector:
    """Return where a body is at the end of the step from some place, m."""
    pose, now = bodies.pose[i], bodies.motion[i]
    return (pose[X] - origin[0]) + now[DX], (pose[Y] - origin[1]) + now[DY]


def two_as_one(i: int, j: int, origin: Vector, bodies: Bodies) -> TwoAsOne:
    """Return what two bodies are together, as seen from some place, m."""
    whole = turning = size = energy = about = x = y = by_x = by_y = 0.0
    for k in (i, j):
        mass, inertia = mass_and_inertia(k, bodies.properties)
        now, place = bodies.motion[k], place_at_end(k, origin, bodies)
        velocity = (now[VX], now[VY])
        along, moment = momentum(mass, velocity), mass_moment(mass, place)
        own = angular_momentum(mass, place, velocity, inertia, now[SPIN])
        whole, turning, size = whole + mass, turning + own, size + abs(own)
        x, y, by_x, by_y = x + moment[0], y + moment[1], by_x + along[0], by_y + along[1]
        about += inertia_origin(mass, place, inertia)
        energy += kinetic_energy(mass, velocity, inertia, now[SPIN])
    middle = position_island((x, y), whole)
    return TwoAsOne(
        whole,
        middle,
        inertia_island(about, whole, middle),
        velocity_island((by_x, by_y), whole),
        turning,
        size,
        energy,
    )


def return_turning(i: int, j: int, before: TwoAsOne, origin: Vector, bodies: Bodies) -> None:
    """Give two bodies back the angular momentum that they had before they met."""
    after = two_as_one(i, j, origin, bodies)
    given = after.turning - before.turning
    if abs(given) <= ROUNDED * max(before.size, after.size):
        return
    add_motion_as_one(i, j, after, angular_velocity_returned(given, after.inertia), origin, bodies)
    now = two_as_one(i, j, origin, bodies)
    if now.energy > before.energy * (1.0 + GRACE):
        lose_energy(i, j, now, before.energy, origin, bodies)


def add_motion_as_one(
    i: int, j: int, one: TwoAsOne, spin: float, origin: Vector, bodies: Bodies
) -> None:
    """Let two bodies turn about their centre of mass as one, in addition, rad/s."""
    for k in (i, j):
        now, (x, y) = bodies.motion[k], place_at_end(k, origin, bodies)
        arm = (x - one.place[0], y - one.place[1])
        now[VX], now[VY] = point_velocity((now[VX], now[VY]), spin, arm)
        now[SPIN] += spin


def lose_energy(i: int, j: int, one: TwoAsOne, most: float, origin: Vector, bodies: Bodies) -> None:
    """Let the motion of two bodies come so near to their motion as one that they have no more."""
    spin = angular_velocity_island(one.turning, one.mass, one.place, one.velocity, one.inertia)
    least = kinetic_energy(one.mass, one.velocity, one.inertia, spin)
    share = damped_share(one.energy, most, least) if most > least and one.energy > least else 0.0
    for k in (i, j):
        now, (x, y) = bodies.motion[k], place_at_end(k, origin, bodies)
        arm = (x - one.place[0], y - one.place[1])
        as_one = point_velocity(one.velocity, spin, arm)
        now[VX], now[VY] = velocity_damped((now[VX], now[VY]), as_one, share)
        now[SPIN] = angular_velocity_damped(now[SPIN], spin, share)
