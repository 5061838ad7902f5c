"""Which pairs touch, or may in this step, and where.

Serves: a step. Hides: how near is near, which follows from sizes and from the motion at hand.
"""

from tamias2d.state import (
    Array,
)
from tamias2d.stepped.layout import (
    ARRANGED,
    COUNT,
    DORMANT,
    GAP,
    HIT,
    HIT_A,
    HIT_B,
    HIT_COLOUR,
    HITS,
    IS,
    ISLANDED,
    LIVE,
    OF_A,
    OF_B,
    PAIRS,
    POINT,
    SENSOR,
    SHAPE_REACH,
    SPIN,
    TIME_STEP,
    TOUCHED,
    VX,
    VY,
    WAS,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.manifold import (
    collide,
)

CLOSE = 0.02  # of the smaller reach: what is nearer is a contact already
AHEAD = 0.1  # of the smaller reach: how far the motion of a step can make it one
BULLET = 2.0  # of the smaller reach: what moves farther in a step is met in flight


def meet(
    again: bool,
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    surface: Array,
    filters: Whole,
    turned: Array,
    pair: Whole,
    touch: Array,
    trace: Whole,
    hits: Whole,
    island: Whole,
) -> None:
    """Find the contacts of all pairs, and list the pairs that have some.

    What was noted of the last step is aged, unless that has been done. Where contacts are those of
    the last step, with as many points, their arrangement holds.
    """
    total = 0
    same = counts[ARRANGED] == 1
    for p in range(counts[PAIRS]):
        if trace[p, TOUCHED] != 0 and not again:
            trace[p, TOUCHED] = WAS * (trace[p, TOUCHED] & IS)
        s, t = pair[p, 0], pair[p, 1]
        i, j = pair[p, OF_A], pair[p, OF_B]
        if counts[DORMANT] > 0 and island[i, LIVE] + island[j, LIVE] == 0:
            continue
        x, y = pose[j, X] - pose[i, X], pose[j, Y] - pose[i, Y]
        reach, other = surface[s, SHAPE_REACH], surface[t, SHAPE_REACH]
        radii = reach + other
        reach = min(reach, other)
        radii += (CLOSE + AHEAD) * reach
        if x * x + y * y > radii * radii and trace[p, COUNT] == 0:
            continue
        by_x = motion[j, VX] - motion[i, VX]
        by_y = motion[j, VY] - motion[i, VY]
        speed = (abs(by_x) + abs(by_y)) * settings[TIME_STEP]
        turn_a = abs(motion[i, SPIN]) * surface[s, SHAPE_REACH] if shape_count[s] > 1 else 0.0
        turn_b = abs(motion[j, SPIN]) * surface[t, SHAPE_REACH] if shape_count[t] > 1 else 0.0
        whirl = speed + (turn_a + turn_b) * settings[TIME_STEP]
        margin = CLOSE * reach + min(speed, AHEAD * reach)
        margin = 0.0 if whirl > BULLET * reach else margin
        count = collide(
            p,
            s,
            t,
            x,
            y,
            margin,
            shape_kind,
            shape_first,
            shape_count,
            shape_radius,
            surface,
            turned,
            touch,
            trace,
        )
        if count == 0:
            continue
        if filters[s, SENSOR] == 0 and filters[t, SENSOR] == 0:
            same = same & (hits[HIT, total] == p) & (hits[HIT_COLOUR, total] % 2 == count - 1)
            hits[HIT, total], hits[HIT_A, total], hits[HIT_B, total] = p, i, j
            total += 1
        elif touch[p, GAP] <= 0.0 or (count == 2 and touch[p, GAP + POINT] <= 0.0):
            trace[p, TOUCHED] |= IS  # it overlaps a sensor
    if not same or counts[HITS] != total:
        counts[ARRANGED] = counts[ISLANDED] = 0
    counts[HITS] = total
