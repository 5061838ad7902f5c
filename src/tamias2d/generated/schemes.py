"""Integration schemes: one step of each.

Generated from srs/schemes/euler.md,
srs/schemes/legacy.md,
srs/schemes/runge_kutta.md,
srs/schemes/verlet.md by `python -m tools.generate`. Edit the chapter, not this file.
Positions and velocities are arrays of any one shape, angles and their rates among them; an
acceleration is a function of time, position and velocity.
"""

from collections.abc import Callable
from typing import Any

Acceleration = Callable[[Any, Any, Any], Any]


def explicit_euler(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> tuple[Any, Any]:
    """Explicit Euler, of order 1.

    Position and velocity both move along the slopes of the step's beginning.

    Source: srs/schemes/euler.md:22; hairer1993.
    """
    rate_1 = acceleration(time, position, velocity)
    position = position + time_step * velocity
    velocity = velocity + time_step * rate_1
    return position, velocity


def semi_implicit_euler(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> tuple[Any, Any]:
    """Semi-implicit Euler, of order 1.

    The velocity takes a full kick, then the position drifts with the velocity that results.

    Source: srs/schemes/euler.md:47; hairer2006.
    """
    velocity = velocity + time_step * acceleration(time, position, velocity)
    position = position + time_step * velocity
    return position, velocity


def legacy_2018_translation(
    time_step: Any, position: Any, velocity: Any, previous: Any, current: Any
) -> tuple[Any, Any]:
    """Translation in the program of 2018, of order 0.

    The position moves with half the velocity and with the acceleration of the step before; the
    velocity with the mean of the accelerations before and now.

    Source: srs/schemes/legacy.md:19; tamias2018.
    """
    return (
        position + time_step / 2 * velocity + time_step * time_step / 2 * previous,
        velocity + time_step / 2 * previous + time_step / 2 * current,
    )


def legacy_2018_rotation(
    time_step: Any, position: Any, velocity: Any, previous: Any, current: Any
) -> tuple[Any, Any]:
    """Rotation in the program of 2018, of order 1.

    The orientation moves with the full angular velocity and with the angular acceleration of
    the step before; the angular velocity with the one of now.

    Source: srs/schemes/legacy.md:35; tamias2018.
    """
    return (
        position + time_step * velocity + time_step * time_step / 2 * previous,
        velocity + time_step * current,
    )


def runge_kutta_4(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> tuple[Any, Any]:
    """Classical Runge-Kutta, of order 4.

    Four slopes, one at the beginning, two in the middle and one at the end of the step,
    averaged with the weights of Simpson's rule.

    Source: srs/schemes/runge_kutta.md:8; kutta1901, hairer1993.
    """
    rate_1 = acceleration(time, position, velocity)
    velocity_2 = velocity + time_step / 2 * rate_1
    rate_2 = acceleration(time + time_step / 2, position + time_step / 2 * velocity, velocity_2)
    velocity_3 = velocity + time_step / 2 * rate_2
    rate_3 = acceleration(time + time_step / 2, position + time_step / 2 * velocity_2, velocity_3)
    velocity_4 = velocity + time_step * rate_3
    rate_4 = acceleration(time + time_step, position + time_step * velocity_3, velocity_4)
    position = position + time_step / 6 * (velocity + 2 * velocity_2 + 2 * velocity_3 + velocity_4)
    velocity = velocity + time_step / 6 * (rate_1 + 2 * rate_2 + 2 * rate_3 + rate_4)
    return position, velocity


def velocity_verlet(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> tuple[Any, Any]:
    """Velocity Verlet, of order 2.

    Half a kick with the force at the step's beginning, a full drift, half a kick with the force
    at its end.

    Source: srs/schemes/verlet.md:7; verlet1967, hairer2006.
    """
    velocity = velocity + time_step / 2 * acceleration(time, position, velocity)
    position = position + time_step * velocity
    velocity = velocity + time_step / 2 * acceleration(time + time_step, position, velocity)
    return position, velocity
