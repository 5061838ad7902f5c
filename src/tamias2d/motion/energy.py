"""Energy in the springs of a scene (IM7) and in the attraction between its bodies (IM5)."""

from typing import Any

import numpy as np

from tamias2d.generated import definitions, gravitation, spring as model
from tamias2d.scene import Freedom, Joint, Scene, Spring
from tamias2d.scene.springs import arm
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array, History


def energy_between(scene: Scene, history: History) -> Array:
    """Return (k,), J; fields and laws of a user's own have no potential and are not in it."""
    total = np.zeros(len(history.position))
    for spring in scene.springs:
        total += _of_spring(spring, history)
    for joint in scene.joints:
        for freedom in joint.freedoms:
            if freedom.spring is not None:
                total += _of_joint(joint, freedom, history)
    return total if scene.attraction is None else total + _of_attraction(scene, history)


def _of_spring(spring: Spring, history: History) -> Array:
    ends = []
    for body, anchor in spring.ends:
        x, y = arm(anchor, history.orientation[:, body]) if any(anchor) else (0.0, 0.0)
        ends.append((history.position[:, body, 0] + x, history.position[:, body, 1] + y))
    first, second = (*ends, spring.point)[:2]
    energy: Array = model.spring_energy(spring.stiffness, spring.rest_length, first, second)
    return energy


def _of_joint(joint: Joint, freedom: Freedom, history: History) -> Array:
    """Return the energy in the spring of a freedom of a joint."""
    spring = freedom.spring
    assert spring is not None
    value, turns = _stretch(joint, freedom, history), freedom.measure == "angle"
    energy = definitions.rotary_spring_energy if turns else definitions.joint_spring_energy
    found: Array = energy(spring.stiffness, value)
    if spring.maximum is None:
        return found
    pull = _pull(spring.stiffness, value)
    if turns:
        share = definitions.torque_share(spring.maximum, np.abs(pull))
        return np.asarray(definitions.bounded_rotary_energy(share, found))
    others = [each for each in joint.freedoms if joint.kind == "target" and each is not freedom]
    across = sum(_pull(spring.stiffness, _stretch(joint, each, history)) for each in others)
    share = definitions.force_share(spring.maximum, definitions.joint_pull(pull, across))
    return np.asarray(definitions.bounded_spring_energy(share, found))


def _pull(stiffness: float, stretch: Array) -> Array:
    """Return what a spring exerts without its damper, N or N m."""
    found: Array = definitions.joint_spring_force(stiffness, stretch, 0.0, 0.0)
    return found


def _stretch(joint: Joint, freedom: Freedom, history: History) -> Array:
    """Return how far a freedom of a joint is beyond where its spring is at rest, m or rad."""
    measured = joint.measured(freedom, 0.0)
    known: dict[str, Any] = dict(measured.given)
    for end, body in zip(ENDS, measured.ends, strict=True):
        known[f"position_{end}"] = (
            (0.0, 0.0)
            if body is None
            else (history.position[:, body, 0], history.position[:, body, 1])
        )
        known[f"orientation_{end}"] = 0.0 if body is None else history.orientation[:, body]
    (value,) = measured.functions.constraint(known)
    assert freedom.spring is not None
    stretch: Array = value - (freedom.spring.rest or 0.0)
    return stretch


def _of_attraction(scene: Scene, history: History) -> Array:
    """Sum over all pairs, one body at a time against all after it."""
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    mass = np.array([scene.bodies[k].mass for k in moving])
    place = history.position[:, moving]
    total = np.zeros(len(place))
    for i in range(len(moving) - 1):
        one, others = place[:, i, None], place[:, i + 1 :]
        total += gravitation.gravitational_energy(
            scene.attraction,
            mass[i],
            mass[i + 1 :],
            (one[..., 0], one[..., 1]),
            (others[..., 0], others[..., 1]),
        ).sum(axis=-1)
    return total
