"""Where bodies get to in a step: those without contacts along their closed forms (IM1, IM6).

A body is moved at the end of the step only, once it is known what it meets.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.bounds import goes_far
from tamias2d.engine.solver.energy import unchanged_by_contacts
from tamias2d.engine.tables import Bodies, Control
from tamias2d.generated.definitions import (
    acceleration,
    angular_acceleration,
    coordinate_displacement,
    coordinate_velocity_gain,
    coordinate_velocity_later,
)
from tamias2d.state import Array


def integrate_free(control: Control, bodies: Bodies) -> bool:
    """Find the displacements of bodies that contacts leave alone (IM1, IM6), and what forces give.

    Returns whether some body goes so far that it needs continuous collision.
    """
    far, of_substeps = False, 1.0 / control.counts[tb.PART_SUBSTEPS]
    for i in range(len(bodies.kind)):
        if bodies.moved[i] == tb.UNTOUCHED and unchanged_by_contacts(
            control, bodies.substep_state[i], bodies.motion[i]
        ):
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
    by_x = by_y = turning = 0.0
    if bodies.kind[i] == tb.DYNAMIC:
        gravity = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
        force, torque = (bodies.load[i, 0], bodies.load[i, 1]), bodies.load[i, 2]
        by_x, by_y = acceleration(gravity, force, bodies.properties[i, tb.INVERSE_MASS])
        turning = angular_acceleration(torque, bodies.properties[i, tb.INVERSE_INERTIA])
    propagator = bodies.propagators[int(bodies.properties[i, tb.PROPAGATOR])]
    motion, flight = bodies.motion, bodies.flight
    integrate_coordinate(i, 0, tb.WHOLE_STEP, by_x, propagator, motion, flight)
    integrate_coordinate(i, 1, tb.WHOLE_STEP, by_y, propagator, motion, flight)
    integrate_coordinate(i, 2, tb.WHOLE_STEP + tb.ANGULAR, turning, propagator, motion, flight)


def integrate_coordinate(
    i: int, axis: int, at: int, by: float, propagator: Array, motion: Array, flight: Array
) -> None:
    """Take one coordinate of a body through the step, under an acceleration (DD41)."""
    before, gain = motion[i, axis], propagator[at + tb.GAIN]
    after = coordinate_velocity_later(
        propagator[at + tb.DECAY], before, coordinate_velocity_gain(gain, by)
    )
    motion[i, tb.DX + axis] = coordinate_displacement(gain, propagator[at + tb.LIFT], before, by)
    motion[i, axis] = after
    flight[i, tb.FORCE_GAIN + axis] = after - before
