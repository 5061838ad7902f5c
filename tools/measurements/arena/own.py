"""A scene in this library's simulator, at its defaults.

Serves: the measurement of contacts. Hides: how the simulator is asked.
"""

import numpy as np

import tamias2d as t2
from tamias2d.scene import Scene
from tamias2d.state import Array


class Own:
    """A simulator."""

    name = "Tamias2D"

    def __init__(self, scene: Scene, time_step: float, substeps: int | None = None) -> None:
        self.simulator = (
            t2.Simulator(scene, time_step=time_step)
            if substeps is None
            else t2.Simulator(scene, time_step=time_step, substeps=substeps)
        )

    def step(self, count: int = 1) -> None:
        """Go so many time steps ahead."""
        self.simulator.step(count)

    def read(self) -> Array:
        """Return the positions (n, 2), m: a view, which nobody has to fill."""
        return np.asarray(self.simulator.position)

    def state(self) -> Array:
        """Return (n, 6): positions, orientations and their rates."""
        own = self.simulator
        return np.column_stack((own.position, own.orientation, own.velocity, own.angular_velocity))
