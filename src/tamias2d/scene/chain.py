"""Terrain: a line through many vertices, whose pieces know their neighbours (A16)."""

import math
from dataclasses import dataclass, field

from tamias2d.generated import terrain
from tamias2d.scene.crossings import crossings
from tamias2d.scene.rules import RuleError, Vector, checked_flag, sequence, vector
from tamias2d.suggestions import suggests

_OF = "a chain"
_REMEDY = "Give a list of points (x, y) in m, e.g. [(0, 0), (5, 1), (10, 0)]."

Corner = tuple[float, float]
"""Cosine and sine of the angle by which a chain turns left at a vertex (DD73)."""
FREE: Corner = (-1.0, 0.0)
"""The corner at an end that nothing adjoins: any direction away from the piece is a normal."""


@suggests
@dataclass(frozen=True, init=False)
class Chain:
    """A line through `vertices`, in m: hills, caves, the ground of a game, for static bodies.

    Kinematic bodies may have one, too: platforms that move, drums that turn.

    A `loop` goes on from the last vertex to the first. Bodies slide over inner vertices without
    catching on them. A chain is solid from both sides or, if it is `one_sided`, from its right
    side alone, seen along its vertices: ground goes from right to left, and a loop of which the
    outside is solid goes counter-clockwise. What comes from the other side passes, until it is
    more on the solid side than behind it. Vertices are in the axes of the body, whose position is
    their origin.
    """

    vertices: tuple[Vector, ...]
    loop: bool
    one_sided: bool
    corners: tuple[Corner, ...] = field(compare=False, repr=False)
    """At the start of each piece, and at the end of the last one."""

    def __init__(self, *, vertices: object, loop: bool = False, one_sided: bool = False) -> None:
        """Take two vertices or more, of a loop three.

        Raises:
            InputError: they are too few, one is no point or the same as the one before it, or two
                pieces cross (A16); the message names them.
        """
        loop, one_sided = checked_flag(loop, "loop", _OF), checked_flag(one_sided, "one_sided", _OF)
        points = _checked_vertices(vertices, 3 if loop else 2)
        _refuse_repeated(points, loop=loop)
        object.__setattr__(self, "vertices", points)
        object.__setattr__(self, "loop", loop)
        object.__setattr__(self, "one_sided", one_sided)
        _refuse_crossing(self.segments, loop=loop)
        object.__setattr__(self, "corners", tuple(_corners(self.segments, loop=loop)))

    @property
    def segments(self) -> tuple[tuple[Vector, Vector], ...]:
        """Both ends of each piece, in order, m."""
        following = (*self.vertices[1:], self.vertices[0])
        pairs = tuple(zip(self.vertices, following, strict=True))
        return pairs if self.loop else pairs[:-1]

    @property
    def bounding_radius(self) -> float:
        """The distance of the farthest vertex from the body's position, m."""
        return max(math.hypot(x, y) for x, y in self.vertices)

    @property
    def area(self) -> float:
        """None: it has no thickness."""
        return 0.0


@dataclass(frozen=True)
class Piece:
    """A piece of a chain as a shape of its own, about its middle."""

    core: tuple[Vector, Vector]
    """Both ends, m."""
    start: Corner
    end: Corner
    one_sided: bool

    rounding = 0.0
    area = 0.0

    @property
    def bounding_radius(self) -> float:
        """Half its length, m."""
        return math.dist(*self.core) / 2


def _checked_vertices(vertices: object, least: int) -> tuple[Vector, ...]:
    items = sequence(vertices, _OF, _REMEDY, at=("vertices",))
    if len(items) < least:
        what = "a chain that is a loop" if least == 3 else _OF
        raise RuleError(
            f"vertices of {what}: found {len(items)}: must be at least {least} (R4). {_REMEDY}",
            "vertices",
        )
    return tuple(
        vector(item, "vertex", _OF, _REMEDY, at=("vertices", k)) for k, item in enumerate(items)
    )


def _refuse_repeated(points: tuple[Vector, ...], *, loop: bool) -> None:
    """Refuse a vertex from which float64 cannot tell the one before it."""
    for k in range(0 if loop else 1, len(points)):
        length = math.dist(points[k - 1], points[k])
        if 0 < length * length < math.inf:
            continue
        (x, y), which = points[k], "last" if k == 0 else "one before it"
        why = "a loop closes by itself. Leave the last one out." if k == 0 else "Leave one out."
        found = "is too far from the" if length else "is the same as the"
        raise RuleError(
            f"vertices[{k}] ({x:g}, {y:g}) of {_OF}: {found} {which} (R4). {why}", "vertices", k
        )


def _refuse_crossing(segments: tuple[tuple[Vector, Vector], ...], *, loop: bool) -> None:
    """Refuse pieces with a common point that is no vertex of neighbours."""
    for a, b in crossings(segments, loop=loop):
        x, y = segments[b][0]
        raise RuleError(
            f"vertices[{b}] ({x:g}, {y:g}) of {_OF}: the piece that begins there meets the one "
            f"that begins at vertices[{a}]: pieces have no point in common but the vertices of "
            "neighbours (A16). Move one, or give two chains.",
            "vertices",
            b,
        )


def _corners(segments: tuple[tuple[Vector, Vector], ...], *, loop: bool) -> list[Corner]:
    """Return the corner at the start of each piece, and that at the end of the last one."""
    ways = []
    for (ax, ay), (bx, by) in segments:
        length = math.hypot(bx - ax, by - ay)
        ways.append(((bx - ax) / length, (by - ay) / length))
    turns = [
        (
            float(terrain.corner_cosine(before, way)),
            float(terrain.corner_sine(before, way)),
        )
        for before, way in zip((ways[-1], *ways), (*ways, ways[0]), strict=True)
    ]
    return turns if loop else [FREE, *turns[1:-1], FREE]
