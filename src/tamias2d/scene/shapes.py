"""The shapes of one piece that a body can have; `compound` joins several.

Every shape is given about its centre of mass, which the body's position then puts into the world.
A shape is its `core`, corners in m (counter-clockwise where there are three), and all points no
farther from the core than its `rounding`, m. A shape knows the radius of the circle that holds it
at any orientation, its area, and its inertia by the formulas of the specification. A half-plane has
neither core nor area.
"""

import math
from dataclasses import dataclass, field
from typing import TypeAlias

import numpy as np

from tamias2d.float64 import EPSILON
from tamias2d.generated import definitions
from tamias2d.scene.outline import centred, checked_outline, edges
from tamias2d.scene.rules import RuleError, Vector, number, vector
from tamias2d.suggestions import suggests

_WRITTEN = 1e-3  # by which the length of a unit vector may differ that is written in decimals


@suggests
@dataclass(frozen=True, kw_only=True)
class Disc:
    """A solid disc of a `radius` in m."""

    radius: float

    def __post_init__(self) -> None:
        _set(self, radius=_length(self.radius, "radius", "a disc"))

    @property
    def vertices(self) -> tuple[Vector, ...]:
        """None: a disc has no corners."""
        return ()

    @property
    def core(self) -> tuple[Vector, ...]:
        """Its centre."""
        return ((0.0, 0.0),)

    @property
    def rounding(self) -> float:
        """The radius, m."""
        return self.radius

    @property
    def bounding_radius(self) -> float:
        """The radius, m."""
        return self.radius

    @property
    def area(self) -> float:
        """The area, m^2 (DD24)."""
        return float(definitions.area_disc(self.radius))

    def inertia(self, mass: float) -> float:
        """Return the inertia about the centre of mass, kg m^2 (DD14)."""
        return float(definitions.inertia_disc(mass, self.radius))


class _Corners:
    """What all shapes with corners have in common."""

    vertices: tuple[Vector, ...]

    @property
    def core(self) -> tuple[Vector, ...]:
        """The vertices."""
        return self.vertices

    @property
    def rounding(self) -> float:
        """None: the corners are sharp."""
        return 0.0

    @property
    def bounding_radius(self) -> float:
        """The distance of the farthest vertex from the centre of mass, m."""
        return max(math.hypot(x, y) for x, y in self.vertices)


@suggests
@dataclass(frozen=True, kw_only=True)
class Box(_Corners):
    """A solid rectangle of a `width` and a `height` in m, along its own axes."""

    width: float
    height: float
    vertices: tuple[Vector, ...] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        width = _length(self.width, "width", "a box")
        height = _length(self.height, "height", "a box")
        x, y = _half(width, "width", "a box"), _half(height, "height", "a box")
        _set(self, width=width, height=height, vertices=((-x, -y), (x, -y), (x, y), (-x, y)))

    @property
    def area(self) -> float:
        """The area, m^2 (DD24)."""
        return float(definitions.area_box(self.width, self.height))

    def inertia(self, mass: float) -> float:
        """Return the inertia about the centre of mass, kg m^2 (DD14)."""
        return float(definitions.inertia_box(mass, self.width, self.height))


@suggests
@dataclass(frozen=True, init=False)
class Polygon(_Corners):
    """A solid convex polygon.

    `outline` holds the vertices as they were given, in any frame and either sense; `vertices` are
    relative to the centroid and counter-clockwise. `centroid` is where that lies in the frame of
    the outline: a body put there stands where the outline was drawn.
    """

    outline: tuple[Vector, ...]
    vertices: tuple[Vector, ...] = field(compare=False, repr=False)
    centroid: Vector = field(compare=False, repr=False)

    def __init__(self, *, vertices: object) -> None:
        """Take at least three vertices; raise `InputError` naming the one at fault."""
        outline = checked_outline(vertices)
        about_centroid, centroid = centred(outline)
        _set(self, outline=outline, vertices=about_centroid, centroid=centroid)

    @property
    def area(self) -> float:
        """The area, m^2 (DD18)."""
        return float(definitions.area_polygon(*edges(self.vertices)))

    def inertia(self, mass: float) -> float:
        """Return the inertia about the centre of mass, kg m^2 (DD14)."""
        with np.errstate(all="ignore"):  # what overflows is refused with the body
            return float(definitions.inertia_polygon(mass, *edges(self.vertices)))


class _Line:
    """What all shapes around a line along their own x axis have in common."""

    length: float

    @property
    def vertices(self) -> tuple[Vector, ...]:
        """Both ends of the line, the left one first, m."""
        return (-self.length / 2, 0.0), (self.length / 2, 0.0)

    @property
    def core(self) -> tuple[Vector, ...]:
        """Both ends of the line."""
        return self.vertices


