"""When two bodies on their ways meet.

Serves: flight. Hides: how shapes are turned to where they are at an instant.
"""

from tamias2d.engine.continuous.conservative_advancement import (
    MISSED,
    NEAR,
    WIDE,
    place_vertices,
    time_of_impact,
)
from tamias2d.engine.continuous.event_queue import update_event
from tamias2d.engine.continuous.impact import contact_point, path_speed_along, seen_from_b
from tamias2d.engine.narrow_phase.collide import collide_cores
from tamias2d.engine.narrow_phase.core import core_of
from tamias2d.engine.tables import (
    ANGLE,
    CONTACT_OF_BODY,
    CONTACTS,
    CORE_RADIUS,
    DANGLE,
    DX,
    DY,
    DYNAMIC,
    FIRST_OF_BODY,
    GAP,
    HALF_PLANE,
    MIN_EXTENT,
    NX,
    NY,
    PATH_EXCESS,
    PATH_LENGTH,
    POINT,
    POINT_COUNT,
    REDIRECTED,
    SENSOR,
    SHAPE_RADIUS,
    SLOT_A,
    SLOT_B,
    TIME_STEP,
    Bodies,
    BroadPhase,
    Contacts,
    Control,
    Events,
    Shapes,
    X,
    Y,
)
from tamias2d.state import Array

THROUGH = 0.7  # of half the widths of both: how far one may go into another and be pushed back,
# but not farther than the smaller one reaches
SHALLOW = 0.5  # of that: how far what waits may come into what is not a wall, or that into it
SWUNG = 0.35  # of the smaller reach: how far one may turn about a contact, which the solver follows


def find_events(
    now: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    broad_phase: BroadPhase,
    contacts: Contacts,
    events: Events,
) -> int:
    """Find when all pairs meet from `now` on that the solver may let through; return how many do.

    The line that parts two bodies in contact holds them back: only what goes through it, or turns,
    can come farther in.
    """
    found = 0
    body_count = len(bodies.pose)
    for p in range(broad_phase.counts[CONTACTS]):
        events.times[body_count + p] = MISSED
        s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
        i, j = contacts.pairs[p, SLOT_A], contacts.pairs[p, SLOT_B]
        bent = bodies.flight[i, REDIRECTED] + bodies.flight[j, REDIRECTED] > 0.0
        reach = min(shapes.material[s, SHAPE_RADIUS], shapes.material[t, SHAPE_RADIUS])
        if not bent and stay_near(bodies.flight[i], bodies.flight[j], reach):
            continue
        touches = contacts.flags[p, POINT_COUNT] > 0
        if shapes.filters[s, SENSOR] != 0 or shapes.filters[t, SENSOR] != 0:
            continue
        by_x, by_y = (
            bodies.motion[j, DX] - bodies.motion[i, DX],
            bodies.motion[j, DY] - bodies.motion[i, DY],
        )
        turn = turning_reach(i, j, bodies.motion, bodies.properties)
        deep = allowed_depth(i, j, reach, bodies.properties)
        if not bent and abs(by_x) + abs(by_y) + turn <= deep:
            continue
        into = (
            max(0.0, -contacts.manifolds[p, NX] * by_x - contacts.manifolds[p, NY] * by_y)
            if touches
            else WIDE
        )
        if bent or into + turn > max(deep, SWUNG * reach):
            events.times[body_count + p] = next_event(
                s, t, now, control.settings[TIME_STEP], bodies, shapes, events
            )
            found += events.times[body_count + p] <= 1.0
    return found


def turning_reach(i: int, j: int, motion: Array, properties: Array) -> float:
    """Return how far corners of two bodies go by turning in a step, m."""
    return (
        abs(motion[i, DANGLE]) * properties[i, CORE_RADIUS]
        + abs(motion[j, DANGLE]) * properties[j, CORE_RADIUS]
    )


def allowed_depth(i: int, j: int, reach: float, properties: Array) -> float:
    """Return how far one body may go into another and be pushed back, m."""
    return min(THROUGH * half_widths(properties[i, MIN_EXTENT], properties[j, MIN_EXTENT]), reach)


def stay_near(one: Array, other: Array, reach: float) -> bool:
    """Return whether two bodies go too little for one to get far into the other.

    This is what follows from how far each goes, and not from where both go.
    """
    return bool(
        (one[PATH_EXCESS] + other[PATH_EXCESS] <= 0.0)
        & (one[PATH_LENGTH] + other[PATH_LENGTH] <= reach)
    )


