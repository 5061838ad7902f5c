"""Bodies that were put elsewhere by hand, and the limits beyond which they are there (GD21).

A simulator warns of them. The engine brings such a body back without energy, and so does not where
it would have to lift it.
"""

from collections.abc import Iterable, Iterator

from tamias2d.engine import tables as tb
from tamias2d.engine.engine import Engine
from tamias2d.scene.joint_checks import values_of_freedoms
from tamias2d.scene.joints import Joint
from tamias2d.simulator.joint_layout import APART
from tamias2d.simulator.joint_separations import size_of_joint
from tamias2d.simulator.moved_limits import beyond
from tamias2d.simulator.standing_bodies import StandingBodies
from tamias2d.state import Array


def put_elsewhere(joints: Iterable[Joint], left: Array, engine: Engine) -> list[Joint]:
    """Return the joints of bodies that move, and are not at the poses (n, 3) of before.

    Bodies that came since may have been put anywhere.
    """
    pose, known = engine.pose, min(len(left), engine.size)
    if known == len(left) == len(pose) and (pose == left).all():
        return []
    moved = engine.kind == tb.DYNAMIC
    moved[:known] &= (pose[:known] != left[:known]).any(axis=1)
    return [joint for joint in joints if moved[list(joint.bodies)].any()]


def beyond_limits(joints: Iterable[Joint], engine: Engine) -> Iterator[tuple[Joint, str, float]]:
    """Yield joints beyond a limit, which limit, and how far, m or rad.

    What is less than `APART`, in rad or of the size of a joint, does not count.
    """
    bodies = StandingBodies(engine, {})
    for joint in joints:
        if not any(each.limits for each in joint.freedoms):
            continue
        values = values_of_freedoms(joint, bodies)
        for each, value in zip(joint.freedoms, values, strict=True):
            most = APART * (1.0 if each.measure == "angle" else size_of_joint(joint, engine))
            for side, much in beyond(each, value):
                if much > most:
                    yield joint, side, much
