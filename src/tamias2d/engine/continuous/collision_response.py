"""Collision response: what a pair that meets in flight does, with all that meet at that instant.

Bodies that are on parabolas are put on them first; what a level seam stops goes on. Pairs that
share a moving body answer together.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.bend import bend_paths, is_first, put_on_parabola
from tamias2d.engine.continuous.clusters import leave
from tamias2d.engine.continuous.events import manifold_at
from tamias2d.engine.continuous.gap_bound import UNBOUNDED
from tamias2d.engine.continuous.impact import (
    contact_point,
    normal_line,
    place_on_path,
    rebound,
    record_impact,
)
from tamias2d.engine.continuous.impact_points import (
    is_point,
    list_points,
    rebound_at_points,
    total_drag,
    total_push,
)
from tamias2d.engine.continuous.impulse import path_speed_along
from tamias2d.engine.continuous.meetings import gather_meetings, is_first_listed, measure_meeting
from tamias2d.engine.narrow_phase.core import core_of, is_thin
from tamias2d.engine.narrow_phase.material import mixed_material
from tamias2d.engine.narrow_phase.polygon import held_normal
from tamias2d.engine.narrow_phase.seams import (
    extend_ground,
    goes_on,
    is_seam,
    level_manifold,
    note_met_ground,
)
from tamias2d.engine.tables import Bodies, Contacts, Control, Events, Shapes
from tamias2d.generated.continuous_collision import position_later


def resolve_impact(
    p: int,
    now: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    events: Events,
) -> int:
    """Let a pair that meets rebound, together with all that meet then; return how many pairs do.

    There are none where it does not approach.
    """
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    sense = 1.0
    if shapes.kind[t] == tb.HALF_PLANE:
        s, t = t, s
        sense = -1.0
    i, j = shapes.slot[s], shapes.slot[t]
    held = held_normal(contacts.manifolds[p], contacts.flags[p])
    time_step = control.progress[tb.PART_TIME]
    count = gather_meetings(p, now, time_step, bodies, shapes, contacts, events)
    bends = contacts.flags[p, tb.LOCATED] > 0 and is_first(i, j, bodies)
    if bends:
        now = bend_paths(s, t, now, time_step, bodies, shapes, events)
        if now > 1.0:
            return 0
        events.times[len(bodies.kind) + p] = now
        a, b = core_of(s, shapes), core_of(t, shapes)
        if is_thin(a, b) and held[0] == 0.0 and held[1] == 0.0:
            held = (events.scratch[0, tb.NX], events.scratch[0, tb.NY])  # rounding hides the gap
    gap = manifold_at(s, t, now, held, bodies, shapes, events)
    if gap >= UNBOUNDED:  # it is beside a piece
        return 0
    manifold = events.scratch[0]
    if meets_seam(s, t, now, time_step, bodies, shapes, events):
        return 0
    level_meeting(s, t, now, bodies, shapes, events)
    list_points(0, now, bodies, shapes, contacts, events)
    if count > 1:
        return rebound_together(count, bends, now, control, bodies, shapes, contacts, events)
    friction, restitution = mixed_material(s, t, shapes.material, shapes.pair_overrides)
    impulse = rebound(i, j, now, friction, restitution, control, bodies, events)
    if impulse < 0.0:
        return 0
    if impulse > 0.0:
        normal = (sense * manifold[tb.NX], sense * manifold[tb.NY])
        place = place_on_path(i, now, contact_point(manifold), bodies)
        in_parts = control.counts[tb.LEVEL] > 0
        drag, manifold, flags = total_drag(0, events), contacts.manifolds[p], contacts.flags[p]
        record_impact(impulse, drag, place, normal, in_parts, manifold, flags)
    go_alone(i, bodies, events)
    go_alone(j, bodies, events)
    return 1


def rebound_together(
    count: int,
    bends: bool,
    now: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    events: Events,
) -> int:
    """Let all pairs that are listed rebound; return how many, none where they do not approach."""
    time_step = control.progress[tb.PART_TIME]
    for k in range(1, count):
        for i in (events.met[k, tb.MET_A], events.met[k, tb.MET_B]):
            if (
                bends
                and is_first_listed(i, k, events.met)
                and bodies.flight[i, tb.REDIRECTED] == 0.0
            ):
                put_on_parabola(i, now, time_step, bodies)
    for k in range(1, count):
        measure_meeting(k, now, bodies, shapes, contacts, events)
        q, turned = events.met[k, tb.MET_CONTACT], events.met[k, tb.MET_TURNED]
        s, t = contacts.pairs[q, turned], contacts.pairs[q, 1 - turned]
        level_meeting(s, t, now, bodies, shapes, events)
        list_points(k, now, bodies, shapes, contacts, events)
    if not rebound_at_points(count, now, time_step, bodies, events):
        return 0
    for k in range(count):
        tell_impact(k, now, control.counts[tb.LEVEL] > 0, bodies, contacts, events)
        go_alone(events.met[k, tb.MET_A], bodies, events)
        go_alone(events.met[k, tb.MET_B], bodies, events)
    return count


def tell_impact(
    k: int, now: float, in_parts: bool, bodies: Bodies, contacts: Contacts, events: Events
) -> None:
    """Add the impact of a listed pair to what is told of its contact, if it was pushed."""
    impulse, at = total_push(k, events)
    if impulse <= 0.0:
        return
    q, one = events.met[k, tb.MET_CONTACT], events.met_points[2 * k]
    row = one if is_point(one) else events.met_points[2 * k + 1]
    sense = -1.0 if events.met[k, tb.MET_TURNED] == 1 else 1.0
    normal = (sense * row[tb.M_NORMAL], sense * row[tb.M_NORMAL + 1])
    place = place_on_path(events.met[k, tb.MET_A], now, at, bodies)
    drag, manifold, flags = total_drag(k, events), contacts.manifolds[q], contacts.flags[q]
    record_impact(impulse, drag, place, normal, in_parts, manifold, flags)


def go_alone(i: int, bodies: Bodies, events: Events) -> None:
    """Note that an impact has redirected a body that moves freely, which goes on with no other."""
    if bodies.kind[i] == tb.DYNAMIC:
        bodies.flight[i, tb.REDIRECTED] = 1.0
        leave(i, events.together)


def level_meeting(
    s: int, t: int, now: float, bodies: Bodies, shapes: Shapes, events: Events
) -> None:
    """Let two shapes that meet at a corner in level ground meet that ground."""
    i, manifold = shapes.slot[s], events.scratch[0]
    still, moved = (t, s) if bodies.kind[shapes.slot[t]] == tb.STATIC else (s, t)
    if events.ground[shapes.slot[moved], tb.G_SHAPE] == 0.0:
        return
    extend_ground(still, moved, bodies, shapes, events.ground)
    place, shift = bodies.pose[i], bodies.motion[i]
    at = position_later((place[tb.X], place[tb.Y]), (shift[tb.DX], shift[tb.DY]), now)
    count = 2 if manifold[tb.GAP + tb.POINT] < UNBOUNDED else 1
    level_manifold(s, t, at, count, manifold, bodies, shapes, events.ground)


def meets_seam(
    s: int,
    t: int,
    now: float,
    time_step: float,
    bodies: Bodies,
    shapes: Shapes,
    events: Events,
) -> bool:
    """Return whether a body meets a static shape where that joins its ground."""
    i, j, manifold = shapes.slot[s], shapes.slot[t], events.scratch[0]
    if bodies.kind[i] != tb.STATIC and bodies.kind[j] != tb.STATIC:
        return False
    at, shift = bodies.pose[i], bodies.motion[i]
    x, y = position_later((at[tb.X], at[tb.Y]), (shift[tb.DX], shift[tb.DY]), now)
    by_x, by_y = contact_point(manifold)
    place, normal = (x + by_x, y + by_y), (manifold[tb.NX], manifold[tb.NY])
    line = normal_line(i, j, now, manifold, bodies)
    rise = time_step * path_speed_along(line, time_step, bodies.motion)
    if bodies.kind[i] != tb.STATIC:
        s, t, normal = t, s, (-normal[0], -normal[1])
    straight = goes_on(s, t, place, normal, rise, shapes, events.ground)
    if not straight and is_seam(s, t, place, normal, bodies, shapes, events.ground):
        extend_ground(s, t, bodies, shapes, events.ground)
        return True
    if not straight:
        note_met_ground(s, t, place, normal, bodies, shapes, events.ground)
    return straight
