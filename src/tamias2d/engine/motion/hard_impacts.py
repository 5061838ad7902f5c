"""Impacts of hard discs within a step, one after the other.

Two rebound where they meet (IM3, IM9), and go on along new paths, on which only their own pairs are
looked at again. A disc whose rebound from a half-plane is slow rests there; one that rests and is
struck meets its half-plane next, if it is pressed into it.
"""

from math import inf, sqrt

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.conservative_advancement import NEAR
from tamias2d.engine.continuous.event_queue import list_contacts_by_body
from tamias2d.engine.continuous.impact_points import line_of, rebound_at_point
from tamias2d.engine.continuous.impulse import speed_along
from tamias2d.engine.motion.hard_meetings import find_due, note_meeting
from tamias2d.engine.motion.hard_paths import (
    advance_to,
    closing_of,
    closing_of_discs,
    closing_on_plane,
    disc_and_other,
    note_path,
    place_at,
    pull_on,
    reach_of,
)
from tamias2d.engine.motion.hard_rest import (
    land,
    leave_plane,
    noise_of,
    rests_still,
    roll_on,
    stay_on,
)
from tamias2d.engine.narrow_phase.material import mixed_material
from tamias2d.engine.tables import Bodies, Contacts, Control, Events, Shapes, World
from tamias2d.generated.continuous_collision import centre_acceleration_least
from tamias2d.generated.definitions import normal_velocity_after
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

SLOWEST_REBOUND = 2.0**-2  # velocities that gravity gives in a step: slower discs rest
AT_ONCE = 2.0**-30  # of the radius: what is as near touches


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
    if near == 0 or events.times[p] > step:
        return 0
    note_paths(bodies)
    while events.times[p] <= step:
        now = events.times[p]
        if bodies.path[disc_of(p, shapes, contacts), tb.RESTS_ON] == p + 1:
            roll_on(p, now, control, bodies, shapes, contacts)
            hard = True
        else:
            hard = met < tb.MOST_AT_ONCE and rebound_hard(p, met, now, world, contacts)
            met += 1
        near = look_on(p, now, near, met, taken, world, contacts) if hard else -1
        if near < 0:
            put_back(bodies)
            return -1
        p = first_to_meet(near, events)
    for i in range(len(bodies.kind)):
        if bodies.flight[i, tb.REDIRECTED] != 0.0:
            advance_to(i, step, bodies)
            bodies.flight[i, tb.PATH_START] = 0.0
    return met


@inlined
def disc_of(p: int, shapes: Shapes, contacts: Contacts) -> int:
    """Return the body of a disc of a pair."""
    s, _ = disc_and_other(p, shapes, contacts)
    return shapes.slot[s]


@inlined
def note_paths(bodies: Bodies) -> None:
    """Note where all bodies are as the step begins, and how they move."""
    for i in range(len(bodies.kind)):
        if bodies.kind[i] == tb.DYNAMIC:
            note_path(i, bodies)


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
    """Let a pair rebound at a time in the step, s; return whether it parts for a while, or rests.

    What is to be told of the impact is listed under a number.
    """
    control, bodies, shapes, events = world.control, world.bodies, world.shapes, world.events
    s, t = disc_and_other(p, shapes, contacts)
    i, j = shapes.slot[s], shapes.slot[t]
    advance_to(i, now, bodies)
    advance_to(j, now, bodies)
    friction, restitution = mixed_material(s, t, shapes.material, shapes.pair_overrides)
    row = events.met_points[2 * met]
    events.met[met, tb.MET_CONTACT], events.met[met, tb.MET_A], events.met[met, tb.MET_B] = p, i, j
    row[tb.M_FRICTION], row[tb.M_RESTITUTION], row[tb.M_DRAG] = friction, restitution, 0.0
    row[tb.M_PUSH] = row[tb.M_SURFACE_SPEED] = 0.0
    pull = find_touch(s, t, row, bodies, shapes)
    line = line_of(2 * met, False, events)
    row[tb.M_APPROACH] = speed_along(line, 0.0, bodies.motion, bodies.flight)
    parts = normal_velocity_after(restitution, row[tb.M_APPROACH])
    slow = not parts > SLOWEST_REBOUND * pull * control.settings[tb.TIME_STEP]
    lands = slow and not (restitution == 1.0 and parts > 0.0)  # what loses nothing bounces for ever
    if lands:
        if not may_land(i, t, row, control, bodies, shapes):
            return False
        row[tb.M_RESTITUTION], row[tb.M_APPROACH] = 0.0, min(row[tb.M_APPROACH], 0.0)
    rebound_at_point(2 * met, 0.0, bodies, events)
    row[tb.M_PLACE] = bodies.pose[i, tb.X] + row[tb.M_ARM_A]
    row[tb.M_PLACE + 1] = bodies.pose[i, tb.Y] + row[tb.M_ARM_A + 1]
    bodies.flight[i, tb.REDIRECTED] = 1.0
    bodies.flight[j, tb.REDIRECTED] = 1.0 if bodies.kind[j] == tb.DYNAMIC else 0.0
    if lands:
        return land(p, now, control, bodies, shapes, contacts)
    for k in (i, j):
        if bodies.path[k, tb.RESTS_ON] != 0.0:
            go_on_or_leave(k, now, control, bodies, shapes, contacts)
    return True


