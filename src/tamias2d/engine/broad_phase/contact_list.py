"""The contact list: pairs of shapes that may touch, with what is known of each contact.

It is two runs, each sorted by the canonical ranks of its shapes: those found as the list was
rebuilt, and those added since. So no result depends on the order in which bodies were added or
found. The list stands in one of two buffers; a new one is made in the other. Cost: one merge.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import BroadPhase, ContactBuffers, Contacts, Integers, Shapes, Touching


def current_contacts(broad_phase: BroadPhase, buffers: ContactBuffers) -> Contacts:
    """Return the contacts in use."""
    return buffered(broad_phase.counts[tb.BUFFER], buffers)


def buffered(side: int, buffers: ContactBuffers) -> Contacts:
    """Return the contacts of one of the buffers."""
    return Contacts(
        buffers.pairs[side], buffers.manifolds[side], buffers.axes[side], buffers.flags[side]
    )


def replace_contacts(
    total: int, in_parts: bool, shapes: Shapes, broad_phase: BroadPhase, buffers: ContactBuffers
) -> int:
    """Make the sorted candidates the list in use, with what is known of those that were on it.

    A contact that touched and is no candidate any more stays once, so that its end is reported.
    Returns how many contacts there are; if there is no room for them, the list is as it was.
    """
    counts, rank = broad_phase.counts, broad_phase.canonical[tb.RANK]
    side = counts[tb.BUFFER]
    contacts, following = buffered(side, buffers), buffered(1 - side, buffers)
    pairs = contacts.pairs
    size = 0
    first, second = 0, counts[tb.FIRST_RUN]  # heads of the two runs
    for p in range(total + 1):
        a, b = (
            (broad_phase.candidates[p, 0], broad_phase.candidates[p, 1])
            if p < total
            else (len(rank), 0)
        )
        known = False
        while True:
            from_first = first < counts[tb.FIRST_RUN] and (
                second == counts[tb.CONTACTS] or not comes_before(second, first, rank, pairs)
            )
            old = first if from_first else second
            if old == counts[tb.CONTACTS] or is_after(old, a, b, rank, pairs):
                break
            first, second = (first + 1, second) if from_first else (first, second + 1)
            known = has_ranks(old, a, b, rank, pairs)
            if known or contacts.flags[old, tb.TOUCHES] != 0:
                if size < len(pairs):
                    copy_contact(old, in_parts, contacts, following, size)
                size += 1
        if p < total and not known:
            if size < len(pairs):
                begin_contact(a, b, shapes, broad_phase, following, size)
            size += 1
    if size <= len(pairs):
        counts[tb.BUFFER] = 1 - side
        counts[tb.CONTACTS] = counts[tb.FIRST_RUN] = size
        note_first_of_rank(rank, following.pairs, size, broad_phase.first_of_rank)
    return size


def comes_before(p: int, q: int, rank: Integers, pairs: Integers) -> bool:
    """Return whether a contact on the list is before another in canonical order."""
    s, t = rank[pairs[p, 0]], rank[pairs[q, 0]]
    return bool(s < t or (s == t and rank[pairs[p, 1]] < rank[pairs[q, 1]]))


def is_after(p: int, a: int, b: int, rank: Integers, pairs: Integers) -> bool:
    """Return whether a contact on the list comes after one of these ranks."""
    s, t = rank[pairs[p, 0]], rank[pairs[p, 1]]
    return bool(s > a or (s == a and t > b))


def has_ranks(p: int, a: int, b: int, rank: Integers, pairs: Integers) -> bool:
    """Return whether a contact on the list has these ranks."""
    return bool(rank[pairs[p, 0]] == a and rank[pairs[p, 1]] == b)


def note_first_of_rank(rank: Integers, pairs: Integers, size: int, starts: Integers) -> None:
    """Write where in the first run the contacts of each rank begin, and where the last ones end."""
    k = 0
    for r in range(len(rank) + 1):
        while k < size and rank[pairs[k, 0]] < r:
            k += 1
        starts[r] = k


def add_contacts(
    total: int,
    in_parts: bool,
    shapes: Shapes,
    broad_phase: BroadPhase,
    contacts: Contacts,
    touching: Touching,
) -> bool:
    """Merge the sorted candidates that are not on the list into its second run.

    Returns whether there was room for them.
    """
    counts, rank = broad_phase.counts, broad_phase.canonical[tb.RANK]
    new = keep_new_candidates(total, broad_phase, contacts)
    if counts[tb.CONTACTS] + new > len(contacts.pairs):
        return False
    old, place = counts[tb.CONTACTS] - 1, counts[tb.CONTACTS] + new - 1
    counts[tb.CONTACTS] += new
    while new > 0:  # from the end, so that each moves once
        a, b = broad_phase.candidates[new - 1, 0], broad_phase.candidates[new - 1, 1]
        if old >= counts[tb.FIRST_RUN] and is_after(old, a, b, rank, contacts.pairs):
            if contacts.flags[old, tb.POINT_COUNT] > 0:  # one that is arranged gets another place
                touching.counts[tb.ARRANGED] = touching.counts[tb.ISLANDS_KNOWN] = 0
            copy_contact(old, in_parts, contacts, contacts, place)
            old -= 1
        else:
            begin_contact(a, b, shapes, broad_phase, contacts, place)
            new -= 1
        place -= 1
    return True


def keep_new_candidates(total: int, broad_phase: BroadPhase, contacts: Contacts) -> int:
    """Keep the sorted candidates that are not on the list; return how many."""
    counts, rank = broad_phase.counts, broad_phase.canonical[tb.RANK]
    candidates, starts, pairs = broad_phase.candidates, broad_phase.first_of_rank, contacts.pairs
    new = 0
    second = counts[tb.FIRST_RUN]
    for p in range(total):
        a, b = candidates[p, 0], candidates[p, 1]
        known = False
        for k in range(starts[a], starts[a + 1]):
            known = known | (rank[pairs[k, 1]] == b)
        while second < counts[tb.CONTACTS] and not is_after(second, a, b, rank, pairs):
            known = known | has_ranks(second, a, b, rank, pairs)
            second += 1
        if not known:
            candidates[new, 0], candidates[new, 1] = a, b
            new += 1
    return new


def copy_contact(
    old: int, in_parts: bool, contacts: Contacts, following: Contacts, new: int
) -> None:
    """Copy a contact; its manifold only if it has points, touched, will, or knows its side.

    In a step in parts, and after an impact in flight, the columns of a second point tell of it. The
    cached axis is kept of all: to find those of a crowd costs more than all else here.
    """
    for k in range(4):
        following.pairs[new, k] = contacts.pairs[old, k]
        following.axes[new, k] = contacts.axes[old, k]
    touches = contacts.flags[old, tb.TOUCHES] + contacts.flags[old, tb.LOCATED] != 0
    points, known = contacts.flags[old, tb.POINT_COUNT], contacts.flags[old, tb.KNOWN_SIDE]
    if points > 0 or touches or known == 1:
        met = contacts.flags[old, tb.TOUCHES] >= tb.MET_IN_FLIGHT
        met = met or in_parts or contacts.flags[old, tb.IN_PARTS] == 1
        for k in range(tb.POINT if points == 1 and known == 0 and not met else tb.MANIFOLD):
            following.manifolds[new, k] = contacts.manifolds[old, k]
        for k in range(contacts.flags.shape[1]):
            following.flags[new, k] = contacts.flags[old, k]
    else:
        clear_flags(new, following.flags)
        for k in (tb.SENSES, tb.CACHED_AXIS, tb.CACHED_AXIS + 1):
            following.flags[new, k] = contacts.flags[old, k]


def begin_contact(
    a: int, b: int, shapes: Shapes, broad_phase: BroadPhase, contacts: Contacts, new: int
) -> None:
    """Begin a contact between the shapes of two ranks, which does not touch."""
    pair, shape_of_rank = contacts.pairs[new], broad_phase.canonical[tb.SHAPE_OF_RANK]
    pair[0], pair[1] = shape_of_rank[a], shape_of_rank[b]
    pair[tb.SLOT_A], pair[tb.SLOT_B] = shapes.slot[pair[0]], shapes.slot[pair[1]]
    clear_flags(new, contacts.flags)
    for k in range(4):
        contacts.axes[new, k] = 0.0
    sensors = shapes.filters[pair[0], tb.SENSOR] + shapes.filters[pair[1], tb.SENSOR]
    contacts.flags[new, tb.SENSES] = 1 if sensors > 0 else 0


def clear_flags(p: int, flags: Integers) -> None:
    """Let nothing be known of a contact: without features, points have no impulses."""
    for k in range(flags.shape[1]):
        flags[p, k] = 0
