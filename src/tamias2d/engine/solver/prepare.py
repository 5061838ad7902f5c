"""Constraints prepared as a step begins: manifolds into blocks, effective masses, and softness.

Source: Catto (2024), soft step; the softness under a load, and the preload, are DD28 to DD31.
"""

from tamias2d.engine.solver.blocks import lane_of, points_of
from tamias2d.engine.tables import (
    FIRST_POINT,
    FORESEEN,
    GAP,
    IMPULSE_RATIO,
    NORMAL_IMPULSE,
    NX,
    NY,
    P_APPROACH,
    P_GAP,
    P_NORMAL_ARM_A,
    P_NORMAL_ARM_B,
    P_NORMAL_IMPULSE,
    P_NORMAL_MASS,
    P_TANGENT_ARM_A,
    P_TANGENT_ARM_B,
    P_TANGENT_IMPULSE,
    P_TANGENT_MASS,
    P_TOTAL_IMPULSE,
    POINT,
    POINT_SIZE,
    POINTS,
    PRELOAD,
    PX,
    PY,
    R_ALLOWED,
    R_BIAS_LEAST,
    R_BIAS_RATE,
    R_IMPULSE_SHARE,
    R_INERTIA_A,
    R_INERTIA_B,
    R_MASS_A,
    R_MASS_B,
    R_MASS_SHARE,
    R_NX,
    R_NY,
    R_RADIUS_A,
    R_RADIUS_B,
    R_RESTITUTION,
    R_SMALLER_RADIUS,
    SECOND_POINT,
    SHARED,
    SUBSTEP_START,
    TANGENT_IMPULSE,
    Bodies,
    Constraints,
    Contacts,
    Control,
    Integers,
    Touching,
    X,
    Y,
)
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
    turning_arm,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array, Vector

FIRMER = 2.0  # frequency of a contact with a body that does not move freely, to that of others
FIRMEST = 2.0  # frequency under load, to that without
DAMPING = 10.0  # of the spring, where 1 is critical
REST = 0.015  # of the smaller radius: overlap to which a load should lead
LEARNT = 0.02  # of the overlap, by the preload in a step
PRELOADED = 0.2  # of the smaller radius: largest preload
FASTEST = 0.02  # of the smaller radius: how far an overlap is pushed apart in a substep, at most


def fill_blocks(
    first: int,
    last: int,
    control: Control,
    bodies: Bodies,
    contacts: Contacts,
    touching: Touching,
    constraints: Constraints,
) -> None:
    """Write the manifolds of touching contacts, which are listed by slabs."""
    ratio = control.progress[IMPULSE_RATIO]
    for place in range(first, last):
        k = touching.by_slab[place]
        i, j = touching.body_a[k], touching.body_b[k]
        b, m = lane_of(k, touching)
        row, manifold = constraints.blocks[b], contacts.manifolds[touching.contact[k]]
        row[R_NX + m], row[R_NY + m] = manifold[NX], manifold[NY]
        delta = (bodies.pose[j, X] - bodies.pose[i, X], bodies.pose[j, Y] - bodies.pose[i, Y])
        ahead = manifold[FORESEEN]
        if ahead > 0.0:
            delta = span_ahead(delta, bodies.substep_state[i], bodies.substep_state[j], ahead)
        for n in range(points_of(k, touching)):
            at = SHARED + n * POINT_SIZE + m
            fill_arms(m, n, delta, manifold, row)
            fill_impulses(m, n, ratio, manifold, row)
            if ahead > 0.0:
                row[at + P_GAP] = gap_before(
                    m, at, row, bodies.substep_state[i], bodies.substep_state[j], ahead
                )
            if row[R_RESTITUTION + m] > 0.0:
                row[at + P_APPROACH] = approach_velocity(
                    m, at, row, bodies.substep_state[i], bodies.substep_state[j]
                )


def span_ahead(delta: Vector, a: Array, b: Array, ahead: float) -> Vector:
    """Return what leads from the centre of A to that of B after a time, s, at their velocities."""
    start = SUBSTEP_START
    return (
        delta[0] + ahead * (b[start] - a[start]),
        delta[1] + ahead * (b[start + 1] - a[start + 1]),
    )


def gap_before(m: int, at: int, row: Array, a: Array, b: Array, ahead: float) -> float:
    """Return the gap of a point that has a known one after a time, s, at these velocities."""
    start = SUBSTEP_START
    closed = separation_later(
        0.0,
        (ahead * a[start], ahead * a[start + 1]),
        ahead * a[start + 2],
        row[at + P_NORMAL_ARM_A],
        row[at + P_TANGENT_ARM_A] - row[R_RADIUS_A + m],
        (ahead * b[start], ahead * b[start + 1]),
        ahead * b[start + 2],
        row[at + P_NORMAL_ARM_B],
        row[at + P_TANGENT_ARM_B] + row[R_RADIUS_B + m],
        (row[R_NX + m], row[R_NY + m]),
    )
    return float(row[at + P_GAP] - closed)


