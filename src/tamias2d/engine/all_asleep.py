"""Steps in which all bodies sleep: they are not taken but counted.

Between calls users may write into what they see. So each call compares that with what it was as all
fell asleep, and takes all of its steps at once if it is the same. Where bodies come or go the list
of pairs does not hold, and the next step looks at each of them. A world in which nothing can be
pushed sleeps, too.
Cost: of a call, a pass through what users see; of a step, nothing.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Chunks, Islands, World


def note_all_asleep(world: World) -> bool:
    """Note whether all bodies have slept through a step, and how users see them then.

    In the step in which the last of them fell asleep contacts were still solved, so that some may
    begin to touch or cease to; the one after it is the first that changes nothing.
    """
    control, chunks = world.control, world.chunks
    counts = control.counts
    slept = world.islands.counts[tb.SLEEP_STEPS] > 0 and world.springs.counts[tb.SPRINGS] == 0
    slept = slept and nobody_awake(world.islands)
    if slept:
        for g in range(len(chunks.course)):
            row = chunks.asleep[g]
            for n in range(tb.CHUNK_LANES):
                row[tb.POSES_ASLEEP + n] = chunks.poses[g, n]
                row[tb.VELOCITIES_ASLEEP + n] = chunks.velocities[g, n]
                row[tb.LOADS_ASLEEP + n] = chunks.loads[g, n]
        gravity = chunks.asleep[len(chunks.course)]
        gravity[0], gravity[1] = control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y]
    counts[tb.ALL_ASLEEP] = 1 if slept else 0
    return bool(slept)


def nobody_awake(islands: Islands) -> bool:
    """Return whether no body was awake in a step, and none that is not dynamic was new or moved."""
    i, size = 0, len(islands.links)
    while i < size and islands.links[i, tb.AWAKE] == 0:
        i += 1
    return i == size


def still_asleep(world: World) -> bool:
    """Return whether all bodies sleep, and are as they were when they fell asleep.

    The list of pairs holds no longer where bodies came, went or got another material.
    """
    if world.control.counts[tb.ALL_ASLEEP] == 0 or world.broad_phase.counts[tb.LIST_HOLDS] == 0:
        return False
    control, chunks = world.control, world.chunks
    settings, gravity = control.settings, chunks.asleep[len(chunks.course)]
    same = gravity[0] == settings[tb.GRAVITY_X] and gravity[1] == settings[tb.GRAVITY_Y]
    for g in range(len(chunks.course)):
        same = same and changed_lanes(g, chunks) == 0
    world.control.counts[tb.ALL_ASLEEP] = 1 if same else 0
    return bool(same)


def changed_lanes(g: int, chunks: Chunks) -> int:
    """Return how many numbers of a chunk are not what they were as all fell asleep."""
    row, poses, velocities, loads = (
        chunks.asleep[g],
        chunks.poses[g],
        chunks.velocities[g],
        chunks.loads[g],
    )
    changed = 0
    for n in range(tb.CHUNK_LANES):
        changed += 1 if poses[n] != row[tb.POSES_ASLEEP + n] else 0
        changed += 1 if velocities[n] != row[tb.VELOCITIES_ASLEEP + n] else 0
        changed += 1 if loads[n] != row[tb.LOADS_ASLEEP + n] else 0
    return changed


def skip_steps(world: World) -> None:
    """Count the steps that are left of a call as taken."""
    counts = world.control.counts
    counts[tb.STEPS_TAKEN] += counts[tb.STEPS_LEFT]
    world.broad_phase.counts[tb.STEPS_SINCE] += counts[tb.STEPS_LEFT]
    counts[tb.STEPS_LEFT] = 0
