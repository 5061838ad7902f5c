"""Parts of a step in which bodies that touch turn so far that they go deep into each other.

The solver keeps the points and the normal that contacts have as a part begins, or as their shapes
meet. Where an impact lets a body turn fast, other corners come up, and the normal turns: then the
part is taken again as shorter ones. So is one in which joints and contacts disagree. Cost: the gap
of each contact whose bodies turn far, twice.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.events import closing_at_points, manifold_at
from tamias2d.engine.continuous.passing import smaller_radius, turn_shape_to
from tamias2d.engine.energy.joined_gains import joints_disagree
from tamias2d.engine.joints.unforeseen import meets_unforeseen
from tamias2d.engine.narrow_phase.manifold import smallest_gap
from tamias2d.engine.narrow_phase.polygon import held_normal
from tamias2d.engine.parts import OF_ALL
from tamias2d.engine.tables import Bodies, Contacts, Shapes, World

TURNED_FAR = 0.05  # rad, that bodies in contact turn in a part
DEEPER = 0.02  # of the smaller radius: how much an overlap may grow
FINEST_LEVEL = 3  # of the parts that are taken for this


def overshoots(world: World, contacts: Contacts) -> bool:
    """Return whether contacts get deep in a part that may be taken again in shorter ones."""
    control, bodies, shapes = world.control, world.bodies, world.shapes
    touching, events = world.touching, world.events
    again = False
    again = meets_unforeseen(again, world, contacts)
    if again or control.counts[tb.LEVEL] >= FINEST_LEVEL:
        return again
    again = joints_disagree(again, world)
    if again:
        return True
    found = 0
    for k in range(touching.counts[tb.TOUCHING]):
        p, i, j = touching.contact[k], touching.body_a[k], touching.body_b[k]
        s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
        if turn_of(s, i, bodies, shapes) + turn_of(t, j, bodies, shapes) <= TURNED_FAR:
            continue
        gap = smallest_gap(contacts.manifolds[p], contacts.flags[p, tb.POINT_COUNT])
        reach = smaller_radius(s, t, shapes.material)
        deepest = min(gap, 0.0) - DEEPER * reach
        if gap - closing_at_points(p, i, j, reach, bodies, contacts) < deepest:
            held = held_normal(contacts.manifolds[p], contacts.flags[p])
            gap = manifold_at(s, t, 1.0, held, bodies, shapes, events)
            turn_shape_to(s, i, 0.0, bodies, shapes)
            turn_shape_to(t, j, 0.0, bodies, shapes)
            found += 1 if gap < deepest else 0
    return found > world.broad_phase.counts[tb.CONTACTS] // OF_ALL


def turn_of(s: int, i: int, bodies: Bodies, shapes: Shapes) -> float:
    """Return by which angle the body of a shape turns in a part, rad; 0 for a disc."""
    return abs(bodies.motion[i, tb.DANGLE]) if shapes.vertex_count[s] > 1 else 0.0
