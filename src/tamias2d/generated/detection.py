"""Detection: Overlap of axis-parallel boxes.

Generated from srs/models/detection.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Truth, Vector


def overlap(
    center_a: Vector,
    width_a: Scalar,
    height_a: Scalar,
    center_b: Vector,
    width_b: Scalar,
    height_b: Scalar,
) -> Truth:
    """Whether two axis-parallel boxes have a common point, true or false (1).

    overlap = abs(x(center_a) - x(center_b)) <= (width_a + width_b)/2 and abs(y(center_a) -
    y(center_b)) <= (height_a + height_b)/2

    Args:
        center_a: Centre of a box whose sides are parallel to the axes; of body A, m
        width_a: Extent of a box along its own x axis; of body A, m
        height_a: Extent of a box along its own y axis; of body A, m
        center_b: Centre of a box whose sides are parallel to the axes; of body B, m
        width_b: Extent of a box along its own x axis; of body B, m
        height_b: Extent of a box along its own y axis; of body B, m

    Source: IM4, srs/models/detection.md:23.
    """
    center_a_x, center_a_y = center_a
    center_b_x, center_b_y = center_b
    return (abs(center_a_x - center_b_x) <= (width_a + width_b) / 2) & (
        abs(center_a_y - center_b_y) <= (height_a + height_b) / 2
    )
