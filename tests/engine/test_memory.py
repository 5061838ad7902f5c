"""The arrays of the engine begin with a line of a cache, whatever made them."""

import pickle

from tamias2d import Simulator
from tamias2d.engine.arrays.memory import LINE
from tamias2d.engine.arrays.world import named_arrays
from tamias2d.scene import catalogue


def test_rows_touch_no_line_twice_when_made_grown_or_restored() -> None:
    sim = Simulator(catalogue.load("pyramid-30"))
    sim.step(2)
    for one in (sim, pickle.loads(pickle.dumps(sim))):
        for name, array in named_arrays(one._engine.world).items():
            assert array.size == 0 or array.ctypes.data % LINE == 0, name
