"""Where two sides that face each other touch: the ends of what they have in common.

Serves: manifolds. Hides: clipping, and which two corners are nearest where nothing is in common.

Along the leading side, from its first corner v1 to v2 at `length`, the other side runs from w1
down to w2. What they have in common has an end at v1 or w2 and one at v2 or w1: these pairs of
corners name the two points whichever of the sides leads and whichever of the corners is the end,
so that a point keeps its name, and with it its impulses, while bodies rock and slide.
"""

from math import sqrt

from tamias2d.engine.tables import GAP, NX, NY, POINT, PX, PY
from tamias2d.state import Array

NAMES = 1 << 15  # more than the corners of a shape
PARALLEL = 2.0**-6  # of one side's slope to the other: as if parallel; errs by 2**-13 of the gap
TINY = 1e-290  # m^2, for no size: below, squares of lengths are not exact enough for a direction


def touch_sides(
    row: Array,
    first_p: int,
    p1: int,
    p2: int,
    first_q: int,
    q1: int,
    q2: int,
    x: float,
    y: float,
    radius_p: float,
    radius_q: float,
    margin: float,
    bare: bool,
    swapped: bool,
    vertices: Array,
) -> tuple[int, int]:
    """Write the points between a leading side and a facing one to a row of `touch`.

    P's leading side has the corners p1 and p2, Q's facing one q1 and q2; Q's centre is at (x, y)
    from P's, m; `swapped` says that P is B, `bare` that both are lines without sides at their
    ends. Return the names of the points, 0 for one that is not nearer than the margin, m.
    """
    nx, ny = vertices[first_p + p1, 2], vertices[first_p + p1, 3]
    vx, vy = vertices[first_p + p1, 0], vertices[first_p + p1, 1]
    x1, y1 = vertices[first_q + q1, 0] + (x - vx), vertices[first_q + q1, 1] + (y - vy)
    x2, y2 = vertices[first_q + q2, 0] + (x - vx), vertices[first_q + q2, 1] + (y - vy)
    length = nx * (vertices[first_p + p2, 1] - vy) - ny * (vertices[first_p + p2, 0] - vx)
    gap1, gap2 = nx * x1 + ny * y1, nx * x2 + ny * y2
    along1, along2 = nx * y1 - ny * x1, nx * y2 - ny * x2
    low = along2 if along2 > 0.0 else 0.0
    high = along1 if along1 < length else length
    if swapped:
        vx, vy = vx - x, vy - y
    room = gap1 if gap1 < gap2 else gap2
    if room >= 0.0 or bare:
        which = nearest_corners(along1, gap1, along2, gap2, length)
        if which > 0 and (room >= 0.0 or high < low):
            at = length if which > 2 else 0.0
            first = which == 2 or which == 3
            beside = (along1 if first else along2) - at
            across = gap1 if first else gap2
            found = touch_corners(
                row, nx, ny, vx, vy, at, beside, across, radius_p, radius_q, margin, swapped
            )
            p, q = p2 if which > 2 else p1, q1 if first else q2
            return name_of(p, q, swapped) if found else 0, 0
    if high < low or along1 <= along2:  # nothing in common: the deepest corner alone
        low = high = along1 if gap1 < gap2 else along2
        gap_low, gap_high = room, 1e308
    else:
        span = along1 - along2
        gap_low = gap2 + (gap1 - gap2) * ((low - along2) / span)
        gap_high = gap1 + (gap2 - gap1) * ((along1 - high) / span) if high > low else 1e308
    radii = radius_p + radius_q
    uneven = radius_p - radius_q
    row[NX] = -nx if swapped else nx
    row[NY] = -ny if swapped else ny
    name = 0
    other = 0
    if gap_low - radii < margin:
        middle = 0.5 * (gap_low + uneven)
        row[PX] = vx + nx * middle - ny * low
        row[PY] = vy + ny * middle + nx * low
        row[GAP] = gap_low - radii
        name = name_of(p1, q2, swapped)
    if gap_high - radii < margin:
        k = POINT if name > 0 else 0
        middle = 0.5 * (gap_high + uneven)
        row[PX + k] = vx + nx * middle - ny * high
        row[PY + k] = vy + ny * middle + nx * high
        row[GAP + k] = gap_high - radii
        other = name_of(p2, q1, swapped)
        if name == 0:
            name, other = other, 0
    return name, other


def touch_corners(
    row: Array,
    nx: float,
    ny: float,
    vx: float,
    vy: float,
    at: float,
    beside: float,
    across: float,
    radius_p: float,
    radius_q: float,
    margin: float,
    swapped: bool,
) -> bool:
    """Write the point between two corners to a row of `touch`, if they are within the margin.

    P's corner is `at` from v along its side with normal n, Q's is `beside` and `across` from that.
    """
    square = beside * beside + across * across
    distance = sqrt(square)
    gap = distance - radius_p - radius_q
    if gap >= margin:
        return False
    ux, uy = nx, ny
    if square > TINY:
        ux, uy = (nx * across - ny * beside) / distance, (ny * across + nx * beside) / distance
    row[NX] = -ux if swapped else ux
    row[NY] = -uy if swapped else uy
    middle = 0.5 * (distance + radius_p - radius_q)
    row[PX] = vx - ny * at + ux * middle
    row[PY] = vy + nx * at + uy * middle
    row[GAP] = gap
    return True


def nearest_corners(along1: float, gap1: float, along2: float, gap2: float, length: float) -> int:
    """Return which corners are nearest: 1 v1 and w2, 2 v1 and w1, 3 v2 and w1, 4 v2 and w2.

    0 where the inside of a side is nearest, or nearly so: of sides that are almost parallel and
    beside each other both ends count, since what lies in line is to rest on two points.
    """
    span, rise = along1 - along2, gap1 - gap2
    beside = along1 >= 0.0 and along2 <= length
    if beside and abs(rise) <= PARALLEL * span:
        return 0
    if along2 < 0.0 and -along2 * span <= gap2 * rise:
        return 1
    if along1 < 0.0:
        return 2
    if along1 > length and (along1 - length) * span <= -gap1 * rise:
        return 3
    if along2 > length:
        return 4
    return 0


def name_of(p: int, q: int, swapped: bool) -> int:
    """Return the name of a point between a corner of P and one of Q."""
    return 1 + (q * NAMES + p if swapped else p * NAMES + q)
