"""The energy of islands, and what forces give them in a step (DD36, DD37).

Serves: the bound on energy. Hides: how an island is seen where it leans on something that moves.

The kinetic energy of an island may be no more than when the step began and what gravity and forces
have given it since; lifting what overlaps costs nothing. It is measured as seen from what the
island leans on, since that may give any; an island that leans on several things which move against
each other has no bound.
"""

from tamias2d.engine.tables import (
    ACTIVE,
    DANGLE,
    DX,
    DY,
    DYNAMIC,
    ENERGY_AFTER,
    ENERGY_BEFORE,
    ENERGY_FIRST,
    ENERGY_GIVEN,
    ENERGY_NOW,
    ENERGY_OF_CHANGE,
    ENERGY_START,
    FORCE_GAIN,
    GRAVITY_X,
    GRAVITY_Y,
    INVERSE_INERTIA,
    INVERSE_MASS,
    ISLAND_MASS,
    ROOT,
    SEEN,
    SPIN,
    STEP_START,
    SUPPORT,
    TIME_STEP,
    TOUCHING,
    UNBOUNCED,
    VX,
    VY,
    WORK,
    Bodies,
    Constraints,
    Control,
    Islands,
    Touching,
    X,
    Y,
)
from tamias2d.generated.definitions import kinetic_energy, momentum, point_velocity
from tamias2d.generated.island_energy import (
    angular_velocity_seen,
    kinetic_energy_most,
    shift_seen,
    turn_seen,
    velocity_island,
    velocity_seen,
    work,
)
from tamias2d.state import Array, Vector

GRACE = 1e-12  # of the energy: what rounding may add; one impact alone never takes more
ANY = 1e300  # J: what something driven may give
ALIKE = 1e-9  # of their sizes: differences of velocities that are none

# what supports an island: nothing, one motion, or several that differ
FREE, SUPPORTED_BY_ONE, SUPPORTED_BY_MORE = 0.0, 1.0, 2.0


