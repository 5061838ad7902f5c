"""Restitution of contacts on mechanisms, whose joints hold while it acts (DD96).

Cost: of each turn of restitution a solution of all mechanisms that contacts touch.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.moments import note_after_joints, note_before_joints
from tamias2d.engine.joints.stages import fit_velocities
from tamias2d.engine.solver.lane import Velocities, normal_speed
from tamias2d.engine.tables import Bodies, Constraints, Integers, World
from tamias2d.generated.joint_step import lost_share, lost_velocity, row_mass_joined
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array

HELD_FAST = 1.0 - 2.0**-10  # what moves less by an impulse is held


def fit_rebound(first: bool, world: World) -> None:
    """Let the velocities of touched mechanisms fit their rows after a turn of restitution."""
    if world.joints.counts[tb.MECHANISMS_TOUCHED] == 0:
        return
    note_before_joints(tb.IN_CONTACT, tb.IN_CONTACT, world)
    fit_velocities(tb.IN_CONTACT, world.control.settings[tb.SUBSTEP], world.bodies, world.joints)
    note_after_joints(tb.IN_CONTACT, tb.IN_CONTACT, world)
    if first:
        find_mass_of_one(world.bodies, world.constraints)


def find_mass_of_one(bodies: Bodies, constraints: Constraints) -> None:
    """Find how firm the point is that has rebounded on a jointed body, if it is one alone."""
    found, block, lane_of_one, point = 0, 0, 0, 0
    for b in range(constraints.counts[tb.BLOCKS]):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        for m in range(LANES):
            i, j = lane[tb.BODY_A + m], lane[tb.BODY_B + m]
            if bodies.properties[i, tb.JOINED] + bodies.properties[j, tb.JOINED] > 0.0:
                for n in range(2):
                    if row[tb.FIRST_RESTITUTION + n * LANES + m] > 0.0:
                        found, block, lane_of_one, point = found + 1, b, m, n
    if found == 1:
        row, lane = constraints.blocks[block], constraints.lanes[block]
        find_mass(lane_of_one, point, lane, bodies.motion, row)


def find_mass(m: int, n: int, lane: Integers, motion: Array, row: Array) -> None:
    """Find how firm a point of a contact is that has rebounded."""
    at = tb.SHARED + n * tb.POINT_SIZE
    a, b = motion[lane[tb.BODY_A + m]], motion[lane[tb.BODY_B + m]]
    now = Velocities((a[tb.VX], a[tb.VY]), a[tb.SPIN], (b[tb.VX], b[tb.VY]), b[tb.SPIN])
    lost = lost_velocity(
        normal_speed(m, at, now, row), row[at + tb.P_APPROACH + m], row[tb.R_RESTITUTION + m]
    )
    mass, impulse = row[at + tb.P_NORMAL_MASS + m], row[tb.FIRST_RESTITUTION + n * LANES + m]
    share = min(max(lost_share(mass, lost, impulse), 0.0), HELD_FAST)
    row[at + tb.P_NORMAL_MASS + m] = row_mass_joined(mass, share)
