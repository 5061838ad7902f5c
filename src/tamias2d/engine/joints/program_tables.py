"""The programs of joints' own equations as rows of the engine's arrays."""

from collections.abc import Sequence

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.joint_row import JointRow
from tamias2d.engine.tables import Joints
from tamias2d.spec.row_program import INPUTS


def lengths_of_programs(rows: Sequence[JointRow]) -> dict[str, int]:
    """Return how long the arrays for the programs of joints are."""
    programs = [row.program for row in rows if row.program]
    operations = sum(len(program.operations) for program in programs)
    return {
        "equations": len(programs),
        "operations": operations,
        "scalars": operations + len(INPUTS) * len(programs),
    }


def write_programs(joints: Joints, rows: Sequence[JointRow], places: Sequence[int]) -> None:
    """Write the programs of joints, whose places among joints are given."""
    first = operation = equation = 0
    for row, j in zip(rows, places, strict=True):
        if (program := row.program) is None:
            continue
        joints.joints[j, tb.J_EQUATION] = equation
        numbers = joints.equations[equation]
        numbers[[tb.Q_INPUT, tb.Q_OPERATION, tb.Q_BOUND]] = first, operation, row.bound
        numbers[tb.Q_COUNT : tb.Q_COUNT + len(program.counts)] = program.counts
        outputs = [first + scalar for scalar in program.outputs]
        numbers[tb.Q_OUTPUT : tb.Q_OUTPUT + len(outputs)] = outputs
        count = len(program.operations)
        joints.operations[operation : operation + count] = [
            (does, first + one, first + other) for does, one, other in program.operations
        ]
        results = first + len(INPUTS)
        joints.scalars[results : results + count] = program.constants
        first, operation, equation = results + count, operation + count, equation + 1
