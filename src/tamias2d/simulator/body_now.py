"""A body of an engine as it is now: what it is made of, where it is, and how it moves."""

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.engine import Engine
from tamias2d.engine.shapes.shape_of_rows import ConvexRow, shape_of
from tamias2d.engine.shapes.stated_surfaces import UNSTATED
from tamias2d.scene import Body
from tamias2d.scene.compound import Shape
from tamias2d.scene.filters import ALL
from tamias2d.simulator.masses import masses_now
from tamias2d.state import Array


def body_now(engine: Engine, row: int, name: str) -> Body:
    """Return the body in a row, under a name."""
    state, kind = engine.world.state, int(engine.kind[row])
    x, y, turn = engine.pose[row].tolist()
    u, v, spin = engine.velocity[row].tolist()
    force_x, force_y, torque = engine.load[row].tolist()
    heavy = {key: values.item() for key, values in masses_now(engine, [row])._asdict().items()}
    pushed = kind == tb.DYNAMIC
    places = np.flatnonzero(state.body_of_shape == row)
    return Body(
        name=name,
        shape=shape_now(engine, row),
        dynamic=pushed,
        kinematic=kind == tb.KINEMATIC,
        position=(x, y),
        orientation=turn,
        velocity=(u, v),
        angular_velocity=spin,
        force=(force_x, force_y),
        torque=torque,
        inertia_stated=pushed,
        **heavy,
        **(_of_shape(engine, int(places[0])) if len(places) else {"mask": ALL}),
    )


def shape_now(engine: Engine, row: int) -> Shape | None:
    """Return the shape of the body in a row; a particle has none."""
    places = np.flatnonzero(engine.world.state.body_of_shape == row)
    return shape_of([_convex_row(engine, place) for place in places.tolist()])


def _convex_row(engine: Engine, place: int) -> ConvexRow:
    shapes = engine.world.shapes
    first, count = int(shapes.first[place]), int(shapes.vertex_count[place])
    vertices = shapes.local_vertices[first : first + count]
    surface = _surface(shapes.stated[place, tb.BY_PART : tb.BY_BODY])
    return ConvexRow(int(shapes.kind[place]), float(shapes.radius[place]), vertices, **surface)


def _surface(stated: Array) -> dict[str, float | None]:
    friction, restitution = (None if x == UNSTATED else x for x in stated.tolist())
    return {"friction": friction, "restitution": restitution}


def _of_shape(engine: Engine, place: int) -> dict[str, object]:
    """Return what a body has by each of its shapes alike."""
    shapes = engine.world.shapes
    category, mask, group, sensor = shapes.filters[place].tolist()
    return {
        **_surface(shapes.stated[place, tb.BY_BODY :]),
        "surface_speed": float(shapes.material[place, tb.SURFACE_SPEED]),
        "category": category,
        "mask": mask,
        "group": group,
        "sensor": bool(sensor),
    }
