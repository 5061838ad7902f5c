"""Steps of bodies that are near nothing: each along its closed form, without a look around.

Serves: the world, while no pair is on the list. Hides: that bodies go in crews, in one pass through
memory, and are put back where one of them may not go on. The bits are those of ordinary steps.

A lane is a coordinate of a body, and a crew is 48 of them in a row, which the compiler takes eight
at a time. Most crews are plain: all can be pushed, nothing but gravity does, and they flow alike
(DD41). They move where they are; a mixed crew moves beside, in its row, until all are known to
stay at home, which is where the list of pairs holds.
"""

from tamias2d.generated.definitions import (
    acceleration,
    angular_acceleration,
    pace_given,
    pace_later,
    way,
)
from tamias2d.kernels.arrays import Bytes, FloatRows, Floats, Places, RankRows, Ranks
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array
from tamias2d.stepped.frame import move_frame
from tamias2d.stepped.layout import (
    ANGULAR,
    BEGUN,
    DECAY,
    DYNAMIC,
    FLOW,
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
TOGETHER = 16  # crews that take all their steps before the next ones do: they fit the nearest cache

# course (g, 200), a row for each crew: where it may be; where it was and how it moved as the call
# began, or where a mixed one is and how it moves; then whether its bodies are alike, and whether it
# is plain now
L_LOW, L_HIGH, L_AT, L_SPEED, UNIFORM, PLAIN = 0, LANES_OF, 2 * LANES_OF, 3 * LANES_OF, 192, 193
COURSE = 200

# stream (g+1, 288), of each mixed crew what moves its lanes, how they flow, and where the frame is
# before and after a step; the last row is that of all plain crews
L_BY, L_DECAY, L_GAIN, L_LIFT = 0, LANES_OF, 2 * LANES_OF, 3 * LANES_OF
L_BEFORE, L_AFTER = 4 * LANES_OF, 5 * LANES_OF
STREAM = 288


def coast(
    settings: Floats,
    counts: Ranks,
    kind: Bytes,
    poses: FloatRows,
    velocities: FloatRows,
    loads: FloatRows,
    load_bits: RankRows,
    body: FloatRows,
    flows: FloatRows,
    course: FloatRows,
    stream: FloatRows,
    steps: int,
) -> int:
    """Take up to some steps, as long as no pair is near and every body at home; return how many.

    Poses, velocities and loads are those that users see, a row for each crew; the bits of loads
    tell whether nothing pushes, since not all zeros are alike. The course is of the homes as they
    are.
    """
    clear = counts[PHASE] == BEGUN and counts[PAIRS] == 0 and counts[STILL] == 1
    total = settings[GRAVITY_X] + settings[GRAVITY_Y]
    if not clear or counts[PATIENCE] != 0 or total - total != 0.0:
        return 0
    fall_alike(settings, stream[len(course)])
    x, y = settings[FRAME_X], settings[FRAME_Y]
    frame_x, frame_y = settings[FRAME_VX], settings[FRAME_VY]
    tried = 0
    while steps > 0 and steps != tried:
        tried = steps
        stretch = TOGETHER if steps > 1 else len(course)
        for first in range(0, len(course), stretch):
            last = min(first + stretch, len(course))
            steps = glide(
                steps, first, last, settings, kind, poses, velocities, loads, load_bits, body,
                flows, course, stream,
            )  # fmt: skip
            settings[FRAME_X], settings[FRAME_Y] = x, y
            settings[FRAME_VX], settings[FRAME_VY] = frame_x, frame_y
            if steps < tried:
                put_back(last, poses, velocities, course)
                break
    if steps > 0:
        for g in range(len(course)):
            if course[g, PLAIN] == 0.0:
                end_mixed(g, kind, poses[g], velocities[g], course[g])
        for _ in range(steps):
            move_frame(settings)
    return steps


def know_course(
    kind: Bytes,
    body: FloatRows,
    flows: FloatRows,
    home: FloatRows,
    seat: Places,
    course: FloatRows,
    stream: FloatRows,
) -> None:
    """Note where bodies may be, and which crews are uniform.

    They flow as the first body that can be pushed. Nobody may be where no number is.
    """
    one = 0
    while one < len(kind) - 1 and kind[one] != DYNAMIC:
        one += 1
    plain = stream[len(course)]
    for k in range(CREW):
        set_flow(k, body[one], flows, plain)
    for g in range(len(course)):
        row = course[g]
        alike = 0
        for k in range(CREW):
            i = CREW * g + k
            for n in range(3):
                row[L_LOW + 3 * k + n], row[L_HIGH + 3 * k + n] = -FAR, FAR
            if kind[i] >= STATIC:
                room = home[seat[i]]
                turn, most = room[HOME_TURN], room[TURN_ROOM]
                row[L_LOW + 3 * k], row[L_HIGH + 3 * k] = room[LOW_X], room[HIGH_X]
                row[L_LOW + 3 * k + 1], row[L_HIGH + 3 * k + 1] = room[LOW_Y], room[HIGH_Y]
                row[L_LOW + 3 * k + 2], row[L_HIGH + 3 * k + 2] = turn - most, turn + most
                alike += 1 if kind[i] == DYNAMIC and body[i, FLOW] == body[one, FLOW] else 0
        for m in range(LANES_OF):
            row[L_LOW + m] = max(-FAR, row[L_LOW + m])
            row[L_HIGH + m] = min(FAR, row[L_HIGH + m])
        row[UNIFORM] = 1.0 if alike == CREW else 0.0


def set_flow(k: int, body: Array, flows: Array, lanes: Array) -> None:
    """Let the lanes of a crew's k-th body flow as it does."""
    so = flows[int(body[FLOW])]
    for n in range(3):
        at = FULL + ANGULAR if n == 2 else FULL
        lanes[L_DECAY + 3 * k + n] = so[at + DECAY]
        lanes[L_GAIN + 3 * k + n] = so[at + GAIN]
        lanes[L_LIFT + 3 * k + n] = so[at + LIFT]


def fall_alike(settings: Array, plain: Array) -> None:
    """Note what moves plain crews, on which nothing acts but gravity."""
    gravity = (settings[GRAVITY_X], settings[GRAVITY_Y])
    by_x, by_y = acceleration(gravity, (0.0, 0.0), 1.0)
    for k in range(CREW):
        plain[L_BY + 3 * k], plain[L_BY + 3 * k + 1] = by_x, by_y


def glide(
    steps: int,
    first: int,
    last: int,
    settings: Array,
    kind: Whole,
    poses: Array,
    velocities: Array,
    loads: Array,
    load_bits: Whole,
    body: Array,
    flows: Array,
    course: Array,
    stream: Array,
) -> int:
    """Let crews take some steps, or as many as all stay at home in; return how many."""
    plain = stream[len(course)]
    note_frame(settings, plain, L_BEFORE)
    move_frame(settings)
    note_frame(settings, plain, L_AFTER)
    out = 0
    for g in range(first, last):
        course[g, PLAIN] = course[g, UNIFORM]
        if course[g, PLAIN] == 1.0:
            if start_off(poses[g], velocities[g], load_bits[g], course[g], plain) == 0:
                continue
            put_back_one(g, poses, velocities, course)
            course[g, PLAIN] = 0.0
        out += start_off_mixed(
            g, settings, kind, poses, velocities, loads, body, flows, course, stream
        )
    taken = 0
    while out == 0:
        taken += 1
        if taken == steps:
            break
        move_frame(settings)
        note_frame(settings, plain, L_AFTER)
        for g in range(first, last):
            if course[g, PLAIN] == 1.0:
                out += go_on(poses[g], velocities[g], course[g], plain)
            else:
                out += go_on_mixed(settings, course[g], stream[g])
    return taken


@inlined
def start_off(at: Array, speed: Array, load_bits: Whole, row: Array, flow: Array) -> int:
    """Keep where a crew is and let it take a step; return how many of its lanes may not do so.

    They are those that are pushed, or not at home before or after it. What is not a number, or
    moves as none, is not at home.
    """
    out = 0
    for m in range(LANES_OF):
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
def go_on(at: Array, speed: Array, row: Array, flow: Array) -> int:
    """Let a crew take a step; return how many of its lanes are not at home after it."""
    out = 0
    for m in range(LANES_OF):
        now, by, gain = speed[m], flow[L_BY + m], flow[L_GAIN + m]
        to = at[m] + way(gain, flow[L_LIFT + m], now, by)
        at[m] = to
        speed[m] = pace_later(flow[L_DECAY + m], now, pace_given(gain, by))
        after = to - flow[L_AFTER + m]
        out += 0 if (after >= row[L_LOW + m]) & (after <= row[L_HIGH + m]) else 1
    return out


def start_off_mixed(
    g: int,
    settings: Array,
    kind: Whole,
    poses: Array,
    velocities: Array,
    loads: Array,
    body: Array,
    flows: Array,
    course: Array,
    stream: Array,
) -> int:
    """Let any crew take a step in its row; return how many of its lanes may not do so."""
    row, frame = course[g], stream[len(course)]
    if not begin_mixed(
        g, settings, kind, poses[g], velocities[g], loads[g], body, flows, row, stream[g]
    ):
        return LANES_OF
    out = 0
    for m in range(LANES_OF):
        before = row[L_AT + m] - frame[L_BEFORE + m]
        out += 0 if (before >= row[L_LOW + m]) & (before <= row[L_HIGH + m]) else 1
    return out + go_on_mixed(settings, row, stream[g])


def go_on_mixed(settings: Array, row: Array, flow: Array) -> int:
    """Let any crew take a step in its row; return how many of its lanes are not at home after."""
    note_frame(settings, flow, L_AFTER)
    return go_on(row[L_AT : L_AT + LANES_OF], row[L_SPEED : L_SPEED + LANES_OF], row, flow)


def begin_mixed(
    g: int,
    settings: Array,
    kind: Whole,
    pose: Array,
    velocity: Array,
    load: Array,
    body: Array,
    flows: Array,
    row: Array,
    flow: Array,
) -> bool:
    """Bring any crew to its row; return whether it is sound. What does not move rests."""
    for m in range(LANES_OF):
        row[L_AT + m] = row[L_SPEED + m] = 0.0
        flow[L_BY + m] = flow[L_DECAY + m] = flow[L_GAIN + m] = flow[L_LIFT + m] = 0.0
    for k in range(CREW):
        i, m = CREW * g + k, 3 * k
        if not is_sound(m, kind[i], pose, velocity, load):
            return False
        for n in range(3):
            row[L_AT + m + n] = pose[m + n] if kind[i] >= STATIC else 0.0
            row[L_SPEED + m + n] = velocity[m + n] if kind[i] >= KINEMATIC else 0.0
        if kind[i] >= KINEMATIC:
            set_flow(k, body[i], flows, flow)
        if kind[i] == DYNAMIC:
            gravity = (settings[GRAVITY_X], settings[GRAVITY_Y])
            force, torque = (load[m], load[m + 1]), load[m + 2]
            by_x, by_y = acceleration(gravity, force, body[i, INVERSE_MASS])
            flow[L_BY + m], flow[L_BY + m + 1] = by_x, by_y
            flow[L_BY + m + 2] = angular_acceleration(torque, body[i, INVERSE_INERTIA])
    return True


def is_sound(at: int, kind: int, pose: Array, velocity: Array, load: Array) -> bool:
    """Return whether all that users can set of a body are numbers, and a static one is at rest.

    Its lanes begin at a place of its crew.
    """
    bad = moves = 0
    for m in range(at, at + 3):
        total = pose[m] + velocity[m] + load[m]
        bad += 0 if total - total == 0.0 else 1
        moves += 1 if velocity[m] != 0.0 else 0
    return bad == 0 and (kind != STATIC or moves == 0)


def end_mixed(g: int, kind: Whole, pose: Array, velocity: Array, row: Array) -> None:
    """Put those of a crew that move where its lanes got to."""
    for k in range(CREW):
        if kind[CREW * g + k] >= KINEMATIC:
            for m in range(3 * k, 3 * k + 3):
                pose[m], velocity[m] = row[L_AT + m], row[L_SPEED + m]


def put_back(last: int, poses: Array, velocities: Array, course: Array) -> None:
    """Put plain crews where they were as the call began."""
    for g in range(last):
        if course[g, PLAIN] == 1.0:
            put_back_one(g, poses, velocities, course)


def put_back_one(g: int, poses: Array, velocities: Array, course: Array) -> None:
    """Put a plain crew where it was as the call began."""
    for m in range(LANES_OF):
        poses[g, m], velocities[g, m] = course[g, L_AT + m], course[g, L_SPEED + m]


def note_frame(settings: Array, flow: Array, when: int) -> None:
    """Note where the frame is for each lane; turns are seen as they are."""
    for k in range(CREW):
        flow[when + 3 * k], flow[when + 3 * k + 1] = settings[FRAME_X], settings[FRAME_Y]
