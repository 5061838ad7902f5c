"""A disc that is struck while it rests on a half-plane: it goes on, leaves, or is driven into it.

Where it is driven into it, what strikes and what holds answer in rounds (A18), as in
`contact.impacts`: pair by pair, until none approaches. Two that approach at a time and act on each
other are not decided here.
"""

from math import inf

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.approach import EPSILON, axis_of, state_at
from tamias2d.event_driven.departure import depart
from tamias2d.event_driven.laws import restitution_of
from tamias2d.event_driven.rebound import MOST_IMPULSES, arms, normal_velocity, rebound, speed_of
from tamias2d.event_driven.settling import rests_within, stay_on
from tamias2d.event_driven.tables import Moving, Pair, World
from tamias2d.generated import definitions, rest
from tamias2d.kernels.assembled import inlined

MOST_ROUNDS = 64
LEFT = 1e-9  # of the first approach: a slower one is closed without restitution, elsewhere
GAIN = 5e-10  # of the energy: where rounds add more, they may have made some


@inlined
def strike(
    i: int,
    j: int,
    came: tuple[Moving, Moving],
    struck: tuple[Moving, Moving],
    arm_a: Pair,
    arm_b: Pair,
    normal: Pair,
    noise: float,
    tolerance: float,
    most: float,
    before: int,
    time: float,
    world: World,
) -> bool:
    """Let two discs of which one rests at least, and that have rebound, go on; return whether.

    They came in some states, and are in others; a slower approach than the noise, m/s, is none, and
    a lower bounce than the tolerance, m. At most so large is the acceleration of their gap, m/s^2.
    The impacts from `before` on are theirs.
    """
    (noise_i, speed_i), (noise_j, speed_j) = (
        rests_within(i, came[0], time, world),
        rests_within(j, came[1], time, world),
    )
    if noise_i < 0.0 or noise_j < 0.0:
        return False
    a, b = struck
    if is_driven(i, a, noise_i, time, world) or is_driven(j, b, noise_j, time, world):
        loudest = max(speed_of(came[0], came[1], arm_a, arm_b), speed_i, speed_j)
        speed_i, speed_j, least = loudest, loudest, 64 * EPSILON * loudest
        noise, noise_i, noise_j = max(noise, least), max(noise_i, least), max(noise_j, least)
        a, b, ended = answer(
            i, j, a, b, arm_a, arm_b, normal, noise, noise_i, noise_j, before, time, world
        )
        if not ended or energy_of(i, j, a, b, world) > (1.0 + GAIN) * energy_of(
            i, j, came[0], came[1], world
        ):
            return False
        world.counts[tb.RULED] += 1
    rate = normal_velocity(a, b, arm_a, arm_b, normal)
    if rate <= noise or rest.bounce_height(rate, -most) <= tolerance:
        return False
    depart(i, time, a, world)
    depart(j, time, b, world)
    return stay_on(i, came[0], time, noise_i, speed_i, world) and stay_on(
        j, came[1], time, noise_j, speed_j, world
    )


@inlined
def answer(
    i: int,
    j: int,
    a: Moving,
    b: Moving,
    arm_a: Pair,
    arm_b: Pair,
    normal: Pair,
    noise: float,
    noise_i: float,
    noise_j: float,
    before: int,
    time: float,
    world: World,
) -> tuple[Moving, Moving, bool]:
    """Let two discs and what they rest on answer until none approaches.

    Returns both states, and whether that is decided.
    """
    fastest = 0.0
    for row in range(before, world.counts[tb.IMPACTS]):
        fastest = max(fastest, -world.impacts[row, tb.NORMAL_VELOCITY])
    limit = -LEFT * fastest
    for _ in range(MOST_ROUNDS):
        rate = normal_velocity(a, b, arm_a, arm_b, normal)
        rate_i, rate_j = rate_on(i, a, time, world), rate_on(j, b, time, world)
        meets, on_i, on_j = rate < -noise, rate_i < -noise_i, rate_j < -noise_j
        if not (meets or on_i or on_j):
            return a, b, True
        both = meets and (on_i or on_j)
        if both or min(rate, rate_i, rate_j) >= limit:
            return a, b, False
        if world.counts[tb.IMPACTS] + 2 * MOST_IMPULSES > len(world.impacts):
            return a, b, False
        if meets:
            restitution = restitution_of(i, j, world)
            a, b, _ = rebound(a, b, arm_a, arm_b, normal, noise, restitution, i, j, world)
        if on_i:
            a = rebound_from(i, a, noise_i, time, world)
        if on_j:
            b = rebound_from(j, b, noise_j, time, world)
    return a, b, False


@inlined
def is_driven(k: int, state: Moving, noise: float, time: float, world: World) -> bool:
    """Return whether a disc approaches the half-plane on which it rests, if it rests on one."""
    return rate_on(k, state, time, world) < -noise


def rate_on(k: int, state: Moving, time: float, world: World) -> float:
    """Return how fast a disc leaves the half-plane on which it rests, m/s; infinite for none."""
    plane = world.notes[k, tb.HELD_BY] - 1
    if plane < 0:
        return inf
    a, b, arm_a, arm_b, normal = contact_on(k, plane, state, time, world)
    return normal_velocity(a, b, arm_a, arm_b, normal)


def rebound_from(k: int, state: Moving, noise: float, time: float, world: World) -> Moving:
    """Return the state of a disc after it rebounds from the half-plane on which it rests."""
    plane = world.notes[k, tb.HELD_BY] - 1
    i, j = min(k, plane), max(k, plane)
    a, b, arm_a, arm_b, normal = contact_on(k, plane, state, time, world)
    restitution = restitution_of(i, j, world)
    a, b, _ = rebound(a, b, arm_a, arm_b, normal, noise, restitution, i, j, world)
    return a if k == i else b


def contact_on(
    k: int, plane: int, state: Moving, time: float, world: World
) -> tuple[Moving, Moving, Pair, Pair, Pair]:
    """Return the states of a disc and a half-plane, their arms, m, and the normal, as a pair."""
    other, i, j = state_at(plane, time, world.paths), min(k, plane), max(k, plane)
    a, b = (state, other) if k == i else (other, state)
    ux, uy, _, swapped = axis_of(a, b, i, j, world)
    sign = -1.0 if swapped == 1 else 1.0
    point = (ux, uy, 0.0, 0.0, 0.0, 0.0)
    arm_a, arm_b = arms(a, b, point, swapped, i, j, world)
    return a, b, arm_a, arm_b, (sign * ux, sign * uy)


@inlined
def energy_of(i: int, j: int, a: Moving, b: Moving, world: World) -> float:
    """Return the kinetic energy of two discs, J, of which none is fixed."""
    return energy_in(i, a, world) + energy_in(j, b, world)


def energy_in(k: int, state: Moving, world: World) -> float:
    """Return the kinetic energy of a body in a state, J; none for a fixed one."""
    mass, inertia = world.bodies[k, tb.INVERSE_MASS], world.bodies[k, tb.INVERSE_INERTIA]
    if mass == 0.0:
        return 0.0
    turning = 1.0 / inertia if inertia > 0.0 else 0.0
    return float(definitions.kinetic_energy(1.0 / mass, (state[3], state[4]), turning, state[5]))
