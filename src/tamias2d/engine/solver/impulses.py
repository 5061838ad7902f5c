"""Impulses stored from blocks to manifolds: for the next step's warm start, and for users."""

from tamias2d.engine import tables as tb
from tamias2d.engine.part_impulses import store_impulse_of_part
from tamias2d.engine.solver.blocks import lane_of, points_of
from tamias2d.engine.tables import Bodies, Constraints, Contacts, Control, Touching
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
    ends (`add_up_impulses`). A contact that restitution has parted is marked, and what that gave
    is not kept for the next step: it is over.
    """
    in_parts, bouncing = control.counts[tb.LEVEL] > 0, constraints.counts[tb.BOUNCING] > 0
    for place in range(first, last):
        k = touching.by_slab[place]
        p, pose = touching.contact[k], bodies.pose[touching.body_a[k]]
        b, m = lane_of(k, touching)
        row, manifold = constraints.blocks[b], contacts.manifolds[p]
        contacts.flags[p, tb.BOUNCED] = 0
        if not in_parts:
            contacts.flags[p, tb.IN_PARTS] = 0
        for n in range(points_of(k, touching)):
            at, to = tb.SHARED + n * tb.POINT_SIZE + m, tb.POINT * n
            total, friction = row[at + tb.P_TOTAL_IMPULSE], row[at + tb.P_TOTAL_FRICTION]
            if in_parts:
                store_impulse_of_part(n, total, friction, pose, manifold, contacts.flags[p])
            else:
                manifold[tb.TOTAL_IMPULSE + to] = total
                manifold[tb.FRICTION_IMPULSE + n] = friction
                manifold[tb.WORLD_POINT + to] = pose[tb.X] + manifold[tb.PX + to]
                manifold[tb.WORLD_POINT + to + 1] = pose[tb.Y] + manifold[tb.PY + to]
                if total > 0.0:
                    contacts.flags[p, tb.TOUCHES] |= tb.IS_TOUCHING
            pressing, holding = row[at + tb.P_NORMAL_IMPULSE], row[at + tb.P_TANGENT_IMPULSE]
            if bouncing:
                bounce = n * LANES + m
                if row[tb.FIRST_RESTITUTION + bounce] > 0.0:
                    contacts.flags[p, tb.BOUNCED] = 1
                pressing = max(pressing - row[tb.FIRST_RESTITUTION + bounce], 0.0)
                holding -= row[tb.FIRST_REBOUND_DRAG + bounce]
            manifold[tb.NORMAL_IMPULSE + to], manifold[tb.TANGENT_IMPULSE + to] = pressing, holding
