"""Contacts whose normals turn in a step, where loads vary (DD84).

The solver keeps the normals that contacts have as a part of a step begins. What a contact gives
late in it gets the direction of its instant, as the loads do. Cost: two visits to each contact in a
substep, and the manifolds at the end of those whose bodies move against each other.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.events import manifold_at
from tamias2d.engine.continuous.passing import smaller_radius, turn_shape_to
from tamias2d.engine.narrow_phase.polygon import held_normal
from tamias2d.engine.solver.blocks import lane_of, points_of
from tamias2d.engine.tables import Bodies, Contacts, World
from tamias2d.generated.contact_turning import (
    impulse_late_later,
    impulse_turned,
    velocity_a_after,
    velocity_b_after,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array, Vector

UNTURNED = 2.0**-20  # of the smaller radius: a way after which a normal is the same
TURNED_MOST = 0.25  # of a normal, in a part: beyond it another side has come up


@inlined
def add_late_impulses(stage: int, slab: int, world: World) -> None:
    """Add up the impulses of a slab at a stage of `take_stage`, by the share of the part gone.

    Where a substep begins they act as they are found; what relaxing changes acts as it ends.
    """
    constraints = world.constraints
    share = 1.0 / world.control.counts[tb.PART_SUBSTEPS]
    ends = stage == 2 * world.control.counts[tb.PART_SUBSTEPS]
    for b in range(constraints.slabs[slab, tb.S_BLOCK], constraints.slabs[slab + 1, tb.S_BLOCK]):
        row, late = constraints.blocks[b], constraints.late_impulses[b]
        if stage == 0:
            for m in range(LANES):
                late[m] = 0.0
        for n in range(constraints.lanes[b, tb.POINTS] if stage > 0 else 0):
            at = tb.SHARED + n * tb.POINT_SIZE
            weight = -share if stage % 2 == 1 else (stage // 2) * share
            add_lanes(weight, at + tb.P_NORMAL_IMPULSE, row, late)
            if ends:  # to which `late_impulse` adds the total with what restitution gives then
                add_lanes(-1.0, at + tb.P_TOTAL_IMPULSE, row, late)


@inlined
def add_lanes(share: float, at: int, row: Array, late: Array) -> None:
    """Add a share of a column to the late impulses of a block."""
    for m in range(LANES):
        late[m] = impulse_late_later(late[m], share, row[at + m])


def turn_contacts(world: World, contacts: Contacts) -> None:
    """Let the impulses of contacts follow their normals through a part, but for free islands."""
    bodies, touching = world.bodies, world.touching
    for k in range(touching.counts[tb.TOUCHING]):
        p, i, j = touching.contact[k], touching.body_a[k], touching.body_b[k]
        mover = i if bodies.kind[i] == tb.DYNAMIC else j
        known = contacts.manifolds[p, tb.FORESEEN] == 0.0
        if known and world.islands.held[mover] == 1:
            late = late_impulse(k, world)
            if late != 0.0 and turns(p, i, j, world, contacts):
                turn_contact(
                    i, j, late, contacts.manifolds[p], normal_at_end(p, world, contacts), bodies
                )


def late_impulse(k: int, world: World) -> float:
    """Return the late impulse of a touching contact, N s."""
    constraints = world.constraints
    b, m = lane_of(k, world.touching)
    late: float = constraints.late_impulses[b, m]
    for n in range(points_of(k, world.touching)):
        at = tb.SHARED + n * tb.POINT_SIZE + tb.P_TOTAL_IMPULSE
        late = impulse_late_later(late, 1.0, constraints.blocks[b, at + m])
    return late


def turns(p: int, i: int, j: int, world: World, contacts: Contacts) -> bool:
    """Return whether two bodies have moved against each other."""
    a, b = world.bodies.motion[i], world.bodies.motion[j]
    reach = smaller_radius(contacts.pairs[p, 0], contacts.pairs[p, 1], world.shapes.material)
    way = abs(b[tb.DX] - a[tb.DX]) + abs(b[tb.DY] - a[tb.DY])
    return bool(way + reach * (abs(a[tb.DANGLE]) + abs(b[tb.DANGLE])) > UNTURNED * reach)


def normal_at_end(p: int, world: World, contacts: Contacts) -> Vector:
    """Return the normal of a contact where its bodies are as the part ends."""
    bodies, shapes, events = world.bodies, world.shapes, world.events
    s, t, sign = contacts.pairs[p, 0], contacts.pairs[p, 1], 1.0
    if shapes.kind[t] == tb.HALF_PLANE:
        s, t, sign = t, s, -1.0
    held = held_normal(contacts.manifolds[p], contacts.flags[p])
    manifold_at(s, t, 1.0, held, bodies, shapes, events)
    turn_shape_to(s, shapes.slot[s], 0.0, bodies, shapes)
    turn_shape_to(t, shapes.slot[t], 0.0, bodies, shapes)
    return sign * events.scratch[0, tb.NX], sign * events.scratch[0, tb.NY]


def turn_contact(
    i: int, j: int, late: float, manifold: Array, later: Vector, bodies: Bodies
) -> None:
    """Give two bodies what the turning of their contact changes in its late impulse, N s."""
    normal = (manifold[tb.NX], manifold[tb.NY])
    x, y = later[0] - normal[0], later[1] - normal[1]
    if x * x + y * y > TURNED_MOST * TURNED_MOST:
        return
    changed = impulse_turned(late, normal, later)
    a, b, properties = bodies.motion[i], bodies.motion[j], bodies.properties
    a[tb.VX], a[tb.VY] = velocity_a_after(
        (a[tb.VX], a[tb.VY]), properties[i, tb.INVERSE_MASS], changed
    )
    b[tb.VX], b[tb.VY] = velocity_b_after(
        (b[tb.VX], b[tb.VY]), properties[j, tb.INVERSE_MASS], changed
    )
