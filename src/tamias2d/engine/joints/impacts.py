"""Impacts of mechanisms: contacts and joints answer them at once (DD107).

A contact that meets faster than loads could make it is an impact. Solved in turns with joints it
would stop the link that it touches, again and again, and not what hangs on that. So as a substep
begins, the impulses of all points of the mechanisms that are struck are found together, by
conjugate gradients in which joints answer each direction. They are not those with which contacts
go on. Cost: where something is struck, some solutions of its mechanisms, and visits to its points.
Source: Fletcher and Reeves (1964); Polak and Ribiere (1969); Rockafellar (1976).
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.direct.contacts import gap_later, point_speed
from tamias2d.engine.joined_approach import gain_by_loads
from tamias2d.engine.joints.struck import begin_struck, end_struck, fit_struck
from tamias2d.engine.tables import Bodies, Constraints, Joints, World
from tamias2d.generated.firm_contact import tangent_impulse_most
from tamias2d.generated.island_energy import moment_ahead_later
from tamias2d.generated.joint_step import impact_rate
from tamias2d.generated.soft_contact import (
    angular_velocity_a_after,
    angular_velocity_b_after,
    surface_slip,
    velocity_a_after,
    velocity_b_after,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array, Vector

ROUNDS_OF_IMPACTS = 2  # of normal impulses, then tangent ones; normal ones come last again
STEPS_OF_IMPACTS = 8  # of conjugate gradients, in each of these
IMPACTS_SOLVED = 1e-2  # of the rates at first: what is left contacts and joints answer in turns
HELD_BY_JOINTS = 2.0**-16  # of what its mass by itself answers: what moves less is held
NORMAL_RATES, TANGENT_RATES = range(2)


def answer_impacts(substep: float, world: World) -> None:
    """Give what meets mechanisms too fast, and these, the impulses by which it does so no more."""
    if world.control.counts[tb.IMPACTS] == 0:
        return
    count = list_struck(substep, world)
    if count == 0:
        return
    begin_struck(world.bodies, world.joints)
    fit_struck(world)
    for _ in range(ROUNDS_OF_IMPACTS):
        reduce_impact_rates(NORMAL_RATES, count, world)
        reduce_impact_rates(TANGENT_RATES, count, world)
    reduce_impact_rates(NORMAL_RATES, count, world)
    end_struck(world.joints)


def list_struck(substep: float, world: World) -> int:
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
                count += 1
                if rate < -gain_by_loads(i, j, world.control, bodies):
                    mark_struck(i, bodies, joints)
                    mark_struck(j, bodies, joints)
                    struck = True
    if not struck:
        return 0
    while pass_on_struck(count, world):
        continue
    return keep_struck(count, world)


@inlined
def meets_one(i: int, j: int, bodies: Bodies, joints: Joints) -> bool:
    """Return whether one of two bodies is of a mechanism, and none of one that is a mesh."""
    one, other = mechanism_of(i, bodies, joints), mechanism_of(j, bodies, joints)
    found = one >= 0 or other >= 0
    if one >= 0 and joints.mechanisms[one, tb.M_MESHED] == 1:
        found = False
    if other >= 0 and joints.mechanisms[other, tb.M_MESHED] == 1:
        found = False
    return found


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
    point[tb.STRUCK_NORMAL] = point[tb.STRUCK_TANGENT] = point[tb.STRUCK_STEP] = 0.0
    return float(rate)


def reduce_impact_rates(which: int, count: int, world: World) -> None:
    """Take the rates of one kind from the points on the list, as far as their impulses may.

    Joints answer a trial of each direction, which tells how far to go along it.
    """
    first = before = 0.0
    for step in range(STEPS_OF_IMPACTS):
        size, mixed = find_impact_rates(which, count, world)
        first = max(first, size)
        if not size > IMPACTS_SOLVED * IMPACTS_SOLVED * first:
            return
        kept = max((size - mixed) / before, 0.0) if step > 0 else 0.0
        choose_directions(which, kept, count, world)
        before = size
        push_points(which, 1.0, count, world)
        fit_struck(world)
        push_points(which, share_of_step(which, count, world) - 1.0, count, world)
        fit_struck(world)


def find_impact_rates(which: int, count: int, world: World) -> tuple[float, float]:
    """Find the rates of all points that count; return two sums of products, J.

    These are of the rates with what their own masses answer: now, and as found before.
    """
    size = mixed = 0.0
    for k in range(count):
        point = world.joints.impact_points[k]
        rate, mass = rate_of_point(which, k, world), mass_of_point(which, k, world)
        if not counts_in(which, rate, k, world):
            rate = point[tb.STRUCK_STEP] = 0.0
        size += mass * rate * rate
        mixed += mass * rate * point[tb.STRUCK_RATE]
        point[tb.STRUCK_RATE] = rate
    return size, mixed


def counts_in(which: int, rate: float, k: int, world: World) -> bool:
    """Return whether a point may have an impulse of a kind that changes its rate."""
    point = world.joints.impact_points[k]
    if which == NORMAL_RATES:
        return bool(rate < 0.0 or point[tb.STRUCK_NORMAL] > 0.0)
    least, most = bounds_of_point(which, k, world)
    return bool(point[tb.STRUCK_TANGENT] > least if rate > 0.0 else point[tb.STRUCK_TANGENT] < most)


def bounds_of_point(which: int, k: int, world: World) -> tuple[float, float]:
    """Return the least and the largest impulse of a kind that a point may have, N s."""
    if which == NORMAL_RATES:
        return 0.0, inf
    b, m, _ = place_of_point(k, world.joints)
    friction = world.constraints.blocks[b, tb.R_FRICTION + m]
    most = tangent_impulse_most(world.joints.impact_points[k, tb.STRUCK_NORMAL], friction)
    return -most, most


def rate_of_point(which: int, k: int, world: World) -> float:
    """Return the rate of a point that impulses of a kind are to take away, m/s."""
    b, m, n = place_of_point(k, world.joints)
    row, lanes = world.constraints.blocks[b], world.constraints.lanes[b]
    one = world.bodies.motion[lanes[tb.BODY_A + m]]
    other = world.bodies.motion[lanes[tb.BODY_B + m]]
    at, normal = tb.SHARED + n * tb.POINT_SIZE + m, (row[tb.R_NX + m], row[tb.R_NY + m])
    if which == NORMAL_RATES:
        arm_a, arm_b = row[at + tb.P_NORMAL_ARM_A], row[at + tb.P_NORMAL_ARM_B]
        speed = point_speed(one, other, arm_a, arm_b, normal)
        return float(speed + world.joints.impact_points[k, tb.STRUCK_ALLOWED])
    arm_a, arm_b = row[at + tb.P_TANGENT_ARM_A], row[at + tb.P_TANGENT_ARM_B]
    speed = point_speed(one, other, arm_a, arm_b, (-normal[1], normal[0]))
    return float(surface_slip(speed, row[tb.R_SURFACE_SPEED + m]))


def mass_of_point(which: int, k: int, world: World) -> float:
    """Return the mass of a point by itself along one of its lines, kg."""
    b, m, n = place_of_point(k, world.joints)
    at = tb.SHARED + n * tb.POINT_SIZE + m
    column = tb.P_NORMAL_MASS if which == NORMAL_RATES else tb.P_TANGENT_MASS
    return float(world.constraints.blocks[b, at + column])


def choose_directions(which: int, kept: float, count: int, world: World) -> None:
    """Choose what to try at all points: what their masses answer, and a share of what was tried.

    No impulse leaves its bounds by it.
    """
    for k in range(count):
        point = world.joints.impact_points[k]
        wanted = (
            kept * point[tb.STRUCK_STEP] - mass_of_point(which, k, world) * point[tb.STRUCK_RATE]
        )
        least, most = bounds_of_point(which, k, world)
        has = point[tb.STRUCK_NORMAL if which == NORMAL_RATES else tb.STRUCK_TANGENT]
        point[tb.STRUCK_STEP] = min(max(wanted, least - has), most - has)


def share_of_step(which: int, count: int, world: World) -> float:
    """Return how far to go along what was tried once: to least motion, or to a bound.

    That is nowhere where joints hold the points fast.
    """
    wanted = answered = alone = 0.0
    share = inf
    for k in range(count):
        point = world.joints.impact_points[k]
        step = point[tb.STRUCK_STEP]
        answered += step * (rate_of_point(which, k, world) - point[tb.STRUCK_RATE])
        alone += step * step / mass_of_point(which, k, world) if step != 0.0 else 0.0
        wanted -= step * point[tb.STRUCK_RATE]
        least, most = bounds_of_point(which, k, world)
        has = point[tb.STRUCK_NORMAL if which == NORMAL_RATES else tb.STRUCK_TANGENT] - step
        if step != 0.0:
            share = min(share, ((most if step > 0.0 else least) - has) / step)
    if not answered > HELD_BY_JOINTS * alone:
        return 0.0
    return max(min(wanted / answered, share), 0.0)


def push_points(which: int, share: float, count: int, world: World) -> None:
    """Give bodies a share of what is tried at all points, and add it to what these have given."""
    for k in range(count):
        point = world.joints.impact_points[k]
        impulse = share * point[tb.STRUCK_STEP]
        if impulse != 0.0:
            b, m, n = place_of_point(k, world.joints)
            at, row = tb.SHARED + n * tb.POINT_SIZE + m, world.constraints.blocks[b]
            line = (row[tb.R_NX + m], row[tb.R_NY + m])
            if which == NORMAL_RATES:
                point[tb.STRUCK_NORMAL] += impulse
                row[at + tb.P_TOTAL_IMPULSE] += impulse
                push_point(
                    b, m, impulse, line, at + tb.P_NORMAL_ARM_A, at + tb.P_NORMAL_ARM_B, world
                )
            else:
                point[tb.STRUCK_TANGENT] += impulse
                row[at + tb.P_TOTAL_FRICTION] += impulse
                line = (-line[1], line[0])
                push_point(
                    b, m, impulse, line, at + tb.P_TANGENT_ARM_A, at + tb.P_TANGENT_ARM_B, world
                )


def push_point(
    b: int, m: int, impulse: float, line: Vector, arm_a: int, arm_b: int, world: World
) -> None:
    """Give two bodies an impulse, N s, along a line, which is not that of a substep.

    The arms are in columns of the block. Bodies that joints hold turn by it as they do in these.
    """
    bodies, islands = world.bodies, world.islands
    row, lanes = world.constraints.blocks[b], world.constraints.lanes[b]
    i, j = lanes[tb.BODY_A + m], lanes[tb.BODY_B + m]
    for end in range(2):
        each = i if end == 0 else j
        now, state = bodies.motion[each], bodies.substep_state[each]
        x, y, spin = now[tb.VX], now[tb.VY], now[tb.SPIN]
        member = int(bodies.properties[each, tb.JOINED])
        held = world.joints.places[member, tb.HELD_INVERSE_INERTIA]
        if end == 0:
            now[tb.VX], now[tb.VY] = velocity_a_after((x, y), impulse, line, row[tb.R_MASS_A + m])
            inertia = held if member > 0 else row[tb.R_INERTIA_A + m]
            now[tb.SPIN] = angular_velocity_a_after(spin, impulse, row[arm_a], inertia)
        else:
            now[tb.VX], now[tb.VY] = velocity_b_after((x, y), impulse, line, row[tb.R_MASS_B + m])
            inertia = held if member > 0 else row[tb.R_INERTIA_B + m]
            now[tb.SPIN] = angular_velocity_b_after(spin, impulse, row[arm_b], inertia)
        by = (now[tb.VX] - x, now[tb.VY] - y)
        state[tb.SUBSTEP_START] += by[0]
        state[tb.SUBSTEP_START + 1] += by[1]
        state[tb.SUBSTEP_START + 2] += now[tb.SPIN] - spin
        if islands.held[each] == 0:
            given = islands.energy[each]
            given[tb.VELOCITY_GIVEN] += by[0]
            given[tb.VELOCITY_GIVEN + 1] += by[1]
            given[tb.ANGULAR_VELOCITY_GIVEN] += now[tb.SPIN] - spin
            way = (now[tb.DX], now[tb.DY])
            given[tb.MOMENT_AHEAD] = moment_ahead_later(given[tb.MOMENT_AHEAD], way, by)
