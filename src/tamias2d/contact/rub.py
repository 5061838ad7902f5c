"""What an impact of rough bodies does: impulses along normals and tangents of one pair (IM9).

Serves: what happens at one instant. Hides: how two contacts share what friction can give.
"""

from collections.abc import Sequence

import numpy as np

from tamias2d.contact.core import Core
from tamias2d.contact.manifold import Contact, approach, sliding, tangent_of
from tamias2d.contact.response import coupling, impulses
from tamias2d.generated import friction
from tamias2d.state import State


def rubs(
    cores: Sequence[Core],
    contacts: Sequence[Contact],
    a: State,
    b: State,
    restitution: float,
    roughness: float,
) -> list[tuple[float, float]]:
    """Return the impulses along normal and tangent at each contact of one pair, N s.

    `roughness` is the pair's coefficient of friction.
    """
    pushes = impulses(cores, contacts, a, b, restitution)
    pressed = [k for k, push in enumerate(pushes) if push > 0]
    found = [(push, 0.0) for push in pushes]
    if len(pressed) == 1:
        (k,) = pressed
        found[k] = _alone(cores, contacts[k], a, b, pushes[k], roughness)
    elif pressed:
        found = _together(cores, contacts, a, b, pushes, 1 / (1 + restitution), roughness)
    return found


def struck(
    cores: Sequence[Core], contact: Contact, rub: tuple[float, float], a: State, b: State
) -> tuple[State, State]:
    """Return the states of A and B after impulses along normal and tangent, N s."""
    core_a, core_b = cores[contact.a], cores[contact.b]
    impulse = friction.impulse_vector(*rub, contact.normal)
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


def _alone(
    cores: Sequence[Core], contact: Contact, a: State, b: State, push: float, roughness: float
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
        sliding(contact, a, b), cross, approach(contact, a, b), mass
    )
    sticking = friction.sticking_impulse(closest, sliding_mass)
    change = friction.normal_change(cross, sticking, mass)
    share = friction.share(roughness, push, sticking, change)
    return (
        float(friction.normal_impulse(push, share, change)),
        float(friction.tangential_impulse(share, sticking)),
    )


def _together(
    cores: Sequence[Core],
    contacts: Sequence[Contact],
    a: State,
    b: State,
    pushes: Sequence[float],
    closest: float,
    roughness: float,
) -> list[tuple[float, float]]:
    """Return the impulses at two contacts; `closest` is the part of the pushes until then.

    Both lie on one line along the tangent, which is therefore pushed as a whole.
    """
    along = tangent_of(contacts[0])
    ways = [*contacts, along]
    matrix = [[coupling(cores, k, m) for m in ways] for k in ways]
    slide = sliding(contacts[0], a, b) + closest * sum(
        c * push for c, push in zip(matrix[-1], pushes, strict=False)
    )
    wanted = np.array((0.0, 0.0, -slide))
    *changes, sticking = np.linalg.lstsq(np.array(matrix), wanted)[0].tolist()
    share = float(friction.share(roughness, sum(pushes), sticking, sum(changes)))
    for push, change in zip(pushes, changes, strict=True):
        if push + share * change < 0:  # it is no longer pushed from here on
            share = -push / change
    found = [
        max(float(friction.normal_impulse(push, share, change)), 0.0)
        for push, change in zip(pushes, changes, strict=True)
    ]
    whole = float(friction.tangential_impulse(share, sticking))
    total = sum(found)
    return [(push, whole * push / total) for push in found]
