"""Bodies that touch more than one at an instant: their impacts, and discs that stay on half-planes.

It is what `tamias2d.contact` does there, operation by operation. Pairs that approach answer one by
one, in rounds where they act on one another (A18); a disc that neither approaches its half-plane
nor parts from it stays there. Not decided here: pairs that approach at a time and share a body, and
all else that stays.
"""

from math import inf

from tamias2d.contact.manifold import LASTING_NOISE
from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.approach import EPSILON, state_at
from tamias2d.event_driven.cells import gather
from tamias2d.event_driven.departure import MOST_REPEATS, depart, pull_of
from tamias2d.event_driven.kinds import has_hull, is_pushed
from tamias2d.event_driven.laws import restitution_of
from tamias2d.event_driven.length import hypot
from tamias2d.event_driven.meeting import meets
from tamias2d.event_driven.opening import opening_acceleration, pressing
from tamias2d.event_driven.rebound import (
    MOST_IMPULSES,
    arms,
    normal_velocity,
    reach,
    rebound,
    speed_of,
)
from tamias2d.event_driven.settling import keep
from tamias2d.event_driven.tables import Moving, Pair, Point, World
from tamias2d.event_driven.touch import MOST_RESOLUTION, gap_between, is_far, touch_of
from tamias2d.generated import definitions, rest
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

MOST_ROUNDS = 64
LEFT = 1e-9  # of the first approach: a slower one is closed without restitution, elsewhere
GAIN = 5e-10  # of the energy: where rounds add more, they may have made some


def resolve(i: int, j: int, time: float, world: World) -> bool:
    """Set the paths of all that touch two bodies, or one, at a time, s; return whether that is all.

    The bodies on new paths are listed as changed.
    """
    if not list_cluster(i, j, time, world):
        return False
    ruled = world.counts[tb.RULED]
    if not answer_all(world) or not find_support(world):
        return False
    if world.counts[tb.RULED] > ruled and gains(time, world):
        return False
    good = True
    for n in range(world.counts[tb.CLUSTER]):
        good = good and go_on_in(world.cluster[n], time, world)
    return good and world.counts[tb.CHANGED] > 0


# -- what touches


@inlined
def list_cluster(i: int, j: int, time: float, world: World) -> bool:
    """List all bodies that touch two, and what they touch; return whether all is known of them."""
    world.counts[tb.CLUSTER] = world.counts[tb.TOUCHINGS] = 0
    add_to_cluster(i, time, world)
    if j != i:
        add_to_cluster(j, time, world)
    n, good = 0, True
    while good and n < world.counts[tb.CLUSTER]:
        good = list_touching(world.cluster[n], time, world)
        n += 1
    return good


def add_to_cluster(k: int, time: float, world: World) -> None:
    """Add a body to those that touch, if it is pushed; where it is, is noted in any case."""
    row = world.standing[k]
    row[0], row[1], row[2], row[3], row[4], row[5] = state_at(k, time, world.paths)
    world.notes[k, tb.STRUCK] = world.notes[k, tb.SUPPORT] = 0
    if is_pushed(k, world):
        world.cluster[world.counts[tb.CLUSTER]] = k
        world.counts[tb.CLUSTER] += 1


def list_touching(k: int, time: float, world: World) -> bool:
    """List what a body touches; return whether all is known of it."""
    if world.notes[k, tb.STALLED] > MOST_REPEATS // 4 or world.bounces[k, tb.WITH] == tb.SEVERAL:
        return False
    a = standing_of(k, world)
    for place in range(gather(k, world)):
        other = world.near[place]
        i, j = min(k, other), max(k, other)
        lasts = world.notes[k, tb.HELD_BY] == other + 1 or world.notes[other, tb.HELD_BY] == k + 1
        if not (lasts or meets(i, j, world)) or is_listed(i, j, world):
            continue
        if (lasts or not is_far(a, k, other, time, world)) and not add_if_touching(
            i, j, lasts, time, world
        ):
            return False
    return True


