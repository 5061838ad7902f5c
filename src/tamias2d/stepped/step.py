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
    Indices,
    PlaceRows,
    RankRows,
    Ranks,
)
from tamias2d.state import Array
from tamias2d.stepped.coast import coast
from tamias2d.stepped.direct import ready, settle_islands
from tamias2d.stepped.energy import bound_energy, makes_energy, note_velocities
from tamias2d.stepped.flight import LOOKS_AROUND, fly, goes_far, outruns
from tamias2d.stepped.islands import find_islands
from tamias2d.stepped.layout import (
    ACTIVE,
    ANGULAR,
    ARRIVING,
    BEGUN,
    BLOCKS,
    DECAY,
    DORMANT,
    DTURN,
    DX,
    DY,
    DYNAMIC,
    EARLIER,
    FRAME_VX,
    FRAME_VY,
    FRAME_X,
    FRAME_Y,
    FRESH,
    FULL,
    GAIN,
    GAP,
    GRAVITY_X,
    GRAVITY_Y,
    HITS,
    HORIZON,
    INVERSE_INERTIA,
    INVERSE_MASS,
    KINEMATIC,
    KNOWN,
    LIFT,
    LIVE,
    NEEDED,
    OUTRUN,
    PAIRS,
    PATIENCE,
    PHASE,
    POINT,
    SENSOR,
    SHAPE_REACH,
    SIDE,
    SINCE,
    SOUND,
    SPIN,
    STALE,
    STATIC,
    STILL,
    SUB,
    SUBSTEPS,
    SWEPT,
    THIN,
    TIME_STEP,
    TOUCHED,
    UNBOUNCED,
    VX,
    VY,
    WANTED,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.manifold import collide
from tamias2d.stepped.pairs import (
    LONGEST,
    choose_frame,
    fatten,
    find_pairs,
    left_home,
    settle,
    sort_pairs,
    take_over,
    turn_corners,
)
from tamias2d.stepped.rows import (
    clear_lanes,
    colour,
    fill_rows,
    finish_rows,
    keep_impulses,
)
from tamias2d.stepped.sleep import (
    fall_asleep,
    keep_still,
    keep_touching,
    look_who_sleeps,
    note_company,
    rouse,
)
from tamias2d.stepped.solver import bounce, relax, sweep, warm
from tamias2d.stepped.thin import has_leaf, plan

DONE, MORE_FOUND, MORE_PAIRS, MORE_BLOCKS, UNSOUND, MORE_WEB = 0, 1, 2, 3, 4, 5

SENSED = 4  # the bit of `TOUCHED`, within a step, for a pair with a sensor that overlaps

CLOSE = 0.02  # of the smaller reach: what is nearer is a contact already
AHEAD = 0.1  # of the smaller reach: how far the motion of a step can make it one
BULLET = 2.0  # of the smaller reach: what moves farther in a step is met in flight

# on the bench, once its work is done: the fraction of the step that is flown; looks that are left
FLOWN, LOOKS_LEFT = 0, 1


def step(
    settings: Floats,
    counts: Ranks,
    pose: FloatRows,
    motion: FloatRows,
    load: FloatRows,
    body: FloatRows,
    home: FloatRows,
    kind: Bytes,
    used: Ranks,
    ranked: RankRows,
    shape_body: Indices,
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
    curve: RankRows,
    node: FloatRows,
    found: RankRows,
    pairs: IndexBlocks,
    touches: FloatBlocks,
    traces: IndexBlocks,
    hits: RankRows,
    fill: RankRows,
    rows: FloatRows,
    lanes: PlaceRows,
    bench: Floats,
    carried: FloatRows,
    times: Floats,
    scratch: FloatRows,
    island: RankRows,
    rest: FloatRows,
    energy: FloatRows,
    isle: RankRows,
    web: RankRows,
    weave: FloatRows,
) -> int:
    """Take the steps that are wanted, or say what there is too little room for.

    Called again, it goes on.
    """
    while counts[WANTED] > 0:
        if (
            counts[PHASE] == BEGUN
            and counts[PAIRS] == 0
            and counts[STILL] == 1
            and counts[PATIENCE] == 0
        ):
            if counts[SOUND] == 0 and not all_sound(settings, kind, pose, motion, load):
                return UNSOUND
            counts[SOUND] = 1
            counts[WANTED] -= coast(counts[WANTED], settings, kind, pose, motion, load, body, home)
            if counts[WANTED] == 0:
                return DONE
        status = step_once(
            settings, counts, pose, motion, load, body, home, kind, used, ranked,
            shape_body, shape_kind, shape_first, shape_count, shape_radius, surface,
            filters, mixed, corner, turned, box, curve, node, found, pairs, touches,
            traces, hits, fill, rows, lanes, bench, carried, times, scratch,
            island, rest, energy, isle, web, weave,
        )  # fmt: skip
        if status != DONE:
            return status
        counts[WANTED] -= 1
    return DONE


def step_once(
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
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
    found: Whole,
    pairs: Whole,
    touches: Array,
    traces: Whole,
    hits: Whole,
    fill: Whole,
    rows: Array,
    lanes: Whole,
    bench: Array,
    carried: Array,
    times: Array,
    scratch: Array,
    island: Whole,
    rest: Array,
    energy: Array,
    isle: Whole,
    web: Whole,
    weave: Array,
) -> int:
    """Take one step, or say what there is too little room for; called again, it goes on."""
    if counts[PHASE] == BEGUN:
        if counts[SOUND] == 0 and not all_sound(settings, kind, pose, motion, load):
            return UNSOUND
        counts[SOUND] = 1
        if counts[PATIENCE] > 0:
            look_who_sleeps(
                settings, counts, pose, motion, load, kind, shape_body, pairs[counts[SIDE]],
                traces[counts[SIDE]], island, rest,
            )  # fmt: skip
        counts[PHASE] = (
            STALE if counts[STILL] == 0 or left_home(settings, kind, pose, home) else FRESH
        )
    if counts[PHASE] == STALE:
        status = look_around(
            settings, counts, pose, motion, body, home, kind, ranked, shape_body, shape_kind,
            shape_first, shape_count, shape_radius, surface, filters, mixed, corner, turned, box,
            curve, node, found, pairs, touches, traces,
        )  # fmt: skip
        if status != DONE:
            return status
        counts[PHASE] = KNOWN
    elif counts[PHASE] == FRESH:
        turn_corners(
            shape_body, shape_kind, shape_first, shape_count, kind, KINEMATIC, pose, corner, turned
        )
        counts[PHASE] = KNOWN
    if counts[PHASE] == KNOWN:
        pair, touch, trace = pairs[counts[SIDE]], touches[counts[SIDE]], traces[counts[SIDE]]
        meet(
            settings, counts, pose, motion, shape_body, shape_kind, shape_first, shape_count,
            shape_radius, surface, filters, turned, pair, touch, trace, hits, island,
        )  # fmt: skip
        while counts[DORMANT] > 0 and rouse(counts, pair, shape_body, hits, island):
            meet(
                settings, counts, pose, motion, shape_body, shape_kind, shape_first, shape_count,
                shape_radius, surface, filters, turned, pair, touch, trace, hits, island,
            )  # fmt: skip
        needed = colour(counts, pair, trace, shape_body, kind, hits, used, fill)
        if needed > len(rows):
            counts[NEEDED] = needed
            return MORE_BLOCKS
        counts[THIN] = 0
        if has_leaf(kind, used):
            find_islands(counts, pair, shape_body, kind, hits, island)
            counts[THIN] = plan(counts, pair, shape_body, kind, used, hits, fill, island, isle, web)
        if counts[THIN] < 0:
            counts[NEEDED] = -counts[THIN]
            return MORE_WEB
        clear_lanes(len(pose) - 1, fill, rows, lanes)
        bouncing = fill_rows(
            counts, pair, touch, shape_body, shape_radius, surface, pose, motion, body,
            hits, fill, rows, lanes,
        )  # fmt: skip
        finish_rows(settings, counts, rows, lanes)
        solve(
            settings, counts, pose, motion, load, body, kind, used, pair, shape_body, hits, rows,
            lanes, bench, carried, island, energy, bouncing, web, weave,
        )  # fmt: skip
        age_touches(counts, trace)
        keep_impulses(counts, pair, shape_body, pose, rows, lanes, touch, trace)
        if counts[PATIENCE] > 0:
            note_company(counts, pair, shape_body, kind, hits, island)
        if counts[DORMANT] > 0:
            keep_still(kind, island, motion, used)
            keep_touching(counts, pair, shape_body, island, trace)
        drift(settings, motion, load, body, kind, used, carried)
        move_frame(settings, kind, motion)
        far = goes_far(kind, motion, body)
        counts[PHASE] = (
            ARRIVING
            if not far
            else OUTRUN
            if outruns(settings, kind, pose, motion, body, home)
            else SWEPT
        )
        bench[FLOWN], bench[LOOKS_LEFT] = 0.0, LOOKS_AROUND
    while counts[PHASE] != ARRIVING:
        if counts[PHASE] == OUTRUN:
            status = look_around(
                settings, counts, pose, motion, body, home, kind, ranked, shape_body, shape_kind,
                shape_first, shape_count, shape_radius, surface, filters, mixed, corner, turned,
                box, curve, node, found, pairs, touches, traces,
            )  # fmt: skip
            if status != DONE:
                return status
            bench[LOOKS_LEFT] -= 1.0
        pair, touch, trace = pairs[counts[SIDE]], touches[counts[SIDE]], traces[counts[SIDE]]
        bench[FLOWN] = fly(
            settings, counts, pose, motion, body, home, kind, carried, shape_body, shape_kind,
            shape_first, shape_count, shape_radius, surface, filters, corner, turned, pair, touch,
            trace, times, scratch, int(bench[LOOKS_LEFT]), bench[FLOWN],
        )  # fmt: skip
        counts[PHASE] = OUTRUN if bench[FLOWN] <= 1.0 else ARRIVING
    if counts[PATIENCE] > 0:
        fall_asleep(settings, counts, pose, motion, load, body, kind, island, rest)
    arrive(pose, motion)
    counts[SINCE] += 1
    counts[PHASE] = BEGUN
    return DONE


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


def look_around(
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    home: Array,
    kind: Whole,
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
    found: Whole,
    pairs: Whole,
    touches: Array,
    traces: Whole,
) -> int:
    """Make the list of pairs anew, for as many steps ahead as has been worth while."""
    if counts[SINCE] > 0:
        if counts[PAIRS] > 2 * len(shape_body):
            counts[HORIZON] = max(counts[HORIZON] // 2, 2)
        elif 2 * counts[SINCE] >= counts[HORIZON]:
            counts[HORIZON] = min(2 * counts[HORIZON], LONGEST)
        counts[SINCE] = 0
    turn_corners(
        shape_body, shape_kind, shape_first, shape_count, kind, STATIC, pose, corner, turned
    )
    choose_frame(settings, counts, kind, motion)
    settle(settings, counts[HORIZON] * settings[TIME_STEP], kind, pose, motion, body, home)
    fatten(
        shape_body,
        shape_kind,
        shape_first,
        shape_count,
        shape_radius,
        kind,
        body,
        home,
        turned,
        box,
    )
    total = find_pairs(
        counts,
        shape_kind,
        shape_body,
        filters,
        kind,
        ranked,
        box,
        curve,
        node,
        turned,
        shape_first,
        found,
        pose,
        home,
    )
    if total > len(found):
        counts[NEEDED] = total
        return MORE_FOUND
    sort_pairs(total, found, curve[3, : len(shape_body) + 1])
    size = take_over(total, counts, ranked, found, surface, mixed, pairs, touches, traces)
    if size > pairs.shape[1]:
        counts[NEEDED] = size
        return MORE_PAIRS
    counts[STILL] = 1
    return DONE


def meet(
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    surface: Array,
    filters: Whole,
    turned: Array,
    pair: Whole,
    touch: Array,
    trace: Whole,
    hits: Whole,
    island: Whole,
) -> None:
    """Find the contacts of all pairs, and list the pairs that have some."""
    total = 0
    for p in range(counts[PAIRS]):
        s, t = pair[p, 0], pair[p, 1]
        i, j = shape_body[s], shape_body[t]
        if counts[DORMANT] > 0 and island[i, LIVE] + island[j, LIVE] == 0:
            continue
        x, y = pose[j, X] - pose[i, X], pose[j, Y] - pose[i, Y]
        reach = min(surface[s, SHAPE_REACH], surface[t, SHAPE_REACH])
        by_x = motion[j, VX] - motion[i, VX]
        by_y = motion[j, VY] - motion[i, VY]
        speed = (abs(by_x) + abs(by_y)) * settings[TIME_STEP]
        margin = CLOSE * reach + min(speed, AHEAD * reach)
        margin = 0.0 if speed > BULLET * reach else margin
        count = collide(
            p,
            s,
            t,
            x,
            y,
            margin,
            shape_kind,
            shape_first,
            shape_count,
            shape_radius,
            turned,
            touch,
            trace,
        )
        if count == 0:
            continue
        if filters[s, SENSOR] == 0 and filters[t, SENSOR] == 0:
            hits[0, total] = p
            total += 1
        elif touch[p, GAP] <= 0.0 or (count == 2 and touch[p, GAP + POINT] <= 0.0):
            trace[p, TOUCHED] |= SENSED
    counts[HITS] = total


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
    for k in range(counts[ACTIVE]):
        i = hits[1, k]
        if kind[i] == DYNAMIC:
            mass = body[i, INVERSE_MASS]
            by_x = settings[GRAVITY_X] + mass * load[i, 0]
            by_y = settings[GRAVITY_Y] + mass * load[i, 1]
            turn = body[i, INVERSE_INERTIA] * load[i, 2]
            decay, gain = body[i, SUB + DECAY], body[i, SUB + GAIN]
            motion[i, VX] = decay * motion[i, VX] + gain * by_x
            motion[i, VY] = decay * motion[i, VY] + gain * by_y
            decay, gain = body[i, SUB + ANGULAR + DECAY], body[i, SUB + ANGULAR + GAIN]
            motion[i, SPIN] = decay * motion[i, SPIN] + gain * turn
        for n in range(3):
            motion[i, n] += carried[i, n]
            carried[i, 3 + n] = motion[i, n]


def drift(
    settings: Array,
    motion: Array,
    load: Array,
    body: Array,
    kind: Whole,
    used: Whole,
    gained: Array,
) -> None:
    """Find how far bodies without contacts go in this step: they have a closed form (IM1, IM6).

    What forces add to their velocities is noted; for bodies with contacts that is nothing.
    """
    for i in range(len(kind)):
        for n in range(3):
            gained[i, 3 + n] = 0.0
        if kind[i] < KINEMATIC or used[i] == 1:
            used[i] = 0
            continue
        by_x = by_y = turn = 0.0
        if kind[i] == DYNAMIC:
            mass = body[i, INVERSE_MASS]
            by_x = settings[GRAVITY_X] + mass * load[i, 0]
            by_y = settings[GRAVITY_Y] + mass * load[i, 1]
            turn = body[i, INVERSE_INERTIA] * load[i, 2]
        flow(i, 0, FULL, by_x, body, motion, gained)
        flow(i, 1, FULL, by_y, body, motion, gained)
        flow(i, 2, FULL + ANGULAR, turn, body, motion, gained)


def flow(i: int, axis: int, at: int, by: float, body: Array, motion: Array, gained: Array) -> None:
    """Take one coordinate of a body through the step, under an acceleration."""
    before = motion[i, axis]
    after = body[i, at + DECAY] * before + body[i, at + GAIN] * by
    motion[i, DX + axis] = body[i, at + GAIN] * before + body[i, at + LIFT] * by
    motion[i, axis] = after
    gained[i, 3 + axis] = after - before


def move_frame(settings: Array, kind: Whole, motion: Array) -> None:
    """Move the frame of the list of pairs along with all bodies."""
    if settings[FRAME_VX] == 0.0 and settings[FRAME_VY] == 0.0:
        return
    x = y = 0.0
    number = 0
    for i in range(len(kind)):
        if kind[i] == DYNAMIC:
            x += motion[i, DX]
            y += motion[i, DY]
            number += 1
    if number > 0:
        settings[FRAME_X] += x / number
        settings[FRAME_Y] += y / number


def arrive(pose: Array, motion: Array) -> None:
    """Put all bodies at the ends of their lines."""
    for i in range(len(pose)):
        for n in range(3):
            pose[i, n] += motion[i, DX + n]
            motion[i, DX + n] = 0.0


def age_touches(counts: Whole, trace: Whole) -> None:
    """Move what was noted of the last step; a pair with a sensor was seen as this one began."""
    for p in range(counts[PAIRS]):
        noted = trace[p, TOUCHED]
        trace[p, TOUCHED] = ((noted & 1) << 1) | ((noted & SENSED) // SENSED)
