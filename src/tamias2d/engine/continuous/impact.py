"""One impact in flight: two bodies rebound, or stay together.

Velocities are those at the end of the step, with all that forces do in it; those at the instant of
an impact lack what forces do in the rest of the step.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.conservative_advancement import NEAR
from tamias2d.engine.continuous.gap_bound import UNBOUNDED
from tamias2d.engine.continuous.impact_points import rebound_at_points, slip_along, total_push
from tamias2d.engine.continuous.impulse import (
    ImpulseLine,
    change_paths,
    change_velocities,
    change_velocities_and_paths,
    mass_along,
    path_speed_along,
    speed_along,
)
from tamias2d.engine.continuous.motion_sums import place_at_end
from tamias2d.engine.continuous.trajectory import relative_place
from tamias2d.engine.continuous.two_as_one import keeps_turning, return_turning, turning_of
from tamias2d.engine.continuous.work import (
    energy_seen,
    support_velocity,
    take_energy_back,
    take_impulse_back,
    work_ahead,
)
from tamias2d.engine.energy.step_energy import can_be_turned
from tamias2d.engine.part_impulses import forget_earlier
from tamias2d.engine.tables import Bodies, Control, Events, Integers
from tamias2d.generated.continuous_collision import position_later
from tamias2d.generated.definitions import point_velocity
from tamias2d.generated.soft_contact import limited_tangent_impulse, restitution_impulse
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector

MOST_TURNS = 8  # of normal and tangent in one impact
SETTLED_IMPULSE = 2.0**-40  # of the first one


def contact_point(manifold: Array) -> Vector:
    """Return where two shapes touch: the deeper point, or midway where both are as deep."""
    apart = manifold[tb.GAP + tb.POINT] - manifold[tb.GAP]
    x, y, other_x, other_y = (
        manifold[tb.PX],
        manifold[tb.PY],
        manifold[tb.PX + tb.POINT],
        manifold[tb.PY + tb.POINT],
    )
    near = NEAR * (abs(other_x - x) + abs(other_y - y))
    if manifold[tb.GAP + tb.POINT] < UNBOUNDED and abs(apart) <= near:
        return 0.5 * (x + other_x), 0.5 * (y + other_y)
    if apart < 0.0:
        return other_x, other_y
    return x, y


def normal_line(i: int, j: int, now: float, manifold: Array, bodies: Bodies) -> ImpulseLine:
    """Return the line of the normal impulse between bodies i and j at a fraction of the step."""
    at_a = contact_point(manifold)
    place = relative_place(i, j, now, bodies.pose, bodies.motion)
    at_b = (at_a[0] - place[0], at_a[1] - place[1])
    return ImpulseLine(i, j, at_a, at_b, (manifold[tb.NX], manifold[tb.NY]))


def rebound(
    i: int,
    j: int,
    now: float,
    friction: float,
    restitution: float,
    control: Control,
    bodies: Bodies,
    events: Events,
) -> float:
    """Apply the impact of two bodies, so that it makes no energy; return as `apply_impact` does.

    Impacts between moving bodies take none of the displacement that both have in all, as masses
    count. But a body whose path leads into one that nothing moves loses a part of its work, and a
    surface that runs may give any. A body that nothing turns is seen from where it is pushed.
    """
    time_step, left = control.progress[tb.PART_TIME], 1.0 - now
    if bodies.kind[i] == bodies.kind[j]:
        return rebound_freely(i, j, now, time_step, friction, restitution, bodies, events)
    k, wall = (i, j) if bodies.kind[i] == tb.DYNAMIC else (j, i)
    support = support_velocity(k, wall, now, bodies.pose, bodies.motion)
    spin, row = bodies.motion[wall, tb.SPIN], bodies.motion[k]
    x, y, turn = row[tb.VX], row[tb.VY], row[tb.SPIN]
    before = -work_ahead(k, left, control, bodies)
    impulse = apply_impact(i, j, now, time_step, friction, restitution, bodies, events)
    if not can_be_turned(k, bodies.properties):
        support = point_velocity(support, spin, pushed_arm(i, k, now, bodies, events))
    before += energy_seen(k, (x, y), turn, support, spin, bodies.properties)
    velocity, after = (row[tb.VX], row[tb.VY]), -work_ahead(k, left, control, bodies)
    after += energy_seen(k, velocity, row[tb.SPIN], support, spin, bodies.properties)
    if events.met_points[0, tb.M_SURFACE_SPEED] == 0.0:
        given, turned = (row[tb.VX] - x, row[tb.VY] - y), row[tb.SPIN] - turn
        surplus = take_impulse_back(
            k, after - before, given, turned, support, spin, bodies.motion, bodies.properties
        )
        take_energy_back(k, surplus, support, spin, bodies.motion, bodies.properties)
    return impulse


def pushed_arm(i: int, k: int, now: float, bodies: Bodies, events: Events) -> Vector:
    """Return where an impact of body i pushes k, itself or the other, from its centre, m."""
    impulse, at = total_push(0, events)
    if not impulse > 0.0:  # of bodies with contacts, which were pushed where they touch
        at = contact_point(events.scratch[0])
    x, y = relative_place(i, k, now, bodies.pose, bodies.motion)
    return at[0] - x, at[1] - y


def rebound_freely(
    i: int,
    j: int,
    now: float,
    time_step: float,
    friction: float,
    restitution: float,
    bodies: Bodies,
    events: Events,
) -> float:
    """Apply the impact of two bodies that move freely, and let them keep their angular momentum."""
    if not keeps_turning(i, j, bodies):
        return apply_impact(i, j, now, time_step, friction, restitution, bodies, events)
    before = turning_of(i, j, place_at_end(i, (0.0, 0.0), bodies), bodies)
    impulse = apply_impact(i, j, now, time_step, friction, restitution, bodies, events)
    return_turning(i, j, before, bodies)
    return impulse


def apply_impact(
    i: int,
    j: int,
    now: float,
    time_step: float,
    friction: float,
    restitution: float,
    bodies: Bodies,
    events: Events,
) -> float:
    """Apply the impact of two bodies, whose manifold is in the scratch.

    Returns the normal impulse, N s; a negative number where nothing happens. That of friction is
    left at the listed points.
    """
    if bodies.flight[i, tb.SUPPORTED] + bodies.flight[j, tb.SUPPORTED] > 0.0:
        line = normal_line(i, j, now, events.scratch[0], bodies)
        row = events.met_points[0]
        return apply_rows_in_turns(line, now, time_step, friction, restitution, row, bodies)
    if not rebound_at_points(1, now, time_step, bodies, events):
        return -1.0
    impulse, _ = total_push(0, events)
    return impulse


def apply_rows_in_turns(
    line: ImpulseLine,
    now: float,
    time_step: float,
    friction: float,
    restitution: float,
    row: Array,
    bodies: Bodies,
) -> float:
    """Apply the impact of bodies with contacts: along the normal and along the tangent, in turns.

    Friction beside the centre may press them together again: what it leaves is stopped, too.
    """
    impulse = apply_rows(line, now, time_step, friction, restitution, row, bodies)
    more, turns = impulse, MOST_TURNS if friction > 0.0 else 0
    while turns > 0 and more > SETTLED_IMPULSE * impulse:
        more = apply_rows(line, now, time_step, friction, 0.0, row, bodies)
        impulse += max(more, 0.0)
        turns -= 1
    return impulse


def apply_rows(
    line: ImpulseLine,
    now: float,
    time_step: float,
    friction: float,
    restitution: float,
    row: Array,
    bodies: Bodies,
) -> float:
    """Apply one impulse along the normal and one along the tangent; return the first, likewise.

    The second is added to the row of a listed point.
    """
    i, j = line.a, line.b
    impulse = stop_and_rebound(line, now, time_step, restitution, bodies)
    if impulse < 0.0:
        return impulse
    impulse = hold_together(impulse, line, now, time_step, bodies)
    if friction > 0.0:
        along = (-line.direction[1], line.direction[0])
        tangent = ImpulseLine(i, j, line.at_a, line.at_b, along)
        speed = slip_along(tangent, 0.0, row, bodies)
        mass = mass_along(tangent, bodies.properties)
        friction_impulse = limited_tangent_impulse(0.0, speed, mass, friction, impulse)
        change_velocities_and_paths(tangent, now, time_step, friction_impulse, bodies)
        row[tb.M_DRAG] += friction_impulse
    return impulse


def stop_and_rebound(
    line: ImpulseLine, now: float, time_step: float, restitution: float, bodies: Bodies
) -> float:
    """Apply the normal impulse that stops two bodies and lets them rebound; return it, N s.

    A negative number says that neither their velocities nor their paths approach: these are stopped
    each for itself.
    """
    mass = mass_along(line, bodies.properties)
    before = speed_along(line, 0.0, bodies.motion, bodies.flight)
    rate = path_speed_along(line, time_step, bodies.motion)
    if before >= 0.0 and rate >= 0.0:
        return -1.0
    bounce = restitution_impulse(0.0, 0.0, min(max(before, rate), 0.0), restitution, mass)
    impulse = stopping_impulse(before, mass) + bounce
    change_velocities(line, impulse, bodies.motion, bodies.properties)
    change_paths(line, now, (stopping_impulse(rate, mass) + bounce) * time_step, bodies)
    return impulse


@inlined
def stopping_impulse(rate: float, mass: float) -> float:
    """Return the impulse that stops an approach at a rate, m/s, without a rebound, N s."""
    return restitution_impulse(0.0, rate, 0.0, 0.0, mass)


def hold_together(
    impulse: float, line: ImpulseLine, now: float, time_step: float, bodies: Bodies
) -> float:
    """Let bodies stay together that forces press together again in the rest of the step.

    Returns the normal impulse with what that takes, N s.
    """
    rate = path_speed_along(line, time_step, bodies.motion)
    if not rate < 0.0:
        return impulse
    mass = mass_along(line, bodies.properties)
    change_paths(line, now, stopping_impulse(rate, mass) * time_step, bodies)
    held = stopping_impulse(speed_along(line, 0.0, bodies.motion, bodies.flight), mass)
    change_velocities(line, held, bodies.motion, bodies.properties)
    return impulse + held


def place_on_path(i: int, now: float, at: Vector, bodies: Bodies) -> Vector:
    """Return where a point of a body is at a fraction of the step, m from its centre before, m."""
    pose, shift = bodies.pose[i], bodies.motion[i]
    x, y = position_later((pose[tb.X], pose[tb.Y]), (shift[tb.DX], shift[tb.DY]), now)
    return x + at[0], y + at[1]


def record_impact(
    impulse: float,
    drag: float,
    place: Vector,
    normal: Vector,
    in_parts: bool,
    recorded: Array,
    flags: Integers,
) -> None:
    """Add an impact to what is told of a contact in this step, at the place of the first one.

    The drag is what friction gave along the tangent, N s. Several impacts in flight are told as
    one, along the sum of their impulses.
    """
    first = forget_earlier(in_parts, recorded, flags)
    flags[tb.TOUCHES] |= tb.IS_TOUCHING
    if flags[tb.POINT_COUNT] == 0:
        flags[tb.TOUCHES] |= tb.MET_IN_FLIGHT
    elif not in_parts:
        recorded[tb.TOTAL_IMPULSE] += impulse
        recorded[tb.FRICTION_IMPULSE] += drag
        return
    recorded[tb.PART_PUSH_X] += impulse * normal[0]
    recorded[tb.PART_PUSH_Y] += impulse * normal[1]
    recorded[tb.PART_FRICTION_X] -= drag * normal[1]
    recorded[tb.PART_FRICTION_Y] += drag * normal[0]
    if first:
        recorded[tb.WORLD_POINT], recorded[tb.WORLD_POINT + 1] = place
        recorded[tb.IMPACT_NORMAL], recorded[tb.IMPACT_NORMAL + 1] = normal
