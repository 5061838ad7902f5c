"""Rooms of bodies: where each may be until the list of pairs is not known to hold any more.

Serves: the look around, and a step, which asks whether the list still holds. Hides: how much room
each body has. It is relative to sizes and to what the motion at hand would take.
"""

from tamias2d.state import Array
from tamias2d.stepped.layout import (
    ABSENT,
    ARM,
    DTURN,
    DX,
    DY,
    DYNAMIC,
    FRAME_MOVES,
    FRAME_VX,
    FRAME_VY,
    FRAME_X,
    FRAME_Y,
    HIGH_X,
    HIGH_Y,
    HOME_TURN,
    KINEMATIC,
    LOW_X,
    LOW_Y,
    REACH,
    SPIN,
    STATIC,
    TURN,
    TURN_ROOM,
    VX,
    VY,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.tree import FAR

ROOM = 0.1  # of the reach, or the mean if that is less: how far a body may go from its way


def mark_left(settings: Array, kind: Whole, pose: Array, home: Array, used: Whole) -> int:
    """Mark bodies that are where the list of pairs is not known to hold; return how many.

    Rooms move with the frame: where all fall together, nobody comes nearer to anybody.
    """
    left = 0
    for i in range(len(kind)):
        used[i] = 1 if is_out(i, settings, kind, pose, home) else 0
        left += used[i]
    return left


def is_out(i: int, settings: Array, kind: Whole, pose: Array, home: Array) -> bool:
    """Return whether a body is out of its room."""
    x, y = pose[i, X] - settings[FRAME_X], pose[i, Y] - settings[FRAME_Y]
    inside = (
        (x >= home[i, LOW_X])
        & (x <= home[i, HIGH_X])
        & (y >= home[i, LOW_Y])
        & (y <= home[i, HIGH_Y])
        & (abs(pose[i, TURN] - home[i, HOME_TURN]) <= home[i, TURN_ROOM])
    )
    return bool((not inside) & (kind[i] != ABSENT))


def left_behind(settings: Array, kind: Whole, pose: Array, motion: Array, home: Array) -> bool:
    """Return whether something that nothing pushes leaves its room within the step.

    It does so where the frame moves on without it.
    """
    if settings[FRAME_MOVES] == 0.0:
        return False
    out = False
    for i in range(len(kind)):
        x = pose[i, X] + motion[i, DX] - settings[FRAME_X]
        y = pose[i, Y] + motion[i, DY] - settings[FRAME_Y]
        inside = (
            (x >= home[i, LOW_X])
            & (x <= home[i, HIGH_X])
            & (y >= home[i, LOW_Y])
            & (y <= home[i, HIGH_Y])
        )
        out = out | ((not inside) & ((kind[i] == STATIC) | (kind[i] == KINEMATIC)))
    return bool(out)


def settle(
    settings: Array,
    ahead: float,
    kind: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    home: Array,
) -> None:
    """Give each body room around where it will be for a time ahead, s, and in this step."""
    mean = mean_reach(kind, body)
    for i in range(len(kind)):
        settle_one(i, mean, settings, ahead, kind, pose, motion, body, home)


def settle_one(
    i: int,
    mean: float,
    settings: Array,
    ahead: float,
    kind: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    home: Array,
) -> None:
    """Give a body room, where bodies reach `mean` on the average, m.

    What stands still moves against the frame, which may speed up as bodies do: it has some room.
    """
    frame_x, frame_y = settings[FRAME_VX], settings[FRAME_VY]
    spare = ROOM * mean if settings[FRAME_MOVES] != 0.0 else 0.0
    room = ROOM * min(body[i, REACH], mean) if kind[i] > STATIC else spare
    x, y = pose[i, X] - settings[FRAME_X], pose[i, Y] - settings[FRAME_Y]
    by_x, by_y = (motion[i, VX] - frame_x) * ahead, (motion[i, VY] - frame_y) * ahead
    on_x, on_y = motion[i, DX], motion[i, DY]
    home[i, LOW_X] = x - room + min(by_x, on_x, 0.0)
    home[i, LOW_Y] = y - room + min(by_y, on_y, 0.0)
    home[i, HIGH_X] = x + room + max(by_x, on_x, 0.0)
    home[i, HIGH_Y] = y + room + max(by_y, on_y, 0.0)
    home[i, HOME_TURN] = pose[i, TURN]
    arm = body[i, ARM]
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
