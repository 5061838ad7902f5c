"""The energy of groups with springs is compared at both ends of a part, and put right (DD91).

Springs are held, or act in substeps, as if nothing were met on the way. Cost: where springs are in
the world and something was met, some visits to each body and spring.
"""

from math import sqrt

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.contact_list import current_contacts
from tamias2d.engine.joints.sprung import add_gains_of_mechanisms
from tamias2d.engine.solver.energy import GRACE, mass_and_inertia
from tamias2d.engine.solver.island_damping import (
    add_to_island,
    begin_motion,
    find_rigid_motion,
    place_from,
)
from tamias2d.engine.solver.support import FREE, SUPPORTED_BY_MORE
from tamias2d.engine.springs.groups import find_groups
from tamias2d.engine.springs.held import release_springs, turned
from tamias2d.engine.tables import Bodies, Control, Islands, Springs, World
from tamias2d.generated.definitions import (
    acceleration,
    angular_acceleration,
    coordinate_velocity_gain,
    coordinate_velocity_later,
    kinetic_energy,
    momentum,
    point_velocity,
)
from tamias2d.generated.island_energy import (
    angular_velocity_damped,
    angular_velocity_repaid,
    balanced_share,
    energy_along_given,
    energy_unpaid,
    given_product,
    held_excess,
    shift_seen,
    spring_gain,
    velocity_damped,
    velocity_island,
    velocity_repaid,
    velocity_seen,
    work,
)
from tamias2d.generated.spring_step import tension_held
from tamias2d.state import Array

MOST_RETURNED = sqrt(2.0)  # times a motion: springs give back no more energy than it has


def note_start_of_springs(bodies: Bodies) -> None:
    """Note poses and velocities as a part begins, with which it is compared."""
    for i in range(len(bodies.pose)):
        for n in range(3):
            bodies.start[i, n], bodies.start[i, 3 + n] = bodies.pose[i, n], bodies.motion[i, n]


def balance_springs(world: World) -> None:
    """Put the energy of all groups right that have springs, and of which a body met something."""
    bodies, springs, islands = world.bodies, world.springs, world.islands
    flown = world.control.progress[tb.FLOWN] > 1.0
    if not flown and world.touching.counts[tb.TOUCHING] == 0:
        return
    contacts = current_contacts(world.broad_phase, world.buffers)
    release_springs(bodies, springs)
    find_groups(flown, world, contacts)
    find_group_references(bodies, springs, islands)
    for n in range(springs.counts[tb.NETWORKS]):
        if springs.networks[n, tb.N_STATUS] == tb.TOUCHED_SOFT:
            put_network_right(n, world.control, bodies, springs, islands)
    sum_group_energies(world.control, bodies, springs, islands)
    for n in range(springs.counts[tb.NETWORKS]):
        add_gains_of_network(n, bodies, springs, islands)
    add_gains_of_mechanisms(world)
    if find_unpaid(bodies, springs, islands):
        for k in range(len(springs.members)):
            for c in range(3):
                bodies.load[springs.slot[k], c] = springs.members[k, tb.MEAN_LOAD + c]
        pay_from_given(world.control, bodies, springs, islands)
        scale_motions(bodies, springs, islands)


def is_balanced(i: int, bodies: Bodies, springs: Springs, islands: Islands) -> bool:
    """Return whether a body is of a group whose energy is to be put right."""
    row = islands.energy[springs.group[i]]
    bounded = row[tb.SUPPORT] != SUPPORTED_BY_MORE and row[tb.REFERENCE + 2] == 0.0
    return bool(bodies.kind[i] == tb.DYNAMIC and row[tb.SPRUNG] * row[tb.MET] > 0.0 and bounded)


