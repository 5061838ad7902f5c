"""A net of hinges with many loops: its impulses take the errors of its links away, nearly.

They start from those of the last time (`net_gradients`).
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.linearise import move_members
from tamias2d.engine.joints.net_gradients import (
    clear_net,
    clear_nodes_of_net,
    iterate_net,
    may_be_open,
)
from tamias2d.engine.joints.net_link import (
    add_given,
    arms_of_link,
    change_of_link,
    note_what_is_left,
    parts_link,
    push_link,
    write_link,
)
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.joint_step import row_aim, row_error
from tamias2d.kernels.assembled import inlined

REMOVED_BY_NET = 0.05  # of a gap, in a substep of a whole step: of one not looked at, what is left


def begin_net(n: int, joints: Joints) -> None:
    """Begin a part of a step: note how nodes yield, and the impulses of links to start from.

    How far links may be apart is that of the one that may least, and stands in the first; 0 if none
    is looked at.
    """
    for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
        node = joints.net_nodes[m]
        node[tb.N_INVERSE_MASS] = joints.places[m, tb.SLOWED_INVERSE_MASS]
        node[tb.N_INVERSE_INERTIA] = joints.places[m, tb.HELD_INVERSE_INERTIA]
    least = inf
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        link, numbers = joints.links[j], joints.numbers[j]
        link[tb.L_WARM], link[tb.L_WARM + 1] = numbers[tb.J_WARM], numbers[tb.J_WARM + 1]
        least = min(least, numbers[tb.J_SLIGHT])
    joints.links[joints.mechanisms[n, tb.M_JOINT], tb.L_SLIGHT] = least if least < inf else 0.0


def linearise_net(n: int, bodies: Bodies, joints: Joints) -> None:
    """Write the links of a net where its bodies are."""
    first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
    move_members(first, last, 0.0, bodies, joints)
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        write_link(j, joints)


def bring_net_to_aims(
    n: int, again: bool, length: float, substep: float, bodies: Bodies, joints: Joints
) -> None:
    """Change the velocities of a net so that a substep, s, brings its links nearly to their aims.

    These are parts of the gaps as they were just written; its length is as `aim_joints` says. What
    is left is made up for in the next substep.
    """
    first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
    move_members(first, last, substep, bodies, joints)
    clear_net(n, joints)
    share = 0.5 if joints.mechanisms[n, tb.M_HALF] == 1 else 1.0
    warm, removed = 0.0 if again else share, REMOVED_BY_NET * length
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        link = joints.links[j]
        _, _, gap = arms_of_link(j, joints)
        link[tb.L_ERROR] = row_error(gap[0], row_aim(link[tb.L_GAP], removed), substep)
        link[tb.L_ERROR + 1] = row_error(gap[1], row_aim(link[tb.L_GAP + 1], removed), substep)
        start_link(j, warm, joints)
    solve_net(n, 0.0 if again else 1.0 / share, substep, bodies, joints)


def fit_net(n: int, warm: float, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Take the rates at which its links part from the velocities of a net, nearly.

    The impulses are about so many times those of the last substep, s.
    """
    told = joints.counts[tb.FIRST_KINEMATIC]
    note_motion(
        joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1, bodies, joints
    )
    note_motion(told, len(joints.members), bodies, joints)
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        link = joints.links[j]
        link[tb.L_ERROR], link[tb.L_ERROR + 1] = change_of_link(j, joints)
    clear_net(n, joints)
    clear_nodes_of_net(told, len(joints.members), joints)
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        start_link(j, warm, joints)
    solve_net(n, 0.0, substep, bodies, joints)


def note_motion(first: int, last: int, bodies: Bodies, joints: Joints) -> None:
    """Let the changes of some members be their velocities."""
    for m in range(first, last):
        node, now = joints.net_nodes[m], bodies.motion[joints.members[m, tb.JOINED_SLOT]]
        node[tb.N_CHANGE], node[tb.N_CHANGE + 1] = now[tb.VX], now[tb.VY]
        node[tb.N_CHANGE + 2] = now[tb.SPIN]


@inlined
def start_link(j: int, warm: float, joints: Joints) -> None:
    """Give the bodies of a link so many times its impulse in the last substep, to start from."""
    link = joints.links[j]
    impulse = (warm * link[tb.L_WARM], warm * link[tb.L_WARM + 1])
    link[tb.L_IMPULSE], link[tb.L_IMPULSE + 1] = impulse
    push_link(j, impulse, joints)


def solve_net(n: int, kept: float, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Give a net the impulses that take its errors away, nearly; keep so many times as much.

    It is enough if what is left parts no link by much in a substep, s.
    """
    first, last = joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]
    open_most = may_be_open(first, joints)
    parting = False
    for j in range(first, last):
        note_what_is_left(j, joints)
        parting |= parts_link(joints.links[j], tb.L_RATE, substep, open_most)
    if parting:
        iterate_net(n, substep, joints)
        push_links(n, joints)
    give_to_net(n, kept, bodies, joints)


def push_links(n: int, joints: Joints) -> None:
    """Let the impulses of its links, and nothing else, change the velocities of a net."""
    clear_net(n, joints)
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        push_link(j, (joints.links[j, tb.L_IMPULSE], joints.links[j, tb.L_IMPULSE + 1]), joints)


def give_to_net(n: int, kept: float, bodies: Bodies, joints: Joints) -> None:
    """Give bodies the changes of the nodes of a net, and note the impulses of its links.

    So many times as much is kept for the next substep, if that is anything.
    """
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        link = joints.links[j]
        impulse = (link[tb.L_IMPULSE], link[tb.L_IMPULSE + 1])
        link[tb.L_GIVEN] += impulse[0]
        link[tb.L_GIVEN + 1] += impulse[1]
        if kept > 0.0:
            link[tb.L_WARM], link[tb.L_WARM + 1] = kept * impulse[0], kept * impulse[1]
    for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
        i, node = joints.members[m, tb.JOINED_SLOT], joints.net_nodes[m]
        now, state = bodies.motion[i], bodies.substep_state[i]
        for k in range(3):
            now[tb.VX + k] += node[tb.N_CHANGE + k]
            state[tb.SUBSTEP_START + k] += node[tb.N_CHANGE + k]


def store_links(n: int, joints: Joints) -> None:
    """Store what went through the links of a net in a part, and how far apart they were."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        link, numbers = joints.links[j], joints.numbers[j]
        add_given(link)
        for k in range(2):
            numbers[tb.J_PULL + k] += link[tb.L_PULL + k]
            numbers[tb.J_TOTAL + k] -= link[tb.L_PULL + k]
            numbers[tb.J_TOTAL + 3 + k] += link[tb.L_PULL + k]
            numbers[tb.J_APART + k] = max(numbers[tb.J_APART + k], link[tb.L_APART + k])
            numbers[tb.J_WARM + k] = link[tb.L_WARM + k]
        numbers[tb.J_TOTAL + 2] += link[tb.L_TURN_A]
        numbers[tb.J_TOTAL + 5] += link[tb.L_TURN_B]
        for k in range(tb.L_PULL, tb.L_SLIGHT):
            link[k] = 0.0
