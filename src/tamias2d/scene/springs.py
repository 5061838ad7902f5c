"""Springs, perhaps with a damper beside them: between two bodies, or a body and a point (IM7)."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from tamias2d.scene.bodies import Body
from tamias2d.scene.law import Value
from tamias2d.scene.rules import RuleError, Vector, number, vector
from tamias2d.spec.library_functions import cos, sin
from tamias2d.suggestions import suggests


@suggests
@dataclass(frozen=True, kw_only=True)
class Spring:
    """One spring of a scene, checked; made by `Scene.add_spring`."""

    first: int
    """Index of the body at one end."""
    second: int | None
    """Index of the body at the other end; None where that is fixed to a point."""
    point: Vector = (0.0, 0.0)
    """Where the other end is fixed if no body is there, m."""
    stiffness: float
    """N/m"""
    rest_length: float
    """Length at which it neither pulls nor pushes, m."""
    damping: float = 0.0
    """Force per speed at which it lengthens, kg/s."""
    anchor: Vector = (0.0, 0.0)
    """Where it holds the first body, in the body's own axes, from its centre of mass, m."""
    other_anchor: Vector = (0.0, 0.0)
    """Where it holds the second body, likewise, m."""

    @property
    def bodies(self) -> tuple[int, ...]:
        """The one or two bodies that it holds."""
        return (self.first,) if self.second is None else (self.first, self.second)

    @property
    def ends(self) -> tuple[tuple[int, Vector], ...]:
        """Each body that it holds, with the anchor there, m."""
        return tuple(zip(self.bodies, (self.anchor, self.other_anchor), strict=False))


def arm(anchor: tuple[Value, Value], orientation: Value) -> tuple[Value, Value]:
    """Return an anchor, m, in the axes of the world; floats, or arrays for many bodies."""
    x, y = anchor
    cosine, sine = cos(orientation), sin(orientation)
    return cosine * x - sine * y, sine * x + cosine * y


def checked_spring(
    ends: tuple[int, int | None],
    of: str,
    *,
    point: object,
    stiffness: object,
    rest_length: object,
    damping: object,
    anchor: object,
    other_anchor: object,
) -> Spring:
    """Return a spring with good values, or raise `RuleError`."""
    first, second = ends
    axes = "Give (x, y) in m, in the body's axes."
    place = "Give (x, y) in m, or the name of a body."
    length = "Give the length without load in m, 0 for none."
    firm = "Give a positive stiffness in N/m."
    return Spring(
        first=first,
        second=second,
        point=vector(point, "position", of, place, at=("point",)),
        stiffness=number(stiffness, "stiffness", of, firm, at=("stiffness",)),
        rest_length=number(rest_length, "rest_length", of, length, at=("rest_length",)),
        damping=number(damping, "damping", of, "Give it in kg/s, 0 for none.", at=("damping",)),
        anchor=vector(anchor, "arm", of, axes, at=("anchor",)),
        other_anchor=vector(other_anchor, "arm", of, axes, at=("other_anchor",)),
    )


def refuse_spring(spring: Spring, bodies: Sequence[Body], of: str) -> None:
    """Refuse a spring that moves nothing, holds one body twice, or pulls in no direction."""
    held = [bodies[k] for k in spring.bodies]
    if not any(body.dynamic for body in held):
        raise RuleError(f"{of}: it holds no body that moves (IM7). Name one that does.", "bodies")
    if spring.first == spring.second:
        raise RuleError(f"{of}: both ends hold one body (IM7). Name two bodies.", "bodies")
    if spring.second is None and spring.other_anchor != (0, 0):
        raise RuleError(
            f"other anchor of {of}: a point has none (IM7). Move the point itself.", "other_anchor"
        )
    for (k, anchor), key in zip(spring.ends, ("anchor", "other_anchor"), strict=False):
        body = bodies[k]
        unknown = body.dynamic and body.inertia == math.inf and not body.inertia_stated
        if anchor != (0, 0) and unknown:
            raise RuleError(
                f"{key.replace('_', ' ')} of {of}: '{body.name}' has no inertia, and a pull "
                "beside its centre would turn it (IM2, IM7). State its inertia.",
                key,
            )
    if spring.rest_length > 0 and _start_length(spring, bodies) == 0:
        raise RuleError(
            f"{of}: its ends are at one place at the start, so that its push has no direction "
            "(IM7). Move one end, or give it a rest length of 0 m.",
            "rest_length",
        )


def _start_length(spring: Spring, bodies: Sequence[Body]) -> float:
    ends = [_start(bodies[k], anchor) for k, anchor in spring.ends]
    if spring.second is None:
        ends.append(spring.point)
    return math.dist(*ends)


def _start(body: Body, anchor: Vector) -> Vector:
    x, y = arm(anchor, body.orientation)
    return body.position[0] + x, body.position[1] + y
