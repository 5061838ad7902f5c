"""Impulses that are told of a step in parts: what a pair is pushed in all of them (P12).

A normal may turn from a part to the next, and so may that of several impacts in flight: a pair is
told one impulse, the sum of all as vectors. That of a part stands by itself until this ends, since
a part may be taken again.
"""

from tamias2d.engine.tables import (
    HAD_MET_IN_FLIGHT,
    IMPACT_NORMAL,
    IS_TOUCHING,
    MET_IN_FLIGHT,
    NX,
    NY,
    PART_PUSH_X,
    PART_PUSH_Y,
    POINT,
    PUSH,
    PX,
    PY,
    SENSES,
    TOUCHES,
    WAS_TOUCHING,
    WORLD_POINT,
    Contacts,
    Integers,
    X,
    Y,
)
from tamias2d.state import Array


def forget_impulses(count: int, contacts: Contacts) -> None:
    """Let the impulses of the parts of a step add up from zero."""
    for p in range(count):
        forget_impulses_of(contacts.manifolds[p])


def forget_impulses_of(manifold: Array) -> None:
    """Let the impulses of a contact add up from zero."""
    manifold[PART_PUSH_X] = manifold[PART_PUSH_Y] = 0.0
    manifold[PUSH] = manifold[PUSH + 1] = 0.0


def add_up_impulses(count: int, contacts: Contacts) -> None:
    """Add the impulses of the part that ends to those of the parts before, in their directions."""
    for p in range(count):
        manifold = contacts.manifolds[p]
        if contacts.flags[p, TOUCHES] & IS_TOUCHING:
            manifold[PUSH] += manifold[PART_PUSH_X]
            manifold[PUSH + 1] += manifold[PART_PUSH_Y]
            manifold[PART_PUSH_X] = manifold[PART_PUSH_Y] = 0.0


def forget_impulses_of_part(first: bool, count: int, contacts: Contacts) -> None:
    """Let contacts not have touched in a part that is taken again, the first one of a step or not.

    In it a sensor is found again, if it was not met in an earlier one.
    """
    for p in range(count):
        manifold, flags = contacts.manifolds[p], contacts.flags[p]
        manifold[PART_PUSH_X] = manifold[PART_PUSH_Y] = 0.0
        if first:
            flags[TOUCHES] &= WAS_TOUCHING + HAD_MET_IN_FLIGHT
        elif flags[SENSES] == 0 and manifold[PUSH] == 0.0 and manifold[PUSH + 1] == 0.0:
            flags[TOUCHES] &= WAS_TOUCHING + MET_IN_FLIGHT + HAD_MET_IN_FLIGHT


def store_impulse_of_part(
    n: int, total: float, pose: Array, manifold: Array, flags: Integers
) -> None:
    """Add the impulse of a point over a part of a step, N s: the next part may part the bodies.

    Where a pair was pushed is told of its last push.
    """
    to = POINT * n
    if flags[TOUCHES] & IS_TOUCHING == 0:
        forget_impulses_of(manifold)
    manifold[PART_PUSH_X] += total * manifold[NX]
    manifold[PART_PUSH_Y] += total * manifold[NY]
    if total > 0.0:
        flags[TOUCHES] |= IS_TOUCHING
        manifold[IMPACT_NORMAL], manifold[IMPACT_NORMAL + 1] = manifold[NX], manifold[NY]
        manifold[WORLD_POINT] = pose[X] + manifold[PX + to]
        manifold[WORLD_POINT + 1] = pose[Y] + manifold[PY + to]
