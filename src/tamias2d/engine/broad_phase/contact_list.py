"""The list of pairs that may touch, with what is known of each.

Serves: the look around. Hides: that there are two lists, of which one is in use, and that one is
two runs, each sorted by the canonical ranks of its shapes: what follows does not depend on the
order in which bodies were added or found.
"""

from tamias2d.engine.tables import (
    ARRANGED,
    BUFFER,
    CONTACTS,
    FIRST_RUN,
    ISLANDS_KNOWN,
    MANIFOLD,
    POINT,
    POINT_COUNT,
    SLOT_A,
    SLOT_B,
    TOUCHES,
    BroadPhase,
    ContactBuffers,
    Contacts,
    Integers,
    Shapes,
    Touching,
)


def current_contacts(broad_phase: BroadPhase, buffers: ContactBuffers) -> Contacts:
    """Return the contacts in use."""
    return buffered(broad_phase.counts[BUFFER], buffers)


def buffered(side: int, buffers: ContactBuffers) -> Contacts:
    """Return the contacts of one of the buffers."""
    return Contacts(buffers.pairs[side], buffers.manifolds[side], buffers.flags[side])


def replace_contacts(
    total: int, shapes: Shapes, broad_phase: BroadPhase, buffers: ContactBuffers
) -> int:
    """Make the sorted pairs the list in use, with what is known of those that were on it.

    Those that touched and are near no more stay once, for what ends with them to be told. Returns
    how many there are; where there is no room for them, the list is as it was.
    """
    side = broad_phase.counts[BUFFER]
    contacts, following = buffered(side, buffers), buffered(1 - side, buffers)
    pair = contacts.pairs
    size = 0
    first, second = 0, broad_phase.counts[FIRST_RUN]  # heads of the two runs
    for p in range(total + 1):
        a, b = (
            (broad_phase.candidates[p, 0], broad_phase.candidates[p, 1])
            if p < total
            else (len(broad_phase.canonical[1]), 0)
        )
        known = False
        while True:
            from_first = first < broad_phase.counts[FIRST_RUN] and (
                second == broad_phase.counts[CONTACTS]
                or not comes_before(second, first, broad_phase.canonical, pair)
            )
            old = first if from_first else second
            if old == broad_phase.counts[CONTACTS]:
                break
            s, t = broad_phase.canonical[1, pair[old, 0]], broad_phase.canonical[1, pair[old, 1]]
            if s > a or (s == a and t > b):
                break
            first, second = (first + 1, second) if from_first else (first, second + 1)
            known = s == a and t == b
            if known or contacts.flags[old, TOUCHES] != 0:
                if size < len(pair):
                    copy_contact(old, contacts, following, size)
                size += 1
        if p == total:
            break
        if not known:
            if size < len(pair):
                begin_contact(
                    broad_phase.canonical[0, a],
                    broad_phase.canonical[0, b],
                    shapes,
                    following,
                    size,
                )
            size += 1
    if size <= len(pair):
        broad_phase.counts[BUFFER] = 1 - side
        broad_phase.counts[CONTACTS] = broad_phase.counts[FIRST_RUN] = size
        note_first_of_rank(broad_phase.canonical, following.pairs, size, broad_phase.first_of_rank)
    return size


def comes_before(p: int, q: int, canonical: Integers, pairs: Integers) -> bool:
    """Return whether a pair on the list is before another in canonical order."""
    s, t = canonical[1, pairs[p, 0]], canonical[1, pairs[q, 0]]
    return bool(s < t or (s == t and canonical[1, pairs[p, 1]] < canonical[1, pairs[q, 1]]))


def note_first_of_rank(canonical: Integers, pairs: Integers, size: int, starts: Integers) -> None:
    """Write where in the first run the pairs of each rank begin, and where it ends."""
    k = 0
    for rank in range(len(canonical[1]) + 1):
        while k < size and canonical[1, pairs[k, 0]] < rank:
            k += 1
        starts[rank] = k


