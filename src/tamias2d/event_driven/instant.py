"""What happens where two bodies meet in one point and touch nothing else: IM3, IM9 with friction.

It is what `tamias2d.contact` does at such an instant, operation by operation. Whatever else
happens at an instant is left to others, but for a disc that rests on a half-plane where it need not
be told since when (`settling`, `cluster`).
"""

from tamias2d.contact.rest_time import better_estimate
from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.approach import EPSILON, state_at
from tamias2d.event_driven.cluster import resolve
from tamias2d.event_driven.departure import MOST_REPEATS, depart, pull_of
from tamias2d.event_driven.kinds import is_pushed
from tamias2d.event_driven.laws import restitution_of
from tamias2d.event_driven.opening import opening_acceleration, pressing
from tamias2d.event_driven.rebound import (
    MOST_IMPULSES,
    arms,
    normal_velocity,
    reach,
    rebound,
    speed_of,
)
from tamias2d.event_driven.settling import end_sliding, rests, stay
from tamias2d.event_driven.tables import Moving, Pair, World
from tamias2d.event_driven.touch import MOST_RESOLUTION, touch_of, touches_third
from tamias2d.generated import rest
from tamias2d.kernels.assembled import inlined
from tamias2d.work_limit import SAMPLE, WORK_LIMIT

MOST_COMING = WORK_LIMIT  # impacts; after ten thousand, three times as many end a run
CLEAR = 4.0  # times what rounding is at most: a bounce so fast is one, whatever the rounding is


@inlined
def meet(i: int, j: int, time: float, world: World) -> bool:
    """Set the paths of two bodies after they have met; return whether that is all that happens."""
    if rests(i, world) or rests(j, world) or touches_third(i, j, time, world):
        return world.counts[tb.SETTLES] > 0 and resolve(i, j, time, world)
    return collide(i, j, time, world)


@inlined
def stop_sliding(k: int, time: float, world: World) -> bool:
    """Let a disc go on that does not slide any more; return whether that is all that happens."""
    if touches_third(k, k, time, world):
        return resolve(k, k, time, world)
    world.changed[0], world.counts[tb.CHANGED] = k, 1
    return end_sliding(k, time, world)


@inlined
def collide(i: int, j: int, time: float, world: World) -> bool:
    """Set the paths of two bodies that have met and touch no other; return whether it is all."""
    restitution = restitution_of(i, j, world)
    if restitution < 0.0 or is_bound(i, time, world) or is_bound(j, time, world):
        return False
    a, b = state_at(i, time, world.paths), state_at(j, time, world.paths)
    point, swapped, sided, tolerance = touch_of(i, j, a, b, time, world)
    if tolerance < 0.0 or tolerance > MOST_RESOLUTION * min(reach(i, world), reach(j, world)):
        return False
    sign = -1.0 if swapped == 1 else 1.0
    normal = (sign * point[0], sign * point[1])
    arm_a, arm_b = arms(a, b, point, swapped, i, j, world)
    rate = restitution * normal_velocity(a, b, arm_a, arm_b, normal)
    gained = 64 * EPSILON * time * (pull_of(i, world) + pull_of(j, world))
    speed = most_speed_of(a, b, arm_a, arm_b)
    if rate >= -CLEAR * (64 * EPSILON) * speed or least_speed_of(a, b) <= gained:
        speed = speed_of(a, b, arm_a, arm_b)  # lengths take long, and seldom matter
        if speed <= gained:
            return False
    noise = speed * (64 * EPSILON)
    q, arm = (a, arm_a) if swapped == 1 else (b, arm_b)
    before = world.counts[tb.IMPACTS]
    after_a, after_b, rate = rebound(a, b, arm_a, arm_b, normal, noise, restitution, i, j, world)
    staying = abs(rate) <= noise
    on_points = pressing(arm_a, arm_b, normal, i, j, world)
    pair = (after_b, after_a) if swapped == 1 else (after_a, after_b)
    opening = opening_acceleration(on_points, pair[0], pair[1], point, sided)
    if not staying and opening < 0.0:
        staying = rest.bounce_height(rate, opening) <= tolerance
    if (
        rate < -noise
        or before == world.counts[tb.IMPACTS]
        or (staying and not world.counts[tb.SETTLES])
    ):
        world.counts[tb.IMPACTS] = before
        return False
    for row in range(before, world.counts[tb.IMPACTS]):
        world.impacts[row, tb.POINT_X], world.impacts[row, tb.POINT_Y] = (
            q[0] + arm[0],
            q[1] + arm[1],
        )
    forecast(i, j, time, rate, opening, restitution, tolerance, world)
    depart(i, time, after_a, world)
    depart(j, time, after_b, world)
    return not staying or stay(i, j, a, b, arm_a, arm_b, normal, world)


