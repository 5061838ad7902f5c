"""The frame in which the list of pairs holds: it moves with all bodies while nothing touches.

Serves: the look around and a step. Hides: how it moves on, by the mean of what moves the bodies.
Where all fall together, nobody comes nearer to anybody, and the list holds for long.
"""

from tamias2d.generated.definitions import acceleration, pace_given, pace_later, way
from tamias2d.state import Array
from tamias2d.stepped.layout import (
    DECAY,
    DYNAMIC,
    FLOW,
    FRAME_BY_X,
    FRAME_BY_Y,
    FRAME_FLOW,
    FRAME_MOVES,
    FRAME_VX,
    FRAME_VY,
    FRAME_X,
    FRAME_Y,
    FULL,
    GAIN,
    GRAVITY_X,
    GRAVITY_Y,
    HITS,
    INVERSE_MASS,
    LIFT,
    OUTRUN,
    PHASE,
    VX,
    VY,
    Whole,
)


def choose_frame(
    settings: Array,
    counts: Whole,
    kind: Whole,
    motion: Array,
    load: Array,
    body: Array,
    flows: Array,
) -> None:
    """Let the frame be where bodies are, and move as they do in the mean.

    Where something touches it stands still, and within a step, when bodies are on their ways.
    """
    for k in range(FRAME_VX, FRAME_FLOW + 3):
        settings[k] = 0.0
    if counts[HITS] > 0 or counts[PHASE] == OUTRUN:
        return
    gravity = (settings[GRAVITY_X], settings[GRAVITY_Y])
    number = 0
    for i in range(len(kind)):
        if kind[i] == DYNAMIC:
            by_x, by_y = acceleration(gravity, (load[i, 0], load[i, 1]), body[i, INVERSE_MASS])
            settings[FRAME_VX] += motion[i, VX]
            settings[FRAME_VY] += motion[i, VY]
            settings[FRAME_BY_X] += by_x
            settings[FRAME_BY_Y] += by_y
            so = flows[int(body[i, FLOW])]
            for k in range(3):
                settings[FRAME_FLOW + k] += so[FULL + k]
            number += 1
    if number > 0:
        for k in range(FRAME_VX, FRAME_FLOW + 3):
            settings[k] /= number
        settings[FRAME_MOVES] = 1.0


def move_frame(settings: Array) -> None:
    """Let the frame go on through a step (DD41)."""
    if settings[FRAME_MOVES] == 0.0:
        return
    decay, gain = settings[FRAME_FLOW + DECAY], settings[FRAME_FLOW + GAIN]
    lift = settings[FRAME_FLOW + LIFT]
    for speed, by, at in ((FRAME_VX, FRAME_BY_X, FRAME_X), (FRAME_VY, FRAME_BY_Y, FRAME_Y)):
        settings[at] += way(gain, lift, settings[speed], settings[by])
        settings[speed] = pace_later(decay, settings[speed], pace_given(gain, settings[by]))
