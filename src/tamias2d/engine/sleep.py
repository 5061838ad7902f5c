"""Sleeping: islands that have come to rest cost nothing until something happens to them.

Serves: a step, where sleeping is wanted. Hides: what counts as quiet, and what wakes an island.

A body is quiet as DD50 says. An island in which all have been quiet for some steps falls asleep
(IM13): its velocities become zero, nothing moves it, and its contacts are neither looked for nor
solved. What touches nothing sleeps only where it does not move at all, and what leans on something
that moves does not sleep.

It wakes as a whole where something that moves comes near to touching it; where a pose, a velocity,
a load or gravity is not what it was; and where something on which it leaned has been moved.
"""

from tamias2d.engine.islands import find_islands
from tamias2d.engine.tables import (
    ABSENT,
    AWAKE,
    BOUNDING_RADIUS,
    CONTACTS,
    DX,
    DYNAMIC,
    FORCE_GAIN,
    GRAVITY_X,
    GRAVITY_Y,
    ISLAND_SLOW_STEPS,
    POINT_COUNT,
    REST_GRAVITY,
    REST_LOAD,
    ROOT,
    SLEEP_ID,
    SLEEP_STEPS,
    SLEEPING,
    SLOT_A,
    SLOT_B,
    SLOW_STEPS,
    SPIN,
    SUPPORT_KIND,
    TIME_STEP,
    TOUCHES,
    TOUCHING,
    VX,
    VY,
    Bodies,
    BroadPhase,
    Contacts,
    Control,
    Integers,
    Islands,
    Touching,
)
from tamias2d.generated.sleeping import quiet, quiet_square
from tamias2d.state import Array

ALONE, ON_RESTING, ON_MOVING = range(3)  # what a body touches: nothing, or something driven

SLOW = 0.02  # of the velocity of a fall through half the reach: one through 1/5000 of it


def update_sleep(
    control: Control,
    bodies: Bodies,
    broad_phase: BroadPhase,
    contacts: Contacts,
    islands: Islands,
) -> None:
    """Wake what has been changed since the last step, and count what sleeps on."""
    for i in range(len(bodies.kind)):
        if islands.links[i, SLEEP_ID] > 0 and state_changed(
            control.settings, bodies.pose[i], bodies.motion[i], bodies.load[i], islands.rest[i]
        ):
            wake_island(islands.links[i, SLEEP_ID], islands.links)
    for i in range(len(bodies.kind)):
        if bodies.kind[i] == DYNAMIC:
            islands.links[i, AWAKE] = 1 if islands.links[i, SLEEP_ID] == 0 else 0
        else:
            note_support(
                bodies.kind[i], bodies.pose[i], bodies.motion[i], islands.links[i], islands.rest[i]
            )
    for p in range(broad_phase.counts[CONTACTS]):
        i, j = contacts.pairs[p, SLOT_A], contacts.pairs[p, SLOT_B]
        if (
            contacts.flags[p, POINT_COUNT] > 0
            and islands.links[i, AWAKE] != islands.links[j, AWAKE]
        ):
            wake_island(max(islands.links[i, SLEEP_ID], islands.links[j, SLEEP_ID]), islands.links)
    count_sleeping(bodies, islands)


def state_changed(settings: Array, pose: Array, motion: Array, load: Array, rest: Array) -> bool:
    """Return whether a body that sleeps is not as it was when it fell asleep."""
    other = (rest[REST_GRAVITY] != settings[GRAVITY_X]) | (
        rest[REST_GRAVITY + 1] != settings[GRAVITY_Y]
    )
    for n in range(3):
        other = other | (pose[n] != rest[n]) | (motion[n] != 0.0)
        other = other | (load[n] != rest[REST_LOAD + n])
    return bool(other)


def note_support(kind: int, pose: Array, motion: Array, island: Integers, rest: Array) -> None:
    """Say of what nothing pushes whether it wakes others: it is new, has been moved, or moves."""
    live = island[SLOW_STEPS] == 0
    for n in range(3):
        live = live | (pose[n] != rest[n]) | (motion[n] != 0.0)
        rest[n] = pose[n]
    island[AWAKE] = 1 if live and kind != ABSENT else 0
    island[SLOW_STEPS] = 1 if kind != ABSENT else 0


def wake_touched(contacts: Contacts, touching: Touching, islands: Islands) -> bool:
    """Wake what is met by something that may wake it; return whether anything was."""
    woken = False
    for k in range(touching.counts[TOUCHING]):
        i, j = (
            contacts.pairs[touching.contact[k], SLOT_A],
            contacts.pairs[touching.contact[k], SLOT_B],
        )
        if islands.links[i, AWAKE] != islands.links[j, AWAKE]:
            night = max(islands.links[i, SLEEP_ID], islands.links[j, SLEEP_ID])
            wake_island(night, islands.links)
            woken = woken or night > 0
    return woken


def wake_island(night: int, island: Integers) -> None:
    """Wake all that sleep under a name; 0 is none's."""
    if night == 0:
        return
    for i in range(len(island)):
        if island[i, SLEEP_ID] == night:
            island[i, SLEEP_ID], island[i, SLOW_STEPS], island[i, AWAKE] = 0, 0, 1