def may_land(i: int, t: int, row: Array, control: Control, bodies: Bodies, shapes: Shapes) -> bool:
    """Return whether a disc may stay where it meets a shape, for the first time in the step."""
    noise = noise_of(i, bodies.properties[i, tb.BOUNDING_RADIUS], control, bodies)
    comes = row[tb.M_APPROACH] <= noise
    return bool(comes and shapes.kind[t] == tb.HALF_PLANE and bodies.path[i, tb.RESTS_ON] == 0.0)


def go_on_or_leave(
    i: int, now: float, control: Control, bodies: Bodies, shapes: Shapes, contacts: Contacts
) -> None:
    """Let a disc that has been struck go on along its half-plane, or leave it, or meet it."""
    if rests_still(i, control, bodies, shapes, contacts):
        stay_on(int(bodies.path[i, tb.RESTS_ON]) - 1, now, control, bodies, shapes, contacts)
    else:
        leave_plane(i, now, control, bodies)


@inlined
def find_touch(s: int, t: int, row: Array, bodies: Bodies, shapes: Shapes) -> float:
    """Write where a disc touches a shape; return which acceleration presses them together, m/s^2.

    The normal leads from the disc to the other one.
    """
    i, j = shapes.slot[s], shapes.slot[t]
    radius = shapes.material[s, tb.SHAPE_RADIUS]
    x, y = bodies.pose[j, tb.X] - bodies.pose[i, tb.X], bodies.pose[j, tb.Y] - bodies.pose[i, tb.Y]
    if shapes.kind[t] == tb.HALF_PLANE:
        side = shapes.world_vertices[shapes.first[t]]
        nx, ny = -side[2], -side[3]
    else:
        far = sqrt(x * x + y * y)
        nx, ny = x / far, y / far
    row[tb.M_NORMAL], row[tb.M_NORMAL + 1] = nx, ny
    row[tb.M_ARM_A], row[tb.M_ARM_A + 1] = radius * nx, radius * ny
    row[tb.M_ARM_B], row[tb.M_ARM_B + 1] = radius * nx - x, radius * ny - y
    opening = centre_acceleration_least(pull_on(i, bodies), pull_on(j, bodies), (nx, ny), 0.0)
    return max(0.0, -opening)


def list_partners(body_count: int, world: World, contacts: Contacts) -> None:
    """List the pairs of each body, whom they are with, and where they are near."""
    shapes, events = world.shapes, world.events
    list_contacts_by_body(world.broad_phase, contacts, events, body_count)
    for i in range(body_count):
        for k in range(events.queue[tb.FIRST_OF_BODY, i], events.queue[tb.FIRST_OF_BODY, i + 1]):
            s, t = own_and_other(events.queue[tb.CONTACT_OF_BODY, k], i, contacts)
            plane = shapes.kind[t] == tb.HALF_PLANE
            events.partners[k, tb.PARTNER] = shapes.slot[t]
            events.partners[k, tb.PARTNER_SIDE] = shapes.first[t] if plane else -1
            events.reaches[k] = reach_of(s, t, NEAR, shapes)