@inlined
def is_full(world: World) -> bool:
    """Return whether the records have no room for what one instant may add."""
    impacts = world.counts[tb.IMPACTS] + MOST_IMPULSES > len(world.impacts)
    few = world.counts[tb.DEPARTURES] + 2 > len(world.departures)
    return bool(impacts or (few and len(world.departures) > 0))


@inlined
def seems_endless(world: World) -> bool:
    """Return whether so many impacts seem to come of a world that `simulate` may refuse it."""
    done, now = world.counts[tb.IMPACTS], world.numbers[tb.NOW]
    many = world.counts[tb.SETTLES] > 0 and done >= SAMPLE
    return bool(many and done * (world.numbers[tb.END] - now) > MOST_COMING * now)


@inlined
def is_bound(k: int, time: float, world: World) -> bool:
    """Return whether a body bounces on several others, or does not get on in time."""
    note = world.notes[k]
    repeats = note[tb.STALLED] >= MOST_REPEATS and world.paths[k, tb.START] >= time * (
        1 - 4 * EPSILON
    )
    return bool(world.bounces[k, tb.WITH] == tb.SEVERAL or repeats)


@inlined
def most_speed_of(a: Moving, b: Moving, arm_a: Pair, arm_b: Pair) -> float:
    """Return no less than `speed_of` does."""
    return (
        (abs(a[3]) + abs(a[4]))
        + (abs(b[3]) + abs(b[4]))
        + abs(a[5]) * (abs(arm_a[0]) + abs(arm_a[1]))
        + abs(b[5]) * (abs(arm_b[0]) + abs(arm_b[1]))
    )


@inlined
def least_speed_of(a: Moving, b: Moving) -> float:
    """Return no more than `speed_of` does."""
    return max(abs(a[3]), abs(a[4])) + max(abs(b[3]), abs(b[4]))


@inlined
def forecast(
    i: int,
    j: int,
    time: float,
    rate: float,
    opening: float,
    restitution: float,
    tolerance: float,
    world: World,
) -> None:
    """Note when the bounces of a pair end, s, if they go on as a geometric series (GD5)."""
    known = True
    for k, other in ((i, j), (j, i)):
        known = known and (not is_pushed(k, world) or world.bounces[k, tb.WITH] == other + 1)
    last, best, doubt = 0.0, 0.0, -1.0
    if known:
        row = world.bounces[i if is_pushed(i, world) else j]
        last, best, doubt = row[tb.LAST], row[tb.BEST], row[tb.DOUBT]
    if opening * (1 - restitution) < 0.0:
        end = time + rest.time_to_rest(rate, opening, restitution)
        if end > 0.0:
            noise = tolerance / rate / (1 - restitution)
            last, best, doubt = better_estimate(last, best, doubt, end, noise)
    for k, other in ((i, j), (j, i)):
        if is_pushed(k, world):
            row = world.bounces[k]
            row[tb.WITH] = other + 1 if doubt >= 0.0 else 0.0
            row[tb.LAST], row[tb.BEST], row[tb.DOUBT] = last, best, doubt
