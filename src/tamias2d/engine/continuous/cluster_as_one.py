"""A cluster keeps its momentum and angular momentum when bodies join it (IM17).

From then on they go the way that they share, but their velocities stay: at the end of the step
these act along other arms. What that gives the cluster is taken from its motion as one; bodies keep
their spins, unless only these can give it. Forces do other work on that way; where they do less,
what is too much is taken from the motion about the centre of mass (DD36).
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.motion_sums import (
    MotionSums,
    no_motion,
    place_at_end,
    with_motion_of,
)
from tamias2d.engine.continuous.two_as_one import ROUNDED
from tamias2d.engine.energy.angular_momentum import as_one, can_turn, return_motion, suffices
from tamias2d.engine.energy.step_energy import can_be_turned, mass_and_inertia
from tamias2d.engine.tables import Bodies, Integers
from tamias2d.generated.definitions import angular_momentum, kinetic_energy
from tamias2d.generated.island_energy import (
    angular_velocity_damped,
    damped_share,
    velocity_damped,
    velocity_island,
)
from tamias2d.state import Vector


def cluster_turning(
    i: int, origin: Vector, bodies: Bodies, together: Integers
) -> tuple[float, float]:
    """Return the angular momentum of a cluster about a place, m, and the sum of its magnitudes.

    Both in kg m^2/s, at the end of the step.
    """
    whole = size = 0.0
    k, begun = i, False
    while k != i or not begun:
        begun = True
        mass, inertia = mass_and_inertia(k, bodies.properties)
        now, place = bodies.motion[k], place_at_end(k, origin, bodies)
        own = angular_momentum(mass, place, (now[tb.VX], now[tb.VY]), inertia, now[tb.SPIN])
        whole, size = whole + own, size + abs(own)
        k = together[k]
    return whole, size


def return_cluster_turning(
    i: int,
    origin: Vector,
    before: tuple[float, float],
    bodies: Bodies,
    together: Integers,
) -> None:
    """Give a cluster back the angular momentum that it had, if it is pushed as one at most."""
    after = cluster_turning(i, origin, bodies, together)
    given = after[0] - before[0]
    rounded = abs(given) <= ROUNDED * max(before[1], after[1])
    if rounded or not is_pushed_as_one(i, bodies, together):
        return
    for turned in (False, True):
        sums = cluster_sums(i, turned, origin, bodies, together)
        energy = sums.energy
        one = as_one(sums.mass, sums.moment, sums.along, sums.about, sums.turning)
        if can_turn(one, sums.about) and suffices(one, given, energy, 0.0):
            k, begun = i, False
            while k != i or not begun:
                begun = True
                spun = turned and can_be_turned(k, bodies.properties)
                place = place_at_end(k, origin, bodies)
                return_motion(one, given, energy, spun, place, bodies.motion[k])
                k = together[k]
            return


def take_energy_of_cluster_back(i: int, surplus: float, bodies: Bodies, together: Integers) -> None:
    """Take a surplus from the energy of a cluster about its centre of mass, J, if there is one."""
    if not surplus > 0.0:
        return
    origin = (bodies.pose[i, tb.X], bodies.pose[i, tb.Y])
    sums = cluster_sums(i, True, origin, bodies, together)
    energy, velocity = sums.energy, velocity_island(sums.along, sums.mass)
    least = kinetic_energy(sums.mass, velocity, 0.0, 0.0)
    if not energy > least:
        return
    share = damped_share(energy, max(energy - surplus, least), least)
    k, begun = i, False
    while k != i or not begun:
        begun = True
        now = bodies.motion[k]
        now[tb.VX], now[tb.VY] = velocity_damped((now[tb.VX], now[tb.VY]), velocity, share)
        now[tb.SPIN] = angular_velocity_damped(now[tb.SPIN], 0.0, share)
        k = together[k]


def is_pushed_as_one(i: int, bodies: Bodies, together: Integers) -> bool:
    """Return whether forces give all bodies of a cluster the same velocity in the step."""
    flight, k = bodies.flight, together[i]
    same = True
    while k != i:
        for n in range(2):
            same = same & (flight[k, tb.FORCE_GAIN + n] == flight[i, tb.FORCE_GAIN + n])
        k = together[k]
    return bool(same)


def cluster_sums(
    i: int, turned: bool, origin: Vector, bodies: Bodies, together: Integers
) -> MotionSums:
    """Return sums over a cluster, with or without the spins of its bodies, about a place, m."""
    sums = no_motion()
    sums = with_motion_of(i, turned, origin, sums, bodies)
    k = together[i]
    while k != i:
        sums = with_motion_of(k, turned, origin, sums, bodies)
        k = together[k]
    return sums
