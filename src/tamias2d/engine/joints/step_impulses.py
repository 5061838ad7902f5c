"""The impulses of joints over a part of a step and over all of it, and what is told of them."""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.governed import is_limit
from tamias2d.engine.joints.linearise import apart_by_law
from tamias2d.engine.joints.placement import UNTIL_BACK
from tamias2d.engine.parts import is_last_part
from tamias2d.engine.tables import Joints, World
from tamias2d.generated.definitions import mean_row_force
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

JUST = 2.0**-7  # of what is told: what comes back from there gets hardly any speed of that
LET_GO = 1e-9  # of the largest impulse of a mechanism: smaller ones were tried and let go


def begin_impulses(n: int, ratio: float, joints: Joints) -> None:
    """Begin to add up the impulses of a part; those of a mesh count for a substep of this one."""
    whole = joints.numbers[joints.mechanisms[n, tb.M_JOINT]]
    whole[tb.J_MOMENT] = whole[tb.J_GAIN] = 0.0
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        for k in range(tb.J_TOTAL, tb.J_GIVEN + 3):
            joints.numbers[j, k] = 0.0
        if ratio != 1.0:
            for k in range(tb.J_WARM, tb.J_WARM + 3):
                joints.numbers[j, k] *= ratio
        joints.numbers[j, tb.J_LEFT] = joints.numbers[j, tb.J_LEFT_BEFORE]


def keep_joint_impulses(world: World) -> None:
    """Add the impulses of a part that was taken to those of the step, and note the forces."""
    joints = world.joints
    known = found_to_tell(joints)
    time = world.control.progress[tb.PART_TIME]
    kept = 0.0 if world.control.counts[tb.TICK] == 0 else 1.0
    substeps = world.control.counts[tb.PART_SUBSTEPS]
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            keep_of_mechanism(n, substeps, joints)
            for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
                keep_of_joint(kept, time, joints.numbers[j], joints)
            if joints.mechanisms[n, tb.M_GOVERNED] != 0:
                add_limit_impulses(n, kept, joints)
                if is_last_part(world.control):
                    note_limit_changes(n, world.control.counts[tb.STEPS_TAKEN] + 1, joints)
    if found_to_tell(joints) > known:
        world.control.counts[tb.LIMITS] += 1


@inlined
def keep_of_mechanism(n: int, substeps: int, joints: Joints) -> None:
    """Keep the energies of a mechanism, which stand in its first joint, and note what it gained."""
    first = joints.numbers[joints.mechanisms[n, tb.M_JOINT]]
    first[tb.J_PULLED] = max(first[tb.J_PULLED] - substeps, 0.0)
    if first[tb.J_PULLED] == UNTIL_BACK and not some_limit_is_passed(n, joints):
        first[tb.J_PULLED] = 0.0
    first[tb.J_RESERVE] = first[tb.J_RESERVE_LATER]
    first[tb.J_MOTION] = first[tb.J_MOTION_LATER]
    first[tb.J_SCALE] = first[tb.J_SCALE_LATER]
    if first[tb.J_GAIN] > 0.0:
        joints.counts[tb.JOINTS_GAINED] = 1
        first[tb.J_GAINED] = 1.0


def some_limit_is_passed(n: int, joints: Joints) -> bool:
    """Return whether a mechanism is beyond some limit, and not only just."""
    passed = False
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        ends, numbers = joints.joints[j], joints.numbers[j]
        if is_limit(ends[tb.J_LAW]):
            passed = passed or apart_by_law(0, ends, numbers) > JUST * numbers[tb.J_SLIGHT]
    return passed


@inlined
def keep_of_joint(kept: float, time: float, numbers: Array, joints: Joints) -> None:
    """Add the impulses of a joint in a part to so much of those before, and note its forces."""
    for k in range(9):
        numbers[tb.J_STEP_TOTAL + k] = kept * numbers[tb.J_STEP_TOTAL + k] + numbers[tb.J_TOTAL + k]
    numbers[tb.J_LEFT_BEFORE] = numbers[tb.J_LEFT]
    for k in range(3):
        numbers[tb.J_FORCE + k] = mean_row_force(numbers[tb.J_PULL + k], time)
        if numbers[tb.J_APART + k] > numbers[tb.J_SLIGHT + k]:
            joints.counts[tb.JOINTS_APART] = 1
    if numbers[tb.J_TURNED] > 0.0:
        joints.counts[tb.JOINTS_TURNED] = 1


def add_limit_impulses(n: int, kept: float, joints: Joints) -> None:
    """Add the impulses of the limits of a mechanism in a part to so much of those before."""
    first, last = joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]
    largest = 0.0
    for j in range(first, last):
        for k in range(tb.J_PULL, tb.J_PULL + 3):
            largest = max(largest, abs(joints.numbers[j, k]))
    for j in range(first, last):
        if is_limit(joints.joints[j, tb.J_LAW]):
            numbers = joints.numbers[j]
            if kept == 0.0:
                numbers[tb.J_PUSHED_BEFORE], numbers[tb.J_PUSHED] = numbers[tb.J_PUSHED], 0.0
            impulse = abs(numbers[tb.J_PULL])
            if impulse > LET_GO * largest:
                numbers[tb.J_PUSHED] += impulse


def note_limit_changes(n: int, step: int, joints: Joints) -> None:
    """Note which limits of a mechanism are struck or left as a step ends, by its number."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if is_limit(joints.joints[j, tb.J_LAW]):
            numbers = joints.numbers[j]
            before, now = numbers[tb.J_PUSHED_BEFORE], numbers[tb.J_PUSHED]
            if now > 0.0 and before == 0.0:
                numbers[tb.J_STRUCK_AT], numbers[tb.J_STRIKE] = step, now
                joints.counts[tb.LIMIT_CHANGES] += 1
            if now == 0.0 and before > 0.0:
                numbers[tb.J_LEFT_AT] = step
                joints.counts[tb.LIMIT_CHANGES] += 1


def found_to_tell(joints: Joints) -> int:
    """Return how many kinds of things were found to tell of joints."""
    counts = joints.counts
    return int(counts[tb.JOINTS_APART] + counts[tb.JOINTS_TURNED] + counts[tb.JOINTS_GAINED])
