"""Frictional impacts: the normal and tangential impulses of one pair (IM9)."""

from collections.abc import Sequence

import numpy as np

from tamias2d.contact.core import Core
from tamias2d.contact.manifold import Contact, normal_velocity, tangent_of, tangential_velocity
from tamias2d.contact.response import coupling, impulses
from tamias2d.generated import friction
from tamias2d.state import State


def frictional_impulses(
    cores: Sequence[Core],
    contacts: Sequence[Contact],
    a: State,
    b: State,
    restitution: float,
    coefficient: float,
) -> list[tuple[float, float]]:
    """Return the impulses along normal and tangent at each contact of one pair, N s.

    `coefficient` is the pair's coefficient of friction.
    """
    normal_impulses = impulses(cores, contacts, a, b, restitution)
    pressed = [k for k, normal_impulse in enumerate(normal_impulses) if normal_impulse > 0]
    found = [(normal_impulse, 0.0) for normal_impulse in normal_impulses]
    if len(pressed) == 1:
        (k,) = pressed
        found[k] = _at_one_contact(cores, contacts[k], a, b, normal_impulses[k], coefficient)
    elif pressed:
        found = _at_two_contacts(
            cores, contacts, a, b, normal_impulses, 1 / (1 + restitution), coefficient
        )
    return found


def after_frictional_impulse(
    cores: Sequence[Core], contact: Contact, impulses_of: tuple[float, float], a: State, b: State
) -> tuple[State, State]:
    """Return the states of A and B after impulses along normal and tangent, N s."""
    core_a, core_b = cores[contact.a], cores[contact.b]
    impulse = friction.impulse_vector(*impulses_of, contact.normal)
    if core_a.dynamic:
        velocity = friction.velocity_a_after(a.velocity, core_a.inverse_mass, impulse)
        spin = friction.angular_velocity_a_after(
            a.angular_velocity, core_a.inverse_inertia, contact.arm_a, impulse
        )
        a = a._replace(velocity=velocity, angular_velocity=float(spin))
    if core_b.dynamic:
        velocity = friction.velocity_b_after(b.velocity, core_b.inverse_mass, impulse)
        spin = friction.angular_velocity_b_after(
            b.angular_velocity, core_b.inverse_inertia, contact.arm_b, impulse
        )
        b = b._replace(velocity=velocity, angular_velocity=float(spin))
    return a, b


def _at_one_contact(
    cores: Sequence[Core],
    contact: Contact,
    a: State,
    b: State,
    normal_impulse: float,
    coefficient: float,
) -> tuple[float, float]:
    core_a, core_b = cores[contact.a], cores[contact.b]
    mass = coupling(cores, contact, contact)
    cross = friction.cross_coupling(
        core_a.inverse_inertia,
        contact.arm_a,
        core_b.inverse_inertia,
        contact.arm_b,
        contact.normal,
    )
    sliding_mass = friction.inverse_sliding_mass(
        core_a.inverse_mass,
        core_a.inverse_inertia,
        contact.arm_a,
        core_b.inverse_mass,
        core_b.inverse_inertia,
        contact.arm_b,
        mass,
    )
    closest = friction.tangential_velocity_closest(
        tangential_velocity(contact, a, b), cross, normal_velocity(contact, a, b), mass
    )
    sticking = friction.sticking_impulse(closest, sliding_mass)
    change = friction.normal_change(cross, sticking, mass)
    share = friction.share(coefficient, normal_impulse, sticking, change)
    return (
        float(friction.normal_impulse(normal_impulse, share, change)),
        float(friction.tangential_impulse(share, sticking)),
    )


def _at_two_contacts(
    cores: Sequence[Core],
    contacts: Sequence[Contact],
    a: State,
    b: State,
    normal_impulses: Sequence[float],
    closest: float,
    coefficient: float,
) -> list[tuple[float, float]]:
    """Return the impulses at two contacts; `closest` is the share of the normal impulses by then.

    Both contacts lie on one line along the tangent, and share one tangential impulse.
    """
    along = tangent_of(contacts[0])
    directions = [*contacts, along]
    matrix = [[coupling(cores, k, m) for m in directions] for k in directions]
    tangential_velocity_closest = tangential_velocity(contacts[0], a, b) + closest * sum(
        c * normal_impulse for c, normal_impulse in zip(matrix[-1], normal_impulses, strict=False)
    )
    wanted = np.array((0.0, 0.0, -tangential_velocity_closest))
    *changes, sticking = np.linalg.lstsq(np.array(matrix), wanted)[0].tolist()
    share = float(friction.share(coefficient, sum(normal_impulses), sticking, sum(changes)))
    for normal_impulse, change in zip(normal_impulses, changes, strict=True):
        if normal_impulse + share * change < 0:  # its normal impulse ends here
            share = -normal_impulse / change
    found = [
        max(float(friction.normal_impulse(normal_impulse, share, change)), 0.0)
        for normal_impulse, change in zip(normal_impulses, changes, strict=True)
    ]
    whole = float(friction.tangential_impulse(share, sticking))
    total = sum(found)
    return [(normal_impulse, whole * normal_impulse / total) for normal_impulse in found]
