"""Two bodies that meet in flight keep their angular momentum (IM17).

Those that had contacts do not end a step with the velocity of their path, and then an impact on the
path is not quite one of the velocities. What it gives both is taken from their motion as one.
"""

from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.motion_sums import no_motion, place_at_end, with_motion_of
from tamias2d.engine.energy.angular_momentum import as_one, can_turn, return_motion, suffices
from tamias2d.engine.energy.step_energy import mass_and_inertia
from tamias2d.engine.tables import Bodies
from tamias2d.generated.definitions import angular_momentum, kinetic_energy
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
    turned_i, turned_j = is_turned(i, i, before, bodies), is_turned(j, i, before, bodies)
    sums = no_motion()
    sums = with_motion_of(i, turned_i, origin, sums, bodies)
    sums = with_motion_of(j, turned_j, origin, sums, bodies)
    energy = sums.energy
    one = as_one(sums.mass, sums.moment, sums.along, sums.about, sums.turning)
    room = before.energy - after.energy
    if not (can_turn(one, sums.about) and suffices(one, given, energy, room)):
        return
    for k in (i, j):
        turned = turned_i if k == i else turned_j
        place = place_at_end(k, origin, bodies)
        return_motion(one, given, energy, turned, place, bodies.motion[k])


def is_turned(k: int, first: int, before: Turning, bodies: Bodies) -> bool:
    """Return whether the impact has turned a body, the first one or the other."""
    return bool(bodies.motion[k, tb.SPIN] != (before.spin_i if k == first else before.spin_j))
