"""The shapes of bodies."""

from typing import Annotated, NamedTuple

from tamias2d.engine.tables.declarations import Columns, Saved, Sized
from tamias2d.kernels.arrays import FloatRows, Floats, Indices, Places, RankRows

# kind; thin shapes are next to nothing across, and pieces of chains solid from both sides, or one
(
    DISC, CAPSULE, POLYGON, HALF_PLANE, THIN_CAPSULE, THIN_POLYGON, PIECE, ONE_SIDED_PIECE,
) = range(8)  # fmt: skip
THINNEST = 2.0**-8  # of the length: shapes of a smaller width are thin

_material = Columns()
FRICTION = _material()  # -1 where not stated
RESTITUTION = _material()  # -1 where not stated
SURFACE_SPEED = _material()  # m/s, counter-clockwise
SHAPE_RADIUS = _material()  # m, of the circle around the shape from the centre of its body
SHAPE_INRADIUS = _material()  # m, least distance of its sides from there; -inf if that is outside
START_COSINE = _material()  # of a piece of a chain: the corner at its start; 0 of other shapes
START_SINE = _material()
END_COSINE = _material()  # the corner at its end
END_SINE = _material()

_stated = Columns(2)  # friction, restitution; -1 where not stated
BY_PART = _stated()  # for the shape, as a part of its body
BY_BODY = _stated()  # which counts for shapes that state none

CATEGORY, MASK, GROUP, SENSOR = range(4)  # filters

_shape_boxes = Columns()  # around a shape as a part begins, where the contact list is long
BOX_LOW_X = _shape_boxes()  # m
BOX_LOW_Y = _shape_boxes()
BOX_HIGH_X = _shape_boxes()
BOX_HIGH_Y = _shape_boxes()
BOX_WAY_X = _shape_boxes()  # m, that its body goes in the part
BOX_WAY_Y = _shape_boxes()
BOX_CLOSE = _shape_boxes()  # m, below which a gap counts as a contact


class Shapes(NamedTuple):
    """Convex shapes: vertices grown by a radius; read by the broad and the narrow phase."""

    slot: Annotated[Places, Sized("shapes")]  # of the body
    kind: Annotated[Indices, Sized("shapes"), Saved(8)]
    first: Annotated[Indices, Sized("shapes"), Saved("vertices")]  # vertex
    vertex_count: Annotated[Indices, Sized("shapes"), Saved(2**31)]  # of vertices
    radius: Annotated[Floats, Sized("shapes"), Saved()]  # m
    material: Annotated[FloatRows, Sized("shapes", _material.width), Saved(numbers="infinite")]
    # from which the first two columns of the material follow; read by no stage
    stated: Annotated[FloatRows, Sized("shapes", _stated.width), Saved()]
    filters: Annotated[RankRows, Sized("shapes", 4), Saved({SENSOR: 2})]
    # vertex, m; normal of its side
    local_vertices: Annotated[FloatRows, Sized("vertices", 4), Saved()]
    world_vertices: Annotated[FloatRows, Sized("vertices", 4), Saved()]  # the same, turned
    boxes: Annotated[FloatRows, Sized("shapes", 8)]  # a cache line
    # shapes, friction, restitution
    pair_overrides: Annotated[FloatRows, Sized("overrides", 4), Saved({0: "shapes", 1: "shapes"})]
