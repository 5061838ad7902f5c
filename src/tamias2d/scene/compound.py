"""Bodies of several shapes that move as one."""

import math
from dataclasses import dataclass, field, replace
from typing import TypeAlias, cast

import numpy as np

from tamias2d.generated import definitions
from tamias2d.scene.chain import Chain
from tamias2d.scene.rules import RuleError, Vector, number, sequence, shown, vector
from tamias2d.scene.shapes import Box, Capsule, Disc, HalfPlane, Polygon, Segment, Single
from tamias2d.scene.surface_values import optional_friction, optional_restitution
from tamias2d.suggestions import suggests

_LOST = 1e-3  # of a side, by which rounding may move one end against the other
_SINGLES = (Disc, Box, Polygon, Capsule, Segment)


@suggests
@dataclass(frozen=True, kw_only=True)
class Part:
    """One `shape` of a body: where its centre of mass is, m, and how it is turned, rad.

    It has the `restitution` and the `friction` of its body where it states none of its own.
    """

    shape: Single
    position: Vector = (0.0, 0.0)
    orientation: float = 0.0
    restitution: float | None = None
    friction: float | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.shape, _SINGLES):
            raise RuleError(
                f"shape of a part: found {shown(self.shape)}: must be of one piece and bounded "
                "(R4). Give a Disc, Box, Polygon, Capsule or Segment.",
                "shape",
            )
        position = vector(
            self.position, "position", "a part", "Give (x, y) in m.", at=("position",)
        )
        angle = number(
            self.orientation, "orientation", "a part", "Give it in rad.", at=("orientation",)
        )
        checked = {
            "position": position,
            "orientation": angle,
            "restitution": optional_restitution(self.restitution, "a part"),
            "friction": optional_friction(self.friction, "a part"),
        }
        for name, value in checked.items():
            object.__setattr__(self, name, value)

    @property
    def core(self) -> tuple[Vector, ...]:
        """The core of the shape where the part stands, m."""
        x, y = self.position
        if self.orientation == 0:  # what is not turned keeps all its bits
            return tuple((x + p, y + q) for p, q in self.shape.core)
        c, s = math.cos(self.orientation), math.sin(self.orientation)
        return tuple((x + (c * p - s * q), y + (s * p + c * q)) for p, q in self.shape.core)


@suggests
@dataclass(frozen=True, init=False)
class Compound:
    """Several shapes that are one body; they may overlap, and what they share counts twice.

    `parts` are as they were given, in any frame; `pieces` are the same about the common centre of
    mass, to which each counts by its area, or, where none has one, by its length (DD25).
    `centroid` is where that centre lies in the frame of the parts: a body put there stands where
    they were drawn.
    """

    parts: tuple[Part, ...]
    pieces: tuple[Part, ...] = field(compare=False, repr=False)
    centroid: Vector = field(compare=False, repr=False)

    def __init__(self, *, parts: object) -> None:
        """Take one part or more; raise `InputError` naming the one at fault."""
        given = _checked_parts(parts)
        with np.errstate(all="ignore"):
            center = definitions.position_compound(_shares(given), _columns(given))
        x, y = (float(value) for value in center)
        if not (math.isfinite(x) and math.isfinite(y)):
            raise RuleError(
                "parts of a compound: their centre of mass is not finite (R4). Give parts of a "
                "size that float64 can square.",
                "parts",
            )
        pieces = tuple(
            replace(part, position=(part.position[0] - x, part.position[1] - y)) for part in given
        )
        for k, piece in enumerate(pieces):
            _refuse_lost_sides(piece, k)
        for name, value in (("parts", given), ("pieces", pieces), ("centroid", (x + 0.0, y + 0.0))):
            object.__setattr__(self, name, value)

    @property
    def bounding_radius(self) -> float:
        """The distance of the farthest point from the centre of mass, m."""
        return max(
            math.hypot(x, y) + piece.shape.rounding for piece in self.pieces for x, y in piece.core
        )

    @property
    def area(self) -> float:
        """The sum of the areas of the parts, m^2."""
        return sum(part.shape.area for part in self.parts)

    def inertia(self, mass: float) -> float:
        """Return the inertia about the centre of mass, kg m^2 (DD14, DD25)."""
        shares = _shares(self.pieces)
        with np.errstate(all="ignore"):
            masses = mass * (shares / shares.sum())
            own = np.array(
                [
                    piece.shape.inertia(float(share))
                    for piece, share in zip(self.pieces, masses, strict=True)
                ]
            )
            return float(definitions.inertia_compound(own, masses, _columns(self.pieces)))


Shape: TypeAlias = Single | HalfPlane | Compound | Chain
"""All shapes that a body can have."""


def pieces_of(shape: Single | Compound | Chain) -> tuple[Part, ...]:
    """Return the parts of a bounded shape about its centre: one, or those that it has."""
    if isinstance(shape, Chain):
        return tuple(_segment(*ends) for ends in shape.segments)
    return shape.pieces if isinstance(shape, Compound) else (Part(shape=shape),)


def _segment(start: Vector, end: Vector) -> Part:
    (ax, ay), (bx, by) = start, end
    return Part(
        shape=Segment(length=math.dist(start, end)),
        position=(ax / 2 + bx / 2, ay / 2 + by / 2),
        orientation=math.atan2(by - ay, bx - ax),
    )


def _checked_parts(parts: object) -> tuple[Part, ...]:
    remedy = "Give a list such as [Part(shape=Disc(radius=1.0), position=(0, 2))]."
    items = sequence(parts, "a compound", remedy, at=("parts",))
    if not items:
        raise RuleError(
            f"parts of a compound: found none: must be 1 or more (R4). {remedy}", "parts"
        )
    for k, item in enumerate(items):
        if not isinstance(item, Part):
            raise RuleError(
                f"parts[{k}] of a compound: found {shown(item)}: must be a Part (R4). {remedy}",
                "parts",
                k,
            )
    return cast("tuple[Part, ...]", items)


def _refuse_lost_sides(piece: Part, k: int) -> None:
    """Refuse a part whose sides rounding changes too much where it stands."""
    if piece.orientation == 0 and piece.position == (0, 0):
        return
    c, s = math.cos(piece.orientation), math.sin(piece.orientation)
    for (u, v), (x, y) in zip(_sides(piece.shape.core), _sides(piece.core), strict=True):
        if math.hypot(x - (c * u - s * v), y - (s * u + c * v)) > _LOST * math.hypot(u, v):
            raise RuleError(
                f"parts[{k}] of a compound: a side of {math.hypot(u, v):g} m is lost in rounding, "
                f"{math.hypot(*piece.position):g} m from the centre of mass (R4). Put the parts "
                "nearer together, or give this one longer sides.",
                *("parts", k),
            )


def _sides(core: tuple[Vector, ...]) -> list[Vector]:
    return [(x - p, y - q) for (p, q), (x, y) in zip(core, core[1:] + core[:1], strict=True)]


def _shares(parts: tuple[Part, ...]) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Return what each part counts: its area or, where none has one, its length."""
    areas = np.array([part.shape.area for part in parts])
    if areas.any():
        return areas
    return np.array([2 * part.shape.bounding_radius for part in parts])


def _columns(parts: tuple[Part, ...]) -> tuple[object, object]:
    x, y = np.array([part.position for part in parts]).T
    return x, y
