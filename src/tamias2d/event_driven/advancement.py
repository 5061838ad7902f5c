"""When two bodies of which one has corners meet: conservative advancement (IM12).

It is what `tamias2d.contact.conservative_advancement` does under constant loads, operation by
operation.
"""

from math import inf, pi

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.approach import MOST_STEPS, TINY_STEP, TINY_STEPS, UNDECIDED, root
from tamias2d.event_driven.axes import best_axis, find_axes, find_gaps
from tamias2d.event_driven.length import hypot
from tamias2d.event_driven.stand import resolution_of, round_off, stand, turn
from tamias2d.event_driven.tables import World
from tamias2d.generated import continuous_collision, impact, rotation
from tamias2d.kernels.assembled import inlined, separate

BEHIND = -0.5  # cosine between directions that separate a pair from either side
FAR = 1.1  # times the bounding radii
HERE = -2.0


@separate
def time_of_hull_impact(i: int, j: int, start: float, limit: float, world: World) -> float:
    """Return when two bodies touch and do not separate, s, as `time_of_meeting` does."""
    end, search = world.numbers[tb.END], world.hulls.search
    time, tiny_steps, tiny = start, 0, TINY_STEP * max(abs(end), end - start)
    search[tb.IS_SEEN] = search[tb.TOUCHES] = 0.0
    for _ in range(MOST_STEPS):
        if not time < end or time > limit:
            return inf
        step = safe_step(i, j, time, end, world)
        if step == UNDECIDED:
            return UNDECIDED
        if step == HERE or time + step == time:
            return time
        tiny_steps += 1 if search[tb.TOUCHES] > 0.0 or step < tiny else 0
        if tiny_steps > TINY_STEPS:
            return UNDECIDED
        time += step
    return UNDECIDED


@inlined
def safe_step(i: int, j: int, time: float, end: float, world: World) -> float:
    """Return how long no contact can come about, s, `HERE` if one is there, or `UNDECIDED`."""
    a, b = tb.FIRST_STAND, tb.SECOND_STAND
    stand(a, i, time, world)
    stand(b, j, time, world)
    far, step = step_of_circles(world)
    if far:
        return step
    turn(a, world)
    turn(b, world)
    step = max(step, spinning_step(time, end, world))
    tolerance, search = resolution_of(a, b, time, world), world.hulls.search
    count = find_axes(a, b, world)
    best = best_axis(count, world)
    search[tb.TOUCHES] = 1.0 if world.hulls.axes[best, tb.AXIS_GAP] <= tolerance else 0.0
    if search[tb.TOUCHES] > 0.0:
        best = best_on_side(best, count, tolerance, world)
        if best < 0 or (world.counts[tb.AT_START] == 1 and time == 0.0):
            return UNDECIDED
    else:
        sign = sign_of(best, world)
        search[tb.IS_SEEN] = 1.0
        search[tb.SEEN_X] = sign * world.hulls.axes[best, tb.AXIS_X]
        search[tb.SEEN_Y] = sign * world.hulls.axes[best, tb.AXIS_Y]
    largest = world.hulls.axes[best, tb.AXIS_GAP]
    longest = HERE
    for axis in range(count):
        if world.hulls.axes[axis, tb.AXIS_GAP] >= largest - tolerance:
            longest = max(longest, step_along(axis, a, b, time, end, world))
    return HERE if longest == HERE else max(longest, step)


def sign_of(axis: int, world: World) -> float:
    """Return -1 for an axis that goes from the second body to the first."""
    return -1.0 if world.hulls.owners[axis, tb.SWAPPED] == 1 else 1.0


def best_on_side(best: int, count: int, tolerance: float, world: World) -> int:
    """Return the best of the axes of a pair that touches which do not point against where it was.

    The others are dropped. It is below 0 where that is not decided.
    """
    search, axes = world.hulls.search, world.hulls.axes
    x, y, least = search[tb.SEEN_X], search[tb.SEEN_Y], -inf
    if search[tb.IS_SEEN] == 0.0:
        sign, least = sign_of(best, world), axes[best, tb.AXIS_GAP] - tolerance
        x, y = sign * axes[best, tb.AXIS_X], sign * axes[best, tb.AXIS_Y]
    for axis in range(count):
        sign = sign_of(axis, world)
        along = x * (sign * axes[axis, tb.AXIS_X]) + y * (sign * axes[axis, tb.AXIS_Y])
        if along <= BEHIND and axes[axis, tb.AXIS_GAP] >= least:
            if search[tb.IS_SEEN] == 0.0:
                return -1
            axes[axis, tb.AXIS_GAP] = -inf
    best = best_axis(count, world)
    return best if axes[best, tb.AXIS_GAP] > -inf else -1


@inlined
def step_of_circles(world: World) -> tuple[bool, float]:
    """Return whether circles around the bodies are well apart, and how long they stay so, s."""
    a, b = world.hulls.stands[tb.FIRST_STAND], world.hulls.stands[tb.SECOND_STAND]
    radius, search = a[tb.BOUND] + b[tb.BOUND], world.hulls.search
    search[tb.DISTANCE] = 0.0
    if radius == inf:
        return False, 0.0
    x, y = b[tb.X] - a[tb.X], b[tb.Y] - a[tb.Y]
    distance = hypot(x, y)
    search[tb.DISTANCE] = distance
    if distance <= radius:
        return False, 0.0
    ux, uy = x / distance, y / distance
    rate = impact.normal_velocity(
        (a[tb.VX], a[tb.VY]), 0.0, (0.0, 0.0), (b[tb.VX], b[tb.VY]), 0.0, (0.0, 0.0), (ux, uy)
    )
    least = continuous_collision.centre_acceleration_least(
        (a[tb.AX], a[tb.AY]), (b[tb.AX], b[tb.AY]), (ux, uy), 0.0
    )
    return distance > FAR * radius, root(distance - radius, rate, least)


