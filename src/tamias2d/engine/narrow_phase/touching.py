"""Which contacts touch, or may in this step, and where. Cost: linear in the contacts."""

from tamias2d.engine import tables as tb
from tamias2d.engine.islands import both_sleep
from tamias2d.engine.joined import unless_joined
from tamias2d.engine.narrow_phase.boxes import note_boxes_if_long, stays_far
from tamias2d.engine.narrow_phase.chain import BESIDE
from tamias2d.engine.narrow_phase.chain_sides import note_sides
from tamias2d.engine.narrow_phase.collide import collide
from tamias2d.engine.narrow_phase.half_plane import is_above
from tamias2d.engine.narrow_phase.reuse import move_gaps, note_pose
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
from tamias2d.engine.thickness import contact_extent
from tamias2d.generated.soft_contact import corner_fall, row_velocity, turning_arm
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector

# fractions of the smaller bounding radius of two shapes
CLOSE = 0.02  # the gap below which there is a contact already
BETWEEN = 50.0  # half widths that the radius counts at most for it: across a body there is none
AHEAD = 0.1  # the most by which the motion of a step raises that
GRAZE = 2.0**-12  # the overlap of bodies that have just met
MANY_NEW = 0.25  # of all contacts: in a heap always some come and go
DEEP = 0.35  # the overlap beyond which continuous collision sees to it that it grows no more
STILL = 2.0**-10  # a way for which a manifold is kept: its gaps are wrong by its square, 1e-6
SUNK = 0.5  # of the smaller half of a least width: an overlap that should not grow any more
BULLET = 2.0  # the motion of a step beyond which contacts are left to continuous collision
PARTED = 0.05  # of the margin: how much farther apart points are when a contact loses them
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


@inlined
def update_manifold(
    p: int,
    smaller: float,
    touched: bool,
    fall: float,
    time: float,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
) -> tuple[int, float]:
    """Find the points of a contact, or keep them; return how many, and the margin, m, for them."""
    speeds = relative_speeds(contacts.pairs[p], bodies, shapes)
    way = (speeds[0] + speeds[1]) * time
    slow = touched & (way <= STILL * smaller)
    if slow and keeps_manifold(p, smaller, bodies, shapes, contacts):
        return 2, CLOSE * smaller + way
    margin, further = speculative_margins(
        contacts.pairs[p], smaller, touched, speeds, fall, time, bodies, shapes
    )
    return find_manifold(p, margin, further, bodies, shapes, contacts), margin


@inlined
def keeps_manifold(
    p: int, smaller: float, bodies: Bodies, shapes: Shapes, contacts: Contacts
) -> bool:
    """Let the gaps of two points follow their bodies, which hardly move; return whether they may.

    Which side of a thin shape the other one is on, is asked anew.
    """
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
    if contacts.flags[p, tb.POINT_COUNT] != 2 or not both_plain(s, t, shapes):
        return False
    x, y = bodies.pose[j, tb.X] - bodies.pose[i, tb.X], bodies.pose[j, tb.Y] - bodies.pose[i, tb.Y]
    radii = shapes.material[s, tb.SHAPE_RADIUS] + shapes.material[t, tb.SHAPE_RADIUS]
    angle_a, angle_b = bodies.pose[i, tb.ANGLE], bodies.pose[j, tb.ANGLE]
    return move_gaps(x, y, angle_a, angle_b, radii, STILL * smaller, contacts.manifolds[p])


@inlined
def both_plain(s: int, t: int, shapes: Shapes) -> bool:
    """Return whether neither of two shapes is thin."""
    return bool((shapes.kind[s] < tb.THIN_CAPSULE) & (shapes.kind[t] < tb.THIN_CAPSULE))


@inlined
def find_manifold(
    p: int, margin: float, further: float, bodies: Bodies, shapes: Shapes, contacts: Contacts
) -> int:
    """Find the points of a contact if a gap is below the margin, m; return how many there are.

    Of another point it may be larger by so much further, m. A contact that has points loses them at
    a slightly larger gap than it got them, lest all be arranged anew whenever a gap trembles.
    """
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
    x, y = bodies.pose[j, tb.X] - bodies.pose[i, tb.X], bodies.pose[j, tb.Y] - bodies.pose[i, tb.Y]
    radius_s, radius_t = shapes.material[s, tb.SHAPE_RADIUS], shapes.material[t, tb.SHAPE_RADIUS]
    points = contacts.flags[p, tb.POINT_COUNT]
    radii = radius_s + radius_t + margin
    if points == 0 and (
        x * x + y * y > radii * radii or over_plane(p, x, y, margin, shapes, contacts)
    ):
        return 0
    kept = PARTED * margin
    far = max(further, kept) if points > 0 else 0.0
    count = collide(p, s, t, x, y, margin + far, shapes, contacts)
    if count > 0 and far > 0.0 and smallest_gap(contacts.manifolds[p], count) > margin + kept:
        contacts.flags[p, tb.POINT_COUNT] = 0
        return 0
    if count == 1 and further > far:
        count = collide(p, s, t, x, y, margin + further, shapes, contacts)
    if count == 2 and both_plain(s, t, shapes):
        angle_a, angle_b = bodies.pose[i, tb.ANGLE], bodies.pose[j, tb.ANGLE]
        note_pose(x, y, angle_a, angle_b, 0.0, contacts.manifolds[p])
    return count


