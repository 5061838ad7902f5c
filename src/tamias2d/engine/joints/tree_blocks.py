"""Blocks of equal trees of hinges, each tree in a lane: they are taken through a step together.

Cost: for each node of a block about what four trees by themselves take.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.hinge_tree import SLIGHT_TURN, store_hinge_impulses
from tamias2d.engine.joints.solve import (
    MOST_ITERATIONS_OF_JOINTS,
    REMOVED_BY_JOINTS,
    SLOWLY,
    SOLVED_RATE,
)
from tamias2d.engine.joints.spring_lanes import (
    add_turns,
    begin_springs_of_lanes,
    firm_lanes,
    note_angles_of_lanes,
    note_left_of_lanes,
    owe_springs,
    spring_errors_of_lanes,
    spring_impulses_of_lanes,
    take_left_of_lanes,
    turn_lanes_by_springs,
)
from tamias2d.engine.joints.tree_lanes import (
    add_owed,
    add_pushed,
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
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.joint_step import angular_momentum_later
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array


def begin_blocks(bodies: Bodies, joints: Joints) -> None:
    """Begin a part of a step: note where the bodies of blocks are, and what they weigh."""
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
        all_lanes(tb.T_EACH, 1.0, joints.block_lanes[b])
        written = joints.tree_blocks[b, tb.T_WRITTEN] == 1
        for m in range(LANES):
            n = joints.tree_blocks[b, tb.T_MECHANISM + m]
            awake = n >= 0 and joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP
            for r in range(first, last):
                same = begin_lane(m, r, awake, n, r - first, bodies, joints)
                written = written and same
                if awake and r > first + 1:
                    begin_spring(
                        m, joints.sparse[n, tb.I_NODE] + r - first, joints.tree_lanes[r], joints
                    )
        if not written:
            write_block(b, bodies, joints)
        joints.tree_blocks[b, tb.T_WRITTEN] = 0
        if joints.tree_blocks[b, tb.T_SPRUNG] == 1:
            store_angles(b, joints)


def begin_lane(m: int, r: int, awake: bool, n: int, k: int, bodies: Bodies, joints: Joints) -> bool:
    """Note a body in a lane of a row: of the trees that are awake; others have idle ones.

    Body 0 is what the root hangs on. Return whether it is where the lane was placed, as heavy.
    """
    row = joints.tree_lanes[r]
    i = len(bodies.kind) - 1
    mass, inertia = row[tb.T_MASS + m], row[tb.T_INERTIA + m]
    row[tb.T_MASS + m] = row[tb.T_INERTIA + m] = 1.0
    row[tb.T_INVERSE_MASS + m] = row[tb.T_HELD_INVERSE_INERTIA + m] = 0.0
    if awake and k == 0:
        i = joints.members[
            joints.members[joints.sparse[n, tb.I_NODE] + 1, tb.JOINED_ABOVE], tb.JOINED_SLOT
        ]
    elif awake:
        member = joints.sparse[n, tb.I_NODE] + k
        i = joints.members[member, tb.JOINED_SLOT]
        row[tb.T_MASS + m] = joints.factors[member - 1, tb.NODE_MASS]
        row[tb.T_INERTIA + m] = joints.factors[member - 1, tb.NODE_INERTIA]
        row[tb.T_INVERSE_MASS + m] = bodies.properties[i, tb.INVERSE_MASS]
        row[tb.T_HELD_INVERSE_INERTIA + m] = joints.places[member, tb.HELD_INVERSE_INERTIA]
    joints.tree_slots[r, m] = i
    pose = bodies.pose[i]
    row[tb.T_POSE_X + m], row[tb.T_POSE_Y + m] = pose[tb.X], pose[tb.Y]
    row[tb.T_POSE_ANGLE + m] = pose[tb.ANGLE]
    row[tb.T_STIFFNESS + m] = row[tb.T_DAMPING + m] = row[tb.T_LAW_SIDE + m] = row[
        tb.T_LAW_LEFT + m
    ] = 0.0
    for c in range(tb.T_GIVEN_X, tb.T_LAW_PULL + LANES, LANES):
        row[c + m] = 0.0
    same = (row[tb.T_MASS + m] == mass) & (row[tb.T_INERTIA + m] == inertia)
    same = same & (row[tb.T_X + m] == pose[tb.X]) & (row[tb.T_Y + m] == pose[tb.Y])
    return bool(same & (row[tb.T_ANGLE + m] == pose[tb.ANGLE]))


def begin_spring(m: int, member: int, row: Array, joints: Joints) -> None:
    """Note the spring of the hinge on which a member hangs, in a lane of its row."""
    j = joints.members[member, tb.JOINED_SPRING]
    if j >= 0:
        row[tb.T_JOINT_ANGLE + m] = joints.given[j, 0]
        row[tb.T_STIFFNESS + m] = joints.laws[j, tb.LAW_STIFFNESS]
        row[tb.T_DAMPING + m] = joints.laws[j, tb.LAW_DAMPING]
        row[tb.T_LAW_SIDE + m] = 1.0 if joints.joints[j, tb.J_MEMBER + 1] == member else -1.0
        row[tb.T_LAW_LEFT + m] = joints.numbers[j, tb.J_LEFT]


def write_blocks(bodies: Bodies, joints: Joints) -> None:
    """Write the hinges of blocks where their bodies are."""
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        write_block(b, bodies, joints)


def write_block(b: int, bodies: Bodies, joints: Joints) -> None:
    """Write the hinges of a block where its bodies are, and what hangs on them.

    That is found later for a sprung one, where a substep is known.
    """
    first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
    each, rows = joints.block_lanes[b, tb.T_EACH : tb.T_EACH + LANES], joints.tree_lanes
    for r in range(first, last):
        load_node(joints.tree_slots[r], bodies, rows[r])
        place_lanes(0.0, rows[r])
        if r > first:
            keep_given_lanes(each, rows[r])
            turn_lanes(each, rows[r], rows[joints.tree_above[r]])
            note_apart_lanes(rows[r])
    for r in range(first_sprung(b, joints), last):
        note_angles_of_lanes(rows[r], rows[joints.tree_above[r]])
    if joints.tree_blocks[b, tb.T_SPRUNG] == 0:
        hang_block(b, 0.0, joints)


def turn_block(b: int, joints: Joints) -> None:
    """Write the hinges of a block where its bodies are placed, in lanes that are solved again."""
    first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
    again, rows = joints.block_lanes[b, tb.T_AGAIN : tb.T_AGAIN + LANES], joints.tree_lanes
    for r in range(first + 1, last):
        keep_given_lanes(again, rows[r])
        turn_lanes(again, rows[r], rows[joints.tree_above[r]])


def hang_block(b: int, substep: float, joints: Joints) -> None:
    """Find what hangs on the hinges of a block; springs count through a substep, s, as there."""
    first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
    lanes = joints.tree_lanes
    all_lanes(tb.T_SLIGHT, SLIGHT_TURN, joints.block_lanes[b])
    for r in range(first, last):
        begin_lanes(lanes[r])
    for r in range(first_sprung(b, joints), last):
        firm_lanes(substep, joints.block_lanes[b], lanes[r], lanes[joints.tree_above[r]])
    for r in range(last - 1, first, -1):
        hang_lanes(lanes[r], lanes[joints.tree_above[r]])


def first_sprung(b: int, joints: Joints) -> int:
    """Return the first row of a block whose hinges may have springs; where there are none, its end.

    All after it may, too.
    """
    if joints.tree_blocks[b, tb.T_SPRUNG] == 1:
        return int(joints.tree_blocks[b, tb.T_FIRST] + 2)
    return int(joints.tree_blocks[b + 1, tb.T_FIRST])


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


def first_hinge(b: int, joints: Joints) -> int:
    """Return the first row of a block whose nodes hang on something: that of roots, or the next."""
    return int(
        joints.tree_blocks[b, tb.T_FIRST] + (1 if joints.tree_blocks[b, tb.T_TIED] == 1 else 2)
    )


def fit_blocks(least: int, most: int, bodies: Bodies, joints: Joints) -> None:
    """Take the rates of their hinges from the velocities of trees of some statuses."""
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        if has_status(b, least, most, joints):
            first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
            if joints.tree_blocks[b, tb.T_SPRUNG] == 1:
                hang_block(b, 0.0, joints)
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
        owe_nothing(rows[r])
    for r in range(first_sprung(b, joints), last):
        owe_springs(rows[r])
    for r in range(last - 1, first + 1, -1):
        owe_lanes(rows[r])
        pass_lanes(rows[r])
        add_owed(rows[r], rows[joints.tree_above[r]])
    owe_lanes(rows[first + 1])
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


def give_left_of_blocks(bodies: Bodies, joints: Joints) -> None:
    """Let the springs of blocks that nothing touches give what they have left as a step ends."""
    rows = joints.tree_lanes
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        sprung = joints.tree_blocks[b, tb.T_SPRUNG] == 1
        if sprung and has_status(b, tb.GOVERNED_ALONE, tb.GOVERNED_ALONE, joints):
            first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
            given = joints.block_lanes[b, tb.T_ACTIVE : tb.T_ACTIVE + LANES]
            for r in range(first, last):
                load_node(joints.tree_slots[r], bodies, rows[r])
            for r in range(first_sprung(b, joints), last):
                take_left_of_lanes(given, rows[r])
            turn_by_springs(b, tb.T_ACTIVE, 1.0, joints)
            store_block(b, bodies, joints)


def note_left_of_blocks(joints: Joints) -> None:
    """Note what the springs of blocks have left, as `note_left` does."""
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        sprung = joints.tree_blocks[b, tb.T_SPRUNG] == 1
        if sprung and has_status(b, tb.GOVERNED_ALONE, tb.IN_CONTACT, joints):
            active = joints.block_lanes[b, tb.T_ACTIVE : tb.T_ACTIVE + LANES]
            for r in range(first_sprung(b, joints), joints.tree_blocks[b + 1, tb.T_FIRST]):
                note_left_of_lanes(active, joints.tree_lanes[r])


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


def store_blocks(joints: Joints) -> None:
    """Store what went through the hinges of blocks in a part, and how far apart they were."""
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
        for r in range(first + 1, last):
            each = joints.block_lanes[b, tb.T_EACH : tb.T_EACH + LANES]
            keep_given_lanes(each, joints.tree_lanes[r])
        for m in range(LANES):
            n = joints.tree_blocks[b, tb.T_MECHANISM + m]
            if n < 0 or joints.mechanisms[n, tb.M_STATUS] == tb.ASLEEP:
                continue
            for r in range(first + 1, last):
                member = joints.sparse[n, tb.I_NODE] + r - first
                store_lane(m, joints.tree_lanes[r], joints.hinges[member])
                if joints.members[member, tb.JOINED_SPRING] >= 0:
                    numbers = joints.numbers[joints.members[member, tb.JOINED_SPRING]]
                    store_spring(m, joints.tree_lanes[r], numbers)
            store_hinge_impulses(n, joints)
        joints.tree_blocks[b, tb.T_WRITTEN] = 1


def store_angles(b: int, joints: Joints) -> None:
    """Let the rows of the springs of a block have the angles that were noted."""
    first = joints.tree_blocks[b, tb.T_FIRST]
    for m in range(LANES):
        n = joints.tree_blocks[b, tb.T_MECHANISM + m]
        if n >= 0 and joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            for r in range(first_sprung(b, joints), joints.tree_blocks[b + 1, tb.T_FIRST]):
                j = joints.members[joints.sparse[n, tb.I_NODE] + r - first, tb.JOINED_SPRING]
                if j >= 0:
                    joints.numbers[j, tb.J_ROW] = joints.tree_lanes[r, tb.T_LAW_START + m]


def store_lane(m: int, row: Array, hinge: Array) -> None:
    """Let the row of a hinge have what its lane has."""
    hinge[tb.H_GIVEN] = hinge[tb.H_GIVEN + 1] = 0.0
    hinge[tb.H_PULL], hinge[tb.H_PULL + 1] = row[tb.T_PULL_X + m], row[tb.T_PULL_Y + m]
    hinge[tb.H_TURN], hinge[tb.H_FAR_TURN] = row[tb.T_TURN + m], row[tb.T_FAR_TURN + m]
    hinge[tb.H_APART], hinge[tb.H_APART + 1] = row[tb.T_APART_X + m], row[tb.T_APART_Y + m]


def store_spring(m: int, row: Array, numbers: Array) -> None:
    """Let the numbers of a spring have what its lane has."""
    pull, own = row[tb.T_LAW_PULL + m], row[tb.T_LAW_SIDE + m] > 0.0
    turning, far = row[tb.T_TURNING + m], row[tb.T_FAR_TURNING + m]
    numbers[tb.J_PULL], numbers[tb.J_LEFT] = pull, row[tb.T_LAW_LEFT + m]
    numbers[tb.J_ROW] = row[tb.T_LAW_START + m]
    to = tb.J_TOTAL + 2
    numbers[to] = angular_momentum_later(numbers[to], pull, far if own else turning)
    numbers[to + 3] = angular_momentum_later(numbers[to + 3], pull, turning if own else far)
