"""A scene in this library's simulator.

Serves: studies and measurements of contacts. Hides: how the simulator is asked.
"""

import numpy as np

from tamias2d.scene import Scene
from tamias2d.simulator import Simulator
from tamias2d.state import Array
from tamias2d.study.engines.engine import Pair


class Own:
    """A simulator."""

    name = "Tamias2D"

    def __init__(
        self, scene: Scene, time_step: float, substeps: int | None = None, *, listens: bool = False
    ) -> None:
        self.simulator = (
            Simulator(scene, time_step=time_step)
            if substeps is None
            else Simulator(scene, time_step=time_step, substeps=substeps)
        )
        # studies ask for steps that are too long, and judge themselves what comes of them
        self.simulator._warned.keep_back()
        self._listens = listens
        self.met: dict[Pair, float] = {}

    def step(self, count: int = 1) -> None:
        """Go so many time steps ahead."""
        if not self._listens:
            self.simulator.step(count)
            return
        for _ in range(count):
            self.simulator.step()
            for a, b in self.simulator.began.bodies.tolist():
                self.met.setdefault((min(a, b), max(a, b)), self.simulator.time)

    def drive(self, body: int, velocity: tuple[float, float]) -> None:
        """Give a kinematic body another velocity, m/s."""
        self.simulator.velocity[body] = velocity

    def read(self) -> Array:
        """Return the positions (n, 2), m: a view, which nobody has to fill."""
        return np.asarray(self.simulator.position)

    def state(self) -> Array:
        """Return (n, 6): positions, orientations and their rates."""
        own = self.simulator
        return np.column_stack((own.position, own.orientation, own.velocity, own.angular_velocity))
