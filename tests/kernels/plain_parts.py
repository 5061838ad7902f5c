"""Functions to assemble: as an engine's modules are, on constants, other modules and each other."""

from math import cos
from typing import NamedTuple

from tamias2d.generated import impact
from tamias2d.generated.translation import acceleration as pulled
from tamias2d.kernels.arrays import FloatRows
from tamias2d.kernels.assembled import for_each, inlined, separate
from tamias2d.spec.functions import largest, least, sqrt

LANES = 16
HALF = 0.5


@separate
def halved(number: float) -> float:
    """Half of a number.

    This is not copied.

    Source: DD1.
    """
    result: float = number * HALF  # a comment stays
    return result


@inlined
def clamped(number: float, low: float, high: float) -> float:
    return least(largest(number, low), high)


def pushed(rows: FloatRows, count: int) -> float:
    """Work on blocks of lanes."""
    greatest = 0.0
    for block in range(count):
        row = rows[block]
        for lane in range(LANES):
            normal_velocity = halved(row[lane])
            push = impact.impulse(HALF, normal_velocity, row[LANES + lane])
            row[2 * LANES + lane] = clamped(push, 0.0, row[LANES + lane])
            greatest = largest(greatest, push)
    return sqrt(greatest)


def fallen(rows: FloatRows, time: float) -> None:
    """Turn and pull every row."""
    for k in range(rows.shape[0]):
        row = rows[k]
        pull = pulled((cos(time), 0.0), (row[0], row[1]), HALF)
        row[0] += pull[0]
        row[1] = halved(pull[1])


class Heap(NamedTuple):
    """A group of arrays."""

    rows: FloatRows


@for_each
def heaped(heap: Heap, count: int) -> int:
    """Add to all numbers of a heap; return how many rows it has."""
    for k in range(len(heap.rows)):
        heap.rows[k, 0] += count
    return len(heap.rows)
