"""The arrangement of contacts: slabs, blocks, thin islands, and which bodies take part.

Serves: a step. Hides: that all of it stays from step to step while the same pairs touch.
"""

from tamias2d.engine.broad_phase.pairs import DONE, MORE_BLOCKS, MORE_SPARSE
from tamias2d.engine.direct.contact_tree import number_trees, plan_elimination
from tamias2d.engine.solver.constraints import assign_lanes, colour, count_lanes
from tamias2d.engine.solver.slabs import divide_into_slabs
from tamias2d.engine.tables import (
    ACTIVE,
    ARRANGED,
    BOUNCING,
    KINEMATIC,
    LANES_FILLED,
    ROWS_NEEDED,
    TOUCHING,
    TREES,
    Bodies,
    Constraints,
    Contacts,
    Control,
    Direct,
    Touching,
)


def arrange(
    control: Control,
    bodies: Bodies,
    contacts: Contacts,
    touching: Touching,
    constraints: Constraints,
    direct: Direct,
) -> int:
    """Arrange what touches, and mark the bodies that take part; or say what has too little room."""
    if touching.counts[ARRANGED] == 1:
        for k in range(constraints.counts[ACTIVE]):
            bodies.moved[touching.active[k]] = 1
        return DONE
    colour(bodies, contacts, touching, constraints)
    mark_active(bodies, touching, constraints)
    tree_count = number_trees(bodies, touching, direct)
    if tree_count >= 0:
        divide_into_slabs(tree_count, bodies, touching, constraints, direct)
        needed = assign_lanes(touching, constraints)
        if needed > len(constraints.blocks):
            control.counts[ROWS_NEEDED] = needed
            return MORE_BLOCKS
        tree_count = plan_elimination(tree_count, bodies, touching, direct)
    if tree_count < 0:
        control.counts[ROWS_NEEDED] = -tree_count
        return MORE_SPARSE
    direct.counts[TREES] = tree_count
    count_lanes(touching, constraints)
    touching.counts[ARRANGED], constraints.counts[LANES_FILLED], constraints.counts[BOUNCING] = (
        1,
        0,
        0,
    )
    return DONE


def mark_active(bodies: Bodies, touching: Touching, constraints: Constraints) -> None:
    """List the moving bodies that have contacts, in the order of touching.

    Their colours, which are not needed any more, become marks.
    """
    for i in range(len(bodies.moved)):
        bodies.moved[i] = 0
    active = 0
    for k in range(touching.counts[TOUCHING]):
        for i in (touching.body_a[k], touching.body_b[k]):
            if bodies.moved[i] == 0 and bodies.kind[i] >= KINEMATIC:
                bodies.moved[i] = 1
                touching.active[active] = i
                active += 1
    constraints.counts[ACTIVE] = active
