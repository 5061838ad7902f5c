"""The soft step through blocks: warm start, solve, relax and restitution, lane by lane.

Each loop goes over a fixed number of lanes, over two arrays, so that compiled code takes several
lanes in one instruction; a block of few contacts is left to `few_lanes`. Cost: a visit to two
bodies for each lane, and loop. Source: Catto (2024), soft step.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.solver.few_lanes import relax_few, soften_few, warm_start_few
from tamias2d.engine.solver.lane import (
    after_bounced_friction,
    after_restitution,
    relaxed,
    set_velocities,
    soften,
    velocities_of,
    warm_started,
)
from tamias2d.engine.tables import Bodies, Constraints, Integers
from tamias2d.kernels.lanes import LANES, both_above, load_half, load_rows, store_half
from tamias2d.state import Array

FEW_LANES = 2  # lanes that hold a contact, for which those of a block cost more than one by one


def load_velocities(lane: Integers, motion: Array, scratch: Array) -> None:
    """Load the velocities of the bodies of a block into the scratch array."""
    load_half(lane, tb.BODY_A, motion, scratch, tb.B_VX_A)
    load_half(lane, tb.BODY_B, motion, scratch, tb.B_VX_B)


def load_motions(lane: Integers, motion: Array, scratch: Array) -> None:
    """Load the velocities of the bodies of a block, and their displacements in the step."""
    load_rows(lane, tb.BODY_A, motion, scratch, tb.B_VX_A)
    load_rows(lane, tb.BODY_B, motion, scratch, tb.B_VX_B)


def store_velocities(lane: Integers, motion: Array, scratch: Array) -> None:
    """Store the velocities of the bodies of a block."""
    store_half(lane, tb.BODY_A, motion, scratch, tb.B_VX_A)
    store_half(lane, tb.BODY_B, motion, scratch, tb.B_VX_B)


# -- the lanes of a block


def warm_start_lanes(at: int, row: Array, scratch: Array) -> None:
    """Apply the impulses of the last substep again."""
    for m in range(LANES):
        now = velocities_of(m, scratch)
        now = warm_started(m, at, now, row)
        set_velocities(m, now, scratch)


def soft_lanes(row: Array, scratch: Array, substep: float) -> None:
    """Correct the impulses of contacts with one point; the substep in s."""
    for m in range(LANES):
        now = velocities_of(m, scratch)
        now = soften(m, 1, now, row, scratch, substep)
        set_velocities(m, now, scratch)


def soft_lanes_of_two(row: Array, scratch: Array, substep: float) -> None:
    """Correct the impulses of contacts with two points; the substep in s."""
    for m in range(LANES):
        now = velocities_of(m, scratch)
        now = soften(m, 2, now, row, scratch, substep)
        set_velocities(m, now, scratch)


def relax_lanes(row: Array, scratch: Array, substep: float, share: float) -> None:
    """Relax contacts with one point; the substep in s."""
    for m in range(LANES):
        now = velocities_of(m, scratch)
        now = relaxed(m, 1, now, row, substep, share)
        set_velocities(m, now, scratch)


def relax_lanes_of_two(row: Array, scratch: Array, substep: float, share: float) -> None:
    """Relax contacts with two points; the substep in s."""
    for m in range(LANES):
        now = velocities_of(m, scratch)
        now = relaxed(m, 2, now, row, substep, share)
        set_velocities(m, now, scratch)


def restitution_lanes(at: int, bounce: int, row: Array, scratch: Array) -> None:
    """Apply restitution to the points of contacts."""
    for m in range(LANES):
        now = velocities_of(m, scratch)
        now = after_restitution(m, at, bounce, now, row, scratch)
        set_velocities(m, now, scratch)


def bounced_friction_lanes(at: int, bounce: int, row: Array, scratch: Array) -> None:
    """Correct the tangent impulses of points that have bounced."""
    for m in range(LANES):
        now = velocities_of(m, scratch)
        now = after_bounced_friction(m, at, bounce, now, row)
        set_velocities(m, now, scratch)


def apply_bounced_friction(lane: Integers, row: Array, scratch: Array) -> None:
    """Apply friction to points that have bounced, if any has."""
    two = lane[tb.POINTS] == 2
    if some_bounced(tb.FIRST_POINT, tb.FIRST_RESTITUTION, row) or (
        two and some_bounced(tb.SECOND_POINT, tb.SECOND_RESTITUTION, row)
    ):
        bounced_friction_lanes(tb.FIRST_POINT, tb.FIRST_RESTITUTION, row, scratch)
        if two:
            bounced_friction_lanes(tb.SECOND_POINT, tb.SECOND_RESTITUTION, row, scratch)


def some_bounced(at: int, bounce: int, row: Array) -> bool:
    """Return whether a lane with a normal impulse has bounced."""
    return both_above(row, bounce, 0.0, at + tb.P_NORMAL_IMPULSE, 0.0)


def some_above(row: Array, column: int) -> bool:
    """Return whether a lane has a positive number in a column."""
    return both_above(row, column, 0.0, column, 0.0)


# -- all blocks


def warm_start(first: int, last: int, bodies: Bodies, constraints: Constraints) -> None:
    """Apply the impulses of the last substep to the bodies of some blocks."""
    motion, scratch = bodies.motion, constraints.scratch
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        if lane[tb.FILLED] <= FEW_LANES:
            warm_start_few(lane, motion, row, scratch)
            continue
        load_velocities(lane, motion, scratch)
        warm_start_lanes(tb.FIRST_POINT, row, scratch)
        if lane[tb.POINTS] == 2:
            warm_start_lanes(tb.SECOND_POINT, row, scratch)
        store_velocities(lane, motion, scratch)


def solve_soft(
    first: int, last: int, bodies: Bodies, constraints: Constraints, substep: float
) -> None:
    """Solve soft constraints once."""
    motion, scratch = bodies.motion, constraints.scratch
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        if lane[tb.FILLED] <= FEW_LANES:
            soften_few(lane, motion, row, scratch, substep)
            continue
        load_motions(lane, motion, scratch)
        if lane[tb.POINTS] == 2:
            soft_lanes_of_two(row, scratch, substep)
        else:
            soft_lanes(row, scratch, substep)
        store_velocities(lane, motion, scratch)


def relax(
    first: int,
    last: int,
    bodies: Bodies,
    constraints: Constraints,
    substep: float,
    counted: bool,
) -> None:
    """Relax constraints once, so that no softness is left in the velocities.

    The impulses of the last time in a substep are counted.
    """
    motion, scratch, share = bodies.motion, constraints.scratch, 1.0 if counted else 0.0
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        if lane[tb.FILLED] <= FEW_LANES:
            relax_few(lane, motion, row, scratch, substep, share)
            continue
        load_velocities(lane, motion, scratch)
        if lane[tb.POINTS] == 2:
            relax_lanes_of_two(row, scratch, substep, share)
        else:
            relax_lanes(row, scratch, substep, share)
        store_velocities(lane, motion, scratch)


def clear_restitution(constraints: Constraints) -> None:
    """Let restitution have given no impulse yet."""
    for b in range(constraints.counts[tb.BLOCKS]):
        for m in range(LANES):
            constraints.blocks[b, tb.FIRST_RESTITUTION + m] = 0.0
            constraints.blocks[b, tb.SECOND_RESTITUTION + m] = 0.0
            constraints.blocks[b, tb.FIRST_REBOUND_DRAG + m] = 0.0
            constraints.blocks[b, tb.SECOND_REBOUND_DRAG + m] = 0.0


def apply_restitution(again: bool, bodies: Bodies, constraints: Constraints) -> bool:
    """Apply restitution to the bodies of all blocks once; return whether impulses have settled.

    Again, it visits the blocks only to which it has given some.
    """
    motion, scratch = bodies.motion, constraints.scratch
    settled = True
    for b in range(constraints.counts[tb.BLOCKS]):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        if again and not (
            some_above(row, tb.FIRST_RESTITUTION) or some_above(row, tb.SECOND_RESTITUTION)
        ):
            continue
        load_velocities(lane, motion, scratch)
        restitution_lanes(tb.FIRST_POINT, tb.FIRST_RESTITUTION, row, scratch)
        settled = settled and not some_above(scratch, tb.B_UNSETTLED)
        if lane[tb.POINTS] == 2:
            restitution_lanes(tb.SECOND_POINT, tb.SECOND_RESTITUTION, row, scratch)
            settled = settled and not some_above(scratch, tb.B_UNSETTLED)
        apply_bounced_friction(lane, row, scratch)
        store_velocities(lane, motion, scratch)
    return settled
