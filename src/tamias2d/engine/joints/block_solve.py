"""Blocks of trees are solved together: each lane as long as it has to be.

What `hinge_solve` does for one tree is done here for those of a block.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.solve import (
    MOST_ITERATIONS_OF_JOINTS,
    SLOWLY,
    SOLVED_RATE,
)
from tamias2d.engine.joints.spring_lanes import (
    add_spring_bias,
    add_turns,
    begin_springs_of_lanes,
    spring_errors_of_lanes,
    spring_impulses_of_lanes,
    turn_lanes_by_springs,
)
from tamias2d.engine.joints.tree_blocks import first_hinge, first_sprung, hang_block, turn_block
from tamias2d.engine.joints.tree_lanes import (
    add_biases,
    add_pushed,
    aim_lanes,
    all_lanes,
    bias_lanes,
    clear_biases,
    end_slight_lanes,
    gap_errors_of_lanes,
    let_lanes_go,
    load_node,
    pass_impulses,
    pass_lanes,
    pass_lanes_down,
    place_lanes,
    push_own_lanes,
    rates_of_lanes,
    some_lanes,
    store_node,
)
from tamias2d.engine.joints.yielding import REMOVED_BY_JOINTS
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array


def aim_blocks(length: float, joints: Joints) -> None:
    """Note to which gaps a substep brings the hinges of blocks, as `aim_tree` does."""
    for r in range(joints.tree_blocks[joints.counts[tb.TREE_BLOCKS], tb.T_FIRST]):
        aim_lanes(REMOVED_BY_JOINTS * length, joints.tree_lanes[r])
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        for r in range(first_sprung(b, joints), joints.tree_blocks[b + 1, tb.T_FIRST]):
            begin_springs_of_lanes(joints.tree_lanes[r])


def bring_blocks_to_aims(
    least: int, again: bool, substep: float, bodies: Bodies, joints: Joints
) -> None:
    """Bring trees of at least a status to what hinges aim at, as `keep_tree_positions` does."""
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        if has_status(b, least, tb.IN_CONTACT, joints):
            if joints.tree_blocks[b, tb.T_SPRUNG] == 1 and not again:
                hang_block(b, substep, joints)
            bring_block_to_aims(b, substep, bodies, joints)


def bring_block_to_aims(b: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Bring the active trees of a block to the aims of their hinges."""
    lanes = joints.block_lanes[b]
    for k in range(MOST_ITERATIONS_OF_JOINTS):
        find_errors_of_block(b, substep, bodies, joints)
        look_at_errors(k == 0, lanes)
        if some_lanes(tb.T_BACK, lanes):
            take_block_back(b, bodies, joints)
        if some_lanes(tb.T_AGAIN, lanes):
            turn_block(b, joints)
            hang_block(b, substep, joints)
        if not some_lanes(tb.T_ACTIVE, lanes):
            return
        solve_block(b, bodies, joints)
        end_slight_lanes(substep, lanes)
        if not some_lanes(tb.T_ACTIVE, lanes):
            return


def has_status(b: int, least: int, most: int, joints: Joints) -> bool:
    """Let the trees of a block be active that have a status from the least to the most; say if any.

    None is solved again as yet.
    """
    lanes, found = joints.block_lanes[b], False
    for m in range(LANES):
        n = joints.tree_blocks[b, tb.T_MECHANISM + m]
        status = joints.mechanisms[n, tb.M_STATUS] if n >= 0 else tb.ASLEEP
        active = (status >= least) & (status <= most)
        lanes[tb.T_ACTIVE + m] = 1.0 if active else 0.0
        lanes[tb.T_AGAIN + m] = 0.0
        found |= bool(active)
    return found


def look_at_errors(begins: bool, lanes: Array) -> None:
    """Choose the lanes to solve by the sizes of their errors, now and before."""
    for m in range(LANES):
        size = lanes[tb.T_SIZE + m]
        first = size if begins else lanes[tb.T_SIZE_FIRST + m]
        lanes[tb.T_SIZE_FIRST + m] = first
        active, again = lanes[tb.T_ACTIVE + m] > 0.0, lanes[tb.T_AGAIN + m] > 0.0
        less = begins | (size < lanes[tb.T_BEFORE + m])
        back = active & again & (not less)
        active = active & (not back) & (not size <= SOLVED_RATE * SOLVED_RATE * first)
        slowly = active & (not begins) & (size > SLOWLY * lanes[tb.T_BEFORE + m])
        lanes[tb.T_BACK + m], lanes[tb.T_ACTIVE + m] = 1.0 if back else 0.0, 1.0 if active else 0.0
        lanes[tb.T_AGAIN + m] = 1.0 if slowly else 0.0
        lanes[tb.T_BEFORE + m] = size


