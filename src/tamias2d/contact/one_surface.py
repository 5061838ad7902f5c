"""Pieces of a chain that a body meets along one normal: in impacts they are one surface (IM16).

Such are both pieces at a corner, and level ones that a body lies across. Piece by piece, friction
would be split between contacts of one point, and impulses of equal impacts would differ.
"""

import math
from collections.abc import Iterable, Sequence

from tamias2d.contact.instant_inputs import InstantInputs
from tamias2d.contact.manifold import Contact
from tamias2d.contact.touching import TouchingPair

_EQUAL = 1e-9  # sine: by how much rounding may set equal normals apart


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
            one_point = max(one.tolerance, touch.tolerance)
            one.striking, touch.striking = _ends(one.striking + touch.striking, one_point), []


def _is_one_surface(one: TouchingPair, other: TouchingPair, world: InstantInputs) -> bool:
    """Return whether pairs have a moving body, a surface and a normal in common."""
    moving = [i for i in set(one.pair) & set(other.pair) if world.cores[i].dynamic]
    return (
        bool(moving)
        and world.restitution(*one.pair) == world.restitution(*other.pair)
        and world.friction(*one.pair) == world.friction(*other.pair)
        and _have_one_normal(
            one.contacts + other.contacts,
            max(one.tolerance, other.tolerance) / world.cores[moving[0]].bounding_radius,
        )
    )


def _have_one_normal(contacts: Sequence[Contact], rounding: float) -> bool:
    """Return whether normals are equal, but for rounding of the places between which they are."""
    (x, y), *others = (contact.normal for contact in contacts)
    most = max(_EQUAL, rounding)
    return all(x * u + y * v > 0 and abs(x * v - y * u) <= most for u, v in others)


def _ends(contacts: Sequence[Contact], one_point: float) -> list[Contact]:
    """Return the two ends of contacts with one normal, or one of them if these are one point.

    So they are if they are no farther apart than a length, m.
    """
    x, y = contacts[0].normal
    low, *_, high = sorted(contacts, key=lambda each: each.point[1] * x - each.point[0] * y)
    apart = math.dist(low.point, high.point)
    return [low, high] if apart > one_point else [low]
