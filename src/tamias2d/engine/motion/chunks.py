"""One chunk of 16 bodies that are near nothing: how it takes a step, and how it is put back."""

from tamias2d.engine.tables import (
    ANGULAR,
    CHUNK,
    CHUNK_LANES,
    DECAY,
    DYNAMIC,
    FRAME_X,
    FRAME_Y,
    GAIN,
    GRAVITY_X,
    GRAVITY_Y,
    INVERSE_INERTIA,
    INVERSE_MASS,
    KINEMATIC,
    L_AFTER,
    L_AT,
    L_BEFORE,
    L_BY,
    L_DECAY,
    L_GAIN,
    L_HIGH,
    L_LIFT,
    L_LOW,
    L_SPEED,
    LIFT,
    PROPAGATOR,
    STATIC,
    WHOLE_STEP,
    Bodies,
    BodyState,
    BroadPhase,
    Chunks,
    Control,
    Integers,
)
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
    propagator = propagators[int(properties[PROPAGATOR])]
    for n in range(3):
        at = WHOLE_STEP + ANGULAR if n == 2 else WHOLE_STEP
        stream[L_DECAY + 3 * k + n] = propagator[at + DECAY]
        stream[L_GAIN + 3 * k + n] = propagator[at + GAIN]
        stream[L_LIFT + 3 * k + n] = propagator[at + LIFT]


def note_frame(broad_phase: BroadPhase, stream: Array, when: int) -> None:
    """Note for each lane where the frame is; angles are not seen from it."""
    for k in range(CHUNK):
        stream[when + 3 * k] = broad_phase.frame[FRAME_X]
        stream[when + 3 * k + 1] = broad_phase.frame[FRAME_Y]


@inlined
def begin_plain(
    pose: Array, velocity: Array, load_bits: Integers, course: Array, stream: Array
) -> int:
    """Note where a chunk is and let it take a step; return how many of its lanes may not.

    They are those with a load, or out of bounds before or after it. NaN is out of all bounds.
    """
    out = 0
    for m in range(CHUNK_LANES):
        here, now, by, gain = pose[m], velocity[m], stream[L_BY + m], stream[L_GAIN + m]
        course[L_AT + m], course[L_SPEED + m] = here, now
        to = here + coordinate_displacement(gain, stream[L_LIFT + m], now, by)
        pose[m] = to
        velocity[m] = coordinate_velocity_later(
            stream[L_DECAY + m], now, coordinate_velocity_gain(gain, by)
        )
        before, after = here - stream[L_BEFORE + m], to - stream[L_AFTER + m]
        low, high = course[L_LOW + m], course[L_HIGH + m]
        within = (before >= low) & (before <= high) & (after >= low) & (after <= high)
        out += 0 if within & (load_bits[m] == 0) else 1
    return out


@inlined
def take_lanes(pose: Array, velocity: Array, course: Array, stream: Array) -> int:
    """Let a chunk take a step; return how many of its lanes are out of bounds after it."""
    out = 0
    for m in range(CHUNK_LANES):
        now, by, gain = velocity[m], stream[L_BY + m], stream[L_GAIN + m]
        to = pose[m] + coordinate_displacement(gain, stream[L_LIFT + m], now, by)
        pose[m] = to
        velocity[m] = coordinate_velocity_later(
            stream[L_DECAY + m], now, coordinate_velocity_gain(gain, by)
        )
        after = to - stream[L_AFTER + m]
        out += 0 if (after >= course[L_LOW + m]) & (after <= course[L_HIGH + m]) else 1
    return out


def restore_chunk(g: int, chunks: Chunks) -> None:
    """Put a plain chunk back to where it was as the call began."""
    for m in range(CHUNK_LANES):
        chunks.poses[g, m] = chunks.course[g, L_AT + m]
        chunks.velocities[g, m] = chunks.course[g, L_SPEED + m]


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
        return CHUNK_LANES
    out = 0
    for m in range(CHUNK_LANES):
        before = course[L_AT + m] - frame[L_BEFORE + m]
        out += 0 if (before >= course[L_LOW + m]) & (before <= course[L_HIGH + m]) else 1
    return out + take_mixed(broad_phase, course, chunks.stream[g])


def take_mixed(broad_phase: BroadPhase, course: Array, stream: Array) -> int:
    """Let a mixed chunk take a step; return how many of its lanes are out of bounds after it."""
    note_frame(broad_phase, stream, L_AFTER)
    pose = course[L_AT : L_AT + CHUNK_LANES]
    velocity = course[L_SPEED : L_SPEED + CHUNK_LANES]
    return take_lanes(pose, velocity, course, stream)


def load_mixed(g: int, control: Control, state: BodyState, bodies: Bodies, chunks: Chunks) -> bool:
    """Bring a chunk to its row of the course; return whether its values are valid."""
    course, stream, kind = chunks.course[g], chunks.stream[g], state.kind
    pose, velocity, load = chunks.poses[g], chunks.velocities[g], chunks.loads[g]
    for m in range(CHUNK_LANES):
        course[L_AT + m] = course[L_SPEED + m] = 0.0
        stream[L_BY + m] = stream[L_DECAY + m] = stream[L_GAIN + m] = stream[L_LIFT + m] = 0.0
    for k in range(CHUNK):
        i, m = CHUNK * g + k, 3 * k
        if not is_valid(m, kind[i], pose, velocity, load):
            return False
        for n in range(3):
            course[L_AT + m + n] = pose[m + n] if kind[i] >= STATIC else 0.0
            course[L_SPEED + m + n] = velocity[m + n] if kind[i] >= KINEMATIC else 0.0
        if kind[i] >= KINEMATIC:
            set_propagator(k, state.properties[i], bodies.propagators, stream)
        if kind[i] == DYNAMIC:
            gravity = (control.settings[GRAVITY_X], control.settings[GRAVITY_Y])
            force, torque = (load[m], load[m + 1]), load[m + 2]
            by_x, by_y = acceleration(gravity, force, state.properties[i, INVERSE_MASS])
            stream[L_BY + m], stream[L_BY + m + 1] = by_x, by_y
            turning = angular_acceleration(torque, state.properties[i, INVERSE_INERTIA])
            stream[L_BY + m + 2] = turning
    return True


def is_valid(lane: int, kind: int, pose: Array, velocity: Array, load: Array) -> bool:
    """Return whether the values of a body, from a lane on, are finite, and a static one rests."""
    bad = moves = 0
    for m in range(lane, lane + 3):
        total = pose[m] + velocity[m] + load[m]
        bad += 0 if total - total == 0.0 else 1
        moves += 1 if velocity[m] != 0.0 else 0
    return bad == 0 and (kind != STATIC or moves == 0)


def store_mixed(g: int, kind: Integers, pose: Array, velocity: Array, course: Array) -> None:
    """Put the moving bodies of a chunk where its lanes got to."""
    for k in range(CHUNK):
        if kind[CHUNK * g + k] >= KINEMATIC:
            for m in range(3 * k, 3 * k + 3):
                pose[m], velocity[m] = course[L_AT + m], course[L_SPEED + m]
