"""Contacts that come about in a part of a step because others change velocities.

A body that meets a floor is stopped, and one that follows it meets it there, though the gap between
them does not close as the part begins. Pairs are added that would meet if contacts took all of the
velocity from a body at which it approaches others; and one that stands on a corner gets its second
one, which a body that falls on it brings down. Cost: a pass over the list of pairs, where a
body approaches another one faster than gravity lets it.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.events import bounces
from tamias2d.engine.continuous.passing import smaller_radius
from tamias2d.engine.islands import both_sleep
from tamias2d.engine.narrow_phase.approach import opening_speed
from tamias2d.engine.narrow_phase.boxes import stays_far
from tamias2d.engine.narrow_phase.chain import BESIDE
from tamias2d.engine.narrow_phase.collide import collide
from tamias2d.engine.narrow_phase.margins import BULLET, relative_speeds, speculative_margins
from tamias2d.engine.narrow_phase.seams import joins_ground, level_contact
from tamias2d.engine.tables import Bodies, Contacts, Islands, Shapes, Touching, World

WIDE = 2.0  # bounding radii, within which points of contact are


def add_secondary_contacts(world: World, contacts: Contacts) -> bool:
    """Put pairs on the list of touching ones that others may drive together.

    Returns whether there are more pairs, or points.
    """
    bodies, touching = world.bodies, world.touching
    pull = abs(world.control.settings[tb.GRAVITY_X]) + abs(world.control.settings[tb.GRAVITY_Y])
    slow = 2.0 * world.control.progress[tb.PART_TIME] * pull
    if not note_approaches(slow, bodies, world.shapes, contacts, touching):
        return False
    added = more = 0
    for p in range(world.broad_phase.counts[tb.CONTACTS]):
        points = contacts.flags[p, tb.POINT_COUNT]
        if points < 2 and is_driven(p, contacts, touching, world.islands):
            if points == 1:
                if not touches_disc(p, contacts, world.shapes):
                    more += 1 if collide_driven(p, world, contacts) > 1 else 0
                    level_contact(p, 0.0, bodies, world.shapes, contacts, world.events.ground)
                continue
            found = meets_driven(p, world, contacts)
            contacts.flags[p, tb.LOCATED] = tb.SECONDARY if found else 0
            added += 1 if found else 0
    if added > 0:
        merge_secondary(added, contacts, touching, world.broad_phase.counts[tb.CONTACTS])
    return added + more > 0


def note_approaches(
    slow: float, bodies: Bodies, shapes: Shapes, contacts: Contacts, touching: Touching
) -> bool:
    """Note how fast each body approaches others that it touches or meets; tell whether one does.

    What is as slow as gravity makes bodies in a part does not count.
    """
    for i in range(len(bodies.kind)):
        touching.approach[i] = 0.0
    found = False
    for k in range(touching.counts[tb.TOUCHING]):
        p, i, j = touching.contact[k], touching.body_a[k], touching.body_b[k]
        speed, turning = relative_speeds(contacts.pairs[p], bodies, shapes)
        if speed + WIDE * turning <= slow:
            continue
        speed = -least_speed(p, i, j, bodies, contacts)
        if speed > slow:
            found = True
            for one in (i, j):
                if bodies.kind[one] == tb.DYNAMIC:
                    touching.approach[one] = max(touching.approach[one], speed)
    return found


def least_speed(p: int, i: int, j: int, bodies: Bodies, contacts: Contacts) -> float:
    """Return how fast the gaps of two bodies open, at the point where they do so least, m/s."""
    least = 0.0
    for n in range(contacts.flags[p, tb.POINT_COUNT]):
        least = min(least, opening_speed(n, i, j, bodies, contacts.manifolds[p]))
    return least


def is_driven(p: int, contacts: Contacts, touching: Touching, islands: Islands) -> bool:
    """Return whether contacts with others may drive two bodies together that are awake."""
    i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
    driven = touching.approach[i] + touching.approach[j] != 0.0
    return bool(driven and not both_sleep(i, j, islands))


def touches_disc(p: int, contacts: Contacts, shapes: Shapes) -> bool:
    """Return whether a contact is with a disc, which has no second corner."""
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    return bool((shapes.kind[s] == tb.DISC) | (shapes.kind[t] == tb.DISC))


def meets_driven(p: int, world: World, contacts: Contacts) -> bool:
    """Find the manifold of two bodies that contacts drive; return whether they may meet so.

    At a seam they do not.
    """
    bodies, shapes, touching = world.bodies, world.shapes, world.touching
    ground = world.events.ground
    i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
    driven, time = touching.approach[i] + touching.approach[j], world.control.progress[tb.PART_TIME]
    for n in range(collide_driven(p, world, contacts)):
        speed = opening_speed(n, i, j, bodies, contacts.manifolds[p]) - driven
        near = contacts.manifolds[p, tb.GAP + n * tb.POINT] + speed * time < 0.0
        if near and contacts.flags[p, tb.FEATURE] != BESIDE:
            if joins_ground(p, 0.0, bodies, shapes, contacts, ground):
                break
            level_contact(p, 0.0, bodies, shapes, contacts, ground)
            return True
    contacts.flags[p, tb.POINT_COUNT] = 0
    return False


def collide_driven(p: int, world: World, contacts: Contacts) -> int:
    """Find the points of two shapes that may touch if contacts drive their bodies.

    Returns how many there are; 0, and changes nothing, where they are too far apart or too fast.
    """
    bodies, shapes, touching = world.bodies, world.shapes, world.touching
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
    driven = world.control.progress[tb.PART_TIME] * (touching.approach[i] + touching.approach[j])
    if touching.counts[tb.BOXED] == 1 and stays_far(s, t, driven, contacts.flags[p], shapes.boxes):
        return 0
    if contacts.flags[p, tb.SENSES] == 1 or bounces(p, shapes, contacts):
        return 0
    reach = smaller_radius(s, t, shapes.material)
    touched = contacts.flags[p, tb.TOUCHES] != 0
    pair, time = contacts.pairs[p], world.control.progress[tb.PART_TIME]
    speeds = relative_speeds(pair, bodies, shapes)
    margin, _ = speculative_margins(pair, reach, touched, speeds, 0.0, time, bodies, shapes)
    if margin == 0.0 or margin + driven > BULLET * reach:
        return 0
    margin += driven
    x, y = bodies.pose[j, tb.X] - bodies.pose[i, tb.X], bodies.pose[j, tb.Y] - bodies.pose[i, tb.Y]
    radii = shapes.material[s, tb.SHAPE_RADIUS] + shapes.material[t, tb.SHAPE_RADIUS] + margin
    if x * x + y * y > radii * radii:
        return 0
    return collide(p, s, t, x, y, margin, shapes, contacts)


def merge_secondary(added: int, contacts: Contacts, touching: Touching, count: int) -> None:
    """Put the marked pairs at their places among those that touch, from the last one on."""
    k = touching.counts[tb.TOUCHING] - 1
    to = k + added
    touching.counts[tb.TOUCHING] += added
    for p in range(count - 1, -1, -1):
        if to == k:
            return
        marked = contacts.flags[p, tb.LOCATED] == tb.SECONDARY
        if marked:
            touching.contact[to] = p
            touching.body_a[to], touching.body_b[to] = (
                contacts.pairs[p, tb.SLOT_A],
                contacts.pairs[p, tb.SLOT_B],
            )
            to -= 1
        elif k >= 0 and touching.contact[k] == p:
            touching.contact[to] = p
            touching.body_a[to], touching.body_b[to] = touching.body_a[k], touching.body_b[k]
            k, to = k - 1, to - 1
