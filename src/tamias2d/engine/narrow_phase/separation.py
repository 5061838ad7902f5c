"""The separating axis test: the side normal along which two convex shapes are least deep.

A shape is its vertices, grown by a radius; sides have outward normals. The separation along a side
is the distance of the other shape's nearest vertex from its line, negative where that lies behind
it. Over all sides of both shapes the largest separation is at most the distance, and equal to it
where a side is among the nearest features.

Cost: the product of the numbers of vertices at worst, their sum where the guesses are right.
Source: Gregorius, The separating axis test between convex polyhedra (GDC 2013).
"""

from typing import NamedTuple

from tamias2d.engine.narrow_phase.core import Core, next_vertex, smaller_size
from tamias2d.state import Array, Vector

# states of an axis: the shapes are apart along it; whose side is the reference side
SEPARATED, REFERENCE_A, REFERENCE_B, EITHER_IS_REFERENCE = 1, 2, 3, 4
INFINITE = 1e308
BEHIND = -0.5  # cosine of the angle between directions on opposite sides of a thin shape
# fractions of the smaller size of two shapes
BROUGHT_BACK = 0.35  # from how deep on the other side one is brought back
PRESSED_THROUGH = 0.02  # how far apart shapes may be of which one was pressed through a corner
OPPOSITE = -1.0 + 2.0**-40  # cosine of sides that face each other but for a millionth


class Axis(NamedTuple):
    """The sides of A and B that face each other, and how far they are ahead of others."""

    state: int
    side_a: int
    side_b: int
    separation: float  # m
    next_separation: float  # along the next best side, m


class Best(NamedTuple):
    """The best side in a search over the sides of one shape."""

    separation: float  # m
    side: int  # -1 if it is one of the other shape
    vertex: int  # nearest vertex of the other shape
    next_separation: float  # along the next best side of this shape, m


def foremost_side(p: Core, x: float, y: float, vertices: Array) -> int:
    """Return the side that a point is farthest in front of, m from the body's centre."""
    side = 0
    most = -INFINITE
    for k in range(p.vertex_count):
        height = height_over(p.first + k, x, y, vertices)
        side = k if height > most else side
        most = max(most, height)
    return side


def height_over(side: int, x: float, y: float, vertices: Array) -> float:
    """Return how far a point is in front of a side, m."""
    height: float = vertices[side, 2] * (x - vertices[side, 0]) + vertices[side, 3] * (
        y - vertices[side, 1]
    )
    return height


def find_axis(
    a: Core, guess_a: int, b: Core, guess_b: int, x: float, y: float, cutoff: float, vertices: Array
) -> Axis:
    """Return the axis of the largest separation.

    `SEPARATED` where a side has a separation of the cutoff, m. The nearer the guessed sides are to
    what is found, the fewer others are measured; of equal ones a guess is found, and A's side is
    the reference.
    """
    along_a, vertex_b = separation_along(a.first + guess_a, b, x, y, vertices)
    if along_a >= cutoff:
        return Axis(SEPARATED, guess_a, guess_b, along_a, 0.0)
    along_b, vertex_a = separation_along(b.first + guess_b, a, -x, -y, vertices)
    if along_b >= cutoff:
        return Axis(SEPARATED, guess_a, guess_b, along_b, 0.0)
    side_a, side_b = (guess_a, -1) if along_a >= along_b else (-1, guess_b)
    start_a = Best(max(along_a, along_b), side_a, vertex_b, 0.0)
    best_a = best_side(a, guess_a, start_a, b, x, y, cutoff, vertices)
    if best_a.separation >= cutoff:
        return Axis(SEPARATED, best_a.side, guess_b, best_a.separation, 0.0)
    start_b = Best(best_a.separation, side_b if best_a.side < 0 else -1, vertex_a, 0.0)
    best_b = best_side(b, guess_b, start_b, a, -x, -y, cutoff, vertices)
    if best_b.separation >= cutoff:
        return Axis(SEPARATED, guess_a, best_b.side, best_b.separation, 0.0)
    state = REFERENCE_A
    side_a, side_b = best_a.side, best_b.side
    if side_b < 0:
        v = a.first + side_a
        side_b = incident_side(b, best_a.vertex, vertices[v, 2], vertices[v, 3], vertices)
    else:
        state = REFERENCE_B
        v = b.first + side_b
        side_a = incident_side(a, best_b.vertex, vertices[v, 2], vertices[v, 3], vertices)
    next_a = best_a.next_separation
    next_a = next_a if side_a == guess_a else max(next_a, along_a)
    next_b = best_b.next_separation
    next_b = next_b if side_b == guess_b else max(next_b, along_b)
    return Axis(state, side_a, side_b, best_b.separation, max(next_a, next_b))


