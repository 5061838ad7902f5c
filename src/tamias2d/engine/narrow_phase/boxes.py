"""Boxes around shapes as a part begins: on a long contact list most pairs are far apart.

A list is made for several steps. Where many bodies fall together it holds ten pairs for one that
touches. Most of the others are told by two boxes, and nothing else of their bodies is read.
Cost: a visit to each vertex, and to the boxes of each pair.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, BroadPhase, Control, Integers, Shapes
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

LONG = 4  # contacts to a shape, above which boxes cost less than they save
BOUNDLESS = 2.0**1000  # m, half of the box of a shape that none contains, or that is thin
BOX_ROUNDING = 2.0**-44  # of coordinates and sizes: more than rounding does to a box


def note_boxes_if_long(
    broad_phase: BroadPhase, control: Control, close: float, bodies: Bodies, shapes: Shapes
) -> bool:
    """Write the boxes of shapes if the contact list is long; return whether it is."""
    if broad_phase.counts[tb.CONTACTS] <= LONG * len(shapes.slot):
        return False
    note_boxes(control.progress[tb.PART_TIME], close, bodies, shapes)
    return True


def note_boxes(time: float, close: float, bodies: Bodies, shapes: Shapes) -> None:
    """Write the boxes of shapes where they are, and how far their bodies go in a time, s.

    A gap below the share `close` of the smaller radius counts as a contact.
    """
    for s in range(len(shapes.slot)):
        box, radius = shapes.boxes[s], shapes.material[s, tb.SHAPE_RADIUS]
        pose, motion = bodies.pose[shapes.slot[s]], bodies.motion[shapes.slot[s]]
        x, y = pose[tb.X], pose[tb.Y]
        more = shapes.radius[s] + BOX_ROUNDING * (abs(x) + abs(y) + radius)
        if shapes.kind[s] >= tb.HALF_PLANE:
            more = BOUNDLESS
        low_x, low_y, high_x, high_y = BOUNDLESS, BOUNDLESS, -BOUNDLESS, -BOUNDLESS
        for k in range(shapes.first[s], shapes.first[s] + shapes.vertex_count[s]):
            vx, vy = shapes.world_vertices[k, 0], shapes.world_vertices[k, 1]
            low_x, high_x = min(low_x, vx), max(high_x, vx)
            low_y, high_y = min(low_y, vy), max(high_y, vy)
        box[tb.BOX_LOW_X], box[tb.BOX_HIGH_X] = x + low_x - more, x + high_x + more
        box[tb.BOX_LOW_Y], box[tb.BOX_HIGH_Y] = y + low_y - more, y + high_y + more
        box[tb.BOX_WAY_X], box[tb.BOX_WAY_Y] = time * motion[tb.VX], time * motion[tb.VY]
        box[tb.BOX_CLOSE] = close * radius


@inlined
def stays_far(s: int, t: int, more: float, flags: Integers, boxes: Array) -> bool:
    """Return whether nothing is known of a contact, and its shapes do not come near in a part.

    Near is what counts as close, and so much more, m.
    """
    known = flags[tb.POINT_COUNT] + flags[tb.TOUCHES] + flags[tb.FEATURE] + flags[tb.FEATURE + 1]
    a, b = boxes[s], boxes[t]
    gap_x = max(b[tb.BOX_LOW_X] - a[tb.BOX_HIGH_X], a[tb.BOX_LOW_X] - b[tb.BOX_HIGH_X])
    gap_y = max(b[tb.BOX_LOW_Y] - a[tb.BOX_HIGH_Y], a[tb.BOX_LOW_Y] - b[tb.BOX_HIGH_Y])
    way = abs(b[tb.BOX_WAY_X] - a[tb.BOX_WAY_X]) + abs(b[tb.BOX_WAY_Y] - a[tb.BOX_WAY_Y])
    near = min(a[tb.BOX_CLOSE], b[tb.BOX_CLOSE]) + way + more
    return bool((known == 0) & (max(gap_x, gap_y) > near))
