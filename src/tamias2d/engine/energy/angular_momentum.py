"""Free islands keep their angular momentum: what their contacts have given them goes back (IM17).

The arms of contacts are those of the begin of the step, and their two ends go apart in it. What
that gives an island is added up and taken from its motion as one, by which no contact opens or
closes. An island is free if it touches nothing but itself. Where none is, nothing is added up.

Cost: where some are free, two visits to each body in a substep; otherwise one to each contact when
those that touch change.
"""

from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.island_damping import add_to_island, place_from, spin_is_changed
from tamias2d.engine.energy.step_energy import mass_and_inertia
from tamias2d.engine.energy.support import is_root
from tamias2d.engine.islands import update_islands
from tamias2d.engine.tables import Bodies, Constraints, Islands, Joints, Touching
from tamias2d.generated.definitions import kinetic_energy, point_velocity
from tamias2d.generated.island_energy import (
    angular_momentum_given,
    angular_velocity_island,
    angular_velocity_island_returned,
    angular_velocity_returned,
    inertia_island,
    moment_ahead_later,
    moment_ahead_moved,
    position_island,
    returned_share,
    velocity_island,
    velocity_returned,
    velocity_seen,
)
from tamias2d.state import Array, Vector

LEAST_INERTIA = 2.0**-30  # of the inertia about the root: a body alone that nothing turns has none
MOST_GROWTH = 1.0 + 2.0**-6  # of what is left of the motion, so that energy stays


def mark_held_islands(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands, joints: Joints
) -> None:
    """Mark the islands that contacts hold, or that have a body which does not turn."""
    links, held = islands.links, islands.held
    update_islands(bodies, touching, islands, joints)
    for k in range(constraints.counts[tb.ACTIVE]):
        held[links[touching.active[k], tb.ROOT]] = 0
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        if bodies.properties[i, tb.INVERSE_INERTIA] == 0.0:
            held[links[i, tb.ROOT]] = 1
    for k in range(touching.counts[tb.TOUCHING]):
        i, j = touching.body_a[k], touching.body_b[k]
        if bodies.kind[i] != tb.DYNAMIC:
            held[links[j, tb.ROOT]] = 1
        if bodies.kind[j] != tb.DYNAMIC:
            held[links[i, tb.ROOT]] = 1


