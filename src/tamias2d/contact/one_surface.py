"""Contacts along one normal that are those of one surface in impacts (IM16, GD20).

Such are pieces of a chain that a body meets, both at a corner, and level ones that it lies across;
and bodies that are welded together and meet another one, at one point or along a face of both.
Piece by piece, friction would be split between contacts of one point, and impulses of equal impacts
would differ; of welded bodies only the sum of impulses at one point is unique.
"""

import math
from collections.abc import Iterable, Sequence

from tamias2d.contact.core import Core
from tamias2d.contact.instant_inputs import InstantInputs
from tamias2d.contact.manifold import Contact
from tamias2d.contact.touching import TouchingPair
from tamias2d.state import Vector

_EQUAL = 1e-9  # sine: by how much rounding may set equal normals apart


def strike_as_one(touching: Iterable[TouchingPair], world: InstantInputs) -> None:
    """Let the first pair of each surface have all of its contacts that take part in impacts."""
    first: list[TouchingPair] = []
    for touch in touching:
        if not any(_may_be_part(world.cores[i]) for i in touch.pair):
            continue
        one = next((one for one in first if _is_one_surface(one, touch, world)), None)
        if one is None:
            first.append(touch)
        else:
            one_point = max(one.tolerance, touch.tolerance)
            one.striking, touch.striking = _ends(one.striking + touch.striking, one_point), []


def _may_be_part(core: Core) -> bool:
    return core.piece is not None or len(core.welded) > 1


def _is_one_surface(one: TouchingPair, other: TouchingPair, world: InstantInputs) -> bool:
    """Return whether pairs have a body and a normal in common, and else parts of a surface."""
    common, parts = set(one.pair) & set(other.pair), set(one.pair) ^ set(other.pair)
    if len(common) != 1:
        return False
    (shared,) = (world.cores[i] for i in common)
    first, second = (world.cores[i] for i in parts)
    welded = first.index in second.welded
    pieces = shared.dynamic and None not in (first.piece, second.piece)
    moving = min(core.bounding_radius for core in (shared, first, second) if core.dynamic)
    return (
        (welded or pieces)
        and world.restitution(*one.pair) == world.restitution(*other.pair)
        and world.friction(*one.pair) == world.friction(*other.pair)
        and _have_one_normal(
            [_outwards(contact, shared) for contact in one.contacts + other.contacts],
            max(one.tolerance, other.tolerance) / moving,
        )
    )


def _outwards(contact: Contact, body: Core) -> Vector:
    """Return the normal of a contact away from one of its bodies."""
    x, y = contact.normal
    return (x, y) if contact.a == body.index else (-x, -y)


def _have_one_normal(normals: Sequence[Vector], rounding: float) -> bool:
    """Return whether normals are equal, but for rounding of the places between which they are."""
    (x, y), *others = normals
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
