"""The substeps of all bodies with contacts.

Serves: a step. Hides: that what contacts did before is carried by bodies, so that each contact is
visited twice in a substep, and once more as the step begins.
"""

from tamias2d.generated.definitions import acceleration, angular_acceleration
from tamias2d.state import Array
from tamias2d.stepped.direct import (
    ready,
    settle_islands,
)
from tamias2d.stepped.energy import (
    bound_energy,
    makes_energy,
    note_velocities,
)
from tamias2d.stepped.islands import (
    find_islands,
)
from tamias2d.stepped.layout import (
    ACTIVE,
    ANGULAR,
    BLOCKS,
    DECAY,
    DTURN,
    DX,
    DY,
    DYNAMIC,
    EARLIER,
    GAIN,
    GRAVITY_X,
    GRAVITY_Y,
    HITS,
    INVERSE_INERTIA,
    INVERSE_MASS,
    KINEMATIC,
    SPIN,
    SUB,
    SUBSTEPS,
    THIN,
    TIME_STEP,
    UNBOUNCED,
    VX,
    VY,
    Whole,
)
from tamias2d.stepped.solver import (
    bounce,
    relax,
    sweep,
    warm,
)


def solve(
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    kind: Whole,
    used: Whole,
    pair: Whole,
    shape_body: Whole,
    hits: Whole,
    rows: Array,
    lanes: Whole,
    bench: Array,
    carried: Array,
    island: Whole,
    energy: Array,
    bouncing: int,
    web: Whole,
    weave: Array,
) -> None:
    """Take the substeps of all bodies with contacts, and let them bounce."""
    active = mark_active(counts, kind, used, pair, shape_body, hits)
    if active == 0:
        return
    substeps = counts[SUBSTEPS]
    blocks = counts[BLOCKS]
    substep = settings[TIME_STEP] / substeps
    ready(counts[THIN], body, rows, lanes, web, weave)
    note_velocities(EARLIER, counts, motion, hits, energy)
    begin(counts, motion, carried, hits)
    warm(blocks, rows, lanes, motion, bench)
    carry(counts, motion, carried, hits)
    back(counts, motion, carried, hits)
    for _ in range(substeps):
        hasten(settings, counts, motion, load, body, kind, hits, carried)
        settle_islands(False, substep, counts, rows, lanes, motion, web, weave)
        sweep(blocks, rows, lanes, motion, bench, substep)
        shift(substep, counts, motion, hits)
        settle_islands(True, substep, counts, rows, lanes, motion, web, weave)
        relax(blocks, rows, lanes, motion, bench, substep)
        carry(counts, motion, carried, hits)
    slowest = 2.0 * settings[TIME_STEP] * (abs(settings[GRAVITY_X]) + abs(settings[GRAVITY_Y]))
    if bouncing > 0 or makes_energy(settings, counts, motion, load, body, kind, hits, energy):
        if bouncing > 0:
            note_velocities(UNBOUNCED, counts, motion, hits, energy)
            bounce(blocks, rows, lanes, motion, bench, slowest)
        find_islands(counts, pair, shape_body, kind, hits, island)
        bound_energy(
            settings, counts, pose, motion, load, body, kind, pair, shape_body, hits, island,
            energy, rows, lanes, bouncing,
        )  # fmt: skip


def begin(counts: Whole, motion: Array, carried: Array, hits: Whole) -> None:
    """Note the velocities before the impulses of the last step are applied again."""
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        for n in range(3):
            carried[i, n] = 0.0
            carried[i, 3 + n] = motion[i, n]


def carry(counts: Whole, motion: Array, carried: Array, hits: Whole) -> None:
    """Add what contacts have changed in the velocities to what the next substep starts with.

    Impulses add up, so this is what applying each of them again would do.
    """
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        for n in range(3):
            carried[i, n] += motion[i, n] - carried[i, 3 + n]


def back(counts: Whole, motion: Array, carried: Array, hits: Whole) -> None:
    """Go back to the velocities that were noted."""
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        for n in range(3):
            motion[i, n] = carried[i, 3 + n]


def shift(substep: float, counts: Whole, motion: Array, hits: Whole) -> None:
    """Move bodies along for a substep, s."""
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        motion[i, DX] += substep * motion[i, VX]
        motion[i, DY] += substep * motion[i, VY]
        motion[i, DTURN] += substep * motion[i, SPIN]


def mark_active(
    counts: Whole,
    kind: Whole,
    used: Whole,
    pair: Whole,
    shape_body: Whole,
    hits: Whole,
) -> int:
    """List the moving bodies that have contacts in the second row of `hits`; return how many.

    Their colours, which are not needed any more, become marks.
    """
    for k in range(counts[HITS]):
        p = hits[0, k]
        used[shape_body[pair[p, 0]]] = used[shape_body[pair[p, 1]]] = 0
    active = 0
    for k in range(counts[HITS]):
        p = hits[0, k]
        for n in range(2):
            i = shape_body[pair[p, n]]
            if used[i] == 0 and kind[i] >= KINEMATIC:
                used[i] = 1
                hits[1, active] = i
                active += 1
    counts[ACTIVE] = active
    return active


def hasten(
    settings: Array,
    counts: Whole,
    motion: Array,
    load: Array,
    body: Array,
    kind: Whole,
    hits: Whole,
    carried: Array,
) -> None:
    """Let gravity, forces and drag change velocities for a substep, and contacts as before."""
    gravity = (settings[GRAVITY_X], settings[GRAVITY_Y])
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        if kind[i] == DYNAMIC:
            by_x, by_y = acceleration(gravity, (load[i, 0], load[i, 1]), body[i, INVERSE_MASS])
            turn = angular_acceleration(load[i, 2], body[i, INVERSE_INERTIA])
            decay, gain = body[i, SUB + DECAY], body[i, SUB + GAIN]
            motion[i, VX] = decay * motion[i, VX] + gain * by_x
            motion[i, VY] = decay * motion[i, VY] + gain * by_y
            decay, gain = body[i, SUB + ANGULAR + DECAY], body[i, SUB + ANGULAR + GAIN]
            motion[i, SPIN] = decay * motion[i, SPIN] + gain * turn
        for n in range(3):
            motion[i, n] += carried[i, n]
            carried[i, 3 + n] = motion[i, n]
