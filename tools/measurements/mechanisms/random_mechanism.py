"""Random mechanisms: bodies without shapes in a tree of joints, with loops."""

import math
import random
from typing import Any

from tamias2d.scene import Distance, Equation, Groove, Limits, Prismatic, Revolute, Scene, Weld
from tools.measurements.mechanisms.scenes import G

LIMITS, EQUATIONS = "limits", "equations"


def random_mechanism(
    seed: int, more: str | None = None, *, name: str = "", duration: float | None = None
) -> Scene:
    """Two to eight bodies in a tree of joints of all kinds, with a loop now and then.

    There may be `more`: limits that bounce, or equations of one's own instead of some kinds.
    """
    rng, scene = random.Random(seed), Scene(gravity=(0.0, -G), name=name, duration=duration)
    for k in range(rng.randint(2, 8)):
        place, turn = (rng.uniform(-2, 2), rng.uniform(-2, 2)), rng.uniform(-3, 3)
        mass, inertia = 10 ** rng.uniform(-1, 1), 10 ** rng.uniform(-2, 0)
        scene.add_body(None, mass=mass, inertia=inertia, position=place, orientation=turn)
        if k or rng.random() < 0.7:
            _tie(scene, rng, rng.randrange(k) if k else None, k, more)
        if k > 2 and rng.random() < 0.2:
            _tie(scene, rng, rng.randrange(k - 1), k, more)
    return scene


def _tie(
    scene: Scene, rng: random.Random, first: int | None, second: int, more: str | None
) -> None:
    """Tie two bodies, or one and the plane, by any joint that fits where they are."""
    at = (rng.uniform(-2, 2), rng.uniform(-2, 2))
    axis = (math.cos(angle := rng.uniform(-3, 3)), math.sin(angle))
    kinds = (Revolute(), Revolute(), Revolute(), Weld(), Prismatic(axis=axis), Groove(axis=axis))
    kind: Any = rng.choice((*kinds, Distance()))
    own = local(scene, second, at)
    turn = scene.bodies[second].orientation
    turn -= 0.0 if first is None else scene.bodies[first].orientation
    if isinstance(kind, Distance):
        own = (rng.uniform(-1, 1), rng.uniform(-1, 1))
    elif more == LIMITS:
        kind = _limited(kind, axis, turn, rng)
    elif more == EQUATIONS:
        kind = _stated(kind, turn, rng)
    if first is None:
        scene.add_joint(kind, at, second, other_anchor=own)
    else:
        scene.add_joint(kind, first, second, anchor=local(scene, first, at), other_anchor=own)


def local(scene: Scene, k: int, at: tuple[float, float]) -> tuple[float, float]:
    """Return where a place is in the axes of a body, m."""
    body = scene.bodies[k]
    x, y = at[0] - body.position[0], at[1] - body.position[1]
    c, s = math.cos(body.orientation), math.sin(body.orientation)
    return c * x + s * y, c * y - s * x


def _limited(kind: Any, axis: tuple[float, float], turn: float, rng: random.Random) -> Any:
    """Return a kind of joint with limits that bounce, if it may have any; its angle is a `turn`."""
    lower, upper, restitution = rng.uniform(-1, 0), rng.uniform(0, 1), rng.uniform(0, 1)
    if isinstance(kind, Revolute):
        ends = {"lower": turn + lower, "upper": turn + upper}
        return Revolute(limits=Limits(restitution=restitution, **ends))
    if isinstance(kind, Prismatic):
        limits = Limits(restitution=restitution, lower=lower, upper=upper)
        return Prismatic(axis=axis, limits=limits)
    return kind


def _stated(kind: Any, turn: float, rng: random.Random) -> Any:
    """Return an equation instead of a kind, or the kind.

    It holds where the points of the joint are at one place, and its angle is a `turn`.
    """
    a, b = rng.uniform(-2, 2), rng.uniform(-2, 2)
    along = "dot(rotate(vector(1, 0), orientation_a), point_b - point_a)"
    across = "dot(rotate(vector(0, 1), orientation_a), point_b - point_a)"
    stated: dict[type, Any] = {
        Revolute: "point_b - point_a",
        Groove: f"{across} - {a!r}*({along})**2/1[m]",
        Weld: ["point_b - point_a", f"sin((orientation_b - orientation_a - {turn!r})/2)"],
        Prismatic: f"{across} + {b!r}*1[m]*(cos({along}/1[m]) - 1)",
    }
    return Equation(stated[type(kind)]) if rng.random() < 0.5 and type(kind) in stated else kind
