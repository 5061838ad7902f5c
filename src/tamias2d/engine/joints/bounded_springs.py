"""Springs that exert no more than a maximum (DD105): softer ones, of which none gives more.

Of each it is found how soft it is; the mechanism is solved, and what it gives looked at again.
Cost: for each time that one is made softer, a factorization, as for a choice.
Source: More and Sorensen (1983), who find the size of a step likewise.
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.impulse import apply_joint_impulse
from tamias2d.engine.joints.solve import rate_of_row
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.definitions import (
    bounded_spring_energy,
    force_share,
    joint_pull,
    joint_spring_force,
)
from tamias2d.generated.joint_step import (
    impulse_room,
    row_energy,
    row_impulse_most,
    whole_impulse,
)
from tamias2d.kernels.assembled import inlined

SLIGHTLY_BEYOND = 1e-9  # of its maximum: as near to it as a spring has to come
LEAST_RATIO = 1e-100  # of what a spring gives to its maximum, so that its reciprocal is finite


@inlined
def is_bounded(j: int, joints: Joints) -> bool:
    """Return whether a row is that of a spring with a maximum, the first one if it has two."""
    sprung = (joints.joints[j, tb.J_LAW] == tb.SPRING) & (joints.laws[j, tb.LAW_MOST] < inf)
    return bool(sprung & (joints.joints[j, tb.J_PAIR] != tb.OF_PAIR))


def begin_bounded(n: int, again: bool, bodies: Bodies, joints: Joints) -> None:
    """Let the springs of a mechanism be as soft as they are where a substep begins.

    Again, they are as soft as they were made in it.
    """
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if is_bounded(j, joints):
            joints.numbers[j, tb.J_SOFTNESS] = 0.0
            if not again:
                other = joints.joints[j, tb.J_PAIR]
                pull, across = pull_of_row(j, rate_of_row(j, 0, bodies, joints), joints), 0.0
                if other >= 0:
                    across = pull_of_row(other, rate_of_row(other, 0, bodies, joints), joints)
                size = joint_pull(pull, across)
                let_exert(j, force_share(joints.laws[j, tb.LAW_MOST], size), joints)


@inlined
def pull_of_row(j: int, rate: float, joints: Joints) -> float:
    """Return what the spring of a row would exert by itself at its value and a rate, N or N m."""
    stiffness, damping = joints.laws[j, tb.LAW_STIFFNESS], joints.laws[j, tb.LAW_DAMPING]
    return joint_spring_force(stiffness, joints.numbers[j, tb.J_ROW], damping, rate)


@inlined
def let_exert(j: int, share: float, joints: Joints) -> None:
    """Let a spring, with its other row, exert a share of what it would."""
    joints.numbers[j, tb.J_EXERTED] = share
    if joints.joints[j, tb.J_PAIR] >= 0:
        joints.numbers[joints.joints[j, tb.J_PAIR], tb.J_EXERTED] = share


def soften_springs(n: int, substep: float, joints: Joints) -> bool:
    """Make the springs softer that give more than they can in a substep, s; return if any changed.

    Those that give less are made stiffer, up to what they are by themselves. In a mesh, which is
    solved once only, they stay as they are.
    """
    changed = False
    if joints.mechanisms[n, tb.M_MESHED] == 1:
        return changed
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if is_bounded(j, joints):
            share, ratio = joints.numbers[j, tb.J_EXERTED], ratio_given(n, j, substep, joints)
            less = share < 1.0 and ratio < 1.0 - SLIGHTLY_BEYOND
            if ratio > 1.0 + SLIGHTLY_BEYOND or less:
                let_exert(j, 1.0 / softness_tried_next(j, ratio, joints), joints)
                changed = changed or joints.numbers[j, tb.J_EXERTED] != share
    return changed


def softness_tried_next(j: int, ratio: float, joints: Joints) -> float:
    """Return how soft to make a spring that has given so many times its maximum.

    The reciprocal of that is linear in it for a row by itself. By the first solution, or where the
    last two tell nothing, it is softer in that ratio, which is never too much.
    """
    numbers = joints.numbers[j]
    softness, spare = 1.0 / numbers[tb.J_EXERTED], 1.0 / max(ratio, LEAST_RATIO)
    found = softness * ratio
    way, gain = softness - numbers[tb.J_SOFTNESS], spare - numbers[tb.J_SPARE]
    if numbers[tb.J_SOFTNESS] > 0.0 and way * gain > 0.0:
        by_line = softness + (1.0 - spare) * (way / gain)
        found = max(found, by_line) if ratio > 1.0 else min(found, by_line)
    numbers[tb.J_SOFTNESS], numbers[tb.J_SPARE] = softness, spare
    return max(found, 1.0)


def ratio_given(n: int, j: int, substep: float, joints: Joints) -> float:
    """Return how many times its maximum a spring of a mechanism has given in a substep, s.

    Where contacts touch that, what was left to give counts with what is given, and in the first
    substep after they did, too.
    """
    numbers, other = joints.numbers[j], joints.joints[j, tb.J_PAIR]
    given, left, share = numbers[tb.J_GIVEN], numbers[tb.J_LEFT], numbers[tb.J_SHARE]
    across = across_left = 0.0
    across_share = share
    if other >= 0:
        across, across_left = joints.numbers[other, tb.J_GIVEN], joints.numbers[other, tb.J_LEFT]
        across_share = joints.numbers[other, tb.J_SHARE]
    whole = joint_pull(whole_impulse(given, share), whole_impulse(across, across_share))
    most = row_impulse_most(joints.laws[j, tb.LAW_MOST], substep)
    room = impulse_room(most, joint_pull(left, across_left))
    if joints.mechanisms[n, tb.M_HALF] == 1:
        return whole / room
    if joints.mechanisms[n, tb.M_STATUS] == tb.IN_CONTACT:
        return max(whole / most, joint_pull(given, across) / room)
    return whole / most


def bound_springs(n: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Let springs that would exert more give their maximum in a substep, s, to the last bit.

    What is taken back is next to nothing, but where more was to be chosen than is tried.
    """
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if is_bounded(j, joints):
            ratio, other = ratio_given(n, j, substep, joints), joints.joints[j, tb.J_PAIR]
            soft = joints.numbers[j, tb.J_EXERTED] < 1.0
            if ratio > 1.0 or (soft and ratio >= 1.0 - SLIGHTLY_BEYOND):
                back = 1.0 / ratio - 1.0
                apply_joint_impulse(j, 0, back * joints.numbers[j, tb.J_GIVEN], bodies, joints)
                if other >= 0:
                    given = joints.numbers[other, tb.J_GIVEN]
                    apply_joint_impulse(other, 0, back * given, bodies, joints)


def energy_of_spring(j: int, joints: Joints) -> float:
    """Return the energy of the spring of a row, J, at the value that this has.

    That of the second row of a target is counted with the first.
    """
    stiffness, most = joints.laws[j, tb.LAW_STIFFNESS], joints.laws[j, tb.LAW_MOST]
    other = joints.joints[j, tb.J_PAIR]
    if other == tb.OF_PAIR:
        return 0.0
    energy = row_energy(stiffness, joints.numbers[j, tb.J_ROW])
    if most == inf:
        return energy
    pull, across = pull_of_row(j, 0.0, joints), 0.0
    if other >= 0:
        across = pull_of_row(other, 0.0, joints)
        energy += row_energy(stiffness, joints.numbers[other, tb.J_ROW])
    return bounded_spring_energy(force_share(most, joint_pull(pull, across)), energy)
