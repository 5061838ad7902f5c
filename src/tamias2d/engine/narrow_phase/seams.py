"""Seams between static shapes that adjoin: what slides over them does not meet them.

A body that a static shape holds, its ground, meets no side of another one that stands no higher and
begins where the ground is, or ends; the ground goes on with that as far as it is level. Cost: some
passes over the touching contacts, if one of a body with a static shape is new.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.chain import STRAIGHT
from tamias2d.engine.narrow_phase.core import core_of
from tamias2d.engine.narrow_phase.separation import INFINITE
from tamias2d.engine.tables import Bodies, Contacts, Events, Shapes, Touching
from tamias2d.state import Array, Vector

LEVEL_WITHIN = 0.02  # of the body's bounding radius: how far off shapes are that count as level
SAME_WAY = 0.9  # cosine: a contact with such a normal is with the same side as that of the ground


def clear_grounds(bodies: Bodies, events: Events) -> None:
    """Let no body have a ground."""
    for i in range(len(bodies.kind)):
        events.ground[i, tb.G_SHAPE] = 0.0


def leave_seams_out(
    bodies: Bodies, shapes: Shapes, contacts: Contacts, touching: Touching, events: Events
) -> bool:
    """Note the ground of each body, and take seams off the list; return whether there were some."""
    if not some_end(bodies, shapes, contacts, touching):
        return False
    for loaded in (True, False):
        for k in range(touching.counts[tb.TOUCHING]):
            if is_with_static(k, bodies, touching):
                note_ground(touching.contact[k], loaded, bodies, shapes, contacts, events.ground)
    for k in range(touching.counts[tb.TOUCHING]):
        if is_with_static(k, bodies, touching):
            note_level_side(touching.contact[k], bodies, shapes, contacts, events.ground)
    before = touching.counts[tb.TOUCHING]
    while take_seams_off(bodies, shapes, contacts, touching, events):
        pass  # beyond the next shape may be another one
    return touching.counts[tb.TOUCHING] < before


def some_end(bodies: Bodies, shapes: Shapes, contacts: Contacts, touching: Touching) -> bool:
    """Return whether some body touches a static shape that is no half-plane."""
    for k in range(touching.counts[tb.TOUCHING]):
        if is_with_static(k, bodies, touching):
            s, t = contacts.pairs[touching.contact[k], 0], contacts.pairs[touching.contact[k], 1]
            if shapes.kind[s] != tb.HALF_PLANE and shapes.kind[t] != tb.HALF_PLANE:
                return True
    return False


def take_seams_off(
    bodies: Bodies, shapes: Shapes, contacts: Contacts, touching: Touching, events: Events
) -> bool:
    """Take seams with the grounds of bodies off the list; return whether there were some."""
    stay = 0
    for k in range(touching.counts[tb.TOUCHING]):
        p = touching.contact[k]
        if is_with_static(k, bodies, touching) and joins_ground(
            p, 0.0, bodies, shapes, contacts, events.ground
        ):
            contacts.flags[p, tb.POINT_COUNT] = 0
        else:
            touching.contact[stay] = p
            touching.body_a[stay], touching.body_b[stay] = touching.body_a[k], touching.body_b[k]
            stay += 1
    found = stay < touching.counts[tb.TOUCHING]
    touching.counts[tb.TOUCHING] = stay
    return found


def is_with_static(k: int, bodies: Bodies, touching: Touching) -> bool:
    """Return whether a touching contact is with a static body."""
    a, b = bodies.kind[touching.body_a[k]], bodies.kind[touching.body_b[k]]
    return bool((a == tb.STATIC) | (b == tb.STATIC))


def note_ground(
    p: int, loaded: bool, bodies: Bodies, shapes: Shapes, contacts: Contacts, ground: Array
) -> None:
    """Note the side of a static shape if it holds a body, and no other one is farther ahead.

    A side without a load, on which a body lies that has taken no step yet, counts if there is none.
    """
    manifold = contacts.manifolds[p]
    s, t, way = contacts.pairs[p, 0], contacts.pairs[p, 1], 1.0
    if bodies.kind[shapes.slot[t]] == tb.STATIC:
        s, t, way = t, s, -1.0
    i, j = shapes.slot[s], shapes.slot[t]
    still = (
        bodies.kind[i] == tb.STATIC
        and bodies.kind[j] == tb.DYNAMIC
        and shapes.kind[s] != tb.HALF_PLANE
    )
    if not still or not holds_body(s, loaded, manifold, contacts.flags[p, tb.POINT_COUNT], shapes):
        return
    if not loaded and ground[j, tb.G_SHAPE] > 0.0:
        return
    normal, motion = (way * manifold[tb.NX], way * manifold[tb.NY]), bodies.motion[j]
    for n in range(contacts.flags[p, tb.POINT_COUNT]):
        x, y = contact_place(p, n, 0.0, normal, bodies, shapes, contacts)
        ahead = motion[tb.VX] * (x - bodies.pose[j, tb.X]) + motion[tb.VY] * (
            y - bodies.pose[j, tb.Y]
        )
        if ground[j, tb.G_SHAPE] == 0.0 or ahead > ground[j, tb.G_AHEAD]:
            ground[j, tb.G_NX], ground[j, tb.G_NY] = normal
            ground[j, tb.G_HEIGHT] = normal[0] * x + normal[1] * y
            ground[j, tb.G_AHEAD], ground[j, tb.G_SHAPE] = ahead, s + 1.0
            ground[j, tb.G_LOW], ground[j, tb.G_HIGH] = level_part(s, t, bodies, shapes, ground)


def holds_body(s: int, loaded: bool, manifold: Array, count: int, shapes: Shapes) -> bool:
    """Return whether a contact had an impulse; or, without one, is close.

    One point does not hold a body that may lean on another shape, but on a chain.
    """
    if loaded:
        load = manifold[tb.NORMAL_IMPULSE] + (
            manifold[tb.NORMAL_IMPULSE + tb.POINT] if count == 2 else 0.0
        )
        return bool(load > 0.0)
    close = LEVEL_WITHIN * shapes.material[s, tb.SHAPE_RADIUS]
    if shapes.kind[s] >= tb.PIECE and count == 1:
        return bool(manifold[tb.GAP] < close)
    return bool(count == 2 and max(manifold[tb.GAP], manifold[tb.GAP + tb.POINT]) < close)


def contact_place(
    p: int,
    n: int,
    later: float,
    normal: Vector,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
) -> Vector:
    """Return where a point of a contact is on the static shape, m, with its normal."""
    i, manifold, at = shapes.slot[contacts.pairs[p, 0]], contacts.manifolds[p], tb.POINT * n
    half = 0.5 * manifold[tb.GAP + at]
    x = bodies.pose[i, tb.X] + later * bodies.motion[i, tb.VX] + manifold[tb.PX + at]
    y = bodies.pose[i, tb.Y] + later * bodies.motion[i, tb.VY] + manifold[tb.PY + at]
    return x - half * normal[0], y - half * normal[1]


def note_level_side(
    p: int, bodies: Bodies, shapes: Shapes, contacts: Contacts, ground: Array
) -> None:
    """Let the ground of a body go on with another static side on which it is."""
    s, t, way = contacts.pairs[p, 0], contacts.pairs[p, 1], 1.0
    if bodies.kind[shapes.slot[t]] == tb.STATIC:
        s, t, way = t, s, -1.0
    row, manifold = ground[shapes.slot[t]], contacts.manifolds[p]
    along = row[tb.G_NX] * way * manifold[tb.NX] + row[tb.G_NY] * way * manifold[tb.NY]
    if row[tb.G_SHAPE] > 0.0 and along > SAME_WAY and contacts.flags[p, tb.POINT_COUNT] > 0:
        extend_ground(s, t, bodies, shapes, ground)


def joins_ground(
    p: int, later: float, bodies: Bodies, shapes: Shapes, contacts: Contacts, ground: Array
) -> bool:
    """Return whether a contact is with the side of a static shape that joins a body's ground.

    If it is, the ground goes on with that. Its points are where they are `later`, s, at the
    velocities that the bodies have.
    """
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    way = 1.0
    if bodies.kind[shapes.slot[t]] == tb.STATIC:
        s, t, way = t, s, -1.0
    i, j = shapes.slot[s], shapes.slot[t]
    if ground[j, tb.G_SHAPE] == 0.0 or bodies.kind[i] != tb.STATIC or bodies.kind[j] != tb.DYNAMIC:
        return False
    normal = (way * contacts.manifolds[p, tb.NX], way * contacts.manifolds[p, tb.NY])
    for n in range(contacts.flags[p, tb.POINT_COUNT]):
        place = contact_place(p, n, later, normal, bodies, shapes, contacts)
        if not is_seam(s, t, place, normal, bodies, shapes, ground):
            return False
    extend_ground(s, t, bodies, shapes, ground)
    return True


def is_seam(
    s: int,
    t: int,
    place: Vector,
    normal: Vector,
    bodies: Bodies,
    shapes: Shapes,
    ground: Array,
) -> bool:
    """Return whether a body's shape t meets a static one s where that joins the body's ground."""
    row, slop = ground[shapes.slot[t]], LEVEL_WITHIN * shapes.material[t, tb.SHAPE_RADIUS]
    same = (
        row[tb.G_SHAPE] == s + 1.0 or row[tb.G_NX] * normal[0] + row[tb.G_NY] * normal[1] > SAME_WAY
    )
    if row[tb.G_SHAPE] == 0.0 or same or shapes.kind[s] == tb.HALF_PLANE:
        return False
    if shapes.kind[s] >= tb.PIECE and shapes.kind[int(row[tb.G_SHAPE]) - 1] >= tb.PIECE:
        return False  # pieces of chains know each other
    height = row[tb.G_NX] * place[0] + row[tb.G_NY] * place[1] - row[tb.G_HEIGHT]
    along = row[tb.G_NX] * place[1] - row[tb.G_NY] * place[0]
    reach = shapes.radius[s] + slop
    beside = abs(height) <= reach and row[tb.G_LOW] - reach <= along <= row[tb.G_HIGH] + reach
    return beside and stands_no_higher(s, slop, row, bodies, shapes)


def extend_ground(s: int, t: int, bodies: Bodies, shapes: Shapes, ground: Array) -> None:
    """Let the ground of a body, whose shape is t, go on with a static shape, where it is level."""
    row = ground[shapes.slot[t]]
    low, high = level_part(s, t, bodies, shapes, ground)
    row[tb.G_LOW], row[tb.G_HIGH] = min(row[tb.G_LOW], low), max(row[tb.G_HIGH], high)


def level_part(
    s: int, t: int, bodies: Bodies, shapes: Shapes, ground: Array
) -> tuple[float, float]:
    """Return from where to where along its ground a static shape is level with it, m.

    The first is larger than the second where it is nowhere.
    """
    row, slop = ground[shapes.slot[t]], LEVEL_WITHIN * shapes.material[t, tb.SHAPE_RADIUS]
    core, pose = core_of(s, shapes), bodies.pose[shapes.slot[s]]
    low, high = INFINITE, -INFINITE
    for k in range(core.first, core.first + core.vertex_count):
        x, y = pose[tb.X] + shapes.world_vertices[k, 0], pose[tb.Y] + shapes.world_vertices[k, 1]
        if abs(row[tb.G_NX] * x + row[tb.G_NY] * y + core.radius - row[tb.G_HEIGHT]) <= slop:
            along = row[tb.G_NX] * y - row[tb.G_NY] * x
            low, high = min(low, along), max(high, along)
    return low, high


def goes_on(
    s: int,
    t: int,
    place: Vector,
    normal: Vector,
    motion: Array,
    shapes: Shapes,
    ground: Array,
) -> bool:
    """Return whether a piece of a chain that a shape t meets goes on straight from its ground.

    What holds the body there, so that it hardly moves towards the ground, holds it here.
    """
    row, slop = ground[shapes.slot[t]], LEVEL_WITHIN * shapes.material[t, tb.SHAPE_RADIUS]
    other = row[tb.G_SHAPE] > 0.0 and row[tb.G_SHAPE] != s + 1.0
    if not other or shapes.kind[s] < tb.PIECE or shapes.kind[int(row[tb.G_SHAPE]) - 1] < tb.PIECE:
        return False
    height = row[tb.G_NX] * place[0] + row[tb.G_NY] * place[1]
    aside = row[tb.G_NX] * normal[1] - row[tb.G_NY] * normal[0]
    same_way = row[tb.G_NX] * normal[0] + row[tb.G_NY] * normal[1] > SAME_WAY
    rise = normal[0] * motion[tb.DX] + normal[1] * motion[tb.DY]
    level = abs(aside) <= STRAIGHT and abs(height - row[tb.G_HEIGHT]) <= slop
    return bool(same_way and level and rise >= -slop)


def stands_no_higher(s: int, slop: float, row: Array, bodies: Bodies, shapes: Shapes) -> bool:
    """Return whether a shape stands no higher than the ground of a body."""
    core, pose = core_of(s, shapes), bodies.pose[shapes.slot[s]]
    for k in range(core.first, core.first + core.vertex_count):
        x, y = pose[tb.X] + shapes.world_vertices[k, 0], pose[tb.Y] + shapes.world_vertices[k, 1]
        if row[tb.G_NX] * x + row[tb.G_NY] * y + core.radius > row[tb.G_HEIGHT] + slop:
            return False
    return True
