"""Limits that are moved past where their joints are: what takes these along, and what jumps (GD21).

Serves: `set_limits`. Hides: how much of what a joint is beyond a limit the last move of it was.
"""

from typing import NamedTuple

from tamias2d.engine.engine import Engine
from tamias2d.scene.freedoms import Freedom, Limits
from tamias2d.scene.joint_checks import values_of_freedoms
from tamias2d.scene.joints import Joint
from tamias2d.simulator.joint_separations import size_of_joint
from tamias2d.simulator.standing_bodies import StandingBodies

TAKEN_ALONG = 2.0**-4
"""Of the size of a joint, or rad: by how much a limit may pass it at once that takes it along."""
NEARLY_ALONG = 2.0
"""Times its last move, by which a joint may be behind a limit that takes it along.

A limit that goes on moving as far in each step jumps in the first one only.
"""


def beyond(freedom: Freedom, value: float) -> tuple[tuple[str, float], tuple[str, float]]:
    """Return by how much a value is beyond the lower and the upper limit of a freedom; 0 if not."""
    limits = freedom.limits or Limits(restitution=0.0)
    lower = 0.0 if limits.lower is None else max(limits.lower - value, 0.0)
    upper = 0.0 if limits.upper is None else max(value - limits.upper, 0.0)
    return ("lower", lower), ("upper", upper)


class Passed(NamedTuple):
    """A limit that was moved past where its joint is."""

    side: str
    """lower or upper"""
    beyond: float
    """m or rad, by which the joint is beyond it"""
    moved: float
    """m or rad, of these by the last move"""
    jumps: bool
    """whether that is more than takes the joint along"""
    is_far: bool
    """whether that is so beside the length of a rope or rod, too, and is told"""


def passed_limits(joint: Joint, before: Joint, engine: Engine) -> list[Passed]:
    """Return the limits of a joint that were moved past where it is: `before` had those before."""
    values = values_of_freedoms(joint, StandingBodies(engine, {}))
    found = []
    for each, old, value in zip(joint.freedoms, before.freedoms, values, strict=True):
        size = 1.0 if each.measure == "angle" else size_of_joint(joint, engine)
        length = max(size, value if each.measure == "distance" else 0.0)
        for (side, now), (_, then) in zip(beyond(each, value), beyond(old, value), strict=True):
            moved = now - then
            jumps, is_far = moved > TAKEN_ALONG * size, moved > TAKEN_ALONG * length
            if moved > 0.0:
                found.append(Passed(side, now, moved, jumps, is_far))
    return found
