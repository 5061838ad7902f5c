"""Friction, restitution and surface speed of two shapes, as stated for them or for the pair."""

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.chain import known_side, seen_from
from tamias2d.engine.narrow_phase.core import core_of
from tamias2d.engine.tables import Shapes
from tamias2d.generated.definitions import pair_friction, pair_restitution
from tamias2d.generated.soft_contact import surface_speed_both
from tamias2d.state import Array, Vector

BOUNCY = 0.7  # restitution that gives half of the energy back


def mixed_material(s: int, t: int, material: Array, overrides: Array) -> tuple[float, float]:
    """Return the friction and the restitution of two shapes.

    `overrides` (k, 4) holds what was set for pairs, sorted: the lower shape, the other one,
    friction, restitution; -1 where that was not set. Cost: the logarithm of its length.
    """
    friction = mixed_friction(material[s, tb.FRICTION], material[t, tb.FRICTION])
    restitution = mixed_restitution(material[s, tb.RESTITUTION], material[t, tb.RESTITUTION])
    k = override_of(min(s, t), max(s, t), overrides)
    if k < len(overrides):
        friction = overrides[k, 2] if overrides[k, 2] >= 0.0 else friction
        restitution = overrides[k, 3] if overrides[k, 3] >= 0.0 else restitution
    return friction, restitution


def runs(s: int, t: int, shapes: Shapes) -> bool:
    """Return whether the surface of one of two shapes runs."""
    of_s, of_t = shapes.material[s, tb.SURFACE_SPEED], shapes.material[t, tb.SURFACE_SPEED]
    return bool((of_s != 0.0) | (of_t != 0.0))


def mixed_surface_speed(s: int, t: int, normal: Vector, shapes: Shapes) -> float:
    """Return the speed at which the surfaces of two shapes run along their tangent, m/s (DD97).

    The normal leads from the first one to the other.
    """
    nx, ny = normal
    of_s, of_t = surface_speed(s, (nx, ny), shapes), surface_speed(t, (-nx, -ny), shapes)
    return surface_speed_both(of_s, of_t)


def surface_speed(s: int, out: Vector, shapes: Shapes) -> float:
    """Return the speed at which a surface runs counter-clockwise where a normal leads out, m/s.

    A chain that is solid from both sides runs along its vertices on each: on its left one, which
    is seen from the other side, that is clockwise.
    """
    speed = shapes.material[s, tb.SURFACE_SPEED]
    if speed == 0.0 or shapes.kind[s] != tb.PIECE:
        return float(speed)
    piece, vertices = core_of(s, shapes), shapes.world_vertices
    right = seen_from(0, s, piece, vertices, shapes)
    left = seen_from(1, s, piece, vertices, shapes)
    return float(-speed if known_side(out[0], out[1], right, left) == -1 else speed)


def override_of(s: int, t: int, overrides: Array) -> int:
    """Return the row that was set for a pair, or the number of rows if there is none."""
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
    """Return the friction of two surfaces. Where one states none, -1, the other's counts."""
    if first < 0.0 or second < 0.0:
        return max(first, second, 0.0)
    return pair_friction(first, second)


def mixed_restitution(first: float, second: float) -> float:
    """Return the restitution of two surfaces. Where one states none, -1, the other's counts."""
    if first < 0.0 or second < 0.0:
        return max(first, second, 0.0)
    return pair_restitution(first, second)
