"""What mechanisms with springs may gain yet while contacts touch them (DD79).

Of an island it is what it has less than it may have as a part ends: a scheme of order two goes to
and fro about the right energy, in contact, too. Cost: where contacts touch such mechanisms, a visit
to each body of all islands.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.support import FREE, energy_from_support
from tamias2d.engine.joints.energy import energies_of_part, note_balance, see_from_support
from tamias2d.engine.joints.island_bound import energy_of_springs, root_of_mechanism
from tamias2d.engine.tables import Bodies, Constraints, Control, Islands, Joints, Touching
from tamias2d.generated.island_energy import kinetic_energy_most


def note_reserves(
    control: Control,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
    joints: Joints,
) -> None:
    """Note what each mechanism with springs that contacts touch may gain of what its island lost.

    Where an island has several of these, those that come first take what there is.
    """
    if not some_touched_with_springs(joints):
        return
    for n in range(islands.counts[tb.ROOTS]):
        row = islands.energy[islands.roots[n]]
        row[tb.ENERGY_AFTER] = 0.0
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == tb.DYNAMIC:
            row = islands.energy[islands.links[i, tb.ROOT]]
            row[tb.ENERGY_AFTER] += energy_from_support(i, bodies, islands)
    for n in range(islands.counts[tb.ROOTS]):
        row = islands.energy[islands.roots[n]]
        most = kinetic_energy_most(row[tb.ENERGY_START], row[tb.WORK])
        damped = row[tb.SUPPORT] == FREE and row[tb.DAMPED_SHARE] != 1.0  # seen from another motion
        row[tb.ENERGY_SURPLUS] = 0.0 if damped else row[tb.ENERGY_AFTER] - most
    for n in range(joints.counts[tb.MECHANISMS]):
        if is_touched_with_springs(n, joints):
            note_reserve(n, control, bodies, islands, joints)


def some_touched_with_springs(joints: Joints) -> bool:
    """Return whether contacts touch a mechanism with springs."""
    found = False
    for n in range(joints.counts[tb.MECHANISMS]):
        found = found or is_touched_with_springs(n, joints)
    return found


def is_touched_with_springs(n: int, joints: Joints) -> bool:
    """Return whether a mechanism has springs, or changes with time, and contacts touch it."""
    touched = joints.mechanisms[n, tb.M_STATUS] == tb.IN_CONTACT
    return bool(touched and joints.mechanisms[n, tb.M_DRIVEN] == 1)


def note_reserve(
    n: int, control: Control, bodies: Bodies, islands: Islands, joints: Joints
) -> None:
    """Note what a mechanism may gain of what its island has less than it may have."""
    island = islands.energy[root_of_mechanism(n, islands, joints)]
    missing = -island[tb.ENERGY_SURPLUS]
    first, last = joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]
    see_from_support(n, bodies, joints, islands)
    row = islands.energy[joints.sparse[first, tb.N_BODY]]
    base = (row[tb.REFERENCE], row[tb.REFERENCE + 1])
    start, _, now = energies_of_part(first, last, base, control, bodies, joints)
    numbers = joints.numbers[joints.mechanisms[n, tb.M_JOINT]]
    note_balance(n, start, now, energy_of_springs(n, joints), now + missing, joints)
    island[tb.ENERGY_SURPLUS] += numbers[tb.J_RESERVE_LATER]