def find_group_references(bodies: Bodies, springs: Springs, islands: Islands) -> None:
    """Let groups without support be seen from their centres of mass as the part began."""
    for i in range(len(bodies.kind)):
        row = islands.energy[i]
        row[tb.ISLAND_MASS] = row[tb.MOMENTUM_X] = row[tb.MOMENTUM_Y] = 0.0
        row[tb.ENERGY_START] = row[tb.ENERGY_AFTER] = row[tb.WORK] = 0.0
    for i in range(len(bodies.kind)):
        if is_balanced(i, bodies, springs, islands):
            row, mass = (
                islands.energy[springs.group[i]],
                1.0 / bodies.properties[i, tb.INVERSE_MASS],
            )
            x, y = momentum(mass, (bodies.start[i, 3], bodies.start[i, 4]))
            row[tb.MOMENTUM_X] += x
            row[tb.MOMENTUM_Y] += y
            row[tb.ISLAND_MASS] += mass
    for i in range(len(bodies.kind)):
        row = islands.energy[i]
        if row[tb.ISLAND_MASS] > 0.0 and row[tb.SUPPORT] == FREE:
            whole = (row[tb.MOMENTUM_X], row[tb.MOMENTUM_Y])
            row[tb.REFERENCE], row[tb.REFERENCE + 1] = velocity_island(whole, row[tb.ISLAND_MASS])


def sum_group_energies(
    control: Control, bodies: Bodies, springs: Springs, islands: Islands
) -> None:
    """Add up the kinetic energies of groups, then and now, and the work of given loads, J."""
    for i in range(len(bodies.kind)):
        if is_balanced(i, bodies, springs, islands):
            row, then = islands.energy[springs.group[i]], bodies.start[i]
            mass, inertia = mass_and_inertia(i, bodies.properties)
            seen = velocity_seen((then[3], then[4]), (row[tb.REFERENCE], row[tb.REFERENCE + 1]))
            row[tb.ENERGY_START] += kinetic_energy(mass, seen, inertia, then[5])
            row[tb.ENERGY_AFTER] += energy_of(i, row, bodies)
            row[tb.WORK] += work_on(i, row, control, bodies)


def energy_of(i: int, row: Array, bodies: Bodies) -> float:
    """Return the kinetic energy of a body as seen from the reference in a row, J."""
    mass, inertia = mass_and_inertia(i, bodies.properties)
    now, by = bodies.motion[i], (row[tb.REFERENCE], row[tb.REFERENCE + 1])
    seen = velocity_seen((now[tb.VX], now[tb.VY]), by)
    return kinetic_energy(mass, seen, inertia, now[tb.SPIN])


def work_on(i: int, row: Array, control: Control, bodies: Bodies) -> float:
    """Return the work of gravity and given loads on a body in a part, as seen from there, J."""
    mass, _ = mass_and_inertia(i, bodies.properties)
    gravity, load = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y]), bodies.load[i]
    x, y, turn = way_of(i, bodies)
    by = (row[tb.REFERENCE], row[tb.REFERENCE + 1])
    shift = shift_seen((x, y), by, control.progress[tb.PART_TIME])
    return work(mass, gravity, (load[0], load[1]), load[2], shift, turn)


def way_of(i: int, bodies: Bodies) -> tuple[float, float, float]:
    """Return how far a body has come in a part, m, m, rad; impacts may have moved its pose."""
    pose, start, now = bodies.pose[i], bodies.start[i], bodies.motion[i]
    return (
        (pose[tb.X] - start[tb.X]) + now[tb.DX],
        (pose[tb.Y] - start[tb.Y]) + now[tb.DY],
        (pose[tb.ANGLE] - start[tb.ANGLE]) + now[tb.DANGLE],
    )


def put_network_right(
    n: int, control: Control, bodies: Bodies, springs: Springs, islands: Islands
) -> None:
    """Scale the motion of a network by what its impulses in substeps gave beyond its springs.

    One that is tied is seen from there; of another one, momentum and angular momentum stay.
    """
    first, last = springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]
    root = first_free_of(n, bodies, springs)
    gain, exact = gain_of_network(n, bodies, springs)
    if not (exact and is_balanced(root, bodies, springs, islands)):
        return
    group, row = islands.energy[springs.group[root]], islands.energy[len(bodies.kind) - 1]
    tied = is_tied(n, bodies, springs)
    row[tb.SUPPORT] = group[tb.SUPPORT] if tied else FREE
    for c in range(3):
        row[tb.REFERENCE + c] = group[tb.REFERENCE + c]
    row[tb.ENERGY_AFTER] = given = 0.0
    begin_motion(1.0, row)
    for k in range(first, last):
        i = springs.slot[k]
        if bodies.kind[i] == tb.DYNAMIC:
            given += springs.members[k, tb.KICK_WORK] - work_on(i, row, control, bodies)
            row[tb.ENERGY_AFTER] += energy_of(i, row, bodies)
            add_motion_in_part(i, root, row, bodies)
    row[tb.ENERGY_SURPLUS] = held_excess(gain, given)
    find_group_motion(row)
    for k in range(first, last):
        if bodies.kind[springs.slot[k]] == tb.DYNAMIC:
            scale_motion(springs.slot[k], root, row, bodies)


