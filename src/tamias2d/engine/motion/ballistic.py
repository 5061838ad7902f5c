"""Steps of bodies that are near nothing: each along its closed form, without a broad phase.

Bodies are taken in chunks of 16, in one pass through memory. A lane of a chunk is one coordinate of
a body; the compiler takes eight lanes at a time. Most chunks are plain: all bodies are dynamic,
nothing but gravity acts on them, and their propagators are alike (DD41). Plain chunks move where
they are, and are put back where a body of theirs would leave its bounds; a mixed chunk moves in its
row of the course, until no body leaves its bounds, in which the list of pairs holds.

The bits are those of ordinary steps.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.bvh import FAR
from tamias2d.engine.broad_phase.comoving_frame import move_frame
from tamias2d.engine.joints.activity import clear_of_joints
from tamias2d.engine.motion.chunks import (
    begin_mixed,
    begin_plain,
    note_frame,
    restore_chunk,
    set_propagator,
    store_mixed,
    take_lanes,
    take_mixed,
)
from tamias2d.engine.state import LARGEST
from tamias2d.engine.tables import Bodies, BodyState, BroadPhase, Chunks, Control, World
from tamias2d.generated.definitions import acceleration
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

TOGETHER = 16  # chunks that take all their steps before the next ones do: they fit the L1 cache


def integrate_ballistic(world: World, steps: int) -> int:
    """Take up to some steps while no body leaves its bounds or has a contact; return how many.

    Poses, velocities and loads are those that users see, a row for each chunk; the bits of loads
    tell whether nothing pushes, since not all zeros are alike. The course must have been noted for
    the bounds as they are.
    """
    control, broad_phase, chunks = world.control, world.broad_phase, world.chunks
    if not may_be_ballistic(world):
        return 0
    note_gravity(control, chunks.stream[len(chunks.course)])
    x, y = broad_phase.frame[tb.FRAME_X], broad_phase.frame[tb.FRAME_Y]
    frame_x, frame_y = broad_phase.frame[tb.FRAME_VX], broad_phase.frame[tb.FRAME_VY]
    tried = 0
    while steps > 0 and steps != tried:
        tried = steps
        stretch = TOGETHER if steps > 1 else len(chunks.course)
        for first in range(0, len(chunks.course), stretch):
            last = min(first + stretch, len(chunks.course))
            steps = advance_chunks(
                steps, first, last, control, world.state, world.bodies, broad_phase, chunks
            )
            broad_phase.frame[tb.FRAME_X], broad_phase.frame[tb.FRAME_Y] = x, y
            broad_phase.frame[tb.FRAME_VX], broad_phase.frame[tb.FRAME_VY] = frame_x, frame_y
            if steps < tried:
                restore_chunks(last, chunks)
                break
    if steps > 0:
        store_all_mixed(world.state, chunks)
        for _ in range(steps):
            move_frame(broad_phase)
        control.counts[tb.STEPS_TAKEN] += steps
        control.counts[tb.FINEST] = 0
    return steps


def may_be_ballistic(world: World) -> bool:
    """Return whether a step begins with no contact on a list that holds, without sleep or NaN.

    Springs and joints connect bodies, which are not alone then.
    """
    counts, gravity = world.broad_phase.counts, world.control.settings
    total = gravity[tb.GRAVITY_X] + gravity[tb.GRAVITY_Y]
    alone = world.springs.counts[tb.SPRINGS] == 0
    alone = clear_of_joints(alone, world)
    return bool(
        alone
        and world.control.counts[tb.STAGE] == tb.AT_START
        and counts[tb.CONTACTS] == 0
        and counts[tb.LIST_HOLDS] == 1
        and world.islands.counts[tb.SLEEP_STEPS] == 0
        and total - total == 0.0
    )


def note_gravity(control: Control, plain: Array) -> None:
    """Note the acceleration of plain chunks, on which nothing acts but gravity."""
    gravity = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
    by_x, by_y = acceleration(gravity, (0.0, 0.0), 1.0)
    for k in range(tb.CHUNK):
        plain[tb.L_BY + 3 * k], plain[tb.L_BY + 3 * k + 1] = by_x, by_y


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
    """Let some chunks take steps while no body leaves its bounds; return how many."""
    plain = chunks.stream[len(chunks.course)]
    note_frame(broad_phase, plain, tb.L_BEFORE)
    move_frame(broad_phase)
    note_frame(broad_phase, plain, tb.L_AFTER)
    out = 0
    for g in range(first, last):
        out += begin_chunk(g, control, state, bodies, broad_phase, chunks)
    taken = 0
    while out == 0:
        taken += 1
        if taken == steps:
            break
        move_frame(broad_phase)
        note_frame(broad_phase, plain, tb.L_AFTER)
        for g in range(first, last):
            course = chunks.course[g]
            if course[tb.PLAIN] == 1.0:
                out += take_lanes(chunks.poses[g], chunks.velocities[g], course, plain)
            else:
                out += take_mixed(broad_phase, course, chunks.stream[g])
    return taken


@inlined
def begin_chunk(
    g: int,
    control: Control,
    state: BodyState,
    bodies: Bodies,
    broad_phase: BroadPhase,
    chunks: Chunks,
) -> int:
    """Let a chunk take its first step, as a plain one if it is one; return its lanes that may not.

    A uniform chunk on which something else than gravity acts is a mixed one.
    """
    course, plain = chunks.course[g], chunks.stream[len(chunks.course)]
    course[tb.PLAIN] = course[tb.UNIFORM]
    if course[tb.PLAIN] == 1.0:
        pose, velocity = chunks.poses[g], chunks.velocities[g]
        if begin_plain(pose, velocity, chunks.load_bits[g], course, plain) == 0:
            return 0
        restore_chunk(g, chunks)
        course[tb.PLAIN] = 0.0
    return begin_mixed(g, control, state, bodies, broad_phase, chunks)


def restore_chunks(last: int, chunks: Chunks) -> None:
    """Put plain chunks back to where they were as the call began."""
    for g in range(last):
        if chunks.course[g, tb.PLAIN] == 1.0:
            restore_chunk(g, chunks)


def store_all_mixed(state: BodyState, chunks: Chunks) -> None:
    """Put the bodies of mixed chunks where their lanes got to."""
    for g in range(len(chunks.course)):
        if chunks.course[g, tb.PLAIN] == 0.0:
            store_mixed(g, state.kind, chunks.poses[g], chunks.velocities[g], chunks.course[g])


def note_course(world: World) -> None:
    """Note the bounds of all bodies, and which chunks are uniform.

    The bodies of these are dynamic and have the propagator of the first dynamic one. No bounds
    contain infinity.
    """
    state, chunks = world.state, world.chunks
    most_turn = LARGEST * world.control.settings[tb.TIME_STEP]
    one = 0
    while one < len(state.kind) - 1 and state.kind[one] != tb.DYNAMIC:
        one += 1
    plain = chunks.stream[len(chunks.course)]
    for k in range(tb.CHUNK):
        set_propagator(k, state.properties[one], world.bodies.propagators, plain)
    for g in range(len(chunks.course)):
        alike = 0
        for k in range(tb.CHUNK):
            i = tb.CHUNK * g + k
            note_bounds(i, k, most_turn, state, world.broad_phase, chunks.course[g])
            same = state.properties[i, tb.PROPAGATOR] == state.properties[one, tb.PROPAGATOR]
            alike += 1 if state.kind[i] == tb.DYNAMIC and same else 0
        chunks.course[g, tb.UNIFORM] = 1.0 if alike == tb.CHUNK else 0.0


def note_bounds(
    i: int, k: int, most_turn: float, state: BodyState, broad_phase: BroadPhase, course: Array
) -> None:
    """Note where a body, which is the k-th of its chunk, may be; an absent one anywhere.

    A disc may turn by any angle, but by more than `most_turn` in a step only with an angular
    velocity that is not valid.
    """
    low, high = course[tb.L_LOW + 3 * k :], course[tb.L_HIGH + 3 * k :]
    for n in range(3):
        low[n], high[n] = -FAR, FAR
    if state.kind[i] >= tb.STATIC:
        fat = broad_phase.fat_bounds[state.slot_of_body[i]]
        low[0], high[0] = max(-FAR, fat[tb.LOW_X]), min(FAR, fat[tb.HIGH_X])
        low[1], high[1] = max(-FAR, fat[tb.LOW_Y]), min(FAR, fat[tb.HIGH_Y])
        margin = min(fat[tb.ANGLE_MARGIN], most_turn)
        low[2] = max(-FAR, fat[tb.BASE_ANGLE] - margin)
        high[2] = min(FAR, fat[tb.BASE_ANGLE] + margin)
