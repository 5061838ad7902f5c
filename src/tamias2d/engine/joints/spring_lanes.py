"""Springs of the angles of hinges side by side, a lane for each tree: what `angle_laws` does.

Each node of a tree has one at most. A lane without a spring has one that is not firm.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.hinge_tree import slight_turn
from tamias2d.engine.joints.hinged_yield import yield_with_hinge
from tamias2d.engine.joints.linearise import firmness_that_yields
from tamias2d.generated.hinge_tree import law_impulse
from tamias2d.generated.joint_step import (
    angular_velocity_later,
    coupled_inertia,
    implicit_share,
    left_impulse,
    row_impulse,
    row_rate,
    row_yield,
    spring_error,
    spring_firmness,
)
from tamias2d.kernels.assembled import separate
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array


@separate
def begin_springs_of_lanes(row: Array) -> None:
    """Begin a substep, in which the springs of a row lack what they had left."""
    for m in range(LANES):
        row[tb.T_LAW_GIVEN + m] = -row[tb.T_LAW_LEFT + m]


@separate
def note_angles_of_lanes(row: Array, above: Array) -> None:
    """Note the angles of the springs of a row where bodies are."""
    for m in range(LANES):
        angle = row[tb.T_LAW_SIDE + m] * (row[tb.T_ANGLE + m] - above[tb.T_ANGLE + m])
        row[tb.T_LAW_START + m] = angle - row[tb.T_JOINT_ANGLE + m]


@separate
def firm_lanes(substep: float, lanes: Array, row: Array, above: Array) -> None:
    """Find how firm the springs of a row are in a substep, s; a body may not turn."""
    for m in range(LANES):
        side, held = row[tb.T_LAW_SIDE + m], row[tb.T_HELD_INVERSE_INERTIA + m]
        held_above = above[tb.T_HELD_INVERSE_INERTIA + m]
        turning = side if held > 0.0 else 0.0
        far = -side if held_above > 0.0 else 0.0
        yielding = row_yield((0.0, 0.0), turning, 0.0, held)
        yielding += row_yield((0.0, 0.0), far, 0.0, held_above)
        stiffness, damping = row[tb.T_STIFFNESS + m], row[tb.T_DAMPING + m]
        spins = (
            angular_velocity_later(0.0, 1.0, turning, held),
            angular_velocity_later(0.0, 1.0, far, held_above),
        )
        mass = row[tb.T_INVERSE_MASS + m]
        inverse = (mass if mass > 0.0 else 1.0, held)
        inverse_above = (above[tb.T_INVERSE_MASS + m], held_above)
        arm = (row[tb.T_ARM_X + m], row[tb.T_ARM_Y + m])
        far_arm = (row[tb.T_FAR_ARM_X + m], row[tb.T_FAR_ARM_Y + m])
        hinged = yield_with_hinge(yielding, (0.0, 0.0), spins, arm, far_arm, inverse, inverse_above)
        share = implicit_share(stiffness, damping, hinged, substep)
        firm = spring_firmness(stiffness, damping, share, substep)
        firm = min(firmness_that_yields(yielding), firm)
        row[tb.T_LAW_SHARE + m] = share
        slight = min(lanes[tb.T_SLIGHT + m], slight_turn(share))
        lanes[tb.T_SLIGHT + m] = slight if side != 0.0 else lanes[tb.T_SLIGHT + m]
        row[tb.T_TURNING + m], row[tb.T_FAR_TURNING + m] = turning, far
        row[tb.T_FIRMNESS + m], row[tb.T_FIRM + m] = firm, coupled_inertia(turning, turning, firm)


@separate
def spring_errors_of_lanes(substep: float, lanes: Array, row: Array, above: Array) -> None:
    """Write the rates that the springs of a row have not answered yet."""
    for m in range(LANES):
        angle = row[tb.T_LAW_SIDE + m] * (row[tb.T_ANGLE + m] - above[tb.T_ANGLE + m])
        angle -= row[tb.T_JOINT_ANGLE + m]
        rate = row_rate((0.0, 0.0), row[tb.T_TURNING + m], (0.0, 0.0), row[tb.T_SPIN + m])
        rate += row_rate((0.0, 0.0), row[tb.T_FAR_TURNING + m], (0.0, 0.0), above[tb.T_SPIN + m])
        firm, given = row[tb.T_FIRMNESS + m], row[tb.T_LAW_GIVEN + m]
        stiffness, damping = row[tb.T_STIFFNESS + m], row[tb.T_DAMPING + m]
        divisor = firm if firm > 0.0 else 1.0
        start, share = row[tb.T_LAW_START + m], row[tb.T_LAW_SHARE + m]
        error = spring_error(angle, start, rate, given, stiffness, damping, share, divisor, substep)
        error = error if firm > 0.0 else 0.0
        row[tb.T_LAW_ERROR + m] = error
        error = row[tb.T_LAW_ARM + m] * error
        lanes[tb.T_SIZE + m] = lanes[tb.T_SIZE + m] + error * error


@separate
def add_spring_bias(row: Array) -> None:
    """Note what the springs of a row ask for about their hinges."""
    for m in range(LANES):
        turned = row[tb.T_TURNING + m] * row[tb.T_LAW_ERROR + m]
        row[tb.T_LAW + m] = 0.0 + law_impulse(row[tb.T_FIRMNESS + m], turned)


@separate
def spring_impulses_of_lanes(row: Array, above: Array) -> None:
    """Find the angular impulses of the springs of a row."""
    for m in range(LANES):
        own = row_rate((0.0, 0.0), row[tb.T_TURNING + m], (0.0, 0.0), row[tb.T_CHANGE_SPIN + m])
        far = row_rate(
            (0.0, 0.0), row[tb.T_FAR_TURNING + m], (0.0, 0.0), above[tb.T_CHANGE_SPIN + m]
        )
        is_b, firm = row[tb.T_LAW_SIDE + m] > 0.0, row[tb.T_FIRMNESS + m]
        first, second = far if is_b else own, own if is_b else far
        impulse = row_impulse(row[tb.T_LAW_ERROR + m] + first + second, firm)
        row[tb.T_LAW_IMPULSE + m] = impulse if firm > 0.0 else 0.0


@separate
def note_left_of_lanes(chosen: Array, row: Array) -> None:
    """Note what the springs of a row have left to give where bodies have moved to."""
    for m in range(LANES):
        sprung = (chosen[m] > 0.0) & (row[tb.T_FIRMNESS + m] > 0.0)
        share = row[tb.T_LAW_SHARE + m] if sprung else 1.0
        row[tb.T_LAW_LEFT + m] = left_impulse(row[tb.T_LAW_GIVEN + m], share) if sprung else 0.0


@separate
def take_left_of_lanes(chosen: Array, row: Array) -> None:
    """Let the impulses of springs be what they have left, and nothing be left, in some lanes."""
    for m in range(LANES):
        left = row[tb.T_LAW_LEFT + m]
        row[tb.T_LAW_IMPULSE + m] = left
        row[tb.T_LAW_LEFT + m] = 0.0 if chosen[m] > 0.0 else left


@separate
def turn_lanes_by_springs(chosen: Array, sign: float, row: Array, above: Array) -> None:
    """Give the bodies of a row the angular impulses of their springs, or take these back.

    What that does to the bodies above is noted: where nothing is turned, a zero which leaves one of
    either sign as it is.
    """
    for m in range(LANES):
        turned = (chosen[m] > 0.0) & (row[tb.T_FIRMNESS + m] > 0.0)
        impulse, held = sign * row[tb.T_LAW_IMPULSE + m], row[tb.T_HELD_INVERSE_INERTIA + m]
        pull, given = row[tb.T_LAW_PULL + m] + impulse, row[tb.T_LAW_GIVEN + m] + impulse
        turn = angular_velocity_later(0.0, impulse, row[tb.T_TURNING + m], held)
        held_above = above[tb.T_HELD_INVERSE_INERTIA + m]
        passed = angular_velocity_later(0.0, impulse, row[tb.T_FAR_TURNING + m], held_above)
        row[tb.T_LAW_PULL + m] = pull if turned else row[tb.T_LAW_PULL + m]
        row[tb.T_LAW_GIVEN + m] = given if turned else row[tb.T_LAW_GIVEN + m]
        row[tb.T_SPIN + m] = row[tb.T_SPIN + m] + turn if turned else row[tb.T_SPIN + m]
        row[tb.T_START_SPIN + m] = (
            row[tb.T_START_SPIN + m] + turn if turned else row[tb.T_START_SPIN + m]
        )
        row[tb.T_PASSED_TURN + m] = passed if turned else -0.0


@separate
def add_turns(row: Array, above: Array) -> None:
    """Add them to the spins of these, now and as the substep began."""
    for m in range(LANES):
        above[tb.T_SPIN + m] += row[tb.T_PASSED_TURN + m]
        above[tb.T_START_SPIN + m] += row[tb.T_PASSED_TURN + m]
