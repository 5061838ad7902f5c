"""Which bodies have a closed form: their motion between impacts is a formula of time."""

from typing import Literal

from tamias2d.scene.acting import varying_loads
from tamias2d.scene.scene_data import SceneData
from tamias2d.scene.springs import Spring

Form = Literal["constant loads", "linear drag", "angular drag", "spring without length"]


def closed_forms(scene: SceneData) -> dict[int, Form]:
    """Return the form of each body that has one (IM1 and IM2, IM6, IM7); what is static has none.

    Besides what the form says, all loads are constant.
    """
    varying = varying_loads(scene)
    tied = {k for joint in scene.joints for k in joint.bodies}
    forms: dict[int, Form] = {}
    for k, body in enumerate(scene.bodies):
        if not body.dynamic or k in tied:
            continue
        if k not in varying:
            forms[k] = "constant loads"
        elif _dragged_only(scene, k):
            forms[k] = "linear drag" if body.linear_drag else "angular drag"
        elif _sprung_only(scene, k):
            forms[k] = "spring without length"
    return forms


def spring_of(scene: SceneData, k: int) -> Spring:
    """Return the one spring of a body whose form is "spring without length"."""
    return next(spring for spring in scene.springs if k in spring.bodies)


def _dragged_only(scene: SceneData, k: int) -> bool:
    """Whether linear and angular drag are all that varies."""
    held = any(k in spring.bodies for spring in scene.springs)
    return not held and not scene.bodies[k].quadratic_drag and _laws_steady(scene, k)


def _sprung_only(scene: SceneData, k: int) -> bool:
    """Whether one spring of no length from its centre to a point is all that varies."""
    body = scene.bodies[k]
    springs = [spring for spring in scene.springs if k in spring.bodies]
    slowed = body.linear_drag or body.quadratic_drag or body.angular_drag
    if len(springs) != 1 or slowed or not _laws_steady(scene, k):
        return False
    (spring,) = springs
    return (
        spring.second is None
        and spring.rest_length == spring.damping == 0
        and spring.anchor == (0.0, 0.0)
    )


def _laws_steady(scene: SceneData, k: int) -> bool:
    """Whether no law of a body's own or of a field varies, and nothing attracts the body."""
    steady = all(field.constant for field in scene.fields if field.acts_on(k))
    alone = sum(body.dynamic for body in scene.bodies) < 2
    return scene.bodies[k].constant and steady and (scene.attraction is None or alone)
