"""The energy of mechanisms that are free of contacts: it never rises by itself (IM15).

What is too much is taken from the motion of all bodies in proportion: relative to what the
mechanism is tied to, or else to its motion as one. Energies are those seen from there; what turns
a mechanism, moves against another thing to which it is tied, or has another velocity than before,
may give it any, unless its rows yield (DD86). Rows that have no rate have none afterwards.
One that is tied and has not the energy for its way keeps a part of it.
What was lost may be gained again (DD79): a scheme of order two goes to and fro about the right
energy, and would lose by a bound that is blind to it. Springs have energies, too.

Cost: a visit to each body and spring, and two more where there is too much.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.island_damping import (
    add_to_island,
    begin_motion,
    find_rigid_motion,
    place_from,
)
from tamias2d.engine.energy.load_seen import load_seen
from tamias2d.engine.energy.step_energy import can_be_turned, mass_and_inertia
from tamias2d.engine.energy.support import FREE, SUPPORTED_BY_ONE
from tamias2d.engine.joints.bounce import strikes
from tamias2d.engine.joints.island_bound import (
    energy_of_springs,
    may_get_any,
    support_mechanism,
    work_of_motors,
)
from tamias2d.engine.joints.opening import note_drive
from tamias2d.engine.joints.yielding import energy_driven, mass_of_mechanism, yields
from tamias2d.engine.tables import Bodies, Control, Islands, Joints
from tamias2d.generated.definitions import (
    kinetic_energy,
    point_velocity,
)
from tamias2d.generated.island_energy import (
    angular_velocity_damped,
    shift_seen,
    velocity_damped,
    velocity_seen,
    work,
)
from tamias2d.generated.joint_step import (
    energy_regained,
    energy_reserve_later,
    energy_scale_later,
    mechanism_energy_balance,
    way_kept,
)
from tamias2d.generated.soft_contact import shift_later
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector

RESERVE = 0.05  # of the energy at play lately: what may be gained of what was lost
SAME_MOTION = 1e-9  # of its energy: what differs by less is rounding
SCALE_FADE = 0.99  # in a part, of the energy at play: oscillations of some seconds keep theirs


def bound_mechanism(
    n: int, control: Control, bodies: Bodies, joints: Joints, islands: Islands, energy: Array
) -> None:
    """Take from the motion of a mechanism what is more than a step may end with.

    What it gains of what it has lost is no energy that contacts have made.
    """
    first, last = joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]
    row = islands.energy[joints.sparse[first, tb.N_BODY]]
    tied = joints.mechanisms[n, tb.M_TIED] == 1
    powered = joints.mechanisms[n, tb.M_TURNED_BY_MOTOR] + joints.mechanisms[n, tb.M_DRIVEN] > 0
    carried = joints.mechanisms[n, tb.M_CARRIED] == 1
    see_from_support(n, bodies, joints, islands)
    base = (row[tb.REFERENCE], row[tb.REFERENCE + 1])
    start, given, now = energies_of_part(first, last, base, control, bodies, joints)
    numbers = joints.numbers[joints.mechanisms[n, tb.M_JOINT]]
    sprung, reserve = energy_of_springs(n, joints), numbers[tb.J_RESERVE]
    if (carried and is_changed(start, numbers)) or may_get_any(n, row, joints):
        if yields(n, joints):
            driven = energy_driven(n, mass_of_mechanism(n, joints), row, control, bodies, joints)
            most = max(start + given + numbers[tb.J_ENERGY] - sprung, driven)
            now = damp_to(n, now, most, base, bodies, joints, row)
        note_balance(n, start, now, sprung, now, joints)
        return
    if tied and not powered and start + given + reserve < 0.0:
        share = way_kept(start, given, reserve)
        keep_part_of_way(first, last, share, base, control.progress[tb.PART_TIME], bodies, joints)
        given *= share
    worked = given + work_of_motors(n, joints)
    balance = mechanism_energy_balance(start, worked, numbers[tb.J_ENERGY], sprung, reserve)
    most = max(balance, 0.0)
    now = damp_to(n, now, most, base, bodies, joints, row)
    energy[tb.TOTAL_ENERGY_START] += energy_regained(now, start, given)
    note_balance(n, start, now, sprung, balance, joints)


def damp_to(
    n: int, now: float, most: float, base: Vector, bodies: Bodies, joints: Joints, row: Array
) -> float:
    """Let a mechanism have at most an energy, J; return that which it has then."""
    if not now > most:
        return now
    first, last = joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]
    row[tb.ENERGY_KEPT], row[tb.ENERGY_BOUND] = now, most
    damp_mechanism(first, last, row, bodies, joints)
    damped = row[tb.DAMPED_SHARE] > 0.0
    return most if damped else energy_of_motion(first, last, base, bodies, joints)


def rise_of_yielding(
    n: int, before: float, control: Control, bodies: Bodies, joints: Joints, islands: Islands
) -> None:
    """Let a mechanism that yields have no more energy than before, J, but what drives it gives."""
    first, last = joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]
    row = islands.energy[joints.sparse[first, tb.N_BODY]]
    see_from_support(n, bodies, joints, islands)
    most = max(before, energy_driven(n, mass_of_mechanism(n, joints), row, control, bodies, joints))
    base = (row[tb.REFERENCE], row[tb.REFERENCE + 1])
    now = energy_of_motion(first, last, base, bodies, joints)
    if now > most:
        add_motions(n, -1.0, bodies, joints)
        damp_to(n, now, most, base, bodies, joints, row)
        add_motions(n, 1.0, bodies, joints)


def add_motions(n: int, sign: float, bodies: Bodies, joints: Joints) -> None:
    """Add the velocities of a mechanism, with a sign, to what contacts have not done."""
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        i = joints.sparse[node, tb.N_BODY]
        for k in range(3):
            bodies.substep_state[i, tb.SUBSTEP_START + k] += sign * bodies.motion[i, k]


def energy_of_mechanism(n: int, bodies: Bodies, joints: Joints, islands: Islands) -> float:
    """Return the kinetic energy of a mechanism, J, as seen from what ties it."""
    first, last = joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]
    row = islands.energy[joints.sparse[first, tb.N_BODY]]
    see_from_support(n, bodies, joints, islands)
    base = (row[tb.REFERENCE], row[tb.REFERENCE + 1])
    return energy_of_motion(first, last, base, bodies, joints)


def note_drive_of(
    n: int, substep: float, control: Control, bodies: Bodies, joints: Joints, islands: Islands
) -> None:
    """Note how fast what ties a mechanism drives it in a substep, s: not at all if that stands."""
    joints.numbers[joints.mechanisms[n, tb.M_JOINT], tb.J_DRIVEN] = 0.0
    if joints.mechanisms[n, tb.M_CARRIED] + joints.mechanisms[n, tb.M_TIMED] > 0:
        see_from_support(n, bodies, joints, islands)
        row = islands.energy[joints.sparse[joints.sparse[n, tb.I_NODE], tb.N_BODY]]
        note_drive(n, row, substep, control, bodies, joints)


def see_from_support(n: int, bodies: Bodies, joints: Joints, islands: Islands) -> None:
    """Write the motion from which a mechanism is seen: that of what ties it, if it moves."""
    root = joints.sparse[joints.sparse[n, tb.I_NODE], tb.N_BODY]
    row = islands.energy[root]
    tied = joints.mechanisms[n, tb.M_TIED] == 1
    row[tb.SUPPORT], row[tb.DRIVEN_RATE] = SUPPORTED_BY_ONE if tied else FREE, 0.0
    row[tb.REFERENCE] = row[tb.REFERENCE + 1] = row[tb.REFERENCE + 2] = 0.0
    if joints.mechanisms[n, tb.M_CARRIED] == 1:
        row[tb.SUPPORT] = FREE
        support_mechanism(n, root, bodies, islands, joints)


def energies_of_part(
    first: int, last: int, base: Vector, control: Control, bodies: Bodies, joints: Joints
) -> tuple[float, float, float]:
    """Return the energy of some nodes as a part began, what loads gave since, and that now, J.

    As in all of these, motion is seen from what ties the nodes, which moves with a velocity, m/s.
    """
    gravity = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
    start = given = now = 0.0
    for node in range(first, last):
        i = joints.sparse[node, tb.N_BODY]
        mass, inertia = mass_and_inertia(i, bodies.properties)
        then, motion = bodies.substep_state[i], bodies.motion[i]
        velocity = velocity_seen((then[tb.STEP_START], then[tb.STEP_START + 1]), base)
        start += kinetic_energy(mass, velocity, inertia, then[tb.STEP_START + 2])
        shift = shift_seen((motion[tb.DX], motion[tb.DY]), base, control.progress[tb.PART_TIME])
        force, torque = load_seen(i, base, 0.0, bodies)
        given += work(mass, gravity, force, torque, shift, motion[tb.DANGLE])
        velocity = velocity_seen((motion[tb.VX], motion[tb.VY]), base)
        now += kinetic_energy(mass, velocity, inertia, motion[tb.SPIN])
    return start, given, now


def energy_of_motion(first: int, last: int, base: Vector, bodies: Bodies, joints: Joints) -> float:
    """Return the kinetic energy of some nodes, J."""
    energy = 0.0
    for node in range(first, last):
        i = joints.sparse[node, tb.N_BODY]
        mass, inertia = mass_and_inertia(i, bodies.properties)
        motion = bodies.motion[i]
        velocity = velocity_seen((motion[tb.VX], motion[tb.VY]), base)
        energy += kinetic_energy(mass, velocity, inertia, motion[tb.SPIN])
    return energy


def note_energy_of_springs(n: int, joints: Joints) -> None:
    """Note the energy of the springs of a mechanism as a part begins, and what it may gain yet."""
    numbers = joints.numbers[joints.mechanisms[n, tb.M_JOINT]]
    numbers[tb.J_ENERGY] = energy_of_springs(n, joints)
    numbers[tb.J_RESERVE_LATER], numbers[tb.J_SCALE_LATER] = (
        numbers[tb.J_RESERVE],
        numbers[tb.J_SCALE],
    )
    numbers[tb.J_MOTION_LATER] = numbers[tb.J_MOTION]


def note_balance(
    n: int, start: float, now: float, sprung: float, balance: float, joints: Joints
) -> None:
    """Note what of its balance, J, a mechanism lacks as a part ends: to gain, or to lose.

    Where it began with other motion than the last part ended with, joints may take of that what
    does not fit them: none may be gained for it, nor for what it loses as it strikes a limit.
    """
    numbers = joints.numbers[joints.mechanisms[n, tb.M_JOINT]]
    scale = energy_scale_later(numbers[tb.J_SCALE], now, sprung, SCALE_FADE)
    later = energy_reserve_later(balance, now, scale, RESERVE)
    changed = is_changed(start, numbers) or strikes(n, joints)
    numbers[tb.J_RESERVE_LATER] = min(later, numbers[tb.J_RESERVE]) if changed else later
    numbers[tb.J_SCALE_LATER], numbers[tb.J_MOTION_LATER] = scale, now


@inlined
def is_changed(start: float, numbers: Array) -> bool:
    """Return whether a mechanism begins with another energy of motion, J, than it ended with."""
    return bool(abs(start - numbers[tb.J_MOTION]) > SAME_MOTION * start)


def keep_part_of_way(
    first: int, last: int, share: float, base: Vector, time: float, bodies: Bodies, joints: Joints
) -> None:
    """Let the nodes of a mechanism keep a share of their way: it has no energy for the rest."""
    for node in range(first, last):
        motion = bodies.motion[joints.sparse[node, tb.N_BODY]]
        by_x, by_y = shift_seen((motion[tb.DX], motion[tb.DY]), base, time)
        motion[tb.DX], motion[tb.DY] = shift_later((share * by_x, share * by_y), base, time)
        motion[tb.DANGLE] *= share


def damp_mechanism(first: int, last: int, row: Array, bodies: Bodies, joints: Joints) -> None:
    """Damp the motion of the nodes of a mechanism; the row says how much energy it may keep."""
    root = joints.sparse[first, tb.N_BODY]
    begin_motion(0.0, row)
    for node in range(first, last):
        add_motion(joints.sparse[node, tb.N_BODY], root, bodies, row)
    find_rigid_motion(row)
    share, spin = row[tb.DAMPED_SHARE], row[tb.REFERENCE + 2]
    for node in range(first, last):
        i = joints.sparse[node, tb.N_BODY]
        now, place = bodies.motion[i], place_from(root, i, bodies)
        as_one = point_velocity((row[tb.REFERENCE], row[tb.REFERENCE + 1]), spin, place)
        now[tb.VX], now[tb.VY] = velocity_damped((now[tb.VX], now[tb.VY]), as_one, share)
        if can_be_turned(i, bodies.properties):
            now[tb.SPIN] = angular_velocity_damped(now[tb.SPIN], spin, share)


def add_motion(i: int, root: int, bodies: Bodies, row: Array) -> None:
    """Add mass, momenta and moments of a body, as they are now, to those of its mechanism."""
    mass, inertia = mass_and_inertia(i, bodies.properties)
    now, place = bodies.motion[i], place_from(root, i, bodies)
    velocity = (now[tb.VX], now[tb.VY])
    add_to_island(mass, inertia, place, velocity, now[tb.SPIN], row)
