"""Rolling: Disc on a half-plane.

Generated from srs/models/friction.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector


def inverse_rolling_mass(inverse_mass: Scalar, inverse_inertia: Scalar, arm: Vector) -> Scalar:
    """Change of the tangential velocity of a disc that touches what cannot move, for one unit of
    tangential impulse (1/kg).

    inverse_rolling_mass = inverse_mass + inverse_inertia*dot(arm, arm)

    Args:
        inverse_mass: One over the mass, zero for a static body, 1/kg
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)
        arm: Lever arm, from the centre of mass to the point where something acts on a body, m

    Source: DD85, srs/models/friction.md:490.
    """
    arm_x, arm_y = arm
    return inverse_mass + inverse_inertia * (arm_x * arm_x + arm_y * arm_y)


def disc_force(normal_acceleration: Scalar, inverse_mass: Scalar) -> Scalar:
    """Force along the normal that holds a disc up (N).

    disc_force = -normal_acceleration/inverse_mass

    Args:
        normal_acceleration: Rate of change of the normal velocity of a contact that rests,
            m/s^2
        inverse_mass: One over the mass, zero for a static body, 1/kg

    Source: DD85, srs/models/friction.md:491.
    """
    return (-normal_acceleration) / inverse_mass


def rolling_friction(tangential_acceleration: Scalar, inverse_rolling_mass: Scalar) -> Scalar:
    """Force along the tangent with which a disc does not begin to slide (N).

    rolling_friction = -tangential_acceleration/inverse_rolling_mass

    Args:
        tangential_acceleration: Rate of change of the tangential velocity of a contact that
            lasts, m/s^2
        inverse_rolling_mass: Change of the tangential velocity of a disc that touches what
            cannot move, for one unit of tangential impulse, 1/kg

    Source: DD85, srs/models/friction.md:492.
    """
    return (-tangential_acceleration) / inverse_rolling_mass


def sliding_time(tangential_velocity: Scalar, tangential_acceleration: Scalar) -> Scalar:
    """Time until a contact that slides does not slide any more (s).

    sliding_time = -tangential_velocity/tangential_acceleration

    Args:
        tangential_velocity: Velocity of B's point of contact seen from A's, along the tangent;
            zero where the contact does not slide, m/s
        tangential_acceleration: Rate of change of the tangential velocity of a contact that
            lasts, m/s^2

    Source: DD85, srs/models/friction.md:493.
    """
    return (-tangential_velocity) / tangential_acceleration
