"""Contacts that are apart as a part of a step begins, and meet in it.

Where nothing else acts on two bodies that meet, or where they bounce and nothing holds them, their
impact is located: continuous collision finds its instant. All others are foreseen: the solver gets
the manifold that they have when they meet on the paths that they are on, with the gap that closes
until then, and treats them together with the contacts that touch.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.conservative_advancement import place_vertices, time_of_impact
from tamias2d.engine.continuous.events import bounces
from tamias2d.engine.continuous.passing import smaller_radius
from tamias2d.engine.continuous.secondary_contacts import add_secondary_contacts
from tamias2d.engine.continuous.trajectory import RelativePath
from tamias2d.engine.joined import unless_joined
from tamias2d.engine.narrow_phase.chain import BESIDE, judge
from tamias2d.engine.narrow_phase.chain_sides import note_located_sides
from tamias2d.engine.narrow_phase.collide import collide_cores, match_impulses
from tamias2d.engine.narrow_phase.core import Core, core_of, is_piece, is_thin
from tamias2d.engine.narrow_phase.manifold import smallest_gap
from tamias2d.engine.narrow_phase.margins import CLOSE
from tamias2d.engine.narrow_phase.polygon import held_normal
from tamias2d.engine.narrow_phase.reuse import NEVER
from tamias2d.engine.narrow_phase.seams import (
    clear_grounds,
    joins_ground,
    leave_seams_out,
    level_contact,
    some_lean,
)
from tamias2d.engine.tables import Bodies, Contacts, Control, Events, Shapes, Touching, World


def foresee(world: World, contacts: Contacts) -> None:
    """Leave lone impacts to continuous collision, and give the solver the others to come."""
    control, bodies, shapes = world.control, world.bodies, world.shapes
    touching, events = world.touching, world.events
    touching.counts[tb.LOCATED_PAIRS] = 0
    clear_grounds(bodies, events)
    asked = touching.counts[tb.NEW_STATIC] + control.counts[tb.GOES_FAR] > 0
    asked = asked or some_lean(bodies, shapes, contacts, touching)
    if asked and leave_seams_out(bodies, shapes, contacts, touching, events):
        touching.counts[tb.ARRANGED] = touching.counts[tb.ISLANDS_KNOWN] = 0
    if touching.counts[tb.MEETING] == 0:
        return
    changed = add_secondary_contacts(world, contacts)
    if changed:
        touching.counts[tb.IMPULSES_UNKNOWN] = 1
    count_contacts(bodies, shapes, contacts, touching)
    stay = 0
    for k in range(touching.counts[tb.TOUCHING]):
        p, i, j = touching.contact[k], touching.body_a[k], touching.body_b[k]
        comes, points = contacts.flags[p, tb.LOCATED], contacts.flags[p, tb.POINT_COUNT]
        meets, contacts.flags[p, tb.LOCATED] = comes == tb.MOST_LOCATED, 0
        if (
            comes == tb.SECONDARY
            and is_alone(i, bodies, touching)
            and is_alone(j, bodies, touching)
        ):
            contacts.flags[p, tb.POINT_COUNT] = 0  # what would drive it is located
            continue
        located = is_located(meets, p, i, j, bodies, shapes, contacts, touching)
        located = unless_joined(located, i, j, bodies)
        if located:
            contacts.flags[p, tb.LOCATED], contacts.flags[p, tb.POINT_COUNT] = tb.MOST_LOCATED, 0
            touching.counts[tb.LOCATED_PAIRS] += 1
        elif contacts.flags[p, tb.POINT_COUNT] > 0 and (
            not meets or foresee_contact(p, i, j, control, bodies, shapes, contacts, events)
        ):
            touching.contact[stay], touching.body_a[stay], touching.body_b[stay] = p, i, j
            stay += 1
            if meets and contacts.manifolds[p, tb.FORESEEN] > 0.0:
                touching.counts[tb.IMPULSES_UNKNOWN] = 1
            changed = changed or contacts.flags[p, tb.POINT_COUNT] != points
        else:
            contacts.flags[p, tb.POINT_COUNT] = 0
    note_located_sides(world.broad_phase.counts[tb.CONTACTS], contacts, shapes, touching)
    if changed or stay < touching.counts[tb.TOUCHING]:
        touching.counts[tb.TOUCHING] = stay
        touching.counts[tb.ARRANGED] = touching.counts[tb.ISLANDS_KNOWN] = 0


def count_contacts(bodies: Bodies, shapes: Shapes, contacts: Contacts, touching: Touching) -> None:
    """Count the contacts of each body that has some, those that hold it, and those to come.

    To come are those with what does not move freely that meet, or that others drive together. What
    holds bodies is counted only where some bounce.
    """
    near = touching.near
    some_bounce = False
    for k in range(touching.counts[tb.TOUCHING]):
        for n in range(3):
            near[touching.body_a[k], n] = near[touching.body_b[k], n] = 0
    for k in range(touching.counts[tb.TOUCHING]):
        p, a, b = touching.contact[k], touching.body_a[k], touching.body_b[k]
        comes = contacts.flags[p, tb.LOCATED] > 0 and bodies.kind[a] != bodies.kind[b]
        some_bounce = some_bounce or bounces(p, shapes, contacts)
        for i in (a, b):
            near[i, tb.ALL] += 1
            near[i, tb.COMING] += 1 if comes else 0
    for k in range(touching.counts[tb.TOUCHING] if some_bounce else 0):
        manifold = contacts.manifolds[touching.contact[k]]
        if manifold[tb.NORMAL_IMPULSE] + manifold[tb.NORMAL_IMPULSE + tb.POINT] > 0.0:
            near[touching.body_a[k], tb.HOLDING] += 1
            near[touching.body_b[k], tb.HOLDING] += 1


def is_located(
    meets: bool,
    p: int,
    i: int,
    j: int,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    touching: Touching,
) -> bool:
    """Return whether continuous collision finds the impact of two bodies.

    Where bodies bounce and nothing holds them, those that touch already may meet, too: one after
    the other they pass an impact on.
    """
    bouncing = bounces(p, shapes, contacts)
    if not (meets or bouncing):
        return False
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    gap = smallest_gap(contacts.manifolds[p], contacts.flags[p, tb.POINT_COUNT])
    a, b = core_of(s, shapes), core_of(t, shapes)
    if is_thin(a, b) and not gap > 0.0:
        return False  # behind a gap of 0 is the other side
    held = holds(i, bodies, touching) + holds(j, bodies, touching)
    if bouncing and held == 0:
        return gap > -CLOSE * smaller_radius(s, t, shapes.material)  # the solver parts others
    return meets and is_alone(i, bodies, touching) and is_alone(j, bodies, touching)


def holds(i: int, bodies: Bodies, touching: Touching) -> int:
    """Return how many contacts hold a body that moves freely."""
    return touching.near[i, tb.HOLDING] if bodies.kind[i] == tb.DYNAMIC else 0


def is_alone(i: int, bodies: Bodies, touching: Touching) -> bool:
    """Return whether a body has one contact, or none that is not to come, or does not move freely.

    Then an impact acts on it when it is on no path but its own.
    """
    near = touching.near[i]
    lone = (near[tb.ALL] == 1) | (near[tb.ALL] == near[tb.COMING])
    return bool((bodies.kind[i] != tb.DYNAMIC) | lone)


def foresee_contact(
    p: int,
    i: int,
    j: int,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    events: Events,
) -> bool:
    """Write the manifold of two shapes as they meet; return whether they do, or are close."""
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    time = control.progress[tb.PART_TIME]
    path = path_ahead(i, j, time, bodies)
    manifold, flags = contacts.manifolds[p], contacts.flags[p]
    held = held_normal(manifold, flags)
    at = time_of_impact(s, t, False, path, held, shapes, events)
    margin = CLOSE * min(shapes.material[s, tb.SHAPE_RADIUS], shapes.material[t, tb.SHAPE_RADIUS])
    if at > 1.0:
        near = smallest_gap(manifold, flags[tb.POINT_COUNT]) < margin
        return near and flags[tb.FEATURE] != BESIDE
    a, b, rows = core_of(s, shapes), core_of(t, shapes), events.scratch[1:]
    place_vertices(a, path.turn_a * at, shapes.world_vertices, 0, rows)
    place_vertices(b, path.turn_b * at, shapes.world_vertices, a.vertex_count, rows)
    placed_a = Core(a.kind, 0, a.vertex_count, a.radius, 0.0)
    placed_b = Core(b.kind, a.vertex_count, b.vertex_count, b.radius, 0.0)
    x, y = path.x + at * path.dx, path.y + at * path.dy
    margin += abs(path.dx) + abs(path.dy)  # an impact at one end brings the other one down
    first, second = collide_cores(manifold, placed_a, placed_b, x, y, margin, held, rows)
    if first > 0 and (is_piece(a) or is_piece(b)):
        verdict = judge(s, t, placed_a, placed_b, (x, y), margin, held, manifold, rows, shapes)
        if not verdict.stays:
            first, second = verdict.first, verdict.second
        if first == BESIDE:
            return False
    elif second > 0:
        manifold[tb.KNOWN_WAY] = NEVER
    manifold[tb.FORESEEN] = at * time
    found = match_impulses(manifold, flags, first, second) > 0
    if not found or joins_ground(p, at * time, bodies, shapes, contacts, events.ground):
        return False
    level_contact(p, at * time, bodies, shapes, contacts, events.ground)
    return True


def path_ahead(i: int, j: int, time: float, bodies: Bodies) -> RelativePath:
    """Return the path of body j as seen from i in a time, s, at the velocities that they have."""
    pose, motion = bodies.pose, bodies.motion
    return RelativePath(
        pose[j, tb.X] - pose[i, tb.X],
        pose[j, tb.Y] - pose[i, tb.Y],
        time * (motion[j, tb.VX] - motion[i, tb.VX]),
        time * (motion[j, tb.VY] - motion[i, tb.VY]),
        time * motion[i, tb.SPIN],
        time * motion[j, tb.SPIN],
    )