def find_axis_on_side(
    a: Core, b: Core, x: float, y: float, held: Vector, cutoff: float, vertices: Array
) -> Axis:
    """Return the axis of the largest separation that is not behind the normal of before.

    The inside of a thin shape does not tell on which side of it another one is: the normal does. It
    is (0, 0) where any axis will do. So it will where shapes are apart, unless one has come through
    the other one. Of two lines each may be through the other by any part of its length and yet
    apart from it, in a hollow: there the normal of before decides.
    """
    best_a = best_on_side(a, b, x, y, held[0], held[1], vertices)
    best_b = best_on_side(b, a, -x, -y, -held[0], -held[1], vertices)
    behind = max(best_a.next_separation, best_b.next_separation)
    radii = a.radius + b.radius
    apart = behind > max(best_a.separation, best_b.separation, radii)
    lines = a.vertex_count == 2 and b.vertex_count == 2
    if apart and not lines and not has_passed(a, b, x, y, held, behind - radii, vertices):
        best_a = best_on_side(a, b, x, y, 0.0, 0.0, vertices)
        best_b = best_on_side(b, a, -x, -y, 0.0, 0.0, vertices)
    if best_a.separation >= best_b.separation:
        v = a.first + best_a.side
        other = incident_side(b, best_a.vertex, vertices[v, 2], vertices[v, 3], vertices)
        state = SEPARATED if best_a.separation >= cutoff else REFERENCE_A
        return Axis(state, best_a.side, other, best_a.separation, best_b.separation)
    v = b.first + best_b.side
    other = incident_side(a, best_b.vertex, vertices[v, 2], vertices[v, 3], vertices)
    state = SEPARATED if best_b.separation >= cutoff else REFERENCE_B
    return Axis(state, other, best_b.side, best_b.separation, best_a.separation)


def best_on_side(
    p: Core, q: Core, x: float, y: float, hx: float, hy: float, vertices: Array
) -> Best:
    """Return the side of P with the largest separation from Q, of those that are not behind.

    The next separation is the largest one along those that are.
    """
    best, side, vertex, behind = -INFINITE, 0, 0, -INFINITE
    for k in range(p.vertex_count):
        v = p.first + k
        along, nearest = separation_along(v, q, x, y, vertices)
        if vertices[v, 2] * hx + vertices[v, 3] * hy < BEHIND:
            behind = max(behind, along)
        elif along > best:
            best, side, vertex = along, k, nearest
    return Best(best, side, vertex, behind)


def has_passed(
    a: Core, b: Core, x: float, y: float, held: Vector, apart: float, vertices: Array
) -> bool:
    """Return whether shapes that are apart by so much, m, are so since one came through the other.

    Then it is not far back to the side on which it was, and they are over each other there, or as
    near as contacts let them come through a corner. What is beside the end of another shape has not
    come through it, however deep below its line it is.
    """
    nx, ny = held
    _, high_a = extent_along(a, nx, ny, vertices)
    low_b, _ = extent_along(b, nx, ny, vertices)
    back, size = high_a - (low_b + nx * x + ny * y), smaller_size(a, b, vertices)
    if back + a.radius + b.radius > BROUGHT_BACK * size:
        return False
    left_a, right_a = extent_along(a, -ny, nx, vertices)
    left_b, right_b = extent_along(b, -ny, nx, vertices)
    aside = nx * y - ny * x
    over = min(right_a - left_b - aside, right_b - left_a + aside)
    return apart < max(over, PRESSED_THROUGH * size)


def extent_along(p: Core, nx: float, ny: float, vertices: Array) -> tuple[float, float]:
    """Return from where to where the vertices of a shape are along a direction, m."""
    low, high = INFINITE, -INFINITE
    for k in range(p.first, p.first + p.vertex_count):
        height = nx * vertices[k, 0] + ny * vertices[k, 1]
        low, high = min(low, height), max(high, height)
    return low, high


def best_side(
    p: Core, guess: int, start: Best, q: Core, x: float, y: float, cutoff: float, vertices: Array
) -> Best:
    """Return the side of P with the largest separation, if it is larger than that of the start.

    Q's centre is at (x, y) from P's, m. The guessed side has been measured. Sides whose separation
    cannot be larger, since no side of Q is nearer to its centre than the inradius, are not
    measured, and this bound counts as theirs. The search ends at the cutoff, m.
    """
    separation, side, vertex = start.separation, start.side, start.vertex
    following = -INFINITE
    for i in range(p.vertex_count):
        if i == guess:
            continue
        bound = height_over(p.first + i, x, y, vertices) - q.inradius
        if bound <= separation:
            following = max(following, bound)
            continue
        along, nearest = separation_along(p.first + i, q, x, y, vertices)
        if along > separation:
            following = separation if side >= 0 else following
            separation, side, vertex = along, i, nearest
            if separation >= cutoff:
                break
        else:
            following = max(following, along)
    return Best(separation, side, vertex, following)


