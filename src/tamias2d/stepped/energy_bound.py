"""A bound on energy: contacts never make any, however many act at once (IM11).

Serves: a step, after its contacts have been solved and have bounced. Hides: what an island loses
that has too much.

Each contact gets what it asks for, one after the other; where many hold the same bodies, together
they may give more than there was. It is looked at where something bounces, or where there is more
energy in all than there may be.

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
    velocity_calmed,
    velocity_island,
    velocity_kept,
    velocity_seen,
)
from tamias2d.state import Array
from tamias2d.stepped.energy import (
    AFTER,
    BEFORE,
    FIRST_ENERGY,
    FREE,
    GRACE,
    OF_CHANGE,
    TORN,
    WORK,
    look_from_supports,
    mass_and_inertia,
    sum_energies,
    support_at,
)
from tamias2d.stepped.layout import (
    ACTIVE,
    ACTIVE_BODY,
    BLOCKS,
    DYNAMIC,
    ISLAND,
    LEANS,
    SEEN,
    SPIN,
    SUMS,
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

# what follows from the sums of an island: which share of the bounce is kept, energy with it, and
# how much may stay, J
KEPT, NOW, MOST = SUMS + 5, SUMS + 6, SUMS + 7
# the motion as one, seen from the lowest body: mass, momentum, its angular one; moments of the mass
WHOLE, ALONG_X, ALONG_Y, ROUND = SUMS, SUMS + 1, SUMS + 2, SUMS + 3
MOMENT_X, MOMENT_Y, MOMENT = SUMS + 4, SUMS + 8, SUMS + 9
CALMED = SUMS + 5  # the factor of what differs from it


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
    carried: Array,
    energy: Array,
    rows: Array,
    lanes: Whole,
    bouncing: int,
) -> None:
    """Take back of the bounce and of the motion of each island what makes energy."""
    look_from_supports(counts, pose, motion, body, kind, hits, island, carried, energy)
    sum_energies(
        settings, counts, pose, motion, load, body, kind, hits, island, carried, energy, bouncing
    )
    if share_bounces(counts, kind, hits, island, energy, bouncing):
        take_back(counts, motion, kind, hits, island, energy)
        take_back_pushes(counts, kind, island, energy, rows, lanes)
    if choose_calm(counts, kind, hits, island, energy):
        sum_motions(counts, pose, motion, body, kind, hits, island, energy)
        calm(counts, pose, motion, kind, hits, island, energy)


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
