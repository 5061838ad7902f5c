"""What bodies that joints hold meet unforeseen, since they were struck within a part of a step.

They have no impacts in flight: what they meet has to be foreseen as a part begins. Where one is
struck, and goes on into something else, the part is taken again as shorter ones.
Cost: a visit to each contact of the list, and the time of impact of those that may meet.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.bounds import path_length
from tamias2d.engine.continuous.event_loop import may_retake
from tamias2d.engine.continuous.events import THIN, allowed_depth, event_on_path, relative_motion
from tamias2d.engine.continuous.passing import keep_away, smaller_radius
from tamias2d.engine.joined import is_held
from tamias2d.engine.parts import LIMIT
from tamias2d.engine.tables import Contacts, World

SHALLOWER = 0.2  # of that depth: how far one may go into a wall


def meets_unforeseen(again: bool, world: World, contacts: Contacts) -> bool:
    """Return whether a part is taken again: also where a held body goes into another, unseen."""
    if world.joints.counts[tb.MECHANISMS_AWAKE] == 0:
        return again
    found = again
    for p in range(world.broad_phase.counts[tb.CONTACTS]):
        if contacts.flags[p, tb.POINT_COUNT] == 0 and contacts.flags[p, tb.SENSES] == 0:
            found = found or goes_in(p, world, contacts)
    return found


def goes_in(p: int, world: World, contacts: Contacts) -> bool:
    """Return whether two shapes without a contact go into each other, and less in shorter parts."""
    bodies, shapes = world.bodies, world.shapes
    pair = contacts.pairs[p]
    s, t, i, j = pair[0], pair[1], pair[tb.SLOT_A], pair[tb.SLOT_B]
    if not (is_held(i, bodies) or is_held(j, bodies)):
        return False
    reach = smaller_radius(s, t, shapes.material)
    deep = max(LIMIT * allowed_depth(i, j, reach, bodies.properties), THIN * reach)
    if bodies.kind[i] != tb.DYNAMIC or bodies.kind[j] != tb.DYNAMIC:
        deep *= SHALLOWER
    way = path_length(i, bodies.motion, bodies.properties)
    way += path_length(j, bodies.motion, bodies.properties)
    if way <= deep or keep_away(s, t, 0.0, bodies, shapes):
        return False
    far = relative_motion(i, j, bodies)
    if not may_retake(far, deep, world.control):
        return False
    met = event_on_path(p, s, t, 0.0, world.control, bodies, shapes, contacts, world.events)
    return bool((1.0 - met) * far > deep)
