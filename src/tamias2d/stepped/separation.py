"""The side of one convex shape that leaves most room to another.

Serves: manifolds and sweeps. Hides: how sides and corners are searched.

A shape is its corners, grown by a radius; sides have outward normals. The room that a side leaves
is the distance of the other's nearest corner from its line, negative where that lies behind it.
Over all sides of both shapes the largest room is at most the distance, and all of it where a side
is among the nearest features. Where room is left, the sides on both of whose neighbours it is less
leave most (Box2D's `b2FindMaxSeparation` looks at all of them too).
"""

from tamias2d.state import Array


def roomiest(
    first_p: int,
    count_p: int,
    first_q: int,
    count_q: int,
    x: float,
    y: float,
    cosine: float,
    sine: float,
    enough: float,
    rows: Array,
) -> tuple[float, int, int, float]:
    """Return the room of the roomiest side of P, m, its index, Q's nearest corner, the next room.

    Q's centre is at (x, y) from P's, in the axes of P, towards which those of Q are turned by the
    given cosine and sine. The search ends at the first side that leaves `enough` room, m.
    """
    best = second = -1e308
    side = corner = 0
    for i in range(count_p):
        nx = rows[first_p + i, 2]
        ny = rows[first_p + i, 3]
        ux = nx * cosine + ny * sine
        uy = ny * cosine - nx * sine
        low = 1e308
        at = 0
        for j in range(count_q):
            height = ux * rows[first_q + j, 0] + uy * rows[first_q + j, 1]
            if height < low:
                low = height
                at = j
        room = nx * (x - rows[first_p + i, 0]) + ny * (y - rows[first_p + i, 1]) + low
        if room > best:
            second = best
            best = room
            side = i
            corner = at
            if best >= enough:
                break
        elif room > second:
            second = room
    return best, side, corner, second


def facing_side(first: int, count: int, corner: int, nx: float, ny: float, turned: Array) -> int:
    """Return which of the two sides at a corner looks more against a direction."""
    before = corner - 1 if corner > 0 else count - 1
    here = nx * turned[first + corner, 2] + ny * turned[first + corner, 3]
    other = nx * turned[first + before, 2] + ny * turned[first + before, 3]
    return before if other < here else corner
