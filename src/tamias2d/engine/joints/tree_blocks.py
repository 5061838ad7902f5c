"""Blocks of equal trees of hinges, each tree in a lane: they are taken through a step together.

Cost: for each node of a block about what four trees by themselves take.
"""

from tamias2d.engine.joints.hinge_solve import SLIGHT_TURN
from tamias2d.engine.joints.hinge_tree import store_hinge_impulses
from tamias2d.engine.joints.solve import (
    MOST_ITERATIONS_OF_JOINTS,
    REMOVED_BY_JOINTS,
    SLOWLY,
    SOLVED_RATE,
)
from tamias2d.engine.joints.tree_lanes import (
    add_passed,
    aim_lanes,
    all_lanes,
    begin_lanes,
    end_slight_lanes,
    gap_errors_of_lanes,
    hang_lanes,
    keep_given_lanes,
    let_lanes_go,
    load_node,
    note_apart_lanes,
    owe_lanes,
    owe_nothing,
    pass_impulses,
    pass_lanes,
    pass_lanes_down,
    place_lanes,
    push_own_lanes,
    rates_of_lanes,
    some_lanes,
    store_node,
    turn_lanes,
)
from tamias2d.engine.tables import (
    ANGLE,
    ASLEEP,
    H_APART,
    H_FAR_TURN,
    H_GIVEN,
    H_PULL,
    H_TURN,
    HELD_INVERSE_INERTIA,
    I_NODE,
    INVERSE_MASS,
    JOINED_ABOVE,
    JOINED_SLOT,
    M_STATUS,
    NODE_INERTIA,
    NODE_MASS,
    T_ACTIVE,
    T_AGAIN,
    T_APART_X,
    T_APART_Y,
    T_BACK,
    T_BEFORE,
    T_EACH,
    T_FAR_TURN,
    T_FIRST,
    T_GIVEN_X,
    T_HELD_INVERSE_INERTIA,
    T_INERTIA,
    T_INVERSE_MASS,
    T_LARGEST,
    T_MASS,
    T_MECHANISM,
    T_OWED_X,
    T_POSE_ANGLE,
    T_POSE_X,
    T_POSE_Y,
    T_PULL_X,
    T_PULL_Y,
    T_SIZE,
    T_SIZE_FIRST,
    T_START_X,
    T_TIED,
    T_TURN,
    T_VX,
    TREE_BLOCKS,
    Bodies,
    Joints,
    X,
    Y,
)
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array


def begin_blocks(bodies: Bodies, joints: Joints) -> None:
    """Begin a part of a step: note where the bodies of blocks are, and what they weigh."""
    for b in range(joints.counts[TREE_BLOCKS]):
        first, last = joints.tree_blocks[b, T_FIRST], joints.tree_blocks[b + 1, T_FIRST]
        all_lanes(T_EACH, 1.0, joints.block_lanes[b])
        for m in range(LANES):
            n = joints.tree_blocks[b, T_MECHANISM + m]
            awake = n >= 0 and joints.mechanisms[n, M_STATUS] != ASLEEP
            for r in range(first, last):
                begin_lane(m, r, awake, n, r - first, bodies, joints)
        write_block(b, bodies, joints)


def begin_lane(m: int, r: int, awake: bool, n: int, k: int, bodies: Bodies, joints: Joints) -> None:
    """Note a body in a lane of a row: of the trees that are awake; others have idle ones.

    Body 0 is what the root hangs on.
    """
    row = joints.tree_lanes[r]
    i = len(bodies.kind) - 1
    row[T_MASS + m] = row[T_INERTIA + m] = 1.0
    row[T_INVERSE_MASS + m] = row[T_HELD_INVERSE_INERTIA + m] = 0.0
    if awake and k == 0:
        i = joints.members[joints.members[joints.sparse[n, I_NODE] + 1, JOINED_ABOVE], JOINED_SLOT]
    elif awake:
        member = joints.sparse[n, I_NODE] + k
        i = joints.members[member, JOINED_SLOT]
        row[T_MASS + m] = joints.factors[member - 1, NODE_MASS]
        row[T_INERTIA + m] = joints.factors[member - 1, NODE_INERTIA]
        row[T_INVERSE_MASS + m] = bodies.properties[i, INVERSE_MASS]
        row[T_HELD_INVERSE_INERTIA + m] = joints.places[member, HELD_INVERSE_INERTIA]
    joints.tree_slots[r, m] = i
    pose = bodies.pose[i]
    row[T_POSE_X + m], row[T_POSE_Y + m] = pose[X], pose[Y]
    row[T_POSE_ANGLE + m] = pose[ANGLE]
    for c in range(T_GIVEN_X, T_APART_Y + LANES, LANES):
        row[c + m] = 0.0


