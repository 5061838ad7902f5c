"""Hard discs: where nothing but gravity and contacts moves a few discs, from impact to impact.

Pairs of discs, and discs and half-planes that stand, meet at an instant that has a closed form
(DD46, DD80). They rebound there (IM3, IM9), and go on along their parabolas (IM1); what bounces no
more slides and rolls on its half-plane (DD85). Whatever else may happen in a step is left to the
ordinary way: discs that lean on each other, a third shape where two meet, an overlap.

Of each pair it is known for how many steps nothing happens to it. Cost: a step in which nothing
does is a pass over bodies; an impact looks at the pairs of both bodies.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.contact_list import current_contacts
from tamias2d.engine.continuous.impact import record_impact
from tamias2d.engine.hard_scene import are_hard_discs
from tamias2d.engine.motion.hard_impacts import list_partners, pass_impacts
from tamias2d.engine.motion.hard_meetings import foretell, list_due, soonest_of
from tamias2d.engine.motion.hard_paths import begin_paths, disc_and_other, fly_on, steps_near
from tamias2d.engine.motion.hard_rest import begin_rest, footing, push_of_rest
from tamias2d.engine.motion.quiet import age, is_known, note_quiet, show_moved
from tamias2d.engine.narrow_phase.touching import forget_arrangement
from tamias2d.engine.reports.contact_log import log_events
from tamias2d.engine.tables import Bodies, Contacts, Control, Events, Shapes, World
from tamias2d.kernels.assembled import inlined


def may_be_hard(world: World) -> bool:
    """Return whether the next step may be one of hard discs."""
    near = steps_near(1, world.control, world.bodies) > 0
    return near and are_hard_discs(world.bodies, world.shapes) and not discs_lean(world)


def discs_lean(world: World) -> bool:
    """Return whether two discs pushed each other in the last step, and not only in flight."""
    contacts = current_contacts(world.broad_phase, world.buffers)
    for p in range(world.broad_phase.counts[tb.CONTACTS]):
        s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
        discs = world.shapes.kind[s] == tb.DISC and world.shapes.kind[t] == tb.DISC
        pushed = contacts.flags[p, tb.TOUCHES] & tb.IS_TOUCHING
        if discs and pushed and contacts.flags[p, tb.POINT_COUNT] > 0:
            return True
    return False


def take_hard_steps(world: World) -> None:
    """Take the steps that are left, as long as discs meet two by two.

    Where events are told, what may cease to touch in the next step is looked at after that one.
    """
    control, bodies, shapes, events = world.control, world.bodies, world.shapes, world.events
    contacts = current_contacts(world.broad_phase, world.buffers)
    listed, steps = world.broad_phase.counts[tb.CONTACTS], control.counts[tb.STEPS_LEFT]
    begin_paths(control, bodies)
    for p in range(listed):
        begin_rest(p, control, bodies, shapes, contacts)
    for p in range(listed):
        foretell(p, 0, control, bodies, shapes, contacts, events)
    soonest = soonest_of(listed, events)
    taken, known, partnered = 0, list_known(listed, contacts, events), False
    logged, touched = True, known > 0
    while taken < steps and logged:
        met = near = 0
        alone = touched and control.counts[tb.EVENTS_TOLD] == 1
        ahead = 1 if alone else max(min(soonest, steps) - taken, 1)
        ahead = steps_near(ahead, control, bodies)
        if ahead == 0:
            break
        looks = soonest <= taken
        if looks:
            near = list_near(taken, listed, world, contacts)
            if near > 0 and not partnered:
                list_partners(len(bodies.kind), world, contacts)
                partnered = True
            met = pass_impacts(near, taken, world, contacts)
            if met < 0:
                break
        fly_on(ahead, bodies)
        taken += ahead
        control.counts[tb.FINEST] = 0
        for k in range(min(ahead, 2)):  # that pairs have touched is known for so many steps
            known = age_known(known, shapes, contacts, events)
            known = tell_impacts(met if k == 0 else 0, known, contacts, events)
            known = tell_rests(known, control, bodies, shapes, contacts, events)
        for k in range(near):
            p = events.queue[tb.WAITING, k]
            foretell(p, taken, control, bodies, shapes, contacts, events)
        if looks:
            soonest = soonest_of(listed, events)
        if touched or looks:
            logged = log_events(world)
        touched = met > 0
    if taken > 0:
        note_quiet(taken, world)
        forget_arrangement(world.touching.counts[tb.TOUCHING] > 0, world.touching)
        show_moved(world.state, bodies)


def list_near(taken: int, listed: int, world: World, contacts: Contacts) -> int:
    """List the pairs to which something may happen in a step; return how many there are.

    A disc that is on a half-plane as the step begins, without a velocity along its normal, rests.
    """
    control, bodies, shapes, events = world.control, world.bodies, world.shapes, world.events
    near = list_due(taken, listed, events)
    rests = False
    for k in range(near):
        p = events.queue[tb.WAITING, k]
        rests = begin_rest(p, control, bodies, shapes, contacts) or rests
    if rests:
        for p in range(listed):
            foretell(p, taken, control, bodies, shapes, contacts, events)
        near = list_due(taken, listed, events)
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
        push, drag = row[tb.M_PUSH], row[tb.M_DRAG]
        record_impact(push, drag, place, normal, False, contacts.manifolds[p], contacts.flags[p])
    return known


def tell_rests(
    known: int, control: Control, bodies: Bodies, shapes: Shapes, contacts: Contacts, events: Events
) -> int:
    """Add what half-planes push discs that rest on them; likewise."""
    step = control.settings[tb.TIME_STEP]
    for i in range(len(bodies.kind)):
        p = int(bodies.flight[i, tb.RESTED_ON]) - 1
        push, drag = push_of_rest(i, step, bodies)
        if p >= 0 and push > 0.0:
            s, t = disc_and_other(p, shapes, contacts)
            arm, normal = footing(s, t, shapes)
            place = (bodies.start[i, tb.X] + arm[0], bodies.start[i, tb.Y] + arm[1])
            if contacts.flags[p, tb.TOUCHES] == 0:
                events.touched[known] = p
                known += 1
            if contacts.pairs[p, 0] == s:
                normal = (-normal[0], -normal[1])
            manifold, flags = contacts.manifolds[p], contacts.flags[p]
            record_impact(push, drag, place, normal, False, manifold, flags)
    return known