def count_free_islands(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Count the islands that have contacts, and that nothing holds; mark the bodies of others."""
    held = islands.held
    free = 0
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        held[i] = held[islands.links[i, tb.ROOT]]
        free += is_root(i, bodies, islands) and held[i] == 0
    constraints.counts[tb.FREE_ISLANDS] = free


def begin_moments(first: int, last: int, touching: Touching, islands: Islands) -> None:
    """Begin to add up what contacts give some bodies, of those that nothing holds."""
    for k in range(first, last):
        i = touching.active_by_slab[k]
        if islands.held[i] == 0:
            for n in range(tb.VELOCITY_GIVEN, tb.MOMENT_AHEAD + 1):
                islands.energy[i, n] = 0.0


def add_moments_before(
    substep: float, first: int, last: int, bodies: Bodies, touching: Touching, islands: Islands
) -> None:
    """Add what contacts have given some bodies in a substep, s, with which these move on."""
    for k in range(first, last):
        i = touching.active_by_slab[k]
        given, now = islands.energy[i], bodies.motion[i]
        if islands.held[i] == 0:
            given[tb.MOMENT_AHEAD] = moment_ahead_moved(
                given[tb.MOMENT_AHEAD],
                (now[tb.VX], now[tb.VY]),
                velocity_change(i, bodies),
                substep,
            )


def add_moments(
    first: int, last: int, bodies: Bodies, touching: Touching, islands: Islands
) -> None:
    """Add all that contacts have given some bodies in a substep, after these have moved on."""
    for k in range(first, last):
        i = touching.active_by_slab[k]
        if islands.held[i] == 0:
            add_moment_of(i, bodies, islands.energy[i])


def add_moment_of(i: int, bodies: Bodies, given: Array) -> None:
    """Add what contacts have given a body in a substep."""
    now, state = bodies.motion[i], bodies.substep_state[i]
    by_x, by_y = velocity_change(i, bodies)
    given[tb.VELOCITY_GIVEN] += by_x
    given[tb.VELOCITY_GIVEN + 1] += by_y
    given[tb.ANGULAR_VELOCITY_GIVEN] += state[tb.CONTACT_CHANGE + 2] + (
        now[tb.SPIN] - state[tb.SUBSTEP_START + 2]
    )
    given[tb.MOMENT_AHEAD] = moment_ahead_later(
        given[tb.MOMENT_AHEAD], (now[tb.DX], now[tb.DY]), (by_x, by_y)
    )


def velocity_change(i: int, bodies: Bodies) -> Vector:
    """Return what contacts have changed in the velocity of a body in this substep, m/s."""
    now, state = bodies.motion[i], bodies.substep_state[i]
    return (
        state[tb.CONTACT_CHANGE] + (now[tb.VX] - state[tb.SUBSTEP_START]),
        state[tb.CONTACT_CHANGE + 1] + (now[tb.VY] - state[tb.SUBSTEP_START + 1]),
    )


def keep_angular_momentum(
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
    joints: Joints,
) -> None:
    """Take from free islands what they were given, and note the energy that they have."""
    rows, links = islands.energy, islands.links
    for n in range(islands.counts[tb.ROOTS]):
        row = rows[islands.roots[n]]
        row[tb.ANGULAR_MOMENTUM_GIVEN] = row[tb.ENERGY_PUSHED] = 0.0
        for at in range(tb.ISLAND_MASS, tb.MOMENT_OF_INERTIA + 1):
            row[at] = 0.0
    add_given_by_joints(islands, joints)
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        if is_pushed_and_free(i, bodies, islands):
            add_moment_of(i, bodies, rows[i])
            sum_pushed(i, links[i, tb.ROOT], bodies, islands)
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        row = rows[links[i, tb.ROOT]]
        if is_pushed_and_free(i, bodies, islands) and row[tb.ANGULAR_MOMENTUM_GIVEN] != 0.0:
            return_of_island(i, links[i, tb.ROOT], bodies, islands)


def add_given_by_joints(islands: Islands, joints: Joints) -> None:
    """Add what joints have given mechanisms to what contacts have given their islands."""
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            i = joints.sparse[joints.sparse[n, tb.I_NODE], tb.N_BODY]
            given = joints.numbers[joints.mechanisms[n, tb.M_JOINT], tb.J_MOMENT]
            islands.energy[islands.links[i, tb.ROOT], tb.ANGULAR_MOMENTUM_GIVEN] += given


def is_pushed_and_free(i: int, bodies: Bodies, islands: Islands) -> bool:
    """Return whether contacts have pushed a body, of an island that nothing holds."""
    pushed = (bodies.kind[i] == tb.DYNAMIC) & (bodies.moved[i] == tb.MOVED)
    return bool(pushed & (islands.held[i] == 0))


def sum_pushed(i: int, root: int, bodies: Bodies, islands: Islands) -> None:
    """Add the motion of a body, and what contacts have given it, to those of its island."""
    given, row = islands.energy[i], islands.energy[root]
    mass, inertia = mass_and_inertia(i, bodies.properties)
    start = (
        bodies.pose[i, tb.X] - bodies.pose[root, tb.X],
        bodies.pose[i, tb.Y] - bodies.pose[root, tb.Y],
    )
    now, place = bodies.motion[i], place_from(root, i, bodies)
    row[tb.ANGULAR_MOMENTUM_GIVEN] += angular_momentum_given(
        mass,
        start,
        (given[tb.VELOCITY_GIVEN], given[tb.VELOCITY_GIVEN + 1]),
        given[tb.MOMENT_AHEAD],
        inertia,
        given[tb.ANGULAR_VELOCITY_GIVEN],
    )
    inertia = inertia if spin_is_changed(i, bodies, islands) else 0.0
    velocity = velocity_seen((now[tb.VX], now[tb.VY]), (row[tb.REFERENCE], row[tb.REFERENCE + 1]))
    add_to_island(mass, inertia, place, velocity, now[tb.SPIN], row)
    row[tb.ENERGY_PUSHED] += kinetic_energy(mass, velocity, inertia, now[tb.SPIN])


def return_of_island(i: int, root: int, bodies: Bodies, islands: Islands) -> None:
    """Give a body the motion that it has where its island has its angular momentum."""
    row = islands.energy[root]
    mass, inertia = mass_and_inertia(i, bodies.properties)
    now, reference = bodies.motion[i], (row[tb.REFERENCE], row[tb.REFERENCE + 1])
    one = as_one(
        row[tb.ISLAND_MASS],
        (row[tb.MOMENT_X], row[tb.MOMENT_Y]),
        (row[tb.MOMENTUM_X], row[tb.MOMENTUM_Y]),
        row[tb.MOMENT_OF_INERTIA],
        row[tb.ANGULAR_MOMENTUM],
    )
    seen = velocity_seen((now[tb.VX], now[tb.VY]), reference)
    before = kinetic_energy(mass, seen, inertia, now[tb.SPIN])
    turned = spin_is_changed(i, bodies, islands)
    if not can_turn(one, row[tb.MOMENT_OF_INERTIA]):
        return
    now[tb.VX], now[tb.VY] = seen
    return_motion(
        one,
        row[tb.ANGULAR_MOMENTUM_GIVEN],
        row[tb.ENERGY_PUSHED],
        turned,
        place_from(root, i, bodies),
        now,
    )
    seen = (now[tb.VX], now[tb.VY])
    row[tb.ENERGY_KEPT] += kinetic_energy(mass, seen, inertia, now[tb.SPIN]) - before
    now[tb.VX], now[tb.VY] = seen[0] + reference[0], seen[1] + reference[1]


class AsOne(NamedTuple):
    """The motion of some bodies as one (DD38)."""

    mass: float  # kg
    place: Vector  # m, of the centre of mass
    velocity: Vector  # m/s
    inertia: float  # kg m^2
    spin: float  # rad/s


def as_one(mass: float, moment: Vector, along: Vector, about: float, turning: float) -> AsOne:
    """Return the motion as one of bodies, from sums over them.

    These are masses, kg, their moments, kg m, momenta, kg m/s, and about the origin inertias,
    kg m^2, and angular momenta, kg m^2/s.
    """
    place, velocity = position_island(moment, mass), velocity_island(along, mass)
    inertia = inertia_island(about, mass, place)
    return AsOne(
        mass,
        place,
        velocity,
        inertia,
        angular_velocity_island(turning, mass, place, velocity, inertia),
    )


def can_turn(one: AsOne, about: float) -> bool:
    """Return whether bodies have an inertia as one, besides what rounding leaves of a sum."""
    return one.inertia > LEAST_INERTIA * about


def suffices(one: AsOne, given: float, energy: float, room: float) -> bool:
    """Return whether bodies have the energy for their angular momentum, J, with some more to take.

    They may not where their paths are far from what their velocities say.
    """
    spin = angular_velocity_island_returned(one.spin, given, one.inertia)
    least = kinetic_energy(one.mass, one.velocity, one.inertia, spin)
    return least <= energy + max(room, 0.0)


def return_motion(
    one: AsOne, given: float, energy: float, turned: bool, place: Vector, now: Array
) -> None:
    """Give a body the motion that it has without the angular momentum given to all, kg m^2/s.

    The energy is that of all of them, J.
    """
    spin = angular_velocity_island_returned(one.spin, given, one.inertia)
    least = kinetic_energy(one.mass, one.velocity, one.inertia, one.spin)
    later = kinetic_energy(one.mass, one.velocity, one.inertia, spin)
    share = returned_share(energy, least, later, MOST_GROWTH) if energy > least else 1.0
    arm = (place[0] - one.place[0], place[1] - one.place[1])
    before = point_velocity(one.velocity, one.spin, arm)
    after = point_velocity(one.velocity, spin, arm)
    now[tb.VX], now[tb.VY] = velocity_returned((now[tb.VX], now[tb.VY]), before, after, share)
    if turned:
        now[tb.SPIN] = angular_velocity_returned(now[tb.SPIN], one.spin, spin, share)
