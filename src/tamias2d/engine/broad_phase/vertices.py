"""Vertices of shapes in the axes of the world, which are turned only where that may change them."""

from tamias2d.engine import tables as tb
from tamias2d.engine.rotation import cosine_sine
from tamias2d.engine.tables import Bodies, Shapes
from tamias2d.kernels.assembled import inlined


def turn_vertices(bodies: Bodies, shapes: Shapes, least: int) -> None:
    """Turn the vertices of all bodies whose kind is at least this into the axes of the world."""
    for s in range(len(shapes.slot)):
        if bodies.kind[shapes.slot[s]] >= least:
            turn_shape(s, bodies, shapes)


@inlined
def turn_shape(s: int, bodies: Bodies, shapes: Shapes) -> None:
    """Turn the vertices of a shape, unless it is a disc around the centre.

    Of a half-plane, whose row holds its offset and its normal, the normal turns alone.
    """
    local, world, first = shapes.local_vertices, shapes.world_vertices, shapes.first[s]
    plane = shapes.kind[s] == tb.HALF_PLANE
    centred = local[first, 0] == 0.0 and local[first, 1] == 0.0
    if not plane and shapes.vertex_count[s] == 1 and centred:
        return
    c, d = cosine_sine(bodies.pose[shapes.slot[s], tb.ANGLE])
    for k in range(first, first + shapes.vertex_count[s]):
        x, y = local[k, 0], local[k, 1]
        if not plane:
            world[k, 0], world[k, 1] = c * x - d * y, d * x + c * y
        x, y = local[k, 2], local[k, 3]
        world[k, 2], world[k, 3] = c * x - d * y, d * x + c * y
