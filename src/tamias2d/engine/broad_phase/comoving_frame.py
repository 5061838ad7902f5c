"""The frame in which fat bounds hold: it moves as bodies do in the mean, while nothing touches.

Where all bodies fall together, none comes nearer to another, and the contact list holds for long.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, BroadPhase, Control, Touching
from tamias2d.generated.definitions import (
    acceleration,
    coordinate_displacement,
    coordinate_velocity_gain,
    coordinate_velocity_later,
)

FRAME_COLUMNS = tb.FRAME_PROPAGATOR + 3


def choose_frame(
    control: Control, bodies: Bodies, broad_phase: BroadPhase, touching: Touching
) -> None:
    """Let the frame begin at the origin, with the mean velocity and acceleration of all bodies.

    It stands still where something touches, and where bodies are in flight within a step.
    """
    frame = broad_phase.frame
    stand_still(broad_phase)
    if touching.counts[tb.TOUCHING] > 0 or control.counts[tb.STAGE] == tb.OUT_OF_BOUNDS:
        return
    gravity = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
    number = 0
    for i in range(len(bodies.kind)):
        if bodies.kind[i] == tb.DYNAMIC:
            properties, load = bodies.properties[i], bodies.load[i]
            by_x, by_y = acceleration(gravity, (load[0], load[1]), properties[tb.INVERSE_MASS])
            frame[tb.FRAME_VX] += bodies.motion[i, tb.VX]
            frame[tb.FRAME_VY] += bodies.motion[i, tb.VY]
            frame[tb.FRAME_AX] += by_x
            frame[tb.FRAME_AY] += by_y
            propagator = bodies.propagators[int(properties[tb.PROPAGATOR])]
            for k in range(3):
                frame[tb.FRAME_PROPAGATOR + k] += propagator[tb.WHOLE_STEP + k]
            number += 1
    if number > 0:
        for k in range(FRAME_COLUMNS):
            frame[k] /= number
        frame[tb.FRAME_MOVES] = 1.0


def stand_still(broad_phase: BroadPhase) -> None:
    """Let the frame stand at the origin."""
    for k in range(FRAME_COLUMNS):
        broad_phase.frame[k] = 0.0


def move_frame(broad_phase: BroadPhase) -> None:
    """Let the frame go on through a step (DD41)."""
    frame = broad_phase.frame
    if frame[tb.FRAME_MOVES] == 0.0:
        return
    decay, gain = frame[tb.FRAME_PROPAGATOR + tb.DECAY], frame[tb.FRAME_PROPAGATOR + tb.GAIN]
    lift = frame[tb.FRAME_PROPAGATOR + tb.LIFT]
    for speed, by, at in (
        (tb.FRAME_VX, tb.FRAME_AX, tb.FRAME_X),
        (tb.FRAME_VY, tb.FRAME_AY, tb.FRAME_Y),
    ):
        frame[at] += coordinate_displacement(gain, lift, frame[speed], frame[by])
        frame[speed] = coordinate_velocity_later(
            decay, frame[speed], coordinate_velocity_gain(gain, frame[by])
        )
