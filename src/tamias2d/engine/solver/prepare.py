"""Constraints prepared as a step begins: manifolds into blocks, effective masses, and softness.

Source: Catto (2024), soft step; the softness under a load, and the preload, are DD28 to DD31.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joined_approach import joined_approach, judge_blow
from tamias2d.engine.tables import Bodies, Constraints, Contacts, Control, Integers
from tamias2d.generated.soft_contact import (
    angular_frequency_even,
    angular_frequency_loaded,
    bend,
    bias_rate,
    bias_velocity_least,
    impulse_share,
    mass_share,
    preload_later,
    row_mass,
    row_velocity,
    separation_later,
    slowest_impact,
    turning_arm,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.kernels.lanes import LANES, load_part
from tamias2d.state import Array

FIRMER = 2.0  # frequency of a contact with a body that does not move freely, to that of others
FIRMEST = 2.0  # frequency under load, to that without
DAMPING = 10.0  # of the spring, where 1 is critical
REST = 0.015  # of the smaller radius: overlap to which a load should lead
LEARNT = 0.02  # of the overlap, by the preload in a step
UNLEARNT = 0.5  # of a gap: much less lets heaps boil, as single loaded contacts open and close
PRELOADED = 0.2  # of the smaller radius: largest preload
FASTEST = 0.02  # of the smaller radius: how far an overlap is pushed apart in a substep, at most


def fill_blocks(
    first: int,
    last: int,
    control: Control,
    bodies: Bodies,
    contacts: Contacts,
    constraints: Constraints,
) -> None:
    """Write the manifolds of touching contacts to their blocks."""
    ratio, found = control.progress[tb.IMPULSE_RATIO], constraints.scratch
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        load_manifolds(lane, bodies, contacts, found)
        for m in range(LANES):
            row[tb.R_NX + m], row[tb.R_NY + m] = found[tb.F_NX + m], found[tb.F_NY + m]
        arm_lanes(tb.FIRST_POINT, tb.F_FIRST_POINT, row, found)
        impulse_lanes(tb.FIRST_POINT, tb.F_FIRST_POINT, ratio, row, found)
        if lane[tb.POINTS] == 2:
            arm_lanes(tb.SECOND_POINT, tb.F_SECOND_POINT, row, found)
            impulse_lanes(tb.SECOND_POINT, tb.F_SECOND_POINT, ratio, row, found)
        for m in range(lane[tb.FILLED]):
            finish_lane(m, lane, row, control, bodies, contacts, found)


@inlined
def load_manifolds(lane: Integers, bodies: Bodies, contacts: Contacts, found: Array) -> None:
    """Load the manifolds of a block, and where bodies are from each other; zeros where is none.

    A manifold that is foreseen is that of the poses in which bodies will be then.
    """
    manifolds, start = contacts.manifolds, tb.SUBSTEP_START
    load_part(lane, tb.LANE_CONTACT, manifolds, 0, found, tb.F_NX)
    if lane[tb.POINTS] == 2:
        load_part(lane, tb.LANE_CONTACT, manifolds, tb.POINT, found, tb.F_SECOND_POINT - 2 * LANES)
    for m in range(LANES):
        a, b = bodies.pose[lane[tb.BODY_A + m]], bodies.pose[lane[tb.BODY_B + m]]
        found[tb.F_SPAN_X + m], found[tb.F_SPAN_Y + m] = b[tb.X] - a[tb.X], b[tb.Y] - a[tb.Y]
    for m in range(lane[tb.FILLED]):
        ahead = manifolds[lane[tb.LANE_CONTACT + m], tb.FORESEEN]
        if ahead > 0.0:
            a, b = (
                bodies.substep_state[lane[tb.BODY_A + m]],
                bodies.substep_state[lane[tb.BODY_B + m]],
            )
            found[tb.F_SPAN_X + m] += ahead * (b[start] - a[start])
            found[tb.F_SPAN_Y + m] += ahead * (b[start + 1] - a[start + 1])
    for m in range(lane[tb.FILLED], LANES):
        for at in range(tb.F_NX + m, tb.F_SPAN_X, LANES):
            found[at] = 0.0


def arm_lanes(at: int, of: int, row: Array, found: Array) -> None:
    """Write the turning arms of points.

    Arms of a contact with a body that does not move freely end on the surfaces, whose points meet
    when the gap closes.
    """
    for m in range(LANES):
        normal = (row[tb.R_NX + m], row[tb.R_NY + m])
        x, y = found[of + tb.F_X + m], found[of + tb.F_Y + m]
        bound = (row[tb.R_MASS_A + m] == 0.0) | (row[tb.R_MASS_B + m] == 0.0)
        half = 0.5 * max(found[of + tb.F_GAP + m], 0.0) if bound else 0.0
        row[at + tb.P_NORMAL_ARM_A + m] = turning_arm((x, y), normal)
        row[at + tb.P_TANGENT_ARM_A + m] = bend((x, y), normal) - half
        x, y = x - found[tb.F_SPAN_X + m], y - found[tb.F_SPAN_Y + m]
        row[at + tb.P_NORMAL_ARM_B + m] = turning_arm((x, y), normal)
        row[at + tb.P_TANGENT_ARM_B + m] = bend((x, y), normal) + half


def impulse_lanes(at: int, of: int, ratio: float, row: Array, found: Array) -> None:
    """Write the gaps and the impulses of points, and learn the preloads."""
    for m in range(LANES):
        gap, normal = found[of + tb.F_GAP + m], found[of + tb.F_NORMAL_IMPULSE + m]
        most = PRELOADED * row[tb.R_SMALLER_RADIUS + m]
        before = found[of + tb.F_PRELOAD + m]
        learnt = preload_later(before, gap, LEARNT, UNLEARNT, row[tb.R_ALLOWED + m], most)
        preload = learnt if normal > 0.0 else 0.0
        found[of + tb.F_PRELOAD + m] = preload
        row[at + tb.P_GAP + m] = gap - preload
        row[at + tb.P_NORMAL_IMPULSE + m] = ratio * normal
        row[at + tb.P_TANGENT_IMPULSE + m] = ratio * found[of + tb.F_TANGENT_IMPULSE + m]
        row[at + tb.P_TOTAL_IMPULSE + m] = row[at + tb.P_TOTAL_FRICTION + m] = 0.0


@inlined
def finish_lane(
    m: int,
    lane: Integers,
    row: Array,
    control: Control,
    bodies: Bodies,
    contacts: Contacts,
    found: Array,
) -> None:
    """Keep the preloads of a contact; find its gaps if it is foreseen, and how fast it meets.

    What meets too slowly for an impact does not approach. What has bounced and parts starts
    without its impulses: friction would act by that of a blow that is over.
    """
    manifold, state = contacts.manifolds[lane[tb.LANE_CONTACT + m]], bodies.substep_state
    a, b, ahead = state[lane[tb.BODY_A + m]], state[lane[tb.BODY_B + m]], manifold[tb.FORESEEN]
    bounced = contacts.flags[lane[tb.LANE_CONTACT + m], tb.BOUNCED] > 0
    manifold[tb.PRELOAD] = found[tb.F_FIRST_POINT + tb.F_PRELOAD + m]
    if lane[tb.POINTS] == 2:
        manifold[tb.PRELOAD + tb.POINT] = found[tb.F_SECOND_POINT + tb.F_PRELOAD + m]
    for n in range(lane[tb.POINTS]):
        at = tb.SHARED + n * tb.POINT_SIZE + m
        if ahead > 0.0:
            row[at + tb.P_GAP] = gap_before(m, at, row, a, b, ahead)
        judge_blow(m, at, lane, row, control, bodies)
        if row[tb.R_RESTITUTION + m] > 0.0:
            speed = approach_velocity(m, at, row, a, b)
            pressing = 0.0 if bounced else row[at + tb.P_NORMAL_IMPULSE]
            slow = meets_slowly(m, at, speed, pressing, row, control)
            met = speed
            met = joined_approach(met, m, at, lane, row, control, bodies)
            row[at + tb.P_APPROACH] = 0.0 if slow else met
            if bounced and speed > 0.0:
                row[at + tb.P_NORMAL_IMPULSE] = row[at + tb.P_TANGENT_IMPULSE] = 0.0


def gap_before(m: int, at: int, row: Array, a: Array, b: Array, ahead: float) -> float:
    """Return the gap of a point that has a known one after a time, s, at these velocities."""
    start = tb.SUBSTEP_START
    closed = separation_later(
        0.0,
        (ahead * a[start], ahead * a[start + 1]),
        ahead * a[start + 2],
        row[at + tb.P_NORMAL_ARM_A],
        row[at + tb.P_TANGENT_ARM_A] - row[tb.R_RADIUS_A + m],
        (ahead * b[start], ahead * b[start + 1]),
        ahead * b[start + 2],
        row[at + tb.P_NORMAL_ARM_B],
        row[at + tb.P_TANGENT_ARM_B] + row[tb.R_RADIUS_B + m],
        (row[tb.R_NX + m], row[tb.R_NY + m]),
    )
    return float(row[at + tb.P_GAP] - closed)


@inlined
def approach_velocity(m: int, at: int, row: Array, a: Array, b: Array) -> float:
    """Return the normal velocity of a point before the step, m/s, from the states of its bodies."""
    return row_velocity(
        (a[tb.SUBSTEP_START], a[tb.SUBSTEP_START + 1]),
        a[tb.SUBSTEP_START + 2],
        row[at + tb.P_NORMAL_ARM_A],
        (b[tb.SUBSTEP_START], b[tb.SUBSTEP_START + 1]),
        b[tb.SUBSTEP_START + 2],
        row[at + tb.P_NORMAL_ARM_B],
        (row[tb.R_NX + m], row[tb.R_NY + m]),
    )


@inlined
def meets_slowly(
    m: int, at: int, speed: float, pressing: float, row: Array, control: Control
) -> bool:
    """Return whether a point approaches no faster than what presses it makes it (DD93)."""
    arm_a, arm_b = row[at + tb.P_NORMAL_ARM_A], row[at + tb.P_NORMAL_ARM_B]
    mass = row_mass(
        row[tb.R_MASS_A + m], row[tb.R_INERTIA_A + m], arm_a,
        row[tb.R_MASS_B + m], row[tb.R_INERTIA_B + m], arm_b,
    )  # fmt: skip
    slowest = slowest_impact(
        (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y]),
        pressing,
        mass,
        control.counts[tb.PART_SUBSTEPS],
        control.progress[tb.PART_TIME],
    )
    return bool(speed >= -slowest)


def prepare_blocks(first: int, last: int, substep: float, blocks: Array, lanes: Integers) -> None:
    """Write the effective masses and the softness of some blocks."""
    for b in range(first, last):
        row = blocks[b]
        effective_mass_lanes(tb.FIRST_POINT, row)
        if lanes[b, tb.POINTS] == 2:
            effective_mass_lanes(tb.SECOND_POINT, row)
        soften_lanes(row, lanes[b, tb.POINTS], substep)


def effective_mass_lanes(at: int, row: Array) -> None:
    """Write the effective masses along normal and tangent; 0 in an idle lane."""
    for m in range(LANES):
        a, b = row[tb.R_MASS_A + m], row[tb.R_MASS_B + m]
        turn_a, turn_b = row[tb.R_INERTIA_A + m], row[tb.R_INERTIA_B + m]
        idle = a + b == 0.0
        b = 1.0 if idle else b
        normal_a, normal_b = row[at + tb.P_NORMAL_ARM_A + m], row[at + tb.P_NORMAL_ARM_B + m]
        normal = row_mass(a, turn_a, normal_a, b, turn_b, normal_b)
        tangent_a, tangent_b = row[at + tb.P_TANGENT_ARM_A + m], row[at + tb.P_TANGENT_ARM_B + m]
        tangent = row_mass(a, turn_a, tangent_a, b, turn_b, tangent_b)
        row[at + tb.P_NORMAL_MASS + m] = 0.0 if idle else normal
        row[at + tb.P_TANGENT_MASS + m] = 0.0 if idle else tangent


def soften_lanes(row: Array, points: int, substep: float) -> None:
    """Write the softness of contacts: so soft that their loads press them in by `REST`.

    The load is the normal impulse of a point in the last substep, N s. Contacts firmer than
    `FIRMEST` allows would feed the waves of a wide pile (DD76).
    """
    each = 1.0 / points  # 1 or a half: the product is exact
    even = angular_frequency_even(substep)
    for m in range(LANES):
        a, b = row[tb.R_MASS_A + m], row[tb.R_MASS_B + m]
        second = row[tb.SECOND_POINT + tb.P_NORMAL_IMPULSE + m] if points == 2 else 0.0
        load = (row[tb.FIRST_POINT + tb.P_NORMAL_IMPULSE + m] + second) * each
        frequency = even if (a > 0.0) & (b > 0.0) else FIRMER * even
        radius = row[tb.R_SMALLER_RADIUS + m] if row[tb.R_SMALLER_RADIUS + m] > 0.0 else 1.0
        frequency = angular_frequency_loaded(frequency, load, a, b, substep, REST, radius, FIRMEST)
        row[tb.R_BIAS_RATE + m] = bias_rate(frequency, DAMPING, substep)
        row[tb.R_MASS_SHARE + m] = mass_share(frequency, DAMPING, substep)
        row[tb.R_IMPULSE_SHARE + m] = impulse_share(frequency, DAMPING, substep)
        row[tb.R_BIAS_LEAST + m] = bias_velocity_least(FASTEST, radius, substep)
