"""Free islands keep their angular momentum: what their contacts have given them goes back (IM17).

The arms of contacts are those of the begin of the step, and their two ends go apart in it. What
that gives an island is added up and taken from its motion as one, by which no contact opens or
closes. An island is free if it touches nothing but itself. Where none is, nothing is added up.

Cost: where some are free, two visits to each body in a substep; otherwise one to each contact when
those that touch change.
"""

from tamias2d.engine.islands import update_islands
from tamias2d.engine.joints.stages import hold_tied
from tamias2d.engine.solver.energy import mass_and_inertia
from tamias2d.engine.solver.island_damping import place_from
from tamias2d.engine.solver.support import is_root
from tamias2d.engine.tables import (
    ACTIVE,
    ANGULAR_MOMENTUM,
    ANGULAR_VELOCITY_GIVEN,
    CONTACT_CHANGE,
    DX,
    DY,
    DYNAMIC,
    ENERGY_KEPT,
    FREE_ISLANDS,
    INVERSE_INERTIA,
    IS_HELD,
    ISLAND_MASS,
    MOMENT_AHEAD,
    MOMENT_OF_INERTIA,
    MOMENT_X,
    MOMENT_Y,
    MOVED,
    REFERENCE,
    RETURNED,
    ROOT,
    SPIN,
    SUBSTEP_START,
    TOUCHING,
    VELOCITY_GIVEN,
    VX,
    VY,
    Bodies,
    Constraints,
    Islands,
    Joints,
    Touching,
    X,
    Y,
)
from tamias2d.generated.definitions import kinetic_energy, point_velocity
from tamias2d.generated.island_energy import (
    angular_momentum_given,
    angular_velocity_returned,
    inertia_island,
    inertia_origin,
    mass_moment,
    moment_ahead_later,
    moment_ahead_moved,
    position_island,
    velocity_seen,
)
from tamias2d.state import Array, Vector


def find_free_islands(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands, joints: Joints
) -> None:
    """Mark the islands that something holds, and count the others that have contacts."""
    links, marks = islands.links, islands.energy
    update_islands(bodies, touching, islands, joints)
    for k in range(constraints.counts[ACTIVE]):
        marks[links[touching.active[k], ROOT], IS_HELD] = 0.0
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if bodies.properties[i, INVERSE_INERTIA] == 0.0:
            marks[links[i, ROOT], IS_HELD] = 1.0
    for k in range(touching.counts[TOUCHING]):
        i, j = touching.body_a[k], touching.body_b[k]
        if bodies.kind[i] != DYNAMIC:
            marks[links[j, ROOT], IS_HELD] = 1.0
        if bodies.kind[j] != DYNAMIC:
            marks[links[i, ROOT], IS_HELD] = 1.0
    hold_tied(islands, joints)
    free = 0
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        free += is_root(i, bodies, islands) and marks[i, IS_HELD] == 0.0
    constraints.counts[FREE_ISLANDS] = free


def begin_moments(first: int, last: int, touching: Touching, islands: Islands) -> None:
    """Begin to add up what contacts give some bodies."""
    for k in range(first, last):
        for n in range(VELOCITY_GIVEN, MOMENT_AHEAD + 1):
            islands.energy[touching.active_by_slab[k], n] = 0.0


def add_moments_before(
    substep: float, first: int, last: int, bodies: Bodies, touching: Touching, islands: Islands
) -> None:
    """Add what contacts have given some bodies in a substep, s, with which these move on."""
    for k in range(first, last):
        i = touching.active_by_slab[k]
        given, now = islands.energy[i], bodies.motion[i]
        given[MOMENT_AHEAD] = moment_ahead_moved(
            given[MOMENT_AHEAD], (now[VX], now[VY]), velocity_change(i, bodies), substep
        )


def add_moments(
    first: int, last: int, bodies: Bodies, touching: Touching, islands: Islands
) -> None:
    """Add all that contacts have given some bodies in a substep, after these have moved on."""
    for k in range(first, last):
        i = touching.active_by_slab[k]
        add_moment_of(i, bodies, islands.energy[i])


