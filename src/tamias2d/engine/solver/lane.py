"""One contact in its lane: what a stage of the soft step does to it.

Without branches that depend on numbers, so that loops over lanes take several in one instruction.
Source: Catto (2024), soft step.
"""

from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.generated.soft_contact import (
    angular_velocity_a_after,
    angular_velocity_b_after,
    bias_velocity,
    bias_velocity_later,
    limited_tangent_impulse,
    restitution_impulse,
    row_velocity,
    separation_later,
    soft_normal_impulse,
    surface_slip,
    velocity_a_after,
    velocity_b_after,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector

SETTLED_RESTITUTION = 2.0**-40  # of its impulses: a change that does not count


class Velocities(NamedTuple):
    """Those of both bodies of a lane."""

    a: Vector  # m/s
    spin_a: float  # rad/s
    b: Vector
    spin_b: float


@inlined
def velocities_of(m: int, scratch: Array) -> Velocities:
    """Return the velocities of the bodies of a lane."""
    return Velocities(
        (scratch[tb.B_VX_A + m], scratch[tb.B_VY_A + m]),
        scratch[tb.B_SPIN_A + m],
        (scratch[tb.B_VX_B + m], scratch[tb.B_VY_B + m]),
        scratch[tb.B_SPIN_B + m],
    )


@inlined
def set_velocities(m: int, now: Velocities, scratch: Array) -> None:
    """Set the velocities of the bodies of a lane."""
    scratch[tb.B_VX_A + m], scratch[tb.B_VY_A + m] = now.a
    scratch[tb.B_SPIN_A + m] = now.spin_a
    scratch[tb.B_VX_B + m], scratch[tb.B_VY_B + m] = now.b
    scratch[tb.B_SPIN_B + m] = now.spin_b


@inlined
def pushed(
    m: int, amount: float, line: Vector, arm_a: float, arm_b: float, now: Velocities, row: Array
) -> Velocities:
    """Return velocities after an impulse, N s, along a line; turning arms in m."""
    return Velocities(
        velocity_a_after(now.a, amount, line, row[tb.R_MASS_A + m]),
        angular_velocity_a_after(now.spin_a, amount, arm_a, row[tb.R_INERTIA_A + m]),
        velocity_b_after(now.b, amount, line, row[tb.R_MASS_B + m]),
        angular_velocity_b_after(now.spin_b, amount, arm_b, row[tb.R_INERTIA_B + m]),
    )


@inlined
def pushed_apart(m: int, at: int, amount: float, now: Velocities, row: Array) -> Velocities:
    """Return velocities after an impulse, N s, along the normal of a point."""
    line = (row[tb.R_NX + m], row[tb.R_NY + m])
    arm_a, arm_b = row[at + tb.P_NORMAL_ARM_A + m], row[at + tb.P_NORMAL_ARM_B + m]
    return pushed(m, amount, line, arm_a, arm_b, now, row)


@inlined
def pushed_along(m: int, at: int, amount: float, now: Velocities, row: Array) -> Velocities:
    """Return velocities after an impulse, N s, along the tangent of a point."""
    line = (-row[tb.R_NY + m], row[tb.R_NX + m])
    arm_a, arm_b = row[at + tb.P_TANGENT_ARM_A + m], row[at + tb.P_TANGENT_ARM_B + m]
    return pushed(m, amount, line, arm_a, arm_b, now, row)


@inlined
def normal_speed(m: int, at: int, now: Velocities, row: Array) -> float:
    """Return the normal velocity of a point, m/s, at which its gap opens."""
    arm_a, arm_b = row[at + tb.P_NORMAL_ARM_A + m], row[at + tb.P_NORMAL_ARM_B + m]
    line = (row[tb.R_NX + m], row[tb.R_NY + m])
    return row_velocity(now.a, now.spin_a, arm_a, now.b, now.spin_b, arm_b, line)


def velocities_of_one(motion: Array, is_a: bool) -> Velocities:
    """Return the velocities at a contact if only one of its bodies, A or B, moved."""
    of_a = 1.0 if is_a else 0.0
    of_b = 1.0 - of_a
    return Velocities(
        (of_a * motion[tb.VX], of_a * motion[tb.VY]),
        of_a * motion[tb.SPIN],
        (of_b * motion[tb.VX], of_b * motion[tb.VY]),
        of_b * motion[tb.SPIN],
    )


@inlined
def slip_at(m: int, at: int, now: Velocities, row: Array) -> float:
    """Return at which speed the surfaces slip at a point, m/s (DD97)."""
    arm_a, arm_b = row[at + tb.P_TANGENT_ARM_A + m], row[at + tb.P_TANGENT_ARM_B + m]
    line = (-row[tb.R_NY + m], row[tb.R_NX + m])
    speed = row_velocity(now.a, now.spin_a, arm_a, now.b, now.spin_b, arm_b, line)
    return surface_slip(speed, row[tb.R_SURFACE_SPEED + m])


@inlined
def friction_impulse(m: int, at: int, now: Velocities, row: Array) -> float:
    """Return the tangent impulse of a point, N s, within what friction allows."""
    return limited_tangent_impulse(
        row[at + tb.P_TANGENT_IMPULSE + m],
        slip_at(m, at, now, row),
        row[at + tb.P_TANGENT_MASS + m],
        row[tb.R_FRICTION + m],
        row[at + tb.P_NORMAL_IMPULSE + m],
    )


@inlined
def after_friction(m: int, at: int, now: Velocities, row: Array) -> Velocities:
    """Correct the tangent impulse of a point; return the velocities after it."""
    before = row[at + tb.P_TANGENT_IMPULSE + m]
    after = friction_impulse(m, at, now, row)
    row[at + tb.P_TANGENT_IMPULSE + m] = after
    return pushed_along(m, at, after - before, now, row)


@inlined
def after_last_friction(m: int, at: int, now: Velocities, row: Array, share: float) -> Velocities:
    """Correct the tangent impulse likewise, and count a share of it, as in `after_relaxing`."""
    then = after_friction(m, at, now, row)
    counted = share * row[at + tb.P_TANGENT_IMPULSE + m]
    row[at + tb.P_TOTAL_FRICTION + m] = row[at + tb.P_TOTAL_FRICTION + m] + counted
    return then


@inlined
def gap_in_substep(m: int, at: int, row: Array, scratch: Array) -> float:
    """Return the gap of a point, m, where bodies are in this substep."""
    return separation_later(
        row[at + tb.P_GAP + m],
        (scratch[tb.B_DX_A + m], scratch[tb.B_DY_A + m]),
        scratch[tb.B_ANGLE_A + m],
        row[at + tb.P_NORMAL_ARM_A + m],
        row[at + tb.P_TANGENT_ARM_A + m] - row[tb.R_RADIUS_A + m],
        (scratch[tb.B_DX_B + m], scratch[tb.B_DY_B + m]),
        scratch[tb.B_ANGLE_B + m],
        row[at + tb.P_NORMAL_ARM_B + m],
        row[at + tb.P_TANGENT_ARM_B + m] + row[tb.R_RADIUS_B + m],
        (row[tb.R_NX + m], row[tb.R_NY + m]),
    )


@inlined
def after_soft(
    m: int, at: int, now: Velocities, row: Array, scratch: Array, substep: float
) -> Velocities:
    """Correct the normal impulse of a soft constraint; the substep in s."""
    gap = gap_in_substep(m, at, row, scratch)
    row[at + tb.P_GAP_NOW + m] = gap
    bias = bias_velocity(gap, row[tb.R_BIAS_RATE + m], row[tb.R_BIAS_LEAST + m], substep)
    is_open = gap > 0.0
    mass_share = 1.0 if is_open else row[tb.R_MASS_SHARE + m]
    impulse_share = 0.0 if is_open else row[tb.R_IMPULSE_SHARE + m]
    before, speed = row[at + tb.P_NORMAL_IMPULSE + m], normal_speed(m, at, now, row)
    mass = row[at + tb.P_NORMAL_MASS + m]
    after = soft_normal_impulse(before, speed, bias, mass, mass_share, impulse_share)
    row[at + tb.P_NORMAL_IMPULSE + m] = after
    return pushed_apart(m, at, after - before, now, row)


@inlined
def after_relaxing(
    m: int, at: int, now: Velocities, row: Array, substep: float, share: float
) -> Velocities:
    """Correct the normal impulse so that a point approaches by no more than its gap.

    A share of it is counted: 1 where it is what a substep leaves, 0 elsewhere.
    """
    speed = normal_speed(m, at, now, row)
    bias = bias_velocity_later(row[at + tb.P_GAP_NOW + m], speed, substep)
    before = row[at + tb.P_NORMAL_IMPULSE + m]
    after = soft_normal_impulse(before, speed, bias, row[at + tb.P_NORMAL_MASS + m], 1.0, 0.0)
    row[at + tb.P_NORMAL_IMPULSE + m] = after
    row[at + tb.P_TOTAL_IMPULSE + m] = row[at + tb.P_TOTAL_IMPULSE + m] + share * after
    return pushed_apart(m, at, after - before, now, row)


@inlined
def warm_started(m: int, at: int, now: Velocities, row: Array) -> Velocities:
    """Return velocities after the impulses of the last substep at a point."""
    apart = pushed_apart(m, at, row[at + tb.P_NORMAL_IMPULSE + m], now, row)
    return pushed_along(m, at, row[at + tb.P_TANGENT_IMPULSE + m], apart, row)


@inlined
def soften(
    m: int, points: int, now: Velocities, row: Array, scratch: Array, substep: float
) -> Velocities:
    """Correct the impulses of a contact with one or two points; return velocities after it.

    Friction comes last: that of an impact, which the impulses of before hold, ends with its normal
    impulse, before bodies are moved by it.
    """
    then = after_soft(m, tb.FIRST_POINT, now, row, scratch, substep)
    if points == 2:
        then = after_soft(m, tb.SECOND_POINT, then, row, scratch, substep)
    then = after_friction(m, tb.FIRST_POINT, then, row)
    if points == 2:
        then = after_friction(m, tb.SECOND_POINT, then, row)
    return then


@inlined
def relaxed(
    m: int, points: int, now: Velocities, row: Array, substep: float, share: float
) -> Velocities:
    """Relax a contact with one or two points; return velocities after it.

    Friction comes last: its bound is the impulse that is left, not one that removed overlap.
    """
    then = after_relaxing(m, tb.FIRST_POINT, now, row, substep, share)
    if points == 2:
        then = after_relaxing(m, tb.SECOND_POINT, then, row, substep, share)
    then = after_last_friction(m, tb.FIRST_POINT, then, row, share)
    if points == 2:
        then = after_last_friction(m, tb.SECOND_POINT, then, row, share)
    return then


@inlined
def after_restitution(
    m: int, at: int, bounce: int, now: Velocities, row: Array, scratch: Array
) -> Velocities:
    """Let a point rebound that met and has an impulse.

    The impulses that it is given are added up in the column `bounce`.
    """
    before = row[at + tb.P_NORMAL_IMPULSE + m]
    meets = (
        (row[at + tb.P_APPROACH + m] < 0.0)
        & (row[at + tb.P_TOTAL_IMPULSE + m] > 0.0)
        & (row[tb.R_RESTITUTION + m] > 0.0)
    )
    bounced = restitution_impulse(
        before,
        normal_speed(m, at, now, row),
        row[at + tb.P_APPROACH + m],
        row[tb.R_RESTITUTION + m],
        row[at + tb.P_NORMAL_MASS + m],
    )
    after = bounced if meets else before
    row[at + tb.P_NORMAL_IMPULSE + m] = after
    row[bounce + m] += after - before
    least = SETTLED_RESTITUTION * abs(row[bounce + m])
    scratch[tb.B_UNSETTLED + m] = abs(after - before) - least
    row[at + tb.P_TOTAL_IMPULSE + m] = row[at + tb.P_TOTAL_IMPULSE + m] + (after - before)
    return pushed_apart(m, at, after - before, now, row)


@inlined
def after_bounced_friction(m: int, at: int, bounce: int, now: Velocities, row: Array) -> Velocities:
    """Correct the tangent impulse of a point that has bounced."""
    before, limited = row[at + tb.P_TANGENT_IMPULSE + m], friction_impulse(m, at, now, row)
    bounced = (row[bounce + m] > 0.0) & (row[at + tb.P_NORMAL_IMPULSE + m] > 0.0)
    after = limited if bounced else before
    row[at + tb.P_TANGENT_IMPULSE + m] = after
    row[at + tb.P_TOTAL_FRICTION + m] = row[at + tb.P_TOTAL_FRICTION + m] + (after - before)
    row[bounce + tb.TO_REBOUND_DRAG + m] += after - before
    return pushed_along(m, at, after - before, now, row)
