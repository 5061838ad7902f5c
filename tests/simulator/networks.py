"""Networks of springs at random, and what they must conserve."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

import tamias2d as t2
from tamias2d.simulator import Simulator
from tamias2d.state import Array


@dataclass(frozen=True, kw_only=True)
class Network:
    """How a network is made."""

    seed: int
    bodies: int
    stiffest: float
    """N/m; from 10 on"""
    mass_ratio: float
    anchored: bool = False
    damping: float = 0.0
    loose: bool = False
    """whether rest lengths are zero"""


def scene_of(network: Network, *, gravity: tuple[float, float] = (0.0, 0.0)) -> t2.Scene:
    """A chain of discs with some springs across; nothing of it collides."""
    random = np.random.default_rng(network.seed)
    scene = t2.Scene(gravity=gravity)
    for k in range(network.bodies):
        scene.add_body(
            t2.Disc(radius=0.1),
            mass=float(network.mass_ratio ** random.uniform()),
            position=(4.0 * k + random.uniform(-1, 1), random.uniform(-1, 1)),
            orientation=float(random.uniform(0, 6)),
            velocity=tuple(random.normal(size=2)),
            angular_velocity=float(random.normal()),
            friction=0.0,
            restitution=0.0,
            group=-1,
        )
    ends = [(k, k + 1) for k in range(network.bodies - 1)]
    if network.bodies > 2:
        ends += [(k, k + 2) for k in range(0, network.bodies - 2, 2)]
    for a, b in ends:
        anchors = random.uniform(-0.3, 0.3, (2, 2)) if network.anchored else np.zeros((2, 2))
        first, second = (place(scene.bodies[k], anchors[n]) for n, k in enumerate((a, b)))
        length = 0.0 if network.loose else math.dist(first, second)
        scene.add_spring(
            a,
            b,
            stiffness=float(10 * (network.stiffest / 10) ** random.uniform()),
            rest_length=length * random.uniform(0.98, 1.02),
            damping=network.damping,
            anchor=tuple(anchors[0]),
            other_anchor=tuple(anchors[1]),
        )
    return scene


def place(body: Any, anchor: Array) -> Array:
    """Where an anchor of a body of a scene is at the start."""
    return at(np.array(body.position), body.orientation, anchor)


def at(position: Array, orientation: float, anchor: Any) -> Array:
    """Where an anchor is."""
    cosine, sine = math.cos(orientation), math.sin(orientation)
    x, y = anchor
    return position + np.array([cosine * x - sine * y, sine * x + cosine * y])


@dataclass(frozen=True)
class Totals:
    """What bodies and springs have together."""

    energy: float
    momentum: Array
    angular_momentum: float


def totals(scene: t2.Scene, sim: Simulator) -> Totals:
    """Add up the bodies that move, and the energy of all springs, without gravity's."""
    free = np.array([body.dynamic for body in scene.bodies])
    mass = np.array([body.mass for body in scene.bodies])[free]
    inertia = np.array([body.inertia for body in scene.bodies])[free]
    x, v, w = sim.position[free], sim.velocity[free], sim.angular_velocity[free]
    energy = 0.5 * float((mass * (v**2).sum(axis=1) + inertia * w**2).sum())
    weight = np.array(scene.gravity)
    energy -= float(mass @ (x @ weight))
    for spring in scene.springs:
        ends = [at(sim.position[k], sim.orientation[k], anchor) for k, anchor in spring.ends]
        if spring.second is None:
            ends.append(np.array(spring.point))
        energy += 0.5 * spring.stiffness * (math.dist(*ends) - spring.rest_length) ** 2
    turning = mass * (x[:, 0] * v[:, 1] - x[:, 1] * v[:, 0]) + inertia * w
    return Totals(energy, mass @ v, float(turning.sum()))
