"""Which contacts touch, or may in this step, and where. Cost: linear in the contacts."""

from tamias2d.engine import tables as tb
from tamias2d.engine.islands import both_sleep
from tamias2d.engine.narrow_phase.approach import GRAZE, goes_slowly, will_meet
from tamias2d.engine.narrow_phase.boxes import note_boxes_if_long, stays_far
from tamias2d.engine.narrow_phase.chain import BESIDE
from tamias2d.engine.narrow_phase.chain_sides import note_sides
from tamias2d.engine.narrow_phase.manifold import known_gap, smallest_gap, update_manifold
from tamias2d.engine.narrow_phase.margins import CLOSE
from tamias2d.engine.narrow_phase.thickness import half_extent
from tamias2d.engine.tables import (
    Bodies,
    BroadPhase,
    Contacts,
    Control,
    Integers,
    Islands,
    Shapes,
    Touching,
)
from tamias2d.generated.soft_contact import corner_fall
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

# fractions of the smaller bounding radius of two shapes
AHEAD = 0.1  # the most by which the motion of a step raises CLOSE
DEEP = 0.35  # the overlap beyond which continuous collision sees to it that it grows no more
MANY_NEW = 0.25  # of all contacts: in a heap always some come and go
SUNK = 0.5  # of the smaller half of a least width: an overlap that should not grow any more
OF_THIS_STEP = tb.IS_TOUCHING + tb.MET_IN_FLIGHT  # of TOUCHES; twice these bits are of the last one


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
    """Find the points of all contacts, and list the contacts that have some.

    Flags of the last step are aged, unless they were found in this step already. If the contacts
    are those of the last step, with as many points, their arrangement holds.
    """
    total = marked = new_static = placed = 0
    deep, same = False, touching.counts[tb.ARRANGED] == 1
    pull = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
    time = control.progress[tb.PART_TIME]
    fall = corner_fall(pull, time)
    note_sides(again, broad_phase.counts[tb.CONTACTS], contacts, shapes, touching.sides)
    boxed = note_boxes_if_long(broad_phase, control, CLOSE, bodies, shapes)
    for p in range(broad_phase.counts[tb.CONTACTS]):
        age_flags(again, contacts.flags[p])
        s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
        i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
        far = boxed and stays_far(s, t, 0.0, contacts.flags[p], shapes.boxes)
        if far or both_sleep(i, j, islands):
            continue
        smaller = min(shapes.material[s, tb.SHAPE_RADIUS], shapes.material[t, tb.SHAPE_RADIUS])
        touched = contacts.flags[p, tb.TOUCHES] != 0
        before = known_gap(contacts.manifolds[p], contacts.flags[p])
        count, margin = update_manifold(p, smaller, touched, fall, time, bodies, shapes, contacts)
        if count == 0:
            continue
        if contacts.flags[p, tb.SENSES] == 0:
            beside = contacts.flags[p, tb.FEATURE] == BESIDE
            gap = smallest_gap(contacts.manifolds[p], count)
            apart = gap > (CLOSE + AHEAD) * smaller
            comes = (not touched or (apart and goes_slowly(margin, i, j, bodies))) and will_meet(
                p, i, j, count, smaller, control, bodies, contacts
            )
            meets = comes and not touched
            if (apart and not comes) or (beside and not meets):
                contacts.flags[p, tb.POINT_COUNT] = 0
                continue
            deep = deep | (gap < -DEEP * smaller)
            if (gap < before) & (before < 0.0) & (gap < -SUNK * tb.THINNEST * smaller):
                note_sinking(i, j, gap, control, bodies)
            same = same & (touching.contact[total] == p) & (touching.colour[total] % 2 == count - 1)
            touching.contact[total], touching.body_a[total], touching.body_b[total] = p, i, j
            total += 1
            contacts.flags[p, tb.LOCATED] = tb.MOST_LOCATED if meets else 0
            if not touched and (bodies.kind[i] == tb.STATIC or bodies.kind[j] == tb.STATIC):
                new_static += 1
            placed += 0 if touched or gap > GRAZE * smaller else 1
            fast = margin > (CLOSE + AHEAD) * smaller  # it may change a velocity by much
            marked += 1 if comes or fast else 0
        else:
            mark_sensor(count, contacts.manifolds[p], contacts.flags[p])
    forget_arrangement(not same or touching.counts[tb.TOUCHING] != total, touching)
    touching.counts[tb.TOUCHING] = total
    touching.counts[tb.MEETING], touching.counts[tb.NEW_STATIC] = marked, new_static
    touching.counts[tb.PRESSED_DEEP], touching.counts[tb.BOXED] = int(deep), int(boxed)
    touching.counts[tb.IMPULSES_UNKNOWN] = int(placed > MANY_NEW * total)


@inlined
def forget_arrangement(changed: bool, touching: Touching) -> None:
    """Let nothing be known of how contacts are arranged, if others touch than in the last step."""
    if changed:
        touching.counts[tb.ARRANGED] = touching.counts[tb.ISLANDS_KNOWN] = 0


def note_sinking(i: int, j: int, gap: float, control: Control, bodies: Bodies) -> None:
    """Note the first two bodies whose overlap is deep where it grows: nothing holds them apart.

    It is asked as a step begins, and between its shortest parts: between longer ones an impact may
    press bodies together for a while.
    """
    sunk = gap < -SUNK * min(half_extent(i, bodies), half_extent(j, bodies))
    asked = control.counts[tb.TICK] == 0 or control.counts[tb.LEVEL] == tb.MOST_LEVEL
    if sunk and asked and control.counts[tb.SUNK_A] == 0:
        control.counts[tb.SUNK_A], control.counts[tb.SUNK_B] = i + 1, j + 1
        control.counts[tb.LIMITS] += 1


def age_flags(again: bool, flags: Integers) -> None:
    """Let what touched and met have done so before, unless this step was looked at already."""
    if flags[tb.TOUCHES] != 0 and not again:
        flags[tb.TOUCHES] = 2 * (flags[tb.TOUCHES] & OF_THIS_STEP)
    flags[tb.LOCATED] = 0


@inlined
def mark_sensor(count: int, manifold: Array, flags: Integers) -> None:
    """Mark a contact with a sensor as touching if the shapes overlap."""
    if manifold[tb.GAP] <= 0.0 or (count == 2 and manifold[tb.GAP + tb.POINT] <= 0.0):
        flags[tb.TOUCHES] |= tb.IS_TOUCHING
