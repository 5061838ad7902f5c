"""Which pairs touch, or may in this step, and where.

Serves: a step. Hides: how near is near, which follows from sizes and from the motion at hand.
"""

from tamias2d.engine.narrow_phase.manifold import collide
from tamias2d.engine.tables import (
    ARRANGED,
    AWAKE,
    CONTACTS,
    GAP,
    IS_TOUCHING,
    ISLANDS_KNOWN,
    POINT,
    POINT_COUNT,
    SENSOR,
    SHAPE_RADIUS,
    SLEEPING,
    SLOT_A,
    SLOT_B,
    SPIN,
    TIME_STEP,
    TOUCHES,
    TOUCHING,
    VX,
    VY,
    WAS_TOUCHING,
    Bodies,
    BroadPhase,
    Contacts,
    Control,
    Islands,
    Shapes,
    Touching,
    X,
    Y,
)

CLOSE = 0.02  # of the smaller reach: what is nearer is a contact already
AHEAD = 0.1  # of the smaller reach: how far the motion of a step can make it one
BULLET = 2.0  # of the smaller reach: what moves farther in a step is met in flight


def find_touching(
    again: bool,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    broad_phase: BroadPhase,
    contacts: Contacts,
    touching: Touching,
    islands: Islands,
) -> None:
    """Find the contacts of all pairs, and list the pairs that have some.

    What was noted of the last step is aged, unless that has been done. Where contacts are those of
    the last step, with as many points, their arrangement holds.
    """
    total = 0
    same = touching.counts[ARRANGED] == 1
    for p in range(broad_phase.counts[CONTACTS]):
        if contacts.flags[p, TOUCHES] != 0 and not again:
            contacts.flags[p, TOUCHES] = WAS_TOUCHING * (contacts.flags[p, TOUCHES] & IS_TOUCHING)
        s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
        i, j = contacts.pairs[p, SLOT_A], contacts.pairs[p, SLOT_B]
        if islands.counts[SLEEPING] > 0 and islands.links[i, AWAKE] + islands.links[j, AWAKE] == 0:
            continue
        x, y = bodies.pose[j, X] - bodies.pose[i, X], bodies.pose[j, Y] - bodies.pose[i, Y]
        reach, other = shapes.material[s, SHAPE_RADIUS], shapes.material[t, SHAPE_RADIUS]
        radii = reach + other
        reach = min(reach, other)
        radii += (CLOSE + AHEAD) * reach
        if x * x + y * y > radii * radii and contacts.flags[p, POINT_COUNT] == 0:
            continue
        by_x = bodies.motion[j, VX] - bodies.motion[i, VX]
        by_y = bodies.motion[j, VY] - bodies.motion[i, VY]
        speed = (abs(by_x) + abs(by_y)) * control.settings[TIME_STEP]
        turn_a = (
            abs(bodies.motion[i, SPIN]) * shapes.material[s, SHAPE_RADIUS]
            if shapes.count[s] > 1
            else 0.0
        )
        turn_b = (
            abs(bodies.motion[j, SPIN]) * shapes.material[t, SHAPE_RADIUS]
            if shapes.count[t] > 1
            else 0.0
        )
        whirl = speed + (turn_a + turn_b) * control.settings[TIME_STEP]
        margin = CLOSE * reach + min(speed, AHEAD * reach)
        margin = 0.0 if whirl > BULLET * reach else margin
        count = collide(p, s, t, x, y, margin, shapes, contacts)
        if count == 0:
            continue
        if shapes.filters[s, SENSOR] == 0 and shapes.filters[t, SENSOR] == 0:
            same = same & (touching.contact[total] == p) & (touching.colour[total] % 2 == count - 1)
            touching.contact[total], touching.body_a[total], touching.body_b[total] = p, i, j
            total += 1
        elif contacts.manifolds[p, GAP] <= 0.0 or (
            count == 2 and contacts.manifolds[p, GAP + POINT] <= 0.0
        ):
            contacts.flags[p, TOUCHES] |= IS_TOUCHING  # it overlaps a sensor
    if not same or touching.counts[TOUCHING] != total:
        touching.counts[ARRANGED] = touching.counts[ISLANDS_KNOWN] = 0
    touching.counts[TOUCHING] = total
