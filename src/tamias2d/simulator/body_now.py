"""A body of an engine as it is now: what it is made of, where it is, and how it moves."""

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.batch import UNSTATED
from tamias2d.engine.engine import Engine
from tamias2d.engine.shape_of_rows import ConvexRow, shape_of
from tamias2d.scene import Body
from tamias2d.scene.filters import ALL


def body_now(engine: Engine, row: int, name: str) -> Body:
    """Return the body in a row, under a name."""
    state, kind = engine.world.state, int(engine.kind[row])
    x, y, turn = engine.pose[row].tolist()
    u, v, spin = engine.velocity[row].tolist()
    force_x, force_y, torque = engine.load[row].tolist()
    mass, inertia = _inverse(engine.inverse_mass[row]), _inverse(engine.inverse_inertia[row])
    rates = state.drag_rates[int(state.properties[row, tb.PROPAGATOR])].tolist()
    pushed = kind == tb.DYNAMIC
    places = np.flatnonzero(state.body_of_shape == row)
    return Body(
        name=name,
        shape=shape_of([_convex_row(engine, place) for place in places.tolist()]),
        dynamic=pushed,
        kinematic=kind == tb.KINEMATIC,
        mass=mass,
        inertia=inertia,
        position=(x, y),
        orientation=turn,
        velocity=(u, v),
        angular_velocity=spin,
        force=(force_x, force_y),
        torque=torque,
        linear_drag=rates[0] * mass if rates[0] else 0.0,
        angular_drag=rates[1] * inertia if rates[1] else 0.0,
        inertia_stated=pushed,
        **(_of_shape(engine, int(places[0])) if len(places) else {"mask": ALL}),
    )


def _inverse(value: np.float64) -> float:
    return 1 / float(value) if value else np.inf


def _convex_row(engine: Engine, place: int) -> ConvexRow:
    shapes = engine.world.shapes
    first, count = int(shapes.first[place]), int(shapes.vertex_count[place])
    vertices = shapes.local_vertices[first : first + count]
    return ConvexRow(int(shapes.kind[place]), float(shapes.radius[place]), vertices)


def _of_shape(engine: Engine, place: int) -> dict[str, object]:
    """Return what a body has by each of its shapes alike."""
    shapes = engine.world.shapes
    friction, restitution = shapes.material[place, tb.FRICTION : tb.RESTITUTION + 1].tolist()
    category, mask, group, sensor = shapes.filters[place].tolist()
    return {
        "friction": None if friction == UNSTATED else friction,
        "restitution": None if restitution == UNSTATED else restitution,
        "category": category,
        "mask": mask,
        "group": group,
        "sensor": bool(sensor),
    }
