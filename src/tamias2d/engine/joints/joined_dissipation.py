"""The bodies of a mechanism lose as one the energy that their island has too much (DD88).

So their joints hold: what is taken is a share of one change, or of one motion.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.support import damp_to_support, energy_from_support, share_left
from tamias2d.engine.joints.acting import acts
from tamias2d.engine.joints.island_bound import root_of_mechanism
from tamias2d.engine.tables import Bodies, Islands, Joints
from tamias2d.generated.island_energy import energy_along_given_left


def reduce_together(islands: Islands, joints: Joints) -> None:
    """Let the bodies of a touched mechanism lose energy as one, so that its joints hold."""
    for n in range(joints.counts[tb.MECHANISMS]):
        row = islands.energy[root_of_mechanism(n, islands, joints)]
        acted = joints.mechanisms[n, tb.M_STATUS] == tb.IN_CONTACT and acts(n, joints)
        if acted and row[tb.ENERGY_SURPLUS] > 0.0:
            sum_changes(
                joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE], islands, joints
            )


def sum_changes(first: int, last: int, islands: Islands, joints: Joints) -> None:
    """Give each of some nodes what all of them got, and its product with their motion."""
    given = product = change = got = 0.0
    for node in range(first, last):
        i = joints.sparse[node, tb.N_BODY]
        given += islands.given[i]
        got += max(islands.given[i], 0.0)
        product += islands.energy[i, tb.GIVEN_PRODUCT]
        change += islands.energy[i, tb.CHANGE_ENERGY]
    for node in range(first, last):
        i = joints.sparse[node, tb.N_BODY]
        islands.given[i] = given
        islands.energy[i, tb.GIVEN_PRODUCT] = product
        islands.energy[i, tb.CHANGE_ENERGY] = change
    root = islands.links[joints.sparse[first, tb.N_BODY], tb.ROOT]
    islands.energy[root, tb.ENERGY_GIVEN_ALL] += max(given, 0.0) - got


def reduce_motion_as_one(bodies: Bodies, islands: Islands, joints: Joints) -> None:
    """Take from all of the motion of mechanisms what their island still has too much."""
    for n in range(joints.counts[tb.MECHANISMS]):
        row = islands.energy[root_of_mechanism(n, islands, joints)]
        first, last = joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]
        given = islands.given[joints.sparse[first, tb.N_BODY]]
        acted = joints.mechanisms[n, tb.M_STATUS] == tb.IN_CONTACT and acts(n, joints)
        if acted and given > 0.0 and row[tb.ENERGY_SURPLUS] > 0.0:
            energy = 0.0
            for node in range(first, last):
                i = joints.sparse[node, tb.N_BODY]
                if bodies.moved[i] == tb.MOVED:
                    energy += energy_from_support(i, bodies, islands)
            left = energy_along_given_left(
                energy, row[tb.ENERGY_SURPLUS], given, row[tb.ENERGY_GIVEN_ALL]
            )
            share = share_left(energy, left)
            for node in range(first, last):
                i = joints.sparse[node, tb.N_BODY]
                if bodies.moved[i] == tb.MOVED:
                    damp_to_support(i, share, bodies, islands)
