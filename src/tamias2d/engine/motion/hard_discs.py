"""Hard discs: where nothing but gravity and impacts moves a few discs, from impact to impact.

Pairs of discs, and discs and half-planes that stand, meet at an instant that has a closed form
(DD46, DD80). They rebound there (IM3, IM9), and go on along their parabolas (IM1). Whatever else
may happen in a step is left to the ordinary way: a slow rebound, after which a disc may rest, a
third shape where two meet, an overlap.

Of each pair it is known for how many steps it stays apart. Cost: a step in which none meets is a
pass over bodies; an impact looks at the pairs of both bodies.
"""

from math import inf, sqrt

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.contact_list import current_contacts
from tamias2d.engine.continuous.conservative_advancement import NEAR
from tamias2d.engine.continuous.event_queue import list_contacts_by_body
from tamias2d.engine.continuous.impact import record_impact
from tamias2d.engine.continuous.impact_points import line_of, rebound_at_point
from tamias2d.engine.continuous.impulse import speed_along
from tamias2d.engine.hard_scene import are_hard_discs
from tamias2d.engine.motion.hard_paths import (
    advance_to,
    begin_paths,
    closing_of,
    disc_and_other,
    fly_on,
    foretell,
    list_due,
    note_due,
    note_meeting,
    pull_on,
    soonest_of,
    steps_near,
)
from tamias2d.engine.motion.quiet import age, is_known, note_quiet, show_moved
from tamias2d.engine.narrow_phase.material import mixed_material
from tamias2d.engine.tables import Bodies, Contacts, Control, Events, Shapes, World
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

SLOWEST_REBOUND = 2.0**-4  # velocities that gravity gives in a step: slower discs soon rest
UNSTATED_TOO = -2.0  # less than any restitution, and than what stands for none


def may_be_hard(world: World) -> bool:
    """Return whether the next step may be one of hard discs, of whatever restitution."""
    near = steps_near(1, world.control, world.bodies) > 0
    return near and are_hard_discs(UNSTATED_TOO, world.bodies, world.shapes)


def take_hard_steps(world: World) -> None:
    """Take the steps that are left, as long as discs meet two by two."""
    control, bodies, shapes, events = world.control, world.bodies, world.shapes, world.events
    contacts = current_contacts(world.broad_phase, world.buffers)
    listed, steps = world.broad_phase.counts[tb.CONTACTS], control.counts[tb.STEPS_LEFT]
    list_contacts_by_body(world.broad_phase, contacts, events, len(bodies.kind))
    begin_paths(bodies)
    for p in range(listed):
        foretell(p, 0, control, bodies, shapes, contacts, events)
    soonest = soonest_of(listed, events)
    taken, known = 0, list_known(listed, contacts, events)
    while taken < steps:
        met = near = 0
        ahead = steps_near(max(int(min(soonest, float(steps))) - taken, 1), control, bodies)
        if ahead == 0:
            break
        if soonest < taken + 1:
            near = list_due(taken + 1, listed, events)
            met = pass_impacts(near, taken, world, contacts)
            if met < 0:
                break
        fly_on(ahead, control, bodies)
        taken += ahead
        for _ in range(min(ahead, 2)):  # that pairs have touched is known for so many steps
            known = age_known(known, shapes, contacts, events)
        known = tell_impacts(met, known, contacts, events)
        if near > 0:
            for k in range(near):
                p = events.queue[tb.WAITING, k]
                foretell(p, taken, control, bodies, shapes, contacts, events)
            soonest = soonest_of(listed, events)
    if taken > 0:
        note_quiet(taken, world)
        show_moved(world.state, bodies)


# -- impacts


