"""Mechanisms in free space at which bodies are thrown, light links pinched by heavy ones."""

import math
import random
from typing import Any, NamedTuple

import numpy as np

import tamias2d as t2
from tamias2d.state import Array

_BOX = t2.Box(width=0.5, height=0.3)
_HALF = 0.4  # m, from the centre of a link to its joints
_KINDS = ("hinges", "welds", "slides", "rods", "limits", "all")
_STEPS_A_SECOND, _SHAPES = (30, 60, 120, 240), ("row", "tree", "ring")


class Pinched(NamedTuple):
    """A scene, what joins its bodies, and how it is stepped."""

    scene: t2.Scene
    joints: list[tuple[Any, int, int, float]]  # kind, bodies A and B, the end of A at which B is
    time_step: float  # s
    substeps: int

    @property
    def redundant(self) -> bool:
        """Whether joints depend on each other: a ring of more than hinges and rods."""
        ring = len({a for _, a, _, _ in self.joints} | {b for _, _, b, _ in self.joints})
        firm = any(isinstance(kind, (t2.Weld, t2.Prismatic)) for kind, *_ in self.joints)
        return firm and len(self.joints) == ring


def pinched(seed: int) -> Pinched:
    """Return two to ten links, and one to three bodies that are thrown at them."""
    chance = random.Random(seed)
    ratio, shape = 10.0 ** chance.uniform(0.0, 3.5), chance.choice(_SHAPES)
    count = chance.randint(4 if shape == "ring" else 2, 10)
    poses, tied = _links(chance, shape, count)
    alternate = chance.random() < 0.5
    scene = t2.Scene(gravity=(0.0, 0.0))
    far = np.array((chance.choice((0.0, 0.0, 1000.0)), 0.0))
    surface: dict[str, Any] = {
        "friction": chance.choice((0.0, 0.3, 0.6, 1.0)),
        "restitution": chance.choice((0.0, 0.3, 0.5, 0.9)),
    }
    for k, (place, angle) in enumerate(poses):
        mass = (ratio if k % 2 == 0 else 1.0) if alternate else ratio ** chance.random()
        velocity = np.array((chance.gauss(0.0, 0.5), chance.gauss(0.0, 0.5)))
        _add(scene, chance, mass, far + place, velocity, angle, surface)
    speed = chance.choice((1.0, 1.0, 4.0))
    reach = max(math.hypot(*place) for place, _ in poses) + 0.7
    for k in range(chance.randint(1, 3)):
        angle = chance.uniform(0.0, math.tau)
        out = np.array((math.cos(angle), math.sin(angle)))
        place = far + (reach + k) * out
        velocity = -chance.uniform(2.0, 8.0) * speed * out
        _add(scene, chance, ratio ** chance.uniform(0.5, 1.0), place, velocity, 0.0, surface)
    wanted = chance.choice(_KINDS)
    joints = [(_joint(chance, wanted, shape), a, b, end) for a, b, end in tied]
    return Pinched(scene, joints, 1.0 / chance.choice(_STEPS_A_SECOND), chance.randint(2, 8))


def simulator(case: Pinched) -> t2.Simulator:
    """Return a simulator of a case; velocities fit its joints after a step."""
    sim = t2.Simulator(case.scene, time_step=case.time_step, substeps=case.substeps)
    for kind, a, b, end in case.joints:
        inward = 0.5 if isinstance(kind, t2.Distance) else 1.0  # a rod has a length
        near, far = (inward * end, 0.0), (-inward * _HALF, 0.0)
        sim.add_joint(kind, a, b, anchor=near, other_anchor=far)
    return sim


def _links(
    chance: random.Random, shape: str, count: int
) -> tuple[list[tuple[Array, float]], list[tuple[int, int, float]]]:
    """Return the places and angles of links, and what is tied to which end of what."""
    if shape == "ring":
        out = _HALF / math.tan(math.pi / count)
        turns = [math.tau * k / count for k in range(count)]
        ring = [(np.array((out * math.cos(a), out * math.sin(a))), a + math.pi / 2) for a in turns]
        return ring, [(k, (k + 1) % count, _HALF) for k in range(count)]
    poses: list[tuple[Array, float]] = [(np.zeros(2), chance.uniform(-3.0, 3.0))]
    tied = []
    for k in range(1, count):
        above = k - 1 if shape == "row" else chance.randrange(k)
        end = _HALF if shape == "row" else chance.choice((-_HALF, _HALF))
        place, angle = poses[above]
        bend = 0.7 if shape == "row" else 3.0
        turned = angle + chance.uniform(-bend, bend)
        hinge = place + end * np.array((math.cos(angle), math.sin(angle)))
        poses.append((hinge + _HALF * np.array((math.cos(turned), math.sin(turned))), turned))
        tied.append((above, k, end))
    return poses, tied


def _joint(chance: random.Random, wanted: str, shape: str) -> Any:
    limited = t2.Limits(lower=-1.0, upper=1.0, restitution=0.0)
    kinds = {
        "hinges": t2.Revolute(),
        "welds": t2.Weld(),
        "slides": t2.Prismatic(axis=(1.0, 0.0)),
        "rods": t2.Distance(),
        "limits": t2.Revolute(limits=limited if shape == "row" else None),
    }
    return kinds[chance.choice(sorted(kinds)) if wanted == "all" else wanted]


def _add(
    scene: t2.Scene,
    chance: random.Random,
    mass: float,
    place: Array,
    velocity: Array,
    angle: float,
    surface: dict[str, Any],
) -> None:
    scene.add_body(
        _BOX,
        mass=mass,
        position=(float(place[0]), float(place[1])),
        velocity=(float(velocity[0]), float(velocity[1])),
        orientation=angle,
        angular_velocity=chance.gauss(0.0, 2.0),
        **surface,
    )
