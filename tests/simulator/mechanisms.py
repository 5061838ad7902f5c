"""Mechanisms that several tests of joints look at, and what they must keep."""

import math
import random
from typing import Any

import numpy as np

import tamias2d as t2
from tamias2d.scene import Revolute, Scene
from tamias2d.simulator import Simulator
from tests.engine.scenes import ground

G = 10.0


def pendulum() -> Scene:
    """A bob of 1 kg that starts level, 1 m from its hinge."""
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=1.0, inertia=0.1, position=(1.0, 0.0), name="bob")
    scene.add_joint(Revolute(), "bob", (0.0, 0.0), anchor=(-1.0, 0.0))
    return scene


def chain(count: int, *, last: float = 1.0) -> Scene:
    """Links of 1 m and 1 kg, hanging straight down from the origin; the last one may be heavy."""
    scene = Scene(gravity=(0.0, -G))
    shape = t2.Capsule(length=0.8, radius=0.1)
    for k in range(count):
        mass = last if k == count - 1 else 1.0
        place = (0.0, -0.5 - k)
        turned = {"inertia": mass / 12, "orientation": -math.pi / 2}
        scene.add_body(shape, mass=mass, position=place, restitution=0.0, **turned)
        upper: Any = (0.0, 0.0) if k == 0 else k - 1
        anchor = (0.0, 0.0) if k == 0 else (0.5, 0.0)
        scene.add_joint(Revolute(), upper, k, anchor=anchor, other_anchor=(-0.5, 0.0))
    return scene


def energy(sim: Simulator, scene: Scene) -> float:
    """Return how much energy motion and height have, J."""
    mass = np.array([body.mass if body.dynamic else 0.0 for body in scene.bodies])
    inertia = np.array([body.inertia if body.dynamic else 0.0 for body in scene.bodies])
    moving = 0.5 * (mass @ (sim.velocity**2).sum(axis=1) + inertia @ sim.angular_velocity**2)
    return float(moving - mass @ (sim.position @ np.array(scene.gravity)))


def free_rods(rng: random.Random, count: int) -> Scene:
    """Rods pinned to each other in a row, spinning at random, with nothing else in the world."""
    scene = Scene(gravity=(0.0, 0.0))
    velocity = np.array([rng.gauss(0, 1), rng.gauss(0, 1)])
    for k in range(count):
        spin = rng.gauss(0, 2)
        velocity[1] += 0.5 * spin
        scene.add_body(
            None,
            mass=rng.uniform(0.5, 5.0),
            inertia=rng.uniform(0.05, 0.5),
            position=(float(k), 0.0),
            velocity=tuple(velocity.tolist()),
            angular_velocity=spin,
        )
        velocity[1] += 0.5 * spin
        if k:
            scene.add_joint(Revolute(), k - 1, k, anchor=(0.5, 0.0), other_anchor=(-0.5, 0.0))
    return scene


def momenta(sim: Simulator, scene: Scene) -> tuple[np.ndarray[Any, Any], float]:
    """Return the momentum, kg m/s, and the angular momentum about the origin, kg m^2/s."""
    mass = np.array([body.mass for body in scene.bodies])
    inertia = np.array([body.inertia for body in scene.bodies])
    (x, y), (u, v) = sim.position.T, sim.velocity.T
    return mass @ sim.velocity, float(mass @ (x * v - y * u) + inertia @ sim.angular_velocity)


def governed(**law: Any) -> Scene:
    """A bob of 1 kg on an arm of 1 m, level, whose hinge is governed by something."""
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=1.0, inertia=0.1, position=(1.0, 0.0), name="bob")
    scene.add_joint(Revolute(**law), (0.0, 0.0), "bob", other_anchor=(-1.0, 0.0))
    return scene


def links_on_the_ground(count: int = 4, *, collide: bool = False) -> Scene:
    """Discs of 1 kg in a row, each hinged to the next, that may touch each other or not."""
    scene = Scene(gravity=(0.0, -G))
    ground(scene, 0.5)
    for k in range(count):
        place = (0.8 * k, 0.25)
        scene.add_body(
            t2.Disc(radius=0.25), mass=1.0, position=place, friction=0.5, restitution=0.0
        )
        if k:
            ends = (k, k + 1)
            scene.add_joint(
                Revolute(), *ends, anchor=(0.4, 0.0), other_anchor=(-0.4, 0.0), collide=collide
            )
    return scene
