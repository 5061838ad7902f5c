"""Corners of shapes in the axes of the world.

Serves: the look around and a step. Hides: which shapes need no turning.
"""

from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array
from tamias2d.stepped.layout import HALF_PLANE, TURN, Whole
from tamias2d.stepped.rotation import cosine_sine


def turn_corners(
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    kind: Whole,
    least: int,
    pose: Array,
    corner: Array,
    turned: Array,
) -> None:
    """Turn the corners of all bodies that are at least of some kind into the world's axes."""
    for s in range(len(shape_body)):
        if kind[shape_body[s]] >= least:
            turn_shape(s, shape_body, shape_kind, shape_first, shape_count, pose, corner, turned)


@inlined
def turn_shape(
    s: int,
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    pose: Array,
    corner: Array,
    turned: Array,
) -> None:
    """Turn the corners of one shape into the world's axes, unless it looks alike in all of them."""
    first = shape_first[s]
    if shape_kind[s] == HALF_PLANE or (
        shape_count[s] == 1 and corner[first, 0] == 0.0 and corner[first, 1] == 0.0
    ):
        return
    c, d = cosine_sine(pose[shape_body[s], TURN])
    for k in range(first, first + shape_count[s]):
        x, y = corner[k, 0], corner[k, 1]
        turned[k, 0], turned[k, 1] = c * x - d * y, d * x + c * y
        x, y = corner[k, 2], corner[k, 3]
        turned[k, 2], turned[k, 3] = c * x - d * y, d * x + c * y
