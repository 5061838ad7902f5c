"""Steps of bodies that are near nothing: each along its closed form, without a look around.

Serves: the world, while no pair is on the list. Hides: that bodies take their steps in lanes, some
of them all of a call's at once, and that nothing is moved before all are known to stay where the
list holds. The bits are those of ordinary steps.

A lane is a coordinate of a body. Most groups of bodies are plain: all can be pushed, and flow alike
(DD41). Of these only places, velocities and loads are looked at, all in the order in memory.
"""

from tamias2d.generated.definitions import (
    acceleration,
    angular_acceleration,
    pace_given,
    pace_later,
    way,
)
from tamias2d.kernels.arrays import Bytes, FloatRows, Floats, Ranks
from tamias2d.state import Array
from tamias2d.stepped.frame import move_frame
from tamias2d.stepped.layout import (
    ANGULAR,
    BEGUN,
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
    PAIRS,
    PATIENCE,
    PHASE,
    STATIC,
    STILL,
    TURN_ROOM,
    Whole,
)
from tamias2d.stepped.tree import FAR

CREW = 16  # bodies whose lanes are a row
LANES_OF = 3 * CREW  # lanes of a row: x, y and turn of a body, and of the next
TOGETHER = 16  # rows that take all their steps before the next ones do: they fit the nearest cache

# course (g, 200), a row for each crew: where it may be; where it was and how it moved as the call
# began, or where a mixed one is and how it moves; then whether its bodies are alike, and whether it
# is plain now
L_LOW, L_HIGH, L_AT, L_SPEED, UNIFORM, PLAIN = 0, LANES_OF, 2 * LANES_OF, 3 * LANES_OF, 192, 193
COURSE = 200

# stream (17, 240), what moves the lanes of each crew that is mixed, and how they flow; the last row
# is for all that are plain, and has the place of the frame
L_BY, L_DECAY, L_GAIN, L_LIFT, L_FRAME = 0, LANES_OF, 2 * LANES_OF, 3 * LANES_OF, 4 * LANES_OF
STREAM = 240


def coast(
    steps: int,
    known: bool,
    settings: Floats,
    counts: Ranks,
    kind: Bytes,
    pose: Floats,
    velocity: Floats,
    load: Floats,
    load_bits: Ranks,
    body: FloatRows,
    home: FloatRows,
    course: FloatRows,
    stream: FloatRows,
) -> int:
    """Take up to some steps, as long as no pair is near and every body at home; return how many.

    Pose, velocity and load are flat. `known` is whether the course is of the homes as they are.
    Bits tell whether loads are zero, since not all zeros are alike.
    """
    clear = counts[PHASE] == BEGUN and counts[PAIRS] == 0 and counts[STILL] == 1
    total = settings[GRAVITY_X] + settings[GRAVITY_Y]
    if not clear or counts[PATIENCE] != 0 or total - total != 0.0:
        return 0
    if not known:
        know_course(kind, body, home, course, stream)
    fall_alike(settings, stream)
    tried = 0
    while steps > 0 and tried != steps:
        tried = steps
        for first in range(0, len(course), TOGETHER):
            rows = course[first : first + TOGETHER]
            a, b = LANES_OF * first, LANES_OF * (first + len(rows))
            at, speed = pose[a:b], velocity[a:b]
            sound = begin_lanes(
                first, settings, kind, pose, velocity, load, load_bits, body, rows, stream
            )
            steps = glide(steps, settings, at, speed, rows, stream) if sound else 0
            if steps < tried:
                put_back(course[: first + len(rows)], pose, velocity)
                break
    if steps > 0:
        for g in range(len(course)):
            if course[g, PLAIN] == 0.0:
                end_mixed(CREW * g, kind, pose, velocity, course[g])
        for _ in range(steps):
            move_frame(settings)
    return steps


def know_course(kind: Whole, body: Array, home: Array, course: Array, stream: Array) -> None:
    """Note where bodies may be, and which groups are plain.

    They flow as the first body that can be pushed.
    """
    one = 0
    while one < len(kind) - 1 and kind[one] != DYNAMIC:
        one += 1
    plain = stream[TOGETHER]
    for k in range(CREW):
        set_flow(k, body[one], plain)
    for g in range(len(course)):
        row = course[g]
        alike = 0
        for k in range(CREW):
            i = CREW * g + k
            for n in range(3):
                row[L_LOW + 3 * k + n], row[L_HIGH + 3 * k + n] = -FAR, FAR
            if i < len(kind) and kind[i] >= STATIC:
                turn, room = home[i, HOME_TURN], home[i, TURN_ROOM]
                row[L_LOW + 3 * k], row[L_HIGH + 3 * k] = home[i, LOW_X], home[i, HIGH_X]
                row[L_LOW + 3 * k + 1], row[L_HIGH + 3 * k + 1] = home[i, LOW_Y], home[i, HIGH_Y]
                row[L_LOW + 3 * k + 2], row[L_HIGH + 3 * k + 2] = turn - room, turn + room
                alike += 1 if kind[i] == DYNAMIC and flows_as(body[one], body[i]) else 0
        row[UNIFORM] = 1.0 if alike == CREW else 0.0


