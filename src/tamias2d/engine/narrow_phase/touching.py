"""Which contacts touch, or may in this step, and where. Cost: linear in the contacts."""

from tamias2d.engine.joined import unless_joined
from tamias2d.engine.narrow_phase.chain import BESIDE
from tamias2d.engine.narrow_phase.chain_sides import note_sides
from tamias2d.engine.narrow_phase.collide import collide
from tamias2d.engine.narrow_phase.reuse import move_gaps, note_pose
from tamias2d.engine.tables import (
    ANGLE,
    ARRANGED,
    AWAKE,
    BOUNDING_RADIUS,
    CONTACTS,
    DISC,
    FEATURE,
    FORESEEN,
    GAP,
    GRAVITY_X,
    GRAVITY_Y,
    IS_TOUCHING,
    ISLANDS_KNOWN,
    LEVEL,
    LIMITS,
    LOCATED,
    MEETING,
    MET_IN_FLIGHT,
    MIN_EXTENT,
    MOST_LEVEL,
    MOST_LOCATED,
    NEW_STATIC,
    NX,
    NY,
    PART_SUBSTEPS,
    PART_TIME,
    PIECE,
    POINT,
    POINT_COUNT,
    PRESSED_DEEP,
    PX,
    PY,
    SENSES,
    SHAPE_RADIUS,
    SLEEPING,
    SLOT_A,
    SLOT_B,
    SPIN,
    STATIC,
    SUNK_A,
    SUNK_B,
    THIN_CAPSULE,
    THINNEST,
    TICK,
    TOUCHES,
    TOUCHING,
    VX,
    VY,
    Bodies,
    BroadPhase,
    Contacts,
    Control,
    Integers,
    Islands,
    Shapes,
    Touching,
    X,
    Y,
)
from tamias2d.engine.thickness import contact_extent
from tamias2d.generated.soft_contact import corner_fall, row_velocity, turning_arm
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

# fractions of the smaller bounding radius of two shapes
CLOSE = 0.02  # the gap below which there is a contact already
BETWEEN = 50.0  # half widths that the radius counts at most for it: across a body there is none
AHEAD = 0.1  # the most by which the motion of a step raises that
GRAZE = 2.0**-12  # the overlap of bodies that have just met
DEEP = 0.35  # the overlap beyond which continuous collision sees to it that it grows no more
STILL = 2.0**-10  # a way for which a manifold is kept: its gaps are wrong by its square, 1e-6
SUNK = 0.5  # of the smaller half of a least width: an overlap that should not grow any more
BULLET = 2.0  # the motion of a step beyond which contacts are left to continuous collision
OF_THIS_STEP = IS_TOUCHING + MET_IN_FLIGHT  # of TOUCHES; twice these bits are of the last one


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
    total = marked = new_static = 0
    deep = False
    same = touching.counts[ARRANGED] == 1
    pull = (control.settings[GRAVITY_X], control.settings[GRAVITY_Y])
    fall = corner_fall(pull, control.progress[PART_TIME])
    note_sides(again, broad_phase.counts[CONTACTS], contacts, shapes, touching.sides)
    for p in range(broad_phase.counts[CONTACTS]):
        age_flags(again, contacts.flags[p])
        s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
        i, j = contacts.pairs[p, SLOT_A], contacts.pairs[p, SLOT_B]
        if islands.counts[SLEEPING] > 0 and islands.links[i, AWAKE] + islands.links[j, AWAKE] == 0:
            continue
        smaller = min(shapes.material[s, SHAPE_RADIUS], shapes.material[t, SHAPE_RADIUS])
        touched = contacts.flags[p, TOUCHES] != 0
        margin, further = speculative_margins(
            i, j, s, t, smaller, touched, fall, control, bodies, shapes
        )
        before = known_gap(contacts.manifolds[p], contacts.flags[p])
        count = find_manifold(p, margin, further, bodies, shapes, contacts)
        if count == 0:
            continue
        if contacts.flags[p, SENSES] == 0:
            beside = contacts.flags[p, FEATURE] == BESIDE
            gap = smallest_gap(contacts.manifolds[p], count)
            apart = gap > (CLOSE + AHEAD) * smaller
            comes = (not touched or (apart and goes_slowly(margin, i, j, bodies))) and will_meet(
                p, i, j, count, smaller, control, bodies, contacts
            )
            meets = comes and not touched
            if (apart and not comes) or (beside and not meets):
                contacts.flags[p, POINT_COUNT] = 0
                continue
            deep = deep | (gap < -DEEP * smaller)
            if (gap < before) & (before < 0.0) & (gap < -SUNK * THINNEST * smaller):
                note_sinking(i, j, gap, control, bodies)
            same = same & (touching.contact[total] == p) & (touching.colour[total] % 2 == count - 1)
            touching.contact[total], touching.body_a[total], touching.body_b[total] = p, i, j
            total += 1
            contacts.flags[p, LOCATED] = MOST_LOCATED if meets else 0
            if not touched and (bodies.kind[i] == STATIC or bodies.kind[j] == STATIC):
                new_static += 1
            fast = margin > (CLOSE + AHEAD) * smaller  # it may change a velocity by much
            marked += 1 if comes or fast else 0
        else:
            mark_sensor(count, contacts.manifolds[p], contacts.flags[p])
    if not same or touching.counts[TOUCHING] != total:
        touching.counts[ARRANGED] = touching.counts[ISLANDS_KNOWN] = 0
    touching.counts[TOUCHING] = total
    touching.counts[MEETING], touching.counts[NEW_STATIC] = marked, new_static
    touching.counts[PRESSED_DEEP] = 1 if deep else 0


