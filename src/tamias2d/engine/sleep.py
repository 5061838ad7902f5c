"""Sleep: islands at rest cost nothing until something happens to them.

A body is slow as DD50 states. An island whose bodies have all been slow for some steps falls asleep
(IM13): its velocities become zero, nothing moves it, and its contacts are neither searched for nor
solved. A body without contacts sleeps only if it does not move at all; an island that is supported
by a moving body does not sleep.

An island wakes as a whole if a body that may wake others touches it, or comes so near that their
contact has points, unless one of them is a sensor; if a pose, a velocity, a load or gravity differs
from that at rest; or if a body that supports it was moved.
Cost: a pass over bodies and one over contacts in each step, where sleeping is wanted.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.islands import find_islands
from tamias2d.engine.tables import (
    Bodies,
    BroadPhase,
    Contacts,
    Control,
    Integers,
    Islands,
    Joints,
    Touching,
)
from tamias2d.generated.sleeping import quiet, quiet_square
from tamias2d.state import Array

NO_SUPPORT, SUPPORTED_AT_REST, SUPPORTED_IN_MOTION = range(3)  # what a body touches
SLEEP_SPEED = 0.02  # of the velocity of a fall through half the radius: through 1/5000 of it


def update_sleep(
    control: Control,
    bodies: Bodies,
    broad_phase: BroadPhase,
    contacts: Contacts,
    islands: Islands,
    joints: Joints,
) -> None:
    """Wake islands that were changed since the last step, and count the bodies that sleep on."""
    links, rest = islands.links, islands.rest
    for i in range(len(bodies.kind)):
        if links[i, tb.SLEEP_ID] > 0 and state_changed(
            control.settings, bodies.pose[i], bodies.motion[i], bodies.load[i], rest[i]
        ):
            wake_island(links[i, tb.SLEEP_ID], links)
    for i in range(len(bodies.kind)):
        if bodies.kind[i] == tb.DYNAMIC:
            links[i, tb.AWAKE] = 1 if links[i, tb.SLEEP_ID] == 0 else 0
        else:
            note_support(bodies.kind[i], bodies.pose[i], bodies.motion[i], links[i], rest[i])
    for p in range(broad_phase.counts[tb.CONTACTS]):
        if contacts.flags[p, tb.POINT_COUNT] > 0 and contacts.flags[p, tb.SENSES] == 0:
            wake_pair(contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B], links)
    wake_tied(islands, joints)
    count_sleeping(bodies, islands)


def state_changed(settings: Array, pose: Array, motion: Array, load: Array, rest: Array) -> bool:
    """Return whether a body that sleeps is not as it was when it fell asleep."""
    changed = (rest[tb.REST_GRAVITY] != settings[tb.GRAVITY_X]) | (
        rest[tb.REST_GRAVITY + 1] != settings[tb.GRAVITY_Y]
    )
    for n in range(3):
        changed = changed | (pose[n] != rest[tb.REST_POSE + n]) | (motion[n] != 0.0)
        changed = changed | (load[n] != rest[tb.REST_LOAD + n])
    return bool(changed)


def note_support(kind: int, pose: Array, motion: Array, links: Integers, rest: Array) -> None:
    """Note whether a body that is not dynamic wakes others: it is new, was moved, or moves."""
    active = links[tb.SLOW_STEPS] == 0
    for n in range(3):
        active = active | (pose[n] != rest[tb.REST_POSE + n]) | (motion[n] != 0.0)
        rest[tb.REST_POSE + n] = pose[n]
    links[tb.AWAKE] = 1 if active and kind != tb.ABSENT else 0
    links[tb.SLOW_STEPS] = 1 if kind != tb.ABSENT else 0


def wake_touched(contacts: Contacts, touching: Touching, islands: Islands) -> bool:
    """Wake islands that are touched by a body that may wake them; return whether any was."""
    woken = False
    for k in range(touching.counts[tb.TOUCHING]):
        pair = contacts.pairs[touching.contact[k]]
        woken = wake_pair(pair[tb.SLOT_A], pair[tb.SLOT_B], islands.links) or woken
    return woken


def wake_pair(i: int, j: int, links: Integers) -> bool:
    """Wake the one of two bodies that may not wake others, if the other may and it sleeps."""
    if links[i, tb.AWAKE] == links[j, tb.AWAKE]:
        return False
    sleep_id = max(links[i, tb.SLEEP_ID], links[j, tb.SLEEP_ID])
    wake_island(sleep_id, links)
    return bool(sleep_id > 0)


def wake_tied(islands: Islands, joints: Joints) -> None:
    """Wake mechanisms that joints tie to a body which may wake others."""
    for n in range(joints.counts[tb.MECHANISMS]):
        i = joints.members[joints.sparse[n, tb.I_NODE] + 1, tb.JOINED_SLOT]
        for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
            for end in range(tb.ENDS_OF_JOINT):
                if joints.joints[j, tb.J_NODE + end] == tb.NOT_PUSHED:
                    by = joints.members[joints.joints[j, tb.J_MEMBER + end], tb.JOINED_SLOT]
                    wake_pair(i, by, islands.links)


def wake_island(sleep_id: int, links: Integers) -> None:
    """Wake all bodies that sleep under an id; 0 is that of bodies awake."""
    if sleep_id == 0:
        return
    for i in range(len(links)):
        if links[i, tb.SLEEP_ID] == sleep_id:
            links[i, tb.SLEEP_ID], links[i, tb.SLOW_STEPS], links[i, tb.AWAKE] = 0, 0, 1


def count_sleeping(bodies: Bodies, islands: Islands) -> None:
    """Count the bodies that sleep."""
    asleep = 0
    for i in range(len(bodies.kind)):
        asleep += islands.links[i, tb.SLEEP_ID] > 0
    islands.counts[tb.SLEEPING] = asleep


def hold_sleeping(bodies: Bodies, islands: Islands) -> None:
    """Hold bodies that sleep in place: they are marked as moved already."""
    for i in range(len(bodies.kind)):
        if islands.links[i, tb.SLEEP_ID] > 0:
            bodies.moved[i] = 1
            for n in range(3):
                bodies.motion[i, tb.DX + n] = bodies.flight[i, tb.FORCE_GAIN + n] = 0.0


def keep_touching_flags(broad_phase: BroadPhase, contacts: Contacts, islands: Islands) -> None:
    """Let contacts of sleeping bodies touch on if they did, so that none ends or begins."""
    links, pairs = islands.links, contacts.pairs
    for p in range(broad_phase.counts[tb.CONTACTS]):
        if links[pairs[p, tb.SLOT_A], tb.AWAKE] + links[pairs[p, tb.SLOT_B], tb.AWAKE] == 0:
            before = contacts.flags[p, tb.TOUCHES] & (tb.WAS_TOUCHING + tb.HAD_MET_IN_FLIGHT)
            contacts.flags[p, tb.TOUCHES] |= before >> 1


def note_support_kinds(
    bodies: Bodies, contacts: Contacts, touching: Touching, islands: Islands, joints: Joints
) -> None:
    """Note what each body touches: nothing, bodies at rest, or one that moves by itself."""
    find_islands(bodies, touching, islands, joints)
    links = islands.links
    for i in range(len(bodies.kind)):
        links[i, tb.SUPPORT_KIND] = NO_SUPPORT
    note_joined_support(islands, joints)
    for k in range(touching.counts[tb.TOUCHING]):
        pair = contacts.pairs[touching.contact[k]]
        i, j = pair[tb.SLOT_A], pair[tb.SLOT_B]
        in_motion = (bodies.kind[i] != tb.DYNAMIC and links[i, tb.AWAKE] == 1) or (
            bodies.kind[j] != tb.DYNAMIC and links[j, tb.AWAKE] == 1
        )
        support = SUPPORTED_IN_MOTION if in_motion else SUPPORTED_AT_REST
        links[i, tb.SUPPORT_KIND] = max(links[i, tb.SUPPORT_KIND], support)
        links[j, tb.SUPPORT_KIND] = max(links[j, tb.SUPPORT_KIND], support)


def note_joined_support(islands: Islands, joints: Joints) -> None:
    """Note that bodies which joints hold are supported by what these hold besides."""
    for n in range(joints.counts[tb.MECHANISMS]):
        timed = joints.mechanisms[n, tb.M_TIMED] == 1
        support = SUPPORTED_IN_MOTION if timed else SUPPORTED_AT_REST
        for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
            if motor_drives(j, joints):
                support = SUPPORTED_IN_MOTION
            for end in range(tb.ENDS_OF_JOINT):
                by = joints.members[joints.joints[j, tb.J_MEMBER + end], tb.JOINED_SLOT]
                tied = joints.joints[j, tb.J_NODE + end] == tb.NOT_PUSHED
                if tied and islands.links[by, tb.AWAKE] == 1:
                    support = SUPPORTED_IN_MOTION
        for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
            links = islands.links[joints.members[m, tb.JOINED_SLOT]]
            links[tb.SUPPORT_KIND] = max(links[tb.SUPPORT_KIND], support)


def motor_drives(j: int, joints: Joints) -> bool:
    """Return whether a motor moves its joint, however slowly: it does not give all that it can."""
    motor = joints.joints[j, tb.J_LAW] == tb.MOTOR and joints.laws[j, tb.LAW_RATE] != 0.0
    return bool(motor and joints.joints[j, tb.J_STATE] == tb.HOLDS)


def fall_asleep(control: Control, bodies: Bodies, islands: Islands) -> None:
    """Let islands fall asleep whose bodies have all been slow for long enough."""
    links, sleep_steps = islands.links, islands.counts[tb.SLEEP_STEPS]
    for i in range(len(bodies.kind)):
        links[i, tb.ISLAND_SLOW_STEPS] = sleep_steps
    for i in range(len(bodies.kind)):
        if bodies.kind[i] == tb.DYNAMIC and links[i, tb.SLEEP_ID] == 0:
            root = links[i, tb.ROOT]
            count_slow_step(i, control, bodies, links)
            links[root, tb.ISLAND_SLOW_STEPS] = min(
                links[root, tb.ISLAND_SLOW_STEPS], links[i, tb.SLOW_STEPS]
            )
    for i in range(len(bodies.kind)):
        root = links[i, tb.ROOT]
        if (
            bodies.kind[i] == tb.DYNAMIC
            and links[i, tb.SLEEP_ID] == 0
            and links[root, tb.ISLAND_SLOW_STEPS] >= sleep_steps
        ):
            links[i, tb.SLEEP_ID] = root + 1
            note_rest(i, control, bodies, islands.rest[i])


def count_slow_step(i: int, control: Control, bodies: Bodies, links: Integers) -> None:
    """Count for how many steps a body has been slow."""
    support, radius = links[i, tb.SUPPORT_KIND], bodies.properties[i, tb.BOUNDING_RADIUS]
    limit = sleep_speed_squared(control.settings, radius) if support == SUPPORTED_AT_REST else 0.0
    slow = is_slow(control.progress[tb.PART_TIME], limit, bodies.motion[i], radius)
    links[i, tb.SLOW_STEPS] = (
        links[i, tb.SLOW_STEPS] + 1 if slow and support != SUPPORTED_IN_MOTION else 0
    )


def note_rest(i: int, control: Control, bodies: Bodies, rest: Array) -> None:
    """Stop a body that falls asleep, and note its state; its pose is that at the step's end."""
    pose, motion, load = bodies.pose[i], bodies.motion[i], bodies.load[i]
    rest[tb.REST_GRAVITY] = control.settings[tb.GRAVITY_X]
    rest[tb.REST_GRAVITY + 1] = control.settings[tb.GRAVITY_Y]
    for n in range(3):
        motion[n] = 0.0
        rest[tb.REST_POSE + n] = pose[n] + motion[tb.DX + n]
        rest[tb.REST_LOAD + n] = load[n]


def sleep_speed_squared(settings: Array, radius: float) -> float:
    """Return the square of the velocity, m/s, below which a body with contacts is slow."""
    gravity = abs(settings[tb.GRAVITY_X]) + abs(settings[tb.GRAVITY_Y])
    return quiet_square(SLEEP_SPEED, radius, gravity if gravity > 0.0 else radius)


def is_slow(time_step: float, limit: float, motion: Array, radius: float) -> bool:
    """Return whether a body is slow, and has been in this step (DD50); the limit in (m/s)^2."""
    velocity, shift = (motion[tb.VX], motion[tb.VY]), (motion[tb.DX], motion[tb.DY])
    return bool(
        quiet(velocity, motion[tb.SPIN], shift, motion[tb.DANGLE], radius, limit, time_step)
    )
