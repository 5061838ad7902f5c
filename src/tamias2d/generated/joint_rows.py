"""Rows of joints: Revolute joint; Distance joint; Weld; Prismatic joint; Groove; Gear; Pulley;
Angle between two bodies; Travel along a line.

Places are rows of x, y (m), orientation (rad), and its cosine and sine. Each row of a joint takes
ten numbers: its value, then its slopes by x, y and orientation of bodies A, B and C. The second
derivatives by the orientations of these are three numbers for each row.

Generated from srs/models/joints.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from typing import Any

from tamias2d.spec.functions import sqrt

ROW = 10  # numbers of a row
MOST_ROWS = 3  # rows of a joint
MOST_PARAMETERS = 10  # numbers that a joint is given


KINDS = (
    "revolute",
    "distance",
    "weld",
    "prismatic",
    "groove",
    "gear",
    "pulley",
    "angle",
    "travel",
)
"""By which number of a kind."""
ROWS_OF_KIND = (
    2,
    1,
    3,
    2,
    1,
    1,
    1,
    1,
    1,
)


def revolute_values(given: Any, a: Any, b: Any, row: Any) -> None:
    """Revolute joint: how far each row is from holding.

    Source: revolute, srs/models/joints.md:227.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    anchor_b_x, anchor_b_y = given[2], given[3]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    row[0] = span_x
    row[10] = span_y


def revolute_rows(given: Any, a: Any, b: Any, row: Any) -> None:
    """Revolute joint: its rows with their slopes.

    Source: revolute, srs/models/joints.md:227.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    anchor_b_x, anchor_b_y = given[2], given[3]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    row[0] = span_x
    row[1] = -1
    row[2] = 0
    row[3] = arm_a_y
    row[4] = 1
    row[5] = 0
    row[6] = -arm_b_y
    row[7] = 0.0
    row[8] = 0.0
    row[9] = 0.0
    row[10] = span_y
    row[11] = 0
    row[12] = -1
    row[13] = -arm_a_x
    row[14] = 0
    row[15] = 1
    row[16] = arm_b_x
    row[17] = 0.0
    row[18] = 0.0
    row[19] = 0.0


def revolute_bends(given: Any, a: Any, b: Any, row: Any) -> None:
    """Revolute joint: second derivatives of its rows by orientations.

    Source: revolute, srs/models/joints.md:227.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    anchor_b_x, anchor_b_y = given[2], given[3]
    cosine_a, sine_a = a[3], a[4]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    row[0] = arm_a_x
    row[1] = -arm_b_x
    row[2] = 0.0
    row[3] = arm_a_y
    row[4] = -arm_b_y
    row[5] = 0.0


def distance_values(given: Any, a: Any, b: Any, row: Any) -> None:
    """Distance joint: how far each row is from holding.

    Source: distance, srs/models/joints.md:241.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    anchor_b_x, anchor_b_y = given[2], given[3]
    joint_length = given[4]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    distance = sqrt(span_x * span_x + span_y * span_y)
    row[0] = distance - joint_length


def distance_rows(given: Any, a: Any, b: Any, row: Any) -> None:
    """Distance joint: its rows with their slopes.

    Source: distance, srs/models/joints.md:241.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    anchor_b_x, anchor_b_y = given[2], given[3]
    joint_length = given[4]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    distance = sqrt(span_x * span_x + span_y * span_y)
    row[0] = distance - joint_length
    row[1] = (-span_x) / distance
    row[2] = (-span_y) / distance
    row[3] = (-((-arm_a_y) * span_x + (arm_a_x) * span_y)) / distance
    row[4] = span_x / distance
    row[5] = span_y / distance
    row[6] = (span_x * (-arm_b_y) + span_y * (arm_b_x)) / distance
    row[7] = 0.0
    row[8] = 0.0
    row[9] = 0.0


