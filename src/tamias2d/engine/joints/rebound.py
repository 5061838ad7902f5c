"""Restitution of contacts on mechanisms, whose joints hold while it acts (DD96).

Cost: of each turn of restitution a solution of all mechanisms that contacts touch.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joined import is_held
from tamias2d.engine.joints.acceptance import motion_of_mechanism
from tamias2d.engine.joints.moments import note_after_joints, note_before_joints
from tamias2d.engine.joints.stages import fit_velocities
from tamias2d.engine.solver.lane import Velocities, normal_speed
from tamias2d.engine.tables import Bodies, Constraints, Integers, Joints, World
from tamias2d.generated.island_energy import kinetic_energy_most
from tamias2d.generated.joint_step import (
    lost_share,
    lost_velocity,
    overshot_share,
    row_mass_joined,
)
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array

IN_VAIN = 4.0  # times the energy that there was, by turns of restitution
HELD_FAST = 1.0 - 2.0**-10  # what moves less by an impulse is held


def fit_rebound(over: bool, first: bool, world: World) -> bool:
    """Let the velocities of touched mechanisms fit their rows after a turn of restitution.

    Return whether turns are over: they make energy where joints hold what is to rebound.
    """
    if world.joints.counts[tb.MECHANISMS_TOUCHED] == 0:
        return over
    energy = world.constraints.energy
    note_before_joints(tb.IN_CONTACT, tb.IN_CONTACT, world)
    fit_velocities(tb.IN_CONTACT, world.control.settings[tb.SUBSTEP], world.bodies, world.joints)
    note_after_joints(tb.IN_CONTACT, tb.IN_CONTACT, world)
    motion = motion_of_touched(world.bodies, world.joints)
    if first:
        given = kinetic_energy_most(energy[tb.TOTAL_ENERGY_START], energy[tb.TOTAL_WORK])
        energy[tb.REBOUND_MOST] = IN_VAIN * max(motion, given)
        find_mass_of_one(world.bodies, world.constraints)
    elif energy[tb.REBOUNDING] >= 0.0:
        correct_mass(world.bodies, world.constraints)
    return not motion <= energy[tb.REBOUND_MOST]


def motion_of_touched(bodies: Bodies, joints: Joints) -> float:
    """Return the kinetic energy of all mechanisms that contacts touch, J."""
    motion = 0.0
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] == tb.IN_CONTACT:
            motion += motion_of_mechanism(n, bodies, joints)
    return motion


def find_mass_of_one(bodies: Bodies, constraints: Constraints) -> None:
    """Find how firm the point is that has rebounded on a jointed body, if it is one alone."""
    found, place = 0, 0
    for b in range(constraints.counts[tb.BLOCKS]):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        for m in range(LANES):
            i, j = lane[tb.BODY_A + m], lane[tb.BODY_B + m]
            if is_held(i, bodies) or is_held(j, bodies):
                for n in range(2):
                    if row[tb.FIRST_RESTITUTION + n * LANES + m] > 0.0:
                        found, place = found + 1, 2 * (LANES * b + m) + n
    constraints.energy[tb.REBOUNDING] = -1.0
    if found == 1:
        b, m, n = place // (2 * LANES), place // 2 % LANES, place % 2
        row, mass_at = constraints.blocks[b], tb.SHARED + n * tb.POINT_SIZE + tb.P_NORMAL_MASS + m
        lost = lost_at_point(m, n, constraints.lanes[b], bodies.motion, row)
        mass, impulse = row[mass_at], row[tb.FIRST_RESTITUTION + n * LANES + m]
        share = min(max(lost_share(mass, lost, impulse), 0.0), HELD_FAST)
        row[mass_at] = row_mass_joined(mass, share)
        constraints.energy[tb.REBOUNDING], constraints.energy[tb.REBOUND_LOST] = place, lost


def correct_mass(bodies: Bodies, constraints: Constraints) -> None:
    """Let the one point be less firm where a turn has overshot, and left more than it found."""
    place = int(constraints.energy[tb.REBOUNDING])
    b, m, n = place // (2 * LANES), place // 2 % LANES, place % 2
    row, before = constraints.blocks[b], constraints.energy[tb.REBOUND_LOST]
    lost = lost_at_point(m, n, constraints.lanes[b], bodies.motion, row)
    if abs(lost) > abs(before):
        mass_at = tb.SHARED + n * tb.POINT_SIZE + tb.P_NORMAL_MASS + m
        row[mass_at] = row_mass_joined(row[mass_at], overshot_share(lost, before))
    constraints.energy[tb.REBOUND_LOST] = lost


def lost_at_point(m: int, n: int, lane: Integers, motion: Array, row: Array) -> float:
    """Return what joints have taken of the velocity with which a point rebounded, m/s."""
    at = tb.SHARED + n * tb.POINT_SIZE
    a, b = motion[lane[tb.BODY_A + m]], motion[lane[tb.BODY_B + m]]
    now = Velocities((a[tb.VX], a[tb.VY]), a[tb.SPIN], (b[tb.VX], b[tb.VY]), b[tb.SPIN])
    speed = normal_speed(m, at, now, row)
    return lost_velocity(speed, row[at + tb.P_APPROACH + m], row[tb.R_RESTITUTION + m])
