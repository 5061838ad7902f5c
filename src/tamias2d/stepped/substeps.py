"""The substeps of all bodies with contacts.

Serves: a step. Hides: that what contacts did before is carried by bodies, so that each contact is
visited twice in a substep, and once more as the step begins.
"""

from tamias2d.generated.definitions import (
    acceleration,
    angular_acceleration,
    pace_given,
    pace_later,
)
from tamias2d.generated.soft_contact import shift_later, turn_later
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array
from tamias2d.stepped.direct import (
    ready,
    settle_islands,
)
from tamias2d.stepped.energy import makes_energy, note_unbounced, sum_up
from tamias2d.stepped.energy_bound import bound_energy
from tamias2d.stepped.islands import (
    know_islands,
)
from tamias2d.stepped.layout import (
    ACTIVE,
    ACTIVE_ROW,
    ANGULAR,
    BLOCKS,
    BOUNCING,
    CARRIED,
    DECAY,
    DTURN,
    DX,
    DY,
    DYNAMIC,
    EARLIER,
    FLOW,
    GAIN,
    GIVEN,
    GRAVITY_X,
    GRAVITY_Y,
    HITS,
    INVERSE_INERTIA,
    INVERSE_MASS,
    KEPT_BY_DRAG,
    NOTED,
    SEATED,
    SLABS,
    SPIN,
    SUB,
    SUBSTEPS,
    TIME_STEP,
    VX,
    VY,
    Whole,
)
from tamias2d.stepped.rows import (
    S_BLOCK,
    S_BODY,
    S_HIT,
    S_ISLE,
    clear_lanes,
    fetch_rows,
    fetch_touches,
    fill_rows,
    finish_rows,
    keep_impulses,
    seat_pairs,
)
from tamias2d.stepped.solver import (
    ALL_FIRST,
    ALL_GIVEN,
    ALL_NOW,
    FETCHED,
    bounce,
    relax,
    sweep,
    warm,
)


def solve(
    settings: Array,
    counts: Whole,
    pair: Whole,
    touch: Array,
    trace: Whole,
    shape_radius: Array,
    surface: Array,
    mixed: Array,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    flows: Array,
    kind: Whole,
    hits: Whole,
    slabs: Whole,
    rows: Array,
    lanes: Whole,
    bench: Array,
    carried: Array,
    island: Whole,
    energy: Array,
    web: Whole,
    weave: Array,
) -> None:
    """Take the substeps of all bodies with contacts, and let them bounce."""
    if counts[ACTIVE] == 0:
        return
    substeps = counts[SUBSTEPS]
    substep = settings[TIME_STEP] / substeps
    bench[ALL_FIRST] = bench[ALL_NOW] = bench[ALL_GIVEN] = 0.0
    number, last = counts[SLABS], 2 * substeps
    for front in range(number + last):  # of two slabs the first is a stage ahead
        for stage in range(max(front - number + 1, 0), min(front, last) + 1):
            take_stage(
                stage, front - stage, substep, settings, counts, pair, touch, trace, shape_radius,
                surface, mixed, pose, motion, load, body, flows, kind, hits, slabs, rows, lanes,
                bench, carried, web, weave,
            )  # fmt: skip
    counts[SEATED] = 1
    bouncing = counts[BOUNCING]
    slowest = 2.0 * settings[TIME_STEP] * (abs(settings[GRAVITY_X]) + abs(settings[GRAVITY_Y]))
    if bouncing > 0 or makes_energy(bench):
        if bouncing > 0:
            note_unbounced(counts, motion, hits, energy)
            bounce(0, counts[BLOCKS], rows, lanes, motion, bench, slowest)
        know_islands(counts, kind, hits, island)
        bound_energy(
            settings, counts, pose, motion, load, body, kind, hits, island,
            carried, energy, rows, lanes, bouncing,
        )  # fmt: skip
    if bouncing > 0:
        keep_impulses(0, counts[HITS], pose, hits, rows, touch, trace)


