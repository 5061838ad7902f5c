"""What a stage does to one mechanism, by the solver of its kind.

That is a tree of hinges, a net of hinges, or any other system of rows.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.choices import MOST_CHOICES, keep_positions
from tamias2d.engine.joints.governed import let_go_of_rows, time_at_end
from tamias2d.engine.joints.hinge_laws import keep_tree_positions
from tamias2d.engine.joints.hinge_net import bring_net_to_aims, fit_net, linearise_net, store_links
from tamias2d.engine.joints.hinge_solve import aim_tree, fit_tree
from tamias2d.engine.joints.hinge_tree import hang_tree, linearise_tree, store_hinge_impulses
from tamias2d.engine.joints.linearise import factor_mechanism, linearise
from tamias2d.engine.joints.solve import (
    aim_joints,
    keep_velocities,
)
from tamias2d.engine.tables import Bodies, Joints


def write_mechanism(n: int, bodies: Bodies, joints: Joints) -> None:
    """Write the rows of a mechanism where its bodies are, and its matrix."""
    hinged, meshed = joints.mechanisms[n, tb.M_HINGED] == 1, joints.mechanisms[n, tb.M_MESHED] == 1
    if hinged and meshed:
        linearise_net(n, bodies, joints)
    elif hinged:
        linearise_tree(n, bodies, joints)
    else:
        linearise(n, bodies, joints)


def aim_mechanism(n: int, length: float, substep: float, joints: Joints) -> None:
    """Note to which values a substep brings the rows of a mechanism, as `aim_joints` does.

    A net needs no note.
    """
    hinged, meshed = joints.mechanisms[n, tb.M_HINGED] == 1, joints.mechanisms[n, tb.M_MESHED] == 1
    if hinged and not meshed:
        aim_tree(n, length, substep, joints)
    elif not hinged:
        aim_joints(n, length, substep, joints)


def bring_to_end(
    n: int, again: bool, length: float, substep: float, bodies: Bodies, joints: Joints
) -> None:
    """Change the velocities of a mechanism so that a substep leads to what its rows aim at."""
    hinged, meshed = joints.mechanisms[n, tb.M_HINGED] == 1, joints.mechanisms[n, tb.M_MESHED] == 1
    if hinged and meshed:
        bring_net_to_aims(n, again, length, substep, bodies, joints)
    elif hinged:
        keep_tree_positions(n, again, substep, bodies, joints)
    else:
        keep_positions(n, again, substep, bodies, joints)


def fit(n: int, warm: float, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Take the rates of its rows from the velocities of a mechanism; `warm` is for meshes.

    Limits push only, and motors give no more than they can. What is left in a net parts it little
    in a substep, s. Springs do not count.
    """
    take_rates(n, warm, substep, bodies, joints)
    for _ in range(MOST_CHOICES if joints.mechanisms[n, tb.M_CHOOSING] == 1 else 0):
        if not let_go_of_rows(n, time_at_end(n, substep, joints), bodies, joints):
            return
        take_rates(n, warm, substep, bodies, joints)


def take_rates(n: int, warm: float, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Take the rates of the rows that hold from the velocities of a mechanism."""
    hinged, meshed = joints.mechanisms[n, tb.M_HINGED] == 1, joints.mechanisms[n, tb.M_MESHED] == 1
    governed = joints.mechanisms[n, tb.M_GOVERNED] == 1
    if hinged and meshed:
        fit_net(n, warm, substep, bodies, joints)
    elif hinged:
        if governed:
            hang_tree(n, 0.0, joints)
        fit_tree(n, substep, bodies, joints)
    else:
        if governed:
            factor_mechanism(n, 0.0, joints)
        keep_velocities(n, warm, substep, bodies, joints)


def store_mechanism(n: int, joints: Joints) -> None:
    """Store what went through the hinges of a mechanism in a part; other rows need no storing."""
    hinged, meshed = joints.mechanisms[n, tb.M_HINGED] == 1, joints.mechanisms[n, tb.M_MESHED] == 1
    if hinged and meshed:
        store_links(n, joints)
    elif hinged:
        store_hinge_impulses(n, joints)
