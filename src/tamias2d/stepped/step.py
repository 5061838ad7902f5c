"""One step of all bodies: the stages in their order.

Serves: the world, which calls it again with more room where it asks for it. Hides: what happens
within a step.

Who is near whom; who touches where; blocks of contacts; then substeps, each of which moves
velocities by forces, applies what contacts did before, corrects it softly, moves bodies, and takes
the softness out of the velocities again; then bouncing, and bodies that went far are stopped where
they met something. Bodies that touch nothing go along their closed form instead (IM1, IM6).

Cost: a substep visits each contact three times. Source: Macklin et al. (2019), Catto (2024).
"""

from tamias2d.kernels.arrays import (
    Bytes,
    FloatBlocks,
    FloatRows,
    Floats,
    IndexBlocks,
    IndexRows,
    Indices,
    PlaceBlocks,
    PlaceRows,
    Places,
    RankRows,
    Ranks,
)
from tamias2d.state import (
    Array,
)
from tamias2d.stepped.arrangement import arrange
from tamias2d.stepped.drift import (
    arrive,
    drift,
)
from tamias2d.stepped.flight import (
    LOOKS_AROUND,
    fly,
)
from tamias2d.stepped.flight_rooms import mark_outrun
from tamias2d.stepped.frame import (
    move_frame,
)
from tamias2d.stepped.homes import (
    left_behind,
    mark_left,
)
from tamias2d.stepped.layout import (
    ARRIVING,
    BEGUN,
    DORMANT,
    GRAVITY_X,
    GRAVITY_Y,
    KINEMATIC,
    KNOWN,
    MET,
    OUTRUN,
    PAIRS,
    PATIENCE,
    PHASE,
    SIDE,
    SINCE,
    SOUND,
    STALE,
    STATIC,
    STILL,
    SWEPT,
    WANTED,
    Whole,
)
from tamias2d.stepped.meeting import meet
from tamias2d.stepped.sleep import (
    fall_asleep,
    keep_still,
    keep_touching,
    look_who_sleeps,
    note_company,
    rouse,
)
from tamias2d.stepped.substeps import (
    solve,
)
from tamias2d.stepped.surroundings import (
    CLEAR,
    DONE,
    UNSOUND,
    look_again,
    look_around,
)
from tamias2d.stepped.turning import turn_corners

# on the bench, once its work is done: the fraction of the step that is flown; looks that are left
FLOWN, LOOKS_LEFT = 0, 1


def step(
    settings: Floats,
    counts: Ranks,
    pose: FloatRows,
    velocity: FloatRows,
    load: FloatRows,
    owner: Places,
    seated_pose: FloatRows,
    motion: FloatRows,
    seated_load: FloatRows,
    seated_body: FloatRows,
    flows: FloatRows,
    home: FloatRows,
    seated_kind: Bytes,
    used: Ranks,
    ranked: PlaceRows,
    shape_seat: Places,
    shape_kind: Indices,
    shape_first: Indices,
    shape_count: Indices,
    shape_radius: Floats,
    surface: FloatRows,
    filters: RankRows,
    mixed: FloatRows,
    corner: FloatRows,
    turned: FloatRows,
    box: FloatRows,
    curve: PlaceRows,
    node: FloatRows,
    middle: FloatRows,
    found: PlaceRows,
    pairs: PlaceBlocks,
    touches: FloatBlocks,
    traces: IndexBlocks,
    hits: PlaceRows,
    fill: RankRows,
    slabs: RankRows,
    rows: FloatRows,
    lanes: PlaceRows,
    bench: Floats,
    carried: FloatRows,
    times: Floats,
    agenda: IndexRows,
    scratch: FloatRows,
    island: IndexRows,
    rest: FloatRows,
    energy: FloatRows,
    isle: IndexRows,
    web: RankRows,
    weave: FloatRows,
) -> int:
    """Take the steps that are wanted, or say what there is too little room for.

    Called again, it goes on. It stops where no pair is near: bodies may coast then. What users see
    is in the order of adding, what steps work on in that of seats, which are near where bodies are.
    """
    if counts[PHASE] == BEGUN:
        odd = seat_all(
            settings, owner, pose, velocity, load, seated_kind, seated_pose, motion, seated_load
        )
        if (
            odd
            and counts[SOUND] == 0
            and not all_sound(settings, seated_kind, seated_pose, motion, seated_load)
        ):
            return UNSOUND
    alone = False
    while counts[WANTED] > 0 and not alone:
        status = step_once(
            settings, counts, seated_pose, motion, seated_load, seated_body, flows, home,
            seated_kind, used, ranked, shape_seat, shape_kind, shape_first, shape_count,
            shape_radius, surface, filters, mixed, corner, turned, box, curve, node, middle, found,
            pairs, touches, traces, hits, fill, slabs, rows, lanes, bench, carried, times, agenda,
            scratch, island, rest, energy, isle, web, weave,
        )  # fmt: skip
        if status != DONE:
            return status
        arrive(owner, seated_pose, motion, pose, velocity)
        counts[WANTED] -= 1
        alone = counts[PAIRS] == 0 and counts[STILL] == 1 and counts[PATIENCE] == 0
    return CLEAR if alone else DONE


