"""What steps could not hold of joints: found where the engine noted something, each once."""

from collections.abc import Iterable

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.engine import Engine
from tamias2d.generated.joint_rows import MOST_ROWS
from tamias2d.scene.joints import Joint
from tamias2d.simulator.joint_layout import APART, JointLayout

STIFFEST = 2.0**29  # of a spring, times the squared step, over mass or inertia


def too_stiff(
    joints: Iterable[Joint], engine: Engine, time_step: float
) -> tuple[Joint, float] | None:
    """Return a joint whose spring is too stiff for a step, s, and its stiffness; or None.

    Rounding, as many times as a step is long beside its swing, squared, is left of it.
    """
    for joint in joints:
        bodies = list(joint.bodies)
        for each in joint.freedoms:
            turns = each.measure == "angle"
            inverse = (engine.inverse_inertia if turns else engine.inverse_mass)[bodies]
            stiffness = each.spring.stiffness if each.spring else 0.0
            if stiffness * time_step**2 * inverse.max() > STIFFEST:
                return joint, stiffness
    return None


def apart(layout: JointLayout) -> tuple[Joint, float, str] | None:
    """Return a joint that was far apart within the last steps, and by how much; or None.

    It is said, too, why: its mechanism "yields" to what drives it, or is "overloaded", what it
    holds was moved "by hand", or neither.
    """
    counts, numbers = layout.counts, layout.numbers
    if not counts[tb.JOINTS_APART]:
        return None
    counts[tb.JOINTS_APART] = 0
    found = numbers[layout.places, tb.J_APART : tb.J_APART + MOST_ROWS] / layout.per_unit
    numbers[:, tb.J_APART : tb.J_APART + MOST_ROWS] = 0.0
    lengths = np.hypot.reduce(np.where(layout.are_lengths, found, 0.0), axis=1)
    angles = np.hypot.reduce(np.where(layout.are_lengths, 0.0, found), axis=1)
    shares = np.maximum(lengths / layout.sizes, angles)
    worst = int(np.argmax(shares))
    if not shares[worst] > APART:
        return None
    is_length = lengths[worst] / layout.sizes[worst] > angles[worst]
    far = lengths[worst] if is_length else angles[worst]
    first = numbers[layout.first_rows[worst]]
    why = "by hand" if first[tb.J_PULLED] > 0.0 else ""
    if first[tb.J_FIRMEST] > 0.0:
        why = "yields" if first[tb.J_OPENED] > 0.0 else "overloaded"
    return layout.joints[layout.owner[worst]], float(far), why


def turned(layout: JointLayout) -> Joint | None:
    """Return a joint that turned too far in a substep of the last steps; or None."""
    return _worst_lately(layout, tb.JOINTS_TURNED, tb.J_TURNED)


def gained(layout: JointLayout) -> Joint | None:
    """Return the first joint of what got energy, with what touches it, lately; or None."""
    return _worst_lately(layout, tb.JOINTS_GAINED, tb.J_GAINED)


def _worst_lately(layout: JointLayout, count: int, column: int) -> Joint | None:
    """Return the joint with the largest number in a column since it was asked, if any has."""
    counts, numbers = layout.counts, layout.numbers
    if not counts[count]:
        return None
    counts[count] = 0
    worst = int(layout.owner[np.argmax(numbers[layout.places, column])])
    numbers[:, column] = 0.0
    return layout.joints[worst]
