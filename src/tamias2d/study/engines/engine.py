"""What is asked of an engine.

Serves: studies and measurements of contacts. Hides: nothing; this is the contract.
"""

from collections.abc import Callable
from typing import Protocol, TypeAlias

from tamias2d.scene import Scene
from tamias2d.state import Array

Pair: TypeAlias = tuple[int, int]
"""Two bodies, the lower one first."""


class Engine(Protocol):
    """A scene in an engine, which goes ahead by time steps."""

    name: str
    met: dict[Pair, float]
    """When pairs first touched: at the end of which step, s. Only what listens fills it."""

    def step(self, count: int = 1) -> None:
        """Go so many time steps ahead, in one call where the engine can."""

    def drive(self, body: int, velocity: tuple[float, float]) -> None:
        """Give a kinematic body another velocity, m/s."""

    def read(self) -> Array:
        """Return the positions (n, 2), m, of at least what moves, in the fastest way."""

    def state(self) -> Array:
        """Return (n, 6) of all bodies: positions, orientations and their rates."""


Maker: TypeAlias = Callable[[Scene, float], Engine]
"""From a scene and a time step, s, to an engine that holds it."""