def pass_impacts(near: int, taken: int, world: World, contacts: Contacts) -> int:
    """Let the listed pairs meet in this step, one after the other; return how many impacts are.

    The number is below 0 where something else happens: then all is as it was.
    """
    control, bodies, shapes, events = world.control, world.bodies, world.shapes, world.events
    step, met = control.settings[tb.TIME_STEP], 0
    for k in range(near):
        p = events.queue[tb.WAITING, k]
        events.queue[tb.PLACE, p] = k
        if not note_meeting(p, 0.0, control, bodies, shapes, contacts, events):
            return -1
    p = first_to_meet(near, events)
    if events.times[p] > step:
        return 0
    note_paths(bodies)
    while events.times[p] <= step:
        now = events.times[p]
        hard = met < tb.MOST_AT_ONCE and rebound_hard(p, met, now, world, contacts)
        near = look_on(p, now, near, taken, world, contacts) if hard else -1
        if near < 0:
            put_back(bodies)
            return -1
        met += 1
        p = first_to_meet(near, events)
    for i in range(len(bodies.kind)):
        if bodies.flight[i, tb.REDIRECTED] != 0.0:
            advance_to(i, step, control, bodies)
            bodies.flight[i, tb.PATH_START] = 0.0
    return met


@inlined
def note_paths(bodies: Bodies) -> None:
    """Note where all bodies are as the step begins, and how they move."""
    for i in range(len(bodies.kind)):
        if bodies.kind[i] == tb.DYNAMIC:
            for n in range(3):
                bodies.start[i, n], bodies.start[i, 3 + n] = bodies.pose[i, n], bodies.motion[i, n]


@inlined
def put_back(bodies: Bodies) -> None:
    """Put all bodies back to where they were as the step began."""
    for i in range(len(bodies.kind)):
        if bodies.kind[i] == tb.DYNAMIC:
            for n in range(3):
                bodies.pose[i, n], bodies.motion[i, n] = bodies.start[i, n], bodies.start[i, 3 + n]


@inlined
def first_to_meet(near: int, events: Events) -> int:
    """Return the pair of some that meets first; of two at the same time the first of the list."""
    first = events.queue[tb.WAITING, 0]
    for k in range(1, near):
        p = events.queue[tb.WAITING, k]
        if events.times[p] < events.times[first] or (
            events.times[p] == events.times[first] and p < first
        ):
            first = p
    return first


def rebound_hard(p: int, met: int, now: float, world: World, contacts: Contacts) -> bool:
    """Let a pair rebound at a time in the step, s; return whether it parts for a while.

    What is to be told of the impact is listed under a number.
    """
    control, bodies, shapes, events = world.control, world.bodies, world.shapes, world.events
    s, t = disc_and_other(p, shapes, contacts)
    i, j = shapes.slot[s], shapes.slot[t]
    advance_to(i, now, control, bodies)
    advance_to(j, now, control, bodies)
    friction, restitution = mixed_material(s, t, shapes.material, shapes.pair_overrides)
    row = events.met_points[2 * met]
    events.met[met, tb.MET_CONTACT], events.met[met, tb.MET_A], events.met[met, tb.MET_B] = p, i, j
    row[tb.M_FRICTION], row[tb.M_RESTITUTION], row[tb.M_DRAG] = friction, restitution, 0.0
    pull = find_touch(s, t, row, control, bodies, shapes)
    line = line_of(2 * met, False, events)
    row[tb.M_APPROACH] = speed_along(line, 0.0, bodies.motion, bodies.flight)
    parts = -restitution * row[tb.M_APPROACH]
    if not parts > SLOWEST_REBOUND * pull * control.settings[tb.TIME_STEP]:
        return False
    rebound_at_point(2 * met, 0.0, bodies, events)
    row[tb.M_PLACE] = bodies.pose[i, tb.X] + row[tb.M_ARM_A]
    row[tb.M_PLACE + 1] = bodies.pose[i, tb.Y] + row[tb.M_ARM_A + 1]
    bodies.flight[i, tb.REDIRECTED] = 1.0
    bodies.flight[j, tb.REDIRECTED] = 1.0 if bodies.kind[j] == tb.DYNAMIC else 0.0
    return True


@inlined
def find_touch(
    s: int, t: int, row: Array, control: Control, bodies: Bodies, shapes: Shapes
) -> float:
    """Write where a disc touches a shape; return which acceleration presses them together, m/s^2.

    The normal leads from the disc to the other one.
    """
    i, j = shapes.slot[s], shapes.slot[t]
    radius, pull = shapes.material[s, tb.SHAPE_RADIUS], 0.0
    x, y = bodies.pose[j, tb.X] - bodies.pose[i, tb.X], bodies.pose[j, tb.Y] - bodies.pose[i, tb.Y]
    if shapes.kind[t] == tb.HALF_PLANE:
        side, by = shapes.world_vertices[shapes.first[t]], pull_on(i, control, bodies)
        nx, ny = -side[2], -side[3]
        pull = max(0.0, nx * by[0] + ny * by[1])
    else:
        far = sqrt(x * x + y * y)
        nx, ny = x / far, y / far
    row[tb.M_NORMAL], row[tb.M_NORMAL + 1] = nx, ny
    row[tb.M_ARM_A], row[tb.M_ARM_A + 1] = radius * nx, radius * ny
    row[tb.M_ARM_B], row[tb.M_ARM_B + 1] = radius * nx - x, radius * ny - y
    return pull