def flows_as(one: Array, other: Array) -> bool:
    """Return whether two bodies flow alike through a step."""
    alike = 0
    for n in range(2 * ANGULAR):
        alike += 1 if one[FULL + n] == other[FULL + n] else 0
    return alike == 2 * ANGULAR


def set_flow(k: int, body: Array, flow: Array) -> None:
    """Let the lanes of a group's k-th body flow as it does."""
    for n in range(3):
        at = FULL + ANGULAR if n == 2 else FULL
        flow[L_DECAY + 3 * k + n] = body[at + DECAY]
        flow[L_GAIN + 3 * k + n] = body[at + GAIN]
        flow[L_LIFT + 3 * k + n] = body[at + LIFT]


def fall_alike(settings: Array, stream: Array) -> None:
    """Note what moves plain crews, on which nothing acts but gravity."""
    plain = stream[TOGETHER]
    gravity = (settings[GRAVITY_X], settings[GRAVITY_Y])
    by_x, by_y = acceleration(gravity, (0.0, 0.0), 1.0)
    for k in range(CREW):
        plain[L_BY + 3 * k], plain[L_BY + 3 * k + 1] = by_x, by_y


def begin_lanes(
    first: int,
    settings: Array,
    kind: Whole,
    pose: Array,
    velocity: Array,
    load: Array,
    load_bits: Whole,
    body: Array,
    rows: Array,
    stream: Array,
) -> bool:
    """Make crews ready to go; return whether all that users can set is sound, and they at home."""
    note_frame(settings, stream)
    fine = True
    for g in range(len(rows)):
        row = rows[g]
        a, b = LANES_OF * (first + g), LANES_OF * (first + g + 1)
        row[PLAIN] = row[UNIFORM]
        if row[PLAIN] == 1.0:
            bad = begin_plain(pose[a:b], velocity[a:b], load_bits[a:b], row, stream[TOGETHER])
            row[PLAIN] = 1.0 if bad == 0 else 0.0
        if row[PLAIN] == 0.0:
            i = CREW * (first + g)
            sound = begin_mixed(i, settings, kind, pose, velocity, load, body, row, stream[g])
            fine = fine and sound and are_home(row, stream[TOGETHER])
    return fine


def begin_plain(at: Array, speed: Array, load_bits: Whole, row: Array, frame: Array) -> int:
    """Keep where a crew is; return how many of its lanes are pushed, not sound or not at home."""
    bad = 0
    for m in range(LANES_OF):
        here, now = at[m], speed[m]
        row[L_AT + m], row[L_SPEED + m] = here, now
        seen = here - frame[L_FRAME + m]
        fine = (seen >= row[L_LOW + m]) & (seen <= row[L_HIGH + m]) & (here - here == 0.0)
        bad += 0 if fine & (now - now == 0.0) & (load_bits[m] == 0) else 1
    return bad


def begin_mixed(
    first: int,
    settings: Array,
    kind: Whole,
    pose: Array,
    velocity: Array,
    load: Array,
    body: Array,
    row: Array,
    flow: Array,
) -> bool:
    """Bring any crew to its row; return whether it is sound. What does not move rests."""
    for m in range(LANES_OF):
        row[L_AT + m] = row[L_SPEED + m] = 0.0
        flow[L_BY + m] = flow[L_DECAY + m] = flow[L_GAIN + m] = flow[L_LIFT + m] = 0.0
    for k in range(min(CREW, len(kind) - first)):
        i = first + k
        if not is_sound(i, kind, pose, velocity, load):
            return False
        for n in range(3):
            row[L_AT + 3 * k + n] = pose[3 * i + n] if kind[i] >= STATIC else 0.0
            row[L_SPEED + 3 * k + n] = velocity[3 * i + n] if kind[i] >= KINEMATIC else 0.0
        if kind[i] >= KINEMATIC:
            set_flow(k, body[i], flow)
        if kind[i] == DYNAMIC:
            gravity = (settings[GRAVITY_X], settings[GRAVITY_Y])
            force, torque = (load[3 * i], load[3 * i + 1]), load[3 * i + 2]
            by_x, by_y = acceleration(gravity, force, body[i, INVERSE_MASS])
            flow[L_BY + 3 * k], flow[L_BY + 3 * k + 1] = by_x, by_y
            flow[L_BY + 3 * k + 2] = angular_acceleration(torque, body[i, INVERSE_INERTIA])
    return True


