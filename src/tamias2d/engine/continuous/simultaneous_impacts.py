"""Impacts at one instant: all points of all pairs that approach then answer together (DD67).

Each point is solved by itself, in turns, until no impulse changes any more: first along the
normals alone, then along normals and tangents. Source: Moreau (1988).
"""

from tamias2d.engine.continuous.conservative_advancement import NEAR
from tamias2d.engine.continuous.gap_bound import UNBOUNDED
from tamias2d.engine.continuous.impact import place_on_path, record_impact
from tamias2d.engine.continuous.impulse import (
    ImpulseLine,
    change_paths,
    change_velocities,
    change_velocities_and_paths,
    mass_along,
    path_speed_along,
    speed_along,
)
from tamias2d.engine.continuous.meetings import measure_meeting
from tamias2d.engine.continuous.trajectory import relative_place
from tamias2d.engine.narrow_phase.material import mixed_material
from tamias2d.engine.tables import (
    GAP,
    LEVEL,
    M_APPROACH,
    M_ARM_A,
    M_ARM_B,
    M_DRAG,
    M_FRICTION,
    M_HELD,
    M_LASTING,
    M_NORMAL,
    M_PUSH,
    M_RESTITUTION,
    MET_A,
    MET_B,
    MET_CONTACT,
    MET_TURNED,
    NX,
    NY,
    PART_TIME,
    POINT,
    PX,
    PY,
    Bodies,
    Contacts,
    Control,
    Events,
    Shapes,
)
from tamias2d.generated.soft_contact import limited_tangent_impulse, restitution_impulse
from tamias2d.state import Array

MOST_VISITS = 64  # over all points, of each of the ways to solve them
UNCHANGED = 2.0**-48  # of the largest impulse


def rebound_together(
    count: int,
    now: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    events: Events,
) -> bool:
    """Let the pairs that are listed rebound at once; return whether one of them approached."""
    left, time_step = 1.0 - now, control.progress[PART_TIME]
    for k in range(count):
        measure_meeting(k, now, bodies, shapes, contacts, events)
        list_points(k, now, bodies, shapes, contacts, events)
    if not note_approach_speeds(count, left, time_step, bodies, events):
        return False
    solve_points(False, count, now, time_step, bodies, events)
    if hold_paths(count, now, time_step, bodies, events):
        hold_velocities(count, bodies, events)
    solve_points(True, count, now, time_step, bodies, events)
    for k in range(count):
        tell_meeting(k, now, control.counts[LEVEL] > 0, bodies, contacts, events)
    return True


def list_points(
    k: int, now: float, bodies: Bodies, shapes: Shapes, contacts: Contacts, events: Events
) -> None:
    """List the points of a pair whose manifold is in the scratch: two where both are as deep."""
    q, a, b = events.met[k, MET_CONTACT], events.met[k, MET_A], events.met[k, MET_B]
    s, t, manifold = contacts.pairs[q, 0], contacts.pairs[q, 1], events.scratch[0]
    friction, restitution = mixed_material(s, t, shapes.material, shapes.pair_overrides)
    x, y = relative_place(a, b, now, bodies.pose, bodies.motion)
    far = abs(manifold[PX + POINT] - manifold[PX]) + abs(manifold[PY + POINT] - manifold[PY])
    deepest = min(manifold[GAP], manifold[GAP + POINT])
    for n in range(2):
        row, at = events.met_points[2 * k + n], n * POINT
        for m in range(len(row)):
            row[m] = 0.0
        gap = manifold[GAP + at]
        if gap < UNBOUNDED and (gap == deepest or gap - deepest <= NEAR * far):
            row[M_ARM_A], row[M_ARM_A + 1] = manifold[PX + at], manifold[PY + at]
            row[M_ARM_B], row[M_ARM_B + 1] = manifold[PX + at] - x, manifold[PY + at] - y
            row[M_NORMAL], row[M_NORMAL + 1] = manifold[NX], manifold[NY]
            row[M_FRICTION], row[M_RESTITUTION] = friction, restitution


