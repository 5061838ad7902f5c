"""Prefetching: a loop that only reads has many cache lines on their way from memory at once."""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Contacts, Integers, Touching
from tamias2d.state import Array

CACHE_LINE_NUMBERS = 8  # in a cache line


def prefetch_blocks(first: int, last: int, blocks: Array, lanes: Integers) -> float:
    """Read a number of each cache line of some blocks; return their sum."""
    total = 0.0
    for b in range(first, last):
        for at in range(0, tb.SHARED + tb.POINT_SIZE * lanes[b, tb.POINTS], CACHE_LINE_NUMBERS):
            total += blocks[b, at]
    return total


def prefetch_manifolds(first: int, last: int, contacts: Contacts, touching: Touching) -> float:
    """Read a number of each of some manifolds, which are listed by slabs; return their sum."""
    total = 0.0
    for place in range(first, last):
        total += contacts.manifolds[touching.contact[touching.by_slab[place]], tb.NX]
    return total
