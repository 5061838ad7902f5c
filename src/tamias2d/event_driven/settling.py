"""A disc that stays on a half-plane, and slides or rolls along it (GD3, DD85)."""

from tamias2d.contact.constrained_acceleration import along_surface
from tamias2d.contact.manifold import LASTING_NOISE
from tamias2d.contact.rolling_disc import (
    crept,
    held,
    is_pressed,
    load_on,
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
from tamias2d.event_driven.touch import MOST_RESOLUTION, touches_third
from tamias2d.generated import rest
from tamias2d.kernels.assembled import inlined


@inlined
def stay(
    i: int, j: int, a: Moving, b: Moving, arm_a: Pair, arm_b: Pair, normal: Pair, world: World
) -> bool:
    """Let a disc stay on the half-plane that it met in such states; return whether it is so."""
    if world.kinds[i] == tb.PLANE:
        return settle(j, i, speed_of_disc(b, arm_b) * (64 * EPSILON), arm_b, normal, world)
    if world.kinds[j] == tb.PLANE:
        noise, upwards = speed_of_disc(a, arm_a) * (64 * EPSILON), (-normal[0], -normal[1])
        return settle(i, j, noise, arm_a, upwards, world)
    return False


@inlined
def end_sliding(k: int, time: float, world: World) -> bool:
    """Let a disc go on that does not slide any more; return whether that is all that happens."""
    plane, a = world.notes[k, tb.HELD_BY] - 1, state_at(k, time, world.paths)
    arm, normal, tolerance = footing(k, plane, a, time, world)
    speed = speed_of_disc(a, arm)
    unclear = tolerance < 0.0 or world.notes[k, tb.STALLED] >= MOST_REPEATS
    unclear = unclear or speed <= 64 * EPSILON * time * pull_of(k, world)
    parts = abs(rate_of((a[3], a[4], a[5]), arm, normal)) > LASTING_NOISE * speed
    if unclear or parts or touches_third(k, k, time, world):
        return False
    depart(k, time, a, world)
    return settle(k, plane, speed * (64 * EPSILON), arm, normal, world)


def stay_on(k: int, before: Moving, time: float, noise: float, speed: float, world: World) -> bool:
    """Let a disc that has just been struck stay where it rests, if it does, or leave it.

    Return whether that is all that happens. `before` is its state before it was struck; a normal
    velocity up to the noise, m/s, counts as none, and the speed is that by which slips are judged.
    """
    plane = world.notes[k, tb.HELD_BY] - 1
    if plane < 0:
        return True
    path, body = world.paths[k], world.bodies[k]
    arm, normal, tolerance = footing(k, plane, before, time, world)
    motion = (path[tb.VX], path[tb.VY], path[tb.SPIN])
    rate = rate_of(motion, arm, normal)
    if tolerance < 0.0 or rate < -noise:
        return False
    loads = (body[tb.AX], body[tb.AY], body[tb.TURNING])
    world.notes[k, tb.HELD_BY] = 0
    if rate > noise and rest.bounce_height(rate, load_on(loads, arm, normal)) > tolerance:
        return True
    coefficient = friction_of(min(k, plane), max(k, plane), world)
    if coefficient > 0.0:
        inverses = (body[tb.INVERSE_MASS], body[tb.INVERSE_INERTIA])
        low, high = 64 * EPSILON * speed, LASTING_NOISE * speed
        least = sense_of(motion, loads, arm, normal, inverses, coefficient, low, time)
        if least != sense_of(motion, loads, arm, normal, inverses, coefficient, high, time):
            return False  # it depends on whether it has slid before
    return settle(k, plane, speed * (64 * EPSILON), arm, normal, world)


@inlined
def rests_within(k: int, before: Moving, time: float, world: World) -> tuple[float, float]:
    """Return by how much a disc at rest may be off it, m/s, and the speed by which that is judged.

    The first is below 0 where it is more off than that, and both are 0 where it does not rest.
    """
    plane, body = world.notes[k, tb.HELD_BY] - 1, world.bodies[k]
    if plane < 0:
        return 0.0, 0.0
    arm, normal, _ = footing(k, plane, before, time, world)
    speed, pull = speed_of_disc(before, arm), hypot(body[tb.AX], body[tb.AY])
    noise = speed if speed <= 64 * EPSILON * time * pull else LASTING_NOISE * speed
    off = abs(rate_of((before[3], before[4], before[5]), arm, normal)) > noise
    return -1.0 if off else noise, speed


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