def distance_bends(given: Any, a: Any, b: Any, row: Any) -> None:
    """Distance joint: second derivatives of its rows by orientations.

    Source: distance, srs/models/joints.md:241.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    anchor_b_x, anchor_b_y = given[2], given[3]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    distance = sqrt(span_x * span_x + span_y * span_y)
    row[0] = (
        arm_a_x * arm_a_x + arm_a_y * arm_a_y + (arm_a_x * span_x + arm_a_y * span_y)
    ) / distance - (
        -((-arm_a_y) * span_x + (arm_a_x) * span_y)
        * (-((-arm_a_y) * span_x + (arm_a_x) * span_y))
        / distance
    ) / (distance * distance)
    row[1] = (
        arm_b_x * arm_b_x + arm_b_y * arm_b_y - (arm_b_x * span_x + arm_b_y * span_y)
    ) / distance - (span_x * (-arm_b_y) + span_y * (arm_b_x)) * (
        span_x * (-arm_b_y) + span_y * (arm_b_x)
    ) / distance / (distance * distance)
    row[2] = 0.0


def weld_values(given: Any, a: Any, b: Any, row: Any) -> None:
    """Weld: how far each row is from holding.

    Source: weld, srs/models/joints.md:258.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    anchor_b_x, anchor_b_y = given[2], given[3]
    joint_angle = given[4]
    position_a_x, position_a_y = a[0], a[1]
    orientation_a = a[2]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    orientation_b = b[2]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    row[0] = span_x
    row[10] = span_y
    row[20] = orientation_b - orientation_a - joint_angle


def weld_rows(given: Any, a: Any, b: Any, row: Any) -> None:
    """Weld: its rows with their slopes.

    Source: weld, srs/models/joints.md:258.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    anchor_b_x, anchor_b_y = given[2], given[3]
    joint_angle = given[4]
    position_a_x, position_a_y = a[0], a[1]
    orientation_a = a[2]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    orientation_b = b[2]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    row[0] = span_x
    row[1] = -1
    row[2] = 0
    row[3] = arm_a_y
    row[4] = 1
    row[5] = 0
    row[6] = -arm_b_y
    row[7] = 0.0
    row[8] = 0.0
    row[9] = 0.0
    row[10] = span_y
    row[11] = 0
    row[12] = -1
    row[13] = -arm_a_x
    row[14] = 0
    row[15] = 1
    row[16] = arm_b_x
    row[17] = 0.0
    row[18] = 0.0
    row[19] = 0.0
    row[20] = orientation_b - orientation_a - joint_angle
    row[21] = 0
    row[22] = 0
    row[23] = -1
    row[24] = 0
    row[25] = 0
    row[26] = 1
    row[27] = 0.0
    row[28] = 0.0
    row[29] = 0.0


def weld_bends(given: Any, a: Any, b: Any, row: Any) -> None:
    """Weld: second derivatives of its rows by orientations.

    Source: weld, srs/models/joints.md:258.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    anchor_b_x, anchor_b_y = given[2], given[3]
    cosine_a, sine_a = a[3], a[4]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    row[0] = arm_a_x
    row[1] = -arm_b_x
    row[2] = 0.0
    row[3] = arm_a_y
    row[4] = -arm_b_y
    row[5] = 0.0
    row[6] = 0
    row[7] = 0
    row[8] = 0.0


