"""What happens where two bodies meet in one point and touch nothing else: IM3, IM9 with friction.

It is what `tamias2d.contact` does at such an instant, operation by operation. Whatever else
happens at an instant is not decided here, but for a disc that rests on a half-plane where it need
not be told since when (`settling`).
"""

from math import inf

from tamias2d.contact.rest_time import better_estimate
from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.approach import EPSILON, state_at
from tamias2d.event_driven.departure import MOST_REPEATS, depart, pull_of, pull_on
from tamias2d.event_driven.kinds import is_pushed
from tamias2d.event_driven.laws import friction_of, restitution_of
from tamias2d.event_driven.length import hypot
from tamias2d.event_driven.settling import stay, stay_on
from tamias2d.event_driven.tables import Moving, Pair, Point, World
from tamias2d.event_driven.touch import MOST_RESOLUTION, touch_of, touches_third
from tamias2d.generated import friction, impact, rest
from tamias2d.kernels.assembled import inlined

MOST_IMPULSES = 32  # of one pair at one instant
CLEAR = 4.0  # times what rounding is at most: a bounce so fast is one, whatever the rounding is


@inlined
def meet(i: int, j: int, time: float, world: World) -> bool:
    """Set the paths of two bodies after they have met; return whether that is all that happens."""
    return not touches_third(i, j, time, world) and collide(i, j, time, world)


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
    if world.notes[i, tb.HELD_BY] > 0 or world.notes[j, tb.HELD_BY] > 0:
        closing = abs(opening) + 2.0 * (pull_of(i, world) + pull_of(j, world))
        clear = not staying and rest.bounce_height(rate, -closing) > tolerance
        return clear and stay_on(i, a, time, world) and stay_on(j, b, time, world)
    return not staying or stay(i, j, a, b, arm_a, arm_b, normal, world)


@inlined
def is_full(world: World) -> bool:
    """Return whether the records have no room for what one instant may add."""
    impacts = world.counts[tb.IMPACTS] + MOST_IMPULSES > len(world.impacts)
    few = world.counts[tb.DEPARTURES] + 2 > len(world.departures)
    return bool(impacts or (few and len(world.departures) > 0))


@inlined
def is_bound(k: int, time: float, world: World) -> bool:
    """Return whether a body rests, bounces on several others, or does not get on in time.

    What rests may go on, where it need not be told when it does.
    """
    note = world.notes[k]
    rests = note[tb.HELD_BY] > 0 and world.counts[tb.SETTLES] == 0
    repeats = note[tb.STALLED] >= MOST_REPEATS and world.paths[k, tb.START] >= time * (
        1 - 4 * EPSILON
    )
    return bool(rests or world.bounces[k, tb.WITH] == tb.SEVERAL or repeats)


def reach(k: int, world: World) -> float:
    """Return the radius of a body, m; of a half-plane it is infinite."""
    return inf if world.kinds[k] == tb.PLANE else world.bodies[k, tb.RADIUS]


def arms(
    a: Moving, b: Moving, point: Point, swapped: int, i: int, j: int, world: World
) -> tuple[Pair, Pair]:
    """Return the arms of both bodies to where they touch, m."""
    p, q = (b, a) if swapped == 1 else (a, b)
    ux, uy, wx, wy, _, _ = point
    radius = world.bodies[i, tb.ROUNDING] if swapped == 1 else world.bodies[j, tb.ROUNDING]
    arm_q = (wx - radius * ux, wy - radius * uy)
    arm_p = (arm_q[0] + (q[0] - p[0]), arm_q[1] + (q[1] - p[1]))
    return (arm_q, arm_p) if swapped == 1 else (arm_p, arm_q)


def speed_of(a: Moving, b: Moving, arm_a: Pair, arm_b: Pair) -> float:
    """Return the size of the terms that make up the velocity of a contact, m/s."""
    return (
        hypot(a[3], a[4])
        + hypot(b[3], b[4])
        + abs(a[5]) * hypot(arm_a[0], arm_a[1])
        + abs(b[5]) * hypot(arm_b[0], arm_b[1])
    )


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
def rebound(
    a: Moving,
    b: Moving,
    arm_a: Pair,
    arm_b: Pair,
    normal: Pair,
    noise: float,
    restitution: float,
    i: int,
    j: int,
    world: World,
) -> tuple[Moving, Moving, float]:
    """Return both states after the impulses of an impact, and the normal velocity, m/s."""
    rough = friction_of(i, j, world) > 0.0
    rate = normal_velocity(a, b, arm_a, arm_b, normal)
    for _ in range(MOST_IMPULSES):
        if rate >= -noise:
            break
        if rough:
            after_a, after_b, impulse = after_friction(
                a, b, arm_a, arm_b, normal, rate, restitution, i, j, world
            )
        else:
            after_a, after_b, impulse = after_impulse(
                a, b, arm_a, arm_b, normal, rate, restitution, i, j, world
            )
        note_impact(i, j, normal, impulse, rate, world)
        a, b = after_a, after_b
        rate = normal_velocity(a, b, arm_a, arm_b, normal)
    return a, b, rate


def normal_velocity(a: Moving, b: Moving, arm_a: Pair, arm_b: Pair, normal: Pair) -> float:
    """Return how fast a contact opens, m/s."""
    return float(
        impact.normal_velocity((a[3], a[4]), a[5], arm_a, (b[3], b[4]), b[5], arm_b, normal)
    )


@inlined
def inverses(k: int, world: World) -> Pair:
    """Return the inverses of the mass, 1/kg, and of the inertia, 1/(kg m^2), of a body."""
    return world.bodies[k, tb.INVERSE_MASS], world.bodies[k, tb.INVERSE_INERTIA]


