"""How bodies answer the impulses of joints, which act through a substep against drag (DD110).

Without contacts the first impulse of a step and the last act through half a substep (IM15): the
mean of all stands for each.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.definitions import inverse_inertia_slowed, inverse_mass_slowed


def slowed_column(n: int, joints: Joints) -> int:
    """Return which column of a propagator says what drag leaves of impulses in a mechanism."""
    touched = joints.mechanisms[n, tb.M_STATUS] == tb.IN_CONTACT
    return tb.ONE_SUBSTEP + (tb.SLOWED if touched else tb.SLOWED_MEAN)


def slowed_inverses(i: int, column: int, bodies: Bodies) -> tuple[float, float]:
    """Return the velocity, m/s, that a body gets by 1 N s, and the spin, rad/s, by 1 N m s.

    What drag leaves of both stands in a column of its propagator, and so many columns on.
    """
    properties = bodies.properties[i]
    through = bodies.propagators[int(properties[tb.PROPAGATOR])]
    return (
        inverse_mass_slowed(through[column], properties[tb.INVERSE_MASS]),
        inverse_inertia_slowed(through[column + tb.ANGULAR], properties[tb.INVERSE_INERTIA]),
    )
