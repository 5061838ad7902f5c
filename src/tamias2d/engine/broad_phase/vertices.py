"""Corners of shapes in the axes of the world.

Serves: the look around and a step. Hides: which shapes need no turning.
"""

from tamias2d.engine.motion.rotation import cosine_sine
from tamias2d.engine.tables import ANGLE, HALF_PLANE, Bodies, Shapes
from tamias2d.kernels.assembled import inlined


def turn_vertices(bodies: Bodies, shapes: Shapes, least: int) -> None:
    """Turn the corners of all bodies that are at least of some kind into the world's axes."""
    for s in range(len(shapes.slot)):
        if bodies.kind[shapes.slot[s]] >= least:
            turn_shape(s, bodies, shapes)


@inlined
def turn_shape(s: int, bodies: Bodies, shapes: Shapes) -> None:
    """Turn the corners of one shape into the world's axes, unless it looks alike in all of them."""
    first = shapes.first[s]
    if shapes.kind[s] == HALF_PLANE or (
        shapes.count[s] == 1
        and shapes.local_vertices[first, 0] == 0.0
        and shapes.local_vertices[first, 1] == 0.0
    ):
        return
    c, d = cosine_sine(bodies.pose[shapes.slot[s], ANGLE])
    for k in range(first, first + shapes.count[s]):
        x, y = shapes.local_vertices[k, 0], shapes.local_vertices[k, 1]
        shapes.world_vertices[k, 0], shapes.world_vertices[k, 1] = c * x - d * y, d * x + c * y
        x, y = shapes.local_vertices[k, 2], shapes.local_vertices[k, 3]
        shapes.world_vertices[k, 2], shapes.world_vertices[k, 3] = c * x - d * y, d * x + c * y
