"""A scene that starts otherwise: the same bodies and laws, from other states."""

from collections.abc import Sequence
from copy import copy
from dataclasses import replace

from tamias2d.scene.scene import Scene
from tamias2d.state import State


def restarted(scene: Scene, states: Sequence[State]) -> Scene:
    """Return a copy of a scene whose bodies start in given states, one for each body."""
    other = copy(scene)
    other._bodies = [  # noqa: SLF001 - of its own class's family
        replace(body, **state._asdict())
        for body, state in zip(scene.bodies, states, strict=True)
    ]
    return other
