"""Pieces of chains: which normals they take, so that nothing catches on inner vertices (IM16).

A manifold is found as with a lone segment, and then looked at: it stays, it gets the normal of the
piece, or there is no contact. Cost: linear in the vertices of the other shape.
"""

from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.clip import (
    FEATURES,
    PARALLEL,
    clip_points,
    common_part,
    facing_sides,
    feature_of,
)
from tamias2d.engine.narrow_phase.core import Core, is_piece, next_vertex, smaller_size
from tamias2d.engine.narrow_phase.separation import INFINITE, PRESSED_THROUGH, incident_side
from tamias2d.engine.tables import Shapes
from tamias2d.generated.terrain import admitted, corner_room
from tamias2d.state import Array, Vector

BESIDE = FEATURES * FEATURES - 1  # feature of a point beside a piece, which may come over it
SAME = 2.0**-44  # sine: a direction that leans by no more is the normal of the piece
STRAIGHT = 2.0**-17  # sine: a corner that turns by no more does not stick out
FACING = 2.0**-3  # cosine: a normal that leans more over a piece tells no side of it
SLIVER = 2.0**-4  # of the size of a shape: how much of it may be on the other side of a neighbour


class Side(NamedTuple):
    """A piece of a chain as it is seen from one of its sides."""

    side: int  # 0 for the right one, 1 for the left one
    nx: float  # out of the piece
    ny: float
    start_cosine: float  # the corner where the side begins
    start_sine: float
    end_cosine: float  # the corner where it ends
    end_sine: float


class Verdict(NamedTuple):
    """What is left of the manifold of a piece of a chain."""

    stays: bool  # as it was found
    first: int  # features of its points where it does not stay
    second: int


def has_end(piece: int, shapes: Shapes) -> bool:
    """Return whether the chain of a piece ends with it."""
    row = shapes.material[piece]
    return bool(row[tb.START_COSINE] == -1.0 or row[tb.END_COSINE] == -1.0)


def judge(
    s: int,
    t: int,
    a: Core,
    b: Core,
    at: Vector,
    margin: float,
    held: Vector,
    manifold: Array,
    vertices: Array,
    shapes: Shapes,
) -> Verdict:
    """Look at the manifold of shapes s and t, one of them a piece, and write another if it must.

    B is `at` some place from A, m; the normal of their contact before, (0, 0) where there was none,
    tells on which side of the piece the other shape is. Where there is no contact, but one may come
    about, the first feature is `BESIDE`, and the manifold stays.
    """
    if is_piece(b):
        back, up = (-at[0], -at[1]), (-held[0], -held[1])
        return judge_piece(t, b, a, back, margin, up, True, manifold, vertices, shapes)
    return judge_piece(s, a, b, at, margin, held, False, manifold, vertices, shapes)


def judge_piece(
    piece: int,
    p: Core,
    q: Core,
    at: Vector,
    margin: float,
    held: Vector,
    swapped: bool,
    manifold: Array,
    vertices: Array,
    shapes: Shapes,
) -> Verdict:
    """Look at the manifold of a piece and another shape, which is at some place from it, m.

    Swapped says that the piece is B. The normal of before leads away from the piece.
    """
    ux, uy = (-manifold[tb.NX], -manifold[tb.NY]) if swapped else (manifold[tb.NX], manifold[tb.NY])
    right = seen_from(0, piece, p, vertices, shapes)
    one_sided, round_ = p.kind == tb.ONE_SIDED_PIECE, q.vertex_count == 1
    x, y = at[0], at[1]
    left = seen_from(1, piece, p, vertices, shapes)
    known = 0 if round_ else known_side(held[0], held[1], right, left)
    if known == 1 or (known == -1 and not one_sided):
        side = seen_from(0 if known == 1 else 1, piece, p, vertices, shapes)
        return judge_side(side, p, q, at, margin, swapped, manifold, vertices)
    if is_normal(ux, uy, right, round_):
        return verdict_of(one_sided or not is_beyond_neighbour(right, p, q, x, y, vertices))
    if not one_sided and is_normal(ux, uy, left, round_):
        return verdict_of(not is_beyond_neighbour(left, p, q, x, y, vertices))
    low, lowest = foremost_vertex(right, p, q, x, y, vertices)
    high, highest = foremost_vertex(left, p, q, x, y, vertices)
    up = right.nx * ux + right.ny * uy
    apart = is_beyond(ux, uy, p, q, x, y, vertices)
    in_front = up > 0.0 if apart and abs(up) >= FACING else low > high
    if one_sided and not in_front:
        return Verdict(False, 0, 0)
    side = seen_from(0 if in_front else 1, piece, p, vertices, shapes)
    if round_ or is_of_neighbour(ux, uy, side):
        return verdict_of(False)
    if one_sided or not is_beyond_neighbour(side, p, q, x, y, vertices):
        vertex = lowest if in_front else highest
        deep = not apart and (low if in_front else high) <= q.radius
        over = deep and is_over(side, p, q, vertex, x, y, vertices)
        if over or leans_little(ux, uy, side):
            first, second = clip_piece(
                manifold, side, p, q, vertex, x, y, margin, swapped, vertices
            )
            if first > 0:
                return Verdict(False, first, second)
    return verdict_of(False)


