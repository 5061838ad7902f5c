"""Conservative advancement: when two shapes that move through a step first come close.

Over a step the centres move in straight lines and the bodies turn evenly. A lower bound of the gap
tells for how long the shapes stay apart; from there it is found anew. Shapes meet where the gap
falls to `NEAR` of the smaller one's size (IM12). Source: Mirtich, Impulse-based dynamic
simulation (1996).
"""

from math import sqrt

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.gap_bound import UNBOUNDED, Sweep, safe_advance
from tamias2d.engine.continuous.trajectory import RelativePath
from tamias2d.engine.narrow_phase.chain import BESIDE, FACING, has_end, judge
from tamias2d.engine.narrow_phase.clip import TINY
from tamias2d.engine.narrow_phase.collide import collide_cores
from tamias2d.engine.narrow_phase.core import Core, core_of, is_piece, is_thin, smaller_size
from tamias2d.engine.rotation import cosine_sine
from tamias2d.engine.tables import Events, Shapes
from tamias2d.generated.continuous_collision import (
    fraction_closest,
    half_interval,
    miss_distance,
    motion_bound,
)
from tamias2d.state import Array, Vector

MISSED = 2.0  # the fraction of the step at which pairs meet that do not
NEAR = 2.0**-13  # of the smaller shape's size: a gap that counts as a meeting
MOST_POSES = 4096  # that are tried: a bar that spins 50 times within a hair of a wall
MOST_CLOSE_POSES = 64  # of these, while a pair is as close as at the start
BESIDE_PIECE = 2.0**-5  # of the size: how far a shape goes between looks beside a piece of a chain
WIDER = 1.0 + 2.0**-20  # of a circle, against rounding


def time_of_impact(
    s: int, t: int, sensed: bool, path: RelativePath, held: Vector, shapes: Shapes, events: Events
) -> float:
    """Return the fraction of a path at which shapes s and t first come close, or `MISSED`.

    Vertices are turned as at the start of the path, where the shapes may be in contact, with the
    normal that is given then.

    At the fraction the gap is positive, and at most `NEAR` of the smaller shape's size: their
    manifold at that pose has the normal and the points. A pair that is as close already at the
    start meets when it has come as much closer, or close again after it was apart. One that is
    only sensed meets on both sides of a chain, and at its ends.
    """
    if shapes.kind[t] != tb.HALF_PLANE:
        return advance(s, t, sensed, path, held, shapes, events)
    if shapes.kind[s] == tb.HALF_PLANE:
        return MISSED
    reverse = RelativePath(-path.x, -path.y, -path.dx, -path.dy, path.turn_b, path.turn_a)
    return advance(t, s, sensed, reverse, held, shapes, events)


def advance(
    s: int, t: int, sensed: bool, path: RelativePath, held: Vector, shapes: Shapes, events: Events
) -> float:
    """Return the same where shape t is not a half-plane."""
    p, q, vertices = core_of(s, shapes), core_of(t, shapes), shapes.world_vertices
    plane = p.kind == tb.HALF_PLANE
    lever_a = 0.0 if plane else vertex_radius(p, vertices)
    a = Sweep(0, 0 if plane else p.vertex_count, path.turn_a, lever_a)
    b = Sweep(p.vertex_count, q.vertex_count, path.turn_b, vertex_radius(q, vertices))
    placed_a = Core(p.kind, 0, p.vertex_count, p.radius, 0.0)
    placed_b = Core(q.kind, p.vertex_count, q.vertex_count, q.radius, 0.0)
    near = NEAR * smaller_size(p, q, vertices)
    reach = (a.lever + p.radius + b.lever + q.radius) * WIDER + near
    at, last = near_interval(p, path, reach, vertices)
    manifold, rows = events.scratch[0], events.scratch[1:]
    least = hair = near
    seen = held
    told = held[0] != 0.0 or held[1] != 0.0
    piece = not sensed and (is_piece(p) or is_piece(q))
    kept = piece and not has_end(s if is_piece(p) else t, shapes)
    for pose in range(MOST_POSES):
        if at >= last:
            return MISSED
        x, y = path.x + at * path.dx, path.y + at * path.dy
        place_vertices(p, path.turn_a * at, vertices, 0, rows)
        place_vertices(q, path.turn_b * at, vertices, p.vertex_count, rows)
        gap = measure_gap(manifold, placed_a, placed_b, x, y, held, rows)
        stays = True
        if piece and gap <= near:
            stays, gap = measure_gap_of_piece(
                s, t, placed_a, placed_b, (x, y), gap, held, manifold, rows, shapes
            )
            if (
                seen[0] * manifold[tb.NX] + seen[1] * manifold[tb.NY] < -FACING
            ):  # it came past an end
                stays, gap = False, UNBOUNDED
        elif piece:
            seen = (manifold[tb.NX], manifold[tb.NY])
        if at == 0.0 and gap <= near:
            if gap > 0.0 and is_thin(p, q) and not told:  # behind a gap of 0 is the other side
                least = hair = 0.5 * gap
            else:
                least = gap - near
        elif gap > near:
            least = hair = near
        if gap <= near and not (piece and told):
            held = (manifold[tb.NX], manifold[tb.NY])
        elif gap > near and not kept:  # a shape may have come to the other side
            held, told = (0.0, 0.0), False
        if not (gap > least and (least == near or pose < MOST_CLOSE_POSES)):
            return at
        if not stays:
            at += advance_beside(near, a, b, path)
            continue
        radii = p.radius + q.radius + least - 0.5 * hair
        free = safe_advance(manifold, a, b, x, y, path, radii, last - at, rows)
        if at + free == at:
            return at
        at += free
    return at


