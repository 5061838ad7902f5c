"""Pieces of a chain that a body meets along one normal: in impacts they are one surface (IM16).

Such are both pieces at a corner, and level ones that a body lies across. Pieces by pieces, friction
would be split between contacts of one point, and impulses of equal impacts would differ.
"""

from collections.abc import Iterable, Sequence

from tamias2d.contact.instant_inputs import InstantInputs
from tamias2d.contact.manifold import Contact
from tamias2d.contact.touching import TouchingPair

_EQUAL = 1e-9  # of directions and points: by how much rounding may set equal ones apart


def strike_as_one(touching: Iterable[TouchingPair], world: InstantInputs) -> None:
    """Let the first pair of each surface have all of its contacts that take part in impacts."""
    first: list[TouchingPair] = []
    for touch in touching:
        if all(world.cores[i].piece is None for i in touch.pair):
            continue
        one = next((one for one in first if _is_one_surface(one, touch, world)), None)
        if one is None:
            first.append(touch)
        else:
            one.striking, touch.striking = _ends(one.striking + touch.striking), []


def _is_one_surface(one: TouchingPair, other: TouchingPair, world: InstantInputs) -> bool:
    """Return whether pairs have a moving body, a surface and a normal in common."""
    moving = set(one.pair) & set(other.pair)
    return (
        any(world.cores[i].dynamic for i in moving)
        and world.restitution(*one.pair) == world.restitution(*other.pair)
        and world.friction(*one.pair) == world.friction(*other.pair)
        and _have_one_normal(one.contacts + other.contacts)
    )


def _have_one_normal(contacts: Sequence[Contact]) -> bool:
    (x, y), *others = (contact.normal for contact in contacts)
    return all(x * u + y * v > 0 and abs(x * v - y * u) <= _EQUAL for u, v in others)


def _ends(contacts: Sequence[Contact]) -> list[Contact]:
    """Return the two ends of contacts with one normal, or one contact if all are at one point."""
    x, y = contacts[0].normal
    low, *_, high = sorted(contacts, key=lambda each: each.point[1] * x - each.point[0] * y)
    (ax, ay), (bx, by) = low.point, high.point
    size = max(map(abs, (ax, ay, bx, by)))
    return [low, high] if abs(bx - ax) + abs(by - ay) > _EQUAL * size else [low]
