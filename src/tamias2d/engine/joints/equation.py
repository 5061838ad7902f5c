"""The rows of joints that a scene states by equations of its own: programs that are run (TM7).

Compiled code does not know them, and so a new equation needs no compiler. What has no value, such
as the root of a negative number, is not a number, and the step that meets it is refused.

Cost: some nanoseconds for each operation.
"""

from math import inf, nan

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Joints
from tamias2d.generated.joint_rows import ROW
from tamias2d.spec.constraint import ENDS
from tamias2d.spec.functions import atan2, cos, exp, log, sin, sqrt, tan
from tamias2d.spec.row_program import BENDS, INPUTS, PLACE, TIME_SLOPE, VALUE
from tamias2d.spec.straight_line import (
    ADD,
    COS,
    DIVIDE,
    EXP,
    LOG,
    MULTIPLY,
    NEGATE,
    SIN,
    SQRT,
    SUBTRACT,
    TAN,
)

PLACE_COUNT = len(PLACE)
CLOCK = PLACE_COUNT * len(ENDS)  # input that is the time
ANCHORS = CLOCK + 1  # the first input that is none of a place
ANCHOR_COUNT = 2 * len(ENDS)
INPUT_COUNT = len(INPUTS)
LARGEST_EXPONENT = 709.0  # of e, that float64 holds


def equation_value(j: int, joints: Joints) -> None:
    """Write how far the row of a joint is from holding, where its members are placed."""
    run_program(0, j, joints)
    joints.numbers[j, tb.J_ROW] = found(VALUE, j, joints)


def equation_row(j: int, joints: Joints) -> None:
    """Write the row of a joint with its slopes, and the rate at which it is to change."""
    run_program(1, j, joints)
    for k in range(ROW):
        joints.numbers[j, tb.J_ROW + k] = found(VALUE + k, j, joints)
    joints.laws[j, tb.LAW_RATE] = -found(TIME_SLOPE, j, joints)


def equation_bends(j: int, joints: Joints) -> None:
    """Write the second derivatives of the row of a joint by the orientations of its bodies."""
    run_program(2, j, joints)
    for end in range(tb.ENDS_OF_JOINT):
        joints.bends[end] = found(BENDS + end, j, joints)


def found(output: int, j: int, joints: Joints) -> float:
    """Return a scalar that the program of a joint has found."""
    q = joints.joints[j, tb.J_EQUATION]
    return float(joints.scalars[joints.equations[q, tb.Q_OUTPUT + output]])


def run_program(part: int, j: int, joints: Joints) -> None:
    """Run the program of a joint up to the value (0), the slopes (1) or the bends (2)."""
    q = joints.joints[j, tb.J_EQUATION]
    first, scalars = joints.equations[q, tb.Q_INPUT], joints.scalars
    for end in range(tb.ENDS_OF_JOINT):
        place = joints.places[joints.joints[j, tb.J_MEMBER + end]]
        for k in range(PLACE_COUNT):
            scalars[first + PLACE_COUNT * end + k] = place[tb.PLACE_X + k]
    scalars[first + CLOCK] = joints.clock[tb.CLOCK_NOW] + joints.clock[tb.CLOCK_AHEAD]
    for k in range(ANCHOR_COUNT):
        scalars[first + ANCHORS + k] = joints.given[j, k]
    operation = joints.equations[q, tb.Q_OPERATION]
    for k in range(joints.equations[q, tb.Q_COUNT + part]):
        row = joints.operations[operation + k]
        scalars[first + INPUT_COUNT + k] = result(row[0], scalars[row[1]], scalars[row[2]])


def result(operation: int, a: float, b: float) -> float:
    """Return what an operation yields; of one scalar, that is the first."""
    if operation == ADD:
        return a + b
    if operation == SUBTRACT:
        return a - b
    if operation == MULTIPLY:
        return a * b
    if operation == NEGATE:
        return -a
    if operation == DIVIDE:
        return a / b if b != 0.0 else nan
    if operation >= SQRT:
        return elementary(operation, a, b) if a - a == 0.0 else nan
    return a


def elementary(operation: int, a: float, b: float) -> float:
    """Return an elementary function of a finite number."""
    if operation == SQRT:
        return float(sqrt(a)) if a >= 0.0 else nan
    if operation == SIN:
        return float(sin(a))
    if operation == COS:
        return float(cos(a))
    if operation == TAN:
        return float(tan(a))
    if operation == EXP:
        return float(exp(a)) if a < LARGEST_EXPONENT else inf
    if operation == LOG:
        return float(log(a)) if a > 0.0 else nan
    return float(atan2(a, b))
