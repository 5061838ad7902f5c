"""The arrangement of touching contacts: colours, slabs, blocks of lanes, and tree-like islands.

It stays from step to step while the same contacts touch.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.direct.contact_tree import number_trees
from tamias2d.engine.direct.elimination import plan_elimination
from tamias2d.engine.energy.angular_momentum import count_free_islands, mark_held_islands
from tamias2d.engine.joints.activity import activate_joined, hold_tied, join_slabs
from tamias2d.engine.solver.blocks import assign_lanes, count_lanes
from tamias2d.engine.solver.colouring import colour_contacts
from tamias2d.engine.solver.slabs import divide_into_slabs
from tamias2d.engine.springs.substep import activate_touched
from tamias2d.engine.tables import Bodies, Constraints, Contacts, Touching, World


def arrange(world: World, contacts: Contacts) -> int:
    """Arrange the contacts that touch, and mark active bodies; return which array is too short."""
    control, bodies, touching = world.control, world.bodies, world.touching
    constraints, direct = world.constraints, world.direct
    if touching.counts[tb.ARRANGED] == 1:
        for k in range(constraints.counts[tb.ACTIVE]):
            bodies.moved[touching.active[k]] = 1
        return tb.DONE
    colour_contacts(bodies, contacts, touching, constraints)
    list_active(bodies, touching, constraints)
    if world.springs.counts[tb.SPRINGS] > 0:
        activate_touched(bodies, touching, constraints, world.springs)
    activate_joined(world)
    tree_count = number_trees(bodies, touching, direct)
    if tree_count >= 0:
        one_slab = world.springs.counts[tb.NETWORKS_TOUCHED] > 0
        divide_into_slabs(tree_count, one_slab, bodies, touching, constraints, direct)
        join_slabs(tree_count, world)
        needed = assign_lanes(touching, constraints)
        if needed > len(constraints.blocks):
            control.counts[tb.ROWS_NEEDED] = needed
            return tb.MORE_BLOCKS
        tree_count = plan_elimination(tree_count, bodies, touching, direct)
    if tree_count < 0:
        control.counts[tb.ROWS_NEEDED] = -tree_count
        return tb.MORE_SPARSE
    direct.counts[tb.TREES] = tree_count
    count_lanes(touching, constraints)
    mark_held_islands(bodies, touching, constraints, world.islands, world.joints)
    hold_tied(world.islands, world.joints)
    count_free_islands(bodies, touching, constraints, world.islands)
    touching.counts[tb.ARRANGED] = 1
    counts = constraints.counts
    counts[tb.LANES_FILLED] = counts[tb.BOUNCING] = counts[tb.RUNNING] = 0
    return tb.DONE


def list_active(bodies: Bodies, touching: Touching, constraints: Constraints) -> None:
    """List and mark the moving bodies that have contacts, in the order of touching."""
    for i in range(len(bodies.moved)):
        bodies.moved[i] = 0
    active = 0
    for k in range(touching.counts[tb.TOUCHING]):
        for i in (touching.body_a[k], touching.body_b[k]):
            if bodies.moved[i] == 0 and bodies.kind[i] >= tb.KINEMATIC:
                bodies.moved[i] = 1
                touching.active[active] = i
                active += 1
    constraints.counts[tb.ACTIVE] = active
