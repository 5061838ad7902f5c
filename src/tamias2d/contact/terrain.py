"""Which axes are normals of a piece of a chain: nothing catches on its neighbours (IM16)."""

from tamias2d.contact.core import Placed
from tamias2d.contact.gap import Axis
from tamias2d.generated.terrain import admitted, corner_room
from tamias2d.scene.chain import Piece
from tamias2d.state import Vector

_BESIDE = 1e-6  # sine: a direction that leans back by no more is beside the piece
_ROOM = 1e-9  # sine: a direction for which room is short by no more has it, but for rounding
_SAME = 1e-12  # sine: a direction that leans by no more is the normal of the piece


def normals(a: Placed, b: Placed, found: list[Axis]) -> list[Axis]:
    """Return those of the axes of a pair that touches which a piece of a chain admits.

    It admits none of a body beside it, that touches its neighbour. Of other pairs it is all.
    """
    for body, way in ((a, 1.0), (b, -1.0)):
        if (piece := body.core.piece) is None:
            continue
        return [axis for axis in found if _fits(piece, body, axis.separating_direction, way)]
    return found


def is_behind(a: Placed, b: Placed, normal: Vector) -> bool:
    """Return whether a normal from A to B is on the side from which a chain is not solid."""
    for body, way in ((a, 1.0), (b, -1.0)):
        if body.core.piece is not None and body.core.piece.one_sided:
            up, _ = _parts(body, normal, way)
            return up < -_BESIDE
    return False


def _fits(piece: Piece, body: Placed, direction: Vector, way: float) -> bool:
    up, along = _parts(body, direction, way)
    (start_cosine, start_sine), (end_cosine, end_sine) = piece.start, piece.end
    return _is_normal(up, along, piece.start, piece.end) or _is_normal(
        -up, -along, (end_cosine, -end_sine), (start_cosine, -start_sine)
    )


def _parts(body: Placed, direction: Vector, way: float) -> tuple[float, float]:
    """Return the parts of a direction along the normal of a piece and along the piece."""
    (nx, ny), (x, y) = body.turned(body.core.sides[0].normal), direction
    return way * (nx * x + ny * y), way * (nx * y - ny * x)


def _is_normal(up: float, along: float, start: Vector, end: Vector) -> bool:
    if abs(along) <= _SAME:
        return up > 0
    cosine, sine = start if along < 0 else end
    return bool(admitted(sine, corner_room(cosine, sine, up, abs(along)) + _ROOM))
