"""A scene with other bodies: moved elsewhere, heavier, or more of them, under the same laws."""

from collections.abc import Iterable
from copy import copy
from typing import TypeVar

from tamias2d.scene.bodies import Body
from tamias2d.scene.scene_data import SceneData

AnyScene = TypeVar("AnyScene", bound=SceneData)


def with_bodies(scene: AnyScene, bodies: Iterable[Body]) -> AnyScene:
    """Return a copy of a scene with other bodies, unchecked.

    The first ones are those of the scene, in their order, and have their names.
    """
    other = copy(scene)
    other._shown = tuple(bodies)
    other._bodies = list(other._shown)
    return other
