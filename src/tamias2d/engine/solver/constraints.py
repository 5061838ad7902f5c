"""Contacts as rows of blocks: in each block no body appears twice, so that all its lanes are one.

Serves: the solver. Hides: the colours. Each contact takes the first colour that neither of its
moving bodies has yet; contacts of one colour fill blocks of lanes. Where colours run out, a contact
has a block for itself. Contacts with what does not move come last, because a stack rests on them.

Source: Catto, Box2D v3 (2024), for colours; the layout is that of `SIZE` rows of lanes a point.
"""

from tamias2d.engine.narrow_phase.material import mixed_material
from tamias2d.engine.tables import (
    BLOCKS,
    BODY_A,
    BODY_B,
    BOUNCING,
    COLOURS,
    DYNAMIC,
    FILLED,
    FIRST,
    GAP,
    INVERSE_INERTIA,
    INVERSE_MASS,
    IS_TOUCHING,
    LANES,
    NORMAL_IMPULSE,
    NX,
    NY,
    P_APPROACH,
    P_ARM_A,
    P_ARM_B,
    P_GAP,
    P_MASS,
    P_NORMAL,
    P_SIDE_A,
    P_SIDE_B,
    P_SIDE_MASS,
    P_TANGENT,
    P_TOTAL,
    POINT,
    POINT_COUNT,
    POINTS,
    PRELOAD,
    PX,
    PY,
    R_BIAS,
    R_FRICTION,
    R_INERTIA_A,
    R_INERTIA_B,
    R_KEEP,
    R_LIMIT,
    R_MASS_A,
    R_MASS_B,
    R_NX,
    R_NY,
    R_RADIUS,
    R_RESTITUTION,
    R_ROUND_A,
    R_ROUND_B,
    R_SHARE,
    S_BLOCK,
    S_CONTACT,
    SECOND,
    SHAPE_RADIUS,
    SHARED,
    SIZE,
    SLABS,
    SUBSTEP_START,
    TANGENT_IMPULSE,
    TOTAL_IMPULSE,
    TOUCHES,
    TOUCHING,
    WORLD_POINT,
    Bodies,
    Constraints,
    Contacts,
    Integers,
    Shapes,
    Touching,
    X,
    Y,
)
from tamias2d.generated.soft_contact import (
    angular_frequency_loaded,
    bend,
    bias_rate,
    bias_velocity_least,
    impulse_share,
    mass_share,
    preload_later,
    row_mass,
    row_velocity,
    turning_arm,
)
from tamias2d.state import Array

LINE = 8  # numbers to a line of a cache
MOVING = 40  # colours of contacts between two moving bodies, before those with one

CIRCLE = 6.283185307179586
CYCLES = 0.125  # of a contact's spring, in one substep
FIRMER = 2.0  # the spring against what does not move, to the others
FIRMEST = 3.0  # a spring under load, to one without
DAMPING = 10.0  # of the spring, where 1 is critical
REST = 0.015  # of the smaller reach: how far a load should press bodies into each other
LEARNT = 0.02  # of a step's overlap, by the preload
ALLOWED = 0.005  # of the smaller reach: an overlap for which no preload is learnt
PRELOADED = 0.2  # of the smaller reach: a preload, at most
FASTEST = 0.02  # of the smaller reach: how far an overlap is pushed apart in a substep, at most


def colour(
    bodies: Bodies, contacts: Contacts, touching: Touching, constraints: Constraints
) -> None:
    """Give each of the touching pairs a colour.

    `used` (n+1,) is for the colours of a body; a colour of two-point contacts follows that of
    one-point contacts.
    """
    for i in range(len(constraints.body_colours)):
        constraints.body_colours[i] = 0
    for k in range(touching.counts[TOUCHING]):
        p, i, j = touching.contact[k], touching.body_a[k], touching.body_b[k]
        one, other = bodies.kind[i] == DYNAMIC, bodies.kind[j] == DYNAMIC
        taken = (constraints.body_colours[i] if one else 0) | (
            constraints.body_colours[j] if other else 0
        )
        c = 0 if one and other else MOVING
        end = MOVING if one and other else COLOURS
        while c < end and (taken >> c) & 1:
            c += 1
        if c == end:
            c = COLOURS
        else:
            constraints.body_colours[i] |= 1 << c
            constraints.body_colours[j] |= 1 << c
        touching.colour[k] = 2 * c + (contacts.flags[p, POINT_COUNT] - 1)


