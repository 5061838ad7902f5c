"""What pairs that meet at one instant do to each other: all points that approach answer together.

One point alone rebounds in closed form (IM3, IM9). Several are solved one by one, in turns, until
no impulse changes: without restitution, then with it, and then with friction, which acts while the
bodies are closest (DD67). What forces press together again stays together for the rest of the step.
Source: Moreau (1988).
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.conservative_advancement import NEAR
from tamias2d.engine.continuous.gap_bound import UNBOUNDED
from tamias2d.engine.continuous.impulse import (
    ImpulseLine,
    change_paths,
    change_velocities,
    mass_along,
    path_speed_along,
    speed_along,
)
from tamias2d.engine.continuous.trajectory import relative_place
from tamias2d.engine.narrow_phase.material import mixed_material, mixed_surface_speed
from tamias2d.engine.tables import Bodies, Contacts, Events, Shapes
from tamias2d.generated import friction as frictional, impact as smooth
from tamias2d.generated.soft_contact import (
    limited_tangent_impulse,
    restitution_impulse,
    surface_slip,
)
from tamias2d.state import Array, Vector

MOST_VISITS = 256  # of each point
ONE_POINT = 2.0**-40  # share of a determinant: two points below it do the same
MOST_HOLDS = 32  # turns of normals and tangents where points are held
UNCHANGED = 2.0**-48  # of the largest impulse


def list_points(
    k: int, now: float, bodies: Bodies, shapes: Shapes, contacts: Contacts, events: Events
) -> None:
    """List the points of a pair whose manifold is in the scratch: two where both are as deep."""
    q, a, b = events.met[k, tb.MET_CONTACT], events.met[k, tb.MET_A], events.met[k, tb.MET_B]
    s, t, manifold = contacts.pairs[q, 0], contacts.pairs[q, 1], events.scratch[0]
    friction, restitution = mixed_material(s, t, shapes.material, shapes.pair_overrides)
    one, other = (s, t) if shapes.slot[s] == a else (t, s)
    normal = (manifold[tb.NX], manifold[tb.NY])
    running = mixed_surface_speed(one, other, normal, shapes)
    x, y = relative_place(a, b, now, bodies.pose, bodies.motion)
    far = abs(manifold[tb.PX + tb.POINT] - manifold[tb.PX]) + abs(
        manifold[tb.PY + tb.POINT] - manifold[tb.PY]
    )
    deepest = min(manifold[tb.GAP], manifold[tb.GAP + tb.POINT])
    for n in range(2):
        row, at = events.met_points[2 * k + n], n * tb.POINT
        for m in range(len(row)):
            row[m] = 0.0
        gap = manifold[tb.GAP + at]
        if gap < UNBOUNDED and (gap == deepest or gap - deepest <= NEAR * far):
            row[tb.M_ARM_A], row[tb.M_ARM_A + 1] = manifold[tb.PX + at], manifold[tb.PY + at]
            row[tb.M_ARM_B], row[tb.M_ARM_B + 1] = (
                manifold[tb.PX + at] - x,
                manifold[tb.PY + at] - y,
            )
            row[tb.M_NORMAL], row[tb.M_NORMAL + 1] = manifold[tb.NX], manifold[tb.NY]
            row[tb.M_FRICTION], row[tb.M_RESTITUTION] = friction, restitution
            row[tb.M_SURFACE_SPEED] = running


def rebound_at_points(
    count: int, now: float, time_step: float, bodies: Bodies, events: Events
) -> bool:
    """Let the listed pairs rebound at their points; return whether one of them approached."""
    left = 1.0 - now
    listed, approaching, one = note_points(count, left, time_step, bodies, events)
    if not approaching:
        return False
    if listed == 1:
        rebound_at_point(one, left, bodies, events)
    else:
        rebound_at_several(count, left, bodies, events)
    redirect_paths(count, now, time_step, bodies, events)
    for _ in range(MOST_HOLDS):
        if not hold_paths(count, now, time_step, bodies, events):
            break
        hold_velocities(count, bodies, events)
        if grip(count, now, time_step, bodies, events):
            break
    return True


def note_points(
    count: int, left: float, time_step: float, bodies: Bodies, events: Events
) -> tuple[int, bool, int]:
    """Note how fast bodies approach at all points.

    Returns how many points there are, whether bodies or their paths approach at one, and the last.
    """
    listed, found, last = 0, False, 0
    for r in range(2 * count):
        row = events.met_points[r]
        if is_point(row):
            line = line_of(r, False, events)
            speed = speed_along(line, left, bodies.motion, bodies.flight)
            row[tb.M_APPROACH] = min(speed, 0.0)
            found = found or min(speed, path_speed_along(line, time_step, bodies.motion)) < 0.0
            listed, last = listed + 1, r
    return listed, found, last


def is_point(row: Array) -> bool:
    """Return whether a row is of a point, which has a normal."""
    return bool((row[tb.M_NORMAL] != 0.0) | (row[tb.M_NORMAL + 1] != 0.0))


def line_of(r: int, tangent: bool, events: Events) -> ImpulseLine:
    """Return the line of the normal impulse at a point, or of that along the tangent."""
    row, a, b = events.met_points[r], events.met[r // 2, tb.MET_A], events.met[r // 2, tb.MET_B]
    x, y = row[tb.M_NORMAL], row[tb.M_NORMAL + 1]
    along = (-y, x) if tangent else (x, y)
    at_a, at_b = (row[tb.M_ARM_A], row[tb.M_ARM_A + 1]), (row[tb.M_ARM_B], row[tb.M_ARM_B + 1])
    return ImpulseLine(a, b, at_a, at_b, along)


def rebound_at_point(r: int, left: float, bodies: Bodies, events: Events) -> None:
    """Let two bodies rebound at one point, with friction if they have any (IM3, IM9)."""
    row, line = events.met_points[r], line_of(r, False, events)
    if row[tb.M_APPROACH] == 0.0:
        return
    a, b = bodies.properties[line.a], bodies.properties[line.b]
    mass_a, turn_a, mass_b, turn_b = (
        a[tb.INVERSE_MASS], a[tb.INVERSE_INERTIA], b[tb.INVERSE_MASS], b[tb.INVERSE_INERTIA]
    )  # fmt: skip
    speed, normal = row[tb.M_APPROACH], line.direction
    inverse = smooth.inverse_effective_mass(
        mass_a, turn_a, line.at_a, mass_b, turn_b, line.at_b, normal
    )
    row[tb.M_PUSH] = smooth.impulse(row[tb.M_RESTITUTION], speed, inverse)
    if row[tb.M_FRICTION] > 0.0:
        cross = frictional.cross_coupling(turn_a, line.at_a, turn_b, line.at_b, normal)
        sliding = frictional.inverse_sliding_mass(
            mass_a, turn_a, line.at_a, mass_b, turn_b, line.at_b, inverse
        )
        tangent = line_of(r, True, events)
        slip = slip_along(tangent, left, row, bodies)
        closest = frictional.tangential_velocity_closest(slip, cross, speed, inverse)
        sticking = frictional.sticking_impulse(closest, sliding)
        change = frictional.normal_change(cross, sticking, inverse)
        share = frictional.share(row[tb.M_FRICTION], row[tb.M_PUSH], sticking, change)
        row[tb.M_PUSH] = frictional.normal_impulse(row[tb.M_PUSH], share, change)
        row[tb.M_DRAG] = frictional.tangential_impulse(share, sticking)
        change_velocities(tangent, row[tb.M_DRAG], bodies.motion, bodies.properties)
    change_velocities(line, row[tb.M_PUSH], bodies.motion, bodies.properties)


def slip_along(tangent: ImpulseLine, left: float, row: Array, bodies: Bodies) -> float:
    """Return at which speed the surfaces slip at a point, m/s (DD97)."""
    speed = speed_along(tangent, left, bodies.motion, bodies.flight)
    return surface_slip(speed, row[tb.M_SURFACE_SPEED])


def rebound_at_several(count: int, left: float, bodies: Bodies, events: Events) -> None:
    """Let bodies rebound at several points.

    Friction acts on the velocities that bodies have when they are closest, and changes the normal
    impulses with it; what restitution adds does not change.
    """
    solve_points(count, left, 0.0, False, bodies, events)
    for r in range(2 * count):
        events.met_points[r, tb.M_BOUNCE] = -events.met_points[r, tb.M_PUSH]
    solve_points(count, left, 1.0, False, bodies, events)
    rough = 0.0
    for r in range(2 * count):
        row = events.met_points[r]
        row[tb.M_BOUNCE] += row[tb.M_PUSH]
        rough = max(rough, row[tb.M_FRICTION])
    if rough > 0.0:
        add_bounces(count, -1.0, bodies, events)
        solve_points(count, left, 0.0, True, bodies, events)
        add_bounces(count, 1.0, bodies, events)


def add_bounces(count: int, sense: float, bodies: Bodies, events: Events) -> None:
    """Apply what restitution adds, or take it away where the sense is negative."""
    for r in range(2 * count):
        impulse = sense * events.met_points[r, tb.M_BOUNCE]
        if impulse != 0.0:
            line = line_of(r, False, events)
            change_velocities(line, impulse, bodies.motion, bodies.properties)


def solve_points(
    count: int, left: float, bouncing: float, rough: bool, bodies: Bodies, events: Events
) -> None:
    """Solve all points that approached until no impulse changes.

    `bouncing` is the share of the restitution that they have; a rough one has friction, too.
    """
    for _ in range(MOST_VISITS):
        largest = change = 0.0
        for k in range(count):
            for r in range(2 * k, 2 * k + 2 if rough else 2 * k):
                if is_rough(events.met_points[r]):
                    change = max(change, drag_point(r, left, bodies, events))
            change = max(change, push_pair(k, left, bouncing, bodies, events))
            first, second = events.met_points[2 * k], events.met_points[2 * k + 1]
            largest = max(largest, first[tb.M_PUSH], second[tb.M_PUSH])
        if change <= UNCHANGED * largest:
            return


def is_rough(row: Array) -> bool:
    """Return whether friction acts at a point that has approached."""
    return bool((row[tb.M_APPROACH] < 0.0) & (row[tb.M_FRICTION] > 0.0))


def push_pair(k: int, left: float, bouncing: float, bodies: Bodies, events: Events) -> float:
    """Give the points of a pair their normal velocities; return how far impulses change, N s."""
    one, other = line_of(2 * k, False, events), line_of(2 * k + 1, False, events)
    first, second = events.met_points[2 * k], events.met_points[2 * k + 1]
    missing = -speed_along(one, left, bodies.motion, bodies.flight)
    also = -speed_along(other, left, bodies.motion, bodies.flight)
    missing -= bouncing * first[tb.M_RESTITUTION] * first[tb.M_APPROACH]
    also -= bouncing * second[tb.M_RESTITUTION] * second[tb.M_APPROACH]
    both = (first[tb.M_APPROACH] < 0.0, second[tb.M_APPROACH] < 0.0)
    by, by_other = solve_pair(k, tb.M_PUSH, both, (missing, also), bodies, events)
    change_velocities(one, by, bodies.motion, bodies.properties)
    change_velocities(other, by_other, bodies.motion, bodies.properties)
    return max(abs(by), abs(by_other))


def solve_pair(
    k: int, column: int, solved: tuple[bool, bool], missing: Vector, bodies: Bodies, events: Events
) -> Vector:
    """Give the points of a pair the speeds that they miss, m/s, by impulses in a column.

    None of them pulls: then a point has a larger speed. Returns how much is added to both, N s.
    """
    first, second = events.met_points[2 * k], events.met_points[2 * k + 1]
    x, y = first[column], second[column]
    one, other = line_of(2 * k, False, events), line_of(2 * k + 1, False, events)
    if solved[0] and solved[1]:
        a, b, c = couplings_of(one, other, bodies.properties)
        first[column], second[column] = pushes_of_two(
            a, b, c, a * x + b * y + missing[0], b * x + c * y + missing[1]
        )
    elif solved[0]:
        mass = mass_along(one, bodies.properties)
        first[column] = restitution_impulse(x, -missing[0], 0.0, 0.0, mass)
    elif solved[1]:
        mass = mass_along(other, bodies.properties)
        second[column] = restitution_impulse(y, -missing[1], 0.0, 0.0, mass)
    return first[column] - x, second[column] - y


def couplings_of(
    one: ImpulseLine, other: ImpulseLine, properties: Array
) -> tuple[float, float, float]:
    """Return how impulses along two lines of a pair change the speeds along both, 1/kg."""
    a, b = properties[one.a], properties[one.b]
    mixed = smooth.coupling(
        a[tb.INVERSE_MASS], a[tb.INVERSE_INERTIA],
        one.at_a, one.direction, other.at_a, other.direction,
    )  # fmt: skip
    mixed += smooth.coupling(
        b[tb.INVERSE_MASS], b[tb.INVERSE_INERTIA],
        one.at_b, one.direction, other.at_b, other.direction,
    )  # fmt: skip
    return 1.0 / mass_along(one, properties), mixed, 1.0 / mass_along(other, properties)


def pushes_of_two(a: float, b: float, c: float, p: float, q: float) -> Vector:
    """Return x and y, at least 0, of which a x + b y >= p and b x + c y >= q.

    Where one of these is larger, its unknown is 0. Two points that are as good as one are one.
    """
    whole = a * c - b * b
    if whole > ONE_POINT * a * c:
        x, y = (c * p - b * q) / whole, (a * q - b * p) / whole
        if x >= 0.0 and y >= 0.0:
            return x, y
    x, y = max(p / a, 0.0), max(q / c, 0.0)
    return (x, 0.0) if b * x >= q else (0.0, y)


def drag_point(r: int, left: float, bodies: Bodies, events: Events) -> float:
    """End the sliding of a point, as far as friction can; return by how much that changes, N s."""
    row, line = events.met_points[r], line_of(r, True, events)
    speed = slip_along(line, left, row, bodies)
    mass = mass_along(line, bodies.properties)
    after = limited_tangent_impulse(row[tb.M_DRAG], speed, mass, row[tb.M_FRICTION], row[tb.M_PUSH])
    change = after - row[tb.M_DRAG]
    change_velocities(line, change, bodies.motion, bodies.properties)
    row[tb.M_DRAG] = after
    return abs(change)


def redirect_paths(
    count: int, now: float, time_step: float, bodies: Bodies, events: Events
) -> None:
    """Redirect the paths of all bodies as the impulses did their velocities."""
    for r in range(2 * count):
        row = events.met_points[r]
        if row[tb.M_PUSH] != 0.0:
            line = line_of(r, False, events)
            change_paths(line, now, row[tb.M_PUSH] * time_step, bodies)
        if row[tb.M_DRAG] != 0.0:
            line = line_of(r, True, events)
            change_paths(line, now, row[tb.M_DRAG] * time_step, bodies)


def hold_paths(count: int, now: float, time_step: float, bodies: Bodies, events: Events) -> bool:
    """Let paths stay together that forces press together again; return whether some do."""
    pressed = False
    for _ in range(MOST_VISITS):
        largest = change = 0.0
        for k in range(count):
            one, other = line_of(2 * k, False, events), line_of(2 * k + 1, False, events)
            first, second = events.met_points[2 * k], events.met_points[2 * k + 1]
            missing = -path_speed_along(one, time_step, bodies.motion)
            also = -path_speed_along(other, time_step, bodies.motion)
            both = (is_point(first), is_point(second))
            by, by_other = solve_pair(k, tb.M_HELD, both, (missing, also), bodies, events)
            change_paths(one, now, by * time_step, bodies)
            change_paths(other, now, by_other * time_step, bodies)
            change = max(change, abs(by), abs(by_other))
            largest = max(largest, first[tb.M_HELD], second[tb.M_HELD])
        pressed = pressed or largest > 0.0
        if change <= UNCHANGED * largest:
            break
    return pressed


def hold_velocities(count: int, bodies: Bodies, events: Events) -> None:
    """Stop what forces give bodies by the end of the step at points whose paths are held."""
    for _ in range(MOST_VISITS):
        largest = change = 0.0
        for k in range(count):
            one, other = line_of(2 * k, False, events), line_of(2 * k + 1, False, events)
            first, second = events.met_points[2 * k], events.met_points[2 * k + 1]
            missing = -speed_along(one, 0.0, bodies.motion, bodies.flight)
            also = -speed_along(other, 0.0, bodies.motion, bodies.flight)
            both = (first[tb.M_HELD] > 0.0, second[tb.M_HELD] > 0.0)
            by, by_other = solve_pair(k, tb.M_LASTING, both, (missing, also), bodies, events)
            change_velocities(one, by, bodies.motion, bodies.properties)
            change_velocities(other, by_other, bodies.motion, bodies.properties)
            change = max(change, abs(by), abs(by_other))
            largest = max(largest, first[tb.M_LASTING], second[tb.M_LASTING])
        if change <= UNCHANGED * largest:
            return


def grip(count: int, now: float, time_step: float, bodies: Bodies, events: Events) -> bool:
    """Let friction act where points are held for the rest of the step; return whether it has."""
    settled = True
    for r in range(2 * count):
        row = events.met_points[r]
        if row[tb.M_LASTING] > 0.0 and row[tb.M_FRICTION] > 0.0:
            line, before = line_of(r, True, events), row[tb.M_GRIP]
            speed = slip_along(line, 0.0, row, bodies)
            mass = mass_along(line, bodies.properties)
            row[tb.M_GRIP] = limited_tangent_impulse(
                before, speed, mass, row[tb.M_FRICTION], row[tb.M_LASTING]
            )
            change_velocities(line, row[tb.M_GRIP] - before, bodies.motion, bodies.properties)
            change_paths(line, now, (row[tb.M_GRIP] - before) * time_step, bodies)
            settled = settled and abs(row[tb.M_GRIP] - before) <= UNCHANGED * row[tb.M_LASTING]
    return settled


def total_drag(k: int, events: Events) -> float:
    """Return what friction gave a pair along the tangent, N s."""
    first, second = events.met_points[2 * k], events.met_points[2 * k + 1]
    return float(first[tb.M_DRAG] + first[tb.M_GRIP] + second[tb.M_DRAG] + second[tb.M_GRIP])


def total_push(k: int, events: Events) -> tuple[float, Vector]:
    """Return the normal impulse of a pair, N s, and where it acts, from the centre of A, m."""
    first, second = events.met_points[2 * k], events.met_points[2 * k + 1]
    one, other = first[tb.M_PUSH] + first[tb.M_LASTING], second[tb.M_PUSH] + second[tb.M_LASTING]
    share = other / (one + other) if one + other > 0.0 else 0.0
    x = (1.0 - share) * first[tb.M_ARM_A] + share * second[tb.M_ARM_A]
    y = (1.0 - share) * first[tb.M_ARM_A + 1] + share * second[tb.M_ARM_A + 1]
    return one + other, (x, y)
