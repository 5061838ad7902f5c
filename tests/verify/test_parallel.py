"""Parallel testing, as the verification plan asked for it: Pymunk computes the same scenes (TC13).

Pymunk steps with a fixed step and answers an impact at the end of the step in which it finds it.
So what it says is wrong by up to one step of each change of velocity, and that is its own error:
our answer must lie within it, and still when the step is ten times smaller.
"""

import math

import numpy as np
import pymunk
import pytest

from tamias2d.run import Run
from tamias2d.scene import Body, Disc, HalfPlane, Scene, catalogue
from tamias2d.simulate import simulate

LONG = 1e3  # m, half the length of the segment that stands for a half-plane


@pytest.mark.parametrize("step", [1e-3, 1e-4])
@pytest.mark.parametrize(
    ("name", "duration"),
    [
        ("bouncing-disc", 2.0),
        ("bouncing-elastic", 2.0),
        ("oblique-discs", 3.0),
        ("oblique-discs-unequal", 3.0),
        ("cradle", 5.0),
        ("spinning-square", 0.6),
        ("tc11", 16.0),
        ("tc14", 4.0),
    ],
)
def test_pymunk_agrees_within_its_own_error(name: str, duration: float, step: float) -> None:
    run = simulate(catalogue.load(name), duration=duration)
    theirs = positions(run.scene, duration=duration, step=step)
    assert np.abs(theirs - run.position[-1]).max() <= own_error(run, step)


def own_error(run: Run, step: float) -> float:
    """How far a step moves what was a step late, in m: by falling, and by each impact."""
    falling = math.hypot(*run.scene.gravity) * run.duration
    masses = [min(run.scene.bodies[i].mass for i in pair) for pair in run.impacts.bodies]
    jumps = sum(impulse / mass for impulse, mass in zip(run.impacts.impulse, masses, strict=True))
    return step * (falling + jumps)


def positions(scene: Scene, *, duration: float, step: float) -> np.ndarray:
    """The positions (n, 2) at the end, by Pymunk without damping, friction or correction."""
    space = pymunk.Space()
    space.gravity = scene.gravity
    space.collision_slop = 1e-7
    space.collision_bias = 0.0
    restitution = max(body.restitution or 0.0 for body in scene.bodies)
    bodies = [add(space, body, restitution) for body in scene.bodies]
    for _ in range(round(duration / step)):
        space.step(step)
    return np.array([body.position for body in bodies])


def add(space: pymunk.Space, body: Body, restitution: float) -> pymunk.Body:
    """Pymunk multiplies the elasticities of a pair, and the scenes here have one restitution."""
    if body.dynamic:
        twin = pymunk.Body(body.mass, body.inertia)
        twin.velocity, twin.angular_velocity = body.velocity, body.angular_velocity
    else:
        twin = pymunk.Body(body_type=pymunk.Body.STATIC)
    twin.position, twin.angle = body.position, body.orientation
    shape = outline(twin, body)
    shape.elasticity, shape.friction = math.sqrt(restitution), 0.0
    space.add(twin, shape)
    return twin


def outline(twin: pymunk.Body, body: Body) -> pymunk.Shape:
    match body.shape:
        case Disc(radius=radius):
            return pymunk.Circle(twin, radius)
        case HalfPlane(normal=(x, y), offset=offset):
            deep = offset - 1.0  # the segment is 1 m thick to each side
            ends = [(x * deep - y * far, y * deep + x * far) for far in (-LONG, LONG)]
            return pymunk.Segment(twin, *ends, 1.0)
        case shape:
            return pymunk.Poly(twin, shape.vertices)


def test_one_percent_of_restitution_is_seen() -> None:
    run = simulate(catalogue.load("bouncing-disc"), duration=2.0)
    scene = Scene(gravity=run.scene.gravity)
    scene.add_body(Disc(radius=0.5), mass=1.0, position=(0.0, 1.5), restitution=0.79)
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0))
    theirs = positions(scene, duration=2.0, step=1e-4)
    assert np.abs(theirs - run.position[-1]).max() > own_error(run, 1e-4)
