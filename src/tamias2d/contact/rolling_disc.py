"""A disc that stays on a half-plane with friction under constant loads: it slides or rolls (DD85).

Serves: instants, and compiled code (`tamias2d.event_driven`), whose worlds have the same bits for
that reason. The disc is body B: the normal leads from the half-plane to it.
"""

from math import inf
from typing import TypeAlias

from tamias2d.contact.constrained_acceleration import along_surface
from tamias2d.generated import friction, impact, rest, rolling
from tamias2d.state import Vector

Motion: TypeAlias = tuple[float, float, float]
"""A velocity or an acceleration: x, y and its angular part."""

EPSILON = 2.0**-52
PRESSED = 1e-6  # of the loads: what presses a disc by less may not hold it
BEYOND = 1e-10  # of the friction at its bound: by how much rounding may exceed it
BALANCED = 1e-13  # of the loads: what is left of them where they are in balance


def load_on(loads: Motion, arm: Vector, normal: Vector) -> float:
    """Return the normal acceleration of the contact under the loads, m/s^2."""
    x, y, turning = loads
    return float(
        rest.normal_acceleration((0.0, 0.0), 0.0, (0.0, 0.0), (x, y), turning, arm, normal)
    )


def is_pressed(loads: Motion, arm: Vector, normal: Vector) -> bool:
    """Return whether the loads press a disc on its half-plane, whatever rounding does."""
    return -load_on(loads, arm, normal) > PRESSED * (abs(loads[0]) + abs(loads[1]))


def rate_of(motion: Motion, arm: Vector, normal: Vector) -> float:
    """Return the normal velocity of the contact, m/s."""
    (u, v, spin), still = motion, (0.0, 0.0)
    return float(impact.normal_velocity(still, 0.0, still, (u, v), spin, arm, normal))


def slip_of(motion: Motion, arm: Vector, normal: Vector) -> float:
    """Return the tangential velocity of the contact, m/s."""
    u, v, spin = motion
    return float(
        friction.tangential_velocity((0.0, 0.0), 0.0, (0.0, 0.0), (u, v), spin, arm, normal)
    )


def slip_change(by: Motion, arm: Vector, normal: Vector) -> float:
    """Return the tangential acceleration of the contact, m/s^2."""
    (x, y, turning), still = by, (0.0, 0.0)
    return float(friction.tangential_acceleration(still, 0.0, still, (x, y), turning, arm, normal))


def sense_of(
    motion: Motion,
    loads: Motion,
    arm: Vector,
    normal: Vector,
    inverses: Vector,
    coefficient: float,
    noise: float,
    time: float,
) -> int:
    """Return in which sense a disc slides at a time, s: 0 where it does not.

    A slip counts as none by noise, m/s, or where the time of its end is not known better.
    """
    slip = slip_of(motion, arm, normal)
    most = friction.friction_force_most(
        rolling.disc_force(load_on(loads, arm, normal), inverses[0]), coefficient
    )
    change = most * rolling.inverse_rolling_mass(inverses[0], inverses[1], arm)
    change += abs(loads[0]) + abs(loads[1])
    if abs(slip) <= noise + 64 * EPSILON * time * change:
        return 0
    return 1 if slip > 0.0 else -1


def held(
    loads: Motion, arm: Vector, normal: Vector, inverses: Vector, coefficient: float, sense: int
) -> tuple[float, float, float, int]:
    """Return the acceleration of a disc that is pressed, and in which sense it slides from now on.

    `inverses` are those of its mass, 1/kg, and of its inertia, 1/(kg m^2).
    """
    by_loads = slip_change(loads, arm, normal)
    along = rolling.rolling_friction(
        by_loads, rolling.inverse_rolling_mass(inverses[0], inverses[1], arm)
    )
    force = rolling.disc_force(load_on(loads, arm, normal), inverses[0])
    if sense == 0 and abs(along) > friction.friction_force_most(force, coefficient) * (1 + BEYOND):
        sense = 1 if by_loads > 0.0 else -1
    if sense != 0:
        along = friction.friction_force(sense, coefficient, force)
    push = friction.impulse_vector(0.0, along, normal)
    x, y = along_surface(friction.velocity_b_after((loads[0], loads[1]), inverses[0], push), normal)
    turning = friction.angular_velocity_b_after(loads[2], inverses[1], arm, push)
    radius = abs(arm[0]) + abs(arm[1])
    unseen = BALANCED * (abs(loads[0]) + abs(loads[1]) + radius * abs(loads[2]))
    if abs(x) + abs(y) <= unseen:
        x, y = 0.0, 0.0
    if radius * abs(turning) <= unseen:
        turning = 0.0
    return x, y, turning, sense


def crept(
    place: Motion,
    motion: Motion,
    loads: Motion,
    arm: Vector,
    normal: Vector,
    inverses: Vector,
    restitution: float,
) -> Motion:
    """Return place and orientation where the bounces that are left have brought a disc (DD78).

    It sticks at each of them.
    """
    load = load_on(loads, arm, normal)
    if not load * (1 - restitution) < 0.0:
        return place
    rate = rate_of(motion, arm, normal)
    way = friction.creep(rate, load, slip_change(loads, arm, normal), restitution)
    mass = rolling.inverse_rolling_mass(inverses[0], inverses[1], arm)
    push = friction.impulse_vector(0.0, way / mass, normal)
    x, y = friction.velocity_b_after((place[0], place[1]), inverses[0], push)
    return x, y, friction.angular_velocity_b_after(place[2], inverses[1], arm, push)


def settled(
    motion: Motion, arm: Vector, normal: Vector, inverses: Vector, coefficient: float, sense: int
) -> Motion:
    """Return the velocity of a disc without what its last bounces have left of them (DD75).

    It slides in a sense, or sticks.
    """
    impulse = friction.settling_impulse(rate_of(motion, arm, normal), inverses[0])
    if sense == 0:
        mass = rolling.inverse_rolling_mass(inverses[0], inverses[1], arm)
        along = friction.sticking_impulse(slip_of(motion, arm, normal), mass)
    else:
        along = friction.friction_force(sense, coefficient, impulse)
    push = friction.impulse_vector(impulse, along, normal)
    u, v = along_surface(
        friction.velocity_b_after((motion[0], motion[1]), inverses[0], push), normal
    )
    return u, v, friction.angular_velocity_b_after(motion[2], inverses[1], arm, push)


def sliding_end(
    start: float, motion: Motion, by: Motion, arm: Vector, normal: Vector, sense: int
) -> float:
    """Return when a disc that slides since a start does not slide any more, s, or infinity."""
    change = slip_change(by, arm, normal)
    if not sense * change < 0.0:
        return inf
    return start + max(float(rolling.sliding_time(slip_of(motion, arm, normal), change)), 0.0)
