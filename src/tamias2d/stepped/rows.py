"""Contacts as rows of blocks: in each block no body appears twice, so that all its lanes are one.

Serves: the solver. Hides: the colours. Each contact takes the first colour that neither of its
moving bodies has yet; contacts of one colour fill blocks of lanes. Where colours run out, a contact
has a block for itself. Contacts with what does not move come last, because a stack rests on them.

Source: Catto, Box2D v3 (2024), for colours; the layout is that of `SIZE` rows of lanes a point.
"""

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
from tamias2d.stepped.layout import (
    BLOCKS,
    BOUNCING,
    COUNT,
    DYNAMIC,
    GAP,
    HIT,
    HIT_A,
    HIT_B,
    HIT_BY_SLAB,
    HIT_COLOUR,
    HIT_PLACE,
    HITS,
    INVERSE_INERTIA,
    INVERSE_MASS,
    IS,
    NOTED,
    NX,
    NY,
    POINT,
    PRELOAD,
    PUSH,
    PX,
    PY,
    RUB,
    SHAPE_REACH,
    SLABS,
    TOTAL,
    TOUCHED,
    WHERE,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.surfaces import surfaces_of

LANES = 16
LINE = 8  # numbers to a line of a cache
MOVING = 40  # colours of contacts between two moving bodies, before those with one
COLOURS = 60
BODY_A, BODY_B, FILLED, POINTS = 0, 16, 32, 33  # columns of a block's lanes

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

# slabs (k, 4): where the touching pairs, the blocks, the moving bodies and the thin islands of each
# stretch begin that is solved in turns
S_HIT, S_BLOCK, S_BODY, S_ISLE = 0, 1, 2, 3

# a block: what its points share, then each point
R_NX, R_NY, R_MASS_A, R_INERTIA_A, R_MASS_B, R_INERTIA_B = 0, 16, 32, 48, 64, 80
R_FRICTION, R_ROUND_A, R_ROUND_B, R_LIMIT, R_RESTITUTION = 96, 112, 128, 144, 160
R_BIAS, R_SHARE, R_KEEP, R_REACH = 176, 192, 208, 224
R_LOAD = R_BIAS  # what softness is made of, before it is there
SHARED = 240
P_ARM_A, P_ARM_B, P_SIDE_A, P_SIDE_B, P_MASS, P_SIDE_MASS = 0, 16, 32, 48, 64, 80
P_GAP, P_PUSH, P_RUB, P_TOTAL, P_BEFORE, P_NOW = 96, 112, 128, 144, 160, 176
SIZE = 192
FIRST, SECOND = SHARED, SHARED + SIZE
WIDTH = SECOND + SIZE


def colour(counts: Whole, trace: Whole, kind: Whole, hits: Whole, used: Whole) -> None:
    """Give each of the touching pairs a colour.

    `used` (n+1,) is for the colours of a body; a colour of two-point contacts follows that of
    one-point contacts.
    """
    for i in range(len(used)):
        used[i] = 0
    for k in range(counts[HITS]):
        p, i, j = hits[HIT, k], hits[HIT_A, k], hits[HIT_B, k]
        one, other = kind[i] == DYNAMIC, kind[j] == DYNAMIC
        taken = (used[i] if one else 0) | (used[j] if other else 0)
        c = 0 if one and other else MOVING
        end = MOVING if one and other else COLOURS
        while c < end and (taken >> c) & 1:
            c += 1
        if c == end:
            c = COLOURS
        else:
            used[i] |= 1 << c
            used[j] |= 1 << c
        hits[HIT_COLOUR, k] = 2 * c + (trace[p, COUNT] - 1)


def give_places(counts: Whole, hits: Whole, fill: Whole, slabs: Whole) -> int:
    """Give each touching pair its place in the blocks; return how many blocks it takes.

    `fill` (2, 128) is for the sizes of the colours of a slab, and where they go on.
    """
    block = 0
    for q in range(counts[SLABS]):
        slabs[q, S_BLOCK] = block
        for c in range(2 * COLOURS + 2):
            fill[0, c] = 0
        for m in range(slabs[q, S_HIT], slabs[q + 1, S_HIT]):
            fill[0, hits[HIT_COLOUR, hits[HIT_BY_SLAB, m]]] += 1
        for c in range(2 * COLOURS + 2):
            fill[1, c] = block * LANES
            block += fill[0, c] if c >= 2 * COLOURS else (fill[0, c] + LANES - 1) // LANES
        for m in range(slabs[q, S_HIT], slabs[q + 1, S_HIT]):
            k = hits[HIT_BY_SLAB, m]
            c = hits[HIT_COLOUR, k]
            hits[HIT_PLACE, k] = fill[1, c]
            fill[1, c] += LANES if c >= 2 * COLOURS else 1
    slabs[counts[SLABS], S_BLOCK] = counts[BLOCKS] = block
    return block


def count_lanes(counts: Whole, hits: Whole, lanes: Whole) -> None:
    """Write how many lanes of each block are taken, and how many points each pair has there."""
    for b in range(counts[BLOCKS]):
        lanes[b, FILLED] = 0
    for k in range(counts[HITS]):
        b, _ = seat_of(k, hits)
        lanes[b, FILLED], lanes[b, POINTS] = lanes[b, FILLED] + 1, 1 + hits[HIT_COLOUR, k] % 2


def clear_lanes(first: int, last: int, idle: int, rows: Array, lanes: Whole) -> None:
    """Let lanes work on the idle body, where blocks are not full."""
    for b in range(first, last):
        for m in range(lanes[b, FILLED], LANES):
            lanes[b, BODY_A + m] = lanes[b, BODY_B + m] = idle
            for at in range(m, SHARED + SIZE * lanes[b, POINTS], LANES):
                rows[b, at] = 0.0


def seat_pairs(
    first: int,
    last: int,
    counts: Whole,
    pair: Whole,
    shape_radius: Array,
    surface: Array,
    mixed: Array,
    body: Array,
    hits: Whole,
    rows: Array,
    lanes: Whole,
) -> None:
    """Give touching pairs, which are listed by slabs, their lanes, with what stays as they do."""
    for at_hit in range(first, last):
        k = hits[HIT_BY_SLAB, at_hit]
        p, i, j = hits[HIT, k], hits[HIT_A, k], hits[HIT_B, k]
        b, m = seat_of(k, hits)
        lanes[b, BODY_A + m], lanes[b, BODY_B + m] = i, j
        row, s, t = rows[b], pair[p, 0], pair[p, 1]
        row[R_MASS_A + m], row[R_INERTIA_A + m] = body[i, INVERSE_MASS], body[i, INVERSE_INERTIA]
        row[R_MASS_B + m], row[R_INERTIA_B + m] = body[j, INVERSE_MASS], body[j, INVERSE_INERTIA]
        friction, restitution = surfaces_of(s, t, surface, mixed)
        row[R_FRICTION + m], row[R_RESTITUTION + m] = friction, restitution
        counts[BOUNCING] += restitution > 0.0
        row[R_ROUND_A + m], row[R_ROUND_B + m] = shape_radius[s], shape_radius[t]
        row[R_REACH + m] = min(surface[s, SHAPE_REACH], surface[t, SHAPE_REACH])


def seat_of(k: int, hits: Whole) -> tuple[int, int]:
    """Return the block and the lane of a touching pair."""
    return hits[HIT_PLACE, k] // LANES, hits[HIT_PLACE, k] % LANES


def fetch_rows(first: int, last: int, rows: Array, lanes: Whole) -> float:
    """Read a number of each line of a cache that blocks take; return their sum.

    A loop that does nothing else has many lines on their way from memory at once.
    """
    total = 0.0
    for b in range(first, last):
        for at in range(0, SHARED + SIZE * lanes[b, POINTS], LINE):
            total += rows[b, at]
    return total


def fetch_touches(first: int, last: int, hits: Whole, touch: Array) -> float:
    """Read a number of each of touching pairs, which are listed by slabs; return their sum."""
    total = 0.0
    for at_hit in range(first, last):
        total += touch[hits[HIT, hits[HIT_BY_SLAB, at_hit]], NX]
    return total


def fill_rows(
    first: int,
    last: int,
    touch: Array,
    pose: Array,
    carried: Array,
    hits: Whole,
    rows: Array,
) -> None:
    """Write how touching pairs touch, which are listed by slabs."""
    for at_hit in range(first, last):
        k = hits[HIT_BY_SLAB, at_hit]
        p, i, j = hits[HIT, k], hits[HIT_A, k], hits[HIT_B, k]
        b, m = seat_of(k, hits)
        points = 1 + hits[HIT_COLOUR, k] % 2
        row, one, other = rows[b], carried[i], carried[j]
        normal = (touch[p, NX], touch[p, NY])
        row[R_NX + m], row[R_NY + m] = normal
        pushes = touch[p, PUSH] + (touch[p, PUSH + POINT] if points == 2 else 0.0)
        row[R_LOAD + m] = pushes / points
        reach = row[R_REACH + m]
        fixed = row[R_MASS_A + m] == 0.0 or row[R_MASS_B + m] == 0.0
        delta_x, delta_y = pose[j, X] - pose[i, X], pose[j, Y] - pose[i, Y]
        for n in range(points):
            at = SHARED + n * SIZE + m
            x, y = touch[p, PX + POINT * n], touch[p, PY + POINT * n]
            arm_a, side_a = turning_arm((x, y), normal), bend((x, y), normal)
            x, y = x - delta_x, y - delta_y
            arm_b, side_b = turning_arm((x, y), normal), bend((x, y), normal)
            gap, preload = touch[p, GAP + POINT * n], 0.0
            if fixed:  # to the surfaces, which meet if they do
                half = 0.5 * max(gap, 0.0)
                side_a, side_b = side_a - half, side_b + half
            row[at + P_ARM_A], row[at + P_SIDE_A] = arm_a, side_a
            row[at + P_ARM_B], row[at + P_SIDE_B] = arm_b, side_b
            if touch[p, PUSH + POINT * n] > 0.0:
                preload = preload_later(
                    touch[p, PRELOAD + POINT * n], gap, LEARNT, ALLOWED * reach, PRELOADED * reach
                )
            touch[p, PRELOAD + POINT * n] = preload
            row[at + P_GAP] = gap - preload
            row[at + P_PUSH] = touch[p, PUSH + POINT * n]
            row[at + P_RUB] = touch[p, RUB + POINT * n]
            row[at + P_TOTAL] = 0.0
            if row[R_RESTITUTION + m] > 0.0:
                row[at + P_BEFORE] = row_velocity(
                    (one[NOTED], one[NOTED + 1]),
                    one[NOTED + 2],
                    arm_a,
                    (other[NOTED], other[NOTED + 1]),
                    other[NOTED + 2],
                    arm_b,
                    normal,
                )


def finish_rows(first: int, last: int, substep: float, rows: Array, lanes: Whole) -> None:
    """Write the masses that impulses meet, and how soft contacts are, lane by lane."""
    for b in range(first, last):
        row = rows[b]
        soften_lanes(row, substep)
        weigh_lanes(FIRST, row)
        if lanes[b, POINTS] == 2:
            weigh_lanes(SECOND, row)


def weigh_lanes(at: int, row: Array) -> None:
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


def soften_lanes(row: Array, substep: float) -> None:
    """Write how soft contacts are: as little as their loads need to press them in by `REST`.

    The load is that of a point in the last substep, N s. What is firmer than `FIRMEST` allows would
    shake under the load of a deep pile, whose contacts are not all solved in one substep.
    """
    for m in range(LANES):
        a, b = row[R_MASS_A + m], row[R_MASS_B + m]
        frequency = CIRCLE * CYCLES / substep
        frequency = frequency if (a > 0.0) & (b > 0.0) else FIRMER * frequency
        reach = row[R_REACH + m] if row[R_REACH + m] > 0.0 else 1.0  # 0 in an idle lane
        frequency = angular_frequency_loaded(
            frequency, row[R_LOAD + m], a, b, substep, REST, reach, FIRMEST
        )
        row[R_BIAS + m] = bias_rate(frequency, DAMPING, substep)
        row[R_SHARE + m] = mass_share(frequency, DAMPING, substep)
        row[R_KEEP + m] = impulse_share(frequency, DAMPING, substep)
        row[R_LIMIT + m] = bias_velocity_least(FASTEST, reach, substep)


def keep_impulses(
    first: int,
    last: int,
    pose: Array,
    hits: Whole,
    rows: Array,
    touch: Array,
    trace: Whole,
) -> None:
    """Write impulses back to pairs, which are listed by slabs, with where they were.

    What was pushed touched.
    """
    for at_hit in range(first, last):
        k = hits[HIT_BY_SLAB, at_hit]
        p, i = hits[HIT, k], hits[HIT_A, k]
        b, m = seat_of(k, hits)
        for n in range(1 + hits[HIT_COLOUR, k] % 2):
            at = SHARED + n * SIZE + m
            touch[p, TOTAL + POINT * n] = rows[b, at + P_TOTAL]
            touch[p, WHERE + POINT * n] = pose[i, X] + touch[p, PX + POINT * n]
            touch[p, WHERE + POINT * n + 1] = pose[i, Y] + touch[p, PY + POINT * n]
            if rows[b, at + P_TOTAL] > 0.0:
                trace[p, TOUCHED] |= IS
            touch[p, PUSH + POINT * n] = rows[b, at + P_PUSH]
            touch[p, RUB + POINT * n] = rows[b, at + P_RUB]
