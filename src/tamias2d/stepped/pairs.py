"""Pairs of shapes that may touch before anything has moved far.

Serves: a step, which asks whether the list still holds. Hides: how much room each body has until
then. All room is relative to sizes and to what the motion at hand would take.

The list is sorted by the canonical ranks of the shapes, so that it does not depend on the order in
which bodies were added or found.
"""

from math import cos, sin, sqrt

from tamias2d.generated.definitions import pair_friction, pair_restitution
from tamias2d.state import Array
from tamias2d.stepped.layout import (
    ABSENT,
    ARM,
    CACHE,
    CATEGORY,
    COUNT,
    DTURN,
    DX,
    DY,
    DYNAMIC,
    FAT,
    FRAME_VX,
    FRAME_VY,
    FRAME_X,
    FRAME_Y,
    FRICTION,
    GROUP,
    HALF_PLANE,
    HIGH_X,
    HIGH_Y,
    HITS,
    HOME_TURN,
    LEAVES,
    LOW_X,
    LOW_Y,
    MASK,
    OUTRUN,
    PAIR_FRICTION,
    PAIR_RESTITUTION,
    PAIRS,
    PHASE,
    PRELOAD,
    PUSH,
    REACH,
    RESTITUTION,
    SIDE,
    SPIN,
    STATIC,
    TOUCH,
    TOUCHED,
    TURN,
    TURN_ROOM,
    VX,
    VY,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.tree import BUNCH, FAR, grow_tree, lowest

ROOM = 0.1  # of the reach: how far a body may go before pairs are looked for again
AROUND = 0.12  # of the reach: how far around a shape others must be known
LONGEST = 64  # steps ahead that a list is made for, at most


def left_home(settings: Array, kind: Whole, pose: Array, home: Array) -> bool:
    """Return whether some body is where the list of pairs is not known to hold.

    Rooms move with the frame: where all fall together, nobody comes nearer to anybody.
    """
    for i in range(len(kind)):
        x, y = pose[i, X] - settings[FRAME_X], pose[i, Y] - settings[FRAME_Y]
        turn = pose[i, TURN] - home[i, HOME_TURN]
        inside = (
            (x >= home[i, LOW_X])
            & (x <= home[i, HIGH_X])
            & (y >= home[i, LOW_Y])
            & (y <= home[i, HIGH_Y])
            & (abs(turn) <= home[i, TURN_ROOM])
        )
        if not inside and kind[i] != ABSENT:
            return True
    return False


def turn_corners(
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    kind: Whole,
    least: int,
    pose: Array,
    corner: Array,
    turned: Array,
) -> None:
    """Turn the corners of all bodies that are at least of some kind into the world's axes."""
    for s in range(len(shape_body)):
        i = shape_body[s]
        if kind[i] < least:
            continue
        first = shape_first[s]
        angle = pose[i, TURN]
        if shape_kind[s] == HALF_PLANE or (
            shape_count[s] == 1 and corner[first, 0] == 0.0 and corner[first, 1] == 0.0
        ):
            for k in range(4):
                turned[first, k] = corner[first, k]
            continue
        c, d = cos(angle), sin(angle)
        for k in range(first, first + shape_count[s]):
            x, y = corner[k, 0], corner[k, 1]
            turned[k, 0], turned[k, 1] = c * x - d * y, d * x + c * y
            x, y = corner[k, 2], corner[k, 3]
            turned[k, 2], turned[k, 3] = c * x - d * y, d * x + c * y


def choose_frame(settings: Array, counts: Whole, kind: Whole, motion: Array) -> None:
    """Let the list of pairs hold in a frame that moves with all bodies, while nothing touches.

    Within a step, when bodies are on their ways already, it stands still.
    """
    x = y = 0.0
    number = 0
    if counts[HITS] == 0 and counts[PHASE] != OUTRUN:
        for i in range(len(kind)):
            if kind[i] == DYNAMIC:
                x += motion[i, VX]
                y += motion[i, VY]
                number += 1
    settings[FRAME_VX] = x / number if number > 0 else 0.0
    settings[FRAME_VY] = y / number if number > 0 else 0.0
    settings[FRAME_X] = settings[FRAME_Y] = 0.0


def settle(
    settings: Array,
    ahead: float,
    kind: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    home: Array,
) -> None:
    """Give each body room around where it will be for a time ahead, s, and in this step.

    What stands still moves against the frame, which may speed up as bodies do: it has some room.
    """
    frame_x, frame_y = settings[FRAME_VX], settings[FRAME_VY]
    spare = ROOM * mean_reach(kind, body) if frame_x != 0.0 or frame_y != 0.0 else 0.0
    for i in range(len(kind)):
        x, y, arm = pose[i, X], pose[i, Y], body[i, ARM]
        room = ROOM * body[i, REACH] if kind[i] > STATIC else spare
        by_x, by_y = (motion[i, VX] - frame_x) * ahead, (motion[i, VY] - frame_y) * ahead
        on_x, on_y = motion[i, DX], motion[i, DY]
        home[i, LOW_X] = x - room + min(by_x, on_x, 0.0)
        home[i, LOW_Y] = y - room + min(by_y, on_y, 0.0)
        home[i, HIGH_X] = x + room + max(by_x, on_x, 0.0)
        home[i, HIGH_Y] = y + room + max(by_y, on_y, 0.0)
        home[i, HOME_TURN] = pose[i, TURN]
        if kind[i] <= STATIC:
            home[i, TURN_ROOM] = 0.0
        elif arm > 0.0:
            turn = max(abs(motion[i, SPIN]) * ahead, abs(motion[i, DTURN]))
            home[i, TURN_ROOM] = room / arm + turn
        else:
            home[i, TURN_ROOM] = FAR


def mean_reach(kind: Whole, body: Array) -> float:
    """Return the mean radius of the bodies that move, m."""
    total = 0.0
    number = 0
    for i in range(len(kind)):
        if kind[i] == DYNAMIC:
            total += body[i, REACH]
            number += 1
    return total / number if number > 0 else 0.0


def fatten(
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    kind: Whole,
    body: Array,
    home: Array,
    turned: Array,
    box: Array,
) -> None:
    """Put a box around each shape: wherever its body may be at home, and what is near it there."""
    for s in range(len(shape_body)):
        i = shape_body[s]
        if shape_kind[s] == HALF_PLANE or kind[i] == ABSENT:
            continue
        low_x, low_y, high_x, high_y = FAR, FAR, -FAR, -FAR
        far = 0.0
        for k in range(shape_first[s], shape_first[s] + shape_count[s]):
            x, y = turned[k, 0], turned[k, 1]
            low_x, high_x = min(low_x, x), max(high_x, x)
            low_y, high_y = min(low_y, y), max(high_y, y)
            far = max(far, x * x + y * y)
        more = shape_radius[s]
        if kind[i] > STATIC:
            more += AROUND * body[i, REACH]
        if far > 0.0:  # what turning may do to corners
            more += min(home[i, TURN_ROOM], 2.0) * sqrt(far)
        box[s, FAT], box[s, FAT + 2] = (
            home[i, LOW_X] + low_x - more,
            home[i, HIGH_X] + high_x + more,
        )
        box[s, FAT + 1] = home[i, LOW_Y] + low_y - more
        box[s, FAT + 3] = home[i, HIGH_Y] + high_y + more


def find_pairs(
    counts: Whole,
    shape_kind: Whole,
    shape_body: Whole,
    filters: Whole,
    kind: Whole,
    ranked: Whole,
    box: Array,
    curve: Whole,
    node: Array,
    turned: Array,
    shape_first: Whole,
    found: Whole,
    pose: Array,
    home: Array,
) -> int:
    """Put all pairs whose boxes overlap into `found`, unsorted, as ranks; return how many.

    If there is no room for all of them, only their number is right.
    """
    leaves = grow_tree(shape_kind, shape_body, kind, ranked, box, curve, node)
    counts[LEAVES] = leaves
    for k in range(leaves):
        for n in range(4):
            box[k, n] = box[curve[0, k], FAT + n]
    total = 0
    first = lowest(leaves)
    for k in range(leaves):
        s = curve[0, k]
        low_x, low_y, high_x, high_y = box[k, 0], box[k, 1], box[k, 2], box[k, 3]
        start = k + 1  # those before have found this one
        at = first + k // BUNCH
        while True:
            while at < first:
                hit = (
                    (node[at, 0] <= high_x)
                    & (node[at, 2] >= low_x)
                    & (node[at, 1] <= high_y)
                    & (node[at, 3] >= low_y)
                )
                if not hit:
                    break
                at = 2 * at
            if at >= first:
                bunch = (at - first) * BUNCH
                for m in range(max(start, bunch), min(bunch + BUNCH, leaves)):
                    near = (
                        (box[m, 0] <= high_x)
                        & (box[m, 2] >= low_x)
                        & (box[m, 1] <= high_y)
                        & (box[m, 3] >= low_y)
                    )
                    if near and may_meet(s, curve[0, m], shape_body, kind, filters):
                        total = note_pair(total, s, curve[0, m], ranked, found)
            while at & 1:  # up, until there is a node to the right
                at >>= 1
            if at == 0:
                break
            at += 1
    for s in range(len(shape_kind)):
        if shape_kind[s] == HALF_PLANE and kind[shape_body[s]] != ABSENT:
            total = beside_plane(
                total,
                s,
                leaves,
                shape_body,
                kind,
                filters,
                turned[shape_first[s]],
                pose[shape_body[s]],
                home[shape_body[s]],
                box,
                curve,
                ranked,
                found,
            )
    return total


def beside_plane(
    total: int,
    s: int,
    leaves: int,
    shape_body: Whole,
    kind: Whole,
    filters: Whole,
    side: Array,
    place: Array,
    room: Array,
    box: Array,
    curve: Whole,
    ranked: Whole,
    found: Whole,
) -> int:
    """Note the shapes whose boxes reach a half-plane."""
    normal_x, normal_y = side[2], side[3]
    on_x = room[HIGH_X] if normal_x > 0.0 else room[LOW_X]
    on_y = room[HIGH_Y] if normal_y > 0.0 else room[LOW_Y]
    offset = side[0] + normal_x * (on_x - place[X]) + normal_y * (on_y - place[Y])
    for m in range(leaves):
        t = curve[0, m]
        x = box[t, FAT] if normal_x > 0.0 else box[t, FAT + 2]
        y = box[t, FAT + 1] if normal_y > 0.0 else box[t, FAT + 3]
        near = normal_x * x + normal_y * y <= offset
        if near and may_meet(s, t, shape_body, kind, filters):
            total = note_pair(total, s, t, ranked, found)
    return total


def may_meet(s: int, t: int, shape_body: Whole, kind: Whole, filters: Whole) -> bool:
    """Return whether two shapes are to be looked at at all."""
    i, j = shape_body[s], shape_body[t]
    if i == j or max(kind[i], kind[j]) != DYNAMIC:
        return False
    group = filters[s, GROUP]
    if group != 0 and group == filters[t, GROUP]:
        return bool(group > 0)
    return bool(
        (filters[s, CATEGORY] & filters[t, MASK]) != 0
        and (filters[t, CATEGORY] & filters[s, MASK]) != 0
    )


def note_pair(total: int, s: int, t: int, ranked: Whole, found: Whole) -> int:
    """Write down a pair by its ranks, the lower one first, if there is room; count it anyway."""
    if total < len(found):
        a, b = ranked[1, s], ranked[1, t]
        found[total, 0], found[total, 1] = min(a, b), max(a, b)
    return total + 1


def sort_pairs(total: int, found: Whole, starts: Whole) -> None:
    """Sort pairs by both ranks in the columns 0 and 1: by the second one, then by the first.

    There are no more ranks than shapes, so that counting puts each pair in its place.
    """
    for key in range(1, -1, -1):
        here, there = (0, 2) if key == 1 else (2, 0)
        for k in range(len(starts)):
            starts[k] = 0
        for p in range(total):
            starts[found[p, here + key] + 1] += 1
        for k in range(1, len(starts)):
            starts[k] += starts[k - 1]
        for p in range(total):
            rank = found[p, here + key]
            place = starts[rank]
            starts[rank] = place + 1
            found[place, there], found[place, there + 1] = found[p, here], found[p, here + 1]


def take_over(
    total: int,
    counts: Whole,
    ranked: Whole,
    found: Whole,
    surface: Array,
    mixed: Array,
    pairs: Whole,
    touches: Array,
    traces: Whole,
) -> int:
    """Make the sorted pairs the list in use, with what is known of those that were on it.

    Those that touched and are near no more stay once, for what ends with them to be told. Returns
    how many there are; where there is no room for them, the list is as it was.
    """
    side = counts[SIDE]
    pair, touch, trace = pairs[side], touches[side], traces[side]
    next_pair, next_touch, next_trace = pairs[1 - side], touches[1 - side], traces[1 - side]
    size = 0
    old = 0
    end = counts[PAIRS]
    for p in range(total + 1):
        a, b = (found[p, 0], found[p, 1]) if p < total else (len(ranked[1]), 0)
        while old < end:
            s, t = ranked[1, pair[old, 0]], ranked[1, pair[old, 1]]
            if s > a or (s == a and t >= b):
                break
            if trace[old, TOUCHED] != 0:
                if size < len(pair):
                    copy_pair(old, pair, touch, trace, size, next_pair, next_touch, next_trace)
                size += 1
            old += 1
        if p == total:
            break
        known = old < end and s == a and t == b
        if size < len(pair):
            if known:
                copy_pair(old, pair, touch, trace, size, next_pair, next_touch, next_trace)
            else:
                new_pair(
                    ranked[0, a],
                    ranked[0, b],
                    surface,
                    mixed,
                    size,
                    next_pair,
                    next_touch,
                    next_trace,
                )
        if known:
            old += 1
        size += 1
    if size <= len(pair):
        counts[SIDE] = 1 - side
        counts[PAIRS] = size
    return size


def copy_pair(
    old: int,
    pair: Whole,
    touch: Array,
    trace: Whole,
    new: int,
    next_pair: Whole,
    next_touch: Array,
    next_trace: Whole,
) -> None:
    """Copy what is known of a pair; of one that does not touch, only how its surfaces mix."""
    next_pair[new, 0], next_pair[new, 1] = pair[old, 0], pair[old, 1]
    if trace[old, COUNT] > 0 or trace[old, TOUCHED] != 0:
        for k in range(TOUCH):
            next_touch[new, k] = touch[old, k]
        for k in range(6):
            next_trace[new, k] = trace[old, k]
    else:
        blank(new, next_touch, next_trace)
        next_touch[new, PAIR_FRICTION] = touch[old, PAIR_FRICTION]
        next_touch[new, PAIR_RESTITUTION] = touch[old, PAIR_RESTITUTION]


def blank(p: int, touch: Array, trace: Whole) -> None:
    """Let nothing be known of how a pair touches."""
    for k in range(PUSH, CACHE):
        touch[p, k] = 0.0
    touch[p, PRELOAD] = touch[p, PRELOAD + 1] = 0.0
    for k in range(6):
        trace[p, k] = 0


def new_pair(
    s: int,
    t: int,
    surface: Array,
    mixed: Array,
    new: int,
    pair: Whole,
    touch: Array,
    trace: Whole,
) -> None:
    """Begin a pair: it does not touch, and its surfaces are mixed by the rules of the scene.

    `mixed` (k, 4) holds what was set for pairs of shapes: both, friction, restitution.
    """
    pair[new, 0], pair[new, 1] = s, t
    blank(new, touch, trace)
    touch[new, PAIR_FRICTION] = both_friction(surface[s, FRICTION], surface[t, FRICTION])
    touch[new, PAIR_RESTITUTION] = both_restitution(
        surface[s, RESTITUTION], surface[t, RESTITUTION]
    )
    for k in range(len(mixed)):
        one, other = mixed[k, 0], mixed[k, 1]
        if (one == s and other == t) or (one == t and other == s):
            touch[new, PAIR_FRICTION] = (
                mixed[k, 2] if mixed[k, 2] >= 0.0 else touch[new, PAIR_FRICTION]
            )
            touch[new, PAIR_RESTITUTION] = (
                mixed[k, 3] if mixed[k, 3] >= 0.0 else touch[new, PAIR_RESTITUTION]
            )


def both_friction(first: float, second: float) -> float:
    """Return the friction of two surfaces; -1 where one states none, and 0 if neither does."""
    if first < 0.0 or second < 0.0:
        return max(first, second, 0.0)
    return pair_friction(first, second)


def both_restitution(first: float, second: float) -> float:
    """Return the restitution of two surfaces; -1 where one states none, and 0 if neither does."""
    if first < 0.0 or second < 0.0:
        return max(first, second, 0.0)
    return pair_restitution(first, second)
