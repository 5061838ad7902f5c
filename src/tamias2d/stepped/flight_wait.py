"""Bodies for which a step has no more impacts: they wait for the next, where nothing is.

Serves: flight. Hides: what goes along with what cannot wait, and that nobody gains by waiting.
"""

from tamias2d.state import Array, Vector
from tamias2d.stepped.flight_impact import BENT
from tamias2d.stepped.flight_work import give_back, work_ahead
from tamias2d.stepped.layout import DTURN, DX, DY, DYNAMIC, TIME_STEP, Whole, X, Y
from tamias2d.stepped.trajectory import bend_line

ARC = 0.5  # rad: how far a wall turns at most while what it carries on goes along one line
# instead of 1 where a line is bent: as that of what is pushed on, carried on by a wall, or a wall;
# each time that a body is led on it comes nearer to the next of these
PUSHED_ON, CARRIED_ON, NOTHING_MOVES = 2.0, 3.0, 4.0
NEARER, NEARER_TO_WALL = 1.0 / 8.0, 1.0 / 64.0


def stand_by(
    i: int,
    j: int,
    now: float,
    settings: Array,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    gained: Array,
    kind: Whole,
) -> bool:
    """Let two bodies that meet wait for the next step; return whether this changes their lines.

    What has met something that cannot wait, or something that goes along with that, goes along,
    too. What is led on by walls is led on by nothing else, and by these not for ever: it may be
    jammed.
    """
    near_i, near_j = rank_of(i, gained, kind), rank_of(j, gained, kind)
    if max(near_i, near_j) < PUSHED_ON:
        wait(i, now, settings, pose, motion, load, body, kind)
        wait(j, now, settings, pose, motion, load, body, kind)
        return True
    if near_i < near_j:
        i, j = j, i
    near, wall = min(near_i, near_j), kind[i] != DYNAMIC
    if near >= (NOTHING_MOVES if wall else CARRIED_ON):
        return False
    way, turn = way_along(i, j, now, kind, pose, motion)
    lead(j, now, way, turn, settings, pose, motion, load, body)
    nearer = max(near + NEARER_TO_WALL, CARRIED_ON) if wall else max(near + NEARER, PUSHED_ON)
    gained[j, BENT] = nearer
    return True


def rank_of(i: int, gained: Array, kind: Whole) -> float:
    """Return how near a body is to something that nothing moves and that leads it on."""
    return float(gained[i, BENT]) if kind[i] == DYNAMIC else NOTHING_MOVES


def cannot_wait(i: int, gained: Array, kind: Whole) -> bool:
    """Return whether a body stays on its line whatever it meets, or goes along with such a one."""
    return rank_of(i, gained, kind) >= PUSHED_ON


def wait(
    i: int,
    now: float,
    settings: Array,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    kind: Whole,
) -> None:
    """Let a body stay where it is for the rest of the step."""
    if kind[i] == DYNAMIC:
        lead(i, now, (0.0, 0.0), 0.0, settings, pose, motion, load, body)


def way_along(
    i: int, j: int, now: float, kind: Whole, pose: Array, motion: Array
) -> tuple[Vector, float]:
    """Return the way of a body j, m and rad, as if it were a part of i, as far as a line can be.

    Along with a wall that turns it begins on the inside of its arc, and cuts that before the wall
    has turned by `ARC`: there both meet again.
    """
    x = pose[j, X] - pose[i, X] + now * (motion[j, DX] - motion[i, DX])
    y = pose[j, Y] - pose[i, Y] + now * (motion[j, DY] - motion[i, DY])
    turn = motion[i, DTURN]
    inwards = 0.0
    if kind[i] != DYNAMIC:
        inwards = abs(turn) * min(abs(turn) * (1.0 - now), 0.5 * ARC)
    way = (
        motion[i, DX] - turn * y - inwards * x,
        motion[i, DY] + turn * x - inwards * y,
    )
    return way, turn


def lead(
    i: int,
    now: float,
    way: Vector,
    turn: float,
    settings: Array,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
) -> None:
    """Lead a body another way, over a whole step, without an impulse: its velocity stays.

    But what forces have given it for the way that it does not go any more is taken back.
    """
    left, time_step = 1.0 - now, settings[TIME_STEP]
    before = work_ahead(i, left, settings, motion, load, body)
    by = (way[0] - motion[i, DX], way[1] - motion[i, DY])
    bend_line(i, now, by, turn - motion[i, DTURN], pose, motion)
    undone = before - work_ahead(i, left, settings, motion, load, body)
    support = (way[0] / time_step, way[1] / time_step)
    give_back(i, undone, support, turn / time_step, motion, body)
