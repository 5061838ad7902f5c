"""Sleep: islands at rest cost nothing until something happens to them.

A body is slow as DD50 states. An island whose bodies have all been slow for some steps falls asleep
(IM13): its velocities become zero, nothing moves it, and its contacts are neither searched for nor
solved. A body without contacts sleeps only if it does not move at all; an island that is supported
by a moving body does not sleep.

An island wakes as a whole if a body that may wake others touches it, or comes so near that their
contact has points, unless one of them is a sensor; if a pose, a velocity, a load or gravity differs
from that at rest; if a body that supports it was moved; or if springs pull it otherwise
(`pulled`).
Cost: a pass over bodies and one over contacts in each step, where sleeping is wanted.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.islands import find_islands
from tamias2d.engine.joints.at_rest import note_joined_support, wake_tied
from tamias2d.engine.narrow_phase.material import runs
from tamias2d.engine.tables import (
    Bodies,
    BroadPhase,
    Contacts,
    Control,
    Integers,
    Islands,
    Joints,
    Shapes,
    Touching,
)
from tamias2d.engine.waking import (
    NO_SUPPORT,
    SUPPORTED_AT_REST,
    SUPPORTED_IN_MOTION,
    wake_island,
    wake_pair,
)
from tamias2d.generated.definitions import gyration_radius
from tamias2d.generated.sleeping import quiet, quiet_square
from tamias2d.state import Array

NOT_NOTED = 1e308  # N, a pull of springs
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
    control: Control,
    bodies: Bodies,
    contacts: Contacts,
    touching: Touching,
    islands: Islands,
    joints: Joints,
    shapes: Shapes,
) -> None:
    """Note what each body touches: nothing, bodies at rest, or one that moves by itself.

    So does a surface that runs, though its body stands.
    """
    find_islands(bodies, touching, islands, joints)
    links = islands.links
    for i in range(len(bodies.kind)):
        links[i, tb.SUPPORT_KIND] = NO_SUPPORT
    note_joined_support(control.progress[tb.PART_TIME], bodies, islands, joints)
    for k in range(touching.counts[tb.TOUCHING]):
        pair = contacts.pairs[touching.contact[k]]
        i, j = pair[tb.SLOT_A], pair[tb.SLOT_B]
        in_motion = (bodies.kind[i] != tb.DYNAMIC and links[i, tb.AWAKE] == 1) or (
            bodies.kind[j] != tb.DYNAMIC and links[j, tb.AWAKE] == 1
        )
        in_motion = in_motion or runs(pair[0], pair[1], shapes)
        support = SUPPORTED_IN_MOTION if in_motion else SUPPORTED_AT_REST
        links[i, tb.SUPPORT_KIND] = max(links[i, tb.SUPPORT_KIND], support)
        links[j, tb.SUPPORT_KIND] = max(links[j, tb.SUPPORT_KIND], support)


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
    support, radius = links[i, tb.SUPPORT_KIND], extent_of_body(bodies.properties[i])
    limit = sleep_speed_squared(control.settings, radius) if support == SUPPORTED_AT_REST else 0.0
    slow = is_slow(control.progress[tb.PART_TIME], limit, bodies.motion[i], radius)
    links[i, tb.SLOW_STEPS] = (
        links[i, tb.SLOW_STEPS] + 1 if slow and support != SUPPORTED_IN_MOTION else 0
    )


def extent_of_body(properties: Array) -> float:
    """Return how far a body reaches, m; of a particle that turns, how far its mass is."""
    extent = properties[tb.BOUNDING_RADIUS]
    if extent == 0.0 and properties[tb.INVERSE_INERTIA] > 0.0:
        return gyration_radius(properties[tb.INVERSE_MASS], properties[tb.INVERSE_INERTIA])
    return extent


def note_rest(i: int, control: Control, bodies: Bodies, rest: Array) -> None:
    """Stop a body that falls asleep, and note its state; its pose is that at the step's end."""
    pose, motion, load = bodies.pose[i], bodies.motion[i], bodies.load[i]
    rest[tb.REST_GRAVITY] = control.settings[tb.GRAVITY_X]
    rest[tb.REST_GRAVITY + 1] = control.settings[tb.GRAVITY_Y]
    for n in range(3):
        motion[n] = 0.0
        rest[tb.REST_POSE + n] = pose[n] + motion[tb.DX + n]
        rest[tb.REST_LOAD + n] = load[n]
        rest[tb.REST_PULL + n] = NOT_NOTED  # until the next step


def sleep_speed_squared(settings: Array, radius: float) -> float:
    """Return the square of the velocity, m/s, below which a body with contacts is slow."""
    return quiet_square(SLEEP_SPEED, radius, usual_acceleration(settings, radius))


def usual_acceleration(settings: Array, radius: float) -> float:
    """Return what a body is accelerated by, m/s^2: gravity, or its radius in a second squared."""
    gravity = abs(settings[tb.GRAVITY_X]) + abs(settings[tb.GRAVITY_Y])
    return gravity if gravity > 0.0 else radius


def is_slow(time_step: float, limit: float, motion: Array, radius: float) -> bool:
    """Return whether a body is slow, and has been in this step (DD50); the limit in (m/s)^2."""
    velocity, shift = (motion[tb.VX], motion[tb.VY]), (motion[tb.DX], motion[tb.DY])
    return bool(
        quiet(velocity, motion[tb.SPIN], shift, motion[tb.DANGLE], radius, limit, time_step)
    )
