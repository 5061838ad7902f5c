"""How the surfaces of two shapes mix: by the rules of the scene, or as was set for the pair.

Serves: contacts, and impacts in flight. Hides: how what was set is found.
"""

from tamias2d.generated.definitions import pair_friction, pair_restitution
from tamias2d.state import Array
from tamias2d.stepped.layout import FRICTION, RESTITUTION


def surfaces_of(s: int, t: int, surface: Array, mixed: Array) -> tuple[float, float]:
    """Return the friction and the restitution of two shapes.

    `mixed` (k, 4) holds what was set for pairs, by the lower shape and then by the other one: both,
    friction, restitution; -1 where that was not set.
    """
    friction = both_friction(surface[s, FRICTION], surface[t, FRICTION])
    restitution = both_restitution(surface[s, RESTITUTION], surface[t, RESTITUTION])
    k = place_of(min(s, t), max(s, t), mixed)
    if k < len(mixed):
        friction = mixed[k, 2] if mixed[k, 2] >= 0.0 else friction
        restitution = mixed[k, 3] if mixed[k, 3] >= 0.0 else restitution
    return friction, restitution


def place_of(s: int, t: int, mixed: Array) -> int:
    """Return in which row something was set for a pair; the number of rows where nothing was."""
    low, high = 0, len(mixed)
    while low < high:
        middle = (low + high) // 2
        if mixed[middle, 0] < s or (mixed[middle, 0] == s and mixed[middle, 1] < t):
            low = middle + 1
        else:
            high = middle
    here = low < len(mixed) and mixed[low, 0] == s and mixed[low, 1] == t
    return low if here else len(mixed)


def both_friction(first: float, second: float) -> float:
    """Return the friction of two surfaces; -1 where one states none, and 0 if neither does."""
    if first < 0.0 or second < 0.0:
        return max(first, second, 0.0)
    return pair_friction(first, second)


def both_restitution(first: float, second: float) -> float:
    """Return the restitution of two surfaces; -1 where one states none, and 0 if neither does."""
    if first < 0.0 or second < 0.0:
        return max(first, second, 0.0)
    return pair_restitution(first, second)