def first_free_of(n: int, bodies: Bodies, springs: Springs) -> int:
    """Return the first body of a network that moves freely."""
    k = springs.networks[n, tb.N_MEMBER]
    while bodies.kind[springs.slot[k]] != tb.DYNAMIC:
        k += 1
    return int(springs.slot[k])


def is_tied(n: int, bodies: Bodies, springs: Springs) -> bool:
    """Return whether a network is tied to the plane, or to what nothing pushes."""
    tied = False
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        tied = tied or bodies.kind[springs.slot[k]] != tb.DYNAMIC
    for s in range(springs.networks[n, tb.N_SPRING], springs.networks[n + 1, tb.N_SPRING]):
        tied = tied or springs.ends[s, tb.MEMBER_B] < 0
    return bool(tied)


def gain_of_network(n: int, bodies: Bodies, springs: Springs) -> tuple[float, bool]:
    """Return what the springs of a network have gained, J, and whether nothing else damps it."""
    gain, exact = 0.0, True
    for s in range(springs.networks[n, tb.N_SPRING], springs.networks[n + 1, tb.N_SPRING]):
        spring = springs.springs[s]
        length, later = spring[tb.LENGTH], length_later(s, bodies, springs)
        tension = tension_held(spring[tb.STIFFNESS], spring[tb.REST_LENGTH], length, later)
        gain += spring_gain(tension, length, later)
        exact = exact and spring[tb.DAMPER] == 0.0
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        drag = bodies.propagators[int(bodies.properties[springs.slot[k], tb.PROPAGATOR])]
        at = tb.WHOLE_STEP + tb.DECAY
        exact = exact and drag[at] == 1.0 and drag[at + tb.ANGULAR] == 1.0
    return gain, bool(exact)


def add_gains_of_network(n: int, bodies: Bodies, springs: Springs, islands: Islands) -> None:
    """Add what the springs of a network have gained, and that beyond what held loads took, J."""
    gain, exact = gain_of_network(n, bodies, springs)
    done = 0.0
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        row, way = springs.members[k], way_of(springs.slot[k], bodies)
        for c in range(3):
            done += row[tb.PULL + c] * way[c]
    held = exact and springs.networks[n, tb.N_STATUS] == tb.ALONE
    root = islands.energy[springs.group[first_free_of(n, bodies, springs)]]
    root[tb.SPRING_GAIN] += gain
    root[tb.HELD_EXCESS] += held_excess(gain, done) if held else 0.0


def length_later(s: int, bodies: Bodies, springs: Springs) -> float:
    """Return the length of a spring as a part ends, m."""
    spring = springs.springs[s]
    a, b = springs.ends[s, tb.MEMBER_A], springs.ends[s, tb.MEMBER_B]
    by_x, by_y = end_moved(springs.slot[a], tb.ANCHOR_A, bodies, spring)
    x, y = spring[tb.SPAN_X] - by_x, spring[tb.SPAN_Y] - by_y
    if b >= 0:
        by_x, by_y = end_moved(springs.slot[b], tb.ANCHOR_B, bodies, spring)
        x, y = x + by_x, y + by_y
    return sqrt(x * x + y * y)


def end_moved(i: int, at: int, bodies: Bodies, spring: Array) -> tuple[float, float]:
    """Return how far an end of a spring has come in a part, m."""
    anchor, (x, y, turn) = (spring[at], spring[at + 1]), way_of(i, bodies)
    before = turned(anchor, bodies.start[i, tb.ANGLE])
    after = turned(anchor, bodies.start[i, tb.ANGLE] + turn)
    return x + (after[0] - before[0]), y + (after[1] - before[1])