def measure_gap(
    manifold: Array, a: Core, b: Core, x: float, y: float, held: Vector, vertices: Array
) -> float:
    """Write the manifold of two cores, however far apart; return their gap, m."""
    _, second = collide_cores(manifold, a, b, x, y, UNBOUNDED, held, vertices)
    if second == 0:
        manifold[tb.GAP + tb.POINT] = UNBOUNDED
    return min(manifold[tb.GAP], manifold[tb.GAP + tb.POINT])


def measure_gap_of_piece(
    s: int,
    t: int,
    a: Core,
    b: Core,
    at: Vector,
    gap: float,
    held: Vector,
    manifold: Array,
    vertices: Array,
    shapes: Shapes,
) -> tuple[bool, float]:
    """Return whether a piece of a chain takes the manifold of two shapes, and the gap that counts.

    Where the piece takes none, the gap is huge.
    """
    verdict = judge(s, t, a, b, at, UNBOUNDED, held, manifold, vertices, shapes)
    if verdict.stays:
        return True, gap
    if verdict.first == 0 or verdict.first == BESIDE:
        return False, UNBOUNDED
    if verdict.second == 0:
        manifold[tb.GAP + tb.POINT] = UNBOUNDED
    return False, min(manifold[tb.GAP], manifold[tb.GAP + tb.POINT])


def advance_beside(near: float, a: Sweep, b: Sweep, path: RelativePath) -> float:
    """Return a short fraction, for which shapes go on that are beside or over a piece."""
    turn = motion_bound((0.0, 0.0), path.turn_a, a.lever)
    most = turn + motion_bound((path.dx, path.dy), path.turn_b, b.lever)
    return BESIDE_PIECE / NEAR * near / most if most > 0.0 else 1.0


def place_vertices(p: Core, turn: float, vertices: Array, to: int, rows: Array) -> None:
    """Write the vertices of a core, turned by an angle, from a row on.

    Of a half-plane, whose row holds its offset and its normal, the normal turns alone.
    """
    c, d = 1.0, 0.0
    if turn != 0.0 and not is_centred_disc(p, vertices):
        c, d = cosine_sine(turn)
    fixed = p.kind == tb.HALF_PLANE
    for k in range(p.vertex_count):
        v = p.first + k
        x, y, nx, ny = vertices[v, 0], vertices[v, 1], vertices[v, 2], vertices[v, 3]
        rows[to + k, 0] = x if fixed else c * x - d * y
        rows[to + k, 1] = y if fixed else d * x + c * y
        rows[to + k, 2], rows[to + k, 3] = c * nx - d * ny, d * nx + c * ny


def is_centred_disc(p: Core, vertices: Array) -> bool:
    """Return whether a core is a point at the centre of its body, which does not turn."""
    first = vertices[p.first]
    return bool((p.vertex_count == 1) & (p.kind == tb.DISC) & (first[0] == 0.0) & (first[1] == 0.0))


def vertex_radius(p: Core, vertices: Array) -> float:
    """Return the distance of the farthest vertex from the body's centre, m."""
    far = 0.0
    for k in range(p.first, p.first + p.vertex_count):
        far = max(far, vertices[k, 0] * vertices[k, 0] + vertices[k, 1] * vertices[k, 1])
    return sqrt(far)


def near_interval(
    p: Core, path: RelativePath, reach: float, vertices: Array
) -> tuple[float, float]:
    """Return between which fractions B is within reach of A, or of a half-plane that is fixed."""
    if p.kind != tb.HALF_PLANE:
        return within_circle(path, reach)
    if path.turn_a != 0.0:
        return 0.0, 1.0
    nx, ny = vertices[p.first, 2], vertices[p.first, 3]
    height = nx * path.x + ny * path.y - vertices[p.first, 0] - reach
    return below(height, nx * path.dx + ny * path.dy)


def within_circle(path: RelativePath, reach: float) -> tuple[float, float]:
    """Return between which fractions B's centre is within reach of A's."""
    at, by = (path.x, path.y), (path.dx, path.dy)
    if path.dx * path.dx + path.dy * path.dy <= TINY:
        near = path.x * path.x + path.y * path.y <= reach * reach
        return (0.0, 1.0) if near else (0.0, 0.0)
    beside = miss_distance(at, by)
    if abs(beside) > reach:
        return 0.0, 0.0
    middle, half = fraction_closest(at, by), half_interval(reach, beside, by)
    return max(0.0, middle - half), min(1.0, middle + half)


def below(height: float, rate: float) -> tuple[float, float]:
    """Return between which fractions a height that changes evenly is not positive."""
    after = height + rate
    if height > 0.0:
        return (1.0 if after >= 0.0 else -height / rate), 1.0
    return 0.0, (1.0 if after <= 0.0 else -height / rate)
