"""Where bodies get to in a step: those without contacts along their closed forms (IM1, IM6).

Serves: a step. Hides: that a body is moved at its end only, once it is known what it meets.
"""

from tamias2d.generated.definitions import (
    acceleration,
    angular_acceleration,
    pace_given,
    pace_later,
    way,
)
from tamias2d.state import Array
from tamias2d.stepped.flight_rooms import goes_far
from tamias2d.stepped.layout import (
    ANGULAR,
    DECAY,
    DX,
    DYNAMIC,
    FLOW,
    FULL,
    GAIN,
    GRAVITY_X,
    GRAVITY_Y,
    INVERSE_INERTIA,
    INVERSE_MASS,
    KINEMATIC,
    LIFT,
    Whole,
)


def drift(
    settings: Array,
    motion: Array,
    load: Array,
    body: Array,
    flows: Array,
    kind: Whole,
    used: Whole,
    gained: Array,
) -> bool:
    """Find how far bodies without contacts go in this step: they have a closed form (IM1, IM6).

    What forces add to their velocities is noted; for all others that is nothing already. Returns
    whether some body goes so far that flight is to look after it.
    """
    far = False
    for i in range(len(kind)):
        if kind[i] >= KINEMATIC and used[i] == 0:
            fall(i, settings, motion, load, body, flows, kind, gained)
        used[i] = 0
        far = far | goes_far(i, kind, motion, body)
    return far


def fall(
    i: int,
    settings: Array,
    motion: Array,
    load: Array,
    body: Array,
    flows: Array,
    kind: Whole,
    gained: Array,
) -> None:
    """Find how far a body goes on which no contact acts."""
    by_x = by_y = turn = 0.0
    if kind[i] == DYNAMIC:
        gravity = (settings[GRAVITY_X], settings[GRAVITY_Y])
        by_x, by_y = acceleration(gravity, (load[i, 0], load[i, 1]), body[i, INVERSE_MASS])
        turn = angular_acceleration(load[i, 2], body[i, INVERSE_INERTIA])
    so = flows[int(body[i, FLOW])]
    flow(i, 0, FULL, by_x, so, motion, gained)
    flow(i, 1, FULL, by_y, so, motion, gained)
    flow(i, 2, FULL + ANGULAR, turn, so, motion, gained)


def flow(i: int, axis: int, at: int, by: float, so: Array, motion: Array, gained: Array) -> None:
    """Take one coordinate of a body through the step, under an acceleration (DD41)."""
    before, gain = motion[i, axis], so[at + GAIN]
    after = pace_later(so[at + DECAY], before, pace_given(gain, by))
    motion[i, DX + axis] = way(gain, so[at + LIFT], before, by)
    motion[i, axis] = after
    gained[i, 3 + axis] = after - before


def arrive(owner: Whole, pose: Array, motion: Array, shown: Array, velocity: Array) -> None:
    """Put all bodies at the ends of their lines, and show users how they are and move."""
    for i in range(len(owner)):
        one = owner[i]
        for n in range(3):
            to = pose[i, n] + motion[i, DX + n]
            pose[i, n], motion[i, DX + n] = to, 0.0
            shown[one, n], velocity[one, n] = to, motion[i, n]