def is_listed(i: int, j: int, world: World) -> bool:
    """Return whether a pair is among those that touch."""
    found = False
    for t in range(world.counts[tb.TOUCHINGS]):
        found = found or (world.touchings[t, tb.FIRST] == i and world.touchings[t, tb.SECOND] == j)
    return found


def add_if_touching(i: int, j: int, lasts: bool, time: float, world: World) -> bool:
    """List a pair if it touches, and its bodies; return whether there is room, and it is known."""
    a, b = state_at(i, time, world.paths), state_at(j, time, world.paths)
    point, swapped, sided, tolerance = touch_of(i, j, a, b, time, world)
    if tolerance < 0.0:
        gap, tolerance = gap_between(i, a, j, time, world)
        if not lasts:
            return not has_hull(i, j, world) or gap > 2.0 * tolerance
    t = world.counts[tb.TOUCHINGS]
    close = tolerance > MOST_RESOLUTION * min(reach(i, world), reach(j, world))
    if t == len(world.touchings) or close or restitution_of(i, j, world) < 0.0:
        return False
    world.counts[tb.TOUCHINGS] += 1
    note, row = world.touchings[t], world.contacts[t]
    note[tb.FIRST], note[tb.SECOND], note[tb.LASTS], note[tb.COMES] = i, j, 1 if lasts else 0, 0
    note_contact(i, j, a, b, point, swapped, sided, row, world)
    arm_a, arm_b, _ = contact_of(t, world)
    speed = speed_of(a, b, arm_a, arm_b)
    still = speed <= 64 * EPSILON * time * max(load_on_body(i, world), load_on_body(j, world))
    noise = speed if still else speed * (LASTING_NOISE if lasts else 64 * EPSILON)
    row[tb.NOISE], row[tb.SPEED], row[tb.TOLERANCE] = noise, speed, tolerance
    for k in (i, j):
        if not in_cluster(k, world):
            add_to_cluster(k, time, world)
    return True


@inlined
def note_contact(
    i: int,
    j: int,
    a: Moving,
    b: Moving,
    point: Point,
    swapped: int,
    sided: int,
    row: Array,
    world: World,
) -> None:
    """Note where a pair touches, in two states of its bodies."""
    sign = -1.0 if swapped == 1 else 1.0
    arm_a, arm_b = arms(a, b, point, swapped, i, j, world)
    row[tb.NORMAL], row[tb.NORMAL + 1], row[tb.SIGN] = sign * point[0], sign * point[1], sign
    row[tb.CORNER_Q], row[tb.CORNER_Q + 1] = point[2], point[3]
    row[tb.CORNER_P], row[tb.CORNER_P + 1], row[tb.SIDED] = point[4], point[5], sided
    row[tb.ARM_A], row[tb.ARM_A + 1] = arm_a
    row[tb.ARM_B], row[tb.ARM_B + 1] = arm_b


def in_cluster(k: int, world: World) -> bool:
    """Return whether a body is among the pushed bodies that touch."""
    found = False
    for n in range(world.counts[tb.CLUSTER]):
        found = found or world.cluster[n] == k
    return found


def load_on_body(k: int, world: World) -> float:
    """Return the size of the acceleration of a body by its loads, m/s^2."""
    body = world.bodies[k]
    return hypot(body[tb.AX], body[tb.AY]) if is_pushed(k, world) else 0.0


def standing_of(k: int, world: World) -> Moving:
    """Return the state of a body at the instant, as far as it is answered."""
    row = world.standing[k]
    return row[0], row[1], row[2], row[3], row[4], row[5]


# -- impacts


@inlined
def answer_all(world: World) -> bool:
    """Let all that approaches answer, in rounds; return whether that is decided."""
    before = world.counts[tb.IMPACTS]
    come = find_approaching(-inf, world)
    if come < 0 or (come > 0 and not answer_once(world)):
        return False
    come = find_approaching(-inf, world)
    if come == 0:
        return True
    world.counts[tb.RULED] += 1
    quieten(world)
    fastest = 0.0
    for row in range(before, world.counts[tb.IMPACTS]):
        fastest = max(fastest, -world.impacts[row, tb.NORMAL_VELOCITY])
    for _ in range(MOST_ROUNDS):
        come = find_approaching(-LEFT * fastest, world)
        if come <= 0:
            return come == 0
        if not answer_once(world):
            return False
    return False


