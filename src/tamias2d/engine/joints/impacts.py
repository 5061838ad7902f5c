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
from tamias2d.engine.direct.contacts import point_speed
from tamias2d.engine.joints.struck import begin_struck, end_struck, fit_struck
from tamias2d.engine.joints.struck_points import list_struck, place_of_point
from tamias2d.engine.tables import World
from tamias2d.generated.firm_contact import limited_tangent_impulse, tangent_impulse_most
from tamias2d.generated.island_energy import moment_ahead_later
from tamias2d.generated.soft_contact import (
    angular_velocity_a_after,
    angular_velocity_b_after,
    surface_slip,
    velocity_a_after,
    velocity_b_after,
)
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Vector

STEPS_OF_IMPACTS = 8  # of conjugate gradients
IMPACTS_SOLVED = 1e-2  # of the rates at first: what is left contacts and joints answer in turns
HELD_BY_JOINTS = 2.0**-16  # of what its mass by itself answers: what moves less is held
NORMAL_RATES, TANGENT_RATES, REBOUND_RATES = range(3)


def answer_impacts(substep: float, world: World) -> None:
    """Give what meets mechanisms too fast, and these, the impulses by which it does so no more."""
    if world.control.counts[tb.IMPACTS] == 1:
        answer_struck(False, list_struck(False, substep, world), world)


def answer_rebounds(world: World) -> None:
    """Let the contacts of mechanisms rebound as a part ends, all at once."""
    if world.joints.counts[tb.MECHANISMS_TOUCHED] > 0:
        answer_struck(True, list_struck(True, world.control.settings[tb.SUBSTEP], world), world)


def answer_struck(rebounds: bool, count: int, world: World) -> None:
    """Take from the points on the list what is too much of their rates; no friction in rebounds."""
    if count == 0:
        return
    begin_struck(world.joints)
    fit_struck(world)
    if not rebounds:
        reduce_impact_rates(NORMAL_RATES, count, world)
        reduce_impact_rates(TANGENT_RATES, count, world)
    reduce_impact_rates(REBOUND_RATES if rebounds else NORMAL_RATES, count, world)
    if not rebounds:
        limit_friction(count, world)
        reduce_impact_rates(TANGENT_RATES, count, world)
    end_struck(world.joints)


def reduce_impact_rates(which: int, count: int, world: World) -> None:
    """Take the rates of one kind from the points on the list, as far as their impulses may.

    Joints answer a trial of each direction, which tells how far to go along it. What is left to go
    is done with the next trial.
    """
    first = size = find_impact_rates(which, count, world)
    kept = 0.0
    for _ in range(STEPS_OF_IMPACTS):
        if not size > IMPACTS_SOLVED * IMPACTS_SOLVED * first:
            break
        choose_directions(which, kept, count, world)
        push_points(which, count, world)
        fit_struck(world)
        before = size
        size, mixed = step_along_impacts(which, count, world)
        kept = max((size - mixed) / before, 0.0)
    if first > 0.0:
        for k in range(count):
            world.joints.impact_points[k, tb.STRUCK_STEP] = 0.0
        push_points(which, count, world)
        fit_struck(world)


def limit_friction(count: int, world: World) -> None:
    """Let no point drag by more than the impulse allows that has come to press there."""
    some = False
    for k in range(count):
        point = world.joints.impact_points[k]
        _, most = bounds_of_point(TANGENT_RATES, k, world)
        drag = point[tb.STRUCK_TANGENT]
        point[tb.STRUCK_STEP] = 0.0
        point[tb.STRUCK_LEFT] = limited_tangent_impulse(drag, most) - drag
        some = some or point[tb.STRUCK_LEFT] != 0.0
    if some:
        push_points(TANGENT_RATES, count, world)
        fit_struck(world)


def find_impact_rates(which: int, count: int, world: World) -> float:
    """Find the rates of all points; return the product with what their own masses answer, J."""
    size = 0.0
    for k in range(count):
        point = world.joints.impact_points[k]
        rate = point[tb.STRUCK_RATE] = rate_of_point(which, k, world)
        point[tb.STRUCK_STEP] = point[tb.STRUCK_LEFT] = 0.0
        if counts_in(which, rate, k, world):
            size += mass_of_point(which, k, world) * rate * rate
    return size