def write_blocks(bodies: Bodies, joints: Joints) -> None:
    """Write the hinges of blocks where their bodies are."""
    for b in range(joints.counts[TREE_BLOCKS]):
        write_block(b, bodies, joints)


def write_block(b: int, bodies: Bodies, joints: Joints) -> None:
    """Write the hinges of a block where its bodies are, and what hangs on them."""
    place_block(b, 0.0, bodies, joints)
    first, last = joints.tree_blocks[b, T_FIRST], joints.tree_blocks[b + 1, T_FIRST]
    turn_block(b, T_EACH, joints)
    for r in range(first + 1, last):
        note_apart_lanes(joints.tree_lanes[r])


def place_block(b: int, ahead: float, bodies: Bodies, joints: Joints) -> None:
    """Write where the bodies of a block are, or will be so many seconds ahead."""
    for r in range(joints.tree_blocks[b, T_FIRST], joints.tree_blocks[b + 1, T_FIRST]):
        row = joints.tree_lanes[r]
        load_node(joints.tree_slots[r], bodies, row)
        place_lanes(ahead, row)


def turn_block(b: int, chosen: int, joints: Joints) -> None:
    """Write the hinges of a block where its bodies are placed, in some lanes, and what hangs."""
    first, last = joints.tree_blocks[b, T_FIRST], joints.tree_blocks[b + 1, T_FIRST]
    lanes = joints.tree_lanes
    for r in range(first + 1, last):
        keep_given_lanes(chosen, joints.block_lanes[b], lanes[r])
        turn_lanes(chosen, joints.block_lanes[b], lanes[r], lanes[joints.tree_above[r]])
    for r in range(first, last):
        begin_lanes(lanes[r])
    for r in range(last - 1, first, -1):
        hang_lanes(lanes[r], lanes[joints.tree_above[r]])


def aim_blocks(length: float, joints: Joints) -> None:
    """Note to which gaps a substep brings the hinges of blocks, as `aim_tree` does."""
    for r in range(joints.tree_blocks[joints.counts[TREE_BLOCKS], T_FIRST]):
        aim_lanes(REMOVED_BY_JOINTS * length, joints.tree_lanes[r])


def bring_blocks_to_aims(
    least: int, most: int, substep: float, bodies: Bodies, joints: Joints
) -> None:
    """Bring trees of some statuses to the aims of their hinges, as `bring_tree_to_aims` does."""
    for b in range(joints.counts[TREE_BLOCKS]):
        if has_status(b, least, most, joints):
            bring_block_to_aims(b, substep, bodies, joints)