def find_unpaid(bodies: Bodies, springs: Springs, islands: Islands) -> bool:
    """Note what groups have too much, or too little, J; return whether one has."""
    some = False
    for i in range(len(bodies.kind)):
        row = islands.energy[i]
        row[tb.ENERGY_SURPLUS] = row[tb.GIVEN_PRODUCT] = row[tb.CHANGE_ENERGY] = 0.0
        if springs.group[i] == i and is_balanced(i, bodies, springs, islands):
            gain, after = row[tb.SPRING_GAIN], row[tb.ENERGY_AFTER]
            unpaid = energy_unpaid(
                after, row[tb.ENERGY_START], row[tb.WORK], gain, row[tb.HELD_EXCESS]
            )
            size = after + row[tb.ENERGY_START] + abs(row[tb.WORK]) + abs(gain)
            if abs(unpaid) > GRACE * size:
                row[tb.ENERGY_SURPLUS] = unpaid
                some = True
    return some


def pay_from_given(control: Control, bodies: Bodies, springs: Springs, islands: Islands) -> None:
    """Let each group that leans on something pay along what contacts gave its bodies, as one."""
    for i in range(len(bodies.kind)):
        if is_supported(i, bodies, springs, islands):
            row, now = islands.energy[springs.group[i]], bodies.motion[i]
            mass, inertia = mass_and_inertia(i, bodies.properties)
            x, y, turned_by = given_to(i, control, bodies)
            seen = velocity_seen(
                (now[tb.VX], now[tb.VY]), (row[tb.REFERENCE], row[tb.REFERENCE + 1])
            )
            row[tb.GIVEN_PRODUCT] += given_product(
                mass, seen, (x, y), inertia, now[tb.SPIN], turned_by
            )
            row[tb.CHANGE_ENERGY] += kinetic_energy(mass, (x, y), inertia, turned_by)
    for i in range(len(bodies.kind)):
        if is_supported(i, bodies, springs, islands):
            row, now = islands.energy[springs.group[i]], bodies.motion[i]
            share, product, change = (
                share_of_given(row),
                row[tb.GIVEN_PRODUCT],
                row[tb.CHANGE_ENERGY],
            )
            if share != 1.0:
                x, y, turned_by = given_to(i, control, bodies)
                now[tb.VX], now[tb.VY] = velocity_repaid(
                    (now[tb.VX], now[tb.VY]), (x, y), share, product, change
                )
                now[tb.SPIN] = angular_velocity_repaid(
                    now[tb.SPIN], turned_by, share, product, change
                )
    for i in range(len(bodies.kind)):
        row, share = islands.energy[i], share_of_given(islands.energy[i])
        if row[tb.SUPPORT] != FREE and row[tb.ENERGY_SURPLUS] != 0.0:
            along = (
                energy_along_given(row[tb.GIVEN_PRODUCT], row[tb.CHANGE_ENERGY])
                if share != 1.0
                else 0.0
            )
            paid = along * (1.0 - share * share)
            row[tb.ENERGY_AFTER] -= paid
            left = row[tb.ENERGY_SURPLUS] - paid
            row[tb.ENERGY_SURPLUS] = left if left > GRACE * row[tb.ENERGY_AFTER] else 0.0


def is_supported(i: int, bodies: Bodies, springs: Springs, islands: Islands) -> bool:
    """Return whether a body is of a group that leans on something, and has what is not right."""
    row = islands.energy[springs.group[i]]
    return bool(
        bodies.kind[i] == tb.DYNAMIC and row[tb.SUPPORT] != FREE and row[tb.ENERGY_SURPLUS] != 0.0
    )


def share_of_given(row: Array) -> float:
    """Return the factor of the motion of a group along what contacts gave it."""
    product, change = row[tb.GIVEN_PRODUCT], row[tb.CHANGE_ENERGY]
    if not (product > 0.0 and change > 0.0):
        return 1.0
    energy = energy_along_given(product, change)
    return float(balanced_share(energy, 0.0, row[tb.ENERGY_SURPLUS], MOST_RETURNED))