@inlined
def find_manifold(
    p: int, margin: float, further: float, bodies: Bodies, shapes: Shapes, contacts: Contacts
) -> int:
    """Find the points of a contact if a gap is below the margin, m; return how many there are.

    Of another point it may be larger by so much further, m.
    """
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    i, j = contacts.pairs[p, SLOT_A], contacts.pairs[p, SLOT_B]
    x, y = bodies.pose[j, X] - bodies.pose[i, X], bodies.pose[j, Y] - bodies.pose[i, Y]
    angle_a, angle_b = bodies.pose[i, ANGLE], bodies.pose[j, ANGLE]
    radius_s, radius_t = shapes.material[s, SHAPE_RADIUS], shapes.material[t, SHAPE_RADIUS]
    points = contacts.flags[p, POINT_COUNT]
    plain = (shapes.kind[s] < THIN_CAPSULE) & (shapes.kind[t] < THIN_CAPSULE)
    if points == 2 and plain and contacts.flags[p, TOUCHES] != 0:
        most = STILL * min(radius_s, radius_t)
        slow = margin <= (CLOSE + STILL) * min(radius_s, radius_t)
        if slow and move_gaps(
            x, y, angle_a, angle_b, radius_s + radius_t, most, contacts.manifolds[p]
        ):
            return 2
    radii = radius_s + radius_t + margin
    if x * x + y * y > radii * radii and points == 0:
        return 0
    far = further if points > 0 else 0.0
    count = collide(p, s, t, x, y, margin + far, shapes, contacts)
    if count > 0 and far > 0.0 and smallest_gap(contacts.manifolds[p], count) > margin:
        contacts.flags[p, POINT_COUNT] = 0
        return 0
    if count == 1 and further > far:
        count = collide(p, s, t, x, y, margin + further, shapes, contacts)
    if contacts.manifolds[p, FORESEEN] != 0.0:
        contacts.manifolds[p, FORESEEN] = 0.0
    if count == 2 and plain:  # which side of a thin shape the other one is on, is asked anew
        note_pose(x, y, angle_a, angle_b, 0.0, contacts.manifolds[p])
    return count


def known_gap(manifold: Array, flags: Integers) -> float:
    """Return the smallest gap of a contact as it was found last, m; 0 without points."""
    return smallest_gap(manifold, flags[POINT_COUNT]) if flags[POINT_COUNT] > 0 else 0.0


def note_sinking(i: int, j: int, gap: float, control: Control, bodies: Bodies) -> None:
    """Note the first two bodies whose overlap is deep where it grows: nothing holds them apart.

    It is asked as a step begins, and between its shortest parts: between longer ones an impact may
    press bodies together for a while. Thin bodies know their side, however deep they are.
    """
    least = min(bodies.properties[i, MIN_EXTENT], bodies.properties[j, MIN_EXTENT])
    wide = min(bodies.properties[i, BOUNDING_RADIUS], bodies.properties[j, BOUNDING_RADIUS])
    sunk = (gap < -SUNK * least) & (least > THINNEST * wide)
    asked = control.counts[TICK] == 0 or control.counts[LEVEL] == MOST_LEVEL
    if sunk and asked and control.counts[SUNK_A] == 0:
        control.counts[SUNK_A], control.counts[SUNK_B] = i + 1, j + 1
        control.counts[LIMITS] += 1


