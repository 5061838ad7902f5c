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

from tamias2d.engine.solver.energy import (
    FREE,
    GRACE,
    SUPPORTED_BY_MORE,
    find_supports,
    mass_and_inertia,
    sum_island_energies,
    support_at,
)
from tamias2d.engine.tables import (
    ACTIVE,
    ANGULAR_MOMENTUM,
    BLOCKS,
    BODY_A,
    BODY_B,
    CALM_FACTOR,
    DYNAMIC,
    ENERGY_AFTER,
    ENERGY_BEFORE,
    ENERGY_KEPT,
    ENERGY_MOST,
    ENERGY_OF_CHANGE,
    ENERGY_START,
    FILLED,
    FIRST_BOUNCE,
    ISLAND_MASS,
    KEPT_SHARE,
    LANES,
    MOMENT_OF_INERTIA,
    MOMENT_X,
    MOMENT_Y,
    MOMENTUM_X,
    MOMENTUM_Y,
    P_NORMAL,
    P_TOTAL,
    POINTS,
    ROOT,
    SEEN,
    SHARED,
    SIZE,
    SPIN,
    SUPPORT,
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


def bound_energy(
    control: Control,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
    bouncing: int,
) -> None:
    """Take back of the bounce and of the motion of each island what makes energy."""
    find_supports(bodies, touching, constraints, islands)
    sum_island_energies(control, bodies, touching, constraints, islands, bouncing)
    if choose_kept_shares(bodies, touching, constraints, islands, bouncing):
        keep_shares(bodies, touching, constraints, islands)
        keep_impulse_shares(bodies, constraints, islands)
    if choose_islands_to_calm(bodies, touching, constraints, islands):
        sum_island_motions(bodies, touching, constraints, islands)
        calm(bodies, touching, constraints, islands)


def choose_kept_shares(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands, bouncing: int
) -> bool:
    """Write for each island which share of its bounce it keeps; return whether one loses any."""
    some = False
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] != DYNAMIC or islands.links[i, ROOT] != i:
            continue
        row = islands.energy[i]
        before, after, change = row[ENERGY_BEFORE], row[ENERGY_AFTER], row[ENERGY_OF_CHANGE]
        row[ENERGY_MOST] = kinetic_energy_most(row[ENERGY_START], row[WORK])
        most = max(row[ENERGY_MOST], before)
        row[KEPT_SHARE], row[ENERGY_KEPT] = 1.0, after
        if bouncing > 0 and row[SUPPORT] != SUPPORTED_BY_MORE and after > most * (1.0 + GRACE):
            rise, room = after - before, most - before
            steep = rise > change
            share = (
                kept_share_rising(room, rise, change)
                if steep
                else kept_share_falling(room, rise, change)
            )
            row[KEPT_SHARE], row[ENERGY_KEPT] = (
                share,
                kinetic_energy_kept(before, after, change, share),
            )
            some = True
    return some


