"""Sensors in flight: what passes right through one within a step is sensed, too.

Nothing is pushed: paths stay. What is in a sensor as a step ends is told by the next one, which
looks as it begins. Cost: that of a pair that may meet.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.conservative_advancement import (
    MISSED,
    NEAR,
    measure_gap,
    time_of_impact,
)
from tamias2d.engine.continuous.event_queue import update_event
from tamias2d.engine.continuous.impact import contact_point, place_on_path
from tamias2d.engine.continuous.passing import keep_away, smaller_radius, turn_shape_to
from tamias2d.engine.continuous.trajectory import relative_path, relative_place
from tamias2d.engine.narrow_phase.core import core_of
from tamias2d.engine.tables import Bodies, BroadPhase, Contacts, Events, Integers, Shapes


def may_be_sensed(flags: Integers) -> bool:
    """Return whether nothing is known yet, in this step, of what a sensor meets."""
    return bool(flags[tb.TOUCHES] & tb.IS_TOUCHING == 0 and flags[tb.LOCATED] == 0)


def time_of_sensing(
    s: int, t: int, now: float, bodies: Bodies, shapes: Shapes, events: Events
) -> float:
    """Return the fraction of the step, from `now` on, at which one shape meets another, a sensor.

    It is `MISSED` if it does not.
    """
    if keep_away(s, t, now, bodies, shapes):
        return MISSED
    i, j = shapes.slot[s], shapes.slot[t]
    turn_shape_to(s, i, now, bodies, shapes)
    turn_shape_to(t, j, now, bodies, shapes)
    path = relative_path(i, j, now, bodies)
    ahead = time_of_impact(s, t, True, path, (0.0, 0.0), shapes, events)
    return now + ahead * (1.0 - now) if ahead <= 1.0 else MISSED


def note_sensed(
    p: int, now: float, bodies: Bodies, shapes: Shapes, contacts: Contacts, events: Events
) -> None:
    """Note where a sensor meets another shape at a fraction of the step: once in a part of it."""
    manifold, flags = contacts.manifolds[p], contacts.flags[p]
    first = 1 if shapes.kind[contacts.pairs[p, 1]] == tb.HALF_PLANE else 0
    s, t = contacts.pairs[p, first], contacts.pairs[p, 1 - first]
    gap_at(s, t, now, bodies, shapes, events)
    found, sense = events.scratch[0], 1.0 - 2.0 * first
    at = place_on_path(shapes.slot[s], now, contact_point(found), bodies)
    manifold[tb.WORLD_POINT], manifold[tb.WORLD_POINT + 1] = at
    manifold[tb.IMPACT_NORMAL] = sense * found[tb.NX]
    manifold[tb.IMPACT_NORMAL + 1] = sense * found[tb.NY]
    flags[tb.POINT_COUNT], flags[tb.LOCATED] = 0, tb.SPENT
    event = len(bodies.kind) + p
    events.times[event] = MISSED
    update_event(event, events.times, events.queue)


def tell_passed(
    bodies: Bodies, shapes: Shapes, broad_phase: BroadPhase, contacts: Contacts, events: Events
) -> None:
    """Tell of what sensors have met in flight that it touched, unless it is in them at the end."""
    for p in range(broad_phase.counts[tb.CONTACTS]):
        flags = contacts.flags[p]
        if flags[tb.SENSES] == 1 and flags[tb.LOCATED] > 0:
            first = 1 if shapes.kind[contacts.pairs[p, 1]] == tb.HALF_PLANE else 0
            s, t = contacts.pairs[p, first], contacts.pairs[p, 1 - first]
            near = NEAR * smaller_radius(s, t, shapes.material)
            if gap_at(s, t, 1.0, bodies, shapes, events) > near:
                flags[tb.TOUCHES] |= tb.IS_TOUCHING


def gap_at(s: int, t: int, now: float, bodies: Bodies, shapes: Shapes, events: Events) -> float:
    """Write the manifold of a sensor and what it meets at a fraction of the step; return the gap.

    A half-plane is the first one; either may be on any side of the other one.
    """
    i, j = shapes.slot[s], shapes.slot[t]
    turn_shape_to(s, i, now, bodies, shapes)
    turn_shape_to(t, j, now, bodies, shapes)
    x, y = relative_place(i, j, now, bodies.pose, bodies.motion)
    a, b = core_of(s, shapes), core_of(t, shapes)
    return measure_gap(events.scratch[0], a, b, x, y, (0.0, 0.0), shapes.world_vertices)
