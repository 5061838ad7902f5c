"""Equal trees of hinges side by side, a lane for each: what `hinge_tree` and `hinge_solve` do.

A row holds the same node of all trees of a block; the first row is what their roots hang on. Lanes
get the same bits as trees that are solved by themselves.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.hinge_tree import gone_through
from tamias2d.engine.rotation import cosine_sine
from tamias2d.engine.tables import Bodies, Integers
from tamias2d.generated.definitions import point_velocity
from tamias2d.generated.hinge_tree import (
    angular_momentum_passed,
    angular_velocity_hinged,
    arm_met,
    change,
    hinge_arm,
    hinge_change,
    hinge_gap,
    hinge_impulse,
    hinge_inertia,
    hinge_lever,
    hinge_moment,
    hung_inertia,
    hung_mass,
    hung_moment,
    momentum_hung,
    momentum_passed,
    root_change,
    spin_change,
    turn_bias,
    turned_share,
    turning_yield,
    velocity_hinged,
)
from tamias2d.generated.joint_step import row_aim, row_error
from tamias2d.generated.soft_contact import shift_later, turn_later
from tamias2d.kernels.assembled import inlined, separate
from tamias2d.kernels.lanes import LANES, load_part, load_rows, store_half
from tamias2d.state import Array, Vector


def load_node(slots: Integers, bodies: Bodies, row: Array) -> None:
    """Load how the bodies of a row move, and how they did as the substep began."""
    load_rows(slots, 0, bodies.motion, row, tb.T_VX)
    load_part(slots, 0, bodies.substep_state, tb.SUBSTEP_START, row, tb.T_START_X)


def store_node(slots: Integers, bodies: Bodies, row: Array) -> None:
    """Store what impulses have made of that."""
    store_half(slots, 0, bodies.motion, row, tb.T_VX)
    for m in range(LANES):
        state = bodies.substep_state[slots[m]]
        state[tb.SUBSTEP_START] = row[tb.T_START_X + m]
        state[tb.SUBSTEP_START + 1] = row[tb.T_START_Y + m]
        state[tb.SUBSTEP_START + 2] = row[tb.T_START_SPIN + m]


@separate
def place_lanes(ahead: float, row: Array) -> None:
    """Write where the bodies of a row are, or will be so many seconds ahead."""
    for m in range(LANES):
        shift, velocity = (row[tb.T_DX + m], row[tb.T_DY + m]), (row[tb.T_VX + m], row[tb.T_VY + m])
        by_x, by_y = shift_later(shift, velocity, ahead)
        row[tb.T_X + m], row[tb.T_Y + m] = row[tb.T_POSE_X + m] + by_x, row[tb.T_POSE_Y + m] + by_y
        angle = row[tb.T_POSE_ANGLE + m] + turn_later(
            row[tb.T_DANGLE + m], row[tb.T_SPIN + m], ahead
        )
        row[tb.T_ANGLE + m] = angle
        row[tb.T_COSINE + m], row[tb.T_SINE + m] = cosine_sine(angle)


@separate
def keep_given_lanes(chosen: Array, row: Array) -> None:
    """Add what went through hinges since they were written to what did before, in some lanes."""
    for m in range(LANES):
        kept = chosen[m] > 0.0
        given = (row[tb.T_GIVEN_X + m], row[tb.T_GIVEN_Y + m])
        arm = (row[tb.T_ARM_X + m], row[tb.T_ARM_Y + m])
        far = (row[tb.T_FAR_ARM_X + m], row[tb.T_FAR_ARM_Y + m])
        pull, turn = (row[tb.T_PULL_X + m], row[tb.T_PULL_Y + m]), row[tb.T_TURN + m]
        pull, turn, far_turn = gone_through(pull, turn, row[tb.T_FAR_TURN + m], given, arm, far)
        row[tb.T_PULL_X + m] = pull[0] if kept else row[tb.T_PULL_X + m]
        row[tb.T_PULL_Y + m] = pull[1] if kept else row[tb.T_PULL_Y + m]
        row[tb.T_TURN + m] = turn if kept else row[tb.T_TURN + m]
        row[tb.T_FAR_TURN + m] = far_turn if kept else row[tb.T_FAR_TURN + m]
        row[tb.T_GIVEN_X + m] = 0.0 if kept else given[0]
        row[tb.T_GIVEN_Y + m] = 0.0 if kept else given[1]


@inlined
def arms_of_lane(m: int, row: Array, above: Array) -> tuple[Vector, Vector, Vector]:
    """Return the arms of a hinge in a lane, where bodies are placed, and how far it is apart, m."""
    anchor = (row[tb.T_ANCHOR_X + m], row[tb.T_ANCHOR_Y + m])
    far_anchor = (row[tb.T_FAR_ANCHOR_X + m], row[tb.T_FAR_ANCHOR_Y + m])
    arm = hinge_arm(anchor, row[tb.T_COSINE + m], row[tb.T_SINE + m])
    far = hinge_arm(far_anchor, above[tb.T_COSINE + m], above[tb.T_SINE + m])
    here, there = (row[tb.T_X + m], row[tb.T_Y + m]), (above[tb.T_X + m], above[tb.T_Y + m])
    return arm, far, hinge_gap(here, arm, there, far)


@separate
def turn_lanes(chosen: Array, row: Array, above: Array) -> None:
    """Write the hinges of a row where bodies are placed, in lanes whose number is not 0."""
    for m in range(LANES):
        turns = chosen[m] > 0.0
        arm, far, gap = arms_of_lane(m, row, above)
        met = arm_met(far, gap)
        row[tb.T_ARM_X + m] = arm[0] if turns else row[tb.T_ARM_X + m]
        row[tb.T_ARM_Y + m] = arm[1] if turns else row[tb.T_ARM_Y + m]
        row[tb.T_FAR_ARM_X + m] = met[0] if turns else row[tb.T_FAR_ARM_X + m]
        row[tb.T_FAR_ARM_Y + m] = met[1] if turns else row[tb.T_FAR_ARM_Y + m]
        row[tb.T_GAP_X + m] = gap[0] if turns else row[tb.T_GAP_X + m]
        row[tb.T_GAP_Y + m] = gap[1] if turns else row[tb.T_GAP_Y + m]


@separate
def note_apart_lanes(row: Array) -> None:
    """Note by how much the hinges of a row are apart, if that is more than before."""
    for m in range(2 * LANES):
        row[tb.T_APART_X + m] = max(row[tb.T_APART_X + m], abs(row[tb.T_GAP_X + m]))


@separate
def aim_lanes(removed: float, row: Array) -> None:
    """Note to which gaps a substep brings the hinges of a row."""
    for m in range(LANES):
        row[tb.T_AIM_X + m] = row_aim(row[tb.T_GAP_X + m], removed)
        row[tb.T_AIM_Y + m] = row_aim(row[tb.T_GAP_Y + m], removed)


@separate
def begin_lanes(row: Array) -> None:
    """Let the nodes of a row be their bodies alone, as yet.

    What is copied has a loop by itself, as have three columns of zeros: that is done at once.
    """
    for m in range(LANES):
        row[tb.T_NODE_XX + m] = row[tb.T_MASS + m]
    for m in range(LANES):
        row[tb.T_NODE_YY + m] = row[tb.T_MASS + m]
    for m in range(LANES):
        row[tb.T_NODE_INERTIA + m] = row[tb.T_INERTIA + m]
    for m in range(3 * LANES):
        row[tb.T_NODE_XY + m] = 0.0


@separate
def hang_lanes(row: Array, above: Array) -> None:
    """Find what the nodes of a row are for their hinges, and add it to the nodes above."""
    for m in range(LANES):
        mass_x = (row[tb.T_NODE_XX + m], row[tb.T_NODE_XY + m])
        mass_y = (row[tb.T_NODE_XY + m], row[tb.T_NODE_YY + m])
        moment = (row[tb.T_NODE_MOMENT_X + m], row[tb.T_NODE_MOMENT_Y + m])
        arm = (row[tb.T_ARM_X + m], row[tb.T_ARM_Y + m])
        turned = hinge_moment(mass_x, mass_y, moment, arm)
        inertia = hinge_inertia(moment, row[tb.T_NODE_INERTIA + m], turned, arm)
        firm, can_turn_there = row[tb.T_FIRM + m], row[tb.T_INERTIA + m] > 0.0
        yielding = turning_yield(inertia if can_turn_there else 1.0, firm)
        yielding = yielding if can_turn_there else 0.0
        share = turned_share(firm, yielding)
        lever = hinge_lever(turned, yielding)
        hung_x, hung_y = hung_mass(mass_x, lever[0], turned), hung_mass(mass_y, lever[1], turned)
        row[tb.T_YIELD + m], row[tb.T_LEVER_X + m], row[tb.T_LEVER_Y + m] = (
            yielding,
            lever[0],
            lever[1],
        )
        row[tb.T_MOMENT_X + m], row[tb.T_MOMENT_Y + m], row[tb.T_SHARE + m] = (
            turned[0],
            turned[1],
            share,
        )
        row[tb.T_HUNG_XX + m], row[tb.T_HUNG_XY + m], row[tb.T_HUNG_YY + m] = (
            hung_x[0],
            hung_x[1],
            hung_y[1],
        )
        far = (row[tb.T_FAR_ARM_X + m], row[tb.T_FAR_ARM_Y + m])
        hung_y = (hung_x[1], hung_y[1])
        passed = hung_moment(hung_x, hung_y, turned, share, far)
        above[tb.T_NODE_XX + m] += hung_x[0]
        above[tb.T_NODE_XY + m] += hung_x[1]
        above[tb.T_NODE_YY + m] += hung_y[1]
        above[tb.T_NODE_MOMENT_X + m] += passed[0]
        above[tb.T_NODE_MOMENT_Y + m] += passed[1]
        above[tb.T_NODE_INERTIA + m] += hung_inertia(passed, turned, inertia, share, far)


@separate
def gap_errors_of_lanes(substep: float, lanes: Array, row: Array, above: Array) -> None:
    """Write the rates that the hinges of a row have too much to get to their aims."""
    for m in range(LANES):
        _, _, gap = arms_of_lane(m, row, above)
        error_x = row_error(gap[0], row[tb.T_AIM_X + m], substep)
        error_y = row_error(gap[1], row[tb.T_AIM_Y + m], substep)
        row[tb.T_ERROR_X + m], row[tb.T_ERROR_Y + m] = error_x, error_y
        lanes[tb.T_SIZE + m] = lanes[tb.T_SIZE + m] + (error_x * error_x + error_y * error_y)


@separate
def rates_of_lanes(row: Array, above: Array) -> None:
    """Write the rates at which the hinges of a row part."""
    for m in range(LANES):
        arm = (row[tb.T_ARM_X + m], row[tb.T_ARM_Y + m])
        far = (row[tb.T_FAR_ARM_X + m], row[tb.T_FAR_ARM_Y + m])
        here = point_velocity((row[tb.T_VX + m], row[tb.T_VY + m]), row[tb.T_SPIN + m], arm)
        there = point_velocity((above[tb.T_VX + m], above[tb.T_VY + m]), above[tb.T_SPIN + m], far)
        row[tb.T_ERROR_X + m], row[tb.T_ERROR_Y + m] = here[0] - there[0], here[1] - there[1]


def clear_biases(row: Array) -> None:
    """Let the nodes of a row have no bias yet."""
    for m in range(3 * LANES):
        row[tb.T_BIAS_X + m] = 0.0


@separate
def bias_lanes(row: Array) -> None:
    """Find the biases of the nodes of a row at their hinges."""
    for m in range(LANES):
        bias, arm = (
            (row[tb.T_BIAS_X + m], row[tb.T_BIAS_Y + m]),
            (row[tb.T_ARM_X + m], row[tb.T_ARM_Y + m]),
        )
        turning = turn_bias(row[tb.T_BIAS_TURN + m], bias, arm, row[tb.T_LAW + m])
        hung = momentum_hung(bias, turning, (row[tb.T_LEVER_X + m], row[tb.T_LEVER_Y + m]))
        row[tb.T_BIAS_X + m], row[tb.T_BIAS_Y + m] = hung
        row[tb.T_BIAS_TURN + m] = turning


@separate
def pass_lanes(row: Array) -> None:
    """Find what the nodes of a row, and the errors of hinges, add to the biases above."""
    for m in range(LANES):
        hung = (row[tb.T_BIAS_X + m], row[tb.T_BIAS_Y + m])
        error = (row[tb.T_ERROR_X + m], row[tb.T_ERROR_Y + m])
        far = (row[tb.T_FAR_ARM_X + m], row[tb.T_FAR_ARM_Y + m])
        turned = (row[tb.T_MOMENT_X + m], row[tb.T_MOMENT_Y + m])
        mass_x = (row[tb.T_HUNG_XX + m], row[tb.T_HUNG_XY + m])
        mass_y = (row[tb.T_HUNG_XY + m], row[tb.T_HUNG_YY + m])
        passed = momentum_passed(hung, error, mass_x, mass_y)
        row[tb.T_PASSED_X + m], row[tb.T_PASSED_Y + m] = passed
        row[tb.T_PASSED_TURN + m] = angular_momentum_passed(
            passed,
            row[tb.T_BIAS_TURN + m],
            error,
            turned,
            row[tb.T_SHARE + m],
            far,
            row[tb.T_LAW + m],
        )


@separate
def add_biases(row: Array, above: Array) -> None:
    """Add what the nodes of a row pass on to the biases above."""
    for m in range(3 * LANES):
        above[tb.T_BIAS_X + m] += row[tb.T_PASSED_X + m]


@separate
def let_lanes_go(row: Array) -> None:
    """Let roots that nothing ties move so that no impulse goes through their hinges."""
    for m in range(LANES):
        mass_x = (row[tb.T_HUNG_XX + m], row[tb.T_HUNG_XY + m])
        mass_y = (row[tb.T_HUNG_XY + m], row[tb.T_HUNG_YY + m])
        by_x, by_y = root_change((row[tb.T_BIAS_X + m], row[tb.T_BIAS_Y + m]), mass_x, mass_y)
        row[tb.T_ERROR_X + m], row[tb.T_ERROR_Y + m] = -by_x, -by_y


@separate
def pass_lanes_down(lanes: Array, row: Array, above: Array) -> None:
    """Find how the velocities of a row's bodies change, and the impulses through their hinges."""
    for m in range(LANES):
        by, spin_above = (
            (above[tb.T_CHANGE_X + m], above[tb.T_CHANGE_Y + m]),
            above[tb.T_CHANGE_SPIN + m],
        )
        far = (row[tb.T_FAR_ARM_X + m], row[tb.T_FAR_ARM_Y + m])
        error = (row[tb.T_ERROR_X + m], row[tb.T_ERROR_Y + m])
        at_hinge = hinge_change(by, spin_above, far, error)
        lever, arm = (
            (row[tb.T_LEVER_X + m], row[tb.T_LEVER_Y + m]),
            (row[tb.T_ARM_X + m], row[tb.T_ARM_Y + m]),
        )
        turning, share = row[tb.T_BIAS_TURN + m], row[tb.T_SHARE + m]
        turn = spin_change(spin_above, share, at_hinge, lever, turning, row[tb.T_YIELD + m])
        own = change(at_hinge, turn, arm)
        row[tb.T_CHANGE_X + m], row[tb.T_CHANGE_Y + m] = own
        row[tb.T_CHANGE_SPIN + m] = turn
        mass_x = (row[tb.T_HUNG_XX + m], row[tb.T_HUNG_XY + m])
        mass_y = (row[tb.T_HUNG_XY + m], row[tb.T_HUNG_YY + m])
        hung = (row[tb.T_BIAS_X + m], row[tb.T_BIAS_Y + m])
        turned = (row[tb.T_MOMENT_X + m], row[tb.T_MOMENT_Y + m])
        impulse = hinge_impulse(at_hinge, spin_above, mass_x, mass_y, turned, share, hung)
        row[tb.T_IMPULSE_X + m], row[tb.T_IMPULSE_Y + m] = impulse
    for m in range(LANES):
        turn, spin = abs(row[tb.T_CHANGE_SPIN + m]), abs(row[tb.T_SPIN + m])
        lanes[tb.T_LARGEST + m] = max(lanes[tb.T_LARGEST + m], turn * (spin + turn))


