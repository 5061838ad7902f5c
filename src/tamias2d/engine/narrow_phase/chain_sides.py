"""On which side of a chain a shape is: what touches a piece is on that side of those beside, too.

A piece by itself has no inside. A shape that lies a little too deep on one piece, by rounding or
because a soft step lets it, would come to the next one from behind, and pass. It is told its side
of all that follow. Where a corner sticks out by more than a right angle, what touches one of its
pieces may well be behind the other one, and is told nothing.

Cost: where there are chains, some visits to each contact.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.chain import BESIDE, known_side, seen_from, shows
from tamias2d.engine.narrow_phase.core import core_of
from tamias2d.engine.tables import Contacts, Integers, Shapes, Touching

NO_PIECE = -1
MOST_PIECES = 32  # that are told a side by one that is touched


def note_sides(
    again: bool, count: int, contacts: Contacts, shapes: Shapes, sides: Integers
) -> None:
    """Let the contacts with pieces that a shape touches, and with those beside, know its side.

    What is known stays so to the end of a step, where this is asked `again`. The sides of a shape
    are the first and the last piece that it touches from the right, and from the left, each plus 1.
    """
    if not has_chains(shapes):
        return
    for p in range(count):
        piece, other = piece_and_other(p, contacts, shapes)
        if piece >= 0:
            if not (again or keeps_side(contacts.flags[p])):
                contacts.flags[p, tb.KNOWN_SIDE] = 0
            for n in range(4):
                sides[other, n] = 0
    for p in range(count):
        piece, other = piece_and_other(p, contacts, shapes)
        if piece >= 0 and has_touched(contacts.flags[p]):
            note_touched(p, piece, sides[other], contacts, shapes)
    for p in range(count):
        piece, other = piece_and_other(p, contacts, shapes)
        if piece >= 0 and contacts.flags[p, tb.KNOWN_SIDE] == 0:
            tell_side(p, piece, sides[other], contacts, shapes)


def has_chains(shapes: Shapes) -> bool:
    """Return whether some shape is a piece of a chain."""
    highest = 0
    for s in range(len(shapes.kind)):
        highest = max(highest, shapes.kind[s])
    return bool(highest >= tb.PIECE)


def piece_and_other(p: int, contacts: Contacts, shapes: Shapes) -> tuple[int, int]:
    """Return the piece and the other shape of a contact, which has sides; `NO_PIECE` if there is
    no such piece, or one of them is a sensor, which has no side to be on."""
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    if shapes.kind[s] < tb.PIECE:
        s, t = t, s
    found = shapes.kind[s] >= tb.PIECE and shapes.vertex_count[t] > 1
    found = found and contacts.flags[p, tb.SENSES] == 0
    return (s if found else NO_PIECE), t


def has_touched(flags: Integers) -> bool:
    """Return whether the normal of a contact is that of one in the last step."""
    solved = flags[tb.POINT_COUNT] > 0 and flags[tb.FEATURE] != BESIDE
    return bool(solved or flags[tb.TOUCHES] & tb.MET_IN_FLIGHT > 0 or keeps_side(flags))


def keeps_side(flags: Integers) -> bool:
    """Return whether a contact knows its side that was left to continuous collision.

    It may end a step with a gap of 0, behind which is the other side, before it is found to meet.
    """
    return bool(flags[tb.KNOWN_SIDE] == 1 and flags[tb.LOCATED] > 0)


def note_located_sides(count: int, contacts: Contacts, shapes: Shapes, touching: Touching) -> None:
    """Let contacts that are left to continuous collision, and those beside, know their sides."""
    if touching.counts[tb.LOCATED_PAIRS] == 0 or not has_chains(shapes):
        return
    for p in range(count):
        piece, _ = piece_and_other(p, contacts, shapes)
        if piece >= 0 and contacts.flags[p, tb.LOCATED] > 0:
            note_located(p, piece, contacts, shapes)
    note_sides(True, count, contacts, shapes, touching.sides)


def note_located(p: int, piece: int, contacts: Contacts, shapes: Shapes) -> None:
    """Let a contact know the side on which its manifold is, if no flight leads past that.

    Round a corner that sticks out by more than a right angle, and round an end, one may.
    """
    flags = contacts.flags[p]
    if flags[tb.KNOWN_SIDE] == 1 or flags[tb.FEATURE] == BESIDE:
        return
    known = side_of_normal(p, piece, tb.NX, contacts, shapes)
    core, vertices = core_of(piece, shapes), shapes.world_vertices
    side = seen_from(0 if known == 1 else 1, piece, core, vertices, shapes)
    shown = shows(side.start_cosine, side.start_sine) and shows(side.end_cosine, side.end_sine)
    if known != 0 and shown:
        know_side(p, piece, known == 1, contacts, shapes)


def side_of_normal(p: int, piece: int, at: int, contacts: Contacts, shapes: Shapes) -> int:
    """Return the side of a piece to which a normal of a contact points, as `known_side` does.

    The normal stands in the manifold from some column on.
    """
    hx, hy = contacts.manifolds[p, at], contacts.manifolds[p, at + 1]
    if contacts.pairs[p, 0] != piece:
        hx, hy = -hx, -hy
    core, vertices = core_of(piece, shapes), shapes.world_vertices
    right = seen_from(0, piece, core, vertices, shapes)
    left = seen_from(1, piece, core, vertices, shapes)
    return known_side(hx, hy, right, left)


def note_touched(p: int, piece: int, sides: Integers, contacts: Contacts, shapes: Shapes) -> None:
    """Add the piece of a contact to those that its other shape touches from one side."""
    at = tb.IMPACT_NORMAL if contacts.flags[p, tb.POINT_COUNT] == 0 else tb.NX
    at = tb.SIDE_NORMAL if contacts.flags[p, tb.KNOWN_SIDE] == 1 else at
    known = side_of_normal(p, piece, at, contacts, shapes)
    if known == 0:
        return
    know_side(p, piece, known == 1, contacts, shapes)
    low, high = (tb.RIGHT_LOW, tb.RIGHT_HIGH) if known == 1 else (tb.LEFT_LOW, tb.LEFT_HIGH)
    if sides[low] > 0 and shapes.slot[sides[low] - 1] == shapes.slot[piece]:
        sides[low], sides[high] = min(sides[low], piece + 1), max(sides[high], piece + 1)
    else:
        sides[low] = sides[high] = piece + 1


def tell_side(p: int, piece: int, sides: Integers, contacts: Contacts, shapes: Shapes) -> None:
    """Let a contact know the side of its other shape if the pieces beside do, and only one side."""
    right = is_continued(piece, sides[tb.RIGHT_LOW] - 1, sides[tb.RIGHT_HIGH] - 1, 1.0, shapes)
    left = is_continued(piece, sides[tb.LEFT_LOW] - 1, sides[tb.LEFT_HIGH] - 1, -1.0, shapes)
    if right != left:
        know_side(p, piece, right, contacts, shapes)


def know_side(p: int, piece: int, right: bool, contacts: Contacts, shapes: Shapes) -> None:
    """Write down that the other shape of a contact is on the right side of a piece, or not."""
    sense = 1.0 if right == (contacts.pairs[p, 0] == piece) else -1.0
    v, manifold = shapes.first[piece], contacts.manifolds[p]
    manifold[tb.SIDE_NORMAL] = sense * shapes.world_vertices[v, 2]
    manifold[tb.SIDE_NORMAL + 1] = sense * shapes.world_vertices[v, 3]
    contacts.flags[p, tb.KNOWN_SIDE] = 1


def is_continued(piece: int, low: int, high: int, sense: float, shapes: Shapes) -> bool:
    """Return whether a piece goes on with the first or the last one that a shape touches.

    The sense is 1 on the right side and -1 on the left one.
    """
    if low < 0 or shapes.slot[low] != shapes.slot[piece]:
        return False
    if follows(piece, low, True, sense, shapes) or follows(piece, high, False, sense, shapes):
        return True
    return follows(piece, high, True, sense, shapes) or follows(piece, low, False, sense, shapes)


def follows(piece: int, start: int, ahead: bool, sense: float, shapes: Shapes) -> bool:
    """Return whether a piece comes after another one, or before it, round corners that show both.

    What comes after the next one is not behind the first, either.
    """
    at = start
    for count in range(MOST_PIECES):
        if at == piece:
            return True
        row = shapes.material[at]
        cosine, sine = (tb.END_COSINE, tb.END_SINE) if ahead else (tb.START_COSINE, tb.START_SINE)
        if not shows(row[cosine], sense * row[sine]):
            return False
        at = next_piece(at, shapes) if ahead else previous_piece(at, shapes)
        if count > 0 and not faces_alike(start, at, shapes):
            return False
    return False


def faces_alike(piece: int, other: int, shapes: Shapes) -> bool:
    """Return whether the sides of two pieces turn from each other by less than a right angle."""
    v, w, vertices = shapes.first[piece], shapes.first[other], shapes.world_vertices
    return bool(vertices[v, 2] * vertices[w, 2] + vertices[v, 3] * vertices[w, 3] > 0.0)


def previous_piece(piece: int, shapes: Shapes) -> int:
    """Return the piece before one, or the last one of a loop where it is the first."""
    if piece > 0 and shapes.slot[piece - 1] == shapes.slot[piece]:
        return piece - 1
    last = piece
    while last + 1 < len(shapes.slot) and shapes.slot[last + 1] == shapes.slot[piece]:
        last += 1
    return last


def next_piece(piece: int, shapes: Shapes) -> int:
    """Return the piece after one, or the first one of a loop where it is the last."""
    if piece + 1 < len(shapes.slot) and shapes.slot[piece + 1] == shapes.slot[piece]:
        return piece + 1
    first = piece
    while first > 0 and shapes.slot[first - 1] == shapes.slot[piece]:
        first -= 1
    return first