def find_approaching(limit: float, world: World) -> int:
    """Mark the pairs that approach, and return how many do.

    It is -1 if two of them share a body, or if all are slower than a limit, m/s.
    """
    come, fast = 0, False
    for t in range(world.counts[tb.TOUCHINGS]):
        note, rate = world.touchings[t], rate_at(t, world)
        note[tb.COMES] = 1 if rate < -world.contacts[t, tb.NOISE] else 0
        if note[tb.COMES] == 1:
            come += 1
            fast = fast or rate < limit or limit == -inf
            for s in range(t):
                if world.touchings[s, tb.COMES] == 1 and share_body(s, t, world):
                    return -1
    return come if fast or come == 0 else -1


def share_body(s: int, t: int, world: World) -> bool:
    """Return whether two touching pairs have a body in common that is pushed."""
    one, other, found = world.touchings[s], world.touchings[t], False
    for k in (one[tb.FIRST], one[tb.SECOND]):
        found = found or (is_pushed(k, world) and (k in (other[tb.FIRST], other[tb.SECOND])))
    return found


def answer_once(world: World) -> bool:
    """Let the marked pairs rebound, each alone; return whether they do."""
    good = True
    for t in range(world.counts[tb.TOUCHINGS]):
        note, row = world.touchings[t], world.contacts[t]
        if note[tb.COMES] == 0 or not good:
            continue
        i, j, noise = note[tb.FIRST], note[tb.SECOND], row[tb.NOISE]
        a, b = standing_of(i, world), standing_of(j, world)
        arm_a, arm_b, normal = contact_of(t, world)
        restitution = restitution_of(i, j, world)
        a, b, rate = rebound(a, b, arm_a, arm_b, normal, noise, restitution, i, j, world)
        stand_anew(i, a, world)
        stand_anew(j, b, world)
        room = world.counts[tb.IMPACTS] + MOST_IMPULSES <= len(world.impacts)
        good = rate >= -noise and room
    return good


def stand_anew(k: int, state: Moving, world: World) -> None:
    """Note the state of a body that has been struck."""
    row = world.standing[k]
    row[0], row[1], row[2], row[3], row[4], row[5] = state
    world.notes[k, tb.STRUCK] = 1


def contact_of(t: int, world: World) -> tuple[Pair, Pair, Pair]:
    """Return the arms of both bodies of a touching pair, m, and its normal."""
    row = world.contacts[t]
    arm_a, arm_b = (row[tb.ARM_A], row[tb.ARM_A + 1]), (row[tb.ARM_B], row[tb.ARM_B + 1])
    return arm_a, arm_b, (row[tb.NORMAL], row[tb.NORMAL + 1])


def rate_at(t: int, world: World) -> float:
    """Return how fast a touching pair opens, m/s."""
    a = standing_of(world.touchings[t, tb.FIRST], world)
    b = standing_of(world.touchings[t, tb.SECOND], world)
    arm_a, arm_b, normal = contact_of(t, world)
    return normal_velocity(a, b, arm_a, arm_b, normal)


@inlined
def quieten(world: World) -> None:
    """Take rounding for what it is at the speeds of all bodies that push each other."""
    loudest = 0.0
    for t in range(world.counts[tb.TOUCHINGS]):
        loudest = max(loudest, world.contacts[t, tb.SPEED])
    for t in range(world.counts[tb.TOUCHINGS]):
        row = world.contacts[t]
        row[tb.SPEED], row[tb.NOISE] = loudest, max(row[tb.NOISE], 64 * EPSILON * loudest)