def keep_shares(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Leave each body the share of the bounce that its island keeps."""
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == DYNAMIC:
            share = islands.energy[islands.links[i, ROOT], KEPT_SHARE]
            if share < 1.0:
                before, now = islands.energy[i, UNBOUNCED:], bodies.motion[i]
                now[VX], now[VY] = velocity_kept((before[0], before[1]), (now[VX], now[VY]), share)
                now[SPIN] = angular_velocity_kept(before[2], now[SPIN], share)


def keep_impulse_shares(bodies: Bodies, constraints: Constraints, islands: Islands) -> None:
    """Leave each contact the share of its bounce, which is in the place of its gap by now."""
    for b in range(constraints.counts[BLOCKS]):
        row = constraints.blocks[b]
        for m in range(constraints.lanes[b, FILLED]):
            i = constraints.lanes[b, BODY_A + m]
            i = i if bodies.kind[i] == DYNAMIC else constraints.lanes[b, BODY_B + m]
            share = islands.energy[islands.links[i, ROOT], KEPT_SHARE]
            if share < 1.0:
                for n in range(constraints.lanes[b, POINTS]):
                    at = SHARED + n * SIZE + m
                    bounce = row[FIRST_BOUNCE + n * LANES + m]
                    row[at + P_NORMAL] = push_kept(row[at + P_NORMAL], bounce, share)
                    row[at + P_TOTAL] = push_kept(row[at + P_TOTAL], bounce, share)


def choose_islands_to_calm(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> bool:
    """Return whether some island still has too much energy."""
    some = False
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == DYNAMIC and islands.links[i, ROOT] == i:
            row = islands.energy[i]
            much = row[SUPPORT] != SUPPORTED_BY_MORE and row[ENERGY_KEPT] > row[ENERGY_MOST] * (
                1.0 + GRACE
            )
            row[CALM_FACTOR] = 0.0 if much else 1.0
            some = some or much
    return some


def sum_island_motions(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Find how islands with too much energy would move as one, and how far towards it they go.

    What leans on something moves as that does.
    """
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == DYNAMIC and islands.links[i, ROOT] == i:
            for n in (
                ISLAND_MASS,
                MOMENTUM_X,
                MOMENTUM_Y,
                ANGULAR_MOMENTUM,
                MOMENT_X,
                MOMENT_Y,
                MOMENT_OF_INERTIA,
            ):
                islands.energy[i, n] = 0.0
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        root = islands.links[i, ROOT]
        if (
            bodies.kind[i] != DYNAMIC
            or islands.energy[root, CALM_FACTOR] == 1.0
            or islands.energy[root, SUPPORT] != FREE
        ):
            continue
        row = islands.energy[root]
        mass, inertia = mass_and_inertia(i, bodies.properties)
        place = (bodies.pose[i, X] - bodies.pose[root, X], bodies.pose[i, Y] - bodies.pose[root, Y])
        now = velocity_seen(
            (bodies.motion[i, VX], bodies.motion[i, VY]), (row[SEEN], row[SEEN + 1])
        )
        along, moment = momentum(mass, now), mass_moment(mass, place)
        row[ISLAND_MASS] += mass
        row[MOMENTUM_X] += along[0]
        row[MOMENTUM_Y] += along[1]
        row[ANGULAR_MOMENTUM] += angular_momentum(mass, place, now, inertia, bodies.motion[i, SPIN])
        row[MOMENT_X] += moment[0]
        row[MOMENT_Y] += moment[1]
        row[MOMENT_OF_INERTIA] += inertia_origin(mass, place, inertia)
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if (
            bodies.kind[i] == DYNAMIC
            and islands.links[i, ROOT] == i
            and islands.energy[i, CALM_FACTOR] != 1.0
        ):
            find_rigid_motion(islands.energy[i])


def find_rigid_motion(row: Array) -> None:
    """Write the motion of an island as one, and the factor of what differs from it."""
    least = 0.0
    if row[SUPPORT] == FREE:
        mass = row[ISLAND_MASS]
        place = position_island((row[MOMENT_X], row[MOMENT_Y]), mass)
        by = velocity_island((row[MOMENTUM_X], row[MOMENTUM_Y]), mass)
        inertia = inertia_island(row[MOMENT_OF_INERTIA], mass, place)
        spin = 0.0
        if inertia > 0.0:
            spin = angular_velocity_island(row[ANGULAR_MOMENTUM], mass, place, by, inertia)
        least = kinetic_energy(mass, by, inertia, spin)
        by_x, by_y = point_velocity(by, spin, (-place[0], -place[1]))
        row[SEEN] += by_x
        row[SEEN + 1] += by_y
        row[SEEN + 2] = spin
    row[CALM_FACTOR] = 0.0
    if row[ENERGY_MOST] > least and row[ENERGY_KEPT] > least:
        row[CALM_FACTOR] = calm_share(row[ENERGY_KEPT], row[ENERGY_MOST], least)


def calm(bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands) -> None:
    """Let bodies of islands with too much energy come nearer to moving as one."""
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] != DYNAMIC:
            continue
        part = islands.energy[islands.links[i, ROOT], CALM_FACTOR]
        if part < 1.0:
            whole, spin = support_at(i, bodies, islands)
            now = bodies.motion[i]
            now[VX], now[VY] = velocity_calmed((now[VX], now[VY]), whole, part)
            now[SPIN] = angular_velocity_calmed(now[SPIN], spin, part)