def look_on(p: int, now: float, near: int, taken: int, world: World, contacts: Contacts) -> int:
    """Find anew when both bodies of a pair that has met at a time, s, meet others in this step.

    Returns how many pairs are listed then; -1 if a third shape is near where they met.
    """
    control, bodies, shapes, events = world.control, world.bodies, world.shapes, world.events
    note_meeting(p, now, control, bodies, shapes, contacts, events)
    for i in (contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]):
        if bodies.kind[i] != tb.DYNAMIC:
            continue
        pose, motion = bodies.pose[i], bodies.motion[i]
        at, going = (pose[tb.X], pose[tb.Y]), (motion[tb.VX], motion[tb.VY])
        for k in range(events.queue[tb.FIRST_OF_BODY, i], events.queue[tb.FIRST_OF_BODY, i + 1]):
            q = events.queue[tb.CONTACT_OF_BODY, k]
            if q == p:
                continue
            first = contacts.pairs[q, tb.SLOT_A] == i
            s, t = contacts.pairs[q, 0 if first else 1], contacts.pairs[q, 1 if first else 0]
            gap, rate, by = closing_of(s, t, at, going, now, NEAR, control, bodies, shapes)
            if gap <= 0.0:
                return -1
            note_due(q, taken, now, gap, rate, by, control, events)
            near = list_again(q, now, near, taken, control, bodies, shapes, contacts, events)
    return near


@inlined
def list_again(
    q: int, now: float, near: int, taken: int, control: Control, bodies: Bodies, shapes: Shapes,
    contacts: Contacts, events: Events,
) -> int:  # fmt: skip
    """Note when a pair meets in this step, s, if it may; return how many pairs are listed then."""
    at = events.queue[tb.PLACE, q]
    listed = 0 <= at < near and events.queue[tb.WAITING, at] == q
    if events.due[q] < taken + 1:
        note_meeting(q, now, control, bodies, shapes, contacts, events)
        if not listed:
            events.queue[tb.WAITING, near], events.queue[tb.PLACE, q] = q, near
            near += 1
    elif listed:
        events.times[q] = inf
    return near


# -- what is told


@inlined
def list_known(listed: int, contacts: Contacts, events: Events) -> int:
    """List the contacts of which something is known from earlier steps; return how many are."""
    known = 0
    for p in range(listed):
        if is_known(p, contacts):
            events.touched[known] = p
            known += 1
    return known


@inlined
def age_known(known: int, shapes: Shapes, contacts: Contacts, events: Events) -> int:
    """Let what touched have done so before; return of how many contacts something is known."""
    stay = 0
    for k in range(known):
        p = events.touched[k]
        age(p, shapes, contacts)
        if contacts.flags[p, tb.TOUCHES] != 0:
            events.touched[stay] = p
            stay += 1
    return stay


@inlined
def tell_impacts(met: int, known: int, contacts: Contacts, events: Events) -> int:
    """Add the impacts of a step to what is told of contacts; return of how many something is."""
    for k in range(met):
        p, row = events.met[k, tb.MET_CONTACT], events.met_points[2 * k]
        if contacts.flags[p, tb.TOUCHES] == 0:
            events.touched[known] = p
            known += 1
        turned = events.met[k, tb.MET_A] != contacts.pairs[p, tb.SLOT_A]
        sense = -1.0 if turned else 1.0
        normal = (sense * row[tb.M_NORMAL], sense * row[tb.M_NORMAL + 1])
        place = (row[tb.M_PLACE], row[tb.M_PLACE + 1])
        record_impact(
            row[tb.M_PUSH], place, normal, False, contacts.manifolds[p], contacts.flags[p]
        )
    return known
