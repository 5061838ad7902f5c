"""How far bodies go through the parts of a step, to and fro, which is taken again for that.

Serves: the measurement of crowds. Hides: that the step is plain Python, whose parts can be watched.
"""

from pathlib import Path
from unittest.mock import patch

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.parts import end_part
from tamias2d.engine.tables import World
from tamias2d.simulator import Simulator
from tamias2d.state import Array


def ways(saved: Path) -> Array:
    """Return the lengths (n,), m, of the ways of all bodies in the step after a saved one.

    They are at least that long: impacts that are located within a part bend them in it.
    """
    sim = Simulator.restore(saved, compiled=False)
    slots = sim._engine.world.state.slot_of_body[: len(sim.position)]
    place, length = sim.position.copy(), np.zeros(len(slots))

    def watched(world: World) -> bool:
        shift = world.bodies.motion[slots, tb.DX : tb.DY + 1]
        after = world.bodies.pose[slots, tb.X : tb.Y + 1] + shift
        length[:] += np.hypot(*(after - place).T)
        place[:] = after
        return end_part(world)

    with patch("tamias2d.engine.step.end_part", watched), np.errstate(all="ignore"):
        sim.step()
    alone: Array = np.hypot(*(sim.position - place).T)  # bodies without contacts take no parts
    return length + alone
