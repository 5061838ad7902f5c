"""Bodies on their way into the engine: a row for each, of real numbers and of whole ones."""

from dataclasses import dataclass

from tamias2d.scene.compound import Shape
from tamias2d.state import Array, IntArray


@dataclass(frozen=True)
class Batch:
    """What k bodies are, and where and how they start; SI units."""

    numbers: Array
    """(k, 16): pose, motion and load of three each, and what the properties below tell"""
    wholes: IntArray
    """(k, 5): kind, of `tables` STATIC, KINEMATIC or DYNAMIC, and filters"""
    shapes: tuple[Shape | None, ...]
    """k shapes; None for a particle"""

    def __len__(self) -> int:
        return len(self.shapes)

    @property
    def pose(self) -> Array:
        """(k, 3), position and orientation."""
        return self.numbers[:, :3]

    @property
    def motion(self) -> Array:
        """(k, 3), velocity and angular velocity."""
        return self.numbers[:, 3:6]

    @property
    def load(self) -> Array:
        """(k, 3), applied force and torque."""
        return self.numbers[:, 6:9]

    @property
    def masses(self) -> Array:
        """(k, 4): mass and inertia, infinite where nothing pushes or turns it; rates of drag, 1/s.

        Drag slows the velocity at the first rate, and the angular velocity at the second.
        """
        return self.numbers[:, 9:13]

    @property
    def surfaces(self) -> Array:
        """(k, 3): friction and restitution, UNSTATED where none is stated; surface speed, m/s."""
        return self.numbers[:, 13:]

    @property
    def kind(self) -> IntArray:
        """(k,)."""
        return self.wholes[:, 0]

    @property
    def filters(self) -> IntArray:
        """(k, 4): category, mask, group, sensor."""
        return self.wholes[:, 1:]
