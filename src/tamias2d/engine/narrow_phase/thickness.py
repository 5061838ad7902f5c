"""How thin the bodies of a contact are (DD77)."""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies
from tamias2d.generated.soft_contact import extent_thin

NOT_THIN = 2.0**1000  # m, half the width of what does not move freely


def contact_extent(i: int, j: int, radius: float, widths: float, bodies: Bodies) -> float:
    """Return the extent of two bodies, m: a radius, or so many half widths of the thinner one."""
    half = extent_if_free(i, bodies)
    return extent_thin(radius, min(half, extent_if_free(j, bodies)), widths, tb.THINNEST)


def extent_if_free(i: int, bodies: Bodies) -> float:
    """Return half of the least width of a body that moves freely, m; infinite of any other."""
    half: float = bodies.properties[i, tb.MIN_EXTENT]
    return half if bodies.kind[i] == tb.DYNAMIC else NOT_THIN


def half_extent(i: int, bodies: Bodies) -> float:
    """Return half of the least width of a body, m; half of its length where it is thin.

    What is thin knows its side, and may be deep for a while.
    """
    half: float = bodies.properties[i, tb.MIN_EXTENT]
    wide: float = bodies.properties[i, tb.BOUNDING_RADIUS]
    return half if half > tb.THINNEST * wide else wide