@inlined
def fill_arms(m: int, n: int, delta: Vector, manifold: Array, row: Array) -> None:
    """Write the turning arms of a point; `delta` goes from the centre of A to that of B, m.

    Arms of a contact with a body that does not move freely end on the surfaces, whose points meet
    when the gap closes.
    """
    at, normal = SHARED + n * POINT_SIZE + m, (manifold[NX], manifold[NY])
    x, y = manifold[PX + POINT * n], manifold[PY + POINT * n]
    normal_a, tangent_a = turning_arm((x, y), normal), bend((x, y), normal)
    x, y = x - delta[0], y - delta[1]
    normal_b, tangent_b = turning_arm((x, y), normal), bend((x, y), normal)
    if row[R_MASS_A + m] == 0.0 or row[R_MASS_B + m] == 0.0:
        half = 0.5 * max(manifold[GAP + POINT * n], 0.0)
        tangent_a, tangent_b = tangent_a - half, tangent_b + half
    row[at + P_NORMAL_ARM_A], row[at + P_TANGENT_ARM_A] = normal_a, tangent_a
    row[at + P_NORMAL_ARM_B], row[at + P_TANGENT_ARM_B] = normal_b, tangent_b


@inlined
def fill_impulses(m: int, n: int, ratio: float, manifold: Array, row: Array) -> None:
    """Write the gap and the impulses of a point, and learn the preload."""
    at, to, radius = SHARED + n * POINT_SIZE + m, POINT * n, row[R_SMALLER_RADIUS + m]
    gap, preload = manifold[GAP + to], 0.0
    if manifold[NORMAL_IMPULSE + to] > 0.0:
        before = manifold[PRELOAD + to]
        allowed = row[R_ALLOWED + m]
        preload = preload_later(before, gap, LEARNT, allowed, PRELOADED * radius)
    manifold[PRELOAD + to] = preload
    row[at + P_GAP] = gap - preload
    row[at + P_NORMAL_IMPULSE] = ratio * manifold[NORMAL_IMPULSE + to]
    row[at + P_TANGENT_IMPULSE] = ratio * manifold[TANGENT_IMPULSE + to]
    row[at + P_TOTAL_IMPULSE] = 0.0


@inlined
def approach_velocity(m: int, at: int, row: Array, a: Array, b: Array) -> float:
    """Return the normal velocity of a point before the step, m/s, from the states of its bodies."""
    return row_velocity(
        (a[SUBSTEP_START], a[SUBSTEP_START + 1]),
        a[SUBSTEP_START + 2],
        row[at + P_NORMAL_ARM_A],
        (b[SUBSTEP_START], b[SUBSTEP_START + 1]),
        b[SUBSTEP_START + 2],
        row[at + P_NORMAL_ARM_B],
        (row[R_NX + m], row[R_NY + m]),
    )


def prepare_blocks(first: int, last: int, substep: float, blocks: Array, lanes: Integers) -> None:
    """Write the effective masses and the softness of some blocks."""
    for b in range(first, last):
        row = blocks[b]
        soften_lanes(row, lanes[b, POINTS], substep)
        effective_mass_lanes(FIRST_POINT, row)
        if lanes[b, POINTS] == 2:
            effective_mass_lanes(SECOND_POINT, row)


def effective_mass_lanes(at: int, row: Array) -> None:
    """Write the effective masses along normal and tangent; 0 in an idle lane."""
    for m in range(LANES):
        a, b = row[R_MASS_A + m], row[R_MASS_B + m]
        turn_a, turn_b = row[R_INERTIA_A + m], row[R_INERTIA_B + m]
        idle = a + b == 0.0
        b = 1.0 if idle else b
        normal_a, normal_b = row[at + P_NORMAL_ARM_A + m], row[at + P_NORMAL_ARM_B + m]
        normal = row_mass(a, turn_a, normal_a, b, turn_b, normal_b)
        tangent_a, tangent_b = row[at + P_TANGENT_ARM_A + m], row[at + P_TANGENT_ARM_B + m]
        tangent = row_mass(a, turn_a, tangent_a, b, turn_b, tangent_b)
        row[at + P_NORMAL_MASS + m] = 0.0 if idle else normal
        row[at + P_TANGENT_MASS + m] = 0.0 if idle else tangent


def soften_lanes(row: Array, points: int, substep: float) -> None:
    """Write the softness of contacts: so soft that their loads press them in by `REST`.

    The load is the normal impulse of a point in the last substep, N s. Contacts firmer than
    `FIRMEST` allows would feed the waves of a wide pile (DD76).
    """
    each = 1.0 / points  # 1 or a half: the product is exact
    even = angular_frequency_even(substep)
    for m in range(LANES):
        a, b = row[R_MASS_A + m], row[R_MASS_B + m]
        second = row[SECOND_POINT + P_NORMAL_IMPULSE + m] if points == 2 else 0.0
        load = (row[FIRST_POINT + P_NORMAL_IMPULSE + m] + second) * each
        frequency = even if (a > 0.0) & (b > 0.0) else FIRMER * even
        radius = row[R_SMALLER_RADIUS + m] if row[R_SMALLER_RADIUS + m] > 0.0 else 1.0
        frequency = angular_frequency_loaded(frequency, load, a, b, substep, REST, radius, FIRMEST)
        row[R_BIAS_RATE + m] = bias_rate(frequency, DAMPING, substep)
        row[R_MASS_SHARE + m] = mass_share(frequency, DAMPING, substep)
        row[R_IMPULSE_SHARE + m] = impulse_share(frequency, DAMPING, substep)
        row[R_BIAS_LEAST + m] = bias_velocity_least(FASTEST, radius, substep)
