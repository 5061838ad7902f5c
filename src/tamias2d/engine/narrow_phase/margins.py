"""Speculative margins: below which gap two shapes have a contact, by how they move in a step."""

from tamias2d.engine import tables as tb
from tamias2d.engine.joined import unless_joined
from tamias2d.engine.narrow_phase.thickness import contact_extent
from tamias2d.engine.tables import Bodies, Integers, Shapes
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Vector

# fractions of the smaller bounding radius of two shapes
CLOSE = 0.02  # the gap below which there is a contact already
BETWEEN = 50.0  # half widths that the radius counts at most for it: across a body there is none
BULLET = 2.0  # the motion of a step beyond which contacts are left to continuous collision


@inlined
def relative_speeds(pair: Integers, bodies: Bodies, shapes: Shapes) -> tuple[float, float]:
    """Return how fast two shapes may come together, m/s: by their velocities, and by turning."""
    s, t, motion = pair[0], pair[1], bodies.motion
    i, j = pair[tb.SLOT_A], pair[tb.SLOT_B]
    speed = abs(motion[j, tb.VX] - motion[i, tb.VX]) + abs(motion[j, tb.VY] - motion[i, tb.VY])
    turning = 0.0
    if shapes.vertex_count[s] > 1:
        turning += abs(motion[i, tb.SPIN]) * shapes.material[s, tb.SHAPE_RADIUS]
    if shapes.vertex_count[t] > 1:
        turning += abs(motion[j, tb.SPIN]) * shapes.material[t, tb.SHAPE_RADIUS]
    return speed, turning


@inlined
def speculative_margins(
    pair: Integers,
    smaller: float,
    touched: bool,
    speeds: Vector,
    fall: float,
    time_step: float,
    bodies: Bodies,
    shapes: Shapes,
) -> tuple[float, float]:
    """Return below which gap two shapes have a contact, m.

    It follows the motion of a step, s, and is 0 for a fast pair. The second number is how much
    farther off the other end of such a contact may be: it falls, m, and bodies turn about where
    they touch.
    """
    s, t, i, j = pair[0], pair[1], pair[tb.SLOT_A], pair[tb.SLOT_B]
    speed, turning = speeds
    fast = (speed + turning) * time_step > BULLET * smaller
    fast = unless_joined(fast, i, j, bodies)
    if fast:
        return 0.0, 0.0
    extent = smaller
    if max(shapes.kind[s], shapes.kind[t]) < tb.PIECE:  # near pieces tell a thin shape its side
        extent = contact_extent(i, j, smaller, BETWEEN, bodies)
    margin = CLOSE * extent + (speed + turning if touched else speed) * time_step
    if (shapes.kind[s] == tb.DISC) | (shapes.kind[t] == tb.DISC):
        return margin, 0.0
    return margin, fall + (0.0 if touched else turning * time_step)