@separate
def push_own_lanes(chosen: Array, sign: float, row: Array) -> None:
    """Give the bodies of a row the impulses through their hinges, or take these back."""
    for m in range(LANES):
        pushed = chosen[m] > 0.0
        impulse = (sign * row[tb.T_IMPULSE_X + m], sign * row[tb.T_IMPULSE_Y + m])
        row[tb.T_GIVEN_X + m] = (
            row[tb.T_GIVEN_X + m] + impulse[0] if pushed else row[tb.T_GIVEN_X + m]
        )
        row[tb.T_GIVEN_Y + m] = (
            row[tb.T_GIVEN_Y + m] + impulse[1] if pushed else row[tb.T_GIVEN_Y + m]
        )
        arm = (row[tb.T_ARM_X + m], row[tb.T_ARM_Y + m])
        by_x, by_y = velocity_hinged((0.0, 0.0), impulse, row[tb.T_INVERSE_MASS + m])
        turn = angular_velocity_hinged(0.0, arm, impulse, row[tb.T_HELD_INVERSE_INERTIA + m])
        row[tb.T_VX + m] = row[tb.T_VX + m] + by_x if pushed else row[tb.T_VX + m]
        row[tb.T_VY + m] = row[tb.T_VY + m] + by_y if pushed else row[tb.T_VY + m]
        row[tb.T_SPIN + m] = row[tb.T_SPIN + m] + turn if pushed else row[tb.T_SPIN + m]
        row[tb.T_START_X + m] = row[tb.T_START_X + m] + by_x if pushed else row[tb.T_START_X + m]
        row[tb.T_START_Y + m] = row[tb.T_START_Y + m] + by_y if pushed else row[tb.T_START_Y + m]
        row[tb.T_START_SPIN + m] = (
            row[tb.T_START_SPIN + m] + turn if pushed else row[tb.T_START_SPIN + m]
        )