def prismatic_values(given: Any, a: Any, b: Any, row: Any) -> None:
    """Prismatic joint: how far each row is from holding.

    Source: prismatic, srs/models/joints.md:271.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    guide_a_x, guide_a_y = given[2], given[3]
    anchor_b_x, anchor_b_y = given[4], given[5]
    joint_angle = given[6]
    position_a_x, position_a_y = a[0], a[1]
    orientation_a = a[2]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    orientation_b = b[2]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    guide_x, guide_y = (
        cosine_a * guide_a_x - sine_a * guide_a_y,
        sine_a * guide_a_x + cosine_a * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    row[0] = (-guide_y) * span_x + (guide_x) * span_y
    row[10] = orientation_b - orientation_a - joint_angle


def prismatic_rows(given: Any, a: Any, b: Any, row: Any) -> None:
    """Prismatic joint: its rows with their slopes.

    Source: prismatic, srs/models/joints.md:271.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    guide_a_x, guide_a_y = given[2], given[3]
    anchor_b_x, anchor_b_y = given[4], given[5]
    joint_angle = given[6]
    position_a_x, position_a_y = a[0], a[1]
    orientation_a = a[2]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    orientation_b = b[2]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    guide_x, guide_y = (
        cosine_a * guide_a_x - sine_a * guide_a_y,
        sine_a * guide_a_x + cosine_a * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    row[0] = (-guide_y) * span_x + (guide_x) * span_y
    row[1] = guide_y
    row[2] = -guide_x
    row[3] = -(guide_x * span_x + guide_y * span_y) - (arm_a_x * guide_x + arm_a_y * guide_y)
    row[4] = -guide_y
    row[5] = guide_x
    row[6] = guide_x * arm_b_x + guide_y * arm_b_y
    row[7] = 0.0
    row[8] = 0.0
    row[9] = 0.0
    row[10] = orientation_b - orientation_a - joint_angle
    row[11] = 0
    row[12] = 0
    row[13] = -1
    row[14] = 0
    row[15] = 0
    row[16] = 1
    row[17] = 0.0
    row[18] = 0.0
    row[19] = 0.0


def prismatic_bends(given: Any, a: Any, b: Any, row: Any) -> None:
    """Prismatic joint: second derivatives of its rows by orientations.

    Source: prismatic, srs/models/joints.md:271.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    guide_a_x, guide_a_y = given[2], given[3]
    anchor_b_x, anchor_b_y = given[4], given[5]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    guide_x, guide_y = (
        cosine_a * guide_a_x - sine_a * guide_a_y,
        sine_a * guide_a_x + cosine_a * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    row[0] = (
        (-arm_a_y) * guide_x
        + (arm_a_x) * guide_y
        - ((-guide_y) * span_x + (guide_x) * span_y)
        - ((-arm_a_y) * guide_x + (arm_a_x) * guide_y + arm_a_x * (-guide_y) + arm_a_y * (guide_x))
    )
    row[1] = guide_x * (-arm_b_y) + guide_y * (arm_b_x)
    row[2] = 0.0
    row[3] = 0
    row[4] = 0
    row[5] = 0.0


def groove_values(given: Any, a: Any, b: Any, row: Any) -> None:
    """Groove: how far each row is from holding.

    Source: groove, srs/models/joints.md:288.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    guide_a_x, guide_a_y = given[2], given[3]
    anchor_b_x, anchor_b_y = given[4], given[5]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    guide_x, guide_y = (
        cosine_a * guide_a_x - sine_a * guide_a_y,
        sine_a * guide_a_x + cosine_a * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    row[0] = (-guide_y) * span_x + (guide_x) * span_y


def groove_rows(given: Any, a: Any, b: Any, row: Any) -> None:
    """Groove: its rows with their slopes.

    Source: groove, srs/models/joints.md:288.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    guide_a_x, guide_a_y = given[2], given[3]
    anchor_b_x, anchor_b_y = given[4], given[5]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    guide_x, guide_y = (
        cosine_a * guide_a_x - sine_a * guide_a_y,
        sine_a * guide_a_x + cosine_a * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    row[0] = (-guide_y) * span_x + (guide_x) * span_y
    row[1] = guide_y
    row[2] = -guide_x
    row[3] = -(guide_x * span_x + guide_y * span_y) - (arm_a_x * guide_x + arm_a_y * guide_y)
    row[4] = -guide_y
    row[5] = guide_x
    row[6] = guide_x * arm_b_x + guide_y * arm_b_y
    row[7] = 0.0
    row[8] = 0.0
    row[9] = 0.0


def groove_bends(given: Any, a: Any, b: Any, row: Any) -> None:
    """Groove: second derivatives of its rows by orientations.

    Source: groove, srs/models/joints.md:288.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    guide_a_x, guide_a_y = given[2], given[3]
    anchor_b_x, anchor_b_y = given[4], given[5]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    guide_x, guide_y = (
        cosine_a * guide_a_x - sine_a * guide_a_y,
        sine_a * guide_a_x + cosine_a * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    row[0] = (
        (-arm_a_y) * guide_x
        + (arm_a_x) * guide_y
        - ((-guide_y) * span_x + (guide_x) * span_y)
        - ((-arm_a_y) * guide_x + (arm_a_x) * guide_y + arm_a_x * (-guide_y) + arm_a_y * (guide_x))
    )
    row[1] = guide_x * (-arm_b_y) + guide_y * (arm_b_x)
    row[2] = 0.0


def gear_values(given: Any, a: Any, b: Any, c: Any, row: Any) -> None:
    """Gear: how far each row is from holding.

    Source: gear, srs/models/joints.md:304.
    """
    gear_ratio = given[0]
    joint_angle = given[1]
    orientation_a = a[2]
    orientation_b = b[2]
    orientation_c = c[2]
    row[0] = (
        orientation_b - orientation_c - gear_ratio * (orientation_a - orientation_c) - joint_angle
    )


def gear_rows(given: Any, a: Any, b: Any, c: Any, row: Any) -> None:
    """Gear: its rows with their slopes.

    Source: gear, srs/models/joints.md:304.
    """
    gear_ratio = given[0]
    joint_angle = given[1]
    orientation_a = a[2]
    orientation_b = b[2]
    orientation_c = c[2]
    row[0] = (
        orientation_b - orientation_c - gear_ratio * (orientation_a - orientation_c) - joint_angle
    )
    row[1] = 0
    row[2] = 0
    row[3] = -gear_ratio
    row[4] = 0
    row[5] = 0
    row[6] = 1
    row[7] = 0
    row[8] = 0
    row[9] = -1 + gear_ratio


def gear_bends(row: Any) -> None:
    """Gear: second derivatives of its rows by orientations.

    Source: gear, srs/models/joints.md:304.
    """
    row[0] = 0
    row[1] = 0
    row[2] = 0


def pulley_values(given: Any, a: Any, b: Any, c: Any, row: Any) -> None:
    """Pulley: how far each row is from holding.

    Source: pulley, srs/models/joints.md:322.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    anchor_b_x, anchor_b_y = given[2], given[3]
    post_a_x, post_a_y = given[4], given[5]
    post_b_x, post_b_y = given[6], given[7]
    gear_ratio = given[8]
    joint_length = given[9]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    position_c_x, position_c_y = c[0], c[1]
    cosine_c, sine_c = c[3], c[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    arm_c_a_x, arm_c_a_y = (
        cosine_c * post_a_x - sine_c * post_a_y,
        sine_c * post_a_x + cosine_c * post_a_y,
    )
    arm_c_b_x, arm_c_b_y = (
        cosine_c * post_b_x - sine_c * post_b_y,
        sine_c * post_b_x + cosine_c * post_b_y,
    )
    span_a_x, span_a_y = (
        position_a_x + arm_a_x - position_c_x - arm_c_a_x,
        position_a_y + arm_a_y - position_c_y - arm_c_a_y,
    )
    span_b_x, span_b_y = (
        position_b_x + arm_b_x - position_c_x - arm_c_b_x,
        position_b_y + arm_b_y - position_c_y - arm_c_b_y,
    )
    distance_a = sqrt(span_a_x * span_a_x + span_a_y * span_a_y)
    distance_b = sqrt(span_b_x * span_b_x + span_b_y * span_b_y)
    row[0] = distance_a + gear_ratio * distance_b - joint_length


def pulley_rows(given: Any, a: Any, b: Any, c: Any, row: Any) -> None:
    """Pulley: its rows with their slopes.

    Source: pulley, srs/models/joints.md:322.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    anchor_b_x, anchor_b_y = given[2], given[3]
    post_a_x, post_a_y = given[4], given[5]
    post_b_x, post_b_y = given[6], given[7]
    gear_ratio = given[8]
    joint_length = given[9]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    position_c_x, position_c_y = c[0], c[1]
    cosine_c, sine_c = c[3], c[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    arm_c_a_x, arm_c_a_y = (
        cosine_c * post_a_x - sine_c * post_a_y,
        sine_c * post_a_x + cosine_c * post_a_y,
    )
    arm_c_b_x, arm_c_b_y = (
        cosine_c * post_b_x - sine_c * post_b_y,
        sine_c * post_b_x + cosine_c * post_b_y,
    )
    span_a_x, span_a_y = (
        position_a_x + arm_a_x - position_c_x - arm_c_a_x,
        position_a_y + arm_a_y - position_c_y - arm_c_a_y,
    )
    span_b_x, span_b_y = (
        position_b_x + arm_b_x - position_c_x - arm_c_b_x,
        position_b_y + arm_b_y - position_c_y - arm_c_b_y,
    )
    distance_a = sqrt(span_a_x * span_a_x + span_a_y * span_a_y)
    distance_b = sqrt(span_b_x * span_b_x + span_b_y * span_b_y)
    row[0] = distance_a + gear_ratio * distance_b - joint_length
    row[1] = span_a_x / distance_a
    row[2] = span_a_y / distance_a
    row[3] = (span_a_x * (-arm_a_y) + span_a_y * (arm_a_x)) / distance_a
    row[4] = gear_ratio * span_b_x / distance_b
    row[5] = gear_ratio * span_b_y / distance_b
    row[6] = gear_ratio * (span_b_x * (-arm_b_y) + span_b_y * (arm_b_x)) / distance_b
    row[7] = (-span_a_x) / distance_a + gear_ratio * (-span_b_x) / distance_b
    row[8] = (-span_a_y) / distance_a + gear_ratio * (-span_b_y) / distance_b
    row[9] = (-((-arm_c_a_y) * span_a_x + (arm_c_a_x) * span_a_y)) / distance_a + gear_ratio * (
        -((-arm_c_b_y) * span_b_x + (arm_c_b_x) * span_b_y)
    ) / distance_b


def pulley_bends(given: Any, a: Any, b: Any, c: Any, row: Any) -> None:
    """Pulley: second derivatives of its rows by orientations.

    Source: pulley, srs/models/joints.md:322.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    anchor_b_x, anchor_b_y = given[2], given[3]
    post_a_x, post_a_y = given[4], given[5]
    post_b_x, post_b_y = given[6], given[7]
    gear_ratio = given[8]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    position_c_x, position_c_y = c[0], c[1]
    cosine_c, sine_c = c[3], c[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_c_a_x, arm_c_a_y = (
        cosine_c * post_a_x - sine_c * post_a_y,
        sine_c * post_a_x + cosine_c * post_a_y,
    )
    span_a_x, span_a_y = (
        position_a_x + arm_a_x - position_c_x - arm_c_a_x,
        position_a_y + arm_a_y - position_c_y - arm_c_a_y,
    )
    distance_a = sqrt(span_a_x * span_a_x + span_a_y * span_a_y)
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    arm_c_b_x, arm_c_b_y = (
        cosine_c * post_b_x - sine_c * post_b_y,
        sine_c * post_b_x + cosine_c * post_b_y,
    )
    span_b_x, span_b_y = (
        position_b_x + arm_b_x - position_c_x - arm_c_b_x,
        position_b_y + arm_b_y - position_c_y - arm_c_b_y,
    )
    distance_b = sqrt(span_b_x * span_b_x + span_b_y * span_b_y)
    row[0] = (
        arm_a_x * arm_a_x + arm_a_y * arm_a_y - (arm_a_x * span_a_x + arm_a_y * span_a_y)
    ) / distance_a - (span_a_x * (-arm_a_y) + span_a_y * (arm_a_x)) * (
        span_a_x * (-arm_a_y) + span_a_y * (arm_a_x)
    ) / distance_a / (distance_a * distance_a)
    row[1] = gear_ratio * (
        (arm_b_x * arm_b_x + arm_b_y * arm_b_y - (arm_b_x * span_b_x + arm_b_y * span_b_y))
        / distance_b
        - (span_b_x * (-arm_b_y) + span_b_y * (arm_b_x))
        * (span_b_x * (-arm_b_y) + span_b_y * (arm_b_x))
        / distance_b
        / (distance_b * distance_b)
    )
    row[2] = (
        (
            arm_c_a_x * arm_c_a_x
            + arm_c_a_y * arm_c_a_y
            + (arm_c_a_x * span_a_x + arm_c_a_y * span_a_y)
        )
        / distance_a
        - (
            -((-arm_c_a_y) * span_a_x + (arm_c_a_x) * span_a_y)
            * (-((-arm_c_a_y) * span_a_x + (arm_c_a_x) * span_a_y))
            / distance_a
        )
        / (distance_a * distance_a)
        + gear_ratio
        * (
            (
                arm_c_b_x * arm_c_b_x
                + arm_c_b_y * arm_c_b_y
                + (arm_c_b_x * span_b_x + arm_c_b_y * span_b_y)
            )
            / distance_b
            - (
                -((-arm_c_b_y) * span_b_x + (arm_c_b_x) * span_b_y)
                * (-((-arm_c_b_y) * span_b_x + (arm_c_b_x) * span_b_y))
                / distance_b
            )
            / (distance_b * distance_b)
        )
    )


def angle_values(given: Any, a: Any, b: Any, row: Any) -> None:
    """Angle between two bodies: how far each row is from holding.

    Source: angle, srs/models/joints.md:354.
    """
    joint_angle = given[0]
    orientation_a = a[2]
    orientation_b = b[2]
    row[0] = orientation_b - orientation_a - joint_angle


def angle_rows(given: Any, a: Any, b: Any, row: Any) -> None:
    """Angle between two bodies: its rows with their slopes.

    Source: angle, srs/models/joints.md:354.
    """
    joint_angle = given[0]
    orientation_a = a[2]
    orientation_b = b[2]
    row[0] = orientation_b - orientation_a - joint_angle
    row[1] = 0
    row[2] = 0
    row[3] = -1
    row[4] = 0
    row[5] = 0
    row[6] = 1
    row[7] = 0.0
    row[8] = 0.0
    row[9] = 0.0


def angle_bends(row: Any) -> None:
    """Angle between two bodies: second derivatives of its rows by orientations.

    Source: angle, srs/models/joints.md:354.
    """
    row[0] = 0
    row[1] = 0
    row[2] = 0.0


def travel_values(given: Any, a: Any, b: Any, row: Any) -> None:
    """Travel along a line: how far each row is from holding.

    Source: travel, srs/models/joints.md:364.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    guide_a_x, guide_a_y = given[2], given[3]
    anchor_b_x, anchor_b_y = given[4], given[5]
    joint_travel = given[6]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    guide_x, guide_y = (
        cosine_a * guide_a_x - sine_a * guide_a_y,
        sine_a * guide_a_x + cosine_a * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    row[0] = guide_x * span_x + guide_y * span_y - joint_travel


def travel_rows(given: Any, a: Any, b: Any, row: Any) -> None:
    """Travel along a line: its rows with their slopes.

    Source: travel, srs/models/joints.md:364.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    guide_a_x, guide_a_y = given[2], given[3]
    anchor_b_x, anchor_b_y = given[4], given[5]
    joint_travel = given[6]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    guide_x, guide_y = (
        cosine_a * guide_a_x - sine_a * guide_a_y,
        sine_a * guide_a_x + cosine_a * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    row[0] = guide_x * span_x + guide_y * span_y - joint_travel
    row[1] = -guide_x
    row[2] = -guide_y
    row[3] = (-guide_y) * span_x + (guide_x) * span_y - ((-arm_a_y) * guide_x + (arm_a_x) * guide_y)
    row[4] = guide_x
    row[5] = guide_y
    row[6] = guide_x * (-arm_b_y) + guide_y * (arm_b_x)
    row[7] = 0.0
    row[8] = 0.0
    row[9] = 0.0


def travel_bends(given: Any, a: Any, b: Any, row: Any) -> None:
    """Travel along a line: second derivatives of its rows by orientations.

    Source: travel, srs/models/joints.md:364.
    """
    anchor_a_x, anchor_a_y = given[0], given[1]
    guide_a_x, guide_a_y = given[2], given[3]
    anchor_b_x, anchor_b_y = given[4], given[5]
    position_a_x, position_a_y = a[0], a[1]
    cosine_a, sine_a = a[3], a[4]
    position_b_x, position_b_y = b[0], b[1]
    cosine_b, sine_b = b[3], b[4]
    arm_a_x, arm_a_y = (
        cosine_a * anchor_a_x - sine_a * anchor_a_y,
        sine_a * anchor_a_x + cosine_a * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cosine_b * anchor_b_x - sine_b * anchor_b_y,
        sine_b * anchor_b_x + cosine_b * anchor_b_y,
    )
    guide_x, guide_y = (
        cosine_a * guide_a_x - sine_a * guide_a_y,
        sine_a * guide_a_x + cosine_a * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    row[0] = (
        -(guide_x * span_x + guide_y * span_y)
        - (arm_a_x * guide_x + arm_a_y * guide_y)
        - (-(arm_a_x * guide_x + arm_a_y * guide_y) + arm_a_x * guide_x + arm_a_y * guide_y)
    )
    row[1] = -(arm_b_x * guide_x + arm_b_y * guide_y)
    row[2] = 0.0


def joint_values(kind: int, given: Any, a: Any, b: Any, c: Any, row: Any) -> None:
    """Write how far each row of a joint of a kind is from holding."""
    if kind == 0:
        revolute_values(given, a, b, row)
    elif kind == 1:
        distance_values(given, a, b, row)
    elif kind == 2:
        weld_values(given, a, b, row)
    elif kind == 3:
        prismatic_values(given, a, b, row)
    elif kind == 4:
        groove_values(given, a, b, row)
    elif kind == 5:
        gear_values(given, a, b, c, row)
    elif kind == 6:
        pulley_values(given, a, b, c, row)
    elif kind == 7:
        angle_values(given, a, b, row)
    elif kind == 8:
        travel_values(given, a, b, row)


def joint_rows(kind: int, given: Any, a: Any, b: Any, c: Any, row: Any) -> None:
    """Write the rows of a joint of a kind with their slopes."""
    if kind == 0:
        revolute_rows(given, a, b, row)
    elif kind == 1:
        distance_rows(given, a, b, row)
    elif kind == 2:
        weld_rows(given, a, b, row)
    elif kind == 3:
        prismatic_rows(given, a, b, row)
    elif kind == 4:
        groove_rows(given, a, b, row)
    elif kind == 5:
        gear_rows(given, a, b, c, row)
    elif kind == 6:
        pulley_rows(given, a, b, c, row)
    elif kind == 7:
        angle_rows(given, a, b, row)
    elif kind == 8:
        travel_rows(given, a, b, row)


def joint_bends(kind: int, given: Any, a: Any, b: Any, c: Any, row: Any) -> None:
    """Write the second derivatives of a joint of a kind by orientations."""
    if kind == 0:
        revolute_bends(given, a, b, row)
    elif kind == 1:
        distance_bends(given, a, b, row)
    elif kind == 2:
        weld_bends(given, a, b, row)
    elif kind == 3:
        prismatic_bends(given, a, b, row)
    elif kind == 4:
        groove_bends(given, a, b, row)
    elif kind == 5:
        gear_bends(row)
    elif kind == 6:
        pulley_bends(given, a, b, c, row)
    elif kind == 7:
        angle_bends(row)
    elif kind == 8:
        travel_bends(given, a, b, row)