def add_contacts(
    total: int, shapes: Shapes, broad_phase: BroadPhase, contacts: Contacts, touching: Touching
) -> bool:
    """Put sorted pairs into the second run that are on neither; return whether there was room.

    The list is two runs in canonical order: what was found when all looked around, and since.
    """
    new = keep_new_candidates(total, broad_phase, contacts)
    if broad_phase.counts[CONTACTS] + new > len(contacts.pairs):
        return False
    if new > 0:
        touching.counts[ARRANGED] = touching.counts[ISLANDS_KNOWN] = 0  # pairs have other places
    old, place = broad_phase.counts[CONTACTS] - 1, broad_phase.counts[CONTACTS] + new - 1
    broad_phase.counts[CONTACTS] += new
    while new > 0:  # from the end, so that each moves once
        a, b = broad_phase.candidates[new - 1, 0], broad_phase.candidates[new - 1, 1]
        if old >= broad_phase.counts[FIRST_RUN] and is_after(
            old, a, b, broad_phase.canonical, contacts.pairs
        ):
            copy_contact(old, contacts, contacts, place)
            old -= 1
        else:
            begin_contact(
                broad_phase.canonical[0, a], broad_phase.canonical[0, b], shapes, contacts, place
            )
            new -= 1
        place -= 1
    return True


def keep_new_candidates(total: int, broad_phase: BroadPhase, contacts: Contacts) -> int:
    """Keep those of the sorted pairs found that are not on the list; return how many."""
    new = 0
    second = broad_phase.counts[FIRST_RUN]
    for p in range(total):
        a, b = broad_phase.candidates[p, 0], broad_phase.candidates[p, 1]
        known = False
        for k in range(broad_phase.first_of_rank[a], broad_phase.first_of_rank[a + 1]):
            known = known | (broad_phase.canonical[1, contacts.pairs[k, 1]] == b)
        while second < broad_phase.counts[CONTACTS] and not is_after(
            second, a, b, broad_phase.canonical, contacts.pairs
        ):
            known = known | has_ranks(second, a, b, broad_phase.canonical, contacts.pairs)
            second += 1
        if not known:
            broad_phase.candidates[new, 0], broad_phase.candidates[new, 1] = a, b
            new += 1
    return new


def is_after(p: int, a: int, b: int, canonical: Integers, pairs: Integers) -> bool:
    """Return whether a pair on the list comes after one of these ranks."""
    s, t = canonical[1, pairs[p, 0]], canonical[1, pairs[p, 1]]
    return bool(s > a or (s == a and t > b))


def has_ranks(p: int, a: int, b: int, canonical: Integers, pairs: Integers) -> bool:
    """Return whether a pair on the list has these ranks."""
    return bool(canonical[1, pairs[p, 0]] == a and canonical[1, pairs[p, 1]] == b)


def copy_contact(old: int, contacts: Contacts, following: Contacts, new: int) -> None:
    """Copy a pair; what is known of how it touches, only if it does."""
    for k in range(4):
        following.pairs[new, k] = contacts.pairs[old, k]
    if contacts.flags[old, POINT_COUNT] > 0 or contacts.flags[old, TOUCHES] != 0:
        for k in range(POINT if contacts.flags[old, POINT_COUNT] == 1 else MANIFOLD):
            following.manifolds[new, k] = contacts.manifolds[old, k]
        for k in range(6):
            following.flags[new, k] = contacts.flags[old, k]
    else:
        clear_flags(new, following.flags)


def clear_flags(p: int, flags: Integers) -> None:
    """Let nothing be known of how a pair touches: without names, points have no impulses."""
    for k in range(6):
        flags[p, k] = 0


def begin_contact(s: int, t: int, shapes: Shapes, contacts: Contacts, new: int) -> None:
    """Begin a pair, which does not touch."""
    contacts.pairs[new, 0], contacts.pairs[new, 1] = s, t
    contacts.pairs[new, SLOT_A], contacts.pairs[new, SLOT_B] = shapes.slot[s], shapes.slot[t]
    clear_flags(new, contacts.flags)
