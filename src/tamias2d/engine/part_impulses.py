"""Impulses that are told of a step in parts: what a pair is pushed in all of them (P12).

A normal may turn from a part to the next, and so may that of several impacts in flight: a pair is
told one impulse, the sum of all as vectors. That of a part stands by itself until this ends, since
a part may be taken again. Of a contact whose bodies sleep is told what it was when these fell
asleep, in whatever parts others are solved.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.islands import both_sleep
from tamias2d.engine.tables import Contacts, Integers, Islands
from tamias2d.state import Array


def forget_impulses(count: int, contacts: Contacts, islands: Islands) -> None:
    """Let the impulses of the parts of a step add up from zero."""
    for p in range(count):
        pair = contacts.pairs[p]
        if not both_sleep(pair[tb.SLOT_A], pair[tb.SLOT_B], islands):
            forget_impulses_of(contacts.manifolds[p])


def forget_earlier(in_parts: bool, manifold: Array, flags: Integers) -> bool:
    """Let impulses add up from zero if none is of this step; return whether none is.

    A contact that slept through earlier parts touches, and has had none in them.
    """
    first = flags[tb.TOUCHES] & tb.IS_TOUCHING == 0 or (in_parts and flags[tb.IN_PARTS] == 0)
    if first:
        forget_impulses_of(manifold)
        flags[tb.IN_PARTS] = 1 if in_parts else 0
    return bool(first)


def forget_impulses_of(manifold: Array) -> None:
    """Let the impulses of a contact add up from zero."""
    forget_impulses_since(manifold)
    manifold[tb.PUSH] = manifold[tb.PUSH + 1] = 0.0
    manifold[tb.FRICTION_BEFORE] = manifold[tb.FRICTION_BEFORE + 1] = 0.0


def add_up_impulses(count: int, contacts: Contacts) -> None:
    """Add the impulses of the part that ends to those of the parts before, in their directions."""
    for p in range(count):
        manifold, flags = contacts.manifolds[p], contacts.flags[p]
        if flags[tb.TOUCHES] & tb.IS_TOUCHING and flags[tb.IN_PARTS] == 1:
            manifold[tb.PUSH] += manifold[tb.PART_PUSH_X]
            manifold[tb.PUSH + 1] += manifold[tb.PART_PUSH_Y]
            manifold[tb.FRICTION_BEFORE] += manifold[tb.PART_FRICTION_X]
            manifold[tb.FRICTION_BEFORE + 1] += manifold[tb.PART_FRICTION_Y]
            forget_impulses_since(manifold)


def forget_impulses_since(manifold: Array) -> None:
    """Let the impulses of a part add up from zero."""
    manifold[tb.PART_PUSH_X] = manifold[tb.PART_PUSH_Y] = 0.0
    manifold[tb.PART_FRICTION_X] = manifold[tb.PART_FRICTION_Y] = 0.0


def forget_impulses_of_part(first: bool, count: int, contacts: Contacts, islands: Islands) -> None:
    """Let contacts not have touched in a part that is taken again, the first one of a step or not.

    In it a sensor is found again, if it was not met before.
    """
    for p in range(count):
        manifold, flags, pair = contacts.manifolds[p], contacts.flags[p], contacts.pairs[p]
        if both_sleep(pair[tb.SLOT_A], pair[tb.SLOT_B], islands):
            continue
        forget_impulses_since(manifold)
        if first:
            flags[tb.TOUCHES] &= tb.WAS_TOUCHING + tb.HAD_MET_IN_FLIGHT
        elif flags[tb.SENSES] == 1 and flags[tb.LOCATED] > 0:  # passed in the flight of this part
            flags[tb.TOUCHES] &= tb.WAS_TOUCHING
        elif flags[tb.SENSES] == 0 and manifold[tb.PUSH] == 0.0 and manifold[tb.PUSH + 1] == 0.0:
            flags[tb.TOUCHES] &= tb.WAS_TOUCHING + tb.MET_IN_FLIGHT + tb.HAD_MET_IN_FLIGHT


def store_impulse_of_part(
    n: int, total: float, friction: float, pose: Array, manifold: Array, flags: Integers
) -> None:
    """Add the impulses of a point over a part of a step, N s: the next part may part the bodies.

    Where a pair was pushed is told of its last push.
    """
    to = tb.POINT * n
    forget_earlier(True, manifold, flags)
    manifold[tb.PART_PUSH_X] += total * manifold[tb.NX]
    manifold[tb.PART_PUSH_Y] += total * manifold[tb.NY]
    manifold[tb.PART_FRICTION_X] -= friction * manifold[tb.NY]
    manifold[tb.PART_FRICTION_Y] += friction * manifold[tb.NX]
    if total > 0.0:
        flags[tb.TOUCHES] |= tb.IS_TOUCHING
        manifold[tb.IMPACT_NORMAL], manifold[tb.IMPACT_NORMAL + 1] = (
            manifold[tb.NX],
            manifold[tb.NY],
        )
        manifold[tb.WORLD_POINT] = pose[tb.X] + manifold[tb.PX + to]
        manifold[tb.WORLD_POINT + 1] = pose[tb.Y] + manifold[tb.PY + to]
