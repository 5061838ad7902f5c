"""The frame in which fat bounds hold: it moves as bodies do in the mean, while nothing touches.

Where all bodies fall together, none comes nearer to another, and the contact list holds for long.
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
from tamias2d.generated.definitions import (
    acceleration,
    coordinate_displacement,
    coordinate_velocity_gain,
    coordinate_velocity_later,
)

FRAME_COLUMNS = FRAME_PROPAGATOR + 3


def choose_frame(
    control: Control, bodies: Bodies, broad_phase: BroadPhase, touching: Touching
) -> None:
    """Let the frame begin at the origin, with the mean velocity and acceleration of all bodies.

    It stands still where something touches, and where bodies are in flight within a step.
    """
    frame = broad_phase.frame
    for k in range(FRAME_COLUMNS):
        frame[k] = 0.0
    if touching.counts[TOUCHING] > 0 or control.counts[STAGE] == OUT_OF_BOUNDS:
        return
    gravity = (control.settings[GRAVITY_X], control.settings[GRAVITY_Y])
    number = 0
    for i in range(len(bodies.kind)):
        if bodies.kind[i] == DYNAMIC:
            properties, load = bodies.properties[i], bodies.load[i]
            by_x, by_y = acceleration(gravity, (load[0], load[1]), properties[INVERSE_MASS])
            frame[FRAME_VX] += bodies.motion[i, VX]
            frame[FRAME_VY] += bodies.motion[i, VY]
            frame[FRAME_AX] += by_x
            frame[FRAME_AY] += by_y
            propagator = bodies.propagators[int(properties[PROPAGATOR])]
            for k in range(3):
                frame[FRAME_PROPAGATOR + k] += propagator[WHOLE_STEP + k]
            number += 1
    if number > 0:
        for k in range(FRAME_COLUMNS):
            frame[k] /= number
        frame[FRAME_MOVES] = 1.0


def move_frame(broad_phase: BroadPhase) -> None:
    """Let the frame go on through a step (DD41)."""
    frame = broad_phase.frame
    if frame[FRAME_MOVES] == 0.0:
        return
    decay, gain = frame[FRAME_PROPAGATOR + DECAY], frame[FRAME_PROPAGATOR + GAIN]
    lift = frame[FRAME_PROPAGATOR + LIFT]
    for speed, by, at in ((FRAME_VX, FRAME_AX, FRAME_X), (FRAME_VY, FRAME_AY, FRAME_Y)):
        frame[at] += coordinate_displacement(gain, lift, frame[speed], frame[by])
        frame[speed] = coordinate_velocity_later(
            decay, frame[speed], coordinate_velocity_gain(gain, frame[by])
        )
