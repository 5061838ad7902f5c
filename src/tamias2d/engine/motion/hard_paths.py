"""Paths of hard discs through a step, and the gaps between them.

A disc under gravity alone is on a parabola (IM1), and so is one that slides or rolls on a
half-plane (DD85). The gap of a pair is one in time, too, if both accelerate alike (DD80).
"""

from math import sqrt

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Contacts, Control, Shapes
from tamias2d.generated import impact, rotation, translation
from tamias2d.generated.continuous_collision import (
    centre_acceleration_least,
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
from tamias2d.state import Array, Vector

FARTHEST = 2.0**16  # radii from the origin; there rounding is next to nothing beside `NEAR`


# -- the paths of a step


@inlined
def steps_near(most: int, control: Control, bodies: Bodies) -> int:
    """Return for how many steps no body gets so far that rounding counts: `most`, 1, or none."""
    if all_near(most, control, bodies):
        return most
    return 1 if all_near(1, control, bodies) else 0


@inlined
def all_near(steps: int, control: Control, bodies: Bodies) -> bool:
    """Return whether all bodies are within their range of the origin in some steps to come."""
    near = True
    for i in range(len(bodies.kind)):
        if bodies.kind[i] == tb.DYNAMIC:
            near = near and stays_near(i, steps, control, bodies)
    return near


@inlined
def stays_near(i: int, steps: int, control: Control, bodies: Bodies) -> bool:
    """Return whether a body is within its range of the origin in some steps to come."""
    settings, motion = control.settings, bodies.motion[i]
    time = steps * settings[tb.TIME_STEP]
    pull = abs(settings[tb.GRAVITY_X]) + abs(settings[tb.GRAVITY_Y])
    radius = bodies.properties[i, tb.BOUNDING_RADIUS]
    speed = abs(motion[tb.VX]) + abs(motion[tb.VY]) + radius * abs(motion[tb.SPIN])
    far = abs(bodies.pose[i, tb.X]) + abs(bodies.pose[i, tb.Y]) + time * (speed + time * pull)
    return bool(far <= FARTHEST * radius)


@inlined
def begin_paths(control: Control, bodies: Bodies) -> None:
    """Let the paths of all bodies begin with the step, in flight."""
    for i in range(len(bodies.kind)):
        flight, path = bodies.flight[i], bodies.path[i]
        flight[tb.REDIRECTED] = flight[tb.PATH_START] = flight[tb.RESTED_ON] = 0.0
        for n in range(len(path)):
            path[n] = 0.0
        if bodies.kind[i] == tb.DYNAMIC:
            path[tb.PATH_BY] = control.settings[tb.GRAVITY_X]
            path[tb.PATH_BY + 1] = control.settings[tb.GRAVITY_Y]


@inlined
def fly_on(steps: int, bodies: Bodies) -> None:
    """Let all bodies that met nothing go on for some steps."""
    for i in range(len(bodies.kind)):
        if bodies.flight[i, tb.REDIRECTED] != 0.0:
            bodies.flight[i, tb.REDIRECTED] = 0.0
        elif bodies.kind[i] == tb.DYNAMIC and bodies.path[i, tb.RESTS_ON] == 0.0:
            fly_alone(i, steps, bodies)
        elif bodies.kind[i] == tb.DYNAMIC:
            fly_alone(i, steps - 1, bodies)
            note_path(i, bodies)
            fly_alone(i, 1, bodies)


@inlined
def note_path(i: int, bodies: Bodies) -> None:
    """Note where a body is as a step begins, and how it moves."""
    for n in range(3):
        bodies.start[i, n], bodies.start[i, 3 + n] = bodies.pose[i, n], bodies.motion[i, n]


@inlined
def fly_alone(i: int, steps: int, bodies: Bodies) -> None:
    """Take a body through some steps, one after the other (IM1, IM6)."""
    pose, motion = bodies.pose[i], bodies.motion[i]
    propagator = bodies.propagators[int(bodies.properties[i, tb.PROPAGATOR])]
    gain, lift = propagator[tb.WHOLE_STEP + tb.GAIN], propagator[tb.WHOLE_STEP + tb.LIFT]
    (by_x, by_y), turning = pull_on(i, bodies), bodies.path[i, tb.PATH_BY + 2]
    gain_x, gain_y = coordinate_velocity_gain(gain, by_x), coordinate_velocity_gain(gain, by_y)
    gain_turn = coordinate_velocity_gain(gain, turning)
    x, y, angle = pose[tb.X], pose[tb.Y], pose[tb.ANGLE]
    u, v, spin = motion[tb.VX], motion[tb.VY], motion[tb.SPIN]
    for _ in range(steps):
        x += coordinate_displacement(gain, lift, u, by_x)
        y += coordinate_displacement(gain, lift, v, by_y)
        angle += coordinate_displacement(gain, lift, spin, turning)
        u = coordinate_velocity_later(1.0, u, gain_x)
        v = coordinate_velocity_later(1.0, v, gain_y)
        spin = coordinate_velocity_later(1.0, spin, gain_turn)
    pose[tb.X], pose[tb.Y], pose[tb.ANGLE] = x, y, angle
    motion[tb.VX], motion[tb.VY], motion[tb.SPIN] = u, v, spin


@inlined
def advance_to(i: int, now: float, bodies: Bodies) -> None:
    """Let the path of a body begin where it is at a time in the step, s."""
    elapsed = now - bodies.flight[i, tb.PATH_START]
    if bodies.kind[i] != tb.DYNAMIC or elapsed == 0.0:
        return
    pose, motion = bodies.pose[i], bodies.motion[i]
    going, by, turning = (
        (motion[tb.VX], motion[tb.VY]),
        pull_on(i, bodies),
        bodies.path[i, tb.PATH_BY + 2],
    )
    pose[tb.X], pose[tb.Y] = translation.position((pose[tb.X], pose[tb.Y]), going, by, elapsed)
    motion[tb.VX], motion[tb.VY] = translation.velocity(going, by, elapsed)
    pose[tb.ANGLE] = rotation.orientation(pose[tb.ANGLE], motion[tb.SPIN], turning, elapsed)
    motion[tb.SPIN] = rotation.angular_velocity(motion[tb.SPIN], turning, elapsed)
    bodies.flight[i, tb.PATH_START] = now


@inlined
def pull_on(i: int, bodies: Bodies) -> Vector:
    """Return the acceleration of a body on its path, m/s^2."""
    return bodies.path[i, tb.PATH_BY], bodies.path[i, tb.PATH_BY + 1]


@inlined
def place_at(i: int, now: float, bodies: Bodies) -> tuple[Vector, Vector]:
    """Return where a body is at a time in the step, s, and how fast."""
    pose, motion = bodies.pose[i], bodies.motion[i]
    elapsed = now - bodies.flight[i, tb.PATH_START]
    if elapsed == 0.0:
        return (pose[tb.X], pose[tb.Y]), (motion[tb.VX], motion[tb.VY])
    going, by = (motion[tb.VX], motion[tb.VY]), pull_on(i, bodies)
    at = translation.position((pose[tb.X], pose[tb.Y]), going, by, elapsed)
    return at, translation.velocity(going, by, elapsed)


# -- the gaps between paths


@inlined
def disc_and_other(p: int, shapes: Shapes, contacts: Contacts) -> tuple[int, int]:
    """Return the shapes of a pair, a disc first."""
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    return (t, s) if shapes.kind[s] == tb.HALF_PLANE else (s, t)


@inlined
def closing_of(
    s: int, t: int, at: Vector, going: Vector, now: float, wider: float, bodies: Bodies,
    shapes: Shapes,
) -> tuple[float, float, float]:  # fmt: skip
    """Return the gap between a disc and a shape at a time, s, its rate and its second derivative.

    Shapes are taken wider, by a share of the smaller one. The gap of two discs is that of DD80, or,
    if they accelerate unlike, that along the line of centres, below which theirs does not fall.
    """
    i, j, reach = shapes.slot[s], shapes.slot[t], reach_of(s, t, wider, shapes)
    if shapes.kind[t] == tb.HALF_PLANE:
        side = shapes.world_vertices[shapes.first[t]]
        return closing_on_plane(i, j, side, reach, at, going, bodies)
    return closing_of_discs(i, j, reach, at, going, now, bodies)


@inlined
def reach_of(s: int, t: int, wider: float, shapes: Shapes) -> float:
    """Return how far from a shape the centre of a disc is as they touch, m; see `closing_of`."""
    radius, far = shapes.material[s, tb.SHAPE_RADIUS], shapes.material[t, tb.SHAPE_RADIUS]
    if shapes.kind[t] == tb.HALF_PLANE:
        return (1.0 + wider) * radius
    return radius + far + wider * min(radius, far)


@inlined
def closing_on_plane(
    i: int, j: int, side: Array, reach: float, at: Vector, going: Vector, bodies: Bodies
) -> tuple[float, float, float]:
    """Return what `closing_of` does of a disc and a side of a half-plane."""
    by = pull_on(i, bodies)
    x, y = at[0] - bodies.pose[j, tb.X], at[1] - bodies.pose[j, tb.Y]
    gap = side[2] * x + side[3] * y - side[0] - reach
    return gap, side[2] * going[0] + side[3] * going[1], side[2] * by[0] + side[3] * by[1]


@inlined
def closing_of_discs(
    i: int, j: int, reach: float, at: Vector, going: Vector, now: float, bodies: Bodies
) -> tuple[float, float, float]:
    """Return what `closing_of` does of two discs."""
    other, its = place_at(j, now, bodies)
    span, rate = (other[0] - at[0], other[1] - at[1]), (its[0] - going[0], its[1] - going[1])
    if alike(i, j, bodies):
        return reach_gap(span, reach), reach_gap_rate(span, rate), reach_gap_acceleration(rate)
    away = sqrt(span[0] * span[0] + span[1] * span[1])
    line, still = (span[0] / away, span[1] / away), (0.0, 0.0)
    opening = impact.normal_velocity(going, 0.0, still, its, 0.0, still, line)
    least = centre_acceleration_least(pull_on(i, bodies), pull_on(j, bodies), line, 0.0)
    return away - reach, opening, least


@inlined
def alike(i: int, j: int, bodies: Bodies) -> bool:
    """Return whether two bodies accelerate alike."""
    a, b = pull_on(i, bodies), pull_on(j, bodies)
    return bool(a[0] == b[0] and a[1] == b[1])
