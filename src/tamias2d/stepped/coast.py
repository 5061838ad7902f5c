"""Steps of bodies that are near nothing: each along its closed form, without a look around.

Serves: a step, while no pair is on the list. Hides: that bodies take their steps in lanes, all of a
call at once, and that nothing is moved before all are known to stay where the list holds. The bits
are those of ordinary steps.
"""

from tamias2d.generated.definitions import acceleration, angular_acceleration
from tamias2d.state import Array
from tamias2d.stepped.frame import move_frame
from tamias2d.stepped.layout import (
    ANGULAR,
    DECAY,
    DYNAMIC,
    FRAME_VX,
    FRAME_VY,
    FRAME_X,
    FRAME_Y,
    FULL,
    GAIN,
    GRAVITY_X,
    GRAVITY_Y,
    HIGH_X,
    HIGH_Y,
    HOME_TURN,
    INVERSE_INERTIA,
    INVERSE_MASS,
    KINEMATIC,
    LIFT,
    LOW_X,
    LOW_Y,
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
from tamias2d.stepped.rows import LANES
from tamias2d.stepped.tree import FAR

# rows of lanes on the bench: three coordinates, their velocities, what moves them, how each flows;
# then where they may be
L_AT, L_SPEED, L_BY, L_DECAY, L_GAIN, L_LIFT = 0, 48, 96, 144, 192, 240
L_LOW, L_HIGH = 288, 336
COASTING = 384
"""How much of the bench this takes."""


def coast(
    steps: int,
    settings: Array,
    kind: Whole,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    home: Array,
    bench: Array,
    carried: Array,
) -> int:
    """Take up to some steps, as long as every body stays at home; return how many.

    `carried` (n+1, 12) is for where they get to.
    """
    frame = (settings[FRAME_X], settings[FRAME_Y], settings[FRAME_VX], settings[FRAME_VY])
    pull = settings[GRAVITY_X] + settings[GRAVITY_Y]
    if pull - pull != 0.0:
        return 0
    while steps > 0:
        left = steps
        for first in range(0, len(kind), LANES):
            load_lanes(first, settings, kind, pose, motion, load, body, home, bench)
            left = glide(left, settings, bench)
            (
                settings[FRAME_X],
                settings[FRAME_Y],
                settings[FRAME_VX],
                settings[FRAME_VY],
            ) = frame
            store_lanes(first, bench, carried)
        if left == steps:
            break
        steps = left
    if steps > 0:
        for i in range(len(kind)):
            if kind[i] >= KINEMATIC:
                for n in range(3):
                    pose[i, n], motion[i, n] = carried[i, n], carried[i, 3 + n]
        for _ in range(steps):
            move_frame(settings)
    return steps


def load_lanes(
    first: int,
    settings: Array,
    kind: Whole,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    home: Array,
    bench: Array,
) -> None:
    """Bring bodies to the bench; lanes without one rest, with all the room there is."""
    gravity = (settings[GRAVITY_X], settings[GRAVITY_Y])
    for m in range(LANES):
        i = first + m
        if i >= len(kind) or kind[i] < STATIC:
            rest(m, bench)
            for n in range(3):
                bench[L_LOW + LANES * n + m], bench[L_HIGH + LANES * n + m] = -FAR, FAR
            if i < len(kind) and not is_sound(i, pose, motion, load):
                bench[L_LOW + m] = FAR
            continue
        bench[L_LOW + m], bench[L_HIGH + m] = home[i, LOW_X], home[i, HIGH_X]
        bench[L_LOW + LANES + m], bench[L_HIGH + LANES + m] = home[i, LOW_Y], home[i, HIGH_Y]
        turn, room = home[i, HOME_TURN], home[i, TURN_ROOM]
        bench[L_LOW + 2 * LANES + m], bench[L_HIGH + 2 * LANES + m] = turn - room, turn + room
        moves = motion[i, VX] != 0.0 or motion[i, VY] != 0.0 or motion[i, SPIN] != 0.0
        if kind[i] == STATIC:
            rest(m, bench)
        if not is_sound(i, pose, motion, load) or (kind[i] == STATIC and moves):
            bench[L_LOW + m] = FAR  # out of its room: it is for an ordinary step to tell
        by_x = by_y = turn = 0.0
        if kind[i] == DYNAMIC:
            by_x, by_y = acceleration(gravity, (load[i, 0], load[i, 1]), body[i, INVERSE_MASS])
            turn = angular_acceleration(load[i, 2], body[i, INVERSE_INERTIA])
        bench[L_BY + m], bench[L_BY + LANES + m] = by_x, by_y
        bench[L_BY + 2 * LANES + m] = turn
        for n in range(3):
            bench[L_AT + LANES * n + m] = pose[i, n]
            if kind[i] != STATIC:
                bench[L_SPEED + LANES * n + m] = motion[i, n]
                at = FULL + ANGULAR if n == 2 else FULL
                bench[L_DECAY + LANES * n + m] = body[i, at + DECAY]
                bench[L_GAIN + LANES * n + m] = body[i, at + GAIN]
                bench[L_LIFT + LANES * n + m] = body[i, at + LIFT]


def is_sound(i: int, pose: Array, motion: Array, load: Array) -> bool:
    """Return whether all that users can set of a body are numbers, and not too large."""
    total = pose[i, X] + pose[i, Y] + pose[i, TURN] + load[i, 0] + load[i, 1] + load[i, 2]
    total += motion[i, VX] + motion[i, VY] + motion[i, SPIN]
    return bool(total - total == 0.0)


def rest(m: int, bench: Array) -> None:
    """Let a lane stay where it is: nothing flows."""
    for n in range(L_LOW // LANES):
        bench[LANES * n + m] = 0.0


def store_lanes(first: int, bench: Array, carried: Array) -> None:
    """Write where bodies got to, and how they move."""
    for m in range(min(LANES, len(carried) - first)):
        for n in range(6):  # places, then velocities
            carried[first + m, n] = bench[LANES * n + m]


def glide(steps: int, settings: Array, bench: Array) -> int:
    """Let the lanes take some steps, or as many as they stay at home in; return how many."""
    if leave(settings, bench):
        return 0
    for k in range(steps):
        for m in range(3 * LANES):
            speed, by = bench[L_SPEED + m], bench[L_BY + m]
            bench[L_AT + m] += bench[L_GAIN + m] * speed + bench[L_LIFT + m] * by
            bench[L_SPEED + m] = bench[L_DECAY + m] * speed + bench[L_GAIN + m] * by
        move_frame(settings)
        if leave(settings, bench):
            return k
    return steps


def leave(settings: Array, bench: Array) -> bool:
    """Return whether some lane is where the list of pairs does not hold, or not a number."""
    out = 0
    for m in range(LANES):
        x, y = bench[L_AT + m] - settings[FRAME_X], bench[L_AT + LANES + m] - settings[FRAME_Y]
        turn = bench[L_AT + 2 * LANES + m]
        inside = (
            (x >= bench[L_LOW + m])
            & (x <= bench[L_HIGH + m])
            & (y >= bench[L_LOW + LANES + m])
            & (y <= bench[L_HIGH + LANES + m])
            & (turn >= bench[L_LOW + 2 * LANES + m])
            & (turn <= bench[L_HIGH + 2 * LANES + m])
        )
        out += 0 if inside else 1
    return out > 0