def count_sleeping(bodies: Bodies, islands: Islands) -> None:
    """Count what sleeps."""
    asleep = 0
    for i in range(len(bodies.kind)):
        asleep += islands.links[i, SLEEP_ID] > 0
    islands.counts[SLEEPING] = asleep


def hold_sleeping(bodies: Bodies, islands: Islands) -> None:
    """Let nothing move what sleeps: it is marked like what has been moved already."""
    for i in range(len(bodies.kind)):
        if islands.links[i, SLEEP_ID] > 0:
            bodies.moved[i] = 1
            for n in range(3):
                bodies.motion[i, DX + n] = bodies.flight[i, FORCE_GAIN + n] = 0.0


def keep_touching_flags(broad_phase: BroadPhase, contacts: Contacts, islands: Islands) -> None:
    """Let pairs of what sleeps that touched touch on, so that nothing ends or begins."""
    for p in range(broad_phase.counts[CONTACTS]):
        if (
            islands.links[contacts.pairs[p, SLOT_A], AWAKE]
            + islands.links[contacts.pairs[p, SLOT_B], AWAKE]
            == 0
        ):
            contacts.flags[p, TOUCHES] |= contacts.flags[p, TOUCHES] >> 1


def note_support_kinds(
    bodies: Bodies, contacts: Contacts, touching: Touching, islands: Islands
) -> None:
    """Note of each body whether it touches anything, and whether that is moved by nobody's push."""
    find_islands(bodies, touching, islands)
    for i in range(len(bodies.kind)):
        islands.links[i, SUPPORT_KIND] = ALONE
    for k in range(touching.counts[TOUCHING]):
        i, j = (
            contacts.pairs[touching.contact[k], SLOT_A],
            contacts.pairs[touching.contact[k], SLOT_B],
        )
        moved = (bodies.kind[i] != DYNAMIC and islands.links[i, AWAKE] == 1) or (
            bodies.kind[j] != DYNAMIC and islands.links[j, AWAKE] == 1
        )
        company = ON_MOVING if moved else ON_RESTING
        islands.links[i, SUPPORT_KIND] = max(islands.links[i, SUPPORT_KIND], company)
        islands.links[j, SUPPORT_KIND] = max(islands.links[j, SUPPORT_KIND], company)


def fall_asleep(control: Control, bodies: Bodies, islands: Islands) -> None:
    """Count for how long bodies have been quiet, and let islands sleep that have been for long.

    Poses are those at the beginning of the step, with what has been moved since beside them.
    """
    for i in range(len(bodies.kind)):
        islands.links[i, ISLAND_SLOW_STEPS] = islands.counts[SLEEP_STEPS]
    for i in range(len(bodies.kind)):
        if bodies.kind[i] == DYNAMIC and islands.links[i, SLEEP_ID] == 0:
            company, root = islands.links[i, SUPPORT_KIND], islands.links[i, ROOT]
            slow = (
                sleep_speed(control, bodies.properties[i, BOUNDING_RADIUS])
                if company == ON_RESTING
                else 0.0
            )
            quiet = is_slow(
                control.settings[TIME_STEP],
                slow,
                bodies.motion[i],
                bodies.properties[i, BOUNDING_RADIUS],
            )
            islands.links[i, SLOW_STEPS] = (
                islands.links[i, SLOW_STEPS] + 1 if quiet and company != ON_MOVING else 0
            )
            islands.links[root, ISLAND_SLOW_STEPS] = min(
                islands.links[root, ISLAND_SLOW_STEPS], islands.links[i, SLOW_STEPS]
            )
    for i in range(len(bodies.kind)):
        root = islands.links[i, ROOT]
        peaceful = islands.links[root, ISLAND_SLOW_STEPS] >= islands.counts[SLEEP_STEPS]
        if bodies.kind[i] == DYNAMIC and islands.links[i, SLEEP_ID] == 0 and peaceful:
            islands.links[i, SLEEP_ID] = root + 1
            islands.rest[i, REST_GRAVITY] = control.settings[GRAVITY_X]
            islands.rest[i, REST_GRAVITY + 1] = control.settings[GRAVITY_Y]
            for n in range(3):
                bodies.motion[i, n] = 0.0
                islands.rest[i, n] = bodies.pose[i, n] + bodies.motion[i, DX + n]
                islands.rest[i, REST_LOAD + n] = bodies.load[i, n]


def sleep_speed(control: Control, reach: float) -> float:
    """Return the square of the velocity, m/s, below which a body that touches things is quiet."""
    pull = abs(control.settings[GRAVITY_X]) + abs(control.settings[GRAVITY_Y])
    return quiet_square(SLOW, reach, pull if pull > 0.0 else reach)


def is_slow(time_step: float, slow: float, motion: Array, reach: float) -> bool:
    """Return whether a body is slow, and has been in this step."""
    velocity, shift = (motion[VX], motion[VY]), (motion[DX], motion[DX + 1])
    return bool(quiet(velocity, motion[SPIN], shift, motion[DX + 2], reach, slow, time_step))