@inlined
def over_plane(
    p: int, x: float, y: float, margin: float, shapes: Shapes, contacts: Contacts
) -> bool:
    """Return whether a shape is farther from a half-plane than a margin, m, and keeps no feature.

    The body of the second shape is at (x, y) from that of the first one.
    """
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    if contacts.flags[p, tb.FEATURE] != 0:
        return False
    if shapes.kind[s] == tb.HALF_PLANE:
        side = shapes.world_vertices[shapes.first[s]]
        return is_above(x, y, shapes.material[t, tb.SHAPE_RADIUS], margin, side)
    if shapes.kind[t] == tb.HALF_PLANE:
        side = shapes.world_vertices[shapes.first[t]]
        return is_above(-x, -y, shapes.material[s, tb.SHAPE_RADIUS], margin, side)
    return False


def known_gap(manifold: Array, flags: Integers) -> float:
    """Return the smallest gap of a contact as it was found last, m; 0 without points."""
    return smallest_gap(manifold, flags[tb.POINT_COUNT]) if flags[tb.POINT_COUNT] > 0 else 0.0


def note_sinking(i: int, j: int, gap: float, control: Control, bodies: Bodies) -> None:
    """Note the first two bodies whose overlap is deep where it grows: nothing holds them apart.

    It is asked as a step begins, and between its shortest parts: between longer ones an impact may
    press bodies together for a while. Thin bodies know their side, however deep they are.
    """
    least = min(bodies.properties[i, tb.MIN_EXTENT], bodies.properties[j, tb.MIN_EXTENT])
    wide = min(bodies.properties[i, tb.BOUNDING_RADIUS], bodies.properties[j, tb.BOUNDING_RADIUS])
    sunk = (gap < -SUNK * least) & (least > tb.THINNEST * wide)
    asked = control.counts[tb.TICK] == 0 or control.counts[tb.LEVEL] == tb.MOST_LEVEL
    if sunk and asked and control.counts[tb.SUNK_A] == 0:
        control.counts[tb.SUNK_A], control.counts[tb.SUNK_B] = i + 1, j + 1
        control.counts[tb.LIMITS] += 1


def age_flags(again: bool, flags: Integers) -> None:
    """Let what touched and met have done so before, unless this step was looked at already."""
    if flags[tb.TOUCHES] != 0 and not again:
        flags[tb.TOUCHES] = 2 * (flags[tb.TOUCHES] & OF_THIS_STEP)
    flags[tb.LOCATED] = 0


def smallest_gap(manifold: Array, count: int) -> float:
    """Return the smallest gap of some points, m."""
    gap: float = manifold[tb.GAP]
    return min(gap, manifold[tb.GAP + tb.POINT]) if count == 2 else gap


def will_meet(
    p: int,
    i: int,
    j: int,
    count: int,
    smaller: float,
    control: Control,
    bodies: Bodies,
    contacts: Contacts,
) -> bool:
    """Return whether two bodies that are apart meet in this part, faster than gravity lets them."""
    manifold, time = contacts.manifolds[p], control.progress[tb.PART_TIME]
    seen = time + time / control.counts[tb.PART_SUBSTEPS]  # relaxing looks a substep ahead
    pull = 0.0
    if bodies.kind[i] != bodies.kind[j]:
        pull = time * (abs(control.settings[tb.GRAVITY_X]) + abs(control.settings[tb.GRAVITY_Y]))
    meets = False
    for n in range(count):
        gap = manifold[tb.GAP + n * tb.POINT]
        if gap <= -GRAZE * smaller:
            return False
        speed = opening_speed(n, i, j, bodies, manifold)
        meets = meets | ((speed < -2.0 * pull) & (gap + (speed - pull) * seen < 0.0))
    return bool(meets)


def goes_slowly(margin: float, i: int, j: int, bodies: Bodies) -> bool:
    """Return whether bodies go less far in a part than the thinner one is thick.

    Those that have parted and meet again are left to the solver then, else to the search on paths.
    """
    return bool(
        margin <= min(bodies.properties[i, tb.MIN_EXTENT], bodies.properties[j, tb.MIN_EXTENT])
    )


def opening_speed(n: int, i: int, j: int, bodies: Bodies, manifold: Array) -> float:
    """Return how fast the gap of a point opens, m/s."""
    return opening(n, i, j, tb.VX, bodies, manifold)


def opening(n: int, i: int, j: int, first: int, bodies: Bodies, manifold: Array) -> float:
    """Return how fast the gap of a point opens, m/s; or how far, m, where `first` is `DX`."""
    x, y = manifold[tb.PX + n * tb.POINT], manifold[tb.PY + n * tb.POINT]
    span_x, span_y = (
        bodies.pose[j, tb.X] - bodies.pose[i, tb.X],
        bodies.pose[j, tb.Y] - bodies.pose[i, tb.Y],
    )
    normal, a, b = (manifold[tb.NX], manifold[tb.NY]), bodies.motion[i], bodies.motion[j]
    return row_velocity(
        (a[first], a[first + 1]), a[first + 2], turning_arm((x, y), normal),
        (b[first], b[first + 1]), b[first + 2],
        turning_arm((x - span_x, y - span_y), normal), normal,
    )  # fmt: skip


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


@inlined
def mark_sensor(count: int, manifold: Array, flags: Integers) -> None:
    """Mark a contact with a sensor as touching if the shapes overlap."""
    if manifold[tb.GAP] <= 0.0 or (count == 2 and manifold[tb.GAP + tb.POINT] <= 0.0):
        flags[tb.TOUCHES] |= tb.IS_TOUCHING
