"""The sides of two convex shapes that leave most room between them.

Serves: manifolds and sweeps. Hides: how sides and corners are searched, and what decides.

A shape is its corners, grown by a radius; sides have outward normals. The room that a side leaves
is the distance of the other's nearest corner from its line, negative where that lies behind it.
Over all sides of both shapes the largest room is at most the distance, and all of it where a side
is among the nearest features.

Source: Gregorius, The separating axis test between convex polyhedra (GDC 2013).
"""

from tamias2d.engine.narrow_phase.axis_cache import APART, LED_BY_A, LED_BY_B, NOTHING
from tamias2d.state import Array


def most_facing(first: int, count: int, x: float, y: float, vertices: Array) -> int:
    """Return the side that is farthest behind a point, m from the body's centre."""
    side = 0
    most = -NOTHING
    for k in range(count):
        room = height_over(first + k, x, y, vertices)
        side = k if room > most else side
        most = max(most, room)
    return side


def height_over(side: int, x: float, y: float, vertices: Array) -> float:
    """Return how far a point is before a side, m."""
    room: float = vertices[side, 2] * (x - vertices[side, 0]) + vertices[side, 3] * (
        y - vertices[side, 1]
    )
    return room


def best_side(
    first_p: int,
    count_p: int,
    known: int,
    side: int,
    corner: int,
    best: float,
    first_q: int,
    count_q: int,
    inner_q: float,
    x: float,
    y: float,
    enough: float,
    vertices: Array,
) -> tuple[float, int, int, float]:
    """Return the room of P's roomiest side, m, its index, Q's nearest corner, the next room.

    Q's centre is at (x, y) from P's, and no side of Q is nearer to it than `inner_q`, m. The best
    so far is a room, m, with its side of P, -1 if it is not P's, and its corner; the known side
    has been measured. Sides that cannot leave more are not, and what they might leave counts as
    theirs. The search ends where there is room enough, m.
    """
    second = -NOTHING
    for i in range(count_p):
        if i == known:
            continue
        most = height_over(first_p + i, x, y, vertices) - inner_q
        if most <= best:
            second = max(second, most)
            continue
        room, at = separation_over(first_p + i, first_q, count_q, x, y, vertices)
        if room > best:
            second = best if side >= 0 else second
            best, side, corner = room, i, at
            if best >= enough:
                break
        else:
            second = max(second, room)
    return best, side, corner, second


def separation_over(
    side: int, first_q: int, count_q: int, x: float, y: float, vertices: Array
) -> tuple[float, int]:
    """Return the room that a side of P leaves to Q, m, and the corner of Q that is nearest."""
    nx, ny = vertices[side, 2], vertices[side, 3]
    low = NOTHING
    at = 0
    for j in range(count_q):
        height = nx * vertices[first_q + j, 0] + ny * vertices[first_q + j, 1]
        at = j if height < low else at
        low = min(low, height)
    return nx * (x - vertices[side, 0]) + ny * (y - vertices[side, 1]) + low, at


def inner_radius(first: int, count: int, vertices: Array) -> float:
    """Return how near the sides of a shape are to the centre of its body, m.

    Where the centre is not within the shape this says nothing.
    """
    near = NOTHING
    for k in range(first, first + count):
        near = min(near, vertices[k, 0] * vertices[k, 2] + vertices[k, 1] * vertices[k, 3])
    return near if near >= 0.0 else -NOTHING


def facing_side(first: int, count: int, corner: int, nx: float, ny: float, vertices: Array) -> int:
    """Return which of the two sides at a corner looks more against a direction."""
    before = corner - 1 if corner > 0 else count - 1
    here = nx * vertices[first + corner, 2] + ny * vertices[first + corner, 3]
    other = nx * vertices[first + before, 2] + ny * vertices[first + before, 3]
    return before if other < here else corner