def separation_along(side: int, q: Core, x: float, y: float, vertices: Array) -> tuple[float, int]:
    """Return the separation of Q along a side of P, m, and the vertex of Q that is nearest."""
    nx, ny = vertices[side, 2], vertices[side, 3]
    low = INFINITE
    nearest = 0
    for j in range(q.vertex_count):
        height = nx * vertices[q.first + j, 0] + ny * vertices[q.first + j, 1]
        nearest = j if height < low else nearest
        low = min(low, height)
    return nx * (x - vertices[side, 0]) + ny * (y - vertices[side, 1]) + low, nearest


def side_separation(
    p: Core, side_p: int, q: Core, side_q: int, x: float, y: float, vertices: Array
) -> float:
    """Return the distance of the nearer end of a side of Q from the line of a side of P, m."""
    v = p.first + side_p
    end1, end2 = q.first + side_q, q.first + next_vertex(side_q, q.vertex_count)
    nx, ny = vertices[v, 2], vertices[v, 3]
    low = min(
        nx * vertices[end1, 0] + ny * vertices[end1, 1],
        nx * vertices[end2, 0] + ny * vertices[end2, 1],
    )
    separation: float = nx * (x - vertices[v, 0]) + ny * (y - vertices[v, 1]) + low
    return separation


def inner_radius(p: Core, vertices: Array) -> float:
    """Return the least distance of a side from the body's centre, m; negative if outside."""
    near = INFINITE
    for k in range(p.first, p.first + p.vertex_count):
        near = min(near, vertices[k, 0] * vertices[k, 2] + vertices[k, 1] * vertices[k, 3])
    return near if near >= 0.0 else -INFINITE


def incident_side(q: Core, vertex: int, nx: float, ny: float, vertices: Array) -> int:
    """Return which of the two sides at a vertex faces more against a direction.

    Where both nearly do, sines tell: of a sheet with slanted ends all cosines are rounded to -1.
    """
    before = vertex - 1 if vertex > 0 else q.vertex_count - 1
    mx, my = vertices[q.first + vertex, 2], vertices[q.first + vertex, 3]
    kx, ky = vertices[q.first + before, 2], vertices[q.first + before, 3]
    here, other = nx * mx + ny * my, nx * kx + ny * ky
    if here < OPPOSITE and other < OPPOSITE:
        here, other = abs(nx * my - ny * mx), abs(nx * ky - ny * kx)
    return before if other < here else vertex


def side_slack(
    p: Core,
    side_p: int,
    q: Core,
    side_q: int,
    x: float,
    y: float,
    lever: float,
    axis: Axis,
    vertices: Array,
) -> tuple[bool, float]:
    """Return whether either side may be the reference, and how far both are ahead of others, m.

    P's side is the reference of the axis; Q is at (x, y) from P. Either may be where the ends of
    each are nearest to the other, and each faces the other.
    """
    slack_q, _ = incident_slack(p.first + side_p, q, side_q, lever, vertices)
    slack_p, low = incident_slack(q.first + side_q, p, side_p, lever, vertices)
    v = q.first + side_q
    mx, my = vertices[v, 2], vertices[v, 3]
    other = mx * (-x - vertices[v, 0]) + my * (-y - vertices[v, 1]) + low
    behind = axis.separation - other
    slack = min(axis.separation - axis.next_separation, slack_q)
    return slack_p > behind, min(slack, max(slack_p, behind))


def incident_slack(
    reference: int, q: Core, side: int, lever: float, vertices: Array
) -> tuple[float, float]:
    """Return how much nearer a side's ends are to a reference side than others, and the nearest.

    Counted also is how much better the side faces the reference side than those beside it do, times
    the lever: a turn by a chord changes it by no more than twice that.
    """
    nx, ny = vertices[reference, 2], vertices[reference, 3]
    following = next_vertex(side, q.vertex_count)
    before = side - 1 if side > 0 else q.vertex_count - 1
    here = nx * vertices[q.first + side, 2] + ny * vertices[q.first + side, 3]
    beside = min(
        nx * vertices[q.first + before, 2] + ny * vertices[q.first + before, 3],
        nx * vertices[q.first + following, 2] + ny * vertices[q.first + following, 3],
    )
    near = far = INFINITE
    for k in range(q.vertex_count):
        height = nx * vertices[q.first + k, 0] + ny * vertices[q.first + k, 1]
        if k in (side, following):
            near = min(near, height)
        else:
            far = min(far, height)
    return min(far - near, (beside - here) * lever), min(near, far)
