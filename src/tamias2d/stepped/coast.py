"""Steps of bodies that are near nothing: each along its closed form, without a look around.

Serves: a step, while no pair is on the list. Hides: that all bodies are tried before one is moved,
since the list must hold where they arrive. The bits are those of an ordinary step.
"""

from tamias2d.state import Array
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


def coast(
    steps: int,
    settings: Array,
    kind: Whole,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    home: Array,
) -> int:
    """Take up to some steps, as long as every body stays at home; return how many."""
    for k in range(steps):
        if not stays(settings, kind, pose, motion, load, body, home):
            return k
        go_on(settings, kind, pose, motion, load, body)
    return steps


def stays(
    settings: Array,
    kind: Whole,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    home: Array,
) -> bool:
    """Return whether all bodies are where the list of pairs holds, now and after a step."""
    out = 0
    for i in range(len(kind)):
        x, y = pose[i, X] - settings[FRAME_X], pose[i, Y] - settings[FRAME_Y]
        turn = pose[i, TURN] - home[i, HOME_TURN]
        on_x = on_y = 0.0
        if kind[i] >= KINEMATIC:
            free = 1.0 if kind[i] == DYNAMIC else 0.0
            mass = body[i, INVERSE_MASS]
            gain, lift = body[i, FULL + GAIN], body[i, FULL + LIFT]
            on_x = gain * motion[i, VX] + lift * (free * settings[GRAVITY_X] + mass * load[i, 0])
            on_y = gain * motion[i, VY] + lift * (free * settings[GRAVITY_Y] + mass * load[i, 1])
        inside = (
            (min(x, x + on_x) >= home[i, LOW_X])
            & (max(x, x + on_x) <= home[i, HIGH_X])
            & (min(y, y + on_y) >= home[i, LOW_Y])
            & (max(y, y + on_y) <= home[i, HIGH_Y])
            & (abs(turn) <= home[i, TURN_ROOM])
        )
        out += 0 if inside or kind[i] < STATIC else 1
    return out == 0


def go_on(
    settings: Array, kind: Whole, pose: Array, motion: Array, load: Array, body: Array
) -> None:
    """Take a step of all bodies (IM1, IM6), and of the frame."""
    sum_x = sum_y = 0.0
    number = 0
    for i in range(len(kind)):
        if kind[i] < KINEMATIC:
            continue
        by_x = by_y = turn = 0.0
        if kind[i] == DYNAMIC:
            mass = body[i, INVERSE_MASS]
            by_x = settings[GRAVITY_X] + mass * load[i, 0]
            by_y = settings[GRAVITY_Y] + mass * load[i, 1]
            turn = body[i, INVERSE_INERTIA] * load[i, 2]
        gain, lift, decay = body[i, FULL + GAIN], body[i, FULL + LIFT], body[i, FULL + DECAY]
        on_x = gain * motion[i, VX] + lift * by_x
        on_y = gain * motion[i, VY] + lift * by_y
        pose[i, X] += on_x
        pose[i, Y] += on_y
        motion[i, VX] = decay * motion[i, VX] + gain * by_x
        motion[i, VY] = decay * motion[i, VY] + gain * by_y
        at = FULL + ANGULAR
        gain, lift, decay = body[i, at + GAIN], body[i, at + LIFT], body[i, at + DECAY]
        pose[i, TURN] += gain * motion[i, SPIN] + lift * turn
        motion[i, SPIN] = decay * motion[i, SPIN] + gain * turn
        if kind[i] == DYNAMIC:
            sum_x += on_x
            sum_y += on_y
            number += 1
    if number > 0 and (settings[FRAME_VX] != 0.0 or settings[FRAME_VY] != 0.0):
        settings[FRAME_X] += sum_x / number
        settings[FRAME_Y] += sum_y / number
