"""The energy of islands, and what forces give them in a step (DD36, DD37).

Serves: the bound on energy. Hides: how an island is seen where it leans on something that moves.

The kinetic energy of an island may be no more than when the step began and what gravity and forces
have given it since; lifting what overlaps costs nothing. It is measured as seen from what the
island leans on, since that may give any; an island that leans on several things which move against
each other has no bound.
"""

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
from tamias2d.stepped.layout import (
    ACTIVE,
    ACTIVE_BODY,
    ACTIVE_ROW,
    DTURN,
    DX,
    DY,
    DYNAMIC,
    EARLIER,
    GRAVITY_X,
    GRAVITY_Y,
    HIT_A,
    HIT_B,
    HITS,
    INVERSE_INERTIA,
    INVERSE_MASS,
    ISLAND,
    LEANS,
    NOTED,
    SEEN,
    SPIN,
    SUMS,
    TIME_STEP,
    UNBOUNCED,
    VX,
    VY,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.solver import ALL_FIRST, ALL_GIVEN, ALL_NOW

GRACE = 1e-12  # of the energy: what rounding may add; one impact alone never takes more
ANY = 1e300  # J: what something driven may give
ALIKE = 1e-9  # of their sizes: differences of velocities that are none

# sums of an island, J: at first, as work, before the bounce, after it, and of its difference alone
FIRST_ENERGY, WORK, BEFORE, AFTER, OF_CHANGE = SUMS, SUMS + 1, SUMS + 2, SUMS + 3, SUMS + 4

FREE, LEANING, TORN = 0.0, 1.0, 2.0  # what an island leans on: nothing, something, too much


def note_unbounced(counts: Whole, motion: Array, hits: Whole, energy: Array) -> None:
    """Note the velocities of all bodies with contacts before they bounce."""
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        for n in range(3):
            energy[i, UNBOUNCED + n] = motion[i, n]


def sum_up(
    first: int,
    last: int,
    settings: Array,
    motion: Array,
    load: Array,
    body: Array,
    kind: Whole,
    hits: Whole,
    carried: Array,
    bench: Array,
) -> None:
    """Add to the sums of all energy what bodies had and have, and what forces gave them, J.

    What is driven may give any. Nothing is noted of these bodies any more.
    """
    gravity = (settings[GRAVITY_X], settings[GRAVITY_Y])
    for k in range(first, last):
        i = hits[ACTIVE_ROW, k]
        note = carried[i]
        for n in range(3):
            note[NOTED + n] = 0.0
        if kind[i] != DYNAMIC:
            bench[ALL_GIVEN] = ANY
            continue
        mass, inertia = mass_and_inertia(i, body)
        was = (note[EARLIER], note[EARLIER + 1])
        bench[ALL_FIRST] += kinetic_energy(mass, was, inertia, note[EARLIER + 2])
        now = (motion[i, VX], motion[i, VY])
        bench[ALL_NOW] += kinetic_energy(mass, now, inertia, motion[i, SPIN])
        force, shift = (load[i, 0], load[i, 1]), (motion[i, DX], motion[i, DY])
        bench[ALL_GIVEN] += work(mass, gravity, force, load[i, 2], shift, motion[i, DTURN])


def makes_energy(bench: Array) -> bool:
    """Return whether contacts have made energy in all, where nothing that is driven could have.

    This is cheap, and nearly always all that has to be asked where nothing bounces.
    """
    most = kinetic_energy_most(bench[ALL_FIRST], bench[ALL_GIVEN])
    return bool(bench[ALL_NOW] > most * (1.0 + GRACE))


def mass_and_inertia(i: int, body: Array) -> tuple[float, float]:
    """Return both of a body that moves; an inertia of zero stands for one that cannot turn."""
    free = body[i, INVERSE_INERTIA] > 0.0
    inertia = 1.0 / body[i, INVERSE_INERTIA] if free else 0.0
    return 1.0 / body[i, INVERSE_MASS], inertia


def look_from_supports(
    counts: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    kind: Whole,
    hits: Whole,
    island: Whole,
    carried: Array,
    energy: Array,
) -> None:
    """Write for each island the motion of what it leans on, at its root.

    A free island is seen from its centre of mass as that moved at first: there, gravity does no
    work that contacts could take for theirs.
    """
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        if kind[i] == DYNAMIC and island[i, ISLAND] == i:
            energy[i, LEANS] = FREE
            energy[i, SUMS] = 0.0
            for n in range(3):
                energy[i, SEEN + n] = 0.0
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        if kind[i] == DYNAMIC:
            row, mass = energy[island[i, ISLAND]], 1.0 / body[i, INVERSE_MASS]
            x, y = momentum(mass, (carried[i, EARLIER], carried[i, EARLIER + 1]))
            row[SEEN] += x
            row[SEEN + 1] += y
            row[SUMS] += mass
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        if kind[i] == DYNAMIC and island[i, ISLAND] == i:
            whole = (energy[i, SEEN], energy[i, SEEN + 1])
            energy[i, SEEN], energy[i, SEEN + 1] = velocity_island(whole, energy[i, SUMS])
    for k in range(counts[HITS]):
        i, j = hits[HIT_A, k], hits[HIT_B, k]
        if kind[i] != DYNAMIC:
            i, j = j, i
        if kind[j] != DYNAMIC:
            lean_on(j, island[i, ISLAND], pose, motion, energy)


def lean_on(j: int, root: int, pose: Array, motion: Array, energy: Array) -> None:
    """Let an island be seen from a body that nothing moves."""
    row = energy[root]
    x, y = pose[root, X] - pose[j, X], pose[root, Y] - pose[j, Y]
    by_x, by_y = point_velocity((motion[j, VX], motion[j, VY]), motion[j, SPIN], (x, y))
    spin = motion[j, SPIN]
    if row[LEANS] == FREE:
        row[LEANS] = LEANING
        row[SEEN], row[SEEN + 1], row[SEEN + 2] = by_x, by_y, spin
    apart = abs(row[SEEN] - by_x) + abs(row[SEEN + 1] - by_y)
    speed = abs(by_x) + abs(by_y) + abs(motion[j, VX]) + abs(motion[j, VY])
    if apart > ALIKE * speed or abs(row[SEEN + 2] - spin) > ALIKE * abs(spin):
        row[LEANS] = TORN


def support_at(i: int, pose: Array, island: Whole, energy: Array) -> tuple[Vector, float]:
    """Return the velocity of what a body's island leans on, at this body, and how it turns."""
    root = island[i, ISLAND]
    row = energy[root]
    x, y = pose[i, X] - pose[root, X], pose[i, Y] - pose[root, Y]
    return point_velocity((row[SEEN], row[SEEN + 1]), row[SEEN + 2], (x, y)), row[SEEN + 2]


def sum_energies(
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    kind: Whole,
    hits: Whole,
    island: Whole,
    carried: Array,
    energy: Array,
    bouncing: int,
) -> None:
    """Add up the kinetic energies of all islands, and the work of forces, J."""
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        if kind[i] == DYNAMIC and island[i, ISLAND] == i:
            for n in range(5):
                energy[i, SUMS + n] = 0.0
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        if kind[i] == DYNAMIC:
            support, spin = support_at(i, pose, island, energy)
            row = energy[island[i, ISLAND]]
            row[WORK] += work_seen(i, support, spin, settings, motion, load, body)
            sum_energy(i, support, spin, motion, body, carried, energy, row, bouncing)


def work_seen(
    i: int, support: Vector, spin: float, settings: Array, motion: Array, load: Array, body: Array
) -> float:
    """Return the work of forces on a body as seen from its support, J."""
    gravity, time_step = (settings[GRAVITY_X], settings[GRAVITY_Y]), settings[TIME_STEP]
    shift = shift_seen((motion[i, DX], motion[i, DY]), support, time_step)
    turn = turn_seen(motion[i, DTURN], spin, time_step)
    mass = 1.0 / body[i, INVERSE_MASS]
    return work(mass, gravity, (load[i, 0], load[i, 1]), load[i, 2], shift, turn)


def sum_energy(
    i: int,
    support: Vector,
    spin: float,
    motion: Array,
    body: Array,
    carried: Array,
    energy: Array,
    row: Array,
    bouncing: int,
) -> None:
    """Add the kinetic energies of a body to those of its island, as seen from its support."""
    mass, inertia = mass_and_inertia(i, body)
    note, here = carried[i], energy[i]
    was = velocity_seen((note[EARLIER], note[EARLIER + 1]), support)
    turned = angular_velocity_seen(note[EARLIER + 2], spin)
    row[FIRST_ENERGY] += kinetic_energy(mass, was, inertia, turned)
    now = velocity_seen((motion[i, VX], motion[i, VY]), support)
    turns = angular_velocity_seen(motion[i, SPIN], spin)
    row[AFTER] += kinetic_energy(mass, now, inertia, turns)
    if bouncing > 0:
        was = velocity_seen((here[UNBOUNCED], here[UNBOUNCED + 1]), support)
        turned = angular_velocity_seen(here[UNBOUNCED + 2], spin)
        row[BEFORE] += kinetic_energy(mass, was, inertia, turned)
        turn = motion[i, SPIN] - here[UNBOUNCED + 2]
        row[OF_CHANGE] += kinetic_energy(mass, velocity_seen(now, was), inertia, turn)
