"""Blocks of lanes: contacts of one colour, whose constraints are solved together.

A block is a row of numbers, `LANES` of each kind; lanes without a contact work on the idle body.
What stays while the arrangement does is written here, once.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.material import mixed_material, runs
from tamias2d.engine.narrow_phase.thickness import contact_extent
from tamias2d.engine.tables import Bodies, Constraints, Contacts, Integers, Shapes, Touching
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array

ALLOWED = 0.005  # of the extent: overlap for which no preload is learnt
WIDTHS = 4.0  # half widths that this extent counts at most


def assign_lanes(touching: Touching, constraints: Constraints) -> int:
    """Give each touching contact its lane, slab by slab; return how many blocks are needed."""
    slabs, sizes = constraints.slabs, constraints.colour_counts[tb.COLOUR_SIZE]
    following = constraints.colour_counts[tb.NEXT_LANE]
    block = 0
    for q in range(constraints.counts[tb.SLABS]):
        slabs[q, tb.S_BLOCK] = block
        for c in range(2 * tb.COLOURS + 2):
            sizes[c] = 0
        for m in range(slabs[q, tb.S_CONTACT], slabs[q + 1, tb.S_CONTACT]):
            sizes[touching.colour[touching.by_slab[m]]] += 1
        for c in range(2 * tb.COLOURS + 2):
            following[c] = block * LANES
            block += sizes[c] if c >= 2 * tb.COLOURS else (sizes[c] + LANES - 1) // LANES
        for m in range(slabs[q, tb.S_CONTACT], slabs[q + 1, tb.S_CONTACT]):
            k = touching.by_slab[m]
            c = touching.colour[k]
            touching.lane[k] = following[c]
            following[c] += LANES if c >= 2 * tb.COLOURS else 1
    slabs[constraints.counts[tb.SLABS], tb.S_BLOCK] = constraints.counts[tb.BLOCKS] = block
    return block


def count_lanes(touching: Touching, constraints: Constraints) -> None:
    """Write how many lanes of each block hold a contact, and how many points each contact has."""
    lanes = constraints.lanes
    for b in range(constraints.counts[tb.BLOCKS]):
        lanes[b, tb.FILLED] = 0
    for k in range(touching.counts[tb.TOUCHING]):
        b, _ = lane_of(k, touching)
        lanes[b, tb.FILLED] = lanes[b, tb.FILLED] + 1
        lanes[b, tb.POINTS] = points_of(k, touching)


def lane_of(k: int, touching: Touching) -> tuple[int, int]:
    """Return the block and the lane of a touching contact."""
    return touching.lane[k] // LANES, touching.lane[k] % LANES


def points_of(k: int, touching: Touching) -> int:
    """Return how many points a touching contact has."""
    return 1 + touching.colour[k] % 2


def clear_lanes(first: int, last: int, idle: int, blocks: Array, lanes: Integers) -> None:
    """Let the lanes of some blocks that hold no contact work on the idle body."""
    for b in range(first, last):
        for m in range(lanes[b, tb.FILLED], LANES):
            lanes[b, tb.BODY_A + m] = lanes[b, tb.BODY_B + m] = idle
            lanes[b, tb.LANE_CONTACT + m] = 0
            for at in range(m, tb.SHARED + tb.POINT_SIZE * lanes[b, tb.POINTS], LANES):
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
        lane[tb.BODY_A + m], lane[tb.BODY_B + m], lane[tb.LANE_CONTACT + m] = (
            i,
            j,
            touching.contact[k],
        )
        row, a_is, b_is = constraints.blocks[b], bodies.properties[i], bodies.properties[j]
        row[tb.R_MASS_A + m], row[tb.R_INERTIA_A + m] = (
            a_is[tb.INVERSE_MASS],
            a_is[tb.INVERSE_INERTIA],
        )
        row[tb.R_MASS_B + m], row[tb.R_INERTIA_B + m] = (
            b_is[tb.INVERSE_MASS],
            b_is[tb.INVERSE_INERTIA],
        )
        s, t = pair[0], pair[1]
        friction, restitution = mixed_material(s, t, shapes.material, shapes.pair_overrides)
        row[tb.R_FRICTION + m], row[tb.R_RESTITUTION + m] = friction, restitution
        row[tb.R_SURFACE_SPEED + m] = 0.0  # or as `run_surfaces` tells
        constraints.counts[tb.RUNNING] += runs(s, t, shapes)
        constraints.counts[tb.BOUNCING] += restitution > 0.0
        row[tb.R_RADIUS_A + m], row[tb.R_RADIUS_B + m] = shapes.radius[s], shapes.radius[t]
        radius = min(shapes.material[s, tb.SHAPE_RADIUS], shapes.material[t, tb.SHAPE_RADIUS])
        row[tb.R_SMALLER_RADIUS + m] = radius
        row[tb.R_ALLOWED + m] = ALLOWED * contact_extent(i, j, radius, WIDTHS, bodies)