@inlined
def spinning_step(time: float, end: float, world: World) -> float:
    """Return how long the circle around a body that turns often stays off the sides of another."""
    first = turns_often(tb.FIRST_STAND, time, end, world)
    second = turns_often(tb.SECOND_STAND, time, end, world)
    if first == second:
        return 0.0
    turning, other = (
        (tb.FIRST_STAND, tb.SECOND_STAND) if first else (tb.SECOND_STAND, tb.FIRST_STAND)
    )
    if world.hulls.forms[other, tb.SIDES] == 0:
        return 0.0
    round_off(turning, world)
    a, b = (tb.ROUND_STAND, other) if first else (other, tb.ROUND_STAND)
    axis = best_axis(find_axes(a, b, world), world)
    if world.hulls.axes[axis, tb.AXIS_GAP] <= 0.0:
        return 0.0
    return max(step_along(axis, a, b, time, end, world), 0.0)


def turns_often(place: int, time: float, end: float, world: World) -> bool:
    """Return whether a body at hand with corners turns more than once until the end."""
    spin = abs(world.hulls.stands[place, tb.SPIN])
    return bool(world.hulls.forms[place, tb.CORNERS] > 1 and spin * (end - time) > 2.0 * pi)


def step_along(axis: int, a: int, b: int, time: float, end: float, world: World) -> float:
    """Return the safe step along one axis, s, or `HERE` if there is a contact."""
    count = find_gaps(axis, a, b, world)
    for k in range(count):
        if world.hulls.gaps[k, tb.GAP] <= 0.0 and world.hulls.gaps[k, tb.RATE] <= 0.0:
            return HERE
    p, q = (b, a) if world.hulls.owners[axis, tb.SWAPPED] == 1 else (a, b)
    one, other = world.hulls.stands[p], world.hulls.stands[q]
    turning = world.hulls.owners[axis, tb.SIDE] >= 0 and (
        one[tb.SPIN] != 0.0 or one[tb.TURNING] != 0.0
    )
    speed = acceleration = 0.0
    if turning:
        speed = hypot(other[tb.VX] - one[tb.VX], other[tb.VY] - one[tb.VY])
        acceleration = hypot(other[tb.AX] - one[tb.AX], other[tb.AY] - one[tb.AY])
    longest = smallest_root(axis, p, q, count, 0.0, time, speed, acceleration, turning, world)
    steady = not turning and one[tb.TURNING] == 0.0 and other[tb.TURNING] == 0.0
    if steady:  # the same whatever the window
        return longest
    window = min(longest, end - time)
    return min(
        longest,
        smallest_root(axis, p, q, count, window, time, speed, acceleration, turning, world),
    )


def smallest_root(
    axis: int,
    p: int,
    q: int,
    count: int,
    window: float,
    time: float,
    speed: float,
    acceleration: float,
    turning: bool,
    world: World,
) -> float:
    """Return the first time until which a gap may close, s, by bounds that hold for a window.

    The speed and the acceleration are those of the bodies relative to each other now.
    """
    one, other = world.hulls.stands[p], world.hulls.stands[q]
    spin_p, spin_q = spin_bound(p, time + window, world), spin_bound(q, time + window, world)
    by_p, by_q = abs(one[tb.TURNING]), abs(other[tb.TURNING])
    of_p = continuous_collision.circling(spin_p, by_p)
    of_q = continuous_collision.circling(spin_q, by_q)
    u = (world.hulls.axes[axis, tb.AXIS_X], world.hulls.axes[axis, tb.AXIS_Y])
    centres = continuous_collision.centre_acceleration_least(
        (one[tb.AX], one[tb.AY]), (other[tb.AX], other[tb.AY]), u, 0.0
    )
    if turning:
        most = speed + acceleration * window
        distance = world.hulls.search[tb.DISTANCE] + most * window
        centres = continuous_collision.centre_acceleration_turning(
            of_p, distance, spin_p, most, centres, spin_p * window, acceleration
        )
        spin = abs(other[tb.SPIN] - one[tb.SPIN]) + (by_p + by_q) * window
        of_q = continuous_collision.circling(spin, by_p + by_q)
    found = inf
    for k in range(count):
        row = world.hulls.gaps[k]
        least = continuous_collision.gap_acceleration_least(
            centres, row[tb.REACH_P], of_p, row[tb.REACH_Q], of_q
        )
        found = min(found, root(row[tb.GAP], row[tb.RATE], least))
    return found


def spin_bound(place: int, until: float, world: World) -> float:
    """Return the largest angular velocity of a body at hand until a time, rad/s."""
    body = world.hulls.stands[place]
    late = rotation.angular_velocity(body[tb.START_SPIN], body[tb.TURNING], until - body[tb.START])
    return float(max(abs(body[tb.SPIN]), abs(late)))
