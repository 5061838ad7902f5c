"""A bound on energy: contacts never make any, however many act at once (IM11, DD36, DD37).

The kinetic energy of an island may be no more than when the step began and what gravity and forces
have given it since. Where they have taken some, as overlaps are pushed apart against them, the
bodies that rise lose as much (`lifting`). Each contact is solved by itself; where many hold the
same bodies, together they may give more than there was.

Of restitution an island keeps the largest share that the bound allows; what is still too much
is dissipated in the bodies that got it, or the motion of all is damped. The bound is tested where
there is restitution, or where there is more energy in all than there may be. Cost: some visits to
each body.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.dissipation import dissipate_excess
from tamias2d.engine.energy.angular_momentum import keep_angular_momentum
from tamias2d.engine.energy.held_upright import find_pressed_arms, work_of_holding
from tamias2d.engine.energy.island_damping import (
    choose_islands_to_damp,
    damp_islands,
    sum_island_motions,
)
from tamias2d.engine.energy.joined_gains import note_gains
from tamias2d.engine.energy.lifting import dissipate_rising
from tamias2d.engine.energy.load_seen import load_seen
from tamias2d.engine.energy.step_energy import GRACE, mass_and_inertia
from tamias2d.engine.energy.support import (
    SUPPORTED_BY_MORE,
    find_references,
    reference_at,
)
from tamias2d.engine.energy.support_work import add_support_work
from tamias2d.engine.joints.island_bound import bound_joined, support_joined
from tamias2d.engine.joints.reserve import note_reserves
from tamias2d.engine.tables import Bodies, Constraints, Control, Islands, Joints, Touching
from tamias2d.generated.definitions import kinetic_energy
from tamias2d.generated.island_energy import (
    accumulated_impulse_kept,
    angular_velocity_kept,
    angular_velocity_seen,
    energy_given,
    kept_share_falling,
    kept_share_rising,
    kinetic_energy_kept,
    kinetic_energy_most,
    shift_seen,
    turn_seen,
    velocity_kept,
    velocity_seen,
    work,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array, Vector


def note_before_restitution(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Note the velocities of all bodies with contacts before restitution."""
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        for n in range(3):
            islands.energy[i, tb.BEFORE_RESTITUTION + n] = bodies.motion[i, n]