def note_before_restitution(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Note the velocities of all bodies with contacts before they bounce."""
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        for n in range(3):
            islands.energy[i, UNBOUNCED + n] = bodies.motion[i, n]


def sum_step_energy(
    first: int,
    last: int,
    control: Control,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
) -> None:
    """Add to the sums of all energy what bodies had and have, and what forces gave them, J.

    What is driven may give any. Nothing is noted of these bodies any more.
    """
    gravity = (control.settings[GRAVITY_X], control.settings[GRAVITY_Y])
    for k in range(first, last):
        i = touching.active_by_slab[k]
        note = bodies.substep_state[i]
        for n in range(3):
            bodies.flight[i, FORCE_GAIN + n] = 0.0
        if bodies.kind[i] != DYNAMIC:
            constraints.scratch[ENERGY_GIVEN] = ANY
            continue
        mass, inertia = mass_and_inertia(i, bodies.properties)
        was = (note[STEP_START], note[STEP_START + 1])
        constraints.scratch[ENERGY_FIRST] += kinetic_energy(
            mass, was, inertia, note[STEP_START + 2]
        )
        now = (bodies.motion[i, VX], bodies.motion[i, VY])
        constraints.scratch[ENERGY_NOW] += kinetic_energy(
            mass, now, inertia, bodies.motion[i, SPIN]
        )
        force, shift = (
            (bodies.load[i, 0], bodies.load[i, 1]),
            (bodies.motion[i, DX], bodies.motion[i, DY]),
        )
        constraints.scratch[ENERGY_GIVEN] += work(
            mass, gravity, force, bodies.load[i, 2], shift, bodies.motion[i, DANGLE]
        )


def makes_energy(scratch: Array) -> bool:
    """Return whether contacts have made energy in all, where nothing that is driven could have.

    This is cheap, and nearly always all that has to be asked where nothing bounces.
    """
    most = kinetic_energy_most(scratch[ENERGY_FIRST], scratch[ENERGY_GIVEN])
    return bool(scratch[ENERGY_NOW] > most * (1.0 + GRACE))


def mass_and_inertia(i: int, properties: Array) -> tuple[float, float]:
    """Return both of a body that moves; an inertia of zero stands for one that cannot turn."""
    free = properties[i, INVERSE_INERTIA] > 0.0
    inertia = 1.0 / properties[i, INVERSE_INERTIA] if free else 0.0
    return 1.0 / properties[i, INVERSE_MASS], inertia


def find_supports(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Write for each island the motion of what it leans on, at its root.

    A free island is seen from its centre of mass as that moved at first: there, gravity does no
    work that contacts could take for theirs.
    """
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == DYNAMIC and islands.links[i, ROOT] == i:
            islands.energy[i, SUPPORT] = FREE
            islands.energy[i, ISLAND_MASS] = 0.0
            for n in range(3):
                islands.energy[i, SEEN + n] = 0.0
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == DYNAMIC:
            row, mass = (
                islands.energy[islands.links[i, ROOT]],
                1.0 / bodies.properties[i, INVERSE_MASS],
            )
            x, y = momentum(
                mass, (bodies.substep_state[i, STEP_START], bodies.substep_state[i, STEP_START + 1])
            )
            row[SEEN] += x
            row[SEEN + 1] += y
            row[ISLAND_MASS] += mass
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == DYNAMIC and islands.links[i, ROOT] == i:
            whole = (islands.energy[i, SEEN], islands.energy[i, SEEN + 1])
            islands.energy[i, SEEN], islands.energy[i, SEEN + 1] = velocity_island(
                whole, islands.energy[i, ISLAND_MASS]
            )
    for k in range(touching.counts[TOUCHING]):
        i, j = touching.body_a[k], touching.body_b[k]
        if bodies.kind[i] != DYNAMIC:
            i, j = j, i
        if bodies.kind[j] != DYNAMIC:
            support_island(j, islands.links[i, ROOT], bodies, islands)


def support_island(j: int, root: int, bodies: Bodies, islands: Islands) -> None:
    """Let an island be seen from a body that nothing moves."""
    row = islands.energy[root]
    x, y = bodies.pose[root, X] - bodies.pose[j, X], bodies.pose[root, Y] - bodies.pose[j, Y]
    by_x, by_y = point_velocity(
        (bodies.motion[j, VX], bodies.motion[j, VY]), bodies.motion[j, SPIN], (x, y)
    )
    spin = bodies.motion[j, SPIN]
    if row[SUPPORT] == FREE:
        row[SUPPORT] = SUPPORTED_BY_ONE
        row[SEEN], row[SEEN + 1], row[SEEN + 2] = by_x, by_y, spin
    apart = abs(row[SEEN] - by_x) + abs(row[SEEN + 1] - by_y)
    speed = abs(by_x) + abs(by_y) + abs(bodies.motion[j, VX]) + abs(bodies.motion[j, VY])
    if apart > ALIKE * speed or abs(row[SEEN + 2] - spin) > ALIKE * abs(spin):
        row[SUPPORT] = SUPPORTED_BY_MORE


def support_at(i: int, bodies: Bodies, islands: Islands) -> tuple[Vector, float]:
    """Return the velocity of what a body's island leans on, at this body, and how it turns."""
    root = islands.links[i, ROOT]
    row = islands.energy[root]
    x, y = bodies.pose[i, X] - bodies.pose[root, X], bodies.pose[i, Y] - bodies.pose[root, Y]
    return point_velocity((row[SEEN], row[SEEN + 1]), row[SEEN + 2], (x, y)), row[SEEN + 2]


def sum_island_energies(
    control: Control,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
    bouncing: int,
) -> None:
    """Add up the kinetic energies of all islands, and the work of forces, J."""
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == DYNAMIC and islands.links[i, ROOT] == i:
            for n in range(5):
                islands.energy[i, ENERGY_START + n] = 0.0
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == DYNAMIC:
            support, spin = support_at(i, bodies, islands)
            row = islands.energy[islands.links[i, ROOT]]
            row[WORK] += work_seen(i, support, spin, control, bodies)
            sum_body_energy(i, support, spin, bodies, islands, row, bouncing)


def work_seen(i: int, support: Vector, spin: float, control: Control, bodies: Bodies) -> float:
    """Return the work of forces on a body as seen from its support, J."""
    gravity, time_step = (
        (control.settings[GRAVITY_X], control.settings[GRAVITY_Y]),
        control.settings[TIME_STEP],
    )
    shift = shift_seen((bodies.motion[i, DX], bodies.motion[i, DY]), support, time_step)
    turn = turn_seen(bodies.motion[i, DANGLE], spin, time_step)
    mass = 1.0 / bodies.properties[i, INVERSE_MASS]
    return work(
        mass, gravity, (bodies.load[i, 0], bodies.load[i, 1]), bodies.load[i, 2], shift, turn
    )


def sum_body_energy(
    i: int,
    support: Vector,
    spin: float,
    bodies: Bodies,
    islands: Islands,
    row: Array,
    bouncing: int,
) -> None:
    """Add the kinetic energies of a body to those of its island, as seen from its support."""
    mass, inertia = mass_and_inertia(i, bodies.properties)
    note, here = bodies.substep_state[i], islands.energy[i]
    was = velocity_seen((note[STEP_START], note[STEP_START + 1]), support)
    turned = angular_velocity_seen(note[STEP_START + 2], spin)
    row[ENERGY_START] += kinetic_energy(mass, was, inertia, turned)
    now = velocity_seen((bodies.motion[i, VX], bodies.motion[i, VY]), support)
    turns = angular_velocity_seen(bodies.motion[i, SPIN], spin)
    row[ENERGY_AFTER] += kinetic_energy(mass, now, inertia, turns)
    if bouncing > 0:
        was = velocity_seen((here[UNBOUNCED], here[UNBOUNCED + 1]), support)
        turned = angular_velocity_seen(here[UNBOUNCED + 2], spin)
        row[ENERGY_BEFORE] += kinetic_energy(mass, was, inertia, turned)
        turn = bodies.motion[i, SPIN] - here[UNBOUNCED + 2]
        row[ENERGY_OF_CHANGE] += kinetic_energy(mass, velocity_seen(now, was), inertia, turn)