def age_flags(again: bool, flags: Integers) -> None:
    """Let what touched and met have done so before, unless this step was looked at already."""
    if flags[TOUCHES] != 0 and not again:
        flags[TOUCHES] = 2 * (flags[TOUCHES] & OF_THIS_STEP)
    flags[LOCATED] = 0


def smallest_gap(manifold: Array, count: int) -> float:
    """Return the smallest gap of some points, m."""
    gap: float = manifold[GAP]
    return min(gap, manifold[GAP + POINT]) if count == 2 else gap


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
    manifold, time = contacts.manifolds[p], control.progress[PART_TIME]
    seen = time + time / control.counts[PART_SUBSTEPS]  # relaxing looks a substep ahead
    pull = 0.0
    if bodies.kind[i] != bodies.kind[j]:
        pull = time * (abs(control.settings[GRAVITY_X]) + abs(control.settings[GRAVITY_Y]))
    meets = False
    for n in range(count):
        gap = manifold[GAP + n * POINT]
        if gap <= -GRAZE * smaller:
            return False
        speed = opening_speed(n, i, j, bodies, manifold)
        meets = meets | ((speed < -2.0 * pull) & (gap + (speed - pull) * seen < 0.0))
    return bool(meets)


def goes_slowly(margin: float, i: int, j: int, bodies: Bodies) -> bool:
    """Return whether bodies go less far in a part than the thinner one is thick.

    Those that have parted and meet again are left to the solver then, else to the search on paths.
    """
    return bool(margin <= min(bodies.properties[i, MIN_EXTENT], bodies.properties[j, MIN_EXTENT]))


def opening_speed(n: int, i: int, j: int, bodies: Bodies, manifold: Array) -> float:
    """Return how fast the gap of a point opens, m/s."""
    return opening(n, i, j, VX, bodies, manifold)


def opening(n: int, i: int, j: int, first: int, bodies: Bodies, manifold: Array) -> float:
    """Return how fast the gap of a point opens, m/s; or how far, m, where `first` is `DX`."""
    x, y = manifold[PX + n * POINT], manifold[PY + n * POINT]
    span_x, span_y = bodies.pose[j, X] - bodies.pose[i, X], bodies.pose[j, Y] - bodies.pose[i, Y]
    normal, a, b = (manifold[NX], manifold[NY]), bodies.motion[i], bodies.motion[j]
    return row_velocity(
        (a[first], a[first + 1]), a[first + 2], turning_arm((x, y), normal),
        (b[first], b[first + 1]), b[first + 2],
        turning_arm((x - span_x, y - span_y), normal), normal,
    )  # fmt: skip


@inlined
def speculative_margins(
    i: int,
    j: int,
    s: int,
    t: int,
    smaller: float,
    touched: bool,
    fall: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
) -> tuple[float, float]:
    """Return below which gap two shapes, of the bodies i and j, have a contact, m.

    It follows the motion of a step, and is 0 for a fast pair. The second number is how much farther
    off the other end of such a contact may be: it falls, m, and bodies turn about where they touch.
    """
    motion, time_step = bodies.motion, control.progress[PART_TIME]
    speed = abs(motion[j, VX] - motion[i, VX]) + abs(motion[j, VY] - motion[i, VY])
    turning = 0.0
    if shapes.vertex_count[s] > 1:
        turning += abs(motion[i, SPIN]) * shapes.material[s, SHAPE_RADIUS]
    if shapes.vertex_count[t] > 1:
        turning += abs(motion[j, SPIN]) * shapes.material[t, SHAPE_RADIUS]
    fast = (speed + turning) * time_step > BULLET * smaller
    fast = unless_joined(fast, i, j, bodies)
    if fast:
        return 0.0, 0.0
    extent = smaller
    if max(shapes.kind[s], shapes.kind[t]) < PIECE:  # near pieces tell a thin shape its side
        extent = contact_extent(i, j, smaller, BETWEEN, bodies)
    margin = CLOSE * extent + (speed + turning if touched else speed) * time_step
    if (shapes.kind[s] == DISC) | (shapes.kind[t] == DISC):
        return margin, 0.0
    return margin, fall + (0.0 if touched else turning * time_step)


@inlined
def mark_sensor(count: int, manifold: Array, flags: Integers) -> None:
    """Mark a contact with a sensor as touching if the shapes overlap."""
    if manifold[GAP] <= 0.0 or (count == 2 and manifold[GAP + POINT] <= 0.0):
        flags[TOUCHES] |= IS_TOUCHING