def mark_bounced(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Mark what restitution alone has pushed as pushed: until then it was like one in flight."""
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        for n in range(3):
            if bodies.motion[i, n] != islands.energy[i, tb.BEFORE_RESTITUTION + n]:
                bodies.moved[i] = tb.MOVED


def bound_energy(
    control: Control,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
    joints: Joints,
) -> None:
    """Take back of restitution, and of the motion of each island, what makes energy."""
    find_references(bodies, touching, constraints, islands)
    support_joined(bodies, islands, joints)
    find_pressed_arms(bodies, touching, constraints, islands)
    sum_island_energies(control, bodies, touching, constraints, islands)
    bound_joined(control, bodies, touching, constraints, islands, joints)
    if choose_kept_shares(constraints, islands):
        keep_shares(bodies, touching, constraints, islands)
        keep_impulse_shares(bodies, constraints, islands)
    if constraints.counts[tb.FREE_ISLANDS] > 0:
        keep_angular_momentum(bodies, touching, constraints, islands, joints)
    if choose_islands_to_damp(islands):
        sum_island_motions(bodies, touching, constraints, islands)
        damp_islands(bodies, touching, constraints, islands)
        dissipate_excess(control, bodies, touching, constraints, islands, joints)
        note_gains(control, islands, joints)
    dissipate_rising(control, bodies, touching, constraints, islands)
    note_reserves(control, bodies, touching, constraints, islands, joints)


def sum_island_energies(
    control: Control,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
) -> None:
    """Add up the kinetic energies of all islands, and the work of forces, J."""
    for n in range(islands.counts[tb.ROOTS]):
        for at in range(tb.ENERGY_START, tb.ENERGY_OF_CHANGE + 1):
            islands.energy[islands.roots[n], at] = 0.0
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == tb.DYNAMIC:
            velocity, spin = reference_at(i, bodies, islands)
            row = islands.energy[islands.links[i, tb.ROOT]]
            work_of_body = work_seen(i, velocity, spin, control, bodies)
            work_of_body += work_of_holding(i, spin, bodies, islands)
            row[tb.WORK] += work_of_body
            sum_body_energy(i, velocity, spin, work_of_body, bodies, islands)
            if constraints.counts[tb.BOUNCING] > 0:
                sum_restitution_energy(i, velocity, spin, bodies, islands.energy[i], row)
    add_support_work(bodies, constraints, islands)


def work_seen(i: int, velocity: Vector, spin: float, control: Control, bodies: Bodies) -> float:
    """Return the work of forces on a body as seen from the reference, J."""
    gravity = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
    time_step = control.progress[tb.PART_TIME]
    motion, mass = bodies.motion[i], 1.0 / bodies.properties[i, tb.INVERSE_MASS]
    force, torque = load_seen(i, velocity, spin, bodies)
    shift = shift_seen((motion[tb.DX], motion[tb.DY]), velocity, time_step)
    turn = turn_seen(motion[tb.DANGLE], spin, time_step)
    return work(mass, gravity, force, torque, shift, turn)


def sum_body_energy(
    i: int, velocity: Vector, spin: float, work_of_body: float, bodies: Bodies, islands: Islands
) -> None:
    """Add the energies of a body, then and now, and what contacts gave it, to those of its island.

    What forces gave it is given, J.
    """
    row = islands.energy[islands.links[i, tb.ROOT]]
    mass, inertia = mass_and_inertia(i, bodies.properties)
    then, now = bodies.substep_state[i], bodies.motion[i]
    seen = velocity_seen((then[tb.STEP_START], then[tb.STEP_START + 1]), velocity)
    spin_seen = angular_velocity_seen(then[tb.STEP_START + 2], spin)
    start = kinetic_energy(mass, seen, inertia, spin_seen)
    islands.energy[i, tb.ENERGY_OWN] = kinetic_energy_most(start, max(work_of_body, 0.0))
    islands.energy[i, tb.TIED] = 0.0
    seen = velocity_seen((now[tb.VX], now[tb.VY]), velocity)
    spin_seen = angular_velocity_seen(now[tb.SPIN], spin)
    after = kinetic_energy(mass, seen, inertia, spin_seen)
    given = energy_given(after, start, work_of_body)
    islands.given[i] = given
    row[tb.ENERGY_START] += start
    row[tb.ENERGY_AFTER] += after
    row[tb.ENERGY_GIVEN_ALL] += max(given, 0.0)


def sum_restitution_energy(
    i: int, velocity: Vector, spin: float, bodies: Bodies, before: Array, row: Array
) -> None:
    """Add the energies of a body before restitution, and of its change, to those of its island."""
    mass, inertia = mass_and_inertia(i, bodies.properties)
    now, spin_before = bodies.motion[i], before[tb.BEFORE_RESTITUTION + 2]
    was = velocity_seen(
        (before[tb.BEFORE_RESTITUTION], before[tb.BEFORE_RESTITUTION + 1]), velocity
    )
    spin_seen = angular_velocity_seen(spin_before, spin)
    row[tb.ENERGY_BEFORE] += kinetic_energy(mass, was, inertia, spin_seen)
    change = velocity_seen(velocity_seen((now[tb.VX], now[tb.VY]), velocity), was)
    row[tb.ENERGY_OF_CHANGE] += kinetic_energy(mass, change, inertia, now[tb.SPIN] - spin_before)


def choose_kept_shares(constraints: Constraints, islands: Islands) -> bool:
    """Write which share of restitution each island keeps; return whether one loses any."""
    some = False
    for n in range(islands.counts[tb.ROOTS]):
        row = islands.energy[islands.roots[n]]
        before, after, change = (
            row[tb.ENERGY_BEFORE],
            row[tb.ENERGY_AFTER],
            row[tb.ENERGY_OF_CHANGE],
        )
        row[tb.ENERGY_BOUND] = kinetic_energy_most(row[tb.ENERGY_START], max(row[tb.WORK], 0.0))
        most = max(kinetic_energy_most(row[tb.ENERGY_START], row[tb.WORK]), before)
        row[tb.KEPT_SHARE], row[tb.ENERGY_KEPT] = 1.0, after
        bounded = constraints.counts[tb.BOUNCING] > 0 and row[tb.SUPPORT] != SUPPORTED_BY_MORE
        if bounded and after > most * (1.0 + GRACE):
            share = kept_share(before, after, change, most)
            row[tb.KEPT_SHARE] = share
            row[tb.ENERGY_KEPT] = kinetic_energy_kept(before, after, change, share)
            some = True
    return some


def kept_share(before: float, after: float, change: float, most: float) -> float:
    """Return the largest share of restitution with which an island has at most an energy, J."""
    rise, room = after - before, most - before
    if rise > change:
        return kept_share_rising(room, rise, change)
    return kept_share_falling(room, rise, change)


def keep_shares(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Leave each body the share of restitution that its island keeps."""
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == tb.DYNAMIC:
            share = islands.energy[islands.links[i, tb.ROOT], tb.KEPT_SHARE]
            if share < 1.0:
                before, now = islands.energy[i, tb.BEFORE_RESTITUTION :], bodies.motion[i]
                now[tb.VX], now[tb.VY] = velocity_kept(
                    (before[0], before[1]), (now[tb.VX], now[tb.VY]), share
                )
                now[tb.SPIN] = angular_velocity_kept(before[2], now[tb.SPIN], share)


def keep_impulse_shares(bodies: Bodies, constraints: Constraints, islands: Islands) -> None:
    """Leave each contact the share of its impulses of restitution that its island keeps."""
    lanes = constraints.lanes
    for b in range(constraints.counts[tb.BLOCKS]):
        row = constraints.blocks[b]
        for m in range(lanes[b, tb.FILLED]):
            i = lanes[b, tb.BODY_A + m]
            i = i if bodies.kind[i] == tb.DYNAMIC else lanes[b, tb.BODY_B + m]
            share = islands.energy[islands.links[i, tb.ROOT], tb.KEPT_SHARE]
            if share < 1.0:
                for n in range(lanes[b, tb.POINTS]):
                    at, bounce = tb.SHARED + n * tb.POINT_SIZE + m, n * LANES + m
                    impulse = row[tb.FIRST_RESTITUTION + bounce]
                    keep_impulse_share(at + tb.P_NORMAL_IMPULSE, impulse, share, row)
                    keep_impulse_share(at + tb.P_TOTAL_IMPULSE, impulse, share, row)
                    drag = row[tb.FIRST_REBOUND_DRAG + bounce]
                    keep_impulse_share(at + tb.P_TANGENT_IMPULSE, drag, share, row)
                    keep_impulse_share(at + tb.P_TOTAL_FRICTION, drag, share, row)
                    keep_impulse_share(tb.FIRST_RESTITUTION + bounce, impulse, share, row)
                    keep_impulse_share(tb.FIRST_REBOUND_DRAG + bounce, drag, share, row)


@inlined
def keep_impulse_share(column: int, impulse: float, share: float, row: Array) -> None:
    """Leave a column of a contact a share of an impulse that is in it."""
    row[column] = accumulated_impulse_kept(row[column], impulse, share)
