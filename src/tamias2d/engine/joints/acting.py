"""Which mechanisms act in a part of a step: slack ropes, and limits that are not reached, do not.

A mechanism that gives no impulse ties nothing: its bodies get and lose energy as any others do.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.support import energy_from_support
from tamias2d.engine.tables import Bodies, Constraints, Islands, Joints, Touching
from tamias2d.generated.island_energy import lift_beyond_motion
from tamias2d.kernels.assembled import inlined


def acts(n: int, joints: Joints) -> bool:
    """Return whether some joint of a mechanism has given an impulse in this part."""
    if joints.mechanisms[n, tb.M_HINGED] == 1:
        return True
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        for k in range(tb.J_TOTAL, tb.J_TOTAL + 9):
            if joints.numbers[j, k] != 0.0:
                return True
    return False


def note_tied(
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
    joints: Joints,
) -> None:
    """Note which bodies joints have pushed in this part: nothing that they have is their own.

    Note also what contacts have lifted the others beyond what these had.
    """
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP and acts(n, joints):
            for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
                i = joints.sparse[node, tb.N_BODY]
                islands.energy[i, tb.TIED], islands.energy[i, tb.ENERGY_OWN] = 1.0, 0.0
                islands.energy[islands.links[i, tb.ROOT], tb.ACTING] = 1.0
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == tb.DYNAMIC and islands.energy[i, tb.TIED] == 0.0:
            islands.energy[islands.links[i, tb.ROOT], tb.LIFT_BEYOND_MOTION] += lift_beyond_motion(
                islands.given[i], energy_from_support(i, bodies, islands)
            )


@inlined
def unless_tied(found: bool, i: int, islands: Islands) -> bool:
    """Return whether something was found of a body that no joint has pushed."""
    return bool(found & (islands.energy[i, tb.TIED] == 0.0))