def assign_lanes(touching: Touching, constraints: Constraints) -> int:
    """Give each touching pair its place in the blocks; return how many blocks it takes.

    `fill` (2, 128) is for the sizes of the colours of a slab, and where they go on.
    """
    block = 0
    for q in range(constraints.counts[SLABS]):
        constraints.slabs[q, S_BLOCK] = block
        for c in range(2 * COLOURS + 2):
            constraints.colour_counts[0, c] = 0
        for m in range(constraints.slabs[q, S_CONTACT], constraints.slabs[q + 1, S_CONTACT]):
            constraints.colour_counts[0, touching.colour[touching.by_slab[m]]] += 1
        for c in range(2 * COLOURS + 2):
            constraints.colour_counts[1, c] = block * LANES
            block += (
                constraints.colour_counts[0, c]
                if c >= 2 * COLOURS
                else (constraints.colour_counts[0, c] + LANES - 1) // LANES
            )
        for m in range(constraints.slabs[q, S_CONTACT], constraints.slabs[q + 1, S_CONTACT]):
            k = touching.by_slab[m]
            c = touching.colour[k]
            touching.lane[k] = constraints.colour_counts[1, c]
            constraints.colour_counts[1, c] += LANES if c >= 2 * COLOURS else 1
    constraints.slabs[constraints.counts[SLABS], S_BLOCK] = constraints.counts[BLOCKS] = block
    return block


def count_lanes(touching: Touching, constraints: Constraints) -> None:
    """Write how many lanes of each block are taken, and how many points each pair has there."""
    for b in range(constraints.counts[BLOCKS]):
        constraints.lanes[b, FILLED] = 0
    for k in range(touching.counts[TOUCHING]):
        b, _ = lane_of(k, touching)
        constraints.lanes[b, FILLED], constraints.lanes[b, POINTS] = (
            constraints.lanes[b, FILLED] + 1,
            1 + touching.colour[k] % 2,
        )


def clear_lanes(first: int, last: int, idle: int, blocks: Array, lanes: Integers) -> None:
    """Let lanes work on the idle body, where blocks are not full."""
    for b in range(first, last):
        for m in range(lanes[b, FILLED], LANES):
            lanes[b, BODY_A + m] = lanes[b, BODY_B + m] = idle
            for at in range(m, SHARED + SIZE * lanes[b, POINTS], LANES):
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
    """Give touching pairs, which are listed by slabs, their lanes, with what stays as they do."""
    for at_hit in range(first, last):
        k = touching.by_slab[at_hit]
        p, i, j = touching.contact[k], touching.body_a[k], touching.body_b[k]
        b, m = lane_of(k, touching)
        constraints.lanes[b, BODY_A + m], constraints.lanes[b, BODY_B + m] = i, j
        row, s, t = constraints.blocks[b], contacts.pairs[p, 0], contacts.pairs[p, 1]
        row[R_MASS_A + m], row[R_INERTIA_A + m] = (
            bodies.properties[i, INVERSE_MASS],
            bodies.properties[i, INVERSE_INERTIA],
        )
        row[R_MASS_B + m], row[R_INERTIA_B + m] = (
            bodies.properties[j, INVERSE_MASS],
            bodies.properties[j, INVERSE_INERTIA],
        )
        friction, restitution = mixed_material(s, t, shapes.material, shapes.pair_overrides)
        row[R_FRICTION + m], row[R_RESTITUTION + m] = friction, restitution
        constraints.counts[BOUNCING] += restitution > 0.0
        row[R_ROUND_A + m], row[R_ROUND_B + m] = shapes.radius[s], shapes.radius[t]
        row[R_RADIUS + m] = min(shapes.material[s, SHAPE_RADIUS], shapes.material[t, SHAPE_RADIUS])