def seat_all(
    settings: Array,
    owner: Whole,
    pose: Array,
    velocity: Array,
    load: Array,
    seated_kind: Whole,
    seated_pose: Array,
    motion: Array,
    seated_load: Array,
) -> bool:
    """Bring what users can set to the seats of the bodies; return whether some of it looks odd.

    It does where a sum is not finite, or what is static moves.
    """
    total = settings[GRAVITY_X] + settings[GRAVITY_Y]
    odd = 0 if total - total == 0.0 else 1
    for i in range(len(owner)):
        at, speed, by = pose[owner[i]], velocity[owner[i]], load[owner[i]]
        for n in range(3):
            seated_pose[i, n], motion[i, n], seated_load[i, n] = at[n], speed[n], by[n]
            total = at[n] + speed[n] + by[n]
            odd += 0 if total - total == 0.0 else 1
        moves = abs(speed[0]) + abs(speed[1]) + abs(speed[2]) > 0.0
        odd += 1 if moves & (seated_kind[i] == STATIC) else 0
    return odd > 0


def all_sound(settings: Array, kind: Whole, pose: Array, motion: Array, load: Array) -> bool:
    """Return whether what users can set are numbers, and what is static stands still."""
    x, y = settings[GRAVITY_X], settings[GRAVITY_Y]
    bad = 0 if x - x == 0.0 and y - y == 0.0 else 1
    for i in range(len(pose)):
        mobile = kind[i] != STATIC
        for k in range(3):
            fine = (pose[i, k] - pose[i, k] == 0.0) & (load[i, k] - load[i, k] == 0.0)
            moves = motion[i, k] != 0.0
            fine = fine & (motion[i, k] - motion[i, k] == 0.0) & (mobile | (not moves))
            bad += 0 if fine else 1
    return bad == 0