def counts_in(which: int, rate: float, k: int, world: World) -> bool:
    """Return whether a point may have an impulse of a kind that changes its rate."""
    has, (least, most) = impulse_of_point(which, k, world), bounds_of_point(which, k, world)
    return bool(has > least if rate > 0.0 else has < most)


def impulse_of_point(which: int, k: int, world: World) -> float:
    """Return the impulse that a point has along one of its lines, with what is left to go, N s."""
    point = world.joints.impact_points[k]
    column = tb.STRUCK_TANGENT if which == TANGENT_RATES else tb.STRUCK_NORMAL
    return float(point[column] + point[tb.STRUCK_LEFT])


def bounds_of_point(which: int, k: int, world: World) -> tuple[float, float]:
    """Return the least and the largest impulse of a kind that a point may have, N s."""
    if which != TANGENT_RATES:
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
    if which != TANGENT_RATES:
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
    column = tb.P_TANGENT_MASS if which == TANGENT_RATES else tb.P_NORMAL_MASS
    return float(world.constraints.blocks[b, at + column])


def choose_directions(which: int, kept: float, count: int, world: World) -> None:
    """Choose what to try at all points: what their masses answer, and a share of what was tried.

    No impulse leaves its bounds by it.
    """
    for k in range(count):
        point = world.joints.impact_points[k]
        rate, wanted = point[tb.STRUCK_RATE], 0.0
        if counts_in(which, rate, k, world):
            wanted = kept * point[tb.STRUCK_STEP] - mass_of_point(which, k, world) * rate
        least, most = bounds_of_point(which, k, world)
        has = impulse_of_point(which, k, world)
        point[tb.STRUCK_STEP] = min(max(wanted, least - has), most - has)


def step_along_impacts(which: int, count: int, world: World) -> tuple[float, float]:
    """Go along what was tried; return two sums of products of rates, J.

    These are of those that come to be with what masses answer them, and with the rates before.
    """
    share, size, mixed = share_of_step(which, count, world), 0.0, 0.0
    for k in range(count):
        point = world.joints.impact_points[k]
        before, tried = point[tb.STRUCK_RATE], rate_of_point(which, k, world)
        rate = before + share * (tried - before)
        point[tb.STRUCK_RATE], point[tb.STRUCK_LEFT] = rate, (share - 1.0) * point[tb.STRUCK_STEP]
        if counts_in(which, rate, k, world):
            mass = mass_of_point(which, k, world)
            size, mixed = size + mass * rate * rate, mixed + mass * rate * before
    return size, mixed


def share_of_step(which: int, count: int, world: World) -> float:
    """Return how far to go along what was tried once: to least motion, or to a bound.

    That is nowhere where joints hold the points fast.
    """
    wanted = answered = alone = 0.0
    share = inf
    for k in range(count):
        point = world.joints.impact_points[k]
        step = point[tb.STRUCK_STEP]
        if step != 0.0:
            rate, mass = point[tb.STRUCK_RATE], mass_of_point(which, k, world)
            answered += step * (rate_of_point(which, k, world) - rate)
            alone += step * step / mass
            wanted -= step * rate
            least, most = bounds_of_point(which, k, world)
            has = impulse_of_point(which, k, world) - step
            share = min(share, ((most if step > 0.0 else least) - has) / step)
    if not answered > HELD_BY_JOINTS * alone:
        return 0.0
    return max(min(wanted / answered, share), 0.0)


def push_points(which: int, count: int, world: World) -> None:
    """Give bodies what is left to go and what is tried at all points; add it to what these gave."""
    for k in range(count):
        point = world.joints.impact_points[k]
        impulse, point[tb.STRUCK_LEFT] = point[tb.STRUCK_LEFT] + point[tb.STRUCK_STEP], 0.0
        if impulse != 0.0:
            b, m, n = place_of_point(k, world.joints)
            at, row = tb.SHARED + n * tb.POINT_SIZE + m, world.constraints.blocks[b]
            line = (row[tb.R_NX + m], row[tb.R_NY + m])
            if which != TANGENT_RATES:
                point[tb.STRUCK_NORMAL] += impulse
                row[at + tb.P_TOTAL_IMPULSE] += impulse
                if which == REBOUND_RATES:
                    row[at + tb.P_NORMAL_IMPULSE] += impulse
                    row[tb.FIRST_RESTITUTION + n * LANES + m] += impulse
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
        member = max(int(bodies.properties[each, tb.JOINED]), 0)
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