def lane_of(k: int, touching: Touching) -> tuple[int, int]:
    """Return the block and the lane of a touching pair."""
    return touching.lane[k] // LANES, touching.lane[k] % LANES


def prefetch_blocks(first: int, last: int, blocks: Array, lanes: Integers) -> float:
    """Read a number of each line of a cache that blocks take; return their sum.

    A loop that does nothing else has many lines on their way from memory at once.
    """
    total = 0.0
    for b in range(first, last):
        for at in range(0, SHARED + SIZE * lanes[b, POINTS], LINE):
            total += blocks[b, at]
    return total


def prefetch_manifolds(first: int, last: int, contacts: Contacts, touching: Touching) -> float:
    """Read a number of each of touching pairs, which are listed by slabs; return their sum."""
    total = 0.0
    for at_hit in range(first, last):
        total += contacts.manifolds[touching.contact[touching.by_slab[at_hit]], NX]
    return total


def fill_blocks(
    first: int,
    last: int,
    bodies: Bodies,
    contacts: Contacts,
    touching: Touching,
    constraints: Constraints,
) -> None:
    """Write how touching pairs touch, which are listed by slabs."""
    for at_hit in range(first, last):
        k = touching.by_slab[at_hit]
        p, i, j = touching.contact[k], touching.body_a[k], touching.body_b[k]
        b, m = lane_of(k, touching)
        points = 1 + touching.colour[k] % 2
        row, one, other = constraints.blocks[b], bodies.substep_state[i], bodies.substep_state[j]
        normal = (contacts.manifolds[p, NX], contacts.manifolds[p, NY])
        row[R_NX + m], row[R_NY + m] = normal
        reach = row[R_RADIUS + m]
        fixed = row[R_MASS_A + m] == 0.0 or row[R_MASS_B + m] == 0.0
        delta_x, delta_y = (
            bodies.pose[j, X] - bodies.pose[i, X],
            bodies.pose[j, Y] - bodies.pose[i, Y],
        )
        for n in range(points):
            at = SHARED + n * SIZE + m
            x, y = contacts.manifolds[p, PX + POINT * n], contacts.manifolds[p, PY + POINT * n]
            arm_a, side_a = turning_arm((x, y), normal), bend((x, y), normal)
            x, y = x - delta_x, y - delta_y
            arm_b, side_b = turning_arm((x, y), normal), bend((x, y), normal)
            gap, preload = contacts.manifolds[p, GAP + POINT * n], 0.0
            if fixed:  # to the surfaces, which meet if they do
                half = 0.5 * max(gap, 0.0)
                side_a, side_b = side_a - half, side_b + half
            row[at + P_ARM_A], row[at + P_SIDE_A] = arm_a, side_a
            row[at + P_ARM_B], row[at + P_SIDE_B] = arm_b, side_b
            if contacts.manifolds[p, NORMAL_IMPULSE + POINT * n] > 0.0:
                preload = preload_later(
                    contacts.manifolds[p, PRELOAD + POINT * n],
                    gap,
                    LEARNT,
                    ALLOWED * reach,
                    PRELOADED * reach,
                )
            contacts.manifolds[p, PRELOAD + POINT * n] = preload
            row[at + P_GAP] = gap - preload
            row[at + P_NORMAL] = contacts.manifolds[p, NORMAL_IMPULSE + POINT * n]
            row[at + P_TANGENT] = contacts.manifolds[p, TANGENT_IMPULSE + POINT * n]
            row[at + P_TOTAL] = 0.0
            if row[R_RESTITUTION + m] > 0.0:
                row[at + P_APPROACH] = row_velocity(
                    (one[SUBSTEP_START], one[SUBSTEP_START + 1]),
                    one[SUBSTEP_START + 2],
                    arm_a,
                    (other[SUBSTEP_START], other[SUBSTEP_START + 1]),
                    other[SUBSTEP_START + 2],
                    arm_b,
                    normal,
                )


