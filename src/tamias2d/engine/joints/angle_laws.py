"""Laws of the angles of hinges in a tree: they turn two bodies, and move none (DD57, IM15).

Rows of other joints do the same with slopes for places, too, which are zero here.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.hinged_yield import yield_at_hinge
from tamias2d.engine.joints.linearise import firmness_by_law, spring_now
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.hinge_tree import law_impulse
from tamias2d.generated.joint_rows import angle_values
from tamias2d.generated.joint_step import (
    angular_momentum_later,
    angular_velocity_later,
    coupled_inertia,
    drive_error,
    row_error,
    row_impulse,
    row_rate,
    row_yield,
    spring_error,
)
from tamias2d.kernels.assembled import inlined

TURNING = tb.J_ROW + 3  # turning slope at A; that at B is three numbers on


@inlined
def is_law(j: int, joints: Joints) -> bool:
    """Return whether a joint besides the hinges of a tree ties two of its bodies."""
    return bool(joints.joints[j, tb.J_NODE] >= 0 and joints.joints[j, tb.J_NODE + 1] >= 0)


@inlined
def hung_by_law(j: int, joints: Joints) -> tuple[int, float]:
    """Return which body hangs on the hinge whose angle a law governs, and its turning slope."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    one, other = ends[tb.J_MEMBER], ends[tb.J_MEMBER + 1]
    if joints.members[other, tb.JOINED_ABOVE] == one:
        return other, numbers[TURNING + 3]
    return one, numbers[TURNING]


def add_law(j: int, root: int, substep: float, joints: Joints) -> None:
    """Find how firm a law is; add it to the firmness of the hinge whose angle it governs."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    yielding = 0.0
    for end in range(2):
        inverse = joints.places[ends[tb.J_MEMBER + end], tb.HELD_INVERSE_INERTIA]
        if inverse == 0.0:
            numbers[TURNING + 3 * end] = 0.0
        yielding += row_yield((0.0, 0.0), numbers[TURNING + 3 * end], 0.0, inverse)
    m, turning = hung_by_law(j, joints)
    above = joints.members[m, tb.JOINED_ABOVE]
    held, held_above = (
        joints.places[m, tb.HELD_INVERSE_INERTIA],
        joints.places[above, tb.HELD_INVERSE_INERTIA],
    )
    far = numbers[TURNING] if ends[tb.J_MEMBER] == above else numbers[TURNING + 3]
    spin = angular_velocity_later(0.0, 1.0, turning, held)
    spins = (spin, angular_velocity_later(0.0, 1.0, far, held_above))
    hinged = yield_at_hinge(m, root, yielding, (0.0, 0.0), spins, joints)
    firm = firmness_by_law(yielding, hinged, numbers[tb.J_FIRMEST], j, substep, joints)
    numbers[tb.J_FIRMNESS] = firm
    joints.hinges[m, tb.H_FIRM] += coupled_inertia(turning, turning, firm)


def error_of_law(j: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Write the rate that an angle has too much, whose bodies are placed, rad/s."""
    ends, numbers, law = joints.joints[j], joints.numbers[j], joints.laws[j]
    place_a, place_b = joints.places[ends[tb.J_MEMBER]], joints.places[ends[tb.J_MEMBER + 1]]
    angle_values(joints.given[j], place_a, place_b, numbers)
    angle, firm, error = numbers[tb.J_ROW], numbers[tb.J_FIRMNESS], 0.0
    if ends[tb.J_LAW] < tb.MOTOR:
        error = row_error(angle, numbers[tb.J_AIM], substep)
    elif ends[tb.J_LAW] == tb.MOTOR:
        error = drive_error(rate_of_law(j, bodies, joints), law[tb.LAW_RATE])
    elif firm > 0.0:
        rate, given = rate_of_law(j, bodies, joints), numbers[tb.J_GIVEN]
        start, share = numbers[tb.J_AIM], numbers[tb.J_SHARE]
        stiffness, damping = spring_now(j, joints)
        error = spring_error(angle, start, rate, given, stiffness, damping, share, firm, substep)
    numbers[tb.J_ERROR] = error


@inlined
def rate_of_law(j: int, bodies: Bodies, joints: Joints) -> float:
    """Return the rate of the angle that a law governs, rad/s."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    rate = 0.0
    for end in range(2):
        i = joints.members[ends[tb.J_MEMBER + end], tb.JOINED_SLOT]
        turning, spin = numbers[TURNING + 3 * end], bodies.motion[i, tb.SPIN]
        rate += row_rate((0.0, 0.0), turning, (0.0, 0.0), spin)
    return rate


def add_law_bias(j: int, joints: Joints) -> None:
    """Note what the error of a law asks for about the hinge whose angle it governs."""
    m, turning = hung_by_law(j, joints)
    numbers = joints.numbers[j]
    joints.hinges[m, tb.H_LAW] += law_impulse(numbers[tb.J_FIRMNESS], turning * numbers[tb.J_ERROR])


def impulse_of_law(j: int, joints: Joints) -> float:
    """Return the angular impulse of a law, N m s."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    rate = numbers[tb.J_ERROR]
    for end in range(2):
        turning = numbers[TURNING + 3 * end]
        spin = joints.hinges[ends[tb.J_MEMBER + end], tb.H_CHANGE + 2]
        rate += row_rate((0.0, 0.0), turning, (0.0, 0.0), spin)
    return row_impulse(rate, numbers[tb.J_FIRMNESS])


def turn_by_law(j: int, impulse: float, bodies: Bodies, joints: Joints) -> None:
    """Give the bodies of a law its angular impulse; else as `apply_joint_impulse`."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    numbers[tb.J_PULL] += impulse
    numbers[tb.J_GIVEN] += impulse
    for end in range(2):
        m, turning, to = (
            ends[tb.J_MEMBER + end],
            numbers[TURNING + 3 * end],
            tb.J_TOTAL + 2 + 3 * end,
        )
        numbers[to] = angular_momentum_later(numbers[to], impulse, turning)
        held, i = joints.places[m, tb.HELD_INVERSE_INERTIA], joints.members[m, tb.JOINED_SLOT]
        turn = angular_velocity_later(0.0, impulse, turning, held)
        bodies.motion[i, tb.SPIN] += turn
        bodies.substep_state[i, tb.SUBSTEP_START + 2] += turn