def judge_side(
    side: Side,
    p: Core,
    q: Core,
    at: Vector,
    margin: float,
    swapped: bool,
    manifold: Array,
    vertices: Array,
) -> Verdict:
    """Look at the manifold of a piece and a shape with sides that is on a known side of it.

    What of the shape is behind the piece, and not past its ends, has come through it; of a shape
    that is apart from the piece nothing has, but for what contacts let come through a hollow.
    """
    ux, uy = (-manifold[tb.NX], -manifold[tb.NY]) if swapped else (manifold[tb.NX], manifold[tb.NY])
    if is_normal(ux, uy, side, False):
        return verdict_of(True)
    x, y = at[0], at[1]
    low, vertex = foremost_vertex(side, p, q, x, y, vertices)
    apart = distance_along(ux, uy, p, q, x, y, vertices) - q.radius
    near = q.vertex_count == 2 or apart <= PRESSED_THROUGH * smaller_size(p, q, vertices)
    deep = low <= q.radius and near
    over = deep and is_over(side, p, q, vertex, x, y, vertices)
    within = margin if over or leans_little(ux, uy, side) else 0.0
    if deep or within > 0.0:
        first, second = clip_piece(manifold, side, p, q, vertex, x, y, within, swapped, vertices)
        if first > 0:
            return Verdict(False, first, second)
    return verdict_of(False)


def verdict_of(stays: bool) -> Verdict:
    """Return the verdict that a manifold stays as it was found, or that the shape is beside."""
    return Verdict(True, 0, 0) if stays else Verdict(False, BESIDE, 0)


def seen_from(side: int, piece: int, p: Core, vertices: Array, shapes: Shapes) -> Side:
    """Return a piece as it is seen from its right side, 0, or its left one, 1."""
    row, v = shapes.material[piece], p.first + side
    if side == 0:
        return Side(
            side, vertices[v, 2], vertices[v, 3],
            row[tb.START_COSINE], row[tb.START_SINE], row[tb.END_COSINE], row[tb.END_SINE],
        )  # fmt: skip
    return Side(
        side, vertices[v, 2], vertices[v, 3],
        row[tb.END_COSINE], -row[tb.END_SINE], row[tb.START_COSINE], -row[tb.START_SINE],
    )  # fmt: skip


def is_normal(ux: float, uy: float, side: Side, round_: bool) -> bool:
    """Return whether a direction away from a piece is a normal of one of its sides (IM16).

    A corner with a disc belongs to the piece that begins there.
    """
    along, up = side.nx * uy - side.ny * ux, side.nx * ux + side.ny * uy
    if abs(along) <= SAME:
        return up > 0.0
    if along < 0.0:
        return admitted(
            side.start_sine, corner_room(side.start_cosine, side.start_sine, up, -along)
        )
    if round_ and side.end_cosine != -1.0:
        return False
    return admitted(side.end_sine, corner_room(side.end_cosine, side.end_sine, up, along))


