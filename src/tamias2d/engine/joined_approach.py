"""How fast the contacts of mechanisms meet, or part: they have no impacts in flight (DD102)."""

from tamias2d.engine import tables as tb
from tamias2d.engine.joined import is_held
from tamias2d.engine.tables import Bodies, Control, Integers
from tamias2d.generated.definitions import coordinate_velocity_later
from tamias2d.generated.joint_step import blow_velocity, impact_rate
from tamias2d.generated.soft_contact import impact_velocity, row_acceleration, row_velocity
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector

BLOW_IS_OVER = 0.1  # of the velocity that an impulse gives: what parts faster


def joined_approach(
    speed: float, m: int, at: int, lane: Integers, row: Array, control: Control, bodies: Bodies
) -> float:
    """Return the normal velocity with which a point meets that approaches at a speed, m/s."""
    i, j = lane[tb.BODY_A + m], lane[tb.BODY_B + m]
    if not (is_held(i, bodies) or is_held(j, bodies)):
        return speed
    a, b = bodies.substep_state[i], bodies.substep_state[j]
    driven = row_velocity(
        driven_velocity(a),
        driven_spin(a),
        row[at + tb.P_NORMAL_ARM_A],
        driven_velocity(b),
        driven_spin(b),
        row[at + tb.P_NORMAL_ARM_B],
        (row[tb.R_NX + m], row[tb.R_NY + m]),
    )
    by = row_acceleration(speed, driven, control.settings[tb.SUBSTEP])
    return impact_velocity(speed, by, row[at + tb.P_GAP])


def judge_blow(
    m: int, at: int, lane: Integers, row: Array, control: Control, bodies: Bodies
) -> None:
    """Let a point of a mechanism start without impulses that parts faster than loads give it.

    The impulse of a blow that is over would set the links of a mechanism in motion, which its
    joints and contacts do not take back by one visit each. It is noted if one closes so fast.
    """
    i, j = lane[tb.BODY_A + m], lane[tb.BODY_B + m]
    if not (is_held(i, bodies) or is_held(j, bodies)):
        return
    a, b = bodies.substep_state[i], bodies.substep_state[j]
    start = tb.SUBSTEP_START
    speed = row_velocity(
        (a[start], a[start + 1]), a[start + 2], row[at + tb.P_NORMAL_ARM_A],
        (b[start], b[start + 1]), b[start + 2], row[at + tb.P_NORMAL_ARM_B],
        (row[tb.R_NX + m], row[tb.R_NY + m]),
    )  # fmt: skip
    by_loads = gain_by_loads(i, j, control, bodies)
    given = blow_velocity(row[at + tb.P_NORMAL_IMPULSE], row[tb.R_MASS_A + m], row[tb.R_MASS_B + m])
    if speed > max(BLOW_IS_OVER * given, by_loads):
        row[at + tb.P_NORMAL_IMPULSE] = row[at + tb.P_TANGENT_IMPULSE] = 0.0
    if impact_rate(speed, row[at + tb.P_GAP], control.progress[tb.PART_TIME]) < -by_loads:
        control.counts[tb.IMPACTS] = 1


@inlined
def gain_by_loads(i: int, j: int, control: Control, bodies: Bodies) -> float:
    """Return the most that loads change the velocity between two bodies in a part, m/s."""
    a, b, gain = bodies.substep_state[i], bodies.substep_state[j], tb.INCREMENT
    loads = abs(a[gain]) + abs(a[gain + 1]) + abs(b[gain]) + abs(b[gain + 1])
    return float(control.counts[tb.PART_SUBSTEPS] * loads)


@inlined
def driven_velocity(state: Array) -> Vector:
    """Return the velocity of a body after a substep in which forces alone act, m/s."""
    return (
        coordinate_velocity_later(
            state[tb.DRAG_FACTOR], state[tb.SUBSTEP_START], state[tb.INCREMENT]
        ),
        coordinate_velocity_later(
            state[tb.DRAG_FACTOR + 1], state[tb.SUBSTEP_START + 1], state[tb.INCREMENT + 1]
        ),
    )


@inlined
def driven_spin(state: Array) -> float:
    """Return the spin of a body then, rad/s."""
    return coordinate_velocity_later(
        state[tb.DRAG_FACTOR + 2], state[tb.SUBSTEP_START + 2], state[tb.INCREMENT + 2]
    )
