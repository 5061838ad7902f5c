"""Steps of bodies that are near nothing: each along its closed form, without a look around.

Serves: the world, while no pair is on the list. Hides: that bodies go in crews, in one pass through
memory, and are put back where one of them may not go on. The bits are those of ordinary steps.

A lane is a coordinate of a body, and a crew is 48 of them in a row, which the compiler takes eight
at a time. Most crews are plain: all can be pushed, nothing but gravity does, and they flow alike
(DD41). They move where they are; a mixed crew moves beside, in its row, until all are known to
stay at home, which is where the list of pairs holds.
"""

from tamias2d.engine.broad_phase.bvh import FAR
from tamias2d.engine.broad_phase.comoving_frame import move_frame
from tamias2d.engine.tables import (
    ANGLE_MARGIN,
    ANGULAR,
    AT_START,
    BASE_ANGLE,
    CHUNK,
    CHUNK_LANES,
    CONTACTS,
    DECAY,
    DYNAMIC,
    FRAME_VX,
    FRAME_VY,
    FRAME_X,
    FRAME_Y,
    GAIN,
    GRAVITY_X,
    GRAVITY_Y,
    HIGH_X,
    HIGH_Y,
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
    LIST_HOLDS,
    LOW_X,
    LOW_Y,
    PLAIN,
    PROPAGATOR,
    SLEEP_STEPS,
    STAGE,
    STATIC,
    STEPS_TAKEN,
    UNIFORM,
    WHOLE_STEP,
    Bodies,
    BodyState,
    BroadPhase,
    Chunks,
    Control,
    Integers,
    World,
)
from tamias2d.generated.definitions import (
    acceleration,
    angular_acceleration,
    pace_given,
    pace_later,
    way,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

TOGETHER = 16  # crews that take all their steps before the next ones do: they fit the nearest cache

# course (g, 200), a row for each crew: where it may be; where it was and how it moved as the call
# began, or where a mixed one is and how it moves; then whether its bodies are alike, and whether it
# is plain now

# stream (g+1, 288), of each mixed crew what moves its lanes, how they flow, and where the frame is
# before and after a step; the last row is that of all plain crews


def integrate_ballistic(world: World, steps: int) -> int:
    """Take up to some steps, as long as no pair is near and every body at home; return how many.

    Poses, velocities and loads are those that users see, a row for each crew; the bits of loads
    tell whether nothing pushes, since not all zeros are alike. The course is of the homes as they
    are.
    """
    control, broad_phase, chunks = world.control, world.broad_phase, world.chunks
    clear = (
        control.counts[STAGE] == AT_START
        and broad_phase.counts[CONTACTS] == 0
        and broad_phase.counts[LIST_HOLDS] == 1
    )
    total = control.settings[GRAVITY_X] + control.settings[GRAVITY_Y]
    if not clear or world.islands.counts[SLEEP_STEPS] != 0 or total - total != 0.0:
        return 0
    note_gravity(control, chunks.stream[len(chunks.course)])
    x, y = broad_phase.frame[FRAME_X], broad_phase.frame[FRAME_Y]
    frame_x, frame_y = broad_phase.frame[FRAME_VX], broad_phase.frame[FRAME_VY]
    tried = 0
    while steps > 0 and steps != tried:
        tried = steps
        stretch = TOGETHER if steps > 1 else len(chunks.course)
        for first in range(0, len(chunks.course), stretch):
            last = min(first + stretch, len(chunks.course))
            steps = advance_chunks(
                steps, first, last, control, world.state, world.bodies, broad_phase, chunks
            )
            broad_phase.frame[FRAME_X], broad_phase.frame[FRAME_Y] = x, y
            broad_phase.frame[FRAME_VX], broad_phase.frame[FRAME_VY] = frame_x, frame_y
            if steps < tried:
                restore_chunks(last, chunks)
                break
    if steps > 0:
        for g in range(len(chunks.course)):
            if chunks.course[g, PLAIN] == 0.0:
                store_mixed(
                    g, world.state.kind, chunks.poses[g], chunks.velocities[g], chunks.course[g]
                )
        for _ in range(steps):
            move_frame(broad_phase)
        control.counts[STEPS_TAKEN] += steps
    return steps


def note_course(world: World) -> None:
    """Note where bodies may be, and which crews are uniform.

    They flow as the first body that can be pushed. Nobody may be where no number is.
    """
    state, bodies, chunks = world.state, world.bodies, world.chunks
    one = 0
    while one < len(state.kind) - 1 and state.kind[one] != DYNAMIC:
        one += 1
    plain = chunks.stream[len(chunks.course)]
    for k in range(CHUNK):
        set_propagator(k, state.properties[one], bodies.propagators, plain)
    for g in range(len(chunks.course)):
        row = chunks.course[g]
        alike = 0
        for k in range(CHUNK):
            i = CHUNK * g + k
            for n in range(3):
                row[L_LOW + 3 * k + n], row[L_HIGH + 3 * k + n] = -FAR, FAR
            if state.kind[i] >= STATIC:
                room = world.broad_phase.fat_bounds[state.slot_of_body[i]]
                turn, most = room[BASE_ANGLE], room[ANGLE_MARGIN]
                row[L_LOW + 3 * k], row[L_HIGH + 3 * k] = room[LOW_X], room[HIGH_X]
                row[L_LOW + 3 * k + 1], row[L_HIGH + 3 * k + 1] = room[LOW_Y], room[HIGH_Y]
                row[L_LOW + 3 * k + 2], row[L_HIGH + 3 * k + 2] = turn - most, turn + most
                alike += (
                    1
                    if state.kind[i] == DYNAMIC
                    and state.properties[i, PROPAGATOR] == state.properties[one, PROPAGATOR]
                    else 0
                )
        for m in range(CHUNK_LANES):
            row[L_LOW + m] = max(-FAR, row[L_LOW + m])
            row[L_HIGH + m] = min(FAR, row[L_HIGH + m])
        row[UNIFORM] = 1.0 if alike == CHUNK else 0.0


def set_propagator(k: int, properties: Array, propagators: Array, lanes: Array) -> None:
    """Let the lanes of a crew's k-th body flow as it does."""
    so = propagators[int(properties[PROPAGATOR])]
    for n in range(3):
        at = WHOLE_STEP + ANGULAR if n == 2 else WHOLE_STEP
        lanes[L_DECAY + 3 * k + n] = so[at + DECAY]
        lanes[L_GAIN + 3 * k + n] = so[at + GAIN]
        lanes[L_LIFT + 3 * k + n] = so[at + LIFT]


def note_gravity(control: Control, plain: Array) -> None:
    """Note what moves plain crews, on which nothing acts but gravity."""
    gravity = (control.settings[GRAVITY_X], control.settings[GRAVITY_Y])
    by_x, by_y = acceleration(gravity, (0.0, 0.0), 1.0)
    for k in range(CHUNK):
        plain[L_BY + 3 * k], plain[L_BY + 3 * k + 1] = by_x, by_y


def advance_chunks(
    steps: int,
    first: int,
    last: int,
    control: Control,
    state: BodyState,
    bodies: Bodies,
    broad_phase: BroadPhase,
    chunks: Chunks,
) -> int:
    """Let crews take some steps, or as many as all stay at home in; return how many."""
    plain = chunks.stream[len(chunks.course)]
    note_frame(broad_phase, plain, L_BEFORE)
    move_frame(broad_phase)
    note_frame(broad_phase, plain, L_AFTER)
    out = 0
    for g in range(first, last):
        chunks.course[g, PLAIN] = chunks.course[g, UNIFORM]
        if chunks.course[g, PLAIN] == 1.0:
            if (
                begin_plain(
                    chunks.poses[g],
                    chunks.velocities[g],
                    chunks.load_bits[g],
                    chunks.course[g],
                    plain,
                )
                == 0
            ):
                continue
            restore_chunk(g, chunks)
            chunks.course[g, PLAIN] = 0.0
        out += begin_mixed(g, control, state, bodies, broad_phase, chunks)
    taken = 0
    while out == 0:
        taken += 1
        if taken == steps:
            break
        move_frame(broad_phase)
        note_frame(broad_phase, plain, L_AFTER)
        for g in range(first, last):
            if chunks.course[g, PLAIN] == 1.0:
                out += advance_lanes(chunks.poses[g], chunks.velocities[g], chunks.course[g], plain)
            else:
                out += advance_mixed(broad_phase, chunks.course[g], chunks.stream[g])
    return taken


@inlined
def begin_plain(at: Array, speed: Array, load_bits: Integers, row: Array, flow: Array) -> int:
    """Keep where a crew is and let it take a step; return how many of its lanes may not do so.

    They are those that are pushed, or not at home before or after it. What is not a number, or
    moves as none, is not at home.
    """
    out = 0
    for m in range(CHUNK_LANES):
        here, now, by, gain = at[m], speed[m], flow[L_BY + m], flow[L_GAIN + m]
        row[L_AT + m], row[L_SPEED + m] = here, now
        to = here + way(gain, flow[L_LIFT + m], now, by)
        at[m] = to
        speed[m] = pace_later(flow[L_DECAY + m], now, pace_given(gain, by))
        before, after = here - flow[L_BEFORE + m], to - flow[L_AFTER + m]
        low, high = row[L_LOW + m], row[L_HIGH + m]
        home = (before >= low) & (before <= high) & (after >= low) & (after <= high)
        out += 0 if home & (load_bits[m] == 0) else 1
    return out


@inlined
def advance_lanes(at: Array, speed: Array, row: Array, flow: Array) -> int:
    """Let a crew take a step; return how many of its lanes are not at home after it."""
    out = 0
    for m in range(CHUNK_LANES):
        now, by, gain = speed[m], flow[L_BY + m], flow[L_GAIN + m]
        to = at[m] + way(gain, flow[L_LIFT + m], now, by)
        at[m] = to
        speed[m] = pace_later(flow[L_DECAY + m], now, pace_given(gain, by))
        after = to - flow[L_AFTER + m]
        out += 0 if (after >= row[L_LOW + m]) & (after <= row[L_HIGH + m]) else 1
    return out


def begin_mixed(
    g: int,
    control: Control,
    state: BodyState,
    bodies: Bodies,
    broad_phase: BroadPhase,
    chunks: Chunks,
) -> int:
    """Let any crew take a step in its row; return how many of its lanes may not do so."""
    row, frame = chunks.course[g], chunks.stream[len(chunks.course)]
    if not load_mixed(g, control, state, bodies, chunks):
        return CHUNK_LANES
    out = 0
    for m in range(CHUNK_LANES):
        before = row[L_AT + m] - frame[L_BEFORE + m]
        out += 0 if (before >= row[L_LOW + m]) & (before <= row[L_HIGH + m]) else 1
    return out + advance_mixed(broad_phase, row, chunks.stream[g])


def advance_mixed(broad_phase: BroadPhase, row: Array, flow: Array) -> int:
    """Let any crew take a step in its row; return how many of its lanes are not at home after."""
    note_frame(broad_phase, flow, L_AFTER)
    return advance_lanes(
        row[L_AT : L_AT + CHUNK_LANES], row[L_SPEED : L_SPEED + CHUNK_LANES], row, flow
    )


def load_mixed(g: int, control: Control, state: BodyState, bodies: Bodies, chunks: Chunks) -> bool:
    """Bring any crew to its row; return whether it is sound. What does not move rests."""
    row, flow, kind = chunks.course[g], chunks.stream[g], state.kind
    pose, velocity, load = chunks.poses[g], chunks.velocities[g], chunks.loads[g]
    for m in range(CHUNK_LANES):
        row[L_AT + m] = row[L_SPEED + m] = 0.0
        flow[L_BY + m] = flow[L_DECAY + m] = flow[L_GAIN + m] = flow[L_LIFT + m] = 0.0
    for k in range(CHUNK):
        i, m = CHUNK * g + k, 3 * k
        if not is_valid(m, kind[i], pose, velocity, load):
            return False
        for n in range(3):
            row[L_AT + m + n] = pose[m + n] if kind[i] >= STATIC else 0.0
            row[L_SPEED + m + n] = velocity[m + n] if kind[i] >= KINEMATIC else 0.0
        if kind[i] >= KINEMATIC:
            set_propagator(k, state.properties[i], bodies.propagators, flow)
        if kind[i] == DYNAMIC:
            gravity = (control.settings[GRAVITY_X], control.settings[GRAVITY_Y])
            force, torque = (load[m], load[m + 1]), load[m + 2]
            by_x, by_y = acceleration(gravity, force, state.properties[i, INVERSE_MASS])
            flow[L_BY + m], flow[L_BY + m + 1] = by_x, by_y
            flow[L_BY + m + 2] = angular_acceleration(torque, state.properties[i, INVERSE_INERTIA])
    return True


def is_valid(at: int, kind: int, pose: Array, velocity: Array, load: Array) -> bool:
    """Return whether all that users can set of a body are numbers, and a static one is at rest.

    Its lanes begin at a place of its crew.
    """
    bad = moves = 0
    for m in range(at, at + 3):
        total = pose[m] + velocity[m] + load[m]
        bad += 0 if total - total == 0.0 else 1
        moves += 1 if velocity[m] != 0.0 else 0
    return bad == 0 and (kind != STATIC or moves == 0)


def store_mixed(g: int, kind: Integers, pose: Array, velocity: Array, row: Array) -> None:
    """Put those of a crew that move where its lanes got to."""
    for k in range(CHUNK):
        if kind[CHUNK * g + k] >= KINEMATIC:
            for m in range(3 * k, 3 * k + 3):
                pose[m], velocity[m] = row[L_AT + m], row[L_SPEED + m]


def restore_chunks(last: int, chunks: Chunks) -> None:
    """Put plain crews where they were as the call began."""
    for g in range(last):
        if chunks.course[g, PLAIN] == 1.0:
            restore_chunk(g, chunks)


def restore_chunk(g: int, chunks: Chunks) -> None:
    """Put a plain crew where it was as the call began."""
    for m in range(CHUNK_LANES):
        chunks.poses[g, m], chunks.velocities[g, m] = (
            chunks.course[g, L_AT + m],
            chunks.course[g, L_SPEED + m],
        )


def note_frame(broad_phase: BroadPhase, flow: Array, when: int) -> None:
    """Note where the frame is for each lane; turns are seen as they are."""
    for k in range(CHUNK):
        flow[when + 3 * k], flow[when + 3 * k + 1] = (
            broad_phase.frame[FRAME_X],
            broad_phase.frame[FRAME_Y],
        )
