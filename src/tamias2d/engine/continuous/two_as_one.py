"""Two bodies that meet in flight keep their angular momentum (IM17).

Those that had contacts do not end a step with the velocity of their path, and then an impact on the
path is not quite one of the velocities. What it gives both is taken from their motion as one.
"""

from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.solver.angular_momentum import as_one, can_turn, return_motion, suffices
from tamias2d.engine.solver.energy import mass_and_inertia
from tamias2d.engine.tables import Bodies
from tamias2d.generated.definitions import angular_momentum, kinetic_energy, momentum
from tamias2d.generated.island_energy import inertia_origin, mass_moment
from tamias2d.state import Vector

ROUNDED = 1e-15  # of what an angular momentum is the sum of


class Turning(NamedTuple):
    """The angular momentum of two bodies at the end of the step, before they meet."""

    origin: Vector  # m
    whole: float  # kg m^2/s
    size: float  # kg m^2/s, of what it is the sum of
    energy: float  # J
    spin_i: float  # rad/s
    spin_j: float


def keeps_turning(i: int, j: int, bodies: Bodies) -> bool:
    """Return whether nothing but each other changes the angular momentum of two bodies."""
    flight, properties = bodies.flight, bodies.properties
    pushed = abs(flight[i, tb.FORCE_GAIN] - flight[j, tb.FORCE_GAIN])
    pushed += abs(flight[i, tb.FORCE_GAIN + 1] - flight[j, tb.FORCE_GAIN + 1])
    turns = properties[i, tb.INVERSE_INERTIA] * properties[j, tb.INVERSE_INERTIA]
    return bool((pushed == 0.0) & (turns > 0.0))


def place_at_end(i: int, origin: Vector, bodies: Bodies) -> Vector:
    """Return where a body is at the end of the step from some place, m."""
    pose, now = bodies.pose[i], bodies.motion[i]
    return (pose[tb.X] - origin[0]) + now[tb.DX], (pose[tb.Y] - origin[1]) + now[tb.DY]


def turning_of(i: int, j: int, origin: Vector, bodies: Bodies) -> Turning:
    """Return the angular momentum of two bodies about some place, m."""
    whole = size = energy = 0.0
    for k in (i, j):
        mass, inertia = mass_and_inertia(k, bodies.properties)
        now = bodies.motion[k]
        own = angular_momentum(
            mass, place_at_end(k, origin, bodies), (now[tb.VX], now[tb.VY]), inertia, now[tb.SPIN]
        )
        whole, size = whole + own, size + abs(own)
        energy += kinetic_energy(mass, (now[tb.VX], now[tb.VY]), inertia, now[tb.SPIN])
    return Turning(
        origin, whole, size, energy, bodies.motion[i, tb.SPIN], bodies.motion[j, tb.SPIN]
    )


def return_turning(i: int, j: int, before: Turning, bodies: Bodies) -> None:
    """Give two bodies back the angular momentum that they had before they met."""
    origin = before.origin
    after = turning_of(i, j, origin, bodies)
    given = after.whole - before.whole
    if abs(given) <= ROUNDED * max(before.size, after.size):
        return
    mass = about = turning = energy = x = y = by_x = by_y = 0.0
    for k in (i, j):
        own, inertia = mass_and_inertia(k, bodies.properties)
        inertia = inertia if is_turned(k, i, before, bodies) else 0.0
        now, place = bodies.motion[k], place_at_end(k, origin, bodies)
        velocity = (now[tb.VX], now[tb.VY])
        along, moment = momentum(own, velocity), mass_moment(own, place)
        mass, x, y = mass + own, x + moment[0], y + moment[1]
        by_x, by_y = by_x + along[0], by_y + along[1]
        about += inertia_origin(own, place, inertia)
        turning += angular_momentum(own, place, velocity, inertia, now[tb.SPIN])
        energy += kinetic_energy(own, velocity, inertia, now[tb.SPIN])
    one = as_one(mass, (x, y), (by_x, by_y), about, turning)
    room = before.energy - after.energy
    if not (can_turn(one, about) and suffices(one, given, energy, room)):
        return
    turned_i, turned_j = is_turned(i, i, before, bodies), is_turned(j, i, before, bodies)
    for k in (i, j):
        turned = turned_i if k == i else turned_j
        place = place_at_end(k, origin, bodies)
        return_motion(one, given, energy, turned, place, bodies.motion[k])


def is_turned(k: int, first: int, before: Turning, bodies: Bodies) -> bool:
    """Return whether the impact has turned a body, the first one or the other."""
    return bool(bodies.motion[k, tb.SPIN] != (before.spin_i if k == first else before.spin_j))
