"""Writing the contact log: what began or ceased to touch in each step of a call of many.

A pair of bodies may have several contacts, of which one ceases as another begins: so all contacts
of a pair are logged of which one changed. Cost: a pass over contacts; where some changed, those
that touch are compared with these.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.contact_list import current_contacts
from tamias2d.engine.tables import Contacts, World


def log_events(world: World) -> bool:
    """Log the events of the step that was taken last, if they are told; return whether they fit.

    If they do not, nothing of them is logged: whoever takes the steps looks at the contacts.
    """
    if world.control.counts[tb.EVENTS_TOLD] == 0:
        return True
    counts, contacts = world.log.counts, current_contacts(world.broad_phase, world.buffers)
    first, listed = counts[tb.LOGGED], world.broad_phase.counts[tb.CONTACTS]
    for p in range(listed):
        if has_changed(contacts.flags[p, tb.TOUCHES]):
            log_contact(p, contacts, world)
    last = counts[tb.LOGGED]
    if last == first:
        return True
    for p in range(listed if last <= tb.MOST_LOGGED else 0):
        touches = contacts.flags[p, tb.TOUCHES]
        stays = touches != 0 and not has_changed(touches)
        if stays and is_of_logged(p, first, last, contacts, world):
            log_contact(p, contacts, world)
    counts[tb.STEPS_LOGGED] += 1
    fits = counts[tb.LOGGED] <= tb.MOST_LOGGED
    if not fits:
        counts[tb.LOGGED], counts[tb.LOG_FULL] = first, 1
    return bool(fits)


def has_changed(touches: int) -> bool:
    """Return whether the bits of a contact tell other than those of the step before."""
    return bool((touches & tb.IS_TOUCHING == 0) != (touches & tb.WAS_TOUCHING == 0))


def is_of_logged(p: int, first: int, last: int, contacts: Contacts, world: World) -> bool:
    """Return whether a contact is of two bodies of which some rows of the log are."""
    pair = contacts.pairs[p]
    a, b = world.state.body_of_slot[pair[tb.SLOT_A]], world.state.body_of_slot[pair[tb.SLOT_B]]
    rows, k = world.log.rows, first
    while k < last and not (
        (rows[k, tb.LOG_A] == a and rows[k, tb.LOG_B] == b)
        or (rows[k, tb.LOG_A] == b and rows[k, tb.LOG_B] == a)
    ):
        k += 1
    return bool(k < last)


def log_contact(p: int, contacts: Contacts, world: World) -> None:
    """Log what is known of a contact, if there is room; count it in any case."""
    counts = world.log.counts
    counts[tb.LOGGED] += 1
    if counts[tb.LOGGED] <= tb.MOST_LOGGED:
        write_row(counts[tb.LOGGED] - 1, p, contacts, world)


def write_row(k: int, p: int, contacts: Contacts, world: World) -> None:
    """Write what is known of a contact to a row of the log."""
    row, manifold = world.log.rows[k], world.log.manifolds[k]
    flags, pair = contacts.flags[p], contacts.pairs[p]
    row[tb.LOG_STEP], row[tb.LOG_PLACE] = world.log.counts[tb.STEPS_LOGGED], p
    row[tb.LOG_A] = world.state.body_of_slot[pair[tb.SLOT_A]]
    row[tb.LOG_B] = world.state.body_of_slot[pair[tb.SLOT_B]]
    row[tb.LOG_TOUCHES], row[tb.LOG_POINTS] = flags[tb.TOUCHES], flags[tb.POINT_COUNT]
    row[tb.LOG_SENSES], row[tb.LOG_SPLIT] = flags[tb.SENSES], flags[tb.IN_PARTS]
    for n in range(tb.MANIFOLD):
        manifold[n] = contacts.manifolds[p, n]
    at = world.bodies.pose[pair[tb.SLOT_A]]
    manifold[tb.LOG_PLACE_A], manifold[tb.LOG_PLACE_A + 1] = at[tb.X], at[tb.Y]
