"""A bound on energy: contacts never make any, however many act at once (IM11).

Serves: a step, after its contacts have been solved and have bounced. Hides: how an island is seen
where it leans on something that moves.

Each contact gets what it asks for, one after the other; where many hold the same bodies, together
they may give more than there was. It is looked at where something bounces, or where there is more
energy in all than there may be. The kinetic energy of an island may be no more than when the step
began and what gravity and forces have given it since; lifting what overlaps costs nothing. It is
measured as seen from what the island leans on, since that may give any; an island that leans on
several things which move against each other has no bound.

Of a bounce an island keeps the largest share that the bound allows. What is still too much is taken
from all motion within the island alike: its bodies come nearer to moving as one, with the momentum
and the angular momentum that they have, or with what they lean on.
"""

from tamias2d.generated.definitions import (
    angular_momentum,
    kinetic_energy,
    momentum,
    point_velocity,
)
from tamias2d.generated.island_energy import (
    angular_velocity_calmed,
    angular_velocity_island,
    angular_velocity_kept,
    angular_velocity_seen,
    calm_share,
    inertia_island,
    inertia_origin,
    kept_share_falling,
    kept_share_rising,
    kinetic_energy_kept,
    kinetic_energy_most,
    mass_moment,
    position_island,
    push_kept,
    shift_seen,
    turn_seen,
    velocity_calmed,
    velocity_island,
    velocity_kept,
    velocity_seen,
    work,
)
from tamias2d.state import Array, Vector
from tamias2d.stepped.layout import (
    ACTIVE,
    ACTIVE_BODY,
    BLOCKS,
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
from tamias2d.stepped.rows import (
    BODY_A,
    BODY_B,
    FILLED,
    P_NOW,
    P_PUSH,
    P_TOTAL,
    POINTS,
    SHARED,
    SIZE,
)

GRACE = 1e-12  # of the energy: what rounding may add; one impact alone never takes more
ALIKE = 1e-9  # of their sizes: differences of velocities that are none

# sums of an island, J: at first, as work, before the bounce, after it, and of its difference alone
FIRST_ENERGY, WORK, BEFORE, AFTER, OF_CHANGE = SUMS, SUMS + 1, SUMS + 2, SUMS + 3, SUMS + 4
# what follows from them: which share of the bounce is kept, energy with it, and how much may stay
KEPT, NOW, MOST = SUMS + 5, SUMS + 6, SUMS + 7
# the motion as one, seen from the lowest body: mass, momentum, its angular one; moments of the mass
WHOLE, ALONG_X, ALONG_Y, ROUND = SUMS, SUMS + 1, SUMS + 2, SUMS + 3
MOMENT_X, MOMENT_Y, MOMENT = SUMS + 4, SUMS + 8, SUMS + 9
CALMED = SUMS + 5  # the factor of what differs from it

FREE, LEANING, TORN = 0.0, 1.0, 2.0  # what an island leans on: nothing, something, too much


def note_velocities(column: int, counts: Whole, motion: Array, hits: Whole, energy: Array) -> None:
    """Note the velocities of all bodies with contacts."""
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        for n in range(3):
            energy[i, column + n] = motion[i, n]


def makes_energy(
    settings: Array,
    counts: Whole,
    motion: Array,
    load: Array,
    body: Array,
    kind: Whole,
    hits: Whole,
    energy: Array,
) -> bool:
    """Return whether contacts have made energy in all, where nothing that is driven could have.

    This is cheap, and nearly always all that has to be asked where nothing bounces.
    """
    gravity = (settings[GRAVITY_X], settings[GRAVITY_Y])
    first = last = given = 0.0
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        if kind[i] != DYNAMIC:
            return False
        mass, inertia = mass_and_inertia(i, body)
        was = (energy[i, EARLIER], energy[i, EARLIER + 1])
        first += kinetic_energy(mass, was, inertia, energy[i, EARLIER + 2])
        now = (motion[i, VX], motion[i, VY])
        last += kinetic_energy(mass, now, inertia, motion[i, SPIN])
        force, shift = (load[i, 0], load[i, 1]), (motion[i, DX], motion[i, DY])
        given += work(mass, gravity, force, load[i, 2], shift, motion[i, DTURN])
    return bool(last > kinetic_energy_most(first, given) * (1.0 + GRACE))


def mass_and_inertia(i: int, body: Array) -> tuple[float, float]:
    """Return both of a body that moves; an inertia of zero stands for one that cannot turn."""
    free = body[i, INVERSE_INERTIA] > 0.0
    inertia = 1.0 / body[i, INVERSE_INERTIA] if free else 0.0
    return 1.0 / body[i, INVERSE_MASS], inertia


def bound_energy(
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    kind: Whole,
    hits: Whole,
    island: Whole,
    energy: Array,
    rows: Array,
    lanes: Whole,
    bouncing: int,
) -> None:
    """Take back of the bounce and of the motion of each island what makes energy."""
    look_from_supports(counts, pose, motion, body, kind, hits, island, energy)
    sum_energies(settings, counts, pose, motion, load, body, kind, hits, island, energy, bouncing)
    if share_bounces(counts, kind, hits, island, energy, bouncing):
        take_back(counts, motion, kind, hits, island, energy)
        take_back_pushes(counts, kind, island, energy, rows, lanes)
    if choose_calm(counts, kind, hits, island, energy):
        sum_motions(counts, pose, motion, body, kind, hits, island, energy)
        calm(counts, pose, motion, kind, hits, island, energy)


def look_from_supports(
    counts: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    kind: Whole,
    hits: Whole,
    island: Whole,
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
            x, y = momentum(mass, (energy[i, EARLIER], energy[i, EARLIER + 1]))
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
            sum_energy(i, support, spin, motion, body, energy, row, bouncing)


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
    energy: Array,
    row: Array,
    bouncing: int,
) -> None:
    """Add the kinetic energies of a body to those of its island, as seen from its support."""
    mass, inertia = mass_and_inertia(i, body)
    here = energy[i]
    was = velocity_seen((here[EARLIER], here[EARLIER + 1]), support)
    turned = angular_velocity_seen(here[EARLIER + 2], spin)
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


def share_bounces(
    counts: Whole, kind: Whole, hits: Whole, island: Whole, energy: Array, bouncing: int
) -> bool:
    """Write for each island which share of its bounce it keeps; return whether one loses any."""
    some = False
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        if kind[i] != DYNAMIC or island[i, ISLAND] != i:
            continue
        row = energy[i]
        before, after, change = row[BEFORE], row[AFTER], row[OF_CHANGE]
        row[MOST] = kinetic_energy_most(row[FIRST_ENERGY], row[WORK])
        most = max(row[MOST], before)
        row[KEPT], row[NOW] = 1.0, after
        if bouncing > 0 and row[LEANS] != TORN and after > most * (1.0 + GRACE):
            rise, room = after - before, most - before
            steep = rise > change
            share = (
                kept_share_rising(room, rise, change)
                if steep
                else kept_share_falling(room, rise, change)
            )
            row[KEPT], row[NOW] = share, kinetic_energy_kept(before, after, change, share)
            some = True
    return some


def take_back(
    counts: Whole, motion: Array, kind: Whole, hits: Whole, island: Whole, energy: Array
) -> None:
    """Leave each body the share of the bounce that its island keeps."""
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        if kind[i] == DYNAMIC:
            share = energy[island[i, ISLAND], KEPT]
            if share < 1.0:
                before, now = energy[i, UNBOUNCED:], motion[i]
                now[VX], now[VY] = velocity_kept((before[0], before[1]), (now[VX], now[VY]), share)
                now[SPIN] = angular_velocity_kept(before[2], now[SPIN], share)


def take_back_pushes(
    counts: Whole, kind: Whole, island: Whole, energy: Array, rows: Array, lanes: Whole
) -> None:
    """Leave each contact the share of its bounce, which is in the place of its gap by now."""
    for b in range(counts[BLOCKS]):
        row = rows[b]
        for m in range(lanes[b, FILLED]):
            i = lanes[b, BODY_A + m]
            i = i if kind[i] == DYNAMIC else lanes[b, BODY_B + m]
            share = energy[island[i, ISLAND], KEPT]
            if share < 1.0:
                for n in range(lanes[b, POINTS]):
                    at = SHARED + n * SIZE + m
                    row[at + P_PUSH] = push_kept(row[at + P_PUSH], row[at + P_NOW], share)
                    row[at + P_TOTAL] = push_kept(row[at + P_TOTAL], row[at + P_NOW], share)


def choose_calm(counts: Whole, kind: Whole, hits: Whole, island: Whole, energy: Array) -> bool:
    """Return whether some island still has too much energy."""
    some = False
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        if kind[i] == DYNAMIC and island[i, ISLAND] == i:
            row = energy[i]
            much = row[LEANS] != TORN and row[NOW] > row[MOST] * (1.0 + GRACE)
            row[CALMED] = 0.0 if much else 1.0
            some = some or much
    return some


def sum_motions(
    counts: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    kind: Whole,
    hits: Whole,
    island: Whole,
    energy: Array,
) -> None:
    """Find how islands with too much energy would move as one, and how far towards it they go.

    What leans on something moves as that does.
    """
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        if kind[i] == DYNAMIC and island[i, ISLAND] == i:
            for n in (WHOLE, ALONG_X, ALONG_Y, ROUND, MOMENT_X, MOMENT_Y, MOMENT):
                energy[i, n] = 0.0
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        root = island[i, ISLAND]
        if kind[i] != DYNAMIC or energy[root, CALMED] == 1.0 or energy[root, LEANS] != FREE:
            continue
        row = energy[root]
        mass, inertia = mass_and_inertia(i, body)
        place = (pose[i, X] - pose[root, X], pose[i, Y] - pose[root, Y])
        now = velocity_seen((motion[i, VX], motion[i, VY]), (row[SEEN], row[SEEN + 1]))
        along, moment = momentum(mass, now), mass_moment(mass, place)
        row[WHOLE] += mass
        row[ALONG_X] += along[0]
        row[ALONG_Y] += along[1]
        row[ROUND] += angular_momentum(mass, place, now, inertia, motion[i, SPIN])
        row[MOMENT_X] += moment[0]
        row[MOMENT_Y] += moment[1]
        row[MOMENT] += inertia_origin(mass, place, inertia)
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        if kind[i] == DYNAMIC and island[i, ISLAND] == i and energy[i, CALMED] != 1.0:
            as_one(energy[i])


def as_one(row: Array) -> None:
    """Write the motion of an island as one, and the factor of what differs from it."""
    least = 0.0
    if row[LEANS] == FREE:
        mass = row[WHOLE]
        place = position_island((row[MOMENT_X], row[MOMENT_Y]), mass)
        by = velocity_island((row[ALONG_X], row[ALONG_Y]), mass)
        inertia = inertia_island(row[MOMENT], mass, place)
        spin = 0.0
        if inertia > 0.0:
            spin = angular_velocity_island(row[ROUND], mass, place, by, inertia)
        least = kinetic_energy(mass, by, inertia, spin)
        by_x, by_y = point_velocity(by, spin, (-place[0], -place[1]))
        row[SEEN] += by_x
        row[SEEN + 1] += by_y
        row[SEEN + 2] = spin
    row[CALMED] = 0.0
    if row[MOST] > least and row[NOW] > least:
        row[CALMED] = calm_share(row[NOW], row[MOST], least)


def calm(
    counts: Whole,
    pose: Array,
    motion: Array,
    kind: Whole,
    hits: Whole,
    island: Whole,
    energy: Array,
) -> None:
    """Let bodies of islands with too much energy come nearer to moving as one."""
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        if kind[i] != DYNAMIC:
            continue
        part = energy[island[i, ISLAND], CALMED]
        if part < 1.0:
            whole, spin = support_at(i, pose, island, energy)
            now = motion[i]
            now[VX], now[VY] = velocity_calmed((now[VX], now[VY]), whole, part)
            now[SPIN] = angular_velocity_calmed(now[SPIN], spin, part)
