"""The bodies of an engine as the checks of a joint look at them."""

from collections.abc import Mapping

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.engine import Engine
from tamias2d.scene.placed_bodies import Round, StandingBody


class StandingBodies:
    """The bodies of an engine, by their rows, as the checks of a joint look at them."""

    def __init__(self, engine: Engine, names: Mapping[int, str]) -> None:
        self._engine, self._names = engine, names

    def __getitem__(self, row: int) -> StandingBody:
        engine = self._engine
        x, y, turn = engine.pose[row].tolist()
        u, v, spin = engine.velocity[row].tolist()
        inverse = float(engine.inverse_inertia[row])
        radius = float(engine.world.state.properties[row, tb.BOUNDING_RADIUS])
        return StandingBody(
            name=self._names.get(row, str(row)),
            position=(x, y),
            orientation=turn,
            velocity=(u, v),
            angular_velocity=spin,
            dynamic=bool(engine.kind[row] == tb.DYNAMIC),
            kinematic=bool(engine.kind[row] == tb.KINEMATIC),
            inertia=1 / inverse if inverse > 0 else np.inf,
            inertia_stated=inverse > 0 or radius > 0,  # a particle may have none
            shape=Round(radius),
        )
