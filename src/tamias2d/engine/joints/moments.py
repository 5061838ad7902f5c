"""What joints give free mechanisms of angular momentum, which should be nothing (DD66, IM17).

A body that counts with more inertia than it has, rows where bodies will be, and the ends of a joint
that is apart all turn a mechanism by a little. It is noted, and goes back as what contacts give.

Cost: where islands are free, a visit to each body of their mechanisms before joints act and after.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.island_damping import place_from
from tamias2d.engine.joints.slowed import slowed_column, slowed_inverses
from tamias2d.engine.tables import Bodies, Islands, Joints, World
from tamias2d.generated.definitions import angular_momentum


def note_before_joints(least: int, most: int, world: World) -> None:
    """Note the angular momenta of free mechanisms of some statuses before joints act."""
    if world.constraints.counts[tb.FREE_ISLANDS] > 0:
        add_angular_momenta(-1.0, least, most, world.bodies, world.islands, world.joints)


def note_after_joints(least: int, most: int, world: World) -> None:
    """Note by how much joints have changed these."""
    if world.constraints.counts[tb.FREE_ISLANDS] > 0:
        add_angular_momenta(1.0, least, most, world.bodies, world.islands, world.joints)


def add_angular_momenta(
    sign: float, least: int, most: int, bodies: Bodies, islands: Islands, joints: Joints
) -> None:
    """Add the angular momenta of free mechanisms, with a sign, to what joints have given them."""
    for n in range(joints.counts[tb.MECHANISMS]):
        i = joints.sparse[joints.sparse[n, tb.I_NODE], tb.N_BODY]
        acts = least <= joints.mechanisms[n, tb.M_STATUS] <= most
        if acts and islands.held[i] == 0:
            whole = sign * angular_momentum_of(n, bodies, joints)
            joints.numbers[joints.mechanisms[n, tb.M_JOINT], tb.J_MOMENT] += whole


def angular_momentum_of(n: int, bodies: Bodies, joints: Joints) -> float:
    """Return the angular momentum of a mechanism about its first body, kg m^2/s."""
    first, last = joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]
    root, whole, column = joints.sparse[first, tb.N_BODY], 0.0, slowed_column(n, joints)
    for node in range(first, last):
        i = joints.sparse[node, tb.N_BODY]
        inverse_mass, inverse_inertia = slowed_inverses(i, column, bodies)
        inertia = 1.0 / inverse_inertia if inverse_inertia > 0.0 else 0.0
        mass, now = 1.0 / inverse_mass, bodies.motion[i]
        velocity = (now[tb.VX], now[tb.VY])
        whole += angular_momentum(
            mass, place_from(root, i, bodies), velocity, inertia, now[tb.SPIN]
        )
    return whole