def update_events_of(
    i: int,
    but: int,
    now: float,
    shallow: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    broad_phase: BroadPhase,
    contacts: Contacts,
    events: Events,
) -> None:
    """Find anew when a body meets others `but` one: its line is not what it was.

    What can be pushed comes into it, if by no more than a share of what can be undone.
    """
    if bodies.kind[i] != DYNAMIC:
        return
    body_count = len(bodies.pose)
    for k in range(events.queue[FIRST_OF_BODY, i], events.queue[FIRST_OF_BODY, i + 1]):
        p = events.queue[CONTACT_OF_BODY, k]
        s, t, a, b = (
            contacts.pairs[p, 0],
            contacts.pairs[p, 1],
            contacts.pairs[p, SLOT_A],
            contacts.pairs[p, SLOT_B],
        )
        if but in (a, b) or shapes.filters[s, SENSOR] != 0 or shapes.filters[t, SENSOR] != 0:
            continue
        way = abs(bodies.motion[b, DX] - bodies.motion[a, DX]) + abs(
            bodies.motion[b, DY] - bodies.motion[a, DY]
        )
        way += turning_reach(a, b, bodies.motion, bodies.properties)
        deep = allowed_depth(
            a,
            b,
            min(shapes.material[s, SHAPE_RADIUS], shapes.material[t, SHAPE_RADIUS]),
            bodies.properties,
        )
        harmless = bodies.kind[a] == bodies.kind[b] and way * (1.0 - now) <= shallow * deep
        events.times[body_count + p] = (
            MISSED
            if harmless
            else next_event(s, t, now, control.settings[TIME_STEP], bodies, shapes, events)
        )
        update_event(
            body_count + p, body_count + broad_phase.counts[CONTACTS], events.times, events.queue
        )


def half_widths(one: float, other: float) -> float:
    """Return half the widths of two bodies, m; of a half-plane only the other's counts."""
    return one if other > WIDE else other if one > WIDE else one + other


def manifold_at(
    s: int, t: int, now: float, bodies: Bodies, shapes: Shapes, events: Events
) -> float:
    """Write the manifold of two shapes at a fraction of the step; return their gap, m."""
    i, j = shapes.slot[s], shapes.slot[t]
    half_plane = shapes.kind[s] == HALF_PLANE
    turn_shape_to(s, i, now, half_plane, bodies, shapes)
    turn_shape_to(t, j, now, False, bodies, shapes)
    x = bodies.pose[j, X] - bodies.pose[i, X] + now * (bodies.motion[j, DX] - bodies.motion[i, DX])
    y = bodies.pose[j, Y] - bodies.pose[i, Y] + now * (bodies.motion[j, DY] - bodies.motion[i, DY])
    row = events.scratch[0]
    _, second = collide_cores(row, core_of(s, shapes), core_of(t, shapes), x, y, WIDE, shapes.world_vertices)
    if second == 0:
        row[GAP + POINT] = WIDE
    return min(row[GAP], row[GAP + POINT])


def turn_shape_to(s: int, i: int, now: float, fixed: bool, bodies: Bodies, shapes: Shapes) -> None:
    """Turn the corners of a shape to where they are at a fraction of the step."""
    first = int(shapes.first[s])
    turn = bodies.pose[i, ANGLE] + now * bodies.motion[i, DANGLE]
    place_vertices(
        first,
        int(shapes.count[s]),
        turn,
        fixed,
        shapes.local_vertices,
        first,
        shapes.world_vertices,
    )


def next_event(
    s: int, t: int, now: float, time_step: float, bodies: Bodies, shapes: Shapes, events: Events
) -> float:
    """Return the fraction of the step, from `now` on, at which two shapes meet, or `MISSED`.

    A pair that is close now meets now if it approaches by more than counts as close.
    """
    if shapes.kind[t] == HALF_PLANE:
        s, t = t, s
    i, j = shapes.slot[s], shapes.slot[t]
    near = NEAR * min(shapes.material[s, SHAPE_RADIUS], shapes.material[t, SHAPE_RADIUS])
    if passes_by(
        i,
        j,
        now,
        shapes.material[s, SHAPE_RADIUS] + shapes.material[t, SHAPE_RADIUS] + near,
        bodies.pose,
        bodies.motion,
    ):
        return MISSED
    gap = manifold_at(s, t, now, bodies, shapes, events)
    rest = 1.0 - now
    if gap <= near:
        at_a = contact_point(events.scratch[0])
        at_b = seen_from_b(i, j, now, at_a, bodies.pose, bodies.motion)
        line = (events.scratch[0, NX], events.scratch[0, NY])
        closing = time_step * path_speed_along(i, j, time_step, at_a, at_b, line, bodies.motion)
        if closing * rest < -near:
            return now
    ahead = time_of_impact(
        s,
        t,
        bodies.pose[j, X] - bodies.pose[i, X] + now * (bodies.motion[j, DX] - bodies.motion[i, DX]),
        bodies.pose[j, Y] - bodies.pose[i, Y] + now * (bodies.motion[j, DY] - bodies.motion[i, DY]),
        rest * (bodies.motion[j, DX] - bodies.motion[i, DX]),
        rest * (bodies.motion[j, DY] - bodies.motion[i, DY]),
        rest * bodies.motion[i, DANGLE],
        rest * bodies.motion[j, DANGLE],
        shapes,
        events,
    )
    return now + ahead * rest if ahead <= 1.0 else MISSED


def passes_by(i: int, j: int, now: float, reach: float, pose: Array, motion: Array) -> bool:
    """Return whether the centres of two bodies come no nearer to each other than a reach, m."""
    by_x, by_y = motion[j, DX] - motion[i, DX], motion[j, DY] - motion[i, DY]
    x, y = pose[j, X] - pose[i, X] + now * by_x, pose[j, Y] - pose[i, Y] + now * by_y
    ahead = -(x * by_x + y * by_y)
    square = by_x * by_x + by_y * by_y
    if ahead > 0.0:  # to where they are nearest, but not beyond the step
        until = min(ahead / square, 1.0 - now)
        x, y = x + until * by_x, y + until * by_y
    return bool(x * x + y * y > reach * reach)