def known_side(hx: float, hy: float, right: Side, left: Side) -> int:
    """Return on which side of a piece the shape is that touches it with a normal of it.

    1 says on its right side, -1 on its left one, 0 that it may be either. At a corner that sticks
    out far a normal may lean over a piece by more than a right angle.
    """
    on_right, on_left = is_normal(hx, hy, right, False), is_normal(hx, hy, left, False)
    if on_right != on_left:
        if leans_over_tip(hx, hy, right) if on_right else leans_over_tip(hx, hy, left):
            return 0
        return 1 if on_right else -1
    up = right.nx * hx + right.ny * hy
    return 0 if abs(up) < FACING else 1 if up > 0.0 else -1


def leans_over_tip(ux: float, uy: float, side: Side) -> bool:
    """Return whether a normal leans over a corner whose other piece may hide what is there."""
    along, up = side.nx * uy - side.ny * ux, side.nx * ux + side.ny * uy
    if abs(along) <= PARALLEL * up:
        return False
    if along < 0.0:
        return not shows(side.start_cosine, side.start_sine)
    return not shows(side.end_cosine, side.end_sine)


def shows(cosine: float, sine: float) -> bool:
    """Return whether the pieces of a corner are both before what touches one of them."""
    return bool(cosine > -1.0 and (cosine >= 0.0 or sine < -STRAIGHT))


def is_of_neighbour(ux: float, uy: float, side: Side) -> bool:
    """Return whether a direction past a corner of more than a right angle is its other piece's.

    It leans less over that one, and shows that what is there is not in the hollow of the corner. A
    flat shape that lies on the other piece may be on both sides of the line of this one.
    """
    along, up = side.nx * uy - side.ny * ux, side.nx * ux + side.ny * uy
    cosine, sine = side.end_cosine, side.end_sine
    if along < 0.0:
        cosine, sine = side.start_cosine, side.start_sine
    facing = cosine * up + sine * abs(along)  # the cosine to the normal of the other piece
    sharp = cosine < 0.0 and cosine > -1.0
    return bool(sharp and abs(facing) > abs(up) and (facing < 0.0 or sine > 0.0))


def leans_little(ux: float, uy: float, side: Side) -> bool:
    """Return whether a direction is nearly the normal, over a corner that does not stick out."""
    along, up = side.nx * uy - side.ny * ux, side.nx * ux + side.ny * uy
    sine = side.start_sine if along < 0.0 else side.end_sine
    return abs(along) <= PARALLEL * up and sine <= STRAIGHT


def is_beyond_neighbour(side: Side, p: Core, q: Core, x: float, y: float, vertices: Array) -> bool:
    """Return whether a shape is on the other side of a neighbour, at a corner that is a hollow.

    Then it is on the other side of the chain, and has only come past the corner.
    """
    beyond = False
    if side.start_sine < -STRAIGHT:
        nx = side.start_cosine * side.nx + side.start_sine * side.ny
        ny = side.start_cosine * side.ny - side.start_sine * side.nx
        beyond = is_behind(nx, ny, p.first + side.side, q, x, y, vertices)
    if side.end_sine < -STRAIGHT:
        nx = side.end_cosine * side.nx - side.end_sine * side.ny
        ny = side.end_cosine * side.ny + side.end_sine * side.nx
        beyond = beyond or is_behind(nx, ny, p.first + 1 - side.side, q, x, y, vertices)
    return beyond


def is_behind(
    nx: float, ny: float, vertex: int, q: Core, x: float, y: float, vertices: Array
) -> bool:
    """Return whether nearly all of a shape is behind a line through a vertex with a normal."""
    base = nx * (x - vertices[vertex, 0]) + ny * (y - vertices[vertex, 1])
    low, high = INFINITE, -INFINITE
    for k in range(q.first, q.first + q.vertex_count):
        height = base + nx * vertices[k, 0] + ny * vertices[k, 1]
        low, high = min(low, height), max(high, height)
    low, high = low - q.radius, high + q.radius
    return high <= SLIVER * (high - low)


