"""The sides of two convex shapes that leave most room between them.

Serves: manifolds and sweeps. Hides: how sides and corners are searched, and what decides.

A shape is its corners, grown by a radius; sides have outward normals. The room that a side leaves
is the distance of the other's nearest corner from its line, negative where that lies behind it.
Over all sides of both shapes the largest room is at most the distance, and all of it where a side
is among the nearest features.

Source: Gregorius, The separating axis test between convex polyhedra (GDC 2013).
"""

from tamias2d.state import Array
from tamias2d.stepped.hint import APART, LED_BY_A, LED_BY_B, NOTHING


def roomiest(
    first_p: int,
    count_p: int,
    first_q: int,
    count_q: int,
    x: float,
    y: float,
    enough: float,
    turned: Array,
) -> tuple[float, int, int, float]:
    """Return the room of P's roomiest side, m, its index, Q's nearest corner, the next room.

    Q's centre is at (x, y) from P's. The search ends at the first side that leaves enough room, m.
    """
    best = second = -NOTHING
    side = corner = 0
    for i in range(count_p):
        nx, ny = turned[first_p + i, 2], turned[first_p + i, 3]
        low = NOTHING
        at = 0
        for j in range(count_q):
            height = nx * turned[first_q + j, 0] + ny * turned[first_q + j, 1]
            if height < low:
                low = height
                at = j
        room = nx * (x - turned[first_p + i, 0]) + ny * (y - turned[first_p + i, 1]) + low
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


def find_sides(
    first_a: int,
    count_a: int,
    first_b: int,
    count_b: int,
    x: float,
    y: float,
    enough: float,
    turned: Array,
) -> tuple[int, int, int, float, float]:
    """Return who leads, the sides of A and B that face each other, their room and the next, m.

    `APART` where a side leaves enough room.
    """
    room_a, side_a, corner_b, next_a = roomiest(
        first_a, count_a, first_b, count_b, x, y, enough, turned
    )
    if room_a >= enough:
        return APART, side_a, 0, room_a, 0.0
    room_b, side_b, corner_a, next_b = roomiest(
        first_b, count_b, first_a, count_a, -x, -y, enough, turned
    )
    if room_b >= enough:
        return APART, 0, side_b, room_b, 0.0
    if room_b > room_a:
        nx, ny = turned[first_b + side_b, 2], turned[first_b + side_b, 3]
        facing = facing_side(first_a, count_a, corner_a, nx, ny, turned)
        other = next_a if facing == side_a else room_a
        return LED_BY_B, facing, side_b, room_b, max(other, next_b)
    nx, ny = turned[first_a + side_a, 2], turned[first_a + side_a, 3]
    facing = facing_side(first_b, count_b, corner_b, nx, ny, turned)
    other = next_b if facing == side_b else room_b
    return LED_BY_A, side_a, facing, room_a, max(other, next_a)


def slack_of(
    first_p: int,
    count_p: int,
    side_p: int,
    first_q: int,
    count_q: int,
    side_q: int,
    x: float,
    y: float,
    lever: float,
    room: float,
    other: float,
    turned: Array,
) -> tuple[bool, float]:
    """Return whether either of two sides may lead, and by how much they are ahead of others, m.

    P's side leads with a room, the next but Q's leaves another; Q is at (x, y) from P. Either may
    lead where the corners of each are nearest to the other, and each faces the other.
    """
    near_q, _ = nearness(first_p + side_p, first_q, count_q, side_q, lever, turned)
    near_p, low = nearness(first_q + side_q, first_p, count_p, side_p, lever, turned)
    q = first_q + side_q
    mx, my = turned[q, 2], turned[q, 3]
    behind = room - (mx * (-x - turned[q, 0]) + my * (-y - turned[q, 1]) + low)
    slack = min(room - other, near_q)
    return near_p > behind, min(slack, max(near_p, behind))


def nearness(
    lead: int, first: int, count: int, side: int, lever: float, turned: Array
) -> tuple[float, float]:
    """Return how much nearer a side's corners are to a leading side than others, and the nearest.

    Counted also is how much better the side faces the leading one than those beside it do, times
    the lever: a turn by a chord changes it by no more than twice that.
    """
    nx, ny = turned[lead, 2], turned[lead, 3]
    following = side + 1 if side + 1 < count else 0
    before = side - 1 if side > 0 else count - 1
    here = nx * turned[first + side, 2] + ny * turned[first + side, 3]
    beside = min(
        nx * turned[first + before, 2] + ny * turned[first + before, 3],
        nx * turned[first + following, 2] + ny * turned[first + following, 3],
    )
    near = far = NOTHING
    for k in range(count):
        height = nx * turned[first + k, 0] + ny * turned[first + k, 1]
        if k in (side, following):
            near = min(near, height)
        else:
            far = min(far, height)
    return min(far - near, (beside - here) * lever), min(near, far)
