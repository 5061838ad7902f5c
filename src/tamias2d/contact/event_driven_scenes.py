"""Scenes that compiled code can follow from impact to impact (`tamias2d.event_driven`)."""

from tamias2d.scene import Body, Chain, Compound, Scene
from tamias2d.scene.acting import varying_loads
from tamias2d.scene.filters import filters


def is_event_driven(scene: Scene) -> bool:
    """Whether a scene is of convex bodies, half-planes and particles under constant loads alone."""
    loads = scene.springs or scene.fields or scene.joints or scene.attraction is not None
    return not loads and all(map(_is_known, scene.bodies)) and not varying_loads(scene)


def _is_known(body: Body) -> bool:
    convex = not isinstance(body.shape, Chain | Compound)
    return convex and not (body.kinematic or body.sensor or filters(body))
