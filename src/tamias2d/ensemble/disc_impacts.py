"""Compiled worlds of discs and half-planes without friction, from one located impact to the next.

It does what `tamias2d.contact` does where at most two bodies touch at a time, operation by
operation, so that the bits are the same; the equations are those of `tamias2d.generated`. A world
in which more happens is handed over: it is solved again, in the ordinary way.
"""

from math import frexp, inf, ldexp, sqrt
from typing import TypeAlias

from tamias2d.generated import impact, rotation, translation
from tamias2d.generated.continuous_collision import (
    advance_closing,
    advance_opening,
    centre_acceleration_least,
    discriminant,
)
from tamias2d.kernels.arrays import FloatBlocks, FloatRows, Floats, IndexRows, Indices
from tamias2d.state import Array

# of a body: its start and what acts on it, then what it is
X, Y, TURN, VX, VY, SPIN, AX, AY, TURNING, INVERSE_MASS, INVERSE_INERTIA, RADIUS = range(12)
NORMAL_X, NORMAL_Y, OFFSET = range(12, 15)
COLUMNS = 15
START = 9  # of a path, after its state and its acceleration, s
PATH_COLUMNS = 10
PARTICLE, PLANE, FIXED_DISC, DISC = range(4)  # kinds of bodies; only the last one is pushed
MOVING_PARTICLE = 4
TOLD, RESTS_ON, STALLED = range(3)  # of a body: samples written, plane + 1, paths without advance
NEXT, SEEN_X, SEEN_Y = range(3)  # of a pair: when they meet, and in which direction they were apart
HANDED_OVER, DONE = range(2)

EPSILON = 2.0**-52
MOST_STEPS = 2000
MOST_IMPACTS = 999  # from 1000 on, the rest of a run is estimated
MOST_REPEATS = 32
TINY_STEP = 2.0**-48
TINY_STEPS = 1000
MARGIN = 1e-6  # relative: a comparison that is as near as that is left to the ordinary way
SPLIT = 134217729.0

Moving: TypeAlias = tuple[float, float, float, float, float, float]
"""x, y, m; orientation, rad; velocity, m/s; angular velocity, rad/s"""
Pair: TypeAlias = tuple[float, float]


def follow_worlds(
    bodies: FloatBlocks,
    restitution: FloatBlocks,
    kinds: Indices,
    times: Floats,
    paths: FloatRows,
    notes: IndexRows,
    pairs: FloatRows,
    samples: FloatBlocks,
    status: Indices,
    duration: float,
) -> int:
    """Follow worlds, one after the other; return how many were followed to the end.

    `bodies` are (w, n, 15), `restitution` (w, n, n), below 0 where none is stated, `samples`
    (w, k n, 6), and `status` (w,) says which worlds were handed over. The rest is scratch.
    """
    done = 0
    for w in range(len(bodies)):
        status[w] = follow_world(
            bodies[w], restitution[w], kinds, times, paths, notes, pairs, samples[w], duration
        )
        done += status[w]
    return done


def follow_world(
    bodies: Array,
    restitution: Array,
    kinds: Indices,
    times: Array,
    paths: Array,
    notes: Indices,
    pairs: Array,
    samples: Array,
    duration: float,
) -> int:
    """Follow one world from impact to impact, or hand it over."""
    count = len(kinds)
    for k in range(count):
        for column in range(START):
            paths[k, column] = bodies[k, column]
        paths[k, START] = 0.0
        notes[k, TOLD] = notes[k, RESTS_ON] = notes[k, STALLED] = 0
    pairs[:, :] = 0.0
    pairs[:, NEXT] = inf
    for k in range(count):
        if not schedule(k, k + 1, 0.0, duration, kinds, bodies, paths, notes, pairs):
            return HANDED_OVER
    impacts, repeats, before = 0, 0, -1.0
    while True:
        time, first, second = next_meeting(count, pairs)
        if time > duration:
            break
        impacts += 1
        repeats = repeats + 1 if time == before else 0
        before = time
        if impacts > MOST_IMPACTS or repeats > MOST_REPEATS:
            return HANDED_OVER
        for k in (first, second):
            if kinds[k] == DISC:
                tell(k, time, paths, notes, times, samples)
        e = restitution[first, second]
        if not meet(first, second, time, e, kinds, bodies, paths, notes):
            return HANDED_OVER
        for k in (first, second):
            if kinds[k] == DISC and not schedule(
                k, 0, time, duration, kinds, bodies, paths, notes, pairs
            ):
                return HANDED_OVER
    for k in range(count):
        tell(k, 2.0 * duration, paths, notes, times, samples)
    return DONE


