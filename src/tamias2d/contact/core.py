"""The geometry of a body in contact: corners, sides and a radius around them."""

import math
from copy import copy
from typing import NamedTuple

from tamias2d.errors import SceneError
from tamias2d.scene import Body, Chain, Compound, Disc, HalfPlane, Scene
from tamias2d.scene.acting import groups, timed_loads, varying_loads, welded
from tamias2d.scene.chain import Piece
from tamias2d.scene.filters import Filtered
from tamias2d.state import State, Vector

_SHORTEST = 2.0**-1022
"""m; below it float64 loses digits, and directions with them."""


class Side(NamedTuple):
    """A straight side of a body, in the body's own axes."""

    normal: Vector
    """Unit, out of the body."""
    offset: float
    """Distance of the side from the centre of mass along the normal, m."""
    ends: Vector
    """Where the side begins and ends along the normal turned left, from the centre of mass, m."""


class Core:
    """The solid part of a body: its corners, thickened by a radius (a disc is one corner).

    A side lies as far out as the radius says.
    """

    def __init__(
        self,
        index: int,
        body: Body,
        *,
        steady: bool = True,
        timed: bool = False,
        group: frozenset[int] = frozenset(),
        jointed: bool = False,
        welded: frozenset[int] = frozenset(),
    ) -> None:
        """Take a body, whether its loads are constant, whether they change at rest, and its group.

        The group holds the bodies on whose states its loads depend, itself included. It is jointed
        where it moves and a joint holds it, and may be `welded` to others for good.
        """
        shape = body.shape
        self.index = index
        self.name = body.name
        self.dynamic = body.dynamic
        self.solid = shape is not None
        self.filter: Filtered = body
        self.endless = isinstance(shape, HalfPlane)
        self.steady = steady
        self.timed = timed
        self.group = group
        self.jointed = jointed
        self.welded = welded
        self.inverse_mass = body.inverse_mass
        self.inverse_inertia = body.inverse_inertia
        self.corners: tuple[Vector, ...] = ((0.0, 0.0),)
        self.sides: tuple[Side, ...] = ()
        self.radius = 0.0
        if isinstance(shape, Disc):
            self.radius = shape.radius
        elif isinstance(shape, HalfPlane):
            self.corners = ()
            self.sides = (Side(shape.normal, shape.offset, (-math.inf, math.inf)),)
        elif shape is not None and not isinstance(shape, Compound | Chain):
            self.corners, self.radius = shape.core, shape.rounding
            self.sides = _sides(shape.core, shape.rounding, body.name)
        self.piece = shape if isinstance(shape, Piece) else None
        self.reaches = tuple(math.hypot(x, y) for x, y in self.corners)
        """Distance of each corner from the centre of mass, m."""
        self.bounding_radius = max(self.reaches) + self.radius if self.corners else math.inf
        self.size = self.bounding_radius if self.corners else abs(self.sides[0].offset)
        """How far off the centre of mass its numbers lie, m."""


def cores_of(scene: Scene) -> list[Core]:
    """Return all bodies of a scene."""
    varying, timed = varying_loads(scene), timed_loads(scene)
    group_of = {i: frozenset(group) for group in groups(scene) for i in group}
    jointed = {i for joint in scene.joints for i in joint.bodies}
    welded_to = {i: frozenset(bodies) for bodies in welded(scene) for i in bodies}
    return [
        Core(
            i,
            body,
            steady=i not in varying,
            timed=i in timed,
            group=group_of.get(i, frozenset()),
            jointed=i in jointed and body.dynamic,
            welded=welded_to.get(i, frozenset()),
        )
        for i, body in enumerate(scene.bodies)
    ]


class Placed(NamedTuple):
    """A body in the world at one instant."""

    core: Core
    state: State
    cosine: float
    sine: float
    corners: tuple[Vector, ...]
    """From the centre of mass, in world axes, m."""

    def turned(self, local: Vector) -> Vector:
        """Return a vector of the body's axes in world axes."""
        x, y = local
        return self.cosine * x - self.sine * y, self.sine * x + self.cosine * y


def place(core: Core, state: State) -> Placed:
    """Put a body into the world."""
    angle = state.orientation
    if angle == 0 or len(core.corners) == 1:  # nothing to turn
        return Placed(core, state, 1.0, 0.0, core.corners)
    c, s = math.cos(angle), math.sin(angle)
    corners = tuple([(c * x - s * y, s * x + c * y) for x, y in core.corners])
    return Placed(core, state, c, s, corners)


def rounded(body: Placed) -> Placed:
    """Return the disc around a body with corners, about its centre of mass."""
    core = copy(body.core)
    core.radius, core.sides = core.bounding_radius, ()
    core.corners, core.reaches = ((0.0, 0.0),), (0.0,)
    return Placed(core, body.state, 1.0, 0.0, core.corners)


def _sides(vertices: tuple[Vector, ...], radius: float, name: str) -> tuple[Side, ...]:
    sides = []
    for (ax, ay), (bx, by) in zip(vertices, vertices[1:] + vertices[:1], strict=True):
        length = math.hypot(bx - ax, by - ay)
        if length < _SHORTEST:
            raise SceneError(
                f"shape of body '{name}': a side of {length:g} m is too short for float64 (R4). "
                "Choose units in which it is nearer to 1."
            )
        nx, ny = (by - ay) / length, (ax - bx) / length
        along_a, along_b = ay * nx - ax * ny, by * nx - bx * ny
        sides.append(Side((nx, ny), nx * ax + ny * ay + radius, (along_a, along_b)))
    return tuple(sides)
