"""What a scene does to bodies that are added while it is stepped: its fields and attraction.

Those that are for all bodies that move act on added ones, too, and those that name bodies do not.
"""

from collections.abc import Container, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tamias2d.engine.bodies.batch import Batch
from tamias2d.engine.engine import Engine
from tamias2d.engine.tables import DYNAMIC
from tamias2d.errors import InputError
from tamias2d.scene import Body, Scene
from tamias2d.scene.acting import steady_load
from tamias2d.scene.law import Law, value_at, varies
from tamias2d.scene.other_bodies import with_bodies
from tamias2d.scene.rules import RuleError
from tamias2d.state import Array


def acts_on_all(scene: Scene) -> bool:
    """Return whether something acts on all bodies that move."""
    return scene.attraction is not None or any(field.bodies is None for field in scene.fields)


def acting_scene(
    scene: Scene, staying: Sequence[int], engine: Engine
) -> tuple[Scene, dict[int, int]]:
    """Return the scene with the bodies added, and the index in it of each that moves, by rows.

    `staying` are the rows of its own that are still there. Rows are in canonical order.
    """
    own, known = set(staying), len(scene)
    rows = np.flatnonzero((engine.kind == DYNAMIC) & (engine.rank >= 0))
    ranked = rows[np.argsort(engine.rank[rows])].tolist()
    added = [row for row in ranked if row not in own] if acts_on_all(scene) else []
    index = {row: known + k for k, row in enumerate(added)}
    mass = (1 / engine.inverse_mass[added]).tolist()
    more = (
        Body(name=f"body {row}", shape=None, dynamic=True, mass=mass[k])
        for k, row in enumerate(added)
    )
    longer = with_bodies(scene, [*scene.bodies, *more])
    return longer, {row: index.get(row, row) for row in ranked if row in own or row in index}


def with_masses(scene: Scene, own: Container[int], rows: Sequence[int], mass: Array) -> Scene:
    """Return the scene with other masses (k,), kg, of those bodies (k,) that are its `own`."""
    bodies = list(scene.bodies)
    for row, each in zip(rows, mass.tolist(), strict=True):
        if row in own:
            bodies[row] = replace(bodies[row], mass=each)
    return with_bodies(scene, bodies)


def steady_loads(scene: Scene, own: Container[int], rows: Sequence[int], mass: Array) -> Array:
    """Return the loads (k, 3) that stay as they are on bodies (k,) of such masses, kg."""
    known, given = len(scene), mass.tolist()
    others = (Body(name="", shape=None, dynamic=True, mass=each) for each in given)
    heavy = with_masses(scene, own, rows, mass)
    heavy = with_bodies(heavy, [*heavy.bodies, *others])
    place = [row if row in own else known + k for k, row in enumerate(rows)]
    return np.array([steady_load(heavy, k) for k in place]).reshape(-1, 3)


def with_steady_loads(scene: Scene, batch: Batch, time: float) -> Batch:
    """Return bodies to be added, with what fields that stay as they are do to all that move.

    Raises:
        InputError: a field has no finite value where a body is, at a time in s.
    """
    later = replace(batch, numbers=batch.numbers.copy())
    (x, y, orientation), (u, v, spin) = batch.pose.T, batch.motion.T
    state = {
        "time": time,
        "position": (x, y),
        "velocity": (u, v),
        "orientation": orientation,
        "angular_velocity": spin,
        "mass": batch.masses[:, 0],
    }
    for field in scene.fields if len(batch) else ():
        for component, law in enumerate((*field.force, field.torque)):
            if field.bodies is None:
                value = _value(law, state)
                later.load[:, component] += 0.0 if varies(law) else value
    return later


def _value(law: Law, state: Mapping[str, Any]) -> Any:
    try:
        return value_at(law, state)
    except InputError as error:
        raise RuleError(str(error), "position") from None
