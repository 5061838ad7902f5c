"""How the surfaces of two shapes mix: by the rules of the scene, or as was set for the pair.

Serves: contacts, and impacts in flight. Hides: how what was set is found.
"""

from tamias2d.engine.tables import FRICTION, RESTITUTION
from tamias2d.generated.definitions import pair_friction, pair_restitution
from tamias2d.state import Array


def mixed_material(s: int, t: int, material: Array, overrides: Array) -> tuple[float, float]:
    """Return the friction and the restitution of two shapes.

    `mixed` (k, 4) holds what was set for pairs, by the lower shape and then by the other one: both,
    friction, restitution; -1 where that was not set.
    """
    friction = mixed_friction(material[s, FRICTION], material[t, FRICTION])
    restitution = mixed_restitution(material[s, RESTITUTION], material[t, RESTITUTION])
    k = override_of(min(s, t), max(s, t), overrides)
    if k < len(overrides):
        friction = overrides[k, 2] if overrides[k, 2] >= 0.0 else friction
        restitution = overrides[k, 3] if overrides[k, 3] >= 0.0 else restitution
    return friction, restitution


def override_of(s: int, t: int, overrides: Array) -> int:
    """Return in which row something was set for a pair; the number of rows where nothing was."""
    low, high = 0, len(overrides)
    while low < high:
        middle = (low + high) // 2
        if overrides[middle, 0] < s or (overrides[middle, 0] == s and overrides[middle, 1] < t):
            low = middle + 1
        else:
            high = middle
    here = low < len(overrides) and overrides[low, 0] == s and overrides[low, 1] == t
    return low if here else len(overrides)


def mixed_friction(first: float, second: float) -> float:
    """Return the friction of two surfaces; -1 where one states none, and 0 if neither does."""
    if first < 0.0 or second < 0.0:
        return max(first, second, 0.0)
    return pair_friction(first, second)


def mixed_restitution(first: float, second: float) -> float:
    """Return the restitution of two surfaces; -1 where one states none, and 0 if neither does."""
    if first < 0.0 or second < 0.0:
        return max(first, second, 0.0)
    return pair_restitution(first, second)
