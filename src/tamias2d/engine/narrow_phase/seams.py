"""Seams between static shapes that adjoin: what slides over them does not meet them.

A side of a static shape that a body is on, its ground, goes on with others that adjoin it as far as
they are level. The body meets no side of such a one that stands no higher, and where one has a
corner in level ground, its normal is that of the ground. Cost: a pass over the touching contacts,
and some more if one of a body with a static shape is new, or leans over a corner.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.chain import SAME, STRAIGHT
from tamias2d.engine.narrow_phase.clip import PARALLEL
from tamias2d.engine.narrow_phase.core import core_of
from tamias2d.engine.narrow_phase.manifold import smallest_gap
from tamias2d.engine.narrow_phase.separation import INFINITE
from tamias2d.engine.tables import Bodies, Contacts, Events, Shapes, Touching
from tamias2d.state import Array, Vector

LEVEL_WITHIN = 0.02  # of the body's bounding radius: how far off shapes are that count as level
HARDLY = 2.0**-7  # of that: how far a body that its ground holds comes nearer to it in a part
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
    for k in range(touching.counts[tb.TOUCHING]):
        if is_with_static(k, bodies, touching):
            level_contact(touching.contact[k], 0.0, bodies, shapes, contacts, events.ground)
    before = touching.counts[tb.TOUCHING]
    while take_seams_off(bodies, shapes, contacts, touching, events):
        pass  # beyond the next shape may be another one
    return touching.counts[tb.TOUCHING] < before


def some_lean(bodies: Bodies, shapes: Shapes, contacts: Contacts, touching: Touching) -> bool:
    """Return whether some body touches a corner of a static shape, which may be in its ground."""
    for k in range(touching.counts[tb.TOUCHING]):
        if is_with_static(k, bodies, touching):
            p = touching.contact[k]
            s, way = contacts.pairs[p, 0], 1.0
            if bodies.kind[shapes.slot[s]] != tb.STATIC:
                s, way = contacts.pairs[p, 1], -1.0
            normal = (way * contacts.manifolds[p, tb.NX], way * contacts.manifolds[p, tb.NY])
            if shapes.kind[s] < tb.PIECE and shapes.kind[s] != tb.HALF_PLANE:
                side = side_normal(s, normal, SAME, shapes)
                if side[0] == 0.0 and side[1] == 0.0:
                    return True
    return False


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
    j = shapes.slot[t]
    if not may_have_ground(s, t, bodies, shapes):
        return
    if not holds_body(s, t, loaded, manifold, contacts.flags[p, tb.POINT_COUNT], shapes):
        return
    if not loaded and ground[j, tb.G_SHAPE] > 0.0:
        return
    normal = side_normal(s, (way * manifold[tb.NX], way * manifold[tb.NY]), PARALLEL, shapes)
    if normal[0] == 0.0 and normal[1] == 0.0:
        return
    motion = bodies.motion[j]
    for n in range(contacts.flags[p, tb.POINT_COUNT]):
        x, y = contact_place(p, n, 0.0, normal, bodies, shapes, contacts)
        ahead = motion[tb.VX] * (x - bodies.pose[j, tb.X]) + motion[tb.VY] * (
            y - bodies.pose[j, tb.Y]
        )
        if ground[j, tb.G_SHAPE] == 0.0 or ahead > ground[j, tb.G_AHEAD]:
            begin_ground(s, t, ahead, (x, y), normal, bodies, shapes, ground)


def begin_ground(
    s: int,
    t: int,
    ahead: float,
    place: Vector,
    normal: Vector,
    bodies: Bodies,
    shapes: Shapes,
    ground: Array,
) -> None:
    """Let the ground of a body, whose shape is t, be a side of a static shape through a place."""
    row = ground[shapes.slot[t]]
    row[tb.G_NX], row[tb.G_NY] = normal
    row[tb.G_HEIGHT] = normal[0] * place[0] + normal[1] * place[1]
    row[tb.G_AHEAD], row[tb.G_SHAPE] = ahead, s + 1.0
    row[tb.G_LOW], row[tb.G_HIGH] = level_part(s, t, bodies, shapes, ground)


def may_have_ground(s: int, t: int, bodies: Bodies, shapes: Shapes) -> bool:
    """Return whether a shape is static and has ends, and the body of another moves freely."""
    i, j = shapes.slot[s], shapes.slot[t]
    return bool(
        (bodies.kind[i] == tb.STATIC)
        & (bodies.kind[j] == tb.DYNAMIC)
        & (shapes.kind[s] != tb.HALF_PLANE)
    )


def side_normal(s: int, direction: Vector, within: float, shapes: Shapes) -> Vector:
    """Return the normal of a side of a shape from which a direction leans little, (0, 0) if none.

    Within is the sine of how far it may lean.
    """
    core, vertices = core_of(s, shapes), shapes.world_vertices
    for k in range(core.first, core.first + core.vertex_count if core.vertex_count > 1 else 0):
        nx, ny = vertices[k, 2], vertices[k, 3]
        lean = nx * direction[1] - ny * direction[0]
        if abs(lean) <= within and nx * direction[0] + ny * direction[1] > 0.0:
            return nx, ny
    return 0.0, 0.0


def holds_body(s: int, t: int, loaded: bool, manifold: Array, count: int, shapes: Shapes) -> bool:
    """Return whether a contact had an impulse; or, without one, with a chain, is close."""
    if loaded:
        load = manifold[tb.NORMAL_IMPULSE] + (
            manifold[tb.NORMAL_IMPULSE + tb.POINT] if count == 2 else 0.0
        )
        return bool(load > 0.0)
    close = LEVEL_WITHIN * shapes.material[t, tb.SHAPE_RADIUS]
    return bool(shapes.kind[s] < tb.PIECE or smallest_gap(manifold, count) < close)


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


def note_met_ground(
    s: int,
    t: int,
    place: Vector,
    normal: Vector,
    bodies: Bodies,
    shapes: Shapes,
    ground: Array,
) -> None:
    """Let the side of a static shape that a body meets in flight be its ground if it has none."""
    if not may_have_ground(s, t, bodies, shapes) or ground[shapes.slot[t], tb.G_SHAPE] > 0.0:
        return
    side = side_normal(s, normal, SAME, shapes)
    if side[0] != 0.0 or side[1] != 0.0:
        begin_ground(s, t, 0.0, place, side, bodies, shapes, ground)


def level_contact(
    p: int, later: float, bodies: Bodies, shapes: Shapes, contacts: Contacts, ground: Array
) -> None:
    """Level a contact whose bodies are where they are `later`, s, at the velocities they have."""
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    pose, motion = bodies.pose[shapes.slot[s]], bodies.motion[shapes.slot[s]]
    at = (pose[tb.X] + later * motion[tb.VX], pose[tb.Y] + later * motion[tb.VY])
    count = contacts.flags[p, tb.POINT_COUNT]
    level_manifold(s, t, at, count, contacts.manifolds[p], bodies, shapes, ground)


def level_manifold(
    s: int,
    t: int,
    at: Vector,
    count: int,
    manifold: Array,
    bodies: Bodies,
    shapes: Shapes,
    ground: Array,
) -> None:
    """Let two shapes, one of which meets a corner in its level ground, meet that ground there.

    The first one's body is at some place, m. Points keep their places on the shape on that ground.
    """
    way = 1.0
    if bodies.kind[shapes.slot[t]] == tb.STATIC:
        s, t, way = t, s, -1.0
    nx, ny = way * manifold[tb.NX], way * manifold[tb.NY]
    if not is_in_level(s, t, (nx, ny), bodies, shapes, ground):
        return
    row, radius = ground[shapes.slot[t]], shapes.radius[t]
    for n in range(count):
        point = tb.POINT * n
        out = radius + 0.5 * manifold[tb.GAP + point]
        x, y = manifold[tb.PX + point] + out * nx, manifold[tb.PY + point] + out * ny
        height = row[tb.G_NX] * (at[0] + x) + row[tb.G_NY] * (at[1] + y) - row[tb.G_HEIGHT]
        gap = height - radius
        manifold[tb.PX + point] = x - (radius + 0.5 * gap) * row[tb.G_NX]
        manifold[tb.PY + point] = y - (radius + 0.5 * gap) * row[tb.G_NY]
        manifold[tb.GAP + point] = gap
    manifold[tb.NX], manifold[tb.NY] = way * row[tb.G_NX], way * row[tb.G_NY]


def is_in_level(
    s: int, t: int, normal: Vector, bodies: Bodies, shapes: Shapes, ground: Array
) -> bool:
    """Return whether a normal leans over an end of a static shape s where t's ground goes on."""
    row, slop = ground[shapes.slot[t]], LEVEL_WITHIN * shapes.material[t, tb.SHAPE_RADIUS]
    lean = row[tb.G_NX] * normal[1] - row[tb.G_NY] * normal[0]
    upward = row[tb.G_NX] * normal[0] + row[tb.G_NY] * normal[1] > SAME_WAY
    if row[tb.G_SHAPE] == 0.0 or not upward or lean == 0.0 or shapes.kind[s] >= tb.PIECE:
        return False
    if not may_have_ground(s, t, bodies, shapes):
        return False
    low, high = level_part(s, t, bodies, shapes, ground)
    beyond = row[tb.G_HIGH] - high if lean > 0.0 else low - row[tb.G_LOW]
    return bool(low <= high and beyond > slop) and stands_no_higher(s, slop, row, bodies, shapes)


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
    row, slop = ground[shapes.slot[t]], LEVEL_WITHIN * shapes.material[t, tb.SHAPE_RADIUS]
    low, high = level_part(s, t, bodies, shapes, ground)
    if low <= row[tb.G_HIGH] + slop and high >= row[tb.G_LOW] - slop:
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
    rise: float,
    shapes: Shapes,
    ground: Array,
) -> bool:
    """Return whether a piece of a chain that a shape t meets goes on straight from its ground.

    What holds the body there, so that the gap here hardly closes in a part, m, holds it here.
    """
    row, slop = ground[shapes.slot[t]], LEVEL_WITHIN * shapes.material[t, tb.SHAPE_RADIUS]
    other = row[tb.G_SHAPE] > 0.0 and row[tb.G_SHAPE] != s + 1.0
    if not other or shapes.kind[s] < tb.PIECE or shapes.kind[int(row[tb.G_SHAPE]) - 1] < tb.PIECE:
        return False
    height = row[tb.G_NX] * place[0] + row[tb.G_NY] * place[1]
    aside = row[tb.G_NX] * normal[1] - row[tb.G_NY] * normal[0]
    same_way = row[tb.G_NX] * normal[0] + row[tb.G_NY] * normal[1] > SAME_WAY
    level = abs(aside) <= STRAIGHT and abs(height - row[tb.G_HEIGHT]) <= slop
    return bool(same_way and level and rise >= -HARDLY * shapes.material[t, tb.SHAPE_RADIUS])


def stands_no_higher(s: int, slop: float, row: Array, bodies: Bodies, shapes: Shapes) -> bool:
    """Return whether a shape stands no higher than the ground of a body."""
    core, pose = core_of(s, shapes), bodies.pose[shapes.slot[s]]
    for k in range(core.first, core.first + core.vertex_count):
        x, y = pose[tb.X] + shapes.world_vertices[k, 0], pose[tb.Y] + shapes.world_vertices[k, 1]
        if row[tb.G_NX] * x + row[tb.G_NY] * y + core.radius > row[tb.G_HEIGHT] + slop:
            return False
    return True
