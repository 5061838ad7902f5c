"""Sleeping: islands that have come to rest cost nothing until something happens to them.

Serves: a step, where sleeping is wanted. Hides: what counts as quiet, and what wakes an island.

A body is quiet while its velocity and that of its rim, as they are and as it has moved in the step,
are below a small fraction of the velocity that it gets by falling through its own reach; without
gravity, of its reach a second. An island in which all have been quiet for some steps falls asleep:
its velocities become zero, nothing moves it, and its contacts are neither looked for nor solved.
What touches nothing sleeps only where it does not move at all, and what leans on something that
moves does not sleep.

It wakes as a whole where something that moves comes near to touching it; where a pose, a velocity,
a load or gravity is not what it was; and where something on which it leaned has been moved.
"""

from tamias2d.state import Array
from tamias2d.stepped.islands import find_islands
from tamias2d.stepped.layout import (
    ABSENT,
    COMPANY,
    COUNT,
    DORMANT,
    DX,
    DYNAMIC,
    GRAVITY_X,
    GRAVITY_Y,
    HITS,
    ISLAND,
    LIVE,
    NIGHT,
    NOTED,
    OF_A,
    OF_B,
    PAIRS,
    PATIENCE,
    PEACE,
    QUIET,
    REACH,
    REST_GRAVITY,
    REST_LOAD,
    SPIN,
    TIME_STEP,
    TOUCHED,
    VX,
    VY,
    Whole,
)

ALONE, TOUCHING, MOVED = 0, 1, 2

SLOW = 0.02  # of the velocity of a fall through the reach: one through 1/5000 of it


def look_who_sleeps(
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    load: Array,
    kind: Whole,
    pair: Whole,
    trace: Whole,
    island: Whole,
    rest: Array,
) -> None:
    """Wake what has been changed since the last step, and count what sleeps on."""
    for i in range(len(kind)):
        if island[i, NIGHT] > 0 and stirred(settings, pose[i], motion[i], load[i], rest[i]):
            wake_island(island[i, NIGHT], island)
    for i in range(len(kind)):
        if kind[i] == DYNAMIC:
            island[i, LIVE] = 1 if island[i, NIGHT] == 0 else 0
        else:
            note_support(kind[i], pose[i], motion[i], island[i], rest[i])
    for p in range(counts[PAIRS]):
        i, j = pair[p, OF_A], pair[p, OF_B]
        if trace[p, COUNT] > 0 and island[i, LIVE] != island[j, LIVE]:
            wake_island(max(island[i, NIGHT], island[j, NIGHT]), island)
    count_sleepers(counts, kind, island)


def stirred(settings: Array, pose: Array, motion: Array, load: Array, rest: Array) -> bool:
    """Return whether a body that sleeps is not as it was when it fell asleep."""
    other = (rest[REST_GRAVITY] != settings[GRAVITY_X]) | (
        rest[REST_GRAVITY + 1] != settings[GRAVITY_Y]
    )
    for n in range(3):
        other = other | (pose[n] != rest[n]) | (motion[n] != 0.0)
        other = other | (load[n] != rest[REST_LOAD + n])
    return bool(other)


def note_support(kind: int, pose: Array, motion: Array, island: Whole, rest: Array) -> None:
    """Say of what nothing pushes whether it wakes others: it is new, has been moved, or moves."""
    live = island[QUIET] == 0
    for n in range(3):
        live = live | (pose[n] != rest[n]) | (motion[n] != 0.0)
        rest[n] = pose[n]
    island[LIVE] = 1 if live and kind != ABSENT else 0
    island[QUIET] = 1 if kind != ABSENT else 0


def rouse(counts: Whole, pair: Whole, hits: Whole, island: Whole) -> bool:
    """Wake what is met by something that may wake it; return whether anything was."""
    woken = False
    for k in range(counts[HITS]):
        i, j = pair[hits[0, k], OF_A], pair[hits[0, k], OF_B]
        if island[i, LIVE] != island[j, LIVE]:
            night = max(island[i, NIGHT], island[j, NIGHT])
            wake_island(night, island)
            woken = woken or night > 0
    return woken


def wake_island(night: int, island: Whole) -> None:
    """Wake all that sleep under a name; 0 is none's."""
    if night == 0:
        return
    for i in range(len(island)):
        if island[i, NIGHT] == night:
            island[i, NIGHT], island[i, QUIET], island[i, LIVE] = 0, 0, 1


