"""One chunk of 16 bodies that are near nothing: how it takes a step, and how it is put back."""

from tamias2d.engine import tables as tb
from tamias2d.engine.state import suits_kind
from tamias2d.engine.tables import Bodies, BodyState, BroadPhase, Chunks, Control, Integers
from tamias2d.generated.definitions import (
    acceleration,
    angular_acceleration,
    coordinate_displacement,
    coordinate_velocity_gain,
    coordinate_velocity_later,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array


def set_propagator(k: int, properties: Array, propagators: Array, stream: Array) -> None:
    """Give the lanes of a chunk's k-th body its propagator."""
    propagator = propagators[int(properties[tb.PROPAGATOR])]
    for n in range(3):
        at = tb.WHOLE_STEP + tb.ANGULAR if n == 2 else tb.WHOLE_STEP
        stream[tb.L_DECAY + 3 * k + n] = propagator[at + tb.DECAY]
        stream[tb.L_GAIN + 3 * k + n] = propagator[at + tb.GAIN]
        stream[tb.L_LIFT + 3 * k + n] = propagator[at + tb.LIFT]


def note_frame(broad_phase: BroadPhase, stream: Array, when: int) -> None:
    """Note for each lane where the frame is; angles are not seen from it."""
    for k in range(tb.CHUNK):
        stream[when + 3 * k] = broad_phase.frame[tb.FRAME_X]
        stream[when + 3 * k + 1] = broad_phase.frame[tb.FRAME_Y]


@inlined
def begin_plain(
    pose: Array, velocity: Array, load_bits: Integers, course: Array, stream: Array
) -> int:
    """Note where a chunk is and let it take a step; return how many of its lanes may not.

    They are those with a load, or out of bounds before or after it. NaN is out of all bounds.
    """
    out = 0
    for m in range(tb.CHUNK_LANES):
        here, now, by, gain = pose[m], velocity[m], stream[tb.L_BY + m], stream[tb.L_GAIN + m]
        course[tb.L_AT + m], course[tb.L_SPEED + m] = here, now
        to = here + coordinate_displacement(gain, stream[tb.L_LIFT + m], now, by)
        pose[m] = to
        velocity[m] = coordinate_velocity_later(
            stream[tb.L_DECAY + m], now, coordinate_velocity_gain(gain, by)
        )
        before, after = here - stream[tb.L_BEFORE + m], to - stream[tb.L_AFTER + m]
        low, high = course[tb.L_LOW + m], course[tb.L_HIGH + m]
        within = (before >= low) & (before <= high) & (after >= low) & (after <= high)
        out += 0 if within & (load_bits[m] == 0) else 1
    return out


@inlined
def take_lanes(pose: Array, velocity: Array, course: Array, stream: Array) -> int:
    """Let a chunk take a step; return how many of its lanes are out of bounds after it."""
    out = 0
    for m in range(tb.CHUNK_LANES):
        now, by, gain = velocity[m], stream[tb.L_BY + m], stream[tb.L_GAIN + m]
        to = pose[m] + coordinate_displacement(gain, stream[tb.L_LIFT + m], now, by)
        pose[m] = to
        velocity[m] = coordinate_velocity_later(
            stream[tb.L_DECAY + m], now, coordinate_velocity_gain(gain, by)
        )
        after = to - stream[tb.L_AFTER + m]
        out += 0 if (after >= course[tb.L_LOW + m]) & (after <= course[tb.L_HIGH + m]) else 1
    return out


def restore_chunk(g: int, chunks: Chunks) -> None:
    """Put a plain chunk back to where it was as the call began."""
    for m in range(tb.CHUNK_LANES):
        chunks.poses[g, m] = chunks.course[g, tb.L_AT + m]
        chunks.velocities[g, m] = chunks.course[g, tb.L_SPEED + m]


def begin_mixed(
    g: int,
    control: Control,
    state: BodyState,
    bodies: Bodies,
    broad_phase: BroadPhase,
    chunks: Chunks,
) -> int:
    """Let a chunk take a step in its row of the course; return how many of its lanes may not."""
    course, frame = chunks.course[g], chunks.stream[len(chunks.course)]
    if not load_mixed(g, control, state, bodies, chunks):
        return tb.CHUNK_LANES
    out = 0
    for m in range(tb.CHUNK_LANES):
        before = course[tb.L_AT + m] - frame[tb.L_BEFORE + m]
        out += 0 if (before >= course[tb.L_LOW + m]) & (before <= course[tb.L_HIGH + m]) else 1
    return out + take_mixed(broad_phase, course, chunks.stream[g])


def take_mixed(broad_phase: BroadPhase, course: Array, stream: Array) -> int:
    """Let a mixed chunk take a step; return how many of its lanes are out of bounds after it."""
    note_frame(broad_phase, stream, tb.L_AFTER)
    pose = course[tb.L_AT : tb.L_AT + tb.CHUNK_LANES]
    velocity = course[tb.L_SPEED : tb.L_SPEED + tb.CHUNK_LANES]
    return take_lanes(pose, velocity, course, stream)


def load_mixed(g: int, control: Control, state: BodyState, bodies: Bodies, chunks: Chunks) -> bool:
    """Bring a chunk to its row of the course; return whether its values are valid."""
    course, stream, kind = chunks.course[g], chunks.stream[g], state.kind
    pose, velocity, load = chunks.poses[g], chunks.velocities[g], chunks.loads[g]
    for m in range(tb.CHUNK_LANES):
        course[tb.L_AT + m] = course[tb.L_SPEED + m] = 0.0
        stream[tb.L_BY + m] = stream[tb.L_DECAY + m] = stream[tb.L_GAIN + m] = stream[
            tb.L_LIFT + m
        ] = 0.0
    for k in range(tb.CHUNK):
        i, m = tb.CHUNK * g + k, 3 * k
        if not is_valid(m, kind[i], pose, velocity, load):
            return False
        for n in range(3):
            course[tb.L_AT + m + n] = pose[m + n] if kind[i] >= tb.STATIC else 0.0
            course[tb.L_SPEED + m + n] = velocity[m + n] if kind[i] >= tb.KINEMATIC else 0.0
        if kind[i] >= tb.KINEMATIC:
            set_propagator(k, state.properties[i], bodies.propagators, stream)
        if kind[i] == tb.DYNAMIC:
            gravity = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
            force, torque = (load[m], load[m + 1]), load[m + 2]
            by_x, by_y = acceleration(gravity, force, state.properties[i, tb.INVERSE_MASS])
            stream[tb.L_BY + m], stream[tb.L_BY + m + 1] = by_x, by_y
            turning = angular_acceleration(torque, state.properties[i, tb.INVERSE_INERTIA])
            stream[tb.L_BY + m + 2] = turning
    return True


def is_valid(lane: int, kind: int, pose: Array, velocity: Array, load: Array) -> bool:
    """Return whether the values of a body, from a lane on, are finite, and suit its kind."""
    bad = 0
    for m in range(lane, lane + 3):
        total = pose[m] + velocity[m] + load[m]
        bad += 0 if total - total == 0.0 else 1
    suits = suits_kind(kind, pose[lane:], velocity[lane:], load[lane:])
    return bad == 0 and suits


def store_mixed(g: int, kind: Integers, pose: Array, velocity: Array, course: Array) -> None:
    """Put the moving bodies of a chunk where its lanes got to."""
    for k in range(tb.CHUNK):
        if kind[tb.CHUNK * g + k] >= tb.KINEMATIC:
            for m in range(3 * k, 3 * k + 3):
                pose[m], velocity[m] = course[tb.L_AT + m], course[tb.L_SPEED + m]