@separate
def pass_impulses(chosen: Array, sign: float, row: Array, above: Array) -> None:
    """Find what the impulses through the hinges of a row do to the bodies above.

    Where nothing is pushed, that is a zero which leaves one of either sign as it is.
    """
    for m in range(LANES):
        pushed = chosen[m] > 0.0
        impulse = (-(sign * row[tb.T_IMPULSE_X + m]), -(sign * row[tb.T_IMPULSE_Y + m]))
        far = (row[tb.T_FAR_ARM_X + m], row[tb.T_FAR_ARM_Y + m])
        by_x, by_y = velocity_hinged((0.0, 0.0), impulse, above[tb.T_INVERSE_MASS + m])
        turn = angular_velocity_hinged(0.0, far, impulse, above[tb.T_HELD_INVERSE_INERTIA + m])
        row[tb.T_PASSED_X + m] = by_x if pushed else -0.0
        row[tb.T_PASSED_Y + m] = by_y if pushed else -0.0
        row[tb.T_PASSED_TURN + m] = turn if pushed else -0.0


@separate
def add_pushed(row: Array, above: Array) -> None:
    """Add that to the velocities of these bodies, now and as the substep began."""
    for m in range(3 * LANES):
        above[tb.T_VX + m] += row[tb.T_PASSED_X + m]
        above[tb.T_START_X + m] += row[tb.T_PASSED_X + m]


def some_lanes(chosen: int, lanes: Array) -> bool:
    """Return whether the number of any lane is not 0."""
    found = 0.0
    for m in range(LANES):
        found += lanes[chosen + m]
    return bool(found > 0.0)


def all_lanes(chosen: int, number: float, lanes: Array) -> None:
    """Give all lanes a number."""
    for m in range(LANES):
        lanes[chosen + m] = number


def end_slight_lanes(substep: float, lanes: Array) -> None:
    """Let lanes in which bodies turn little as impulses act, in a substep, s, be active no more."""
    for m in range(LANES):
        much = substep * substep * lanes[tb.T_LARGEST + m] > lanes[tb.T_SLIGHT + m]
        lanes[tb.T_ACTIVE + m] = lanes[tb.T_ACTIVE + m] if much else 0.0
