"""The rows of a joint where its members are placed: by its kind, or by an equation of its own."""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.equation import equation_bends, equation_row, equation_value
from tamias2d.engine.tables import Joints
from tamias2d.generated.joint_rows import joint_bends, joint_rows, joint_values
from tamias2d.kernels.assembled import inlined


@inlined
def write_values(j: int, joints: Joints) -> None:
    """Write how far each row of a joint is from holding."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    if ends[tb.J_EQUATION] >= 0:
        equation_value(j, joints)
        return
    a, b, c = ends[tb.J_MEMBER], ends[tb.J_MEMBER + 1], ends[tb.J_MEMBER + 2]
    place_a, place_b, place_c = joints.places[a], joints.places[b], joints.places[c]
    joint_values(ends[tb.J_KIND], joints.given[j], place_a, place_b, place_c, numbers)


@inlined
def write_slopes(j: int, joints: Joints) -> None:
    """Write the rows of a joint with their slopes."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    if ends[tb.J_EQUATION] >= 0:
        equation_row(j, joints)
        return
    a, b, c = ends[tb.J_MEMBER], ends[tb.J_MEMBER + 1], ends[tb.J_MEMBER + 2]
    place_a, place_b, place_c = joints.places[a], joints.places[b], joints.places[c]
    joint_rows(ends[tb.J_KIND], joints.given[j], place_a, place_b, place_c, numbers)


@inlined
def write_bends(j: int, joints: Joints) -> None:
    """Write the second derivatives of the rows of a joint by the orientations of its bodies."""
    ends, bends = joints.joints[j], joints.bends
    if ends[tb.J_EQUATION] >= 0:
        equation_bends(j, joints)
        return
    a, b, c = ends[tb.J_MEMBER], ends[tb.J_MEMBER + 1], ends[tb.J_MEMBER + 2]
    place_a, place_b, place_c = joints.places[a], joints.places[b], joints.places[c]
    joint_bends(ends[tb.J_KIND], joints.given[j], place_a, place_b, place_c, bends)
