"""Springs of the angles of hinges side by side, a lane for each tree: what `angle_laws` does.

Each node of a tree has one at most. A lane without a spring has one that is not firm.
"""

from tamias2d.engine.joints.hinge_tree import slight_turn
from tamias2d.engine.joints.hinged_yield import yield_with_hinge
from tamias2d.engine.joints.linearise import firmness_that_yields
from tamias2d.engine.tables import (
    T_ANGLE,
    T_ARM_X,
    T_ARM_Y,
    T_CHANGE_SPIN,
    T_DAMPING,
    T_FAR_ARM_X,
    T_FAR_ARM_Y,
    T_FAR_TURNING,
    T_FIRM,
    T_FIRMNESS,
    T_HELD_INVERSE_INERTIA,
    T_INVERSE_MASS,
    T_JOINT_ANGLE,
    T_LAW,
    T_LAW_ERROR,
    T_LAW_GIVEN,
    T_LAW_IMPULSE,
    T_LAW_LEFT,
    T_LAW_PULL,
    T_LAW_SHARE,
    T_LAW_SIDE,
    T_LAW_START,
    T_PASSED_TURN,
    T_SIZE,
    T_SLIGHT,
    T_SPIN,
    T_START_SPIN,
    T_STIFFNESS,
    T_TURNING,
)
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
        row[T_LAW_GIVEN + m] = -row[T_LAW_LEFT + m]


@separate
def note_angles_of_lanes(row: Array, above: Array) -> None:
    """Note the angles of the springs of a row where bodies are."""
    for m in range(LANES):
        angle = row[T_LAW_SIDE + m] * (row[T_ANGLE + m] - above[T_ANGLE + m])
        row[T_LAW_START + m] = angle - row[T_JOINT_ANGLE + m]


@separate
def firm_lanes(substep: float, lanes: Array, row: Array, above: Array) -> None:
    """Find how firm the springs of a row are in a substep, s; a body may not turn."""
    for m in range(LANES):
        side, held = row[T_LAW_SIDE + m], row[T_HELD_INVERSE_INERTIA + m]
        held_above = above[T_HELD_INVERSE_INERTIA + m]
        turning = side if held > 0.0 else 0.0
        far = -side if held_above > 0.0 else 0.0
        yielding = row_yield((0.0, 0.0), turning, 0.0, held)
        yielding += row_yield((0.0, 0.0), far, 0.0, held_above)
        stiffness, damping = row[T_STIFFNESS + m], row[T_DAMPING + m]
        spins = (
            angular_velocity_later(0.0, 1.0, turning, held),
            angular_velocity_later(0.0, 1.0, far, held_above),
        )
        mass = row[T_INVERSE_MASS + m]
        inverse = (mass if mass > 0.0 else 1.0, held)
        inverse_above = (above[T_INVERSE_MASS + m], held_above)
        arm = (row[T_ARM_X + m], row[T_ARM_Y + m])
        far_arm = (row[T_FAR_ARM_X + m], row[T_FAR_ARM_Y + m])
        hinged = yield_with_hinge(yielding, (0.0, 0.0), spins, arm, far_arm, inverse, inverse_above)
        share = implicit_share(stiffness, damping, hinged, substep)
        firm = spring_firmness(stiffness, damping, share, substep)
        firm = min(firmness_that_yields(yielding), firm)
        row[T_LAW_SHARE + m] = share
        slight = min(lanes[T_SLIGHT + m], slight_turn(share))
        lanes[T_SLIGHT + m] = slight if side != 0.0 else lanes[T_SLIGHT + m]
        row[T_TURNING + m], row[T_FAR_TURNING + m] = turning, far
        row[T_FIRMNESS + m], row[T_FIRM + m] = firm, coupled_inertia(turning, turning, firm)


