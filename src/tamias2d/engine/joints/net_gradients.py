"""The impulses of a net's links by conjugate gradients.

They are preconditioned by a sweep through all links and one back, whose work is also the product
with the matrix.

Cost: two visits to each link in an iteration.
Source: Hestenes and Stiefel (1952); Axelsson (1972), the sweeps; Eisenstat (1981), the product.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.iterate import MESH_ACCURACY
from tamias2d.engine.joints.net_link import (
    change_of_link,
    impulse_for,
    parts_link,
    push_link,
    size_of_left,
    weigh_link,
)
from tamias2d.engine.tables import Joints
from tamias2d.kernels.assembled import inlined

MOST_ITERATIONS_OF_NET = 20  # what is left is made up for in later substeps
LEFT_OPEN = 0.05  # of the gap that is looked at, in a substep


def iterate_net(n: int, substep: float, joints: Joints) -> None:
    """Add to the impulses of a net what is left, nearly, beside the size of all its errors."""
    first, last = joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]
    whole = 0.0
    for j in range(first, last):
        whole += weigh_link(j, joints)
    clear_net(n, joints)
    size, before = sweep_from_left(first, last, joints), 0.0
    for _ in range(MOST_ITERATIONS_OF_NET):
        solved = not size > MESH_ACCURACY * MESH_ACCURACY * whole
        if solved or not parts_links(first, last, substep, joints):
            return
        clear_net(n, joints)
        sweep_back(first, last, size / before if before > 0.0 else 0.0, joints)
        clear_net(n, joints)
        curvature = sweep_on(first, last, joints)
        before, size = size, go_along(first, last, size, curvature, joints)


@inlined
def may_be_open(first: int, joints: Joints) -> float:
    """Return by how much more the links of a net, from the first, may be apart in a substep, m."""
    return float(LEFT_OPEN * joints.links[first, tb.L_SLIGHT])


def parts_links(first: int, last: int, substep: float, joints: Joints) -> bool:
    """Return whether what is left of their errors parts links by much in a substep, s."""
    open_most = may_be_open(first, joints)
    parting = False
    for j in range(first, last):
        parting |= parts_link(joints.links[j], tb.L_MADE, substep, open_most)
    return parting


def clear_net(n: int, joints: Joints) -> None:
    """Write zeros to the changes of the nodes of a net."""
    clear_nodes_of_net(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1, joints)


def clear_nodes_of_net(first: int, last: int, joints: Joints) -> None:
    """Write zeros to the changes of some members."""
    for m in range(first, last):
        node = joints.net_nodes[m]
        node[tb.N_CHANGE] = node[tb.N_CHANGE + 1] = node[tb.N_CHANGE + 2] = 0.0


def sweep_from_left(first: int, last: int, joints: Joints) -> float:
    """Sweep through the links with the rates that they are yet to get; return the size, J."""
    size = 0.0
    for j in range(first, last):
        link = joints.links[j]
        by = change_of_link(j, joints)
        left = impulse_for(link, (link[tb.L_RATE] - by[0], link[tb.L_RATE + 1] - by[1]))
        push_link(j, left, joints)
        link[tb.L_LEFT], link[tb.L_LEFT + 1] = left
        link[tb.L_SEARCH] = link[tb.L_SEARCH + 1] = 0.0
        size += size_of_left(link, left)
    return size


def sweep_back(first: int, last: int, kept: float, joints: Joints) -> None:
    """Turn the direction to what is left, keep a share of the last one, and sweep back with it."""
    for back in range(last - first):
        j = last - 1 - back
        link = joints.links[j]
        search = (
            link[tb.L_MADE] + kept * link[tb.L_SEARCH],
            link[tb.L_MADE + 1] + kept * link[tb.L_SEARCH + 1],
        )
        link[tb.L_SEARCH], link[tb.L_SEARCH + 1] = search
        by = change_of_link(j, joints)
        tried = impulse_for(link, (search[0] - by[0], search[1] - by[1]))
        push_link(j, tried, joints)
        link[tb.L_TRIED], link[tb.L_TRIED + 1] = tried
        link[tb.L_RATE], link[tb.L_RATE + 1] = by


def sweep_on(first: int, last: int, joints: Joints) -> float:
    """Sweep through the links with what those after them do; return the curvature, J."""
    curvature = 0.0
    for j in range(first, last):
        link = joints.links[j]
        by = change_of_link(j, joints)
        more = impulse_for(link, (link[tb.L_RATE] - by[0], link[tb.L_RATE + 1] - by[1]))
        push_link(j, more, joints)
        made = (link[tb.L_TRIED] + more[0], link[tb.L_TRIED + 1] + more[1])
        link[tb.L_MADE], link[tb.L_MADE + 1] = made
        curvature += link[tb.L_SEARCH] * made[0] + link[tb.L_SEARCH + 1] * made[1]
    return curvature


def go_along(first: int, last: int, size: float, curvature: float, joints: Joints) -> float:
    """Take a step of conjugate gradients; return the size of what is left, J."""
    share = size / curvature if curvature > 0.0 else 0.0
    new = 0.0
    for j in range(first, last):
        link = joints.links[j]
        link[tb.L_IMPULSE] += share * link[tb.L_TRIED]
        link[tb.L_IMPULSE + 1] += share * link[tb.L_TRIED + 1]
        left = (
            link[tb.L_LEFT] - share * link[tb.L_MADE],
            link[tb.L_LEFT + 1] - share * link[tb.L_MADE + 1],
        )
        link[tb.L_LEFT], link[tb.L_LEFT + 1] = left
        new += size_of_left(link, left)
    return new
