"""Manifolds of two shapes with sides: find the axis of least penetration, then clip."""

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.axis_cache import (
    NOT_CACHED,
    RelativePose,
    cache_guess,
    cache_separation,
    cache_sides,
    cached_sides,
    largest_lever,
    moved_too_far,
    relative_pose,
)
from tamias2d.engine.narrow_phase.chain import BESIDE
from tamias2d.engine.narrow_phase.clip import clip_reference
from tamias2d.engine.narrow_phase.core import Core, is_thin
from tamias2d.engine.narrow_phase.separation import (
    EITHER_IS_REFERENCE,
    REFERENCE_A,
    SEPARATED,
    find_axis,
    find_axis_on_side,
    foremost_side,
    inner_radius,
    side_slack,
)
from tamias2d.engine.tables import Integers
from tamias2d.state import Array, Vector


def collide_cached(
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
    """Write the points between two shapes with sides; search for an axis if none is cached."""
    cutoff = margin + a.radius + b.radius
    pose = relative_pose(a.first, b.first, x, y, vertices)
    state, side_a, side_b = cached_sides(cache, flags, pose, cutoff)
    if state == NOT_CACHED:
        if flags[tb.CACHED_AXIS] == 0:
            side_a = foremost_side(a, x, y, vertices)
            side_b = foremost_side(b, -x, -y, vertices)
        state, side_a, side_b = search(
            manifold, cache, flags, a, side_a, b, side_b, pose, cutoff, vertices
        )
    if state == SEPARATED:
        return 0, 0
    return clip_reference(manifold, state, a, side_a, b, side_b, x, y, margin, vertices)


def search(
    manifold: Array,
    cache: Array,
    flags: Integers,
    a: Core,
    guess_a: int,
    b: Core,
    guess_b: int,
    pose: RelativePose,
    cutoff: float,
    vertices: Array,
) -> tuple[int, int, int]:
    """Return the state of the axis and the sides of A and B, and cache them for this pose.

    Of thin shapes that touch the side is known, but not for how long.
    """
    thin = is_thin(a, b)
    if thin:
        held = held_normal(manifold, flags)
        axis = find_axis_on_side(a, b, pose.x, pose.y, held, cutoff, vertices)
    else:
        axis = find_axis(a, guess_a, b, guess_b, pose.x, pose.y, cutoff, vertices)
    state, side_a, side_b = axis.state, axis.side_a, axis.side_b
    if moved_too_far(cache, flags, pose) or (thin and state != SEPARATED):
        cache_guess(cache, flags, pose, side_a, side_b)
        return state, side_a, side_b
    lever = largest_lever(a, b, pose.x, pose.y, vertices)
    if state == SEPARATED:
        cache_separation(cache, flags, pose, lever, axis, cutoff)
        return state, side_a, side_b
    if state == REFERENCE_A:
        either, slack = side_slack(a, side_a, b, side_b, pose.x, pose.y, lever, axis, vertices)
    else:
        either, slack = side_slack(b, side_b, a, side_a, -pose.x, -pose.y, lever, axis, vertices)
    if either:
        state = EITHER_IS_REFERENCE
    cache_sides(cache, flags, pose, lever, state, axis, slack)
    return state, side_a, side_b


def held_normal(manifold: Array, flags: Integers) -> Vector:
    """Return the normal of a contact that tells the side, (0, 0) of others.

    What a sensor overlaps may be on either side: nothing keeps it from passing.
    """
    if flags[tb.SENSES] == 1:
        return 0.0, 0.0
    if flags[tb.KNOWN_SIDE] == 1:
        return manifold[tb.SIDE_NORMAL], manifold[tb.SIDE_NORMAL + 1]
    if flags[tb.POINT_COUNT] > 0 and flags[tb.FEATURE] != BESIDE:
        return manifold[tb.NX], manifold[tb.NY]
    if flags[tb.POINT_COUNT] == 0 and touched(flags):
        return manifold[tb.IMPACT_NORMAL], manifold[tb.IMPACT_NORMAL + 1]
    return 0.0, 0.0


def touched(flags: Integers) -> bool:
    """Return whether a contact has points, or met in flight."""
    return bool(flags[tb.POINT_COUNT] > 0 or flags[tb.TOUCHES] >= tb.MET_IN_FLIGHT)


def collide_polygons(
    manifold: Array,
    a: Core,
    b: Core,
    x: float,
    y: float,
    margin: float,
    held: Vector,
    vertices: Array,
) -> tuple[int, int]:
    """Write the points between two shapes with sides, without a cache.

    Inradii are measured, to the last bit those of the vertices as they are turned.
    """
    if is_thin(a, b):
        found = find_axis_on_side(a, b, x, y, held, margin + a.radius + b.radius, vertices)
        if found.state == SEPARATED:
            return 0, 0
        return clip_reference(
            manifold, found.state, a, found.side_a, b, found.side_b, x, y, margin, vertices
        )
    one = Core(a.kind, a.first, a.vertex_count, a.radius, inner_radius(a, vertices))
    other = Core(b.kind, b.first, b.vertex_count, b.radius, inner_radius(b, vertices))
    guess_a, guess_b = foremost_side(a, x, y, vertices), foremost_side(b, -x, -y, vertices)
    cutoff = margin + a.radius + b.radius
    axis = find_axis(one, guess_a, other, guess_b, x, y, cutoff, vertices)
    if axis.state == SEPARATED:
        return 0, 0
    return clip_reference(
        manifold, axis.state, a, axis.side_a, b, axis.side_b, x, y, margin, vertices
    )
