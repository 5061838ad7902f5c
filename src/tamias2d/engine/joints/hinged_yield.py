"""By how much a row yields with the hinge on which its body hangs (DD70).

Cost: one division.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Joints
from tamias2d.generated.definitions import point_velocity
from tamias2d.generated.hinge_tree import (
    hinged_yield,
    link_impulse,
    link_mass_x,
    link_mass_y,
    point_yield_x,
    point_yield_y,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Vector


def yield_at_hinge(
    m: int, root: int, yielding: float, by: Vector, spins: Vector, joints: Joints
) -> float:
    """Return by how much a row yields, 1/kg, that yields so much without the hinge of a member.

    A unit of its impulse changes the velocity of the member by `by`, m/s, and the spins of the
    member and of what it hangs on by `spins`, rad/s.
    """
    if joints.members[m, tb.JOINED_HINGE] < 0:
        return yielding
    row, above = joints.hinges[m], joints.members[m, tb.JOINED_ABOVE]
    inverse_mass = joints.places[m, tb.SLOWED_INVERSE_MASS]
    mass_above = inertia_above = 0.0
    if m > root:
        mass_above = joints.places[above, tb.SLOWED_INVERSE_MASS]
        inertia_above = joints.places[above, tb.HELD_INVERSE_INERTIA]
    arm, far = (row[tb.H_ARM], row[tb.H_ARM + 1]), (row[tb.H_FAR_ARM], row[tb.H_FAR_ARM + 1])
    held = joints.places[m, tb.HELD_INVERSE_INERTIA]
    inverse, inverse_above = (inverse_mass, held), (mass_above, inertia_above)
    return yield_with_hinge(yielding, by, spins, arm, far, inverse, inverse_above)


@inlined
def yield_with_hinge(
    yielding: float,
    by: Vector,
    spins: Vector,
    arm: Vector,
    far: Vector,
    inverse: Vector,
    inverse_above: Vector,
) -> float:
    """Return the same for a hinge with arms, m, between bodies of inverse mass and inertia."""
    own_x = point_yield_x(inverse[0], inverse[1], arm)
    own_y = point_yield_y(inverse[0], inverse[1], arm)
    far_x = point_yield_x(inverse_above[0], inverse_above[1], far)
    far_y = point_yield_y(inverse_above[0], inverse_above[1], far)
    yield_x, yield_y = (
        (own_x[0] + far_x[0], own_x[1] + far_x[1]),
        (own_y[0] + far_y[0], own_y[1] + far_y[1]),
    )
    here, there = point_velocity(by, spins[0], arm), point_velocity((0.0, 0.0), spins[1], far)
    rate = (here[0] - there[0], here[1] - there[1])
    mass_x, mass_y = link_mass_x(yield_x, yield_y), link_mass_y(yield_x, yield_y)
    return hinged_yield(yielding, rate, link_impulse(rate, mass_x, mass_y), 1.0)
