"""Who goes far in a step, and leaves the room in which its neighbours are known.

Serves: a step and flight. Hides: that neighbours are known a little farther than the room.
"""

from tamias2d.state import Array
from tamias2d.stepped.layout import (
    ARM,
    DTURN,
    DX,
    DY,
    DYNAMIC,
    FRAME_MOVES,
    FRAME_X,
    FRAME_Y,
    HIGH_X,
    HIGH_Y,
    HOME_TURN,
    INNER,
    KINEMATIC,
    LOW_X,
    LOW_Y,
    REACH,
    TURN,
    TURN_ROOM,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.pairs import AROUND
from tamias2d.stepped.sweep import MISSED

FAST = 0.35  # of half its width: how far a body goes before it is looked after
ANY_TURN = 2.0  # rad: where there is so much room, neighbours are known whichever way it turns


def goes_far(i: int, kind: Whole, motion: Array, body: Array) -> bool:
    """Return whether a body goes farther in this step than it could be pushed back from."""
    return bool((way_of(i, motion, body) > FAST * body[i, INNER]) & (kind[i] >= KINEMATIC))


def mark_outrun(
    settings: Array,
    kind: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    home: Array,
    used: Whole,
) -> int:
    """Mark bodies that go far and leave the room in which neighbours are known; return how many.

    They are known a little farther than the room, too.
    """
    left = 0
    for i in range(len(kind)):
        used[i] = 1 if leaves(i, settings, kind, pose, motion, body, home) else 0
        left += used[i]
    return left


def leaves(
    i: int, settings: Array, kind: Whole, pose: Array, motion: Array, body: Array, home: Array
) -> bool:
    """Return whether a body goes far, and out of where its neighbours are known.

    Where the frame moves on, what stands still goes far from it.
    """
    stays = settings[FRAME_MOVES] == 0.0 and way_of(i, motion, body) <= FAST * body[i, INNER]
    if kind[i] < KINEMATIC or stays:
        return False
    x = pose[i, X] + motion[i, DX] - settings[FRAME_X]
    y = pose[i, Y] + motion[i, DY] - settings[FRAME_Y]
    more = AROUND * body[i, REACH] if kind[i] == DYNAMIC else 0.0
    turn = abs(pose[i, TURN] + motion[i, DTURN] - home[i, HOME_TURN])
    return bool(
        (x < home[i, LOW_X] - more)
        | (x > home[i, HIGH_X] + more)
        | (y < home[i, LOW_Y] - more)
        | (y > home[i, HIGH_Y] + more)
        | (turn > home[i, TURN_ROOM]) & (home[i, TURN_ROOM] < ANY_TURN)
    )


def way_of(i: int, motion: Array, body: Array) -> float:
    """Return how far some point of a body may go in this step, m."""
    return abs(motion[i, DX]) + abs(motion[i, DY]) + abs(motion[i, DTURN]) * body[i, ARM]


def leaves_at(
    i: int,
    now: float,
    settings: Array,
    kind: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    home: Array,
) -> float:
    """Return the fraction of the step, from `now` on, at which a body leaves, or `MISSED`."""
    if not leaves(i, settings, kind, pose, motion, body, home):
        return MISSED
    if settings[FRAME_MOVES] != 0.0:
        return now
    more = AROUND * body[i, REACH]
    until = 1.0
    for k in range(2):
        start, way = pose[i, X + k] - settings[FRAME_X + k], motion[i, DX + k]
        low, high = home[i, LOW_X + k] - more, home[i, HIGH_X + k] + more
        until = min(until, leaves_between(start, way, low, high))
    if home[i, TURN_ROOM] < ANY_TURN:
        start, room = pose[i, TURN] - home[i, HOME_TURN], home[i, TURN_ROOM]
        until = min(until, leaves_between(start, motion[i, DTURN], -room, room))
    return max(until, now)


def leaves_between(start: float, way: float, low: float, high: float) -> float:
    """Return the fraction of a way, at most 1, at which it comes out of an interval."""
    if start + way > high and way > 0.0:
        return (high - start) / way
    if start + way < low and way < 0.0:
        return (low - start) / way
    return 1.0