def count_sleepers(counts: Whole, kind: Whole, island: Whole) -> None:
    """Count what sleeps."""
    asleep = 0
    for i in range(len(kind)):
        asleep += island[i, NIGHT] > 0
    counts[DORMANT] = asleep


def keep_still(kind: Whole, island: Whole, motion: Array, carried: Array, used: Whole) -> None:
    """Let nothing move what sleeps: it is marked like what has been moved already."""
    for i in range(len(kind)):
        if island[i, NIGHT] > 0:
            used[i] = 1
            for n in range(3):
                motion[i, DX + n] = carried[i, NOTED + n] = 0.0


def keep_touching(counts: Whole, pair: Whole, island: Whole, trace: Whole) -> None:
    """Let pairs of what sleeps that touched touch on, so that nothing ends or begins."""
    for p in range(counts[PAIRS]):
        if island[pair[p, OF_A], LIVE] + island[pair[p, OF_B], LIVE] == 0:
            trace[p, TOUCHED] |= trace[p, TOUCHED] >> 1


def note_company(counts: Whole, pair: Whole, kind: Whole, hits: Whole, island: Whole) -> None:
    """Note of each body whether it touches anything, and whether that is moved by nobody's push."""
    find_islands(counts, kind, hits, island)
    for i in range(len(kind)):
        island[i, COMPANY] = ALONE
    for k in range(counts[HITS]):
        i, j = pair[hits[0, k], OF_A], pair[hits[0, k], OF_B]
        moved = (kind[i] != DYNAMIC and island[i, LIVE] == 1) or (
            kind[j] != DYNAMIC and island[j, LIVE] == 1
        )
        company = MOVED if moved else TOUCHING
        island[i, COMPANY] = max(island[i, COMPANY], company)
        island[j, COMPANY] = max(island[j, COMPANY], company)


def fall_asleep(
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    kind: Whole,
    island: Whole,
    rest: Array,
) -> None:
    """Count for how long bodies have been quiet, and let islands sleep that have been for long.

    Poses are those at the beginning of the step, with what has been moved since beside them.
    """
    for i in range(len(kind)):
        island[i, PEACE] = counts[PATIENCE]
    for i in range(len(kind)):
        if kind[i] == DYNAMIC and island[i, NIGHT] == 0:
            company, root = island[i, COMPANY], island[i, ISLAND]
            slow = slowness(settings, body[i, REACH]) if company == TOUCHING else 0.0
            quiet = is_quiet(settings[TIME_STEP], slow, motion[i], body[i, REACH])
            island[i, QUIET] = island[i, QUIET] + 1 if quiet and company != MOVED else 0
            island[root, PEACE] = min(island[root, PEACE], island[i, QUIET])
    for i in range(len(kind)):
        root = island[i, ISLAND]
        peaceful = island[root, PEACE] >= counts[PATIENCE]
        if kind[i] == DYNAMIC and island[i, NIGHT] == 0 and peaceful:
            island[i, NIGHT] = root + 1
            rest[i, REST_GRAVITY] = settings[GRAVITY_X]
            rest[i, REST_GRAVITY + 1] = settings[GRAVITY_Y]
            for n in range(3):
                motion[i, n] = 0.0
                rest[i, n] = pose[i, n] + motion[i, DX + n]
                rest[i, REST_LOAD + n] = load[i, n]


def slowness(settings: Array, reach: float) -> float:
    """Return the square of the velocity, m/s, below which a body that touches things is quiet."""
    pull = abs(settings[GRAVITY_X]) + abs(settings[GRAVITY_Y])
    return SLOW * SLOW * reach * (pull if pull > 0.0 else reach)


def is_quiet(time_step: float, slow: float, motion: Array, reach: float) -> bool:
    """Return whether a body is slow, and has been in this step."""
    x, y, spin = motion[VX], motion[VY], motion[SPIN] * reach
    to_x, to_y, turn = motion[DX], motion[DX + 1], motion[DX + 2] * reach
    most = slow * time_step * time_step
    still = x * x + y * y + spin * spin <= slow
    return bool(still and to_x * to_x + to_y * to_y + turn * turn <= most)
