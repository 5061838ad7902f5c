"""The points at which mechanisms are struck, or rebound, listed with what they may do (DD107).

Cost: a visit to each point of a mechanism in a part in which one is struck.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.direct.contacts import gap_later, point_speed
from tamias2d.engine.joined_approach import gain_by_loads
from tamias2d.engine.joints.hinge_tree import first_besides
from tamias2d.engine.tables import Bodies, Constraints, Joints, World
from tamias2d.generated.joint_step import impact_rate, lost_velocity
from tamias2d.kernels.assembled import inlined
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array


def list_struck(rebounds: bool, substep: float, world: World) -> int:
    """List the points of all mechanisms that are struck, and mark these; return how many.

    What a struck one touches is struck with it.
    """
    bodies, constraints, joints = world.bodies, world.constraints, world.joints
    count, struck = 0, False
    for b in range(constraints.counts[tb.BLOCKS]):
        lanes = constraints.lanes[b]
        for m in range(lanes[tb.FILLED]):
            i, j = lanes[tb.BODY_A + m], lanes[tb.BODY_B + m]
            room = count + lanes[tb.POINTS] <= len(joints.impact_points)
            if not (room and meets_one(i, j, bodies, joints)):
                continue
            for n in range(lanes[tb.POINTS]):
                rate = begin_impact_point(b, m, n, substep, world, joints.impact_points[count])
                strikes = rate < -gain_by_loads(i, j, world.control, bodies)
                if rebounds:
                    strikes = begin_rebound(b, m, n, constraints, joints.impact_points[count])
                count += 1
                if strikes:
                    mark_struck(i, bodies, joints)
                    mark_struck(j, bodies, joints)
                    struck = True
    if not struck:
        return 0
    while pass_on_struck(count, world):
        continue
    return keep_struck(count, world)


def meets_one(i: int, j: int, bodies: Bodies, joints: Joints) -> bool:
    """Return whether one of two bodies is of a mechanism, and none of one that has loops."""
    one, other = mechanism_of(i, bodies, joints), mechanism_of(j, bodies, joints)
    looped = has_loops(one, joints) or has_loops(other, joints)
    return bool((one >= 0 or other >= 0) and not looped)


def has_loops(n: int, joints: Joints) -> bool:
    """Return whether a mechanism, if it is one, is a mesh, or a tree of hinges with a loop.

    A straight bridge would part: its hinges let planks go across, and not far.
    """
    if n < 0:
        return False
    if joints.mechanisms[n, tb.M_MESHED] == 1:
        return True
    if joints.mechanisms[n, tb.M_HINGED] == 0:
        return False
    for k in range(first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        if joints.joints[k, tb.J_LAW] == tb.KEPT:
            return True
    return False


@inlined
def mechanism_of(i: int, bodies: Bodies, joints: Joints) -> int:
    """Return the mechanism of a body, or -1."""
    m = int(bodies.properties[i, tb.JOINED])
    return int(joints.members[m, tb.JOINED_MECHANISM]) if m > 0 else -1


def mark_struck(i: int, bodies: Bodies, joints: Joints) -> bool:
    """Mark the mechanism of a body as struck, if it has one; return whether it was not."""
    n = mechanism_of(i, bodies, joints)
    new = n >= 0 and joints.mechanisms[n, tb.M_STATUS] == tb.IN_CONTACT
    if new:
        joints.mechanisms[n, tb.M_STATUS] = tb.STRUCK
    return new


def pass_on_struck(count: int, world: World) -> bool:
    """Mark what points of struck mechanisms touch as struck, too; return whether there was any."""
    bodies, joints = world.bodies, world.joints
    some = False
    for k in range(count):
        i, j = bodies_of_point(k, world.constraints, joints)
        if is_struck(i, bodies, joints) != is_struck(j, bodies, joints):
            some |= mark_struck(i, bodies, joints)
            some |= mark_struck(j, bodies, joints)
    return some


def is_struck(i: int, bodies: Bodies, joints: Joints) -> bool:
    """Return whether a body is of a mechanism that is struck."""
    n = mechanism_of(i, bodies, joints)
    return bool(n >= 0 and joints.mechanisms[n, tb.M_STATUS] == tb.STRUCK)


def keep_struck(count: int, world: World) -> int:
    """Keep the points of struck mechanisms alone on the list; return how many these are."""
    bodies, joints = world.bodies, world.joints
    kept = 0
    for k in range(count):
        i, j = bodies_of_point(k, world.constraints, joints)
        if is_struck(i, bodies, joints) or is_struck(j, bodies, joints):
            for at in range(len(joints.impact_points[k])):
                joints.impact_points[kept, at] = joints.impact_points[k, at]
            kept += 1
    return kept


def bodies_of_point(k: int, constraints: Constraints, joints: Joints) -> tuple[int, int]:
    """Return the slots of the bodies of a point on the list."""
    b, m, _ = place_of_point(k, joints)
    lanes = constraints.lanes[b]
    return lanes[tb.BODY_A + m], lanes[tb.BODY_B + m]


@inlined
def place_of_point(k: int, joints: Joints) -> tuple[int, int, int]:
    """Return block, lane and number of a point on the list."""
    place = int(joints.impact_points[k, tb.STRUCK_PLACE])
    return place // (2 * LANES), place // 2 % LANES, place % 2


def begin_impact_point(b: int, m: int, n: int, substep: float, world: World, point: Array) -> float:
    """Write a point to the list; return the rate at which it closes more than its gap, m/s."""
    row, lanes = world.constraints.blocks[b], world.constraints.lanes[b]
    at, normal = tb.SHARED + n * tb.POINT_SIZE + m, (row[tb.R_NX + m], row[tb.R_NY + m])
    one = world.bodies.motion[lanes[tb.BODY_A + m]]
    other = world.bodies.motion[lanes[tb.BODY_B + m]]
    arm_a, arm_b = row[at + tb.P_NORMAL_ARM_A], row[at + tb.P_NORMAL_ARM_B]
    speed = point_speed(one, other, arm_a, arm_b, normal)
    rate = impact_rate(speed, gap_later(m, at, row, one, other), substep)
    point[tb.STRUCK_PLACE], point[tb.STRUCK_ALLOWED] = 2 * (LANES * b + m) + n, rate - speed
    point[tb.STRUCK_NORMAL] = point[tb.STRUCK_TANGENT] = 0.0
    return float(rate)


def begin_rebound(b: int, m: int, n: int, constraints: Constraints, point: Array) -> bool:
    """Let a point on the list aim at the rate with which it rebounds; return whether it does."""
    row, at = constraints.blocks[b], tb.SHARED + n * tb.POINT_SIZE + m
    met, share = row[at + tb.P_APPROACH], row[tb.R_RESTITUTION + m]
    rebounds = met < 0.0 and share > 0.0 and row[at + tb.P_TOTAL_IMPULSE] > 0.0
    if rebounds:
        point[tb.STRUCK_ALLOWED] = -lost_velocity(0.0, met, share)
    return bool(rebounds)
