"""The restitution and the friction of a pair, as `Scene.restitution` and `Scene.friction` say."""

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.tables import World
from tamias2d.generated import definitions


def restitution_of(i: int, j: int, world: World) -> float:
    """Return with which restitution a pair parts; below 0 where nothing states it."""
    place = place_of(i, j, world)
    if place >= 0 and world.laws[place, 0] >= 0.0:
        return float(world.laws[place, 0])
    one, other = world.bodies[i, tb.RESTITUTION], world.bodies[j, tb.RESTITUTION]
    if one < 0.0 or other < 0.0:
        return float(max(one, other))
    return float(definitions.pair_restitution(one, other))


def friction_of(i: int, j: int, world: World) -> float:
    """Return the coefficient of friction of a pair."""
    place = place_of(i, j, world)
    if place >= 0 and world.laws[place, 1] >= 0.0:
        return float(world.laws[place, 1])
    one, other = world.bodies[i, tb.FRICTION], world.bodies[j, tb.FRICTION]
    if one < 0.0 or other < 0.0:
        return float(max(one, other, 0.0))
    return float(definitions.pair_friction(one, other))


def place_of(i: int, j: int, world: World) -> int:
    """Return where a pair is among those with laws of their own, or -1."""
    key, low, high = i * len(world.kinds) + j, 0, len(world.pairs)
    while low < high:
        middle = (low + high) // 2
        if world.pairs[middle] < key:
            low = middle + 1
        else:
            high = middle
    return low if low < len(world.pairs) and world.pairs[low] == key else -1
