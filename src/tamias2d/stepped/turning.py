"""Corners of shapes in the axes of the world.

Serves: the look around and a step. Hides: which bodies have turned since.
"""

from math import cos, sin

from tamias2d.state import Array
from tamias2d.stepped.layout import HALF_PLANE, TURN, Whole


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
        i = shape_body[s]
        if kind[i] < least:
            continue
        first = shape_first[s]
        angle = pose[i, TURN]
        if shape_kind[s] == HALF_PLANE or (
            shape_count[s] == 1 and corner[first, 0] == 0.0 and corner[first, 1] == 0.0
        ):
            for k in range(4):
                turned[first, k] = corner[first, k]
            continue
        c, d = cos(angle), sin(angle)
        for k in range(first, first + shape_count[s]):
            x, y = corner[k, 0], corner[k, 1]
            turned[k, 0], turned[k, 1] = c * x - d * y, d * x + c * y
            x, y = corner[k, 2], corner[k, 3]
            turned[k, 2], turned[k, 3] = c * x - d * y, d * x + c * y
