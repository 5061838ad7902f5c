"""Bodies that nothing turns, on a support that turns: where they meet it (DD108).

Such a body goes with the point of its support at which contacts press it, and not with the one at
its centre; what keeps it upright does the rest of the work. Cost: a visit to each body, and to each
contact block where a support turns one.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.step_energy import can_be_turned
from tamias2d.engine.tables import Bodies, Constraints, Islands, Touching
from tamias2d.generated.friction import impulse_vector
from tamias2d.generated.island_energy import (
    contact_arm,
    holding_work,
    impulse_moment,
    pressed_arm,
)
from tamias2d.state import Array, Vector


def find_pressed_arms(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Find where contacts press the bodies that nothing turns, and their moments."""
    some = False
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == tb.DYNAMIC and not can_be_turned(i, bodies.properties):
            islands.energy[i, tb.TOTAL_PRESS : tb.ANGULAR_IMPULSE + 1] = 0.0
            some = some or islands.energy[islands.links[i, tb.ROOT], tb.REFERENCE + 2] != 0.0
    for b in range(constraints.counts[tb.BLOCKS] if some else 0):
        lanes, row = constraints.lanes[b], constraints.blocks[b]
        for m in range(lanes[tb.FILLED]):
            i, j = lanes[tb.BODY_A + m], lanes[tb.BODY_B + m]
            for n in range(lanes[tb.POINTS]):
                at = tb.SHARED + n * tb.POINT_SIZE + m
                arms = (row[at + tb.P_NORMAL_ARM_A], row[at + tb.P_TANGENT_ARM_A])
                add_press(i, -1.0, m, at, arms, row, bodies, islands)
                arms = (row[at + tb.P_NORMAL_ARM_B], row[at + tb.P_TANGENT_ARM_B])
                add_press(j, 1.0, m, at, arms, row, bodies, islands)
    for k in range(constraints.counts[tb.ACTIVE] if some else 0):
        i = touching.active[k]
        given = islands.energy[i]
        if is_held_upright(i, bodies, islands) and given[tb.TOTAL_PRESS] > 0.0:
            given[tb.PRESSED_ARM], given[tb.PRESSED_ARM + 1] = pressed_arm(
                (given[tb.PRESSED_ARM], given[tb.PRESSED_ARM + 1]), given[tb.TOTAL_PRESS]
            )


def is_held_upright(i: int, bodies: Bodies, islands: Islands) -> bool:
    """Return whether nothing turns a body, and it is seen from a support that turns."""
    free = bodies.kind[i] == tb.DYNAMIC and not can_be_turned(i, bodies.properties)
    return bool(free and islands.energy[islands.links[i, tb.ROOT], tb.REFERENCE + 2] != 0.0)


def add_press(
    i: int, sign: float, m: int, at: int, arms: Vector, row: Array, bodies: Bodies, islands: Islands
) -> None:
    """Add the impulses of a point of a contact to those of one of its bodies, with a sign.

    Its arms, m, are those that turn it by an impulse along the normal, and along the tangent.
    """
    if not is_held_upright(i, bodies, islands):
        return
    given, normal_x, normal_y = islands.energy[i], row[tb.R_NX + m], row[tb.R_NY + m]
    total, friction = row[at + tb.P_TOTAL_IMPULSE], row[at + tb.P_TOTAL_FRICTION]
    arm = contact_arm(arms[1], arms[0], (normal_x, normal_y), (-normal_y, normal_x))
    given[tb.TOTAL_PRESS] += total
    for n in range(2):
        given[tb.PRESSED_ARM + n] += total * arm[n]
    x, y = impulse_vector(total, friction, (normal_x, normal_y))
    given[tb.IMPULSE_GOT] += sign * x
    given[tb.IMPULSE_GOT + 1] += sign * y
    given[tb.ANGULAR_IMPULSE] += sign * impulse_moment(total, arms[0], friction, arms[1])


def work_of_holding(i: int, spin: float, bodies: Bodies, islands: Islands) -> float:
    """Return what keeps a body upright has given it, seen from a support that turns, J."""
    if can_be_turned(i, bodies.properties) or spin == 0.0:
        return 0.0
    given = islands.energy[i]
    return holding_work(
        spin,
        given[tb.ANGULAR_IMPULSE],
        (given[tb.PRESSED_ARM], given[tb.PRESSED_ARM + 1]),
        (given[tb.IMPULSE_GOT], given[tb.IMPULSE_GOT + 1]),
    )
