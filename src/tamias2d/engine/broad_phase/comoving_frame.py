"""The frame in which the list of pairs holds: it moves with all bodies while nothing touches.

Serves: the look around and a step. Hides: how it moves on, by the mean of what moves the bodies.
Where all fall together, nobody comes nearer to anybody, and the list holds for long.
"""

from tamias2d.engine.tables import (
    DECAY,
    DYNAMIC,
    FRAME_AX,
    FRAME_AY,
    FRAME_MOVES,
    FRAME_PROPAGATOR,
    FRAME_VX,
    FRAME_VY,
    FRAME_X,
    FRAME_Y,
    GAIN,
    GRAVITY_X,
    GRAVITY_Y,
    INVERSE_MASS,
    LIFT,
    OUT_OF_BOUNDS,
    PROPAGATOR,
    STAGE,
    TOUCHING,
    VX,
    VY,
    WHOLE_STEP,
    Bodies,
    BroadPhase,
    Control,
    Touching,
)
from tamias2d.generated.definitions import acceleration, pace_given, pace_later, way


def choose_frame(
    control: Control, bodies: Bodies, broad_phase: BroadPhase, touching: Touching
) -> None:
    """Let the frame be where bodies are, and move as they do in the mean.

    Where something touches it stands still, and within a step, when bodies are on their ways.
    """
    for k in range(FRAME_VX, FRAME_PROPAGATOR + 3):
        broad_phase.frame[k] = 0.0
    if touching.counts[TOUCHING] > 0 or control.counts[STAGE] == OUT_OF_BOUNDS:
        return
    gravity = (control.settings[GRAVITY_X], control.settings[GRAVITY_Y])
    number = 0
    for i in range(len(bodies.kind)):
        if bodies.kind[i] == DYNAMIC:
            by_x, by_y = acceleration(
                gravity, (bodies.load[i, 0], bodies.load[i, 1]), bodies.properties[i, INVERSE_MASS]
            )
            broad_phase.frame[FRAME_VX] += bodies.motion[i, VX]
            broad_phase.frame[FRAME_VY] += bodies.motion[i, VY]
            broad_phase.frame[FRAME_AX] += by_x
            broad_phase.frame[FRAME_AY] += by_y
            so = bodies.propagators[int(bodies.properties[i, PROPAGATOR])]
            for k in range(3):
                broad_phase.frame[FRAME_PROPAGATOR + k] += so[WHOLE_STEP + k]
            number += 1
    if number > 0:
        for k in range(FRAME_VX, FRAME_PROPAGATOR + 3):
            broad_phase.frame[k] /= number
        broad_phase.frame[FRAME_MOVES] = 1.0


def move_frame(broad_phase: BroadPhase) -> None:
    """Let the frame go on through a step (DD41)."""
    if broad_phase.frame[FRAME_MOVES] == 0.0:
        return
    decay, gain = (
        broad_phase.frame[FRAME_PROPAGATOR + DECAY],
        broad_phase.frame[FRAME_PROPAGATOR + GAIN],
    )
    lift = broad_phase.frame[FRAME_PROPAGATOR + LIFT]
    for speed, by, at in ((FRAME_VX, FRAME_AX, FRAME_X), (FRAME_VY, FRAME_AY, FRAME_Y)):
        broad_phase.frame[at] += way(gain, lift, broad_phase.frame[speed], broad_phase.frame[by])
        broad_phase.frame[speed] = pace_later(
            decay, broad_phase.frame[speed], pace_given(gain, broad_phase.frame[by])
        )
