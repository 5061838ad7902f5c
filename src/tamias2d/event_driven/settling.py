"""A disc that stays on a half-plane, and slides or rolls along it (GD3, DD85)."""

from tamias2d.contact.constrained_acceleration import along_surface
from tamias2d.contact.manifold import LASTING_NOISE
from tamias2d.contact.rolling_disc import (
    crept,
    held,
    is_pressed,
    rate_of,
    sense_of,
    settled,
    sliding_end,
)
from tamias2d.contact.ruled_instants import MOST_RULED
from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.approach import EPSILON, axis_of_plane, resolution, size_of, state_at
from tamias2d.event_driven.departure import MOST_REPEATS, depart, pull_of
from tamias2d.event_driven.laws import friction_of, restitution_of
from tamias2d.event_driven.length import hypot
from tamias2d.event_driven.tables import Moving, Pair, World
from tamias2d.event_driven.touch import MOST_RESOLUTION
from tamias2d.kernels.assembled import inlined


@inlined
def stay(
    i: int, j: int, a: Moving, b: Moving, arm_a: Pair, arm_b: Pair, normal: Pair, world: World
) -> bool:
    """Let a disc stay on the half-plane that it met in such states; return whether it is so.

    A body with corners is left to others: it may tip.
    """
    if world.kinds[i] == tb.PLANE and world.kinds[j] == tb.DISC:
        return settle(j, i, speed_of_disc(b, arm_b) * (64 * EPSILON), arm_b, normal, world)
    if world.kinds[j] == tb.PLANE and world.kinds[i] == tb.DISC:
        noise, upwards = speed_of_disc(a, arm_a) * (64 * EPSILON), (-normal[0], -normal[1])
        return settle(i, j, noise, arm_a, upwards, world)
    return False


@inlined
def end_sliding(k: int, time: float, world: World) -> bool:
    """Let a disc go on that does not slide any more, and touches nothing else; return whether."""
    plane, a = world.notes[k, tb.HELD_BY] - 1, state_at(k, time, world.paths)
    arm, normal, tolerance = footing(k, plane, a, time, world)
    speed = speed_of_disc(a, arm)
    unclear = tolerance < 0.0 or world.notes[k, tb.STALLED] >= MOST_REPEATS
    unclear = unclear or speed <= 64 * EPSILON * time * pull_of(k, world)
    parts = abs(rate_of((a[3], a[4], a[5]), arm, normal)) > LASTING_NOISE * speed
    if unclear or parts:
        return False
    depart(k, time, a, world)
    return settle(k, plane, speed * (64 * EPSILON), arm, normal, world)


def keep(
    k: int, plane: int, state: Moving, speed: float, lasts: bool, time: float, world: World
) -> bool:
    """Let a disc that starts on its path now stay on a half-plane; return whether it does.

    The speed is that by which slips are judged, m/s; what lasts has been there before.
    """
    body, (arm, normal, _) = world.bodies[k], footing(k, plane, state, time, world)
    coefficient, low = friction_of(min(k, plane), max(k, plane), world), 64 * EPSILON * speed
    if lasts and coefficient > 0.0:
        loads = (body[tb.AX], body[tb.AY], body[tb.TURNING])
        inverses = (body[tb.INVERSE_MASS], body[tb.INVERSE_INERTIA])
        motion, high = (state[3], state[4], state[5]), LASTING_NOISE * speed
        least = sense_of(motion, loads, arm, normal, inverses, coefficient, low, time)
        if least != sense_of(motion, loads, arm, normal, inverses, coefficient, high, time):
            return False  # it depends on whether it has slid before
    return settle(k, plane, low, arm, normal, world)


@inlined
def rests(k: int, world: World) -> bool:
    """Return whether a body rests on a half-plane."""
    return bool(world.notes[k, tb.HELD_BY] > 0)


@inlined
def footing(k: int, plane: int, a: Moving, time: float, world: World) -> tuple[Pair, Pair, float]:
    """Return the arm of a disc to the half-plane on which it rests, and the normal of that.

    Last comes the largest gap that counts as none, m, or -1 where that is too large.
    """
    b, radius = state_at(plane, time, world.paths), world.bodies[k, tb.RADIUS]
    ux, uy, _ = axis_of_plane(world.bodies[plane], a[0] - b[0], a[1] - b[1], radius)
    tolerance = resolution(a, b, radius, size_of(plane, world), time)
    known = tolerance <= MOST_RESOLUTION * radius
    return (0.0 - radius * ux, 0.0 - radius * uy), (ux, uy), tolerance if known else -1.0


@inlined
def settle(k: int, plane: int, noise: float, arm: Pair, normal: Pair, world: World) -> bool:
    """Let a disc that starts on its path now stay on a half-plane; return whether it does.

    A slip up to the noise, m/s, counts as none. Where so many have stayed and a rule has decided
    something, `simulate` may give up.
    """
    path, body = world.paths[k], world.bodies[k]
    loads = (body[tb.AX], body[tb.AY], body[tb.TURNING])
    if not is_pressed(loads, arm, normal):
        return False
    world.notes[k, tb.HELD_BY] = plane + 1
    world.counts[tb.STAYED] += 1
    if world.counts[tb.RULED] > 0 and world.counts[tb.STAYED] > MOST_RULED:
        return False
    i, j = min(k, plane), max(k, plane)
    coefficient = friction_of(i, j, world)
    if coefficient == 0.0:
        path[tb.VX], path[tb.VY] = along_surface((path[tb.VX], path[tb.VY]), normal)
        path[tb.AX], path[tb.AY] = along_surface((body[tb.AX], body[tb.AY]), normal)
        return True
    inverses = (body[tb.INVERSE_MASS], body[tb.INVERSE_INERTIA])
    motion = (path[tb.VX], path[tb.VY], path[tb.SPIN])
    start = path[tb.START]
    sense = sense_of(motion, loads, arm, normal, inverses, coefficient, noise, start)
    ax, ay, turning, sense = held(loads, arm, normal, inverses, coefficient, sense)
    if sense == 0:
        place = (path[tb.X], path[tb.Y], path[tb.TURN])
        restitution = restitution_of(i, j, world)
        path[tb.X], path[tb.Y], path[tb.TURN] = crept(
            place, motion, loads, arm, normal, inverses, restitution
        )
    motion = settled(motion, arm, normal, inverses, coefficient, sense)
    path[tb.VX], path[tb.VY], path[tb.SPIN] = motion
    path[tb.AX], path[tb.AY], path[tb.TURNING] = ax, ay, turning
    world.sliding[k] = sliding_end(start, motion, (ax, ay, turning), arm, normal, sense)
    return True


def speed_of_disc(state: Moving, arm: Pair) -> float:
    """Return the size of the terms that make up the velocity of a disc's contact, m/s."""
    return hypot(state[3], state[4]) + abs(state[5]) * hypot(arm[0], arm[1])