def next_meeting(count: int, pairs: Array) -> tuple[float, int, int]:
    """Return the time of the next meeting, s, and who meets; infinity where nobody does."""
    best, first, second = inf, 0, 0
    for i in range(count):
        for j in range(i + 1, count):
            if pairs[count * i + j, NEXT] < best:
                best, first, second = pairs[count * i + j, NEXT], i, j
    return best, first, second


def meets(i: int, j: int, kinds: Indices) -> bool:
    """Return whether two bodies can meet at all."""
    solid = 0 < kinds[i] < MOVING_PARTICLE and 0 < kinds[j] < MOVING_PARTICLE
    return bool(solid and (kinds[i] == DISC or kinds[j] == DISC))


def schedule(
    k: int,
    least: int,
    time: float,
    end: float,
    kinds: Indices,
    bodies: Array,
    paths: Array,
    notes: Indices,
    pairs: Array,
) -> bool:
    """Find when a body meets each other one from `least` on; return whether that can be told."""
    count = len(kinds)
    for other in range(least, count):
        i, j = min(k, other), max(k, other)
        if i == j or not meets(i, j, kinds):
            continue
        pair = pairs[count * i + j]
        if notes[i, RESTS_ON] == j + 1 or notes[j, RESTS_ON] == i + 1:
            pair[NEXT] = inf
            continue
        if passes(i, j, time, end, kinds, bodies, paths, pair):
            pair[NEXT] = inf
            continue
        pair[NEXT] = time_of_impact(i, j, time, end, kinds, bodies, paths, pair)
        if pair[NEXT] < 0.0:
            return False
    return True


def passes(
    i: int,
    j: int,
    time: float,
    end: float,
    kinds: Indices,
    bodies: Array,
    paths: Array,
    pair: Array,
) -> bool:
    """Return whether two discs on which the same acts pass each other well apart.

    One moves on a straight line before the other, so that no search is needed.
    """
    a, b = paths[i], paths[j]
    if kinds[i] == PLANE or kinds[j] == PLANE or a[AX] != b[AX] or a[AY] != b[AY]:
        return False
    p, q = state_at(i, time, paths), state_at(j, time, paths)
    x, y, u, v = q[0] - p[0], q[1] - p[1], q[3] - p[3], q[4] - p[4]
    closing, square = -(x * u + y * v), u * u + v * v
    left = min(closing / square, end - time) if closing > 0.0 and square > 0.0 else 0.0
    x_least, y_least = x + u * left, y + v * left
    apart = (bodies[i, RADIUS] + bodies[j, RADIUS]) * (1.0 + MARGIN)
    if x_least * x_least + y_least * y_least <= apart * apart:
        return False
    pair[SEEN_X], pair[SEEN_Y] = x, y
    return True


