"""Impacts on bodies that joints hold: the joints answer at the same instant (IM3, GD20).

Serves: the instant. Hides: that an impulse on one body of a mechanism moves them all.
"""

from collections.abc import Callable, Mapping, Sequence

from tamias2d.contact.complementarity import complementarity
from tamias2d.contact.core import Core
from tamias2d.contact.manifold import Contact, normal_velocity
from tamias2d.contact.response import unit_forces
from tamias2d.generated import definitions, impact
from tamias2d.state import Acceleration, State

Change = Mapping[int, Acceleration]
"""By how much velocities (m/s) and angular velocities (rad/s) of bodies change."""
Struck = Callable[[Mapping[int, Acceleration]], Change]
"""From impulses (N s) and their moments (N m s) on jointed bodies to the changes of all of them."""


def impulses(
    contacts: Sequence[Contact],
    changes: Sequence[Change],
    state: Callable[[int], State],
    restitution: float,
) -> list[float]:
    """Return the impulse at each contact of one pair, N s, for the changes that a unit makes."""
    speeds = [normal_velocity(contact, state(contact.a), state(contact.b)) for contact in contacts]
    matrix = [[_rate(contact, change) for change in changes] for contact in contacts]
    if len(contacts) == 1:
        return [max(float(impact.impulse(restitution, speeds[0], matrix[0][0])), 0.0)]
    wanted = [-float(impact.impulse(restitution, speed, 1.0)) for speed in speeds]
    return complementarity(matrix, wanted)


def change_by_unit(cores: Sequence[Core], contact: Contact, struck: Struck) -> Change:
    """Return what an impulse of 1 N s at a contact changes, with what the joints answer."""
    jointed: dict[int, Acceleration] = {}
    changes: dict[int, Acceleration] = {}
    for body, arm, force in unit_forces(contact):
        core = cores[body]
        if core.jointed:
            jointed[body] = (*force, float(definitions.torque(arm, force)))
        elif core.dynamic:
            x, y = impact.velocity_b_after((0.0, 0.0), 1.0, force, core.inverse_mass)
            spin = impact.angular_velocity_b_after(0.0, 1.0, arm, force, core.inverse_inertia)
            changes[body] = (float(x), float(y), float(spin))
    return {**changes, **struck(jointed)}


def changed(state: State, change: Acceleration, impulse: float) -> State:
    """Return a state after an impulse in N s, for the change that a unit makes."""
    (u, v), (du, dv, spin) = state.velocity, change
    return state._replace(
        velocity=(u + impulse * du, v + impulse * dv),
        angular_velocity=state.angular_velocity + impulse * spin,
    )


def _rate(contact: Contact, change: Change) -> float:
    """Return the normal velocity of a contact by changes alone, m/s."""
    still = State((0.0, 0.0), 0.0, (0.0, 0.0), 0.0)
    a, b = (changed(still, change.get(k, (0.0, 0.0, 0.0)), 1.0) for k in (contact.a, contact.b))
    return normal_velocity(contact, a, b)