@suggests
@dataclass(frozen=True, kw_only=True)
class Capsule(_Line):
    """All that is within a `radius` of a line of a `length`, both in m, along its own x axis.

    From end to end it measures ``length + 2*radius``.
    """

    length: float
    radius: float

    def __post_init__(self) -> None:
        length = _length(self.length, "length", "a capsule")
        _half(length, "length", "a capsule")
        _set(self, length=length, radius=_length(self.radius, "radius", "a capsule"))

    @property
    def rounding(self) -> float:
        """The radius, m."""
        return self.radius

    @property
    def bounding_radius(self) -> float:
        """Half of what it measures from end to end, m."""
        return self.length / 2 + self.radius

    @property
    def area(self) -> float:
        """The area, m^2 (DD24)."""
        return float(definitions.area_capsule(self.length, self.radius))

    def inertia(self, mass: float) -> float:
        """Return the inertia about the centre of mass, kg m^2 (DD14, DD24)."""
        with np.errstate(all="ignore"):
            return float(definitions.inertia_capsule(mass, self.length, self.radius))


@suggests
@dataclass(frozen=True, kw_only=True)
class Segment(_Line):
    """A line of a `length` in m along its own x axis, solid from both sides."""

    length: float

    def __post_init__(self) -> None:
        length = _length(self.length, "length", "a segment")
        _half(length, "length", "a segment")
        _set(self, length=length)

    @property
    def rounding(self) -> float:
        """None: it has no thickness."""
        return 0.0

    @property
    def bounding_radius(self) -> float:
        """Half the length, m."""
        return self.length / 2

    @property
    def area(self) -> float:
        """None: it has no thickness."""
        return 0.0

    def inertia(self, mass: float) -> float:
        """Return the inertia about the centre of mass, kg m^2 (DD14, DD24)."""
        return float(definitions.inertia_segment(mass, self.length))


@suggests
@dataclass(frozen=True, kw_only=True)
class HalfPlane:
    """All points p with ``normal . p <= offset``: a floor or a wall. Static bodies only.

    `normal` points out of the solid; `offset` is how far the surface lies from the origin along it,
    m. A normal of another length than 1 is made a unit vector where the offset is 0, and refused
    where it is not: then the two meanings of the offset would differ.
    """

    normal: Vector
    offset: float

    def __post_init__(self) -> None:
        of, remedy = "a half-plane", "Give the direction out of the solid, e.g. (0, 1) for a floor."
        x, y = vector(self.normal, "normal", of, remedy, at=("normal",))
        length = math.hypot(x, y)
        if not 0 < length < math.inf:
            raise RuleError(
                f"normal ({x:g}, {y:g}) of {of}: has no direction (R4). {remedy}", "normal"
            )
        offset = number(
            self.offset, "offset", of, "Give its distance from the origin in m.", at=("offset",)
        )
        if offset != 0 and abs(length - 1) > _WRITTEN:
            raise RuleError(
                f"normal ({x:g}, {y:g}) of {of}: found the length {length:.6g} with an offset of "
                f"{offset:g} m: must be 1, since the offset is a distance (R4). Give "
                f"({x / length:.6g}, {y / length:.6g}), and the offset in m.",
                "normal",
            )
        if abs(length - 1) > 4 * EPSILON:  # a unit vector stays as it is, to the last bit
            x, y = x / length + 0.0, y / length + 0.0
        _set(self, normal=(x, y), offset=offset)

    @property
    def vertices(self) -> tuple[Vector, ...]:
        """None: a half-plane has no corners."""
        return ()

    @property
    def bounding_radius(self) -> float:
        """Infinite: no circle holds a half-plane."""
        return math.inf


Single: TypeAlias = Disc | Box | Polygon | Capsule | Segment
"""The shapes that are of one piece and of which a circle holds all."""


def _length(value: object, symbol: str, of: str) -> float:
    return number(value, symbol, of, f"Give a positive {symbol} in m.", at=(symbol,))


def _half(length: float, symbol: str, of: str) -> float:
    """Return half of a length; refuse one whose half is 0, since its ends would be one point."""
    if length / 2 == 0:
        raise RuleError(
            f"{symbol} {length!r} m of {of}: float64 cannot hold its half (R4). "
            f"Give a greater {symbol}.",
            symbol,
        )
    return length / 2


def _set(shape: object, **values: object) -> None:
    """Set fields of a frozen shape while it is being made."""
    for name, value in values.items():
        object.__setattr__(shape, name, value)