def time_of_impact(
    i: int,
    j: int,
    start: float,
    end: float,
    kinds: Indices,
    bodies: Array,
    paths: Array,
    pair: Array,
) -> float:
    """Return when two bodies touch and do not separate, s; infinity if never, -1 if undecided."""
    time, tiny_steps, tiny = start, 0, TINY_STEP * max(abs(end), end - start)
    for _ in range(MOST_STEPS):
        if not time < end:
            return inf
        a, b = state_at(i, time, paths), state_at(j, time, paths)
        tolerance = resolution(a, b, size_of(i, kinds, bodies), size_of(j, kinds, bodies), time)
        ux, uy, gap, swapped = axis_of(a, b, kinds[i], kinds[j], bodies[i], bodies[j])
        if start == 0.0 and time == 0.0 and gap <= MARGIN * tolerance + tolerance:
            return -1.0  # they touch, or overlap, at the start
        touching = gap <= tolerance
        if not touching:
            sign = -1.0 if swapped == 1 else 1.0
            pair[SEEN_X], pair[SEEN_Y] = sign * ux, sign * uy
        elif turned_round(ux, uy, kinds[i], kinds[j], pair):
            return -1.0
        value, rate = gap_of(a, b, ux, uy, swapped, kinds[i], kinds[j], bodies[i], bodies[j])
        if value <= 0.0 and rate <= 0.0:
            return time
        p, q = (j, i) if swapped == 1 else (i, j)
        on_p, on_q = (paths[p, AX], paths[p, AY]), (paths[q, AX], paths[q, AY])
        step = max(root(value, rate, centre_acceleration_least(on_p, on_q, (ux, uy), 0.0)), 0.0)
        if time + step == time:
            return time
        tiny_steps += 1 if touching or step < tiny else 0
        if tiny_steps > TINY_STEPS:
            return -1.0
        time += step
    return -1.0


def turned_round(ux: float, uy: float, kind_a: int, kind_b: int, pair: Array) -> bool:
    """Return whether two discs seem to have passed through each other."""
    discs = kind_a != PLANE and kind_b != PLANE
    return discs and ux * pair[SEEN_X] + uy * pair[SEEN_Y] < 0.0


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


def state_at(k: int, time: float, paths: Array) -> Moving:
    """Return x, y, orientation, velocity and angular velocity of a body at a time, s."""
    path = paths[k]
    elapsed = time - path[START]
    place, going, by = (path[X], path[Y]), (path[VX], path[VY]), (path[AX], path[AY])
    x, y = translation.position(place, going, by, elapsed)
    u, v = translation.velocity(going, by, elapsed)
    turn = rotation.orientation(path[TURN], path[SPIN], path[TURNING], elapsed)
    spin = rotation.angular_velocity(path[SPIN], path[TURNING], elapsed)
    return x, y, turn, u, v, spin


def size_of(k: int, kinds: Indices, bodies: Array) -> float:
    """Return how far off its centre the numbers of a body lie, m."""
    return float(abs(bodies[k, OFFSET]) if kinds[k] == PLANE else bodies[k, RADIUS])


def resolution(
    a: Moving,
    b: Moving,
    size_a: float,
    size_b: float,
    time: float,
) -> float:
    """Return the gap in m that float64 cannot tell from 0."""
    length = abs(a[0]) + abs(a[1]) + abs(b[0]) + abs(b[1]) + size_a + size_b
    speed = abs(b[3] - a[3]) + abs(b[4] - a[4])
    return EPSILON * (16 * length + 4 * speed * time)


def axis_of(
    a: Moving,
    b: Moving,
    kind_a: int,
    kind_b: int,
    body_a: Array,
    body_b: Array,
) -> tuple[float, float, float, int]:
    """Return the axis from P to Q, the gap along it, m, and whether P is the second body."""
    if kind_a == PLANE:
        ux, uy, gap = axis_of_plane(body_a, b[0] - a[0], b[1] - a[1], body_b[RADIUS])
        return ux, uy, gap, 0
    if kind_b == PLANE:
        ux, uy, gap = axis_of_plane(body_b, a[0] - b[0], a[1] - b[1], body_a[RADIUS])
        return ux, uy, gap, 1
    x, y = b[0] - a[0], b[1] - a[1]
    distance = hypot(x, y)
    base = body_a[RADIUS] + body_b[RADIUS]
    if distance == 0.0:
        return 1.0, 0.0, distance - base, 0
    return x / distance, y / distance, distance - base, 0


