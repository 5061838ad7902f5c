"""Random mechanisms with limits and motors: long trees of hinges, and of all kinds, with loops."""

import math
import random
from collections.abc import Sequence
from typing import Any

from tamias2d.scene import Distance, Groove, Limits, Motor, Prismatic, Revolute, Scene, Weld
from tools.measurements.mechanisms.random_mechanism import local
from tools.measurements.mechanisms.scenes import G

_MOST = 40  # bodies
_SPREAD = (0.3, 1.0, 2.0)  # m, from a body to those that hang on it
_BRANCHES = 3  # a body hangs on one of so many before it
_LOOPS = 0.1  # share of bodies with a second joint


def limited_mechanism(seed: int, *, motors: bool) -> Scene:
    """Two to forty bodies: in a tree of hinges, or in one of all kinds of joints, with loops.

    Limits stop, or bounce; half of what has any may have a motor too, which gives up to 100 N or
    N m.
    """
    rng, scene = random.Random(seed), Scene(gravity=(0.0, -G))
    spread, hinged = rng.choice(_SPREAD), rng.random() < 0.5
    for k in range(round(math.exp(rng.uniform(math.log(2), math.log(_MOST))))):
        above = rng.randrange(max(0, k - _BRANCHES), k) if k else None
        _add_body(scene, rng, above, spread)
        if k or rng.random() < 0.7:
            _tie(scene, rng, above, k, spread, _kinds(rng, hinged), motors)
        if k > 2 and not hinged and rng.random() < _LOOPS:
            _tie(scene, rng, rng.randrange(k - 1), k, spread, _kinds(rng, hinged), motors)
    return scene


def _add_body(scene: Scene, rng: random.Random, above: int | None, spread: float) -> None:
    x, y = (0.0, 0.0) if above is None else scene.bodies[above].position
    place = (x + rng.uniform(-spread, spread), y + rng.uniform(-spread, spread))
    mass = 10 ** rng.uniform(-1, 1)
    inertia = mass * spread**2 * 10 ** rng.uniform(-2, 0)
    turn = rng.uniform(-3, 3)
    scene.add_body(None, mass=mass, inertia=inertia, position=place, orientation=turn)


def _kinds(rng: random.Random, hinged: bool) -> Sequence[Any]:
    axis = (math.cos(angle := rng.uniform(-3, 3)), math.sin(angle))
    others = (Weld(), Prismatic(axis=axis), Groove(axis=axis), Distance())
    return (Revolute(),) if hinged else (*4 * (Revolute(),), *others)


def _tie(
    scene: Scene,
    rng: random.Random,
    first: int | None,
    second: int,
    spread: float,
    kinds: Sequence[Any],
    motors: bool,
) -> None:
    """Tie two bodies, or one and the plane, about half-way between them."""
    from_x, from_y = (0.0, 0.0) if first is None else scene.bodies[first].position
    to_x, to_y = scene.bodies[second].position
    x = (from_x + to_x) / 2 + rng.uniform(-0.3, 0.3) * spread
    y = (from_y + to_y) / 2 + rng.uniform(-0.3, 0.3) * spread
    turn = scene.bodies[second].orientation
    turn -= 0.0 if first is None else scene.bodies[first].orientation
    kind, own = _governed(rng.choice(kinds), turn, rng, motors), local(scene, second, (x, y))
    if isinstance(kind, Distance):
        own = (rng.uniform(-spread, spread), rng.uniform(-spread, spread))
    if first is None:
        scene.add_joint(kind, (x, y), second, other_anchor=own)
    else:
        scene.add_joint(kind, first, second, anchor=local(scene, first, (x, y)), other_anchor=own)


def _governed(kind: Any, turn: float, rng: random.Random, motors: bool) -> Any:
    """Return a kind of joint with limits, and maybe a motor, if it may have any."""
    if not isinstance(kind, Revolute | Prismatic):
        return kind
    middle = turn if isinstance(kind, Revolute) else 0.0
    limits = Limits(
        lower=middle + rng.uniform(-1, 0),
        upper=middle + rng.uniform(0, 1),
        restitution=rng.choice((0.0, rng.random())),
    )
    motor = None
    if motors and rng.random() < 0.5:
        motor = Motor(speed=rng.uniform(-5, 5), maximum=10 ** rng.uniform(-1, 2))
    if isinstance(kind, Revolute):
        return Revolute(limits=limits, motor=motor)
    return Prismatic(axis=kind.axis, limits=limits, motor=motor)