def step_once(
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    flows: Array,
    home: Array,
    kind: Whole,
    used: Whole,
    ranked: Whole,
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    surface: Array,
    filters: Whole,
    mixed: Array,
    corner: Array,
    turned: Array,
    box: Array,
    curve: Whole,
    node: Array,
    middle: Array,
    found: Whole,
    pairs: Whole,
    touches: Array,
    traces: Whole,
    hits: Whole,
    fill: Whole,
    slabs: Whole,
    rows: Array,
    lanes: Whole,
    bench: Array,
    carried: Array,
    times: Array,
    agenda: Whole,
    scratch: Array,
    island: Whole,
    rest: Array,
    energy: Array,
    isle: Whole,
    web: Whole,
    weave: Array,
) -> int:
    """Find one step, or say what there is too little room for; called again, it goes on."""
    if counts[PHASE] == BEGUN:
        if counts[PATIENCE] > 0:
            look_who_sleeps(
                settings, counts, pose, motion, load, kind, pairs[counts[SIDE]],
                traces[counts[SIDE]], island, rest,
            )  # fmt: skip
        marked = mark_left(settings, kind, pose, home, used)
        least = STATIC if marked > 0 or counts[STILL] == 0 else KINEMATIC
        turn_corners(
            shape_body, shape_kind, shape_first, shape_count, kind, least, pose, corner, turned
        )
        holds = look_again(
            marked, settings, counts, pose, motion, body, home, kind, used, ranked, shape_body,
            shape_kind, shape_first, shape_count, shape_radius, surface, filters, corner,
            turned, box, curve, node, middle, found, pairs, touches, traces,
        )  # fmt: skip
        counts[PHASE] = KNOWN if holds else STALE
    if counts[PHASE] == STALE:
        status = look_around(
            settings, counts, pose, motion, load, body, flows, home, kind, ranked, shape_body,
            shape_kind, shape_first, shape_count, shape_radius, surface, filters, turned,
            box, curve, node, middle, found, pairs, touches, traces,
        )  # fmt: skip
        if status != DONE:
            return status
        counts[PHASE] = KNOWN
    pair, touch, trace = pairs[counts[SIDE]], touches[counts[SIDE]], traces[counts[SIDE]]
    if counts[PHASE] == KNOWN:
        again = False
        while not again or (counts[DORMANT] > 0 and rouse(counts, pair, hits, island)):
            meet(
                again, settings, counts, pose, motion, shape_kind, shape_first, shape_count,
                shape_radius, surface, filters, turned, pair, touch, trace, hits, island,
            )  # fmt: skip
            again = True
        counts[PHASE] = MET
    if counts[PHASE] == MET:
        status = arrange(
            counts, trace, kind, used, pose, body, hits, fill, slabs, rows, lanes, isle, web
        )
        if status != DONE:
            return status
        solve(
            settings, counts, pair, touch, trace, shape_radius, surface, mixed, pose, motion, load,
            body, flows, kind, hits, slabs, rows, lanes, bench, carried, island, energy, web, weave,
        )  # fmt: skip
        if counts[PATIENCE] > 0:
            note_company(counts, pair, kind, hits, island)
        if counts[DORMANT] > 0:
            keep_still(kind, island, motion, carried, used)
            keep_touching(counts, pair, island, trace)
        far = drift(settings, motion, load, body, flows, kind, used, carried)
        move_frame(settings)
        if not far:
            counts[PHASE] = ARRIVING
        else:
            marked = mark_outrun(settings, kind, pose, motion, body, home, used)
            behind = left_behind(settings, kind, pose, motion, home)
            counts[PHASE] = OUTRUN if marked > 0 or behind else SWEPT
        bench[FLOWN], bench[LOOKS_LEFT] = 0.0, LOOKS_AROUND
    while counts[PHASE] != ARRIVING:
        if counts[PHASE] == OUTRUN:
            if bench[FLOWN] > 0.0:  # corners have been turned along the flight
                turn_corners(
                    shape_body, shape_kind, shape_first, shape_count, kind, STATIC, pose, corner,
                    turned,
                )  # fmt: skip
            marked = mark_outrun(settings, kind, pose, motion, body, home, used)
            holds = look_again(
                marked, settings, counts, pose, motion, body, home, kind, used, ranked, shape_body,
                shape_kind, shape_first, shape_count, shape_radius, surface, filters,
                corner, turned, box, curve, node, middle, found, pairs, touches, traces,
            )  # fmt: skip
            status = DONE if holds else look_around(
                settings, counts, pose, motion, load, body, flows, home, kind, ranked, shape_body,
                shape_kind, shape_first, shape_count, shape_radius, surface, filters,
                turned, box, curve, node, middle, found, pairs, touches, traces,
            )  # fmt: skip
            if status != DONE:
                return status
            bench[LOOKS_LEFT] -= 1.0
        pair, touch, trace = pairs[counts[SIDE]], touches[counts[SIDE]], traces[counts[SIDE]]
        bench[FLOWN] = fly(
            settings, counts, pose, motion, load, body, home, kind, carried, shape_body,
            shape_kind, shape_first, shape_count, shape_radius, surface, mixed, filters, corner,
            turned, pair, touch, trace, times, agenda, scratch, int(bench[LOOKS_LEFT]),
            bench[FLOWN],
        )  # fmt: skip
        counts[PHASE] = OUTRUN if bench[FLOWN] <= 1.0 else ARRIVING
    if counts[PATIENCE] > 0:
        fall_asleep(settings, counts, pose, motion, load, body, kind, island, rest)
    counts[SINCE] += 1
    counts[PHASE] = BEGUN
    return DONE