@inlined
def gains(time: float, world: World) -> bool:
    """Return whether the bodies may have more kinetic energy than they came with."""
    before = after = 0.0
    for n in range(world.counts[tb.CLUSTER]):
        k = world.cluster[n]
        came, goes = state_at(k, time, world.paths), standing_of(k, world)
        before += energy_in(k, came, world)
        after += energy_in(k, goes, world)
    return after > (1.0 + GAIN) * before


def energy_in(k: int, state: Moving, world: World) -> float:
    """Return the kinetic energy of a body that is pushed, J."""
    inverse = world.bodies[k, tb.INVERSE_INERTIA]
    inertia = 1.0 / inverse if inverse > 0.0 else 0.0
    mass, velocity = 1.0 / world.bodies[k, tb.INVERSE_MASS], (state[3], state[4])
    return float(definitions.kinetic_energy(mass, velocity, inertia, state[5]))


# -- what goes on


@inlined
def find_support(world: World) -> bool:
    """Find on which half-plane each disc stays, if on one; return whether that is decided."""
    for t in range(world.counts[tb.TOUCHINGS]):
        i, j = world.touchings[t, tb.FIRST], world.touchings[t, tb.SECOND]
        k, plane = (j, i) if world.kinds[i] == tb.PLANE else (i, j)
        if world.kinds[plane] != tb.PLANE or world.kinds[k] != tb.DISC:
            if stays_near(t, True, world):
                return False
        elif stays_near(t, False, world):
            if world.notes[k, tb.SUPPORT] != 0:
                return False
            world.notes[k, tb.SUPPORT] = t + 1
    for t in range(world.counts[tb.TOUCHINGS]):
        for k in (world.touchings[t, tb.FIRST], world.touchings[t, tb.SECOND]):
            support = world.notes[k, tb.SUPPORT] if is_pushed(k, world) else 0
            if support != 0 and support != t + 1 and stays_near(t, True, world):
                return False
    return True


def stays_near(t: int, perhaps: bool, world: World) -> bool:
    """Return whether a touching pair does not part, or next bounces below what float64 resolves.

    Or whether it does so perhaps, whatever else holds its bodies.
    """
    i, j, row = world.touchings[t, tb.FIRST], world.touchings[t, tb.SECOND], world.contacts[t]
    rate, sign = rate_at(t, world), row[tb.SIGN]
    if rate <= row[tb.NOISE]:
        return True
    arm_a, arm_b, normal = contact_of(t, world)
    a, b = standing_of(i, world), standing_of(j, world)
    p, q = (b, a) if sign < 0.0 else (a, b)
    point = (
        sign * normal[0],
        sign * normal[1],
        row[tb.CORNER_Q],
        row[tb.CORNER_Q + 1],
        row[tb.CORNER_P],
        row[tb.CORNER_P + 1],
    )
    sided = 1 if row[tb.SIDED] > 0.0 else 0
    on_points = pressing(arm_a, arm_b, normal, i, j, world)
    opening = opening_acceleration(on_points, p, q, point, sided)
    if perhaps:
        opening = -abs(opening) - 2.0 * (pull_of(i, world) + pull_of(j, world))
    return bool(opening < 0.0 and rest.bounce_height(rate, opening) <= row[tb.TOLERANCE])


def go_on_in(k: int, time: float, world: World) -> bool:
    """Set the path of a body that was struck or has rested; return whether that is decided."""
    held, support, state = (
        world.notes[k, tb.HELD_BY],
        world.notes[k, tb.SUPPORT],
        standing_of(k, world),
    )
    if held == 0 and support == 0 and world.notes[k, tb.STRUCK] == 0:
        return True
    depart(k, time, state, world)
    world.notes[k, tb.HELD_BY] = 0
    world.changed[world.counts[tb.CHANGED]] = k
    world.counts[tb.CHANGED] += 1
    if support == 0:
        return True
    i, j = world.touchings[support - 1, tb.FIRST], world.touchings[support - 1, tb.SECOND]
    lasts, plane = world.touchings[support - 1, tb.LASTS] == 1, j if k == i else i
    return keep(k, plane, state, world.contacts[support - 1, tb.SPEED], lasts, time, world)
