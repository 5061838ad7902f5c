"""A scene that starts in another state: the same laws for bodies moved elsewhere."""

from collections.abc import Sequence
from copy import copy

from tamias2d.scene.bodies import Body
from tamias2d.scene.scene import Scene


def restarted(scene: Scene, bodies: Sequence[Body]) -> Scene:
    """Return a copy of a scene with other bodies, which differ only in how they start."""
    other = copy(scene)
    other._bodies, other._shown = list(bodies), tuple(bodies)
    return other