def find_errors_of_block(b: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Write the rates that the hinges of a block have too much to get to their aims."""
    first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
    lanes, rows, hinge = joints.block_lanes[b], joints.tree_lanes, first_hinge(b, joints)
    all_lanes(tb.T_SIZE, 0.0, lanes)
    for r in range(first, last):
        load_node(joints.tree_slots[r], bodies, rows[r])
        place_lanes(substep, rows[r])
        if r >= hinge:
            gap_errors_of_lanes(substep, lanes, rows[r], rows[joints.tree_above[r]])
    for r in range(first_sprung(b, joints), last):
        spring_errors_of_lanes(substep, lanes, rows[r], rows[joints.tree_above[r]])


def fit_blocks(least: int, most: int, bodies: Bodies, joints: Joints) -> None:
    """Take the rates of their hinges from the velocities of trees of some statuses."""
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        if has_status(b, least, most, joints):
            if joints.tree_blocks[b, tb.T_SPRUNG] == 1:
                hang_block(b, 0.0, joints)
            fit_block(b, bodies, joints)


def fit_block(b: int, bodies: Bodies, joints: Joints) -> None:
    """Take the rates of their hinges from the velocities of active trees of a block."""
    first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
    for r in range(first, last):
        load_node(joints.tree_slots[r], bodies, joints.tree_lanes[r])
    for r in range(first_hinge(b, joints), last):
        rates_of_lanes(joints.tree_lanes[r], joints.tree_lanes[joints.tree_above[r]])
    solve_block(b, bodies, joints)


def solve_block(b: int, bodies: Bodies, joints: Joints) -> None:
    """Give active trees of a block the impulses that take their errors away."""
    first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
    rows, lanes, hinge = joints.tree_lanes, joints.block_lanes[b], first_hinge(b, joints)
    for r in range(first, last):
        clear_biases(rows[r])
    for r in range(first_sprung(b, joints), last):
        add_spring_bias(rows[r])
    for r in range(last - 1, first + 1, -1):
        bias_lanes(rows[r])
        pass_lanes(rows[r])
        add_biases(rows[r], rows[joints.tree_above[r]])
    bias_lanes(rows[first + 1])
    if hinge > first + 1:
        let_lanes_go(rows[first + 1])
    all_lanes(tb.T_LARGEST, 0.0, lanes)
    for r in range(first + 1, last):
        pass_lanes_down(lanes, rows[r], rows[joints.tree_above[r]])
        if r >= hinge:
            push_row(b, r, tb.T_ACTIVE, 1.0, joints)
    for r in range(first_sprung(b, joints), last):
        spring_impulses_of_lanes(rows[r], rows[joints.tree_above[r]])
    turn_by_springs(b, tb.T_ACTIVE, 1.0, joints)
    store_block(b, bodies, joints)


def take_block_back(b: int, bodies: Bodies, joints: Joints) -> None:
    """Take the last solution from the motion of trees: no solution is near."""
    for r in range(first_hinge(b, joints), joints.tree_blocks[b + 1, tb.T_FIRST]):
        push_row(b, r, tb.T_BACK, -1.0, joints)
    turn_by_springs(b, tb.T_BACK, -1.0, joints)
    store_block(b, bodies, joints)


def push_row(b: int, r: int, chosen: int, sign: float, joints: Joints) -> None:
    """Give bodies of a row, and those above, the impulses through hinges, or take these back."""
    row, pushed = joints.tree_lanes[r], joints.block_lanes[b, chosen : chosen + LANES]
    push_own_lanes(pushed, sign, row)
    if r > joints.tree_blocks[b, tb.T_FIRST] + 1:
        above = joints.tree_lanes[joints.tree_above[r]]
        pass_impulses(pushed, sign, row, above)
        add_pushed(row, above)


def turn_by_springs(b: int, chosen: int, sign: float, joints: Joints) -> None:
    """Give bodies of a block the angular impulses of springs, or take these back."""
    rows, turned = joints.tree_lanes, joints.block_lanes[b, chosen : chosen + LANES]
    for r in range(first_sprung(b, joints), joints.tree_blocks[b + 1, tb.T_FIRST]):
        above = rows[joints.tree_above[r]]
        turn_lanes_by_springs(turned, sign, rows[r], above)
        add_turns(rows[r], above)


def store_block(b: int, bodies: Bodies, joints: Joints) -> None:
    """Store how the bodies of a block move."""
    for r in range(joints.tree_blocks[b, tb.T_FIRST] + 1, joints.tree_blocks[b + 1, tb.T_FIRST]):
        store_node(joints.tree_slots[r], bodies, joints.tree_lanes[r])
