"""Surfaces that run, where contacts touch them (DD97).

On a chain that is solid from both sides the sense depends on which of them is touched, and a body
may roll round its end while the arrangement stays: it is asked for in each step. Cost: a visit to
each contact, where some surface runs.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.material import mixed_surface_speed
from tamias2d.engine.tables import Constraints, Contacts, Shapes


def run_surfaces(
    first: int, last: int, contacts: Contacts, shapes: Shapes, constraints: Constraints
) -> None:
    """Write how fast surfaces run at the contacts of some blocks."""
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        for m in range(lane[tb.FILLED]):
            pair = contacts.pairs[lane[tb.LANE_CONTACT + m]]
            manifold = contacts.manifolds[lane[tb.LANE_CONTACT + m]]
            normal = (manifold[tb.NX], manifold[tb.NY])
            speed = mixed_surface_speed(pair[0], pair[1], normal, shapes)
            row[tb.R_SURFACE_SPEED + m] = speed
