"""A bound on energy: contacts never make any, however many act at once.

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

from math import sqrt

from tamias2d.generated.definitions import kinetic_energy, point_velocity
from tamias2d.state import Array
from tamias2d.stepped.layout import (
    ACTIVE,
    BLOCKS,
    DTURN,
    DX,
    DY,
    DYNAMIC,
    EARLIER,
    GRAVITY_X,
    GRAVITY_Y,
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

STILLNESS = 1e-6  # of the energy of a fall through one step: motion in which a pile just settles
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
        i = hits[1, k]
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
    first = last = work = whole = 0.0
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        if kind[i] != DYNAMIC:
            return False
        mass = 1.0 / body[i, INVERSE_MASS]
        inertia = 1.0 / body[i, INVERSE_INERTIA] if body[i, INVERSE_INERTIA] > 0.0 else 0.0
        was = (energy[i, EARLIER], energy[i, EARLIER + 1])
        first += kinetic_energy(mass, was, inertia, energy[i, EARLIER + 2])
        now = (motion[i, VX], motion[i, VY])
        last += kinetic_energy(mass, now, inertia, motion[i, SPIN])
        work += (
            (mass * settings[GRAVITY_X] + load[i, 0]) * motion[i, DX]
            + (mass * settings[GRAVITY_Y] + load[i, 1]) * motion[i, DY]
            + load[i, 2] * motion[i, DTURN]
        )
        whole += mass
    fall = (settings[TIME_STEP] * settings[GRAVITY_X], settings[TIME_STEP] * settings[GRAVITY_Y])
    still = STILLNESS * kinetic_energy(whole, fall, 0.0, 0.0)
    return bool(last > (first + max(work, 0.0)) * (1.0 + GRACE) + still)


def bound_energy(
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    kind: Whole,
    pair: Whole,
    shape_body: Whole,
    hits: Whole,
    island: Whole,
    energy: Array,
    rows: Array,
    lanes: Whole,
    bouncing: int,
) -> None:
    """Take back of the bounce and of the motion of each island what makes energy."""
    look_from_supports(counts, pose, motion, body, kind, pair, shape_body, hits, island, energy)
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
    pair: Whole,
    shape_body: Whole,
    hits: Whole,
    island: Whole,
    energy: Array,
) -> None:
    """Write for each island the motion of what it leans on, at its root.

    A free island is seen from its centre of mass as that moved at first: there, gravity does no
    work that contacts could take for theirs.
    """
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        if kind[i] == DYNAMIC and island[i, ISLAND] == i:
            energy[i, LEANS] = FREE
            energy[i, SUMS] = 0.0
            for n in range(3):
                energy[i, SEEN + n] = 0.0
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        if kind[i] == DYNAMIC:
            row, mass = energy[island[i, ISLAND]], 1.0 / body[i, INVERSE_MASS]
            row[SEEN] += mass * energy[i, EARLIER]
            row[SEEN + 1] += mass * energy[i, EARLIER + 1]
            row[SUMS] += mass
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        if kind[i] == DYNAMIC and island[i, ISLAND] == i:
            energy[i, SEEN] /= energy[i, SUMS]
            energy[i, SEEN + 1] /= energy[i, SUMS]
    for k in range(counts[HITS]):
        p = hits[0, k]
        i, j = shape_body[pair[p, 0]], shape_body[pair[p, 1]]
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


def seen_from(i: int, pose: Array, island: Whole, energy: Array) -> tuple[float, float, float]:
    """Return the motion of what a body's island leans on, at this body."""
    root = island[i, ISLAND]
    row = energy[root]
    x, y = pose[i, X] - pose[root, X], pose[i, Y] - pose[root, Y]
    by_x, by_y = point_velocity((row[SEEN], row[SEEN + 1]), row[SEEN + 2], (x, y))
    return by_x, by_y, row[SEEN + 2]


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
        i = hits[1, k]
        if kind[i] == DYNAMIC and island[i, ISLAND] == i:
            for n in range(5):
                energy[i, SUMS + n] = 0.0
    time_step = settings[TIME_STEP]
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        if kind[i] != DYNAMIC:
            continue
        mass = 1.0 / body[i, INVERSE_MASS]
        free = body[i, INVERSE_INERTIA] > 0.0
        inertia = 1.0 / body[i, INVERSE_INERTIA] if free else 0.0
        x, y, spin = seen_from(i, pose, island, energy)
        here, row = energy[i], energy[island[i, ISLAND]]
        was = (here[EARLIER] - x, here[EARLIER + 1] - y)
        row[FIRST_ENERGY] += kinetic_energy(mass, was, inertia, here[EARLIER + 2] - spin)
        now = (motion[i, VX] - x, motion[i, VY] - y)
        row[AFTER] += kinetic_energy(mass, now, inertia, motion[i, SPIN] - spin)
        if bouncing > 0:
            was = (here[UNBOUNCED] - x, here[UNBOUNCED + 1] - y)
            row[BEFORE] += kinetic_energy(mass, was, inertia, here[UNBOUNCED + 2] - spin)
            change, turn = (now[0] - was[0], now[1] - was[1]), motion[i, SPIN] - here[UNBOUNCED + 2]
            row[OF_CHANGE] += kinetic_energy(mass, change, inertia, turn)
        row[WORK] += (
            (mass * settings[GRAVITY_X] + load[i, 0]) * (motion[i, DX] - x * time_step)
            + (mass * settings[GRAVITY_Y] + load[i, 1]) * (motion[i, DY] - y * time_step)
            + load[i, 2] * (motion[i, DTURN] - spin * time_step)
        )


