"""Scenes that compiled code can follow from impact to impact (`tamias2d.event_driven`)."""

import math

from tamias2d.contact.core import Core, Side
from tamias2d.scene import Body, Chain, Compound, Scene
from tamias2d.scene.acting import varying_loads
from tamias2d.scene.filters import filters

_THIN = 0.02  # of how far a body reaches: twice the largest gap that may count as none there


def is_event_driven(scene: Scene) -> bool:
    """Whether a scene is of convex bodies, half-planes and particles under constant loads alone."""
    loads = scene.springs or scene.fields or scene.joints or scene.attraction is not None
    return not loads and all(map(is_known, scene.bodies)) and not varying_loads(scene)


def is_known(body: Body) -> bool:
    """Whether compiled code knows a body."""
    convex = not isinstance(body.shape, Chain | Compound)
    moves_others = body.kinematic or body.surface_speed != 0.0
    return convex and not (moves_others or body.sensor or filters(body))


def has_thin_pair(scene: Scene) -> bool:
    """Whether two bodies are so thin that a gap does not tell on which side of each other they are.

    Compiled code does not remember from which side two bodies have met.
    """
    return len(thin_bodies(scene)) > 1


def thin_bodies(scene: Scene) -> list[int]:
    """Return the bodies that are much less wide in some direction than they reach."""
    return [k for k, body in enumerate(scene.bodies) if _is_thin(Core(k, body))]


def _is_thin(core: Core) -> bool:
    """Whether a body is much less wide in some direction than it reaches."""
    return core.solid and any(_width(core, side) < _THIN * core.size for side in core.sides)


def _width(core: Core, side: Side) -> float:
    """Return how wide a body is across one of its sides, m."""
    x, y = side.normal
    lowest = min((x * a + y * b for a, b in core.corners), default=-math.inf)
    return side.offset - lowest + core.radius
