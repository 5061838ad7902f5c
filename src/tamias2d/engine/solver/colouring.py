"""Graph colouring of contacts: those of one colour share no dynamic body, and fill whole blocks.

Each contact takes the first colour that neither of its dynamic bodies has. Contacts with other
bodies have colours of their own, which come last: a stack rests on them. Where colours run out, a
contact gets the colour `COLOURS`, and so a block for itself. Cost: a visit to each contact.
Source: Catto, Box2D v3 (2024).
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Constraints, Contacts, Touching

DYNAMIC_COLOURS = 40  # of contacts between two dynamic bodies, before those with one


def colour_contacts(
    bodies: Bodies, contacts: Contacts, touching: Touching, constraints: Constraints
) -> None:
    """Give each touching contact a colour, those of one point and those of two apart."""
    taken = constraints.body_colours
    for i in range(len(taken)):
        taken[i] = 0
    for k in range(touching.counts[tb.TOUCHING]):
        i, j = touching.body_a[k], touching.body_b[k]
        one, other = bodies.kind[i] == tb.DYNAMIC, bodies.kind[j] == tb.DYNAMIC
        both = (taken[i] if one else 0) | (taken[j] if other else 0)
        colour = 0 if one and other else DYNAMIC_COLOURS
        end = DYNAMIC_COLOURS if one and other else tb.COLOURS
        while colour < end and (both >> colour) & 1:
            colour += 1
        if colour == end:
            colour = tb.COLOURS
        else:
            taken[i] |= 1 << colour
            taken[j] |= 1 << colour
        points = contacts.flags[touching.contact[k], tb.POINT_COUNT]
        touching.colour[k] = 2 * colour + (points - 1)
