"""Random mechanisms: bodies without shapes in a tree of joints, with loops."""

import math
import random

from tamias2d.scene import Distance, Groove, Prismatic, Revolute, Scene, Weld
from tools.measurements.mechanisms.scenes import G


def random_mechanism(seed: int) -> Scene:
    """Two to eight bodies in a tree of joints of all kinds, with a loop now and then."""
    rng, scene = random.Random(seed), Scene(gravity=(0.0, -G))
    for k in range(rng.randint(2, 8)):
        place, turn = (rng.uniform(-2, 2), rng.uniform(-2, 2)), rng.uniform(-3, 3)
        mass, inertia = 10 ** rng.uniform(-1, 1), 10 ** rng.uniform(-2, 0)
        scene.add_body(None, mass=mass, inertia=inertia, position=place, orientation=turn)
        if k or rng.random() < 0.7:
            _tie(scene, rng, rng.randrange(k) if k else None, k)
        if k > 2 and rng.random() < 0.2:
            _tie(scene, rng, rng.randrange(k - 1), k)
    return scene


def _tie(scene: Scene, rng: random.Random, first: int | None, second: int) -> None:
    """Tie two bodies, or one and the plane, by any joint that fits where they are."""
    at = (rng.uniform(-2, 2), rng.uniform(-2, 2))
    axis = (math.cos(turn := rng.uniform(-3, 3)), math.sin(turn))
    kinds = (Revolute(), Revolute(), Revolute(), Weld(), Prismatic(axis=axis), Groove(axis=axis))
    kind = rng.choice((*kinds, Distance()))
    own = _local(scene, second, at)
    if isinstance(kind, Distance):
        own = (rng.uniform(-1, 1), rng.uniform(-1, 1))
    if first is None:
        scene.add_joint(kind, at, second, other_anchor=own)
    else:
        scene.add_joint(kind, first, second, anchor=_local(scene, first, at), other_anchor=own)


def _local(scene: Scene, k: int, at: tuple[float, float]) -> tuple[float, float]:
    body = scene.bodies[k]
    x, y = at[0] - body.position[0], at[1] - body.position[1]
    c, s = math.cos(body.orientation), math.sin(body.orientation)
    return c * x + s * y, c * y - s * x