def find_sides(
    first_a: int,
    count_a: int,
    guess_a: int,
    first_b: int,
    count_b: int,
    guess_b: int,
    inner_a: float,
    inner_b: float,
    x: float,
    y: float,
    enough: float,
    vertices: Array,
) -> tuple[int, int, int, float, float]:
    """Return who leads, the sides of A and B that face each other, their room and the next, m.

    `APART` where a side leaves enough room. The nearer the guessed sides are to what is found, the
    fewer others are measured; of equal ones a guess is found, and A leads.
    """
    room_a, corner_b = separation_over(first_a + guess_a, first_b, count_b, x, y, vertices)
    if room_a >= enough:
        return APART, guess_a, guess_b, room_a, 0.0
    room_b, corner_a = separation_over(first_b + guess_b, first_a, count_a, -x, -y, vertices)
    if room_b >= enough:
        return APART, guess_a, guess_b, room_b, 0.0
    side_a, side_b = (guess_a, -1) if room_a >= room_b else (-1, guess_b)
    best, side_a, corner_b, next_a = best_side(
        first_a,
        count_a,
        guess_a,
        side_a,
        corner_b,
        max(room_a, room_b),
        first_b,
        count_b,
        inner_b,
        x,
        y,
        enough,
        vertices,
    )
    if best >= enough:
        return APART, side_a, guess_b, best, 0.0
    best, side_b, corner_a, next_b = best_side(
        first_b,
        count_b,
        guess_b,
        side_b if side_a < 0 else -1,
        corner_a,
        best,
        first_a,
        count_a,
        inner_a,
        -x,
        -y,
        enough,
        vertices,
    )
    if best >= enough:
        return APART, guess_a, side_b, best, 0.0
    state = LED_BY_A
    if side_b < 0:
        nx, ny = vertices[first_a + side_a, 2], vertices[first_a + side_a, 3]
        side_b = facing_side(first_b, count_b, corner_b, nx, ny, vertices)
    else:
        state = LED_BY_B
        nx, ny = vertices[first_b + side_b, 2], vertices[first_b + side_b, 3]
        side_a = facing_side(first_a, count_a, corner_a, nx, ny, vertices)
    next_a = next_a if side_a == guess_a else max(next_a, room_a)
    next_b = next_b if side_b == guess_b else max(next_b, room_b)
    return state, side_a, side_b, best, max(next_a, next_b)


def side_slack(
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
    vertices: Array,
) -> tuple[bool, float]:
    """Return whether either of two sides may lead, and by how much they are ahead of others, m.

    P's side leads with a room, the next but Q's leaves another; Q is at (x, y) from P. Either may
    lead where the corners of each are nearest to the other, and each faces the other.
    """
    near_q, _ = nearness(first_p + side_p, first_q, count_q, side_q, lever, vertices)
    near_p, low = nearness(first_q + side_q, first_p, count_p, side_p, lever, vertices)
    q = first_q + side_q
    mx, my = vertices[q, 2], vertices[q, 3]
    behind = room - (mx * (-x - vertices[q, 0]) + my * (-y - vertices[q, 1]) + low)
    slack = min(room - other, near_q)
    return near_p > behind, min(slack, max(near_p, behind))


def nearness(
    lead: int, first: int, count: int, side: int, lever: float, vertices: Array
) -> tuple[float, float]:
    """Return how much nearer a side's corners are to a leading side than others, and the nearest.

    Counted also is how much better the side faces the leading one than those beside it do, times
    the lever: a turn by a chord changes it by no more than twice that.
    """
    nx, ny = vertices[lead, 2], vertices[lead, 3]
    following = side + 1 if side + 1 < count else 0
    before = side - 1 if side > 0 else count - 1
    here = nx * vertices[first + side, 2] + ny * vertices[first + side, 3]
    beside = min(
        nx * vertices[first + before, 2] + ny * vertices[first + before, 3],
        nx * vertices[first + following, 2] + ny * vertices[first + following, 3],
    )
    near = far = NOTHING
    for k in range(count):
        height = nx * vertices[first + k, 0] + ny * vertices[first + k, 1]
        if k in (side, following):
            near = min(near, height)
        else:
            far = min(far, height)
    return min(far - near, (beside - here) * lever), min(near, far)
