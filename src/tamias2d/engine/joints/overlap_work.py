"""What overlaps give the islands of mechanisms as contacts push them apart in a part, J (DD106).

Cost: a visit to each contact, where an island has not the energy for its way.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.direct.contacts import gap_later
from tamias2d.engine.tables import Bodies, Constraints, Islands
from tamias2d.generated.joint_step import impulse_way, overlap_removed, overlap_work
from tamias2d.state import Array


def add_overlap_work(
    time_step: float, bodies: Bodies, constraints: Constraints, islands: Islands
) -> None:
    """Add what the overlaps of each island have given to what they may give back."""
    if not some_lacks_energy(islands):
        return
    for n in range(islands.counts[tb.ROOTS]):
        island = islands.energy[islands.roots[n]]
        island[tb.OVERLAP_IMPULSE] = island[tb.OVERLAP_IMPULSE_WAY] = 0.0
    for b in range(constraints.counts[tb.BLOCKS]):
        lanes = constraints.lanes[b]
        for m in range(lanes[tb.FILLED]):
            i, j = lanes[tb.BODY_A + m], lanes[tb.BODY_B + m]
            pushed = i if bodies.kind[i] == tb.DYNAMIC else j
            island = islands.energy[islands.links[pushed, tb.ROOT]]
            sum_impulses_and_ways(m, b, bodies, constraints, island)
    for n in range(islands.counts[tb.ROOTS]):
        island = islands.energy[islands.roots[n]]
        load, impulse = island[tb.ISLAND_LOAD], island[tb.OVERLAP_IMPULSE]
        if load + impulse > 0.0:
            way = island[tb.OVERLAP_IMPULSE_WAY]
            island[tb.LIFT_WORK] += overlap_work(load, impulse, way, time_step)


def some_lacks_energy(islands: Islands) -> bool:
    """Return whether an island goes farther against forces than what it has allows."""
    some = False
    for n in range(islands.counts[tb.ROOTS]):
        island = islands.energy[islands.roots[n]]
        has = island[tb.ENERGY_START] + island[tb.LIFT_WORK]
        some = some or has + island[tb.WORK] + island[tb.LIFT_BEYOND_MOTION] < 0.0
    return some


def sum_impulses_and_ways(
    m: int, b: int, bodies: Bodies, constraints: Constraints, island: Array
) -> None:
    """Add the impulses of a contact, and these times the ways of its overlaps, to its island's."""
    lanes, row = constraints.lanes[b], constraints.blocks[b]
    one, other = bodies.motion[lanes[tb.BODY_A + m]], bodies.motion[lanes[tb.BODY_B + m]]
    for n in range(lanes[tb.POINTS]):
        at = tb.SHARED + n * tb.POINT_SIZE + m
        impulse = row[at + tb.P_TOTAL_IMPULSE]
        removed = overlap_removed(row[at + tb.P_GAP], gap_later(m, at, row, one, other))
        island[tb.OVERLAP_IMPULSE] += impulse
        island[tb.OVERLAP_IMPULSE_WAY] += impulse_way(impulse, removed)