def axis_of_plane(plane: Array, dx: float, dy: float, radius: float) -> tuple[float, float, float]:
    """Return the normal of a half-plane, and the gap to a disc before it, m."""
    ux = 1.0 * plane[NORMAL_X] - 0.0 * plane[NORMAL_Y]
    uy = 0.0 * plane[NORMAL_X] + 1.0 * plane[NORMAL_Y]
    nearest = ux * 0.0 + uy * 0.0
    return ux, uy, ux * dx + uy * dy + nearest - plane[OFFSET] - radius


def gap_of(
    a: Moving,
    b: Moving,
    ux: float,
    uy: float,
    swapped: int,
    kind_a: int,
    kind_b: int,
    body_a: Array,
    body_b: Array,
) -> Pair:
    """Return the gap along an axis, m, and its rate, m/s."""
    p, q = (b, a) if swapped == 1 else (a, b)
    x, y = q[0] - p[0] + 0.0, q[1] - p[1] + 0.0
    plane = kind_a == PLANE or kind_b == PLANE
    if plane:
        owner, disc = (body_b, body_a) if swapped == 1 else (body_a, body_b)
        base, arm = owner[OFFSET] + disc[RADIUS], (x, y)
    else:
        base, arm = body_a[RADIUS] + body_b[RADIUS], (0.0, 0.0)
    rate = impact.normal_velocity((p[3], p[4]), p[5], arm, (q[3], q[4]), q[5], (0.0, 0.0), (ux, uy))
    return ux * x + uy * y - base, rate


def meet(
    i: int,
    j: int,
    time: float,
    restitution: float,
    kinds: Indices,
    bodies: Array,
    paths: Array,
    notes: Indices,
) -> bool:
    """Set the paths of two bodies after they have met; return whether that is all that happens."""
    if restitution < 0.0 or touches_others(i, j, time, kinds, bodies, paths, notes):
        return False
    a, b = state_at(i, time, paths), state_at(j, time, paths)
    tolerance = resolution(a, b, size_of(i, kinds, bodies), size_of(j, kinds, bodies), time)
    ux, uy, gap, swapped = axis_of(a, b, kinds[i], kinds[j], bodies[i], bodies[j])
    least = min(
        inf if kinds[i] == PLANE else bodies[i, RADIUS],
        inf if kinds[j] == PLANE else bodies[j, RADIUS],
    )
    if gap > tolerance or tolerance > 0.01 * least:
        return False
    p, q = (b, a) if swapped == 1 else (a, b)
    radius = bodies[i, RADIUS] if swapped == 1 else bodies[j, RADIUS]
    arm_q = (0.0 - radius * ux, 0.0 - radius * uy)
    arm_p = (arm_q[0] + (q[0] - p[0]), arm_q[1] + (q[1] - p[1]))
    sign = -1.0 if swapped == 1 else 1.0
    normal = (sign * ux, sign * uy)
    arms = (arm_q, arm_p) if swapped == 1 else (arm_p, arm_q)
    after_a, after_b, rate, noise = rebound(
        a, b, arms[0], arms[1], normal, restitution, bodies[i], bodies[j]
    )
    if near(abs(rate), noise) or rate < -noise:
        return False
    acting = pull(i, j, kinds, bodies, normal)
    limit = -2.0 * acting * tolerance
    staying = rate <= noise or (acting < 0.0 and rate * rate <= limit)
    if near(rate * rate, limit) or (rate > noise and unsure(rate, limit, kinds[i], kinds[j])):
        return False
    approached = (
        a[3] != after_a[3] or a[4] != after_a[4] or b[3] != after_b[3] or b[4] != after_b[4]
    )
    if not (approached or staying):
        return False
    for k, state in ((i, after_a), (j, after_b)):
        if kinds[k] == DISC and not depart(k, time, state, bodies[k], paths, notes):
            return False
    return not staying or rest(i, j, acting, normal, kinds, bodies, paths, notes)