@inlined
def take_stage(
    stage: int,
    slab: int,
    substep: float,
    settings: Array,
    counts: Whole,
    pair: Whole,
    touch: Array,
    trace: Whole,
    shape_radius: Array,
    surface: Array,
    mixed: Array,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    flows: Array,
    kind: Whole,
    hits: Whole,
    slabs: Whole,
    rows: Array,
    lanes: Whole,
    bench: Array,
    carried: Array,
    web: Whole,
    weave: Array,
) -> None:
    """Take a slab through one stage: first the begin of the step, then two for each substep.

    Its contacts are with bodies of its own and of the next slab, which the slab before it has
    taken to this stage already.
    """
    first = slabs[slab + 1, S_BODY] if slab > 0 else 0
    last = slabs[min(slab + 2, counts[SLABS]), S_BODY]
    block, end = slabs[slab, S_BLOCK], slabs[slab + 1, S_BLOCK]
    hit, hit_end = slabs[slab, S_HIT], slabs[slab + 1, S_HIT]
    isle, isle_end = slabs[slab, S_ISLE], slabs[slab + 1, S_ISLE]
    if stage == 0:
        if counts[SLABS] > 1:
            bench[FETCHED] = fetch_touches(hit, hit_end, hits, touch)
            bench[FETCHED] += fetch_rows(block, end, rows, lanes)
        begin(first, last, settings, motion, load, body, flows, kind, hits, carried)
        if counts[SEATED] == 0:
            clear_lanes(block, end, len(kind) - 1, rows, lanes)
            seat_pairs(
                hit, hit_end, counts, pair, shape_radius, surface, mixed, body, hits, rows, lanes
            )
        fill_rows(hit, hit_end, touch, pose, carried, hits, rows)
        finish_rows(block, end, substep, rows, lanes)
        ready(isle, isle_end, body, rows, lanes, web, weave)
        warm(block, end, rows, lanes, motion, bench)
    elif stage % 2 == 1:
        hasten(stage > 1, first, last, motion, hits, carried)
        settle_islands(False, isle, isle_end, substep, rows, lanes, motion, web, weave)
        sweep(block, end, rows, lanes, motion, bench, substep)
    else:
        shift(substep, first, last, motion, hits)
        settle_islands(True, isle, isle_end, substep, rows, lanes, motion, web, weave)
        relax(block, end, rows, lanes, motion, bench, substep)
        if stage == 2 * counts[SUBSTEPS]:
            own, own_end = slabs[slab, S_BODY], slabs[slab + 1, S_BODY]
            sum_up(own, own_end, settings, motion, load, body, kind, hits, carried, bench)
            if counts[BOUNCING] == 0:
                keep_impulses(hit, hit_end, pose, hits, rows, touch, trace)


def begin(
    first: int,
    last: int,
    settings: Array,
    motion: Array,
    load: Array,
    body: Array,
    flows: Array,
    kind: Whole,
    hits: Whole,
    carried: Array,
) -> None:
    """Note the velocities before the impulses of the last step are applied again.

    Noted, too, is what gravity, forces and drag do to them in a substep.
    """
    gravity = (settings[GRAVITY_X], settings[GRAVITY_Y])
    for k in range(first, last):
        i = hits[ACTIVE_ROW, k]
        note = carried[i]
        for n in range(3):
            note[CARRIED + n], note[NOTED + n] = 0.0, motion[i, n]
            note[EARLIER + n] = motion[i, n]
            note[KEPT_BY_DRAG + n], note[GIVEN + n] = 1.0, 0.0
        if kind[i] == DYNAMIC:
            by_x, by_y = acceleration(gravity, (load[i, 0], load[i, 1]), body[i, INVERSE_MASS])
            turn = angular_acceleration(load[i, 2], body[i, INVERSE_INERTIA])
            so = flows[int(body[i, FLOW])]
            decay, gain = so[SUB + DECAY], so[SUB + GAIN]
            note[KEPT_BY_DRAG] = note[KEPT_BY_DRAG + 1] = decay
            note[GIVEN], note[GIVEN + 1] = pace_given(gain, by_x), pace_given(gain, by_y)
            decay, gain = so[SUB + ANGULAR + DECAY], so[SUB + ANGULAR + GAIN]
            note[KEPT_BY_DRAG + 2], note[GIVEN + 2] = decay, pace_given(gain, turn)


def hasten(again: bool, first: int, last: int, motion: Array, hits: Whole, carried: Array) -> None:
    """Let forces change velocities for a substep, and contacts as they have before.

    What contacts have changed so far is carried: impulses add up, so this is what applying each of
    them again would do. In the first substep that is what the last step did, and bodies begin with
    the velocities that were noted.
    """
    for k in range(first, last):
        i = hits[ACTIVE_ROW, k]
        note = carried[i]
        for n in range(3):
            note[CARRIED + n] += motion[i, n] - note[NOTED + n]
            before = motion[i, n] if again else note[NOTED + n]
            flown = pace_later(note[KEPT_BY_DRAG + n], before, note[GIVEN + n])
            motion[i, n] = flown + note[CARRIED + n]
            note[NOTED + n] = motion[i, n]


def shift(substep: float, first: int, last: int, motion: Array, hits: Whole) -> None:
    """Move bodies along for a substep, s."""
    for k in range(first, last):
        i = hits[ACTIVE_ROW, k]
        now = motion[i]
        now[DX], now[DY] = shift_later((now[DX], now[DY]), (now[VX], now[VY]), substep)
        now[DTURN] = turn_later(now[DTURN], now[SPIN], substep)