@inlined
def smooth_impulse(
    arm_a: Pair,
    arm_b: Pair,
    normal: Pair,
    rate: float,
    restitution: float,
    i: int,
    j: int,
    world: World,
) -> tuple[float, float]:
    """Return the impulse without friction, N s (IM3), and the inverse effective mass, 1/kg."""
    mass_a, turn_a = inverses(i, world)
    mass_b, turn_b = inverses(j, world)
    inverse = impact.inverse_effective_mass(mass_a, turn_a, arm_a, mass_b, turn_b, arm_b, normal)
    return max(impact.impulse(restitution, rate, inverse), 0.0), inverse


@inlined
def after_impulse(
    a: Moving,
    b: Moving,
    arm_a: Pair,
    arm_b: Pair,
    normal: Pair,
    rate: float,
    restitution: float,
    i: int,
    j: int,
    world: World,
) -> tuple[Moving, Moving, float]:
    """Return both states after an impulse without friction, and its size, N s (IM3)."""
    mass_a, turn_a = inverses(i, world)
    mass_b, turn_b = inverses(j, world)
    impulse, _ = smooth_impulse(arm_a, arm_b, normal, rate, restitution, i, j, world)
    if is_pushed(i, world):
        u, v = impact.velocity_a_after((a[3], a[4]), impulse, normal, mass_a)
        spin = impact.angular_velocity_a_after(a[5], impulse, arm_a, normal, turn_a)
        a = (a[0], a[1], a[2], u, v, spin)
    if is_pushed(j, world):
        u, v = impact.velocity_b_after((b[3], b[4]), impulse, normal, mass_b)
        spin = impact.angular_velocity_b_after(b[5], impulse, arm_b, normal, turn_b)
        b = (b[0], b[1], b[2], u, v, spin)
    return a, b, impulse


@inlined
def after_friction(
    a: Moving,
    b: Moving,
    arm_a: Pair,
    arm_b: Pair,
    normal: Pair,
    rate: float,
    restitution: float,
    i: int,
    j: int,
    world: World,
) -> tuple[Moving, Moving, float]:
    """Return both states after an impulse with friction, and its normal part, N s (IM9)."""
    mass_a, turn_a = inverses(i, world)
    mass_b, turn_b = inverses(j, world)
    impulse, inverse = smooth_impulse(arm_a, arm_b, normal, rate, restitution, i, j, world)
    cross = friction.cross_coupling(turn_a, arm_a, turn_b, arm_b, normal)
    sliding = friction.inverse_sliding_mass(mass_a, turn_a, arm_a, mass_b, turn_b, arm_b, inverse)
    slip = friction.tangential_velocity(
        (a[3], a[4]), a[5], arm_a, (b[3], b[4]), b[5], arm_b, normal
    )
    closest = friction.tangential_velocity_closest(slip, cross, rate, inverse)
    sticking = friction.sticking_impulse(closest, sliding)
    change = friction.normal_change(cross, sticking, inverse)
    share = friction.share(friction_of(i, j, world), impulse, sticking, change)
    along = friction.normal_impulse(impulse, share, change)
    vector = friction.impulse_vector(along, friction.tangential_impulse(share, sticking), normal)
    if is_pushed(i, world):
        u, v = friction.velocity_a_after((a[3], a[4]), mass_a, vector)
        a = (a[0], a[1], a[2], u, v, friction.angular_velocity_a_after(a[5], turn_a, arm_a, vector))
    if is_pushed(j, world):
        u, v = friction.velocity_b_after((b[3], b[4]), mass_b, vector)
        b = (b[0], b[1], b[2], u, v, friction.angular_velocity_b_after(b[5], turn_b, arm_b, vector))
    return a, b, along


@inlined
def note_impact(i: int, j: int, normal: Pair, impulse: float, rate: float, world: World) -> None:
    """Record an impulse, but for where it acts."""
    row = world.impacts[world.counts[tb.IMPACTS]]
    world.counts[tb.IMPACTS] += 1
    row[tb.TIME], row[tb.A], row[tb.B] = world.numbers[tb.NOW], i, j
    row[tb.ALONG_X], row[tb.ALONG_Y] = normal
    row[tb.IMPULSE], row[tb.NORMAL_VELOCITY] = impulse, rate


@inlined
def pressing(arm_a: Pair, arm_b: Pair, normal: Pair, i: int, j: int, world: World) -> float:
    """Return the normal acceleration of a contact under the loads alone, m/s^2 (DD19)."""
    on_a, on_b = pull_on(i, world), pull_on(j, world)
    return float(
        rest.normal_acceleration(
            (on_a[0], on_a[1]), on_a[2], arm_a, (on_b[0], on_b[1]), on_b[2], arm_b, normal
        )
    )


@inlined
def opening_acceleration(on_points: float, p: Moving, q: Moving, point: Point, sided: int) -> float:
    """Return the second derivative of a gap of which the points accelerate, m/s^2 (GD15)."""
    ux, uy, wx, wy, vx, vy = point
    u, w, v = (ux, uy), (wx, wy), (vx, vy)
    distance = ux * (q[0] - p[0] + wx - vx) + uy * (q[1] - p[1] + wy - vy)
    slip = friction.tangential_velocity((p[3], p[4]), p[5], v, (q[3], q[4]), q[5], w, u)
    if sided == 1:
        return float(rest.gap_acceleration_side(on_points, p[5], q[5], w, u, slip, distance))
    if distance == 0.0:
        slip, distance = 0.0, 1.0
    return float(rest.gap_acceleration_corner(on_points, p[5], v, q[5], w, u, slip, distance))


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
