"""When two bodies meet: conservative advancement along the axis between them (IM12).

It is what `tamias2d.contact` does for discs and half-planes under constant loads, operation by
operation. A search begins where the later of the two paths does, so that the bits of a meeting
depend on these paths, and not on when it is looked for.
"""

from math import inf

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.length import hypot
from tamias2d.event_driven.tables import Moving, Pair, World
from tamias2d.generated import impact, rotation, translation
from tamias2d.generated.continuous_collision import (
    advance_closing,
    advance_opening,
    centre_acceleration_least,
    discriminant,
)
from tamias2d.kernels.arrays import Indices
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

EPSILON = 2.0**-52
MOST_STEPS = 2000
TINY_STEP = 2.0**-48
TINY_STEPS = 1000
MARGIN = 1e-6  # of the size: discs that pass at more than that do not touch, whatever the rounding
UNDECIDED = -1.0


@inlined
def time_of_impact(i: int, j: int, start: float, limit: float, world: World) -> float:
    """Return when two bodies touch and do not separate, s; likewise."""
    end = world.numbers[tb.END]
    time, tiny_steps, tiny = start, 0, TINY_STEP * max(abs(end), end - start)
    seen_x, seen_y = 0.0, 0.0
    for _ in range(MOST_STEPS):
        if not time < end or time > limit:
            return inf
        a, b = state_at(i, time, world.paths), state_at(j, time, world.paths)
        tolerance = resolution(a, b, size_of(i, world), size_of(j, world), time)
        ux, uy, gap, swapped = axis_of(a, b, i, j, world)
        if world.counts[tb.AT_START] == 1 and time == 0.0 and gap <= tolerance:
            return UNDECIDED
        touching = gap <= tolerance
        if touching and turned_round(ux, uy, seen_x, seen_y, i, j, world.kinds):
            return UNDECIDED
        seen_x, seen_y = ux, uy
        value, rate = gap_of(a, b, ux, uy, swapped, i, j, world)
        if value <= 0.0 and rate <= 0.0:
            return time
        p, q = (j, i) if swapped == 1 else (i, j)
        on_p = (world.paths[p, tb.AX], world.paths[p, tb.AY])
        on_q = (world.paths[q, tb.AX], world.paths[q, tb.AY])
        step = max(root(value, rate, centre_acceleration_least(on_p, on_q, (ux, uy), 0.0)), 0.0)
        if time + step == time:
            return time
        tiny_steps += 1 if touching or step < tiny else 0
        if tiny_steps > TINY_STEPS:
            return UNDECIDED
        time += step
    return UNDECIDED


@inlined
def turned_round(
    ux: float, uy: float, seen_x: float, seen_y: float, i: int, j: int, kinds: Indices
) -> bool:
    """Return whether two discs seem to have passed through each other since they were seen."""
    discs = kinds[i] != tb.PLANE and kinds[j] != tb.PLANE
    return bool(discs and ux * seen_x + uy * seen_y < 0.0)


def root(value: float, rate: float, least: float) -> float:
    """Return the first time until which a gap may close, s, or infinity (DD46)."""
    inside = discriminant(value, rate, least)
    if inside < 0.0:
        if value > 0.0:
            return inf
        inside = discriminant(0.0, rate, least)
    if rate > 0.0:
        return float(advance_opening(rate, least, inside)) if least < 0.0 else inf
    if inside == 0.0 and rate == 0.0:
        return inf
    return float(advance_closing(value, rate, inside))


def position_at(k: int, time: float, paths: Array) -> Pair:
    """Return where a body is at a time, s."""
    path = paths[k]
    place, going, by = (
        (path[tb.X], path[tb.Y]),
        (path[tb.VX], path[tb.VY]),
        (path[tb.AX], path[tb.AY]),
    )
    x, y = translation.position(place, going, by, time - path[tb.START])
    return x, y


