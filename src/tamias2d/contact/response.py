"""Frictionless impacts: the impulses along the normals of one pair (IM3)."""

from collections.abc import Sequence

from tamias2d.contact.complementarity import complementarity
from tamias2d.contact.core import Core
from tamias2d.contact.manifold import Contact, normal_velocity
from tamias2d.generated import impact
from tamias2d.state import State, Vector


def impulses(
    cores: Sequence[Core], contacts: Sequence[Contact], a: State, b: State, restitution: float
) -> list[float]:
    """Return the impulse at each contact of one pair, N s.

    Two contacts act together: each one separates as its own approach demands, or has no impulse.
    """
    speed_scale = [normal_velocity(contact, a, b) for contact in contacts]
    if len(contacts) == 1:
        mass = coupling(cores, contacts[0], contacts[0])
        return [max(float(impact.impulse(restitution, speed_scale[0], mass)), 0.0)]
    matrix = [[coupling(cores, k, m) for m in contacts] for k in contacts]
    wanted = [-float(impact.impulse(restitution, speed, 1.0)) for speed in speed_scale]
    return complementarity(matrix, wanted)


def coupling(cores: Sequence[Core], first: Contact, second: Contact) -> float:
    """Return the normal acceleration of the first contact by a unit force at the second, 1/kg."""
    if first is second:
        a, b = cores[first.a], cores[first.b]
        return float(
            impact.inverse_effective_mass(
                a.inverse_mass,
                a.inverse_inertia,
                first.arm_a,
                b.inverse_mass,
                b.inverse_inertia,
                first.arm_b,
                first.normal,
            )
        )
    total = 0.0
    for body, arm, force in unit_forces(first):
        for other, other_arm, other_force in unit_forces(second):
            if body == other and cores[body].dynamic:
                core = cores[body]
                total += impact.coupling(
                    core.inverse_mass, core.inverse_inertia, arm, force, other_arm, other_force
                )
    return float(total)


def after_impulse(
    cores: Sequence[Core], contact: Contact, impulse: float, a: State, b: State
) -> tuple[State, State]:
    """Return the states of A and B after an impulse in N s."""
    core_a, core_b = cores[contact.a], cores[contact.b]
    n = contact.normal
    if core_a.dynamic:
        velocity = impact.velocity_a_after(a.velocity, impulse, n, core_a.inverse_mass)
        spin = impact.angular_velocity_a_after(
            a.angular_velocity, impulse, contact.arm_a, n, core_a.inverse_inertia
        )
        a = a._replace(velocity=velocity, angular_velocity=float(spin))
    if core_b.dynamic:
        velocity = impact.velocity_b_after(b.velocity, impulse, n, core_b.inverse_mass)
        spin = impact.angular_velocity_b_after(
            b.angular_velocity, impulse, contact.arm_b, n, core_b.inverse_inertia
        )
        b = b._replace(velocity=velocity, angular_velocity=float(spin))
    return a, b


def unit_forces(contact: Contact) -> tuple[tuple[int, Vector, Vector], ...]:
    """Return for both bodies the arm, and the unit force along the normal."""
    x, y = contact.normal
    return (
        (contact.a, contact.arm_a, (-x, -y)),
        (contact.b, contact.arm_b, (x, y)),
    )
