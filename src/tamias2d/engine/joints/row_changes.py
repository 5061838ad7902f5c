"""Changing joints where they stand: anchors on the plane, and the laws of their freedoms."""

from functools import cache

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.store import Store
from tamias2d.engine.joints.joint_row import LawNumbers, rubs
from tamias2d.engine.tables import Joints
from tamias2d.generated.constraints import CONSTRAINTS
from tamias2d.generated.symbols import SYMBOLS
from tamias2d.kernels.lanes import LANES
from tamias2d.scene.freedoms import VALUE_OF
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Vector


def move_anchor(store: Store, place: int, kind: str, end: str, point: Vector) -> None:
    """Let a joint hold the plane at another point, m; what was made of the old one is made anew."""
    joints = store.world.joints
    column = 2 * ENDS.index(end)  # an equation of its own is no kind, and has all anchors
    if kind in CONSTRAINTS:
        if f"anchor_{end}" not in CONSTRAINTS[kind].parameters:
            return
        column = parameter_column(kind, f"anchor_{end}")
    joints.given[place, column], joints.given[place, column + 1] = point
    n = mechanism_of(store, place)
    _forget_written(n, joints)
    m = joints.sparse[n, tb.I_NODE] + 1
    if joints.mechanisms[n, tb.M_HINGED] == 0 or joints.members[m, tb.JOINED_HINGE] != place:
        return
    joints.hinges[m, tb.H_FAR_ANCHOR : tb.H_FAR_ANCHOR + 2] = point
    if joints.mechanisms[n, tb.M_IN_BLOCK]:
        block, lane = _lane_of(n, joints)
        row = joints.tree_lanes[joints.tree_blocks[block, tb.T_FIRST] + 1]
        row[tb.T_FAR_ANCHOR_X + lane], row[tb.T_FAR_ANCHOR_Y + lane] = point


def set_law(store: Store, place: int, kind: str, at: float, numbers: LawNumbers) -> None:
    """Let a row of a freedom, of a kind, be measured at another value, m or rad, by its law."""
    joints = store.world.joints
    joints.given[place, parameter_column(kind, VALUE_OF[kind])] = at
    joints.laws[place] = numbers
    n = mechanism_of(store, place)
    own = slice(*joints.mechanisms[n : n + 2, tb.M_JOINT])
    law, mechanism = joints.joints[own, tb.J_LAW], joints.mechanisms[n]
    turned = ((law == tb.MOTOR) & (joints.laws[own, tb.LAW_RATE] != 0.0)).any()
    mechanism[tb.M_TURNED_BY_MOTOR] = turned
    mechanism[tb.M_DRIVEN] = mechanism[tb.M_TIMED] or (law == tb.SPRING).any()
    mechanism[tb.M_FIRM] = not all(map(rubs, law.tolist(), joints.laws[own].tolist()))
    mechanism[tb.M_BOUNCING] = (joints.laws[own, tb.LAW_RESTITUTION] > 0.0).any()
    _forget_written(n, joints)


def _forget_written(n: int, joints: Joints) -> None:
    """Write the rows of a mechanism anew before they are next solved, and its block if any."""
    joints.mechanisms[n, tb.M_WRITTEN] = 0
    if joints.mechanisms[n, tb.M_IN_BLOCK]:
        joints.tree_blocks[_lane_of(n, joints)[0], tb.T_WRITTEN] = 0


def _lane_of(n: int, joints: Joints) -> tuple[int, int]:
    """Return the block of a tree, and its lane there."""
    trees = joints.tree_blocks[:, tb.T_MECHANISM : tb.T_MECHANISM + LANES]
    block, lane = np.argwhere(trees == n)[0].tolist()
    return block, lane


def mechanism_of(store: Store, place: int) -> int:
    """Return the mechanism of a joint."""
    joints = store.world.joints
    starts = joints.mechanisms[: joints.counts[tb.MECHANISMS], tb.M_JOINT]
    return int(np.searchsorted(starts, place, side="right")) - 1


@cache
def parameter_column(kind: str, name: str) -> int:
    """Return where among the numbers that a kind of joint is given a parameter begins."""
    parameters = CONSTRAINTS[kind].parameters
    before = parameters[: parameters.index(name)]
    symbols = [SYMBOLS.get(name) or SYMBOLS[name.rpartition("_")[0]] for name in before]
    return sum(2 if symbol.shape == "vector" else 1 for symbol in symbols)
