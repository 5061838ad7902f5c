"""Active bodies: those whose velocities are solved in a part, for contacts or what ties them."""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Constraints, Touching


def activate(i: int, bodies: Bodies, touching: Touching, constraints: Constraints) -> None:
    """Put a body that moves on the list of active bodies, unless it is there."""
    if bodies.moved[i] == 0:
        bodies.moved[i] = 1
        touching.active[constraints.counts[tb.ACTIVE]] = i
        constraints.counts[tb.ACTIVE] += 1
