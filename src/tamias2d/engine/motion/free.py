"""Where bodies get to in a step: those without contacts along their closed forms (IM1, IM6).

Serves: a step. Hides: that a body is moved at its end only, once it is known what it meets.
"""

from tamias2d.engine.continuous.bounds import goes_far
from tamias2d.engine.tables import (
    ANGULAR,
    DECAY,
    DX,
    DYNAMIC,
    FORCE_GAIN,
    GAIN,
    GRAVITY_X,
    GRAVITY_Y,
    INVERSE_INERTIA,
    INVERSE_MASS,
    KINEMATIC,
    LIFT,
    PROPAGATOR,
    WHOLE_STEP,
    Bodies,
    Control,
)
from tamias2d.generated.definitions import (
    acceleration,
    angular_acceleration,
    pace_given,
    pace_later,
    way,
)
from tamias2d.state import Array


def integrate_free(control: Control, bodies: Bodies) -> bool:
    """Find how far bodies without contacts go in this step: they have a closed form (IM1, IM6).

    What forces add to their velocities is noted; for all others that is nothing already. Returns
    whether some body goes so far that flight is to look after it.
    """
    far = False
    for i in range(len(bodies.kind)):
        if bodies.kind[i] >= KINEMATIC and bodies.moved[i] == 0:
            integrate_body(i, control, bodies)
        bodies.moved[i] = 0
        far = far | goes_far(i, bodies)
    return far


def integrate_body(i: int, control: Control, bodies: Bodies) -> None:
    """Find how far a body goes on which no contact acts."""
    by_x = by_y = turn = 0.0
    if bodies.kind[i] == DYNAMIC:
        gravity = (control.settings[GRAVITY_X], control.settings[GRAVITY_Y])
        by_x, by_y = acceleration(
            gravity, (bodies.load[i, 0], bodies.load[i, 1]), bodies.properties[i, INVERSE_MASS]
        )
        turn = angular_acceleration(bodies.load[i, 2], bodies.properties[i, INVERSE_INERTIA])
    so = bodies.propagators[int(bodies.properties[i, PROPAGATOR])]
    integrate_coordinate(i, 0, WHOLE_STEP, by_x, so, bodies.motion, bodies.flight)
    integrate_coordinate(i, 1, WHOLE_STEP, by_y, so, bodies.motion, bodies.flight)
    integrate_coordinate(i, 2, WHOLE_STEP + ANGULAR, turn, so, bodies.motion, bodies.flight)


def integrate_coordinate(
    i: int, axis: int, at: int, by: float, so: Array, motion: Array, flight: Array
) -> None:
    """Take one coordinate of a body through the step, under an acceleration (DD41)."""
    before, gain = motion[i, axis], so[at + GAIN]
    after = pace_later(so[at + DECAY], before, pace_given(gain, by))
    motion[i, DX + axis] = way(gain, so[at + LIFT], before, by)
    motion[i, axis] = after
    flight[i, FORCE_GAIN + axis] = after - before
