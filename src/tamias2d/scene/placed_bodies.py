"""Bodies as the checks of a joint look at them: of a scene, or of a frame loop as they stand."""

from dataclasses import dataclass
from typing import Protocol, TypeAlias

from tamias2d.scene.bodies import Body
from tamias2d.scene.rules import Vector


@dataclass(frozen=True)
class Round:
    """A shape of which only its reach is known."""

    bounding_radius: float
    """m"""


@dataclass(frozen=True)
class StandingBody:
    """A body of a frame loop; quantities as in `Body`."""

    name: str
    position: Vector
    orientation: float
    velocity: Vector
    angular_velocity: float
    dynamic: bool
    kinematic: bool
    inertia: float
    inertia_stated: bool
    shape: Round


PlacedBody: TypeAlias = Body | StandingBody


class PlacedBodies(Protocol):
    """Bodies by their rows: a sequence of those of a scene, or whatever looks them up."""

    def __getitem__(self, row: int, /) -> PlacedBody:
        """Return a body."""
