"""Whether circles around two shapes keep away from each other on their paths; how shapes turn."""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.conservative_advancement import NEAR, place_vertices
from tamias2d.engine.continuous.trajectory import relative_place
from tamias2d.engine.narrow_phase.core import core_of
from tamias2d.engine.narrow_phase.half_plane import is_above
from tamias2d.engine.tables import Bodies, Shapes
from tamias2d.generated.continuous_collision import fraction_closest
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array


def smaller_radius(s: int, t: int, material: Array) -> float:
    """Return the smaller bounding radius of two shapes, m."""
    return min(material[s, tb.SHAPE_RADIUS], material[t, tb.SHAPE_RADIUS])


@inlined
def keep_away(s: int, t: int, now: float, bodies: Bodies, shapes: Shapes) -> bool:
    """Return whether the circles around two shapes do not come near in the rest of a part."""
    if shapes.kind[t] == tb.HALF_PLANE:
        s, t = t, s
    i, j = shapes.slot[s], shapes.slot[t]
    near = NEAR * smaller_radius(s, t, shapes.material)
    if shapes.kind[s] == tb.HALF_PLANE:
        return bodies.kind[i] == tb.STATIC and stays_above(s, t, now, near, bodies, shapes)
    reach = shapes.material[s, tb.SHAPE_RADIUS] + shapes.material[t, tb.SHAPE_RADIUS] + near
    return passes_by(i, j, now, reach, bodies.pose, bodies.motion)


@inlined
def stays_above(
    plane: int, t: int, now: float, near: float, bodies: Bodies, shapes: Shapes
) -> bool:
    """Return whether a shape is farther from a half-plane now, m, and at the end of its path."""
    i, j, motion = shapes.slot[plane], shapes.slot[t], bodies.motion
    by = (motion[j, tb.DX] - motion[i, tb.DX], motion[j, tb.DY] - motion[i, tb.DY])
    x, y = relative_place(i, j, now, bodies.pose, motion)
    rest = 1.0 - now
    side, radius = shapes.world_vertices[shapes.first[plane]], shapes.material[t, tb.SHAPE_RADIUS]
    after = is_above(x + rest * by[0], y + rest * by[1], radius, near, side)
    return after & is_above(x, y, radius, near, side)


@inlined
def passes_by(i: int, j: int, now: float, reach: float, pose: Array, motion: Array) -> bool:
    """Return whether the centres of two bodies come no nearer to each other than a reach, m."""
    by_x, by_y = motion[j, tb.DX] - motion[i, tb.DX], motion[j, tb.DY] - motion[i, tb.DY]
    x, y = relative_place(i, j, now, pose, motion)
    if x * by_x + y * by_y < 0.0:  # to where they are nearest, but not beyond the step
        until = min(fraction_closest((x, y), (by_x, by_y)), 1.0 - now)
        x, y = x + until * by_x, y + until * by_y
    return bool(x * x + y * y > reach * reach)


def turn_shape_to(s: int, i: int, now: float, bodies: Bodies, shapes: Shapes) -> None:
    """Turn the vertices of a shape to where they are at a fraction of the step."""
    core = core_of(s, shapes)
    turn = bodies.pose[i, tb.ANGLE] + now * bodies.motion[i, tb.DANGLE]
    place_vertices(core, turn, shapes.local_vertices, core.first, shapes.world_vertices)
