"""Impulses stored from blocks to manifolds: for the next step's warm start, and for users."""

from tamias2d.engine.part_impulses import store_impulse_of_part
from tamias2d.engine.solver.blocks import lane_of, points_of
from tamias2d.engine.tables import (
    BOUNCED,
    BOUNCING,
    FIRST_RESTITUTION,
    IS_TOUCHING,
    LEVEL,
    NORMAL_IMPULSE,
    P_NORMAL_IMPULSE,
    P_TANGENT_IMPULSE,
    P_TOTAL_IMPULSE,
    POINT,
    POINT_SIZE,
    PX,
    PY,
    SHARED,
    TANGENT_IMPULSE,
    TOTAL_IMPULSE,
    TOUCHES,
    WORLD_POINT,
    Bodies,
    Constraints,
    Contacts,
    Control,
    Touching,
    X,
    Y,
)
from tamias2d.kernels.lanes import LANES


def store_impulses(
    first: int,
    last: int,
    control: Control,
    bodies: Bodies,
    contacts: Contacts,
    touching: Touching,
    constraints: Constraints,
) -> None:
    """Store the impulses of touching contacts, which are listed by slabs, and where they acted.

    A contact with an impulse touched. The impulses of the parts of a step are added up as each
    ends (`add_up_impulses`). A contact that restitution has parted is marked.
    """
    in_parts, bouncing = control.counts[LEVEL] > 0, constraints.counts[BOUNCING] > 0
    for place in range(first, last):
        k = touching.by_slab[place]
        p, pose = touching.contact[k], bodies.pose[touching.body_a[k]]
        b, m = lane_of(k, touching)
        row, manifold = constraints.blocks[b], contacts.manifolds[p]
        contacts.flags[p, BOUNCED] = 0
        for n in range(points_of(k, touching)):
            at, to = SHARED + n * POINT_SIZE + m, POINT * n
            total = row[at + P_TOTAL_IMPULSE]
            if in_parts:
                store_impulse_of_part(n, total, pose, manifold, contacts.flags[p])
            else:
                manifold[TOTAL_IMPULSE + to] = total
                manifold[WORLD_POINT + to] = pose[X] + manifold[PX + to]
                manifold[WORLD_POINT + to + 1] = pose[Y] + manifold[PY + to]
                if total > 0.0:
                    contacts.flags[p, TOUCHES] |= IS_TOUCHING
            if bouncing and row[FIRST_RESTITUTION + n * LANES + m] > 0.0:
                contacts.flags[p, BOUNCED] = 1
            manifold[NORMAL_IMPULSE + to] = row[at + P_NORMAL_IMPULSE]
            manifold[TANGENT_IMPULSE + to] = row[at + P_TANGENT_IMPULSE]
