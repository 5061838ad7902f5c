"""The mechanisms of a scene: bodies that joints connect, directly or not."""

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np

from tamias2d.motion.joint_code import JointCodes
from tamias2d.motion.joint_events import JointEvents, Timeline
from tamias2d.motion.limited_mechanism import LimitedMechanism
from tamias2d.motion.mechanism import Mechanism
from tamias2d.scene import Scene
from tamias2d.scene.joints import Joint
from tamias2d.state import Array, History

Placed: TypeAlias = tuple[list[int], Mechanism | LimitedMechanism]
"""A mechanism, and the places of its bodies among others."""


class Mechanisms:
    """The mechanisms of a scene, each made once: what it expects holds among whatever others."""

    def __init__(self, scene: Scene, timeline: Timeline, codes: JointCodes | None = None) -> None:
        """Take the events of joints; code that is made for mechanisms may find their reactions."""
        self._scene = scene
        self._timeline = timeline
        self._codes = codes
        self._made: dict[tuple[int, ...], Mechanism | LimitedMechanism] = {}

    def among(self, bodies: Sequence[int]) -> list[Placed]:
        """Return those among some bodies, each with the places of its own in `bodies`."""
        place = {body: k for k, body in enumerate(bodies)}
        chain = {body: {body} for body in bodies}
        for joint in self._scene.joints:
            held = [body for body in joint.bodies if body in chain]
            joined = set().union(*(chain[body] for body in held)) if held else set()
            chain.update(dict.fromkeys(joined, joined))
        found: list[Placed] = []
        for members in {id(group): group for group in chain.values()}.values():
            joints = [joint for joint in self._scene.joints if members & set(joint.bodies)]
            if joints:
                own = sorted(members, key=place.__getitem__)
                found.append(([place[body] for body in own], self._of(joints, own)))
        return found

    def _of(self, joints: Sequence[Joint], bodies: Sequence[int]) -> Mechanism | LimitedMechanism:
        if (key := tuple(bodies)) not in self._made:
            limited = any(joint.governed for joint in joints)
            one = (
                LimitedMechanism(self._scene, joints, bodies, self._timeline)
                if limited
                else Mechanism(self._scene, joints, bodies)
            )
            if self._codes is not None:
                one.take_code(self._codes)
            self._made[key] = one
        return self._made[key]


def fitted(
    found: Sequence[Placed], time: float, position: Array, velocity: Array
) -> tuple[Array, Array]:
    """Return coordinates and rates (n, 3) of bodies, moved to where all their joints hold (GD18).

    Raises:
        JointError: no place near by fits.
    """
    position, velocity = position.copy(), velocity.copy()
    for own, mechanism in found:
        position[own], velocity[own] = mechanism.fitted(time, position[own], velocity[own])
    return position, velocity


def drifted(
    found: Sequence[Placed], time: float, duration: float, position: Array, velocity: Array
) -> tuple[Array, Array]:
    """Return coordinates and rates (n, 3) after a drift that ends where all joints hold (GD24).

    Raises:
        JointError: no place near by fits.
    """
    after, along = position + duration * velocity, velocity.copy()
    for own, mechanism in found:
        after[own], along[own] = mechanism.drifted(time, duration, position[own], velocity[own])
    return after, along


def fitted_history(
    scene: Scene,
    times: Array,
    history: History,
    events: JointEvents | None = None,
    codes: JointCodes | None = None,
) -> History:
    """Return the states at times (k,), s, likewise; those of a scene without joints as they are."""
    if not scene.joints:
        return history
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    found = Mechanisms(scene, Timeline(list(events or ())), codes).among(moving)
    rows = [part.copy() for part in history]
    for k, time in enumerate(times.tolist()):
        q = np.column_stack((rows[0][k, moving], rows[1][k, moving]))
        rate = np.column_stack((rows[2][k, moving], rows[3][k, moving]))
        q, rate = fitted(found, time, q, rate)
        rows[0][k, moving], rows[1][k, moving] = q[:, :2], q[:, 2]
        rows[2][k, moving], rows[3][k, moving] = rate[:, :2], rate[:, 2]
    return History(*rows)