def near(value: float, limit: float) -> bool:
    """Return whether a number is too near to a limit to be told from it by other roundings."""
    return limit > 0.0 and abs(value - limit) <= MARGIN * limit


def unsure(rate: float, limit: float, kind_a: int, kind_b: int) -> bool:
    """Return whether two discs may stay together, which the ordinary way decides."""
    return kind_a != PLANE and kind_b != PLANE and rate * rate <= 2.0 * limit


def touches_others(
    i: int, j: int, time: float, kinds: Indices, bodies: Array, paths: Array, notes: Indices
) -> bool:
    """Return whether one of two bodies that meet touches a third one, or rests."""
    for k in (i, j):
        if kinds[k] != DISC:
            continue
        if notes[k, RESTS_ON] > 0:
            return True
        a = state_at(k, time, paths)
        for other in range(len(kinds)):
            if other in (i, j) or not meets(k, other, kinds):
                continue
            b = state_at(other, time, paths)
            apart = (bodies[k, RADIUS] + bodies[other, RADIUS]) * (1.0 + MARGIN)
            x, y = b[0] - a[0], b[1] - a[1]
            if kinds[other] != PLANE and x * x + y * y > apart * apart:
                continue
            sizes = size_of(k, kinds, bodies), size_of(other, kinds, bodies)
            _, _, gap, _ = axis_of(a, b, kinds[k], kinds[other], bodies[k], bodies[other])
            if gap <= 2.0 * resolution(a, b, sizes[0], sizes[1], time):
                return True
    return False


def rebound(
    a: Moving,
    b: Moving,
    arm_a: Pair,
    arm_b: Pair,
    normal: Pair,
    restitution: float,
    body_a: Array,
    body_b: Array,
) -> tuple[
    Moving,
    Moving,
    float,
    float,
]:
    """Return both states after the impulses of an impact, the normal velocity, and its noise.

    A normal velocity of minus infinity says that it is not told from its noise.
    """
    mass_a, mass_b = body_a[INVERSE_MASS], body_b[INVERSE_MASS]
    turn_a, turn_b = body_a[INVERSE_INERTIA], body_b[INVERSE_INERTIA]
    speed = sqrt(a[3] * a[3] + a[4] * a[4]) + sqrt(b[3] * b[3] + b[4] * b[4])
    speed += abs(a[5]) * sqrt(arm_a[0] * arm_a[0] + arm_a[1] * arm_a[1])
    speed += abs(b[5]) * sqrt(arm_b[0] * arm_b[0] + arm_b[1] * arm_b[1])
    noise = speed * (64 * EPSILON)
    u, v, spin_a = a[3], a[4], a[5]
    s, t, spin_b = b[3], b[4], b[5]
    rate = impact.normal_velocity((u, v), spin_a, arm_a, (s, t), spin_b, arm_b, normal)
    if near(-rate, noise):
        return a, b, -inf, noise
    for _ in range(MOST_REPEATS):
        if rate >= -noise:
            break
        inverse = impact.inverse_effective_mass(
            mass_a, turn_a, arm_a, mass_b, turn_b, arm_b, normal
        )
        strength = max(impact.impulse(restitution, rate, inverse), 0.0)
        if mass_a > 0.0:
            u, v = impact.velocity_a_after((u, v), strength, normal, mass_a)
            spin_a = impact.angular_velocity_a_after(spin_a, strength, arm_a, normal, turn_a)
        if mass_b > 0.0:
            s, t = impact.velocity_b_after((s, t), strength, normal, mass_b)
            spin_b = impact.angular_velocity_b_after(spin_b, strength, arm_b, normal, turn_b)
        rate = impact.normal_velocity((u, v), spin_a, arm_a, (s, t), spin_b, arm_b, normal)
    return (a[0], a[1], a[2], u, v, spin_a), (b[0], b[1], b[2], s, t, spin_b), rate, noise


