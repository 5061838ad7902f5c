"""How drag slows bodies: what follows from its rates stands once for all that share them.

Serves: adding bodies. Hides: which row of the world's flows is for which rates, and that rows which
nobody has any more are given up now and then.
"""

from itertools import count

import numpy as np
from numpy.typing import NDArray

from tamias2d.state import Array
from tamias2d.stepped.layout import FLOW
from tamias2d.stepped.world import World


class Drag:
    """The rates of a world's bodies, and their rows."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._row = {tuple(rates): k for k, rates in enumerate(world.rates.tolist())}

    def slow(self, rows: NDArray[np.int64], rates: Array) -> None:
        """Let some bodies slow down at their rates (k, 2), 1/s: of the velocity, of the spin."""
        world = self._world
        kinds, which = np.unique(rates, axis=0, return_inverse=True)
        new = [rate for rate in map(tuple, kinds.tolist()) if rate not in self._row]
        if new:
            more = np.array(new)
            self._row.update(zip(new, count(len(self._row)), strict=False))
            world.rates = np.concatenate((world.rates, more))
            world.flows = np.concatenate((world.flows, world.flow(more)))
        places = np.array([self._row[rate] for rate in map(tuple, kinds.tolist())])
        world.body[rows, FLOW] = places[which.ravel()] if len(rows) else 0

    def forget_unused(self) -> None:
        """Give up rows that nobody has, where they are most."""
        world = self._world
        used, which = np.unique(world.body[:, FLOW].astype(np.int64), return_inverse=True)
        if len(self._row) > 2 * len(used):
            world.body[:, FLOW] = which.ravel()
            world.seated_body[world.seat, FLOW] = world.body[:, FLOW]
            world.rates, world.flows = world.rates[used], world.flows[used]
            self._row = {tuple(rates): k for k, rates in enumerate(world.rates.tolist())}
