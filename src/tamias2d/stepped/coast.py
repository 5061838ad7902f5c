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
LANE = 3 * CREW  # lanes of a row: x, y and turn of a body, and of the next
TOGETHER = 16  # rows that take all their steps before the next ones do: they fit the nearest cache

# course (g, 200), a row for each group: where it is, how it moves, and where it may be; then
# whether its bodies are alike, and whether it is plain now
L_AT, L_SPEED, L_LOW, L_HIGH, UNIFORM, PLAIN = 0, LANE, 2 * LANE, 3 * LANE, 4 * LANE, 4 * LANE + 1
COURSE = 200

# stream (17, 240), what moves the lanes of each row that is not plain, and how they flow; the last
# one is for all that are plain, and has the place of the frame
L_BY, L_DECAY, L_GAIN, L_LIFT, L_FRAME = 0, LANE, 2 * LANE, 3 * LANE, 4 * LANE
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

    Pose, velocity and load are flat. `known` is whether the course is of the homes as they are; a
    plain group is known by the bits of its loads, since not all zeros are alike.
    """
    alone = counts[PHASE] == BEGUN and counts[PAIRS] == 0 and counts[STILL] == 1
    pull = settings[GRAVITY_X] + settings[GRAVITY_Y]
    if not alone or counts[PATIENCE] != 0 or pull - pull != 0.0:
        return 0
    if not known:
        know_course(kind, body, home, course, stream)
    flow_alike(settings, stream)
    while steps > 0:
        taken = steps
        for first in range(0, len(course), TOGETHER):
            rows = course[first : first + TOGETHER]
            sound = begin_lanes(
                first, settings, kind, pose, velocity, load, load_bits, body, rows, stream
            )
            taken = glide(taken, settings, rows, stream) if sound else 0
            if taken == 0:
                return 0
        if taken == steps:
            break
        steps = taken
    for row in range(len(course)):
        end_lanes(row, kind, pose, velocity, course[row])
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


def flow_alike(settings: Array, stream: Array) -> None:
    """Note what moves plain groups, on which nothing acts but gravity."""
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
    """Bring groups to their lanes; return whether all that users can set of them is sound."""
    for g in range(len(rows)):
        a, b = LANE * (first + g), LANE * (first + g + 1)
        plain = rows[g, UNIFORM] == 1.0
        plain = plain and begin_plain(pose[a:b], velocity[a:b], load_bits[a:b], rows[g])
        rows[g, PLAIN] = 1.0 if plain else 0.0
        if not plain and not begin_mixed(
            CREW * (first + g), settings, kind, pose, velocity, load, body, rows[g], stream[g]
        ):
            return False
    return True


def begin_plain(pose: Array, velocity: Array, load_bits: Whole, row: Array) -> bool:
    """Bring a group to its lanes; return whether nothing but gravity acts on it, and it is sound."""
    bad = 0
    for m in range(LANE):
        at, speed = pose[m], velocity[m]
        row[L_AT + m], row[L_SPEED + m] = at, speed
        bad += 0 if (at - at == 0.0) & (speed - speed == 0.0) & (load_bits[m] == 0) else 1
    return bad == 0


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
    """Bring any group to its lanes; return whether it is sound. What does not move rests."""
    gravity = (settings[GRAVITY_X], settings[GRAVITY_Y])
    for m in range(LANE):
        row[L_AT + m] = row[L_SPEED + m] = 0.0
        flow[L_BY + m] = flow[L_DECAY + m] = flow[L_GAIN + m] = flow[L_LIFT + m] = 0.0
    for k in range(min(CREW, len(kind) - first)):
        i = first + k
        bad = moves = 0
        for m in range(3 * i, 3 * i + 3):
            total = pose[m] + velocity[m] + load[m]
            bad += 0 if total - total == 0.0 else 1
            moves += 1 if velocity[m] != 0.0 else 0
        if bad > 0 or (kind[i] == STATIC and moves > 0):
            return False
        for n in range(3):
            row[L_AT + 3 * k + n] = pose[3 * i + n] if kind[i] >= STATIC else 0.0
            row[L_SPEED + 3 * k + n] = velocity[3 * i + n] if kind[i] >= KINEMATIC else 0.0
        if kind[i] >= KINEMATIC:
            set_flow(k, body[i], flow)
        if kind[i] == DYNAMIC:
            force, torque = (load[3 * i], load[3 * i + 1]), load[3 * i + 2]
            by_x, by_y = acceleration(gravity, force, body[i, INVERSE_MASS])
            flow[L_BY + 3 * k], flow[L_BY + 3 * k + 1] = by_x, by_y
            flow[L_BY + 3 * k + 2] = angular_acceleration(torque, body[i, INVERSE_INERTIA])
    return True


def end_lanes(g: int, kind: Whole, pose: Array, velocity: Array, row: Array) -> None:
    """Put a group where its lanes got to."""
    if row[PLAIN] == 1.0:
        at, speed = pose[LANE * g : LANE * (g + 1)], velocity[LANE * g : LANE * (g + 1)]
        for m in range(LANE):
            at[m], speed[m] = row[L_AT + m], row[L_SPEED + m]
        return
    for k in range(min(CREW, len(kind) - CREW * g)):
        i = CREW * g + k
        if kind[i] >= KINEMATIC:
            for n in range(3):
                pose[3 * i + n] = row[L_AT + 3 * k + n]
                velocity[3 * i + n] = row[L_SPEED + 3 * k + n]


def glide(steps: int, settings: Array, rows: Array, stream: Array) -> int:
    """Let lanes take some steps, or as many as they stay at home in; return how many.

    The frame is then where it was.
    """
    x, y, frame_x, frame_y = (
        settings[FRAME_X], settings[FRAME_Y], settings[FRAME_VX], settings[FRAME_VY],
    )  # fmt: skip
    taken = 0
    stay = not leave(settings, rows, stream)
    while stay and taken < steps:
        for g in range(len(rows)):
            go_on(rows[g], stream[TOGETHER if rows[g, PLAIN] == 1.0 else g])
        move_frame(settings)
        stay = not leave(settings, rows, stream)
        taken += 1 if stay else 0
    settings[FRAME_X], settings[FRAME_Y] = x, y
    settings[FRAME_VX], settings[FRAME_VY] = frame_x, frame_y
    return taken


def go_on(row: Array, flow: Array) -> None:
    """Let the lanes of a group take a step."""
    for m in range(LANE):
        speed, by, gain = row[L_SPEED + m], flow[L_BY + m], flow[L_GAIN + m]
        row[L_AT + m] += way(gain, flow[L_LIFT + m], speed, by)
        row[L_SPEED + m] = pace_later(flow[L_DECAY + m], speed, pace_given(gain, by))


def leave(settings: Array, rows: Array, stream: Array) -> bool:
    """Return whether some lane is where the list of pairs does not hold, or not a number."""
    frame = stream[TOGETHER]
    for k in range(CREW):
        frame[L_FRAME + 3 * k] = settings[FRAME_X]
        frame[L_FRAME + 3 * k + 1] = settings[FRAME_Y]
    out = 0
    for g in range(len(rows)):
        row = rows[g]
        for m in range(LANE):
            at = row[L_AT + m] - frame[L_FRAME + m]
            out += 0 if (at >= row[L_LOW + m]) & (at <= row[L_HIGH + m]) else 1
    return out > 0