def given_to(i: int, control: Control, bodies: Bodies) -> tuple[float, float, float]:
    """Return the change of a body's velocities that forces and springs alone do not make."""
    gravity, load = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y]), bodies.load[i]
    x, y = acceleration(gravity, (load[0], load[1]), bodies.properties[i, tb.INVERSE_MASS])
    spin = angular_acceleration(load[2], bodies.properties[i, tb.INVERSE_INERTIA])
    return (
        given_along(i, 0, x, bodies),
        given_along(i, 1, y, bodies),
        given_along(i, 2, spin, bodies),
    )


def given_along(i: int, axis: int, by: float, bodies: Bodies) -> float:
    """Return the same of one coordinate, which loads alone accelerate."""
    propagator = bodies.propagators[int(bodies.properties[i, tb.PROPAGATOR])]
    at = tb.WHOLE_STEP + tb.ANGULAR if axis == 2 else tb.WHOLE_STEP
    gain = coordinate_velocity_gain(propagator[at + tb.GAIN], by)
    before = bodies.start[i, 3 + axis]
    return float(
        bodies.motion[i, axis] - coordinate_velocity_later(propagator[at + tb.DECAY], before, gain)
    )


def scale_motions(bodies: Bodies, springs: Springs, islands: Islands) -> None:
    """Scale what differs from the motion of a group as one, or of its support, by what is left."""
    for i in range(len(bodies.kind)):
        begin_motion(1.0, islands.energy[i])
    for i in range(len(bodies.kind)):
        root = springs.group[i]
        if bodies.kind[i] == tb.DYNAMIC and islands.energy[root, tb.ENERGY_SURPLUS] != 0.0:
            add_motion_in_part(i, root, islands.energy[root], bodies)
    for i in range(len(bodies.kind)):
        if islands.energy[i, tb.ENERGY_SURPLUS] != 0.0:
            find_group_motion(islands.energy[i])
    for i in range(len(bodies.kind)):
        root = springs.group[i]
        if bodies.kind[i] == tb.DYNAMIC and islands.energy[root, tb.ENERGY_SURPLUS] != 0.0:
            scale_motion(i, root, islands.energy[root], bodies)


def scale_motion(i: int, root: int, row: Array, bodies: Bodies) -> None:
    """Scale what differs in a body's motion from that as one, which stands in a row."""
    share, spin, now = row[tb.DAMPED_SHARE], row[tb.REFERENCE + 2], bodies.motion[i]
    velocity = (row[tb.REFERENCE], row[tb.REFERENCE + 1])
    velocity = point_velocity(velocity, spin, place_from(root, i, bodies))
    now[tb.VX], now[tb.VY] = velocity_damped((now[tb.VX], now[tb.VY]), velocity, share)
    if row[tb.SUPPORT] != FREE or is_turned_in_part(i, bodies):
        now[tb.SPIN] = angular_velocity_damped(now[tb.SPIN], spin, share)


def add_motion_in_part(i: int, root: int, row: Array, bodies: Bodies) -> None:
    """Add the motion of a body to that as one; a spin that nothing changed is apart."""
    now = bodies.motion[i]
    mass, inertia = mass_and_inertia(i, bodies.properties)
    seen = velocity_seen((now[tb.VX], now[tb.VY]), (row[tb.REFERENCE], row[tb.REFERENCE + 1]))
    if not is_turned_in_part(i, bodies):
        row[tb.ENERGY_APART] += kinetic_energy(mass, (0.0, 0.0), inertia, now[tb.SPIN])
        inertia = 0.0
    add_to_island(mass, inertia, place_from(root, i, bodies), seen, now[tb.SPIN], row)


def is_turned_in_part(i: int, bodies: Bodies) -> bool:
    """Return whether anything has turned a body in this part."""
    return bool(bodies.motion[i, tb.SPIN] != bodies.start[i, 5])


def find_group_motion(row: Array) -> None:
    """Find the motion as one of a group, and the factor of all that differs from it."""
    unpaid, energy = row[tb.ENERGY_SURPLUS], row[tb.ENERGY_AFTER]
    row[tb.ENERGY_KEPT], row[tb.ENERGY_BOUND] = energy, energy - unpaid
    find_rigid_motion(row)
    least = row[tb.ENERGY_LEAST]
    share = 1.0
    if energy - least > GRACE * energy:
        share = balanced_share(energy, least, unpaid, MOST_RETURNED)
    row[tb.DAMPED_SHARE] = share