def prepare_blocks(first: int, last: int, substep: float, blocks: Array, lanes: Integers) -> None:
    """Write the masses that impulses meet, and how soft contacts are, lane by lane."""
    for b in range(first, last):
        row = blocks[b]
        soften_lanes(row, lanes[b, POINTS], substep)
        effective_mass_lanes(FIRST, row)
        if lanes[b, POINTS] == 2:
            effective_mass_lanes(SECOND, row)


def effective_mass_lanes(at: int, row: Array) -> None:
    """Write the masses that impulses along normal and tangent meet; 0 in an idle lane."""
    for m in range(LANES):
        a, b = row[R_MASS_A + m], row[R_MASS_B + m]
        turn_a, turn_b = row[R_INERTIA_A + m], row[R_INERTIA_B + m]
        idle = a + b == 0.0
        b = 1.0 if idle else b
        mass = row_mass(a, turn_a, row[at + P_ARM_A + m], b, turn_b, row[at + P_ARM_B + m])
        side = row_mass(a, turn_a, row[at + P_SIDE_A + m], b, turn_b, row[at + P_SIDE_B + m])
        row[at + P_MASS + m] = 0.0 if idle else mass
        row[at + P_SIDE_MASS + m] = 0.0 if idle else side


def soften_lanes(row: Array, points: int, substep: float) -> None:
    """Write how soft contacts are: as little as their loads need to press them in by `REST`.

    The load is that of a point in the last substep, N s. What is firmer than `FIRMEST` allows would
    shake under the load of a deep pile, whose contacts are not all solved in one substep.
    """
    for m in range(LANES):
        a, b = row[R_MASS_A + m], row[R_MASS_B + m]
        other = row[SECOND + P_NORMAL + m] if points == 2 else 0.0
        load = (row[FIRST + P_NORMAL + m] + other) / points
        frequency = CIRCLE * CYCLES / substep
        frequency = frequency if (a > 0.0) & (b > 0.0) else FIRMER * frequency
        reach = row[R_RADIUS + m] if row[R_RADIUS + m] > 0.0 else 1.0  # 0 in an idle lane
        frequency = angular_frequency_loaded(frequency, load, a, b, substep, REST, reach, FIRMEST)
        row[R_BIAS + m] = bias_rate(frequency, DAMPING, substep)
        row[R_SHARE + m] = mass_share(frequency, DAMPING, substep)
        row[R_KEEP + m] = impulse_share(frequency, DAMPING, substep)
        row[R_LIMIT + m] = bias_velocity_least(FASTEST, reach, substep)


def store_impulses(
    first: int,
    last: int,
    bodies: Bodies,
    contacts: Contacts,
    touching: Touching,
    constraints: Constraints,
) -> None:
    """Write impulses back to pairs, which are listed by slabs, with where they were.

    What was pushed touched.
    """
    for at_hit in range(first, last):
        k = touching.by_slab[at_hit]
        p, i = touching.contact[k], touching.body_a[k]
        b, m = lane_of(k, touching)
        for n in range(1 + touching.colour[k] % 2):
            at = SHARED + n * SIZE + m
            contacts.manifolds[p, TOTAL_IMPULSE + POINT * n] = constraints.blocks[b, at + P_TOTAL]
            contacts.manifolds[p, WORLD_POINT + POINT * n] = (
                bodies.pose[i, X] + contacts.manifolds[p, PX + POINT * n]
            )
            contacts.manifolds[p, WORLD_POINT + POINT * n + 1] = (
                bodies.pose[i, Y] + contacts.manifolds[p, PY + POINT * n]
            )
            if constraints.blocks[b, at + P_TOTAL] > 0.0:
                contacts.flags[p, TOUCHES] |= IS_TOUCHING
            contacts.manifolds[p, NORMAL_IMPULSE + POINT * n] = constraints.blocks[b, at + P_NORMAL]
            contacts.manifolds[p, TANGENT_IMPULSE + POINT * n] = constraints.blocks[
                b, at + P_TANGENT
            ]
