"""Paths of hard discs through a step, and when they meet on them.

A disc under gravity alone is on a parabola (IM1), and the gap of a pair is one in time, whose first
root is when they meet (DD46, DD80). Of each pair it is noted for how many steps it stays apart.
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.conservative_advancement import NEAR
from tamias2d.engine.tables import Bodies, Contacts, Control, Events, Shapes
from tamias2d.generated import rotation, translation
from tamias2d.generated.continuous_collision import (
    advance_closing,
    advance_opening,
    discriminant,
    reach_gap,
    reach_gap_acceleration,
    reach_gap_rate,
)
from tamias2d.generated.definitions import (
    coordinate_displacement,
    coordinate_velocity_gain,
    coordinate_velocity_later,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Vector

SPARE = 2.0**-6  # of a step, by which pairs are looked at before they may meet
FARTHEST = 2.0**16  # radii from the origin; there rounding is next to nothing beside `NEAR`


# -- the paths of a step


@inlined
def steps_near(most: int, control: Control, bodies: Bodies) -> int:
    """Return for how many steps no body gets so far that rounding counts: `most`, 1, or none."""
    near, next_near = True, True
    for i in range(len(bodies.kind)):
        if bodies.kind[i] == tb.DYNAMIC:
            near = near and stays_near(i, most, control, bodies)
            next_near = next_near and stays_near(i, 1, control, bodies)
    return most if near else 1 if next_near else 0


@inlined
def stays_near(i: int, steps: int, control: Control, bodies: Bodies) -> bool:
    """Return whether a body is within its range of the origin in some steps to come."""
    settings, motion = control.settings, bodies.motion[i]
    time = steps * settings[tb.TIME_STEP]
    pull = abs(settings[tb.GRAVITY_X]) + abs(settings[tb.GRAVITY_Y])
    way = time * (abs(motion[tb.VX]) + abs(motion[tb.VY]) + time * pull)
    far = abs(bodies.pose[i, tb.X]) + abs(bodies.pose[i, tb.Y]) + way
    return bool(far <= FARTHEST * bodies.properties[i, tb.BOUNDING_RADIUS])


@inlined
def begin_paths(bodies: Bodies) -> None:
    """Let the paths of all bodies begin with the step."""
    for i in range(len(bodies.kind)):
        bodies.flight[i, tb.REDIRECTED] = bodies.flight[i, tb.PATH_START] = 0.0


@inlined
def fly_on(steps: int, control: Control, bodies: Bodies) -> None:
    """Let all bodies that met nothing go on for some steps."""
    for i in range(len(bodies.kind)):
        if bodies.flight[i, tb.REDIRECTED] != 0.0:
            bodies.flight[i, tb.REDIRECTED] = 0.0
        elif bodies.kind[i] == tb.DYNAMIC:
            fly_alone(i, steps, control, bodies)


@inlined
def fly_alone(i: int, steps: int, control: Control, bodies: Bodies) -> None:
    """Take a body through some steps, one after the other (IM1, IM6)."""
    pose, motion = bodies.pose[i], bodies.motion[i]
    propagator = bodies.propagators[int(bodies.properties[i, tb.PROPAGATOR])]
    gain, lift = propagator[tb.WHOLE_STEP + tb.GAIN], propagator[tb.WHOLE_STEP + tb.LIFT]
    by_x, by_y = pull_on(i, control, bodies)
    gain_x, gain_y = coordinate_velocity_gain(gain, by_x), coordinate_velocity_gain(gain, by_y)
    x, y, angle = pose[tb.X], pose[tb.Y], pose[tb.ANGLE]
    u, v, spin = motion[tb.VX], motion[tb.VY], motion[tb.SPIN]
    for _ in range(steps):
        x += coordinate_displacement(gain, lift, u, by_x)
        y += coordinate_displacement(gain, lift, v, by_y)
        angle += coordinate_displacement(gain, lift, spin, 0.0)
        u = coordinate_velocity_later(1.0, u, gain_x)
        v = coordinate_velocity_later(1.0, v, gain_y)
    pose[tb.X], pose[tb.Y], pose[tb.ANGLE] = x, y, angle
    motion[tb.VX], motion[tb.VY] = u, v


@inlined
def advance_to(i: int, now: float, control: Control, bodies: Bodies) -> None:
    """Let the path of a body begin where it is at a time in the step, s."""
    elapsed = now - bodies.flight[i, tb.PATH_START]
    if bodies.kind[i] != tb.DYNAMIC or elapsed == 0.0:
        return
    pose, motion = bodies.pose[i], bodies.motion[i]
    going, by = (motion[tb.VX], motion[tb.VY]), pull_on(i, control, bodies)
    pose[tb.X], pose[tb.Y] = translation.position((pose[tb.X], pose[tb.Y]), going, by, elapsed)
    motion[tb.VX], motion[tb.VY] = translation.velocity(going, by, elapsed)
    pose[tb.ANGLE] = rotation.orientation(pose[tb.ANGLE], motion[tb.SPIN], 0.0, elapsed)
    bodies.flight[i, tb.PATH_START] = now


@inlined
def pull_on(i: int, control: Control, bodies: Bodies) -> Vector:
    """Return the acceleration of a body, m/s^2."""
    if bodies.kind[i] != tb.DYNAMIC:
        return 0.0, 0.0
    return control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y]


@inlined
def place_at(i: int, now: float, control: Control, bodies: Bodies) -> tuple[Vector, Vector]:
    """Return where a body is at a time in the step, s, and how fast."""
    pose, motion = bodies.pose[i], bodies.motion[i]
    elapsed = now - bodies.flight[i, tb.PATH_START]
    if elapsed == 0.0:
        return (pose[tb.X], pose[tb.Y]), (motion[tb.VX], motion[tb.VY])
    going, by = (motion[tb.VX], motion[tb.VY]), pull_on(i, control, bodies)
    at = translation.position((pose[tb.X], pose[tb.Y]), going, by, elapsed)
    return at, translation.velocity(going, by, elapsed)


# -- when pairs meet


@inlined
def disc_and_other(p: int, shapes: Shapes, contacts: Contacts) -> tuple[int, int]:
    """Return the shapes of a pair, a disc first."""
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    return (t, s) if shapes.kind[s] == tb.HALF_PLANE else (s, t)


@inlined
def closing_of(
    s: int,
    t: int,
    at: Vector,
    going: Vector,
    now: float,
    wider: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
) -> tuple[float, float, float]:
    """Return the gap between a disc and a shape at a time, s, its rate and its second derivative.

    The last is constant. Shapes are taken wider, by a share of the smaller one. The gap of two
    discs is that of DD80.
    """
    j, radius = shapes.slot[t], shapes.material[s, tb.SHAPE_RADIUS]
    if shapes.kind[t] == tb.HALF_PLANE:
        side, by = shapes.world_vertices[shapes.first[t]], pull_on(shapes.slot[s], control, bodies)
        x, y = at[0] - bodies.pose[j, tb.X], at[1] - bodies.pose[j, tb.Y]
        gap = side[2] * x + side[3] * y - side[0] - (1.0 + wider) * radius
        return gap, side[2] * going[0] + side[3] * going[1], side[2] * by[0] + side[3] * by[1]
    other, its = place_at(j, now, control, bodies)
    span, rate = (other[0] - at[0], other[1] - at[1]), (its[0] - going[0], its[1] - going[1])
    far = shapes.material[t, tb.SHAPE_RADIUS]
    reach = radius + far + wider * min(radius, far)
    return reach_gap(span, reach), reach_gap_rate(span, rate), reach_gap_acceleration(rate)


@inlined
def time_of_meeting(gap: float, rate: float, acceleration: float) -> float:
    """Return after which time a gap closes that is a parabola in time, s; infinite for never."""
    if gap <= 0.0 and rate <= 0.0:
        return 0.0
    inside = discriminant(gap, rate, acceleration)
    if rate > 0.0:
        if acceleration >= 0.0:
            return inf
        return advance_opening(rate, acceleration, max(inside, 0.0))
    if inside < 0.0 or (rate == 0.0 and inside == 0.0):
        return inf
    return advance_closing(gap, rate, inside)


@inlined
def foretell(
    p: int, taken: int, control: Control, bodies: Bodies, shapes: Shapes, contacts: Contacts,
    events: Events,
) -> None:  # fmt: skip
    """Note after how many steps of this call a pair may meet, as a step begins."""
    s, t = disc_and_other(p, shapes, contacts)
    at, going = place_at(shapes.slot[s], 0.0, control, bodies)
    gap, rate, acceleration = closing_of(s, t, at, going, 0.0, NEAR, control, bodies, shapes)
    note_due(p, taken, 0.0, gap, rate, acceleration, control, events)


@inlined
def note_due(
    p: int, taken: int, now: float, gap: float, rate: float, acceleration: float, control: Control,
    events: Events,
) -> None:  # fmt: skip
    """Note after how many steps of this call a gap may close, as seen at a time in one, s."""
    later = time_of_meeting(gap, rate, acceleration) if gap > 0.0 else 0.0
    events.due[p] = taken + (now + later) / control.settings[tb.TIME_STEP] - SPARE


@inlined
def note_meeting(
    p: int, now: float, control: Control, bodies: Bodies, shapes: Shapes, contacts: Contacts,
    events: Events,
) -> bool:  # fmt: skip
    """Note when a pair meets in this step, s; return whether it does not overlap now."""
    s, t = disc_and_other(p, shapes, contacts)
    at, going = place_at(shapes.slot[s], now, control, bodies)
    gap, rate, acceleration = closing_of(s, t, at, going, now, 0.0, control, bodies, shapes)
    events.times[p] = now + time_of_meeting(gap, rate, acceleration)
    if gap > 0.0:
        return True
    core, _, _ = closing_of(s, t, at, going, now, -NEAR, control, bodies, shapes)
    return core > 0.0


@inlined
def soonest_of(listed: int, events: Events) -> float:
    """Return after how many steps of this call the first pair may meet."""
    soonest = inf
    for p in range(listed):
        soonest = min(soonest, events.due[p])
    return soonest


@inlined
def list_due(until: int, listed: int, events: Events) -> int:
    """List the pairs that may meet before some step; return how many do."""
    near = 0
    for p in range(listed):
        if events.due[p] < until:
            events.queue[tb.WAITING, near] = p
            near += 1
    return near
