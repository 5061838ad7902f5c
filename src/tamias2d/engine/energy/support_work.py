"""What supports that move against each other give an island, J (DD90).

It is seen from the ground, where each does work on what it pushes. Cost: a visit to each contact
block, where some island leans on such.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.support import SUPPORTED_BY_ONE
from tamias2d.engine.solver.lane import normal_speed, slip_at, velocities_of_one
from tamias2d.engine.tables import Bodies, Constraints, Islands
from tamias2d.generated.island_energy import support_work


def add_support_work(bodies: Bodies, constraints: Constraints, islands: Islands) -> None:
    """Add what supports that move against each other have given to the work on their islands."""
    some = False
    for n in range(islands.counts[tb.ROOTS]):
        some = some or islands.energy[islands.roots[n], tb.SUPPORTS_DIFFER] == 1.0
    for b in range(constraints.counts[tb.BLOCKS] if some else 0):
        lanes = constraints.lanes[b]
        for m in range(lanes[tb.FILLED]):
            i, j = lanes[tb.BODY_A + m], lanes[tb.BODY_B + m]
            pushed = i if bodies.kind[i] == tb.DYNAMIC else j
            row = islands.energy[islands.links[pushed, tb.ROOT]]
            differ = row[tb.SUPPORTS_DIFFER] == 1.0 and row[tb.SUPPORT] == SUPPORTED_BY_ONE
            if differ and bodies.kind[i] != bodies.kind[j]:
                row[tb.WORK] += work_of_contact(m, pushed == j, b, bodies, constraints)


def work_of_contact(
    m: int, support_is_a: bool, b: int, bodies: Bodies, constraints: Constraints
) -> float:
    """Return what the support of a contact may have given by it at most, J."""
    lanes, row, total = constraints.lanes[b], constraints.blocks[b], 0.0
    support = bodies.motion[lanes[(tb.BODY_A if support_is_a else tb.BODY_B) + m]]
    alone = velocities_of_one(support, support_is_a)
    for n in range(lanes[tb.POINTS]):
        at = tb.SHARED + n * tb.POINT_SIZE
        total += support_work(
            row[at + tb.P_TOTAL_IMPULSE + m],
            row[tb.R_FRICTION + m],
            normal_speed(m, at, alone, row),
            slip_at(m, at, alone, row),
        )
    return total
