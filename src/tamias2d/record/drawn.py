"""What can be drawn: a scene at some times. A run is one, and so are some frames of a loop."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Sequence

    from tamias2d.motion import JointEvents
    from tamias2d.scene import Body, Joint
    from tamias2d.scene.springs import Spring
    from tamias2d.state import Array


class DrawnScene(Protocol):
    """Bodies, and what ties them."""

    @property
    def bodies(self) -> Sequence[Body]:
        """n of them."""

    @property
    def joints(self) -> Sequence[Joint]:
        """Between bodies by their indices."""

    @property
    def springs(self) -> Sequence[Spring]:
        """Likewise."""


class Drawn(Protocol):
    """A scene at k times."""

    @property
    def scene(self) -> DrawnScene:
        """What is drawn."""

    @property
    def times(self) -> Array:
        """(k,), s"""

    @property
    def position(self) -> Array:
        """(k, n, 2), m"""

    @property
    def orientation(self) -> Array:
        """(k, n), rad"""

    @property
    def joint_events(self) -> JointEvents:
        """What happened to joints: of those that broke nothing is drawn."""


@dataclass(frozen=True, kw_only=True)
class FrameScene:
    """The bodies that are there in some frames, and what ties them."""

    bodies: Sequence[Body]
    joints: Sequence[Joint]
    springs: Sequence[Spring]


@dataclass(frozen=True, kw_only=True)
class Frames:
    """k frames of a loop in which no body and no joint comes or goes."""

    scene: FrameScene
    times: Array
    position: Array
    orientation: Array
    joint_events: JointEvents

    def first(self) -> Frames:
        """Return the first of them alone."""
        return replace(
            self,
            times=self.times[:1],
            position=self.position[:1],
            orientation=self.orientation[:1],
        )

    def standing(self) -> Frames:
        """Return the static bodies alone."""
        still = [k for k, body in enumerate(self.scene.bodies) if body.static]
        bodies = [self.scene.bodies[k] for k in still]
        return replace(
            self,
            scene=FrameScene(bodies=bodies, joints=(), springs=()),
            position=self.position[:, still],
            orientation=self.orientation[:, still],
        )
