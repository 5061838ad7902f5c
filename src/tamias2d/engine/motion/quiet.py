"""Quiet steps: nothing is near anything else, so that bodies follow their closed forms (IM1, IM6).

Where all pairs are listed, a step in which none of them can come near is nothing but motion. Such
steps are taken one after another, until some pair may come near. They leave all that is known of
contacts as ordinary steps do, so that the bits of later ones are the same.
Cost: a pass over bodies, and one over pairs until one is near.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.all_pairs import list_holds_for_good
from tamias2d.engine.broad_phase.contact_list import current_contacts
from tamias2d.engine.joints.activity import clear_of_joints
from tamias2d.engine.motion.free import look_ahead
from tamias2d.engine.narrow_phase.chain_sides import has_chains
from tamias2d.engine.narrow_phase.collide import match_impulses
from tamias2d.engine.narrow_phase.half_plane import is_above
from tamias2d.engine.narrow_phase.margins import CLOSE
from tamias2d.engine.narrow_phase.touching import age_flags
from tamias2d.engine.reports.contact_log import log_events
from tamias2d.engine.state import is_valid_state
from tamias2d.engine.tables import Bodies, BodyState, Contacts, Control, Shapes, World
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array


def may_be_quiet(world: World) -> bool:
    """Return whether the next steps may be quiet if nothing touches: their list holds for good.

    Chains tell shapes on which side they are, sleep counts steps, and varying loads are put right.
    """
    counts = world.broad_phase.counts
    may = counts[tb.LIST_HOLDS] == 1 and counts[tb.NEXT_LEVEL] == 0
    may = may and world.islands.counts[tb.SLEEP_STEPS] == 0
    may = may and world.springs.counts[tb.SPRINGS] + world.control.counts[tb.LOADS_VARY] == 0
    may = clear_of_joints(may, world)
    return (
        may
        and list_holds_for_good(world.bodies, world.broad_phase)
        and not has_chains(world.shapes)
    )


def nothing_touches(world: World) -> bool:
    """Return whether no contact has points, as they were found last.

    That follows from what is saved, so that a restored world takes the same steps.
    """
    counts, listed = world.touching.counts, world.broad_phase.counts[tb.CONTACTS]
    if counts[tb.ARRANGED] == 1:
        return bool(counts[tb.TOUCHING] == 0)
    contacts = current_contacts(world.broad_phase, world.buffers)
    p = 0
    while p < listed and contacts.flags[p, tb.POINT_COUNT] == 0:
        p += 1
    return p == listed


def take_quiet_steps(world: World) -> bool:
    """Take the steps that are left while they are quiet; return whether the state is valid then."""
    control, bodies = world.control, world.bodies
    contacts = current_contacts(world.broad_phase, world.buffers)
    listed, steps = world.broad_phase.counts[tb.CONTACTS], control.counts[tb.STEPS_LEFT]
    taken = 0
    valid = logged = True
    while valid and logged and taken < steps:
        finite = look_ahead_of_all(control, bodies)
        time = control.settings[tb.TIME_STEP]
        if not (finite and all_far(listed, time, bodies, world.shapes, contacts)):
            break
        go_ahead(bodies)
        if taken < 2:  # that pairs have touched is known for as long
            age_all(listed, world.shapes, contacts)
        taken += 1
        if taken == 1:  # what touched ceases to, and then nothing happens
            logged = log_events(world)
        valid = all_valid(bodies)
    if taken > 0:
        note_quiet(taken, world)
        show_moved(world.state, bodies)
    return valid


@inlined
def look_ahead_of_all(control: Control, bodies: Bodies) -> bool:
    """Find the motion of all bodies if nothing is near any; return whether it is finite."""
    total = 0.0
    for i in range(len(bodies.kind)):
        ahead = bodies.ahead[i]
        if bodies.kind[i] >= tb.KINEMATIC:
            look_ahead(i, control, bodies)
            for n in range(3):
                total += abs(ahead[n]) + abs(ahead[tb.DX + n])
    return bool(total - total == 0.0)


@inlined
def all_far(listed: int, time: float, bodies: Bodies, shapes: Shapes, contacts: Contacts) -> bool:
    """Return whether no listed pair can come near in a step, s."""
    p = 0
    while p < listed and is_far(p, time, bodies, shapes, contacts):
        p += 1
    return p == listed


@inlined
def is_far(p: int, time: float, bodies: Bodies, shapes: Shapes, contacts: Contacts) -> bool:
    """Return whether two shapes have no points, and find none in a step, s, wherever they turn.

    They are farther apart than the margin within which points are sought, and than the way that
    they go.
    """
    pair = contacts.pairs[p]
    if contacts.flags[p, tb.POINT_COUNT] > 0:
        return False
    s, t, i, j = pair[0], pair[1], pair[tb.SLOT_A], pair[tb.SLOT_B]
    if shapes.kind[t] == tb.HALF_PLANE:
        s, t, i, j = t, s, j, i
    x, y = bodies.pose[j, tb.X] - bodies.pose[i, tb.X], bodies.pose[j, tb.Y] - bodies.pose[i, tb.Y]
    a, b = shapes.material[s, tb.SHAPE_RADIUS], shapes.material[t, tb.SHAPE_RADIUS]
    plane = shapes.kind[s] == tb.HALF_PLANE
    far = CLOSE * min(a, b) + relative_way(
        0.0 if plane or shapes.vertex_count[s] == 1 else a,
        0.0 if shapes.vertex_count[t] == 1 else b,
        time,
        bodies.motion[i],
        bodies.motion[j],
        bodies.ahead[i],
        bodies.ahead[j],
    )
    if plane:
        side = shapes.world_vertices[shapes.first[s]]
        return bodies.kind[i] == tb.STATIC and is_above(x, y, b, far, side)
    reach = a + b + far
    return bool(x * x + y * y > reach * reach)


@inlined
def relative_way(
    lever_a: float, lever_b: float, time: float, a: Array, b: Array, to_a: Array, to_b: Array
) -> float:
    """Return how far shapes may come together in a step, s, by their velocities or their ways."""
    speed = abs(b[tb.VX] - a[tb.VX]) + abs(b[tb.VY] - a[tb.VY])
    turning = lever_a * abs(a[tb.SPIN]) + lever_b * abs(b[tb.SPIN])
    way = abs(to_b[tb.DX] - to_a[tb.DX]) + abs(to_b[tb.DY] - to_a[tb.DY])
    return max((speed + turning) * time, way)


@inlined
def go_ahead(bodies: Bodies) -> None:
    """Let all bodies move on to where they are as the step ends."""
    for i in range(len(bodies.kind)):
        if bodies.kind[i] >= tb.KINEMATIC:
            for n in range(3):
                bodies.pose[i, n] += bodies.ahead[i, tb.DX + n]
                bodies.motion[i, n] = bodies.ahead[i, n]


@inlined
def all_valid(bodies: Bodies) -> bool:
    """Return whether no body moves too fast, or is too far away, for a next step."""
    valid = True
    for i in range(len(bodies.kind)):
        if bodies.kind[i] >= tb.KINEMATIC:
            radius = bodies.properties[i, tb.BOUNDING_RADIUS]
            valid = valid & is_valid_state(bodies.pose[i], bodies.motion[i], bodies.load[i], radius)
    return valid


@inlined
def age_all(listed: int, shapes: Shapes, contacts: Contacts) -> None:
    """Let what touched have done so before, and contacts with half-planes forget their points."""
    for p in range(listed):
        if is_known(p, contacts):
            age(p, shapes, contacts)


@inlined
def is_known(p: int, contacts: Contacts) -> bool:
    """Return whether something is known of a contact; of most pairs on the list there is not."""
    flags = contacts.flags[p]
    return bool(flags[tb.TOUCHES] + flags[tb.LOCATED] + flags[tb.FEATURE] != 0)


@inlined
def age(p: int, shapes: Shapes, contacts: Contacts) -> None:
    """Let a contact have touched before, if it did; points, and names of half-planes, are lost."""
    age_flags(False, contacts.flags[p])
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    plane = shapes.kind[s] == tb.HALF_PLANE or shapes.kind[t] == tb.HALF_PLANE
    named = plane and contacts.flags[p, tb.FEATURE] > 0
    if named or contacts.flags[p, tb.POINT_COUNT] > 0:
        match_impulses(contacts.manifolds[p], contacts.flags[p], 0, 0)


@inlined
def note_quiet(taken: int, world: World) -> None:
    """Note what ordinary steps do in which nothing touches."""
    counts, touching = world.control.counts, world.touching.counts
    counts[tb.STEPS_LEFT] -= taken
    counts[tb.STEPS_TAKEN] += taken
    counts[tb.FINEST] = 0
    world.broad_phase.counts[tb.STEPS_SINCE] += taken
    touching[tb.MEETING] = touching[tb.NEW_STATIC] = touching[tb.PRESSED_DEEP] = 0
    touching[tb.IMPULSES_UNKNOWN] = touching[tb.LOCATED_PAIRS] = 0


@inlined
def show_moved(state: BodyState, bodies: Bodies) -> None:
    """Show users where bodies are and how they move."""
    for i in range(len(state.body_of_slot)):
        if bodies.kind[i] >= tb.KINEMATIC:
            k = state.body_of_slot[i]
            for n in range(3):
                state.pose[k, n], state.velocity[k, n] = bodies.pose[i, n], bodies.motion[i, n]