def is_sound(i: int, kind: Whole, pose: Array, velocity: Array, load: Array) -> bool:
    """Return whether all that users can set of a body are numbers, and a static one is at rest."""
    bad = moves = 0
    for m in range(3 * i, 3 * i + 3):
        total = pose[m] + velocity[m] + load[m]
        bad += 0 if total - total == 0.0 else 1
        moves += 1 if velocity[m] != 0.0 else 0
    return bad == 0 and (kind[i] != STATIC or moves == 0)


def end_mixed(first: int, kind: Whole, pose: Array, velocity: Array, row: Array) -> None:
    """Put those of a crew that move where its lanes got to."""
    for k in range(min(CREW, len(kind) - first)):
        i = first + k
        if kind[i] >= KINEMATIC:
            for n in range(3):
                pose[3 * i + n] = row[L_AT + 3 * k + n]
                velocity[3 * i + n] = row[L_SPEED + 3 * k + n]


def put_back(rows: Array, pose: Array, velocity: Array) -> None:
    """Put plain crews where they were as the call began."""
    for g in range(len(rows)):
        if rows[g, PLAIN] == 1.0:
            for m in range(LANES_OF):
                pose[LANES_OF * g + m] = rows[g, L_AT + m]
                velocity[LANES_OF * g + m] = rows[g, L_SPEED + m]


def glide(
    steps: int, settings: Array, pose: Array, velocity: Array, rows: Array, stream: Array
) -> int:
    """Let crews take some steps, or as many as all stay at home in; return how many.

    The frame is then where it was.
    """
    x, y = settings[FRAME_X], settings[FRAME_Y]
    frame_x, frame_y = settings[FRAME_VX], settings[FRAME_VY]
    taken = out = 0
    while out == 0 and taken < steps:
        move_frame(settings)
        note_frame(settings, stream)
        for g in range(len(rows)):
            a, b = LANES_OF * g, LANES_OF * (g + 1)
            row, frame = rows[g], stream[TOGETHER]
            if row[PLAIN] == 1.0:
                out += go_on(pose[a:b], velocity[a:b], row, frame, frame)
            else:
                at, speed = row[L_AT : L_AT + LANES_OF], row[L_SPEED : L_SPEED + LANES_OF]
                out += go_on(at, speed, row, stream[g], frame)
        taken += 1 if out == 0 else 0
    settings[FRAME_X], settings[FRAME_Y] = x, y
    settings[FRAME_VX], settings[FRAME_VY] = frame_x, frame_y
    return taken


def note_frame(settings: Array, stream: Array) -> None:
    """Note where the frame is for each lane; turns are seen as they are."""
    frame = stream[TOGETHER]
    for k in range(CREW):
        frame[L_FRAME + 3 * k] = settings[FRAME_X]
        frame[L_FRAME + 3 * k + 1] = settings[FRAME_Y]


def go_on(at: Array, speed: Array, row: Array, flow: Array, frame: Array) -> int:
    """Let a crew take a step; return how many lanes are where the list of pairs does not hold.

    What is not a number is nowhere.
    """
    out = 0
    for m in range(LANES_OF):
        now, by, gain = speed[m], flow[L_BY + m], flow[L_GAIN + m]
        to = at[m] + way(gain, flow[L_LIFT + m], now, by)
        at[m] = to
        speed[m] = pace_later(flow[L_DECAY + m], now, pace_given(gain, by))
        seen = to - frame[L_FRAME + m]
        out += 0 if (seen >= row[L_LOW + m]) & (seen <= row[L_HIGH + m]) else 1
    return out


def are_home(row: Array, frame: Array) -> bool:
    """Return whether a mixed crew is where the list of pairs holds."""
    out = 0
    for m in range(LANES_OF):
        seen = row[L_AT + m] - frame[L_FRAME + m]
        out += 0 if (seen >= row[L_LOW + m]) & (seen <= row[L_HIGH + m]) else 1
    return out == 0