def is_beyond(ux: float, uy: float, p: Core, q: Core, x: float, y: float, vertices: Array) -> bool:
    """Return whether all of a shape is beyond all of a piece along a direction."""
    return distance_along(ux, uy, p, q, x, y, vertices) > 0.0


def distance_along(
    ux: float, uy: float, p: Core, q: Core, x: float, y: float, vertices: Array
) -> float:
    """Return how far the vertices of a shape are beyond those of a piece along a direction, m."""
    low = INFINITE
    for k in range(q.first, q.first + q.vertex_count):
        low = min(low, ux * (x + vertices[k, 0]) + uy * (y + vertices[k, 1]))
    first = ux * vertices[p.first, 0] + uy * vertices[p.first, 1]
    second = ux * vertices[p.first + 1, 0] + uy * vertices[p.first + 1, 1]
    return float(low - max(first, second))


def foremost_vertex(
    side: Side, p: Core, q: Core, x: float, y: float, vertices: Array
) -> tuple[float, int]:
    """Return how high a shape is over a side at its lowest vertex, m, and that vertex."""
    v = p.first + side.side
    base = side.nx * (x - vertices[v, 0]) + side.ny * (y - vertices[v, 1])
    low = INFINITE
    lowest = 0
    for k in range(q.first, q.first + q.vertex_count):
        height = base + side.nx * vertices[k, 0] + side.ny * vertices[k, 1]
        lowest = k - q.first if height < low else lowest
        low = min(low, height)
    return low, lowest


def is_over(side: Side, p: Core, q: Core, vertex: int, x: float, y: float, vertices: Array) -> bool:
    """Return whether a vertex of a shape is over a piece, neither before nor behind it.

    At a hollow corner, below which no piece is, it may be as far beyond as the piece is long.
    """
    v, w, k = p.first + side.side, p.first + 1 - side.side, q.first + vertex
    by_x, by_y = vertices[w, 0] - vertices[v, 0], vertices[w, 1] - vertices[v, 1]
    to_x, to_y = x + vertices[k, 0] - vertices[v, 0], y + vertices[k, 1] - vertices[v, 1]
    along, length = by_x * to_x + by_y * to_y, by_x * by_x + by_y * by_y
    before = length if side.start_sine < -STRAIGHT else 0.0
    behind = length if side.end_sine < -STRAIGHT else 0.0
    return bool(along >= -before and along <= length + behind)


def clip_piece(
    manifold: Array,
    side: Side,
    p: Core,
    q: Core,
    vertex: int,
    x: float,
    y: float,
    margin: float,
    swapped: bool,
    vertices: Array,
) -> tuple[int, int]:
    """Write the points of a shape over a side of a piece, along its normal; return their features.

    The vertex is the foremost one of the shape, which is at (x, y) from the piece, m. It is the one
    point where the shape stands on the piece. What is behind the piece counts past its end, too, if
    the corner is a hollow: no other piece would find it.
    """
    side_q = incident_side(q, vertex, side.nx, side.ny, vertices)
    end_p, end_q = 1 - side.side, next_vertex(side_q, q.vertex_count)
    facing = facing_sides(
        p.first + side.side, p.first + end_p, q.first + side_q, q.first + end_q, x, y, swapped,
        vertices,
    )  # fmt: skip
    low, high = common_part(facing)
    if facing.gap2 <= q.radius and side.start_sine < -STRAIGHT:
        low = max(facing.along2, -facing.length)
    if facing.gap1 <= q.radius and side.end_sine < -STRAIGHT:
        high = min(facing.along1, 2.0 * facing.length)
    apart = high < low or facing.along1 <= facing.along2
    if apart and not is_over(side, p, q, vertex, x, y, vertices):
        return 0, 0
    first, second = clip_points(
        manifold, facing, low, high, p.radius, q.radius, margin,
        feature_of(side.side, end_q, swapped), feature_of(end_p, side_q, swapped),
    )  # fmt: skip
    if first > 0:
        manifold[tb.NX] = -side.nx if swapped else side.nx
        manifold[tb.NY] = -side.ny if swapped else side.ny
    return first, second
