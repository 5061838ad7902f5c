"""The few contacts of a block, one by one: the bits of all lanes, without those that hold none."""

from tamias2d.engine import tables as tb
from tamias2d.engine.solver.lane import (
    Velocities,
    relaxed,
    soften,
    warm_started,
)
from tamias2d.engine.tables import Integers
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array


@inlined
def load_pair(m: int, lane: Integers, motion: Array, scratch: Array) -> Velocities:
    """Load how far both bodies of a lane have gone in the step; return their velocities."""
    a, b = motion[lane[tb.BODY_A + m]], motion[lane[tb.BODY_B + m]]
    scratch[tb.B_DX_A + m], scratch[tb.B_DY_A + m] = a[tb.DX], a[tb.DY]
    scratch[tb.B_DX_B + m], scratch[tb.B_DY_B + m] = b[tb.DX], b[tb.DY]
    scratch[tb.B_ANGLE_A + m], scratch[tb.B_ANGLE_B + m] = a[tb.DANGLE], b[tb.DANGLE]
    return Velocities((a[tb.VX], a[tb.VY]), a[tb.SPIN], (b[tb.VX], b[tb.VY]), b[tb.SPIN])


@inlined
def store_pair(m: int, now: Velocities, lane: Integers, motion: Array) -> None:
    """Store the velocities of both bodies of a lane."""
    a, b = motion[lane[tb.BODY_A + m]], motion[lane[tb.BODY_B + m]]
    a[tb.VX], a[tb.VY] = now.a
    b[tb.VX], b[tb.VY] = now.b
    a[tb.SPIN], b[tb.SPIN] = now.spin_a, now.spin_b


def warm_start_few(lane: Integers, motion: Array, row: Array, scratch: Array) -> None:
    """Apply the impulses of the last substep to the few contacts of a block again."""
    for m in range(lane[tb.FILLED]):
        now = load_pair(m, lane, motion, scratch)
        now = warm_started(m, tb.FIRST_POINT, now, row)
        if lane[tb.POINTS] == 2:
            now = warm_started(m, tb.SECOND_POINT, now, row)
        store_pair(m, now, lane, motion)


def soften_few(lane: Integers, motion: Array, row: Array, scratch: Array, substep: float) -> None:
    """Correct the impulses of the few contacts of a block; the substep in s."""
    for m in range(lane[tb.FILLED]):
        now = load_pair(m, lane, motion, scratch)
        now = soften(m, lane[tb.POINTS], now, row, scratch, substep)
        store_pair(m, now, lane, motion)


def relax_few(
    lane: Integers, motion: Array, row: Array, scratch: Array, substep: float, share: float
) -> None:
    """Relax the few contacts of a block."""
    for m in range(lane[tb.FILLED]):
        now = load_pair(m, lane, motion, scratch)
        now = relaxed(m, lane[tb.POINTS], now, row, substep, share)
        store_pair(m, now, lane, motion)
