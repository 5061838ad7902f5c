"""Blocks of lanes: contacts of one colour, whose constraints are solved together.

A block is a row of numbers, `LANES` of each kind; lanes without a contact work on the idle body.
What stays while the arrangement does is written here, once.
"""

from tamias2d.engine.narrow_phase.material import mixed_material
from tamias2d.engine.tables import (
    BLOCKS,
    BODY_A,
    BODY_B,
    BOUNCING,
    COLOUR_SIZE,
    COLOURS,
    FILLED,
    INVERSE_INERTIA,
    INVERSE_MASS,
    LANE_CONTACT,
    NEXT_LANE,
    POINT_SIZE,
    POINTS,
    R_ALLOWED,
    R_FRICTION,
    R_INERTIA_A,
    R_INERTIA_B,
    R_MASS_A,
    R_MASS_B,
    R_RADIUS_A,
    R_RADIUS_B,
    R_RESTITUTION,
    R_SMALLER_RADIUS,
    S_BLOCK,
    S_CONTACT,
    SHAPE_RADIUS,
    SHARED,
    SLABS,
    TOUCHING,
    Bodies,
    Constraints,
    Contacts,
    Integers,
    Shapes,
    Touching,
)
from tamias2d.engine.thickness import contact_extent
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array

ALLOWED = 0.005  # of the extent: overlap for which no preload is learnt
WIDTHS = 4.0  # half widths that this extent counts at most


def assign_lanes(touching: Touching, constraints: Constraints) -> int:
    """Give each touching contact its lane, slab by slab; return how many blocks are needed."""
    slabs, sizes = constraints.slabs, constraints.colour_counts[COLOUR_SIZE]
    following = constraints.colour_counts[NEXT_LANE]
    block = 0
    for q in range(constraints.counts[SLABS]):
        slabs[q, S_BLOCK] = block
        for c in range(2 * COLOURS + 2):
            sizes[c] = 0
        for m in range(slabs[q, S_CONTACT], slabs[q + 1, S_CONTACT]):
            sizes[touching.colour[touching.by_slab[m]]] += 1
        for c in range(2 * COLOURS + 2):
            following[c] = block * LANES
            block += sizes[c] if c >= 2 * COLOURS else (sizes[c] + LANES - 1) // LANES
        for m in range(slabs[q, S_CONTACT], slabs[q + 1, S_CONTACT]):
            k = touching.by_slab[m]
            c = touching.colour[k]
            touching.lane[k] = following[c]
            following[c] += LANES if c >= 2 * COLOURS else 1
    slabs[constraints.counts[SLABS], S_BLOCK] = constraints.counts[BLOCKS] = block
    return block


def count_lanes(touching: Touching, constraints: Constraints) -> None:
    """Write how many lanes of each block hold a contact, and how many points each contact has."""
    lanes = constraints.lanes
    for b in range(constraints.counts[BLOCKS]):
        lanes[b, FILLED] = 0
    for k in range(touching.counts[TOUCHING]):
        b, _ = lane_of(k, touching)
        lanes[b, FILLED] = lanes[b, FILLED] + 1
        lanes[b, POINTS] = points_of(k, touching)


def lane_of(k: int, touching: Touching) -> tuple[int, int]:
    """Return the block and the lane of a touching contact."""
    return touching.lane[k] // LANES, touching.lane[k] % LANES


def points_of(k: int, touching: Touching) -> int:
    """Return how many points a touching contact has."""
    return 1 + touching.colour[k] % 2


def clear_lanes(first: int, last: int, idle: int, blocks: Array, lanes: Integers) -> None:
    """Let the lanes of some blocks that hold no contact work on the idle body."""
    for b in range(first, last):
        for m in range(lanes[b, FILLED], LANES):
            lanes[b, BODY_A + m] = lanes[b, BODY_B + m] = idle
            lanes[b, LANE_CONTACT + m] = 0
            for at in range(m, SHARED + POINT_SIZE * lanes[b, POINTS], LANES):
                blocks[b, at] = 0.0


def fill_lanes(
    first: int,
    last: int,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    touching: Touching,
    constraints: Constraints,
) -> None:
    """Write bodies, masses and materials of touching contacts, which are listed by slabs."""
    for place in range(first, last):
        k = touching.by_slab[place]
        i, j, pair = touching.body_a[k], touching.body_b[k], contacts.pairs[touching.contact[k]]
        b, m = lane_of(k, touching)
        lane = constraints.lanes[b]
        lane[BODY_A + m], lane[BODY_B + m], lane[LANE_CONTACT + m] = i, j, touching.contact[k]
        row, a_is, b_is = constraints.blocks[b], bodies.properties[i], bodies.properties[j]
        row[R_MASS_A + m], row[R_INERTIA_A + m] = a_is[INVERSE_MASS], a_is[INVERSE_INERTIA]
        row[R_MASS_B + m], row[R_INERTIA_B + m] = b_is[INVERSE_MASS], b_is[INVERSE_INERTIA]
        s, t = pair[0], pair[1]
        friction, restitution = mixed_material(s, t, shapes.material, shapes.pair_overrides)
        row[R_FRICTION + m], row[R_RESTITUTION + m] = friction, restitution
        constraints.counts[BOUNCING] += restitution > 0.0
        row[R_RADIUS_A + m], row[R_RADIUS_B + m] = shapes.radius[s], shapes.radius[t]
        radius = min(shapes.material[s, SHAPE_RADIUS], shapes.material[t, SHAPE_RADIUS])
        row[R_SMALLER_RADIUS + m] = radius
        row[R_ALLOWED + m] = ALLOWED * contact_extent(i, j, radius, WIDTHS, bodies)