def look_on(
    p: int, now: float, near: int, met: int, taken: int, world: World, contacts: Contacts
) -> int:
    """Find anew when both bodies of a pair that has met at a time, s, meet others in this step.

    Returns how many pairs are listed then; -1 if one of them was struck towards a third shape that
    it touches: which of them answers first is not known, unless both have met already.
    """
    control, bodies, shapes, events = world.control, world.bodies, world.shapes, world.events
    struck = met > 0 and events.met[met - 1, tb.MET_CONTACT] == p
    note_meeting(p, now, control, bodies, shapes, contacts, events)
    for i in (contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]):
        if bodies.kind[i] != tb.DYNAMIC:
            continue
        first, last = events.queue[tb.FIRST_OF_BODY, i], events.queue[tb.FIRST_OF_BODY, i + 1]
        find_gaps(i, first, last, now, bodies, shapes, events)
        find_due(last - first, now, taken, control.settings[tb.TIME_STEP], events.ahead)
        for k in range(first, last):
            q = events.queue[tb.CONTACT_OF_BODY, k]
            if q != p:
                events.times[q], events.due[q] = inf, int(events.ahead[tb.DUE_AHEAD, k - first])
                if events.due[q] <= taken:
                    known = not struck or has_met(q, i, met, bodies, events)
                    if not known and touches_and_comes(q, i, now, bodies, shapes, contacts):
                        return -1
                    near = list_again(q, now, near, control, bodies, shapes, contacts, events)
    return near


@inlined
def find_gaps(
    i: int, first: int, last: int, now: float, bodies: Bodies, shapes: Shapes, events: Events
) -> None:
    """Write the gaps between a disc whose path begins at a time in the step, s, and all others."""
    pose, motion = bodies.pose[i], bodies.motion[i]
    at, going = (pose[tb.X], pose[tb.Y]), (motion[tb.VX], motion[tb.VY])
    for k in range(first, last):
        j, side = events.partners[k, tb.PARTNER], events.partners[k, tb.PARTNER_SIDE]
        if side >= 0:
            plane, reach = shapes.world_vertices[side], events.reaches[k]
            gap, rate, by = closing_on_plane(i, j, plane, reach, at, going, bodies)
        else:
            gap, rate, by = closing_of_discs(i, j, events.reaches[k], at, going, now, bodies)
        ahead, n = events.ahead, k - first
        ahead[tb.GAP_AHEAD, n], ahead[tb.RATE_AHEAD, n], ahead[tb.BY_AHEAD, n] = gap, rate, by


@inlined
def own_and_other(q: int, i: int, contacts: Contacts) -> tuple[int, int]:
    """Return the shapes of a pair, that of a body first."""
    first = contacts.pairs[q, tb.SLOT_A] == i
    return contacts.pairs[q, 0 if first else 1], contacts.pairs[q, 1 if first else 0]


def touches_and_comes(
    q: int, i: int, now: float, bodies: Bodies, shapes: Shapes, contacts: Contacts
) -> bool:
    """Return whether a disc touches a shape at a time in the step, s, and approaches it."""
    s, t = own_and_other(q, i, contacts)
    at, going = place_at(i, now, bodies)
    gap, rate, _ = closing_of(s, t, at, going, now, AT_ONCE, bodies, shapes)
    return bool(gap <= 0.0 and rate < 0.0)


def has_met(q: int, i: int, met: int, bodies: Bodies, events: Events) -> bool:
    """Return whether a pair of a disc has met in this step, or the disc has rested there."""
    found = bool(bodies.flight[i, tb.RESTED_ON] == q + 1)
    for k in range(met):
        found = found or events.met[k, tb.MET_CONTACT] == q
    return found


@inlined
def list_again(
    q: int, now: float, near: int, control: Control, bodies: Bodies, shapes: Shapes,
    contacts: Contacts, events: Events,
) -> int:  # fmt: skip
    """Note when a pair meets in this step, s; return how many pairs are listed then."""
    note_meeting(q, now, control, bodies, shapes, contacts, events)
    at = events.queue[tb.PLACE, q]
    if not (0 <= at < near and events.queue[tb.WAITING, at] == q):
        events.queue[tb.WAITING, near], events.queue[tb.PLACE, q] = q, near
        near += 1
    return near