def state_at(k: int, time: float, paths: Array) -> Moving:
    """Return x, y, orientation, velocity and angular velocity of a body at a time, s."""
    path = paths[k]
    elapsed = time - path[tb.START]
    x, y = position_at(k, time, paths)
    going, by = (path[tb.VX], path[tb.VY]), (path[tb.AX], path[tb.AY])
    u, v = translation.velocity(going, by, elapsed)
    turn = rotation.orientation(path[tb.TURN], path[tb.SPIN], path[tb.TURNING], elapsed)
    spin = rotation.angular_velocity(path[tb.SPIN], path[tb.TURNING], elapsed)
    return x, y, turn, u, v, spin


@inlined
def size_of(k: int, world: World) -> float:
    """Return how far off its centre the numbers of a body lie, m."""
    plane = world.kinds[k] == tb.PLANE
    return float(abs(world.bodies[k, tb.OFFSET]) if plane else world.bodies[k, tb.RADIUS])


def resolution(a: Moving, b: Moving, size_a: float, size_b: float, time: float) -> float:
    """Return the gap in m that float64 cannot tell from 0."""
    length = abs(a[0]) + abs(a[1]) + abs(b[0]) + abs(b[1]) + size_a + size_b
    speed = abs(b[3] - a[3]) + abs(b[4] - a[4])
    return EPSILON * (16 * length + 4 * speed * time)


@inlined
def axis_of(a: Moving, b: Moving, i: int, j: int, world: World) -> tuple[float, float, float, int]:
    """Return the axis from P to Q, the gap along it, m, and whether P is the second body."""
    body_a, body_b = world.bodies[i], world.bodies[j]
    if world.kinds[i] == tb.PLANE:
        ux, uy, gap = axis_of_plane(body_a, b[0] - a[0], b[1] - a[1], body_b[tb.RADIUS])
        return ux, uy, gap, 0
    if world.kinds[j] == tb.PLANE:
        ux, uy, gap = axis_of_plane(body_b, a[0] - b[0], a[1] - b[1], body_a[tb.RADIUS])
        return ux, uy, gap, 1
    x, y = b[0] - a[0], b[1] - a[1]
    distance = hypot(x, y)
    base = body_a[tb.RADIUS] + body_b[tb.RADIUS]
    if distance == 0.0:
        return 1.0, 0.0, distance - base, 0
    return x / distance, y / distance, distance - base, 0


def axis_of_plane(plane: Array, dx: float, dy: float, radius: float) -> tuple[float, float, float]:
    """Return the normal of a half-plane, and the gap to a disc before it, m."""
    ux = 1.0 * plane[tb.NORMAL_X] - 0.0 * plane[tb.NORMAL_Y]
    uy = 0.0 * plane[tb.NORMAL_X] + 1.0 * plane[tb.NORMAL_Y]
    nearest = ux * 0.0 + uy * 0.0
    return ux, uy, ux * dx + uy * dy + nearest - plane[tb.OFFSET] - radius


@inlined
def gap_of(
    a: Moving, b: Moving, ux: float, uy: float, swapped: int, i: int, j: int, world: World
) -> Pair:
    """Return the gap along an axis, m, and its rate, m/s."""
    p, q = (b, a) if swapped == 1 else (a, b)
    x, y = q[0] - p[0] + 0.0, q[1] - p[1] + 0.0
    body_a, body_b = world.bodies[i], world.bodies[j]
    if world.kinds[i] == tb.PLANE or world.kinds[j] == tb.PLANE:
        owner, disc = (body_b, body_a) if swapped == 1 else (body_a, body_b)
        base, arm = owner[tb.OFFSET] + disc[tb.RADIUS], (x, y)
    else:
        base, arm = body_a[tb.RADIUS] + body_b[tb.RADIUS], (0.0, 0.0)
    rate = impact.normal_velocity((p[3], p[4]), p[5], arm, (q[3], q[4]), q[5], (0.0, 0.0), (ux, uy))
    return ux * x + uy * y - base, rate