def bring_block_to_aims(b: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Bring the active trees of a block to the aims of their hinges."""
    lanes = joints.block_lanes[b]
    for k in range(MOST_ITERATIONS_OF_JOINTS):
        find_errors_of_block(b, substep, bodies, joints)
        look_at_errors(k == 0, lanes)
        if some_lanes(T_BACK, lanes):
            push_block(b, T_BACK, -1.0, bodies, joints)
        if some_lanes(T_AGAIN, lanes):
            turn_block(b, T_AGAIN, joints)
        if not some_lanes(T_ACTIVE, lanes):
            return
        solve_block(b, bodies, joints)
        end_slight_lanes(substep, SLIGHT_TURN, lanes)
        if not some_lanes(T_ACTIVE, lanes):
            return


def has_status(b: int, least: int, most: int, joints: Joints) -> bool:
    """Let the trees of a block be active that have a status from the least to the most; say if any.

    None is solved again as yet.
    """
    lanes, found = joints.block_lanes[b], False
    for m in range(LANES):
        n = joints.tree_blocks[b, T_MECHANISM + m]
        status = joints.mechanisms[n, M_STATUS] if n >= 0 else ASLEEP
        active = (status >= least) & (status <= most)
        lanes[T_ACTIVE + m] = 1.0 if active else 0.0
        lanes[T_AGAIN + m] = 0.0
        found |= bool(active)
    return found


def look_at_errors(begins: bool, lanes: Array) -> None:
    """Choose the lanes to solve by the sizes of their errors, now and before."""
    for m in range(LANES):
        size = lanes[T_SIZE + m]
        first = size if begins else lanes[T_SIZE_FIRST + m]
        lanes[T_SIZE_FIRST + m] = first
        active, again = lanes[T_ACTIVE + m] > 0.0, lanes[T_AGAIN + m] > 0.0
        less = begins | (size < lanes[T_BEFORE + m])
        back = active & again & (not less)
        active = active & (not back) & (not size <= SOLVED_RATE * SOLVED_RATE * first)
        slowly = active & (not begins) & (size > SLOWLY * lanes[T_BEFORE + m])
        lanes[T_BACK + m], lanes[T_ACTIVE + m] = 1.0 if back else 0.0, 1.0 if active else 0.0
        lanes[T_AGAIN + m] = 1.0 if slowly else 0.0
        lanes[T_BEFORE + m] = size


def find_errors_of_block(b: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Write the rates that the hinges of a block have too much to get to their aims."""
    place_block(b, substep, bodies, joints)
    lanes, rows = joints.block_lanes[b], joints.tree_lanes
    all_lanes(T_SIZE, 0.0, lanes)
    for r in range(first_hinge(b, joints), joints.tree_blocks[b + 1, T_FIRST]):
        gap_errors_of_lanes(substep, lanes, rows[r], rows[joints.tree_above[r]])


def first_hinge(b: int, joints: Joints) -> int:
    """Return the first row of a block whose nodes hang on something: that of roots, or the next."""
    return int(joints.tree_blocks[b, T_FIRST] + (1 if joints.tree_blocks[b, T_TIED] == 1 else 2))


def fit_blocks(least: int, most: int, bodies: Bodies, joints: Joints) -> None:
    """Take the rates of their hinges from the velocities of trees of some statuses."""
    for b in range(joints.counts[TREE_BLOCKS]):
        if has_status(b, least, most, joints):
            first, last = joints.tree_blocks[b, T_FIRST], joints.tree_blocks[b + 1, T_FIRST]
            for r in range(first, last):
                load_node(joints.tree_slots[r], bodies, joints.tree_lanes[r])
            for r in range(first_hinge(b, joints), last):
                rates_of_lanes(joints.tree_lanes[r], joints.tree_lanes[joints.tree_above[r]])
            solve_block(b, bodies, joints)


def solve_block(b: int, bodies: Bodies, joints: Joints) -> None:
    """Give active trees of a block the impulses that take their errors away."""
    first, last = joints.tree_blocks[b, T_FIRST], joints.tree_blocks[b + 1, T_FIRST]
    rows, lanes, hinge = joints.tree_lanes, joints.block_lanes[b], first_hinge(b, joints)
    for r in range(first, last):
        owe_nothing(rows[r])
    for r in range(last - 1, first + 1, -1):
        owe_lanes(rows[r])
        pass_lanes(rows[r])
        add_passed(T_OWED_X, rows[r], rows[joints.tree_above[r]])
    owe_lanes(rows[first + 1])
    if hinge > first + 1:
        let_lanes_go(rows[first + 1])
    all_lanes(T_LARGEST, 0.0, lanes)
    for r in range(first + 1, last):
        pass_lanes_down(lanes, rows[r], rows[joints.tree_above[r]])
    push_block(b, T_ACTIVE, 1.0, bodies, joints)


def push_block(b: int, chosen: int, sign: float, bodies: Bodies, joints: Joints) -> None:
    """Give some trees of a block the impulses that were found, or take these back."""
    first, last = joints.tree_blocks[b, T_FIRST], joints.tree_blocks[b + 1, T_FIRST]
    rows, lanes = joints.tree_lanes, joints.block_lanes[b]
    for r in range(first_hinge(b, joints), last):
        push_own_lanes(chosen, sign, lanes, rows[r])
        if r > first + 1:
            above = rows[joints.tree_above[r]]
            pass_impulses(chosen, sign, lanes, rows[r], above)
            add_passed(T_VX, rows[r], above)
            add_passed(T_START_X, rows[r], above)
    for r in range(first + 1, last):
        store_node(joints.tree_slots[r], bodies, rows[r])


def store_blocks(joints: Joints) -> None:
    """Store what went through the hinges of blocks in a part, and how far apart they were."""
    for b in range(joints.counts[TREE_BLOCKS]):
        first, last = joints.tree_blocks[b, T_FIRST], joints.tree_blocks[b + 1, T_FIRST]
        for r in range(first + 1, last):
            keep_given_lanes(T_EACH, joints.block_lanes[b], joints.tree_lanes[r])
        for m in range(LANES):
            n = joints.tree_blocks[b, T_MECHANISM + m]
            if n < 0 or joints.mechanisms[n, M_STATUS] == ASLEEP:
                continue
            for r in range(first + 1, last):
                hinge = joints.hinges[joints.sparse[n, I_NODE] + r - first]
                store_lane(m, joints.tree_lanes[r], hinge)
            store_hinge_impulses(n, joints)


def store_lane(m: int, row: Array, hinge: Array) -> None:
    """Let the row of a hinge have what its lane has."""
    hinge[H_GIVEN] = hinge[H_GIVEN + 1] = 0.0
    hinge[H_PULL], hinge[H_PULL + 1] = row[T_PULL_X + m], row[T_PULL_Y + m]
    hinge[H_TURN], hinge[H_FAR_TURN] = row[T_TURN + m], row[T_FAR_TURN + m]
    hinge[H_APART], hinge[H_APART + 1] = row[T_APART_X + m], row[T_APART_Y + m]
