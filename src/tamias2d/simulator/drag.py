"""How drag slows bodies: what follows from its rates stands once for all that share them.

Serves: adding bodies. Hides: which row of the engine's flows is for which rates, and that rows which
nobody has any more are given up now and then.
"""

from itertools import count

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.engine import Engine
from tamias2d.engine.tables import PROPAGATOR
from tamias2d.state import Array


class Drag:
    """The rates of a engine's bodies, and their rows."""

    def __init__(self, engine: Engine) -> None:
        self._engine = engine
        self._row = {
            tuple(rates): k for k, rates in enumerate(engine.world.state.drag_rates.tolist())
        }

    def slow(self, rows: NDArray[np.int64], rates: Array) -> None:
        """Let some bodies slow down at their rates (k, 2), 1/s: of the velocity, of the spin."""
        engine = self._engine
        kinds, which = np.unique(rates, axis=0, return_inverse=True)
        new = [rate for rate in map(tuple, kinds.tolist()) if rate not in self._row]
        if new:
            more = np.array(new)
            self._row.update(zip(new, count(len(self._row)), strict=False))
            engine.set_drag_rates(np.concatenate((engine.world.state.drag_rates, more)))
        places = np.array([self._row[rate] for rate in map(tuple, kinds.tolist())])
        engine.world.state.properties[rows, PROPAGATOR] = places[which.ravel()] if len(rows) else 0

    def forget_unused(self) -> None:
        """Give up rows that nobody has, where they are most."""
        engine = self._engine
        used, which = np.unique(
            engine.world.state.properties[:, PROPAGATOR].astype(np.int64), return_inverse=True
        )
        if len(self._row) > 2 * len(used):
            engine.world.state.properties[:, PROPAGATOR] = which.ravel()
            engine.world.bodies.properties[engine.world.state.slot_of_body, PROPAGATOR] = (
                engine.world.state.properties[:, PROPAGATOR]
            )
            engine.set_drag_rates(engine.world.state.drag_rates[used])
            self._row = {
                tuple(rates): k for k, rates in enumerate(engine.world.state.drag_rates.tolist())
            }