def pull(i: int, j: int, kinds: Indices, bodies: Array, normal: Pair) -> float:
    """Return the acceleration at which loads alone open a gap, m/s^2."""
    found = 0.0
    for k, sign in ((i, -1.0), (j, 1.0)):
        if kinds[k] == DISC:
            found += sign * (bodies[k, AX] * normal[0] + bodies[k, AY] * normal[1])
    return found


def tell(k: int, until: float, paths: Array, notes: Indices, times: Array, samples: Array) -> None:
    """Write down the states of a body on its path at all times before one, s."""
    count = len(paths)
    while notes[k, TOLD] < len(times) and times[notes[k, TOLD]] < until:
        x, y, turn, u, v, spin = state_at(k, times[notes[k, TOLD]], paths)
        row = samples[count * notes[k, TOLD] + k]
        row[0], row[1], row[2], row[3], row[4], row[5] = x, y, turn, u, v, spin
        notes[k, TOLD] += 1


def depart(
    k: int,
    time: float,
    state: Moving,
    body: Array,
    paths: Array,
    notes: Indices,
) -> bool:
    """Set the path of a body from a state on; return whether it still advances in time."""
    path = paths[k]
    stalled = path[START] >= time * (1 - 4 * EPSILON)
    notes[k, STALLED] = notes[k, STALLED] + 1 if stalled else 0
    path[X], path[Y], path[TURN], path[VX], path[VY], path[SPIN] = state
    path[AX], path[AY], path[TURNING] = body[AX], body[AY], body[TURNING]
    path[START] = time
    return bool(notes[k, STALLED] <= MOST_REPEATS)


def rest(
    i: int,
    j: int,
    acting: float,
    normal: Pair,
    kinds: Indices,
    bodies: Array,
    paths: Array,
    notes: Indices,
) -> bool:
    """Let a disc stay on the half-plane that it is pressed on; return whether it is so."""
    if kinds[i] != PLANE and kinds[j] != PLANE:
        return False
    k, plane = (j, i) if kinds[i] == PLANE else (i, j)
    path = paths[k]
    size = abs(bodies[k, AX]) + abs(bodies[k, AY])
    if acting > -MARGIN * size or size == 0.0:
        return False
    path[VX], path[VY] = tangential(path[VX], path[VY], normal)
    path[AX], path[AY] = tangential(bodies[k, AX], bodies[k, AY], normal)
    notes[k, RESTS_ON] = plane + 1
    return True


def tangential(x: float, y: float, normal: Pair) -> Pair:
    """Return the part of a vector along a surface."""
    along = normal[1] * x - normal[0] * y
    return along * normal[1] + 0.0, -along * normal[0] + 0.0


def hypot(x: float, y: float) -> float:
    """Return the length of a vector as `math.hypot` of CPython does, to the bit.

    That of the C library, which compiled code has, rounds now and then otherwise.
    """
    x, y = abs(x), abs(y)
    largest = max(x, y)
    if largest == 0.0:
        return 0.0
    _, exponent = frexp(largest)
    scale = ldexp(1.0, -exponent)
    total, low, lost = 1.0, 0.0, 0.0
    for value in (x * scale, y * scale):
        high, rest_ = product(value, value)
        after = total + high
        lost += (total - after) + high
        low += rest_
        total = after
    length = sqrt(total - 1.0 + (low + lost))
    high, rest_ = product(-length, length)
    after = total + high
    lost += (total - after) + high
    low += rest_
    error = after - 1.0 + (low + lost)
    return (length + error / (2.0 * length)) / scale


def product(x: float, y: float) -> Pair:
    """Return a product, rounded, and what rounding took from it (Dekker)."""
    split = x * SPLIT
    x_high = split - (split - x)
    split = y * SPLIT
    y_high = split - (split - y)
    x_low, y_low = x - x_high, y - y_high
    found = x * y
    return found, x_high * y_high - found + x_high * y_low + x_low * y_high + x_low * y_low
