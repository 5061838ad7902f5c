"""The rows of joints where their bodies are in a substep, and the matrix that answers them.

Each row resists its rate like a very large mass, which is added to the masses of the bodies (DD57):
joints that depend on each other share their load, and nothing is singular.

Cost: cosine and sine of each body, some blocks for each joint, and a sparse factorization.
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.direct.cholesky import factor
from tamias2d.engine.direct.matrix import add_diagonal, clear_pivot
from tamias2d.engine.joints.placed_rows import write_bends, write_slopes
from tamias2d.engine.joints.slowed import slowed_column, slowed_inverses
from tamias2d.engine.rotation import cosine_sine
from tamias2d.engine.tables import Bodies, Integers, Joints
from tamias2d.generated.joint_rows import KINDS, ROW, revolute_bends
from tamias2d.generated.joint_step import (
    coupled_inertia,
    coupled_lever,
    coupled_mass,
    coupled_moment,
    firmness,
    implicit_share,
    inertia_held,
    leaning,
    row_damping_softer,
    row_stiffness_softer,
    row_yield,
    slope_squared,
    slope_turned,
    spring_firmness,
)
from tamias2d.generated.soft_contact import shift_later, turn_later
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

FIRM = 1e8  # firmness of a row, for each unit of its own mass
ROW_TURNED = 0.48  # sine of half a radian, by which a row may turn in a substep
HINGE = KINDS.index("revolute")
HELD_WHERE_TOUCHED = 4.0  # times its own inertia: 1 and 16 part planks of bridges more
TURNED_TOGETHER = 8  # angles: as many as fit into the widest registers


def linearise(n: int, bodies: Bodies, joints: Joints) -> None:
    """Write the rows of a mechanism where its bodies are, and factor its matrix for velocities.

    That of a governed one is found where its springs are known.
    """
    first, last = joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]
    place_members(first + 1, last + 1, 0.0, bodies, joints)
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        write_rows(j, joints)
    if joints.mechanisms[n, tb.M_GOVERNED] == 0:
        factor_mechanism(n, 0.0, joints)


def write_rows(j: int, joints: Joints) -> None:
    """Write the rows of a joint where its members are, and note by how much they are apart."""
    rows_where_placed(j, joints)
    note_apart(joints.joints[j], joints.numbers[j])


def rows_where_placed(j: int, joints: Joints) -> None:
    """Write the rows of a joint where its members are placed, and note if the first turned far."""
    numbers = joints.numbers[j]
    of_a, of_b = tb.J_ROW + 1, tb.J_ROW + 4
    before_a = (numbers[of_a], numbers[of_a + 1])
    before_b = (numbers[of_b], numbers[of_b + 1])
    write_slopes(j, joints)
    now_a, now_b = (numbers[of_a], numbers[of_a + 1]), (numbers[of_b], numbers[of_b + 1])
    if has_turned(before_a, now_a) or has_turned(before_b, now_b):
        numbers[tb.J_TURNED] = 1.0


@inlined
def has_turned(before: tuple[float, float], now: tuple[float, float]) -> bool:
    """Return whether a slope turned so far that a step loses energy by it."""
    return slope_turned(before, now) > ROW_TURNED * slope_squared(now)


def note_apart(ends: Integers, numbers: Array) -> None:
    """Note by how much the rows of a joint are apart, if that is more than before.

    Limits that bodies pass in a step are not told, but those that yield.
    """
    told = ends[tb.J_LAW] == tb.KEPT or numbers[tb.J_FIRMEST] > 0.0
    for r in range(ends[tb.J_ROWS] if told else 0):
        numbers[tb.J_APART + r] = max(numbers[tb.J_APART + r], apart_by_law(r, ends, numbers))


def apart_by_law(r: int, ends: Integers, numbers: Array) -> float:
    """Return by how much a row of a joint is apart, m or rad; of a limit, how far it is passed."""
    law, value = ends[tb.J_LAW], numbers[tb.J_ROW + ROW * r]
    if law == tb.KEPT:
        return abs(value)
    if law == tb.LOWER_LIMIT:
        return max(-value, 0.0)
    return max(value, 0.0) if law == tb.UPPER_LIMIT else 0.0


def factor_mechanism(n: int, substep: float, joints: Joints) -> None:
    """Find how firm the rows of a mechanism are that hold, and factor its matrix.

    Springs count through a substep, s; not where that is 0 and velocities alone are looked at.
    Rounding leaves each pivot positive, as long as the bodies times the rows at one are less than
    1e7: scaled by the roots of the masses, the matrix is one, and `FIRM` at most for each row.
    """
    meshed = joints.mechanisms[n, tb.M_MESHED] == 1
    first, last = joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]
    for pivot in range(first, first if meshed else last):
        clear_pivot(pivot, joints.sparse, joints.factors)
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        ends, numbers = joints.joints[j], joints.numbers[j]
        for r in range(ends[tb.J_ROWS]):
            yielding = yield_of_row(r, ends, numbers, joints)
            most = numbers[tb.J_FIRMEST + r]
            firm = firmness_by_law(yielding, yielding, most, j, substep, joints)
            numbers[tb.J_FIRMNESS + r] = firm
            if not meshed:
                add_joint_row(r, ends, numbers, joints)
    if not meshed:
        factor(n, joints.sparse, joints.factors)


def firmness_by_law(
    yielding: float, hinged: float, most: float, j: int, substep: float, joints: Joints
) -> float:
    """Return how firm a row is, kg, that yields so much, 1/kg, by itself, and so much with a hinge.

    A row that yields is no firmer than so much; 0 for one that does not. It is noted after which
    share a spring answers.
    """
    firm = firmness_that_yields(yielding)
    if joints.joints[j, tb.J_LAW] == tb.SPRING:
        stiffness, damping = spring_now(j, joints)
        share = implicit_share(stiffness, damping, hinged, substep)
        joints.numbers[j, tb.J_SHARE] = share
        return min(firm, spring_firmness(stiffness, damping, share, substep))
    if joints.joints[j, tb.J_STATE] != tb.HOLDS:
        return 0.0
    return min(firm, most) if most > 0.0 else firm


@inlined
def spring_now(j: int, joints: Joints) -> tuple[float, float]:
    """Return the stiffness, N/m, and the damping, kg/s, of the spring of a row: its share of them.

    It is less than one where that has a maximum, and would exert more.
    """
    share, law = joints.numbers[j, tb.J_EXERTED], joints.laws[j]
    return (
        row_stiffness_softer(share, law[tb.LAW_STIFFNESS]),
        row_damping_softer(share, law[tb.LAW_DAMPING]),
    )


def place_members(first: int, last: int, ahead: float, bodies: Bodies, joints: Joints) -> None:
    """Write where members are, or will be so many seconds ahead with the velocities they have."""
    move_members(first, last, ahead, bodies, joints)
    turn_members(first, last, joints)


def move_members(first: int, last: int, ahead: float, bodies: Bodies, joints: Joints) -> None:
    """Write where members are, as above; cosines and sines stand by themselves."""
    joints.clock[tb.CLOCK_AHEAD] = ahead
    angles = joints.turns[0]
    for m in range(first, last):
        i, place = joints.members[m, tb.JOINED_SLOT], joints.places[m]
        pose, now = bodies.pose[i], bodies.motion[i]
        by_x, by_y = shift_later((now[tb.DX], now[tb.DY]), (now[tb.VX], now[tb.VY]), ahead)
        place[tb.PLACE_X], place[tb.PLACE_Y] = pose[tb.X] + by_x, pose[tb.Y] + by_y
        place[tb.PLACE_ANGLE] = pose[tb.ANGLE] + turn_later(now[tb.DANGLE], now[tb.SPIN], ahead)
        angles[m] = place[tb.PLACE_ANGLE]
    turn_all(first, last, joints.turns[0], joints.turns[1], joints.turns[2])


@inlined
def lean_at_hinge(ends: Integers, numbers: Array, given: Array, joints: Joints) -> None:
    """Add how the pull of a hinge leans on the arms of its bodies."""
    place_a, place_b = joints.places[ends[tb.J_MEMBER]], joints.places[ends[tb.J_MEMBER + 1]]
    bends = joints.bends
    revolute_bends(given, place_a, place_b, bends)
    if ends[tb.J_NODE] >= 0:
        place_a[tb.LEANING] += leaning(numbers[tb.J_FORCE], bends[0])
        place_a[tb.LEANING] += leaning(numbers[tb.J_FORCE + 1], bends[tb.ENDS_OF_JOINT])
    if ends[tb.J_NODE + 1] >= 0:
        place_b[tb.LEANING] += leaning(numbers[tb.J_FORCE], bends[1])
        place_b[tb.LEANING] += leaning(numbers[tb.J_FORCE + 1], bends[tb.ENDS_OF_JOINT + 1])


def turn_members(first: int, last: int, joints: Joints) -> None:
    """Write cosines and sines where generated code takes them."""
    for m in range(first, last):
        place = joints.places[m]
        place[tb.PLACE_COSINE], place[tb.PLACE_SINE] = joints.turns[1, m], joints.turns[2, m]


def turn_all(first: int, last: int, angles: Array, cosines: Array, sines: Array) -> None:
    """Write the cosines and sines of some angles, in whole lanes: others stay as they are."""
    last = first + TURNED_TOGETHER * ((last - first - 1) // TURNED_TOGETHER + 1)
    angle, cosine, sine = angles[first:last], cosines[first:last], sines[first:last]
    for k in range(len(angle)):
        cosine[k], sine[k] = cosine_sine(angle[k])


def add_joint_row(r: int, ends: Integers, numbers: Array, joints: Joints) -> None:
    """Add a row of a joint to the blocks of its nodes and edges."""
    firm = numbers[tb.J_FIRMNESS + r]
    for end in range(tb.ENDS_OF_JOINT):
        if ends[tb.J_NODE + end] >= 0:
            at = tb.J_ROW + ROW * r + 1 + 3 * end
            slope, turning = (numbers[at], numbers[at + 1]), numbers[at + 2]
            add_diagonal(ends[tb.J_NODE + end], firm, slope, turning, joints.factors)
    for pair in range(tb.ENDS_OF_JOINT):
        edge = ends[tb.J_EDGE + pair]
        if edge >= 0:
            one, other = pair // 2, 1 + (pair + 1) // 2  # AB, AC, BC
            if joints.sparse[edge, tb.E_NODE_A] != ends[tb.J_NODE + one]:
                one, other = other, one
            at = tb.J_ROW + ROW * r + 1
            add_coupling(at + 3 * one, at + 3 * other, firm, numbers, joints.factors[edge])


def yield_of_row(r: int, ends: Integers, numbers: Array, joints: Joints) -> float:
    """Return by how much a row yields, 1/kg; 0 for one that nothing moves.

    A body that does not turn gets no slopes for turning.
    """
    yielding = 0.0
    for end in range(tb.ENDS_OF_JOINT):
        at, member = tb.J_ROW + ROW * r + 1 + 3 * end, ends[tb.J_MEMBER + end]
        if ends[tb.J_NODE + end] >= 0:
            slope, inverse = (numbers[at], numbers[at + 1]), joints.places[member]
            if inverse[tb.HELD_INVERSE_INERTIA] == 0.0:
                numbers[at + 2] = 0.0
            yielding += row_yield(
                slope,
                numbers[at + 2],
                inverse[tb.SLOWED_INVERSE_MASS],
                inverse[tb.HELD_INVERSE_INERTIA],
            )
    return yielding


@inlined
def firmness_that_yields(yielding: float) -> float:
    """Return how firm a row is that yields so much, 1/kg."""
    return firmness(FIRM, yielding) if yielding > 0.0 else 0.0


@inlined
def add_coupling(early: int, late: int, firm: float, numbers: Array, e: Array) -> None:
    """Add a row to the block of an edge, with its slopes at the earlier and at the later node."""
    slope, turning = (numbers[early], numbers[early + 1]), numbers[early + 2]
    slope_late, turning_late = (numbers[late], numbers[late + 1]), numbers[late + 2]
    x_x, x_y = coupled_mass(slope, slope_late[0], firm)
    y_x, y_y = coupled_mass(slope, slope_late[1], firm)
    x_turn, y_turn = coupled_moment(turning, slope_late, firm)
    turn_x, turn_y = coupled_lever(slope, turning_late, firm)
    e[tb.OFF_DIAGONAL] += x_x
    e[tb.OFF_DIAGONAL + 1] += x_y
    e[tb.OFF_DIAGONAL + 2] += x_turn
    e[tb.OFF_DIAGONAL + 3] += y_x
    e[tb.OFF_DIAGONAL + 4] += y_y
    e[tb.OFF_DIAGONAL + 5] += y_turn
    e[tb.OFF_DIAGONAL + 6] += turn_x
    e[tb.OFF_DIAGONAL + 7] += turn_y
    e[tb.OFF_DIAGONAL + 8] += coupled_inertia(turning, turning_late, firm)


def note_node_masses(n: int, substep: float, bodies: Bodies, joints: Joints) -> bool:
    """Note slots and masses of the nodes of a mechanism; return whether a mass is another one.

    They are those with which drag lets bodies answer through a substep. An inertia is 0 for a body
    that does not turn.

    A body at whose arms joints pull counts with so much inertia that it swings slowly enough for
    substeps; with a few times its own at most, on which contacts act, if these touch the mechanism.
    """
    note_leaning(n, joints)
    most = HELD_WHERE_TOUCHED if joints.mechanisms[n, tb.M_TOUCHED] == 1 else inf
    column, changed = slowed_column(n, joints), False
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        i, place = joints.members[node + 1, tb.JOINED_SLOT], joints.places[node + 1]
        factors = joints.factors[node]
        joints.sparse[node, tb.N_BODY] = i
        inverse_mass, inverse_inertia = slowed_inverses(i, column, bodies)
        mass, held = 1.0 / inverse_mass, 0.0
        place[tb.SLOWED_INVERSE_MASS], place[tb.HELD_INVERSE_INERTIA] = inverse_mass, 0.0
        if inverse_inertia > 0.0:
            held = inertia_held(1.0 / inverse_inertia, place[tb.LEANING], substep, most)
            place[tb.HELD_INVERSE_INERTIA] = 1.0 / held
        changed = changed | (factors[tb.NODE_MASS] != mass) | (factors[tb.NODE_INERTIA] != held)
        factors[tb.NODE_MASS], factors[tb.NODE_INERTIA] = mass, held
    return bool(changed)


def note_leaning(n: int, joints: Joints) -> None:
    """Note how the pull of joints, as it was last, leans on the arms of a mechanism's bodies."""
    for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
        joints.places[m, tb.LEANING] = 0.0
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        ends, numbers, bends = joints.joints[j], joints.numbers[j], joints.bends
        if ends[tb.J_KIND] == HINGE:
            lean_at_hinge(ends, numbers, joints.given[j], joints)
            continue
        write_bends(j, joints)
        for r in range(ends[tb.J_ROWS]):
            for end in range(tb.ENDS_OF_JOINT):
                if ends[tb.J_NODE + end] >= 0:
                    by = leaning(numbers[tb.J_FORCE + r], bends[tb.ENDS_OF_JOINT * r + end])
                    joints.places[ends[tb.J_MEMBER + end], tb.LEANING] += by
