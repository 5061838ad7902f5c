"""Where bodies get to in a step: those without contacts along their closed forms (IM1, IM6).

A body is moved at the end of the step only, once it is known what it meets.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.bounds import goes_far
from tamias2d.engine.energy.step_energy import unchanged_by_contacts
from tamias2d.engine.tables import Bodies, Control
from tamias2d.generated.definitions import (
    acceleration,
    angular_acceleration,
    coordinate_displacement,
    coordinate_velocity_gain,
    coordinate_velocity_later,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array


def integrate_free(control: Control, bodies: Bodies) -> bool:
    """Find the displacements of bodies that contacts leave alone (IM1, IM6), and what forces give.

    Returns whether some body goes so far that it needs continuous collision.
    """
    far, of_substeps = False, 1.0 / control.counts[tb.PART_SUBSTEPS]
    for i in range(len(bodies.kind)):
        if bodies.moved[i] == tb.UNTOUCHED and unchanged_by_contacts(i, control, bodies):
            for n in range(3):
                bodies.motion[i, n] = bodies.substep_state[i, tb.STEP_START + n]
            bodies.moved[i] = tb.UNMOVED
        if bodies.kind[i] >= tb.KINEMATIC and bodies.moved[i] == tb.UNMOVED:
            integrate_body(i, control, bodies)
        bodies.early[i, tb.SHARE_OF_PART] = of_substeps if bodies.moved[i] == tb.MOVED else 0.0
        bodies.moved[i] = 0
        far = far | goes_far(i, bodies)
    return far


def integrate_body(i: int, control: Control, bodies: Bodies) -> None:
    """Find the displacement of a body on which no contact acts, and its new velocity."""
    look_ahead(i, control, bodies)
    motion, ahead, flight = bodies.motion[i], bodies.ahead[i], bodies.flight[i]
    for n in range(3):
        flight[tb.FORCE_GAIN + n] = ahead[n] - motion[n]
        motion[n], motion[tb.DX + n] = ahead[n], ahead[tb.DX + n]


@inlined
def look_ahead(i: int, control: Control, bodies: Bodies) -> None:
    """Find the motion that a body has as the step ends, if no contact acts on it."""
    by_x = by_y = turning = 0.0
    if bodies.kind[i] == tb.DYNAMIC:
        gravity = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
        force, torque = (bodies.load[i, 0], bodies.load[i, 1]), bodies.load[i, 2]
        by_x, by_y = acceleration(gravity, force, bodies.properties[i, tb.INVERSE_MASS])
        turning = angular_acceleration(torque, bodies.properties[i, tb.INVERSE_INERTIA])
    propagator = bodies.propagators[int(bodies.properties[i, tb.PROPAGATOR])]
    motion, ahead = bodies.motion, bodies.ahead
    look_along(i, 0, tb.WHOLE_STEP, by_x, propagator, motion, ahead)
    look_along(i, 1, tb.WHOLE_STEP, by_y, propagator, motion, ahead)
    look_along(i, 2, tb.WHOLE_STEP + tb.ANGULAR, turning, propagator, motion, ahead)


@inlined
def look_along(
    i: int, axis: int, at: int, by: float, propagator: Array, motion: Array, ahead: Array
) -> None:
    """Take one coordinate of a body through the step, under an acceleration (DD41)."""
    before, gain = motion[i, axis], propagator[at + tb.GAIN]
    ahead[i, axis] = coordinate_velocity_later(
        propagator[at + tb.DECAY], before, coordinate_velocity_gain(gain, by)
    )
    ahead[i, tb.DX + axis] = coordinate_displacement(gain, propagator[at + tb.LIFT], before, by)