def line_of(r: int, tangent: bool, events: Events) -> ImpulseLine:
    """Return the line of the normal impulse at a point, or of that along the tangent."""
    row, a, b = events.met_points[r], events.met[r // 2, MET_A], events.met[r // 2, MET_B]
    x, y = row[M_NORMAL], row[M_NORMAL + 1]
    along = (-y, x) if tangent else (x, y)
    at_a, at_b = (row[M_ARM_A], row[M_ARM_A + 1]), (row[M_ARM_B], row[M_ARM_B + 1])
    return ImpulseLine(a, b, at_a, at_b, along)


def is_point(row: Array) -> bool:
    """Return whether a row is of a point, which has a normal."""
    return bool((row[M_NORMAL] != 0.0) | (row[M_NORMAL + 1] != 0.0))


def note_approach_speeds(
    count: int, left: float, time_step: float, bodies: Bodies, events: Events
) -> bool:
    """Note how fast bodies approach at all points; return whether they or their paths do."""
    found = False
    for r in range(2 * count):
        row = events.met_points[r]
        if is_point(row):
            line = line_of(r, False, events)
            speed = speed_along(line, left, bodies.motion, bodies.flight)
            row[M_APPROACH] = min(speed, 0.0)
            found = found or min(speed, path_speed_along(line, time_step, bodies.motion)) < 0.0
    return found


def solve_points(
    rough: bool, count: int, now: float, time_step: float, bodies: Bodies, events: Events
) -> None:
    """Solve all points that approached until no impulse changes, along tangents, too, if rough.

    Without friction nothing is left to do then.
    """
    for _ in range(MOST_VISITS):
        largest = change = 0.0
        for r in range(2 * count):
            row = events.met_points[r]
            if row[M_APPROACH] < 0.0 and (row[M_FRICTION] > 0.0 or not rough):
                if rough:
                    change = max(change, drag_point(r, now, time_step, bodies, events))
                change = max(change, push_point(r, now, time_step, bodies, events))
                largest = max(largest, row[M_PUSH])
        if change <= UNCHANGED * largest:
            return


def push_point(r: int, now: float, time_step: float, bodies: Bodies, events: Events) -> float:
    """Bring a point to the normal velocity that it rebounds with; return the change, N s."""
    row, line = events.met_points[r], line_of(r, False, events)
    speed = speed_along(line, 1.0 - now, bodies.motion, bodies.flight)
    mass = mass_along(line, bodies.properties)
    after = restitution_impulse(row[M_PUSH], speed, row[M_APPROACH], row[M_RESTITUTION], mass)
    change = after - row[M_PUSH]
    change_velocities_and_paths(line, now, time_step, change, bodies)
    row[M_PUSH] = after
    return abs(change)


def drag_point(r: int, now: float, time_step: float, bodies: Bodies, events: Events) -> float:
    """Stop the sliding at a point, as far as friction does; return the change, N s."""
    row, line = events.met_points[r], line_of(r, True, events)
    speed = speed_along(line, 1.0 - now, bodies.motion, bodies.flight)
    mass = mass_along(line, bodies.properties)
    pushed = row[M_PUSH] + row[M_LASTING]
    after = limited_tangent_impulse(row[M_DRAG], speed, mass, row[M_FRICTION], pushed)
    change = after - row[M_DRAG]
    change_velocities_and_paths(line, now, time_step, change, bodies)
    row[M_DRAG] = after
    return abs(change)


def hold_paths(count: int, now: float, time_step: float, bodies: Bodies, events: Events) -> bool:
    """Let paths stay together that forces press together again; return whether some do."""
    pressed = False
    for _ in range(MOST_VISITS):
        largest = change = 0.0
        for r in range(2 * count):
            row = events.met_points[r]
            if is_point(row):
                line = line_of(r, False, events)
                rate = path_speed_along(line, time_step, bodies.motion)
                mass = mass_along(line, bodies.properties)
                after = restitution_impulse(row[M_HELD], rate, 0.0, 0.0, mass)
                change_paths(line, now, (after - row[M_HELD]) * time_step, bodies)
                change, largest = max(change, abs(after - row[M_HELD])), max(largest, after)
                row[M_HELD] = after
        pressed = pressed or largest > 0.0
        if change <= UNCHANGED * largest:
            break
    return pressed


def hold_velocities(count: int, bodies: Bodies, events: Events) -> None:
    """Stop what forces give bodies by the end of the step at points whose paths are held."""
    for _ in range(MOST_VISITS):
        largest = change = 0.0
        for r in range(2 * count):
            row = events.met_points[r]
            if row[M_HELD] > 0.0:
                line = line_of(r, False, events)
                speed = speed_along(line, 0.0, bodies.motion, bodies.flight)
                mass = mass_along(line, bodies.properties)
                after = restitution_impulse(row[M_LASTING], speed, 0.0, 0.0, mass)
                change_velocities(line, after - row[M_LASTING], bodies.motion, bodies.properties)
                change, largest = max(change, abs(after - row[M_LASTING])), max(largest, after)
                row[M_LASTING] = after
        if change <= UNCHANGED * largest:
            return


def tell_meeting(
    k: int, now: float, in_parts: bool, bodies: Bodies, contacts: Contacts, events: Events
) -> None:
    """Add the impact of a pair to what is told of its contact, where its points are pushed."""
    q, a = events.met[k, MET_CONTACT], events.met[k, MET_A]
    first, second = events.met_points[2 * k], events.met_points[2 * k + 1]
    one, other = first[M_PUSH] + first[M_LASTING], second[M_PUSH] + second[M_LASTING]
    impulse = one + other
    if impulse <= 0.0:
        return
    share = other / impulse
    x = (1.0 - share) * first[M_ARM_A] + share * second[M_ARM_A]
    y = (1.0 - share) * first[M_ARM_A + 1] + share * second[M_ARM_A + 1]
    row = first if is_point(first) else second
    sense = -1.0 if events.met[k, MET_TURNED] == 1 else 1.0
    normal = (sense * row[M_NORMAL], sense * row[M_NORMAL + 1])
    place = place_on_path(a, now, (x, y), bodies)
    record_impact(impulse, place, normal, in_parts, contacts.manifolds[q], contacts.flags[q])