def share_bounces(
    counts: Whole, kind: Whole, hits: Whole, island: Whole, energy: Array, bouncing: int
) -> bool:
    """Write for each island which share of its bounce it keeps; return whether one loses any."""
    some = False
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        if kind[i] != DYNAMIC or island[i, ISLAND] != i:
            continue
        row = energy[i]
        before, after, change = row[BEFORE], row[AFTER], row[OF_CHANGE]
        row[MOST] = row[FIRST_ENERGY] + max(row[WORK], 0.0)
        most = max(row[MOST], before)
        row[KEPT], row[NOW] = 1.0, after
        if bouncing > 0 and row[LEANS] != TORN and after > most * (1.0 + GRACE):
            share = kept_share(most - before, after - before, change)
            rest = 1.0 - share
            row[KEPT], row[NOW] = share, rest * before + share * after - share * rest * change
            some = True
    return some


def kept_share(room: float, rise: float, change: float) -> float:
    """Return the largest share of a change of velocities with which energy rises by `room`, J.

    All of it raises it by more; `change` is the energy of the change of velocities alone. With a
    share s it rises by s (rise - change) + s^2 change.
    """
    slope = rise - change
    root = sqrt(slope * slope + 4.0 * change * room)
    share = 2.0 * room / (slope + root) if slope > 0.0 else (root - slope) / (2.0 * change)
    return min(max(share, 0.0), 1.0)


def take_back(
    counts: Whole, motion: Array, kind: Whole, hits: Whole, island: Whole, energy: Array
) -> None:
    """Leave each body the share of the bounce that its island keeps."""
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        if kind[i] == DYNAMIC:
            share = energy[island[i, ISLAND], KEPT]
            if share < 1.0:
                for n in range(3):
                    before = energy[i, UNBOUNCED + n]
                    motion[i, n] = before + share * (motion[i, n] - before)


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
                    lost = (1.0 - share) * row[at + P_NOW]
                    row[at + P_PUSH] -= lost
                    row[at + P_TOTAL] -= lost


def choose_calm(counts: Whole, kind: Whole, hits: Whole, island: Whole, energy: Array) -> bool:
    """Return whether some island still has too much energy."""
    some = False
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
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
        i = hits[1, k]
        if kind[i] == DYNAMIC and island[i, ISLAND] == i:
            for n in (WHOLE, ALONG_X, ALONG_Y, ROUND, MOMENT_X, MOMENT_Y, MOMENT):
                energy[i, n] = 0.0
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        root = island[i, ISLAND]
        if kind[i] != DYNAMIC or energy[root, CALMED] == 1.0 or energy[root, LEANS] != FREE:
            continue
        row, mass = energy[root], 1.0 / body[i, INVERSE_MASS]
        inertia = 1.0 / body[i, INVERSE_INERTIA] if body[i, INVERSE_INERTIA] > 0.0 else 0.0
        x, y = pose[i, X] - pose[root, X], pose[i, Y] - pose[root, Y]
        by_x, by_y = motion[i, VX] - row[SEEN], motion[i, VY] - row[SEEN + 1]
        row[WHOLE] += mass
        row[ALONG_X] += mass * by_x
        row[ALONG_Y] += mass * by_y
        row[ROUND] += mass * (x * by_y - y * by_x) + inertia * motion[i, SPIN]
        row[MOMENT_X] += mass * x
        row[MOMENT_Y] += mass * y
        row[MOMENT] += mass * (x * x + y * y) + inertia
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        if kind[i] == DYNAMIC and island[i, ISLAND] == i and energy[i, CALMED] != 1.0:
            as_one(energy[i])


def as_one(row: Array) -> None:
    """Write the motion of an island as one, and the factor of what differs from it."""
    least = 0.0
    if row[LEANS] == FREE:
        mass = row[WHOLE]
        x, y = row[MOMENT_X] / mass, row[MOMENT_Y] / mass
        by_x, by_y = row[ALONG_X] / mass, row[ALONG_Y] / mass
        moment = row[MOMENT] - mass * (x * x + y * y)
        spin = (row[ROUND] - mass * (x * by_y - y * by_x)) / moment if moment > 0.0 else 0.0
        least = kinetic_energy(mass, (by_x, by_y), moment, spin)
        by_x, by_y = point_velocity((by_x, by_y), spin, (-x, -y))
        row[SEEN] += by_x
        row[SEEN + 1] += by_y
        row[SEEN + 2] = spin
    row[CALMED] = 0.0
    if row[MOST] > least and row[NOW] > least:
        row[CALMED] = min(sqrt((row[MOST] - least) / (row[NOW] - least)), 1.0)


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
        i = hits[1, k]
        if kind[i] != DYNAMIC:
            continue
        part = energy[island[i, ISLAND], CALMED]
        if part < 1.0:
            x, y, spin = seen_from(i, pose, island, energy)
            motion[i, VX] = x + part * (motion[i, VX] - x)
            motion[i, VY] = y + part * (motion[i, VY] - y)
            motion[i, SPIN] = spin + part * (motion[i, SPIN] - spin)