def add_moment_of(i: int, bodies: Bodies, given: Array) -> None:
    """Add what contacts have given a body in a substep."""
    now, state = bodies.motion[i], bodies.substep_state[i]
    by_x, by_y = velocity_change(i, bodies)
    given[VELOCITY_GIVEN] += by_x
    given[VELOCITY_GIVEN + 1] += by_y
    given[ANGULAR_VELOCITY_GIVEN] += state[CONTACT_CHANGE + 2] + (
        now[SPIN] - state[SUBSTEP_START + 2]
    )
    given[MOMENT_AHEAD] = moment_ahead_later(given[MOMENT_AHEAD], (now[DX], now[DY]), (by_x, by_y))


def velocity_change(i: int, bodies: Bodies) -> Vector:
    """Return what contacts have changed in the velocity of a body in this substep, m/s."""
    now, state = bodies.motion[i], bodies.substep_state[i]
    return (
        state[CONTACT_CHANGE] + (now[VX] - state[SUBSTEP_START]),
        state[CONTACT_CHANGE + 1] + (now[VY] - state[SUBSTEP_START + 1]),
    )


def keep_angular_momentum(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Take from free islands what contacts have given them, and note the energy that they have."""
    rows, links = islands.energy, islands.links
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if is_root(i, bodies, islands):
            for n in range(ISLAND_MASS, MOMENT_OF_INERTIA + 1):
                rows[i, n] = 0.0
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if is_pushed_and_free(i, bodies, islands):
            add_moment_of(i, bodies, rows[i])
            sum_given(i, links[i, ROOT], bodies, rows[i], rows[links[i, ROOT]])
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if is_root(i, bodies, islands) and rows[i, ISLAND_MASS] > 0.0:
            find_returned(rows[i])
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if is_pushed_and_free(i, bodies, islands):
            turn_with_island(i, links[i, ROOT], bodies, rows[links[i, ROOT]])


def is_pushed_and_free(i: int, bodies: Bodies, islands: Islands) -> bool:
    """Return whether contacts have pushed a body, of an island that nothing holds."""
    free = islands.energy[islands.links[i, ROOT], IS_HELD] == 0.0
    return bool((bodies.kind[i] == DYNAMIC) & (bodies.moved[i] == MOVED) & free)


def sum_given(i: int, root: int, bodies: Bodies, given: Array, row: Array) -> None:
    """Add mass, moments and what contacts have given a body to those of its island."""
    mass, inertia = mass_and_inertia(i, bodies.properties)
    start = (bodies.pose[i, X] - bodies.pose[root, X], bodies.pose[i, Y] - bodies.pose[root, Y])
    place = place_from(root, i, bodies)
    moment = mass_moment(mass, place)
    row[ISLAND_MASS] += mass
    row[MOMENT_X] += moment[0]
    row[MOMENT_Y] += moment[1]
    row[MOMENT_OF_INERTIA] += inertia_origin(mass, place, inertia)
    row[ANGULAR_MOMENTUM] += angular_momentum_given(
        mass,
        start,
        (given[VELOCITY_GIVEN], given[VELOCITY_GIVEN + 1]),
        given[MOMENT_AHEAD],
        inertia,
        given[ANGULAR_VELOCITY_GIVEN],
    )


def find_returned(row: Array) -> None:
    """Write the place of an island, as seen from its root, and how fast it turns back."""
    mass = row[ISLAND_MASS]
    place = position_island((row[MOMENT_X], row[MOMENT_Y]), mass)
    inertia = inertia_island(row[MOMENT_OF_INERTIA], mass, place)
    row[MOMENT_X], row[MOMENT_Y] = place
    row[RETURNED] = angular_velocity_returned(row[ANGULAR_MOMENTUM], inertia)


def turn_with_island(i: int, root: int, bodies: Bodies, row: Array) -> None:
    """Let a body turn back with its island, whose energy changes by that."""
    mass, inertia = mass_and_inertia(i, bodies.properties)
    now, reference = bodies.motion[i], (row[REFERENCE], row[REFERENCE + 1])
    seen = velocity_seen((now[VX], now[VY]), reference)
    before = kinetic_energy(mass, seen, inertia, now[SPIN])
    x, y = place_from(root, i, bodies)
    arm = (x - row[MOMENT_X], y - row[MOMENT_Y])
    now[VX], now[VY] = point_velocity((now[VX], now[VY]), row[RETURNED], arm)
    now[SPIN] += row[RETURNED]
    seen = velocity_seen((now[VX], now[VY]), reference)
    row[ENERGY_KEPT] += kinetic_energy(mass, seen, inertia, now[SPIN]) - before
