"""The narrow phase: the manifold of two convex shapes, with a normal and up to two points.

All shapes but half-planes are vertices grown by a radius: a disc has one vertex, a capsule two. A
point is midway between the surfaces. So of the arm p from the centre of A to it, p.n - radius_a -
gap/2 is the part that turns with the sides and vertices of A, and of the arm q from B's centre
q.n + radius_b + gap/2: both are 0 for a disc, which may roll.

Cost: linear in the vertices, or constant where the cached axis holds. Sources: Gregorius, The
separating axis test between convex polyhedra (GDC 2013); Catto, Box2D v3 (2024), for points of
pairs that do not touch yet.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.chain import judge
from tamias2d.engine.narrow_phase.core import Core, core_of, is_piece
from tamias2d.engine.narrow_phase.disc import collide_disc, collide_discs
from tamias2d.engine.narrow_phase.half_plane import collide_half_plane
from tamias2d.engine.narrow_phase.polygon import collide_cached, collide_polygons, held_normal
from tamias2d.engine.narrow_phase.reuse import NEVER
from tamias2d.engine.tables import Contacts, Integers, Shapes
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector


@inlined
def collide(
    contact: int,
    s: int,
    t: int,
    x: float,
    y: float,
    margin: float,
    shapes: Shapes,
    contacts: Contacts,
) -> int:
    """Write the manifold of shapes s and t, which are A and B; return its number of points.

    B's body is at (x, y) from A's, m. Points with a gap below the margin, m, count. Impulses of
    points that were there before are kept, those of others are 0. A contact starts with zeros, and
    serves one pair of shapes.
    """
    a, b = core_of(s, shapes), core_of(t, shapes)
    dx, dy = float(x), float(y)
    if is_piece(a) or is_piece(b):
        return collide_piece(contact, s, t, dx, dy, margin, shapes, contacts)
    manifold, cache = contacts.manifolds[contact], contacts.axes[contact]
    flags, vertices = contacts.flags[contact], shapes.world_vertices
    first, second = find_points(manifold, cache, flags, a, b, dx, dy, margin, vertices)
    if first > 0:
        manifold[tb.FORESEEN] = 0.0
    if second > 0:
        manifold[tb.KNOWN_WAY] = NEVER  # unless the pose is noted
    return match_impulses(manifold, flags, first, second)


def collide_piece(
    contact: int,
    s: int,
    t: int,
    x: float,
    y: float,
    margin: float,
    shapes: Shapes,
    contacts: Contacts,
) -> int:
    """Do the same where one of the shapes is a piece of a chain; a half-plane only senses it.

    A sensor asks whether shapes overlap, not which normal would push them apart: its manifold stays
    that of a lone segment.
    """
    manifold, cache = contacts.manifolds[contact], contacts.axes[contact]
    flags = contacts.flags[contact]
    a, b, vertices = core_of(s, shapes), core_of(t, shapes), shapes.world_vertices
    held = held_normal(manifold, flags)
    first, second = find_points(manifold, cache, flags, a, b, x, y, margin, vertices)
    if first > 0 and flags[tb.SENSES] == 0:
        manifold[tb.FORESEEN] = 0.0
        verdict = judge(s, t, a, b, (x, y), margin, held, manifold, vertices, shapes)
        if not verdict.stays:
            first, second = verdict.first, verdict.second
    return match_impulses(manifold, flags, first, second)


@inlined
def find_points(
    manifold: Array,
    cache: Array,
    flags: Integers,
    a: Core,
    b: Core,
    x: float,
    y: float,
    margin: float,
    vertices: Array,
) -> tuple[int, int]:
    """Write the points of two shapes; return their features, 0 for one that is not there."""
    if a.vertex_count > 1 and b.vertex_count > 1:
        return collide_cached(manifold, cache, flags, a, b, x, y, margin, vertices)
    return collide_cores(manifold, a, b, x, y, margin, (0.0, 0.0), vertices)


def collide_cores(
    manifold: Array,
    a: Core,
    b: Core,
    x: float,
    y: float,
    margin: float,
    held: Vector,
    vertices: Array,
) -> tuple[int, int]:
    """Write normal, points and gaps of two shapes to a manifold.

    The normal of their contact before, (0, 0) where there was none, tells on which side of each
    other thin shapes are. Returns the features of the points, 0 for one that is not within the
    margin.
    """
    if a.kind == tb.HALF_PLANE:
        if b.kind == tb.HALF_PLANE:
            return 0, 0
        return collide_half_plane(manifold, a.first, b, x, y, margin, False, vertices)
    if b.kind == tb.HALF_PLANE:
        return collide_half_plane(manifold, b.first, a, -x, -y, margin, True, vertices)
    if a.vertex_count > 1:
        if b.vertex_count > 1:
            return collide_polygons(manifold, a, b, x, y, margin, held, vertices)
        return collide_disc(manifold, a, b, x, y, margin, False, vertices), 0
    if b.vertex_count > 1:
        return collide_disc(manifold, b, a, -x, -y, margin, True, vertices), 0
    return collide_discs(manifold, a, b, x, y, margin, vertices), 0


def match_impulses(manifold: Array, flags: Integers, first: int, second: int) -> int:
    """Bring impulses to the points with their features, set others to 0, and count the points."""
    old_first, old_second = flags[tb.FEATURE], flags[tb.FEATURE + 1]
    if first != old_first or second != old_second:
        normal_1, tangent_1 = manifold[tb.NORMAL_IMPULSE], manifold[tb.TANGENT_IMPULSE]
        normal_2, tangent_2 = (
            manifold[tb.NORMAL_IMPULSE + tb.POINT],
            manifold[tb.TANGENT_IMPULSE + tb.POINT],
        )
        preload_1, preload_2 = manifold[tb.PRELOAD], manifold[tb.PRELOAD + tb.POINT]
        for k in range(2):
            feature = second if k else first
            at = tb.POINT * k
            was_first = feature > 0 and feature == old_first
            was_second = feature > 0 and feature == old_second
            manifold[tb.NORMAL_IMPULSE + at] = (
                normal_1 if was_first else normal_2 if was_second else 0.0
            )
            manifold[tb.TANGENT_IMPULSE + at] = (
                tangent_1 if was_first else tangent_2 if was_second else 0.0
            )
            manifold[tb.PRELOAD + at] = preload_1 if was_first else preload_2 if was_second else 0.0
        flags[tb.FEATURE], flags[tb.FEATURE + 1] = first, second
    count = (first > 0) + (second > 0)
    flags[tb.POINT_COUNT] = count
    return count