@separate
def spring_errors_of_lanes(substep: float, lanes: Array, row: Array, above: Array) -> None:
    """Write the rates that the springs of a row have not answered yet."""
    for m in range(LANES):
        angle = row[T_LAW_SIDE + m] * (row[T_ANGLE + m] - above[T_ANGLE + m])
        angle -= row[T_JOINT_ANGLE + m]
        rate = row_rate((0.0, 0.0), row[T_TURNING + m], (0.0, 0.0), row[T_SPIN + m])
        rate += row_rate((0.0, 0.0), row[T_FAR_TURNING + m], (0.0, 0.0), above[T_SPIN + m])
        firm, given = row[T_FIRMNESS + m], row[T_LAW_GIVEN + m]
        stiffness, damping = row[T_STIFFNESS + m], row[T_DAMPING + m]
        divisor = firm if firm > 0.0 else 1.0
        start, share = row[T_LAW_START + m], row[T_LAW_SHARE + m]
        error = spring_error(angle, start, rate, given, stiffness, damping, share, divisor, substep)
        error = error if firm > 0.0 else 0.0
        row[T_LAW_ERROR + m] = error
        lanes[T_SIZE + m] = lanes[T_SIZE + m] + error * error


@separate
def owe_springs(row: Array) -> None:
    """Note what the springs of a row ask for about their hinges."""
    for m in range(LANES):
        turned = row[T_TURNING + m] * row[T_LAW_ERROR + m]
        row[T_LAW + m] = 0.0 + law_impulse(row[T_FIRMNESS + m], turned)


@separate
def spring_impulses_of_lanes(row: Array, above: Array) -> None:
    """Find the angular impulses of the springs of a row."""
    for m in range(LANES):
        own = row_rate((0.0, 0.0), row[T_TURNING + m], (0.0, 0.0), row[T_CHANGE_SPIN + m])
        far = row_rate((0.0, 0.0), row[T_FAR_TURNING + m], (0.0, 0.0), above[T_CHANGE_SPIN + m])
        is_b, firm = row[T_LAW_SIDE + m] > 0.0, row[T_FIRMNESS + m]
        first, second = far if is_b else own, own if is_b else far
        impulse = row_impulse(row[T_LAW_ERROR + m] + first + second, firm)
        row[T_LAW_IMPULSE + m] = impulse if firm > 0.0 else 0.0


@separate
def note_left_of_lanes(chosen: Array, row: Array) -> None:
    """Note what the springs of a row have left to give where bodies have moved to."""
    for m in range(LANES):
        sprung = (chosen[m] > 0.0) & (row[T_FIRMNESS + m] > 0.0)
        share = row[T_LAW_SHARE + m] if sprung else 1.0
        row[T_LAW_LEFT + m] = left_impulse(row[T_LAW_GIVEN + m], share) if sprung else 0.0


@separate
def take_left_of_lanes(chosen: Array, row: Array) -> None:
    """Let the impulses of springs be what they have left, and nothing be left, in some lanes."""
    for m in range(LANES):
        left = row[T_LAW_LEFT + m]
        row[T_LAW_IMPULSE + m] = left
        row[T_LAW_LEFT + m] = 0.0 if chosen[m] > 0.0 else left


@separate
def turn_lanes_by_springs(chosen: Array, sign: float, row: Array, above: Array) -> None:
    """Give the bodies of a row the angular impulses of their springs, or take these back.

    What that does to the bodies above is noted: where nothing is turned, a zero which leaves one of
    either sign as it is.
    """
    for m in range(LANES):
        turned = (chosen[m] > 0.0) & (row[T_FIRMNESS + m] > 0.0)
        impulse, held = sign * row[T_LAW_IMPULSE + m], row[T_HELD_INVERSE_INERTIA + m]
        pull, given = row[T_LAW_PULL + m] + impulse, row[T_LAW_GIVEN + m] + impulse
        turn = angular_velocity_later(0.0, impulse, row[T_TURNING + m], held)
        held_above = above[T_HELD_INVERSE_INERTIA + m]
        passed = angular_velocity_later(0.0, impulse, row[T_FAR_TURNING + m], held_above)
        row[T_LAW_PULL + m] = pull if turned else row[T_LAW_PULL + m]
        row[T_LAW_GIVEN + m] = given if turned else row[T_LAW_GIVEN + m]
        row[T_SPIN + m] = row[T_SPIN + m] + turn if turned else row[T_SPIN + m]
        row[T_START_SPIN + m] = row[T_START_SPIN + m] + turn if turned else row[T_START_SPIN + m]
        row[T_PASSED_TURN + m] = passed if turned else -0.0


@separate
def add_turns(row: Array, above: Array) -> None:
    """Add them to the spins of these, now and as the substep began."""
    for m in range(LANES):
        above[T_SPIN + m] += row[T_PASSED_TURN + m]
        above[T_START_SPIN + m] += row[T_PASSED_TURN + m]
