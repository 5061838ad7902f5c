"""A scene of bodies that nothing else acts on, built anew."""

from collections.abc import Iterable
from typing import Any

from tamias2d.scene import Body, Scene


def arguments(body: Body) -> dict[str, Any]:
    """With what a body that moves is added to a scene, or to a simulator."""
    names = ("mass", "position", "orientation", "velocity", "angular_velocity")
    return {name: getattr(body, name) for name in (*names, "friction", "restitution")}


def rebuilt(scene: Scene, order: Iterable[int]) -> Scene:
    """The same bodies, added in another order."""
    other = Scene(gravity=scene.gravity)
    for k in order:
        given = arguments(body := scene.bodies[k])
        if body.dynamic:
            other.add_body(body.shape, name=body.name, **given)
        else:
            stays = ("mass", "velocity", "angular_velocity")
            still = {key: value for key, value in given.items() if key not in stays}
            assert body.shape is not None
            other.add_static(body.shape, name=body.name, **still)
    return other
