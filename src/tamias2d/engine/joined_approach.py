"""How fast the contacts of mechanisms meet, which have no impacts in flight (DD102)."""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Control, Integers
from tamias2d.generated.definitions import coordinate_velocity_later
from tamias2d.generated.soft_contact import impact_velocity, row_acceleration, row_velocity
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector


def joined_approach(
    speed: float, m: int, at: int, lane: Integers, row: Array, control: Control, bodies: Bodies
) -> float:
    """Return the normal velocity with which a point meets that approaches at a speed, m/s."""
    i, j = lane[tb.BODY_A + m], lane[tb.BODY_B + m]
    if bodies.properties[i, tb.JOINED] + bodies.properties[j, tb.JOINED] == 0.0:
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
