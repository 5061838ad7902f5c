"""Scenes that no choice was tuned on: made at random, always the same."""

import math
from collections.abc import Iterator

import numpy as np

from tamias2d.scene import Disc, HalfPlane, Scene

SEED = 1618  # nothing was tuned on these; 2718 and 31415 showed what had to be mended
_EACH = 6
_G = (0.0, -9.81)


def scenes() -> Iterator[Scene]:
    """Yield throws through air, springs, orbits and bouncing discs, six of each."""
    random = np.random.default_rng(SEED)
    for make in (_throw, _springs, _orbit, _bounces):
        for k in range(_EACH):
            yield make(random, k)


def _throw(random: np.random.Generator, k: int) -> Scene:
    scene = Scene(gravity=_G, name=f"throw {k}", duration=float(random.uniform(1.0, 5.0)))
    for _ in range(3):
        angle, speed = random.uniform(0, math.pi), random.uniform(5, 60)
        scene.add_body(
            None,
            mass=float(random.uniform(0.1, 5.0)),
            position=(float(random.uniform(-3, 3)), float(random.uniform(0, 10))),
            velocity=(float(speed * math.cos(angle)), float(speed * math.sin(angle))),
            quadratic_drag=float(10 ** random.uniform(-3, -1)),
            linear_drag=float(random.uniform(0, 0.3)) if k % 2 else 0.0,
        )
    return scene


def _springs(random: np.random.Generator, k: int) -> Scene:
    scene = Scene(gravity=_G, name=f"springs {k}", duration=float(random.uniform(2.0, 6.0)))
    count = 1 + k % 4
    for i in range(count):
        place = (float(i + random.uniform(-0.2, 0.2)), float(random.uniform(-0.3, 0.3)))
        scene.add_body(None, mass=float(random.uniform(0.2, 3.0)), position=place)
        stiffness, rest = float(random.uniform(20, 300)), float(random.uniform(0.2, 1.0))
        damping = float(random.uniform(0, 1.0)) if k % 2 else 0.0
        other: int | tuple[float, float] = i - 1 if i else (-1.0, 0.5)
        scene.add_spring(i, other, stiffness=stiffness, rest_length=rest, damping=damping)
    return scene


def _orbit(random: np.random.Generator, k: int) -> Scene:
    eccentricity = float(random.uniform(0.0, 0.75))
    scene = Scene(gravity=(0.0, 0.0), name=f"orbit {k}", duration=float(random.uniform(5.0, 25.0)))
    near, speed = 1 - eccentricity, math.sqrt((1 + eccentricity) / (1 - eccentricity))
    if k % 2:
        scene.add_body(None, mass=1.0, position=(near, 0.0), velocity=(0.0, speed))
        pull = [f"-1[m^3/s^2]*mass*{axis}(position)/norm(position)**3" for axis in "xy"]
        scene.add_field(force=pull)
        return scene
    share = float(random.uniform(0.05, 0.5))
    for part, side in ((share, 1 - share), (1 - share, -share)):
        scene.add_body(None, mass=part, position=(near * side, 0.0), velocity=(0.0, speed * side))
    scene.add_attraction(gravitational_constant=1.0)
    return scene


def _bounces(random: np.random.Generator, k: int) -> Scene:
    scene = Scene(gravity=_G, name=f"bounces {k}", duration=float(random.uniform(2.0, 4.0)))
    for i in range(1 + k % 3):
        scene.add_body(
            Disc(radius=float(random.uniform(0.1, 0.4))),
            mass=float(random.uniform(0.5, 2.0)),
            position=(2.0 * i + float(random.uniform(-0.5, 0.5)), float(random.uniform(1.0, 3.0))),
            velocity=(float(random.uniform(-2, 2)), float(random.uniform(-1, 3))),
            restitution=float(random.uniform(0.6, 1.0)),
            quadratic_drag=float(random.uniform(0.01, 0.1)) if k >= _EACH // 2 else 0.0,
        )
    walls = (((0.0, 1.0), 0.0), ((1.0, 0.0), -2.0), ((-1.0, 0.0), -7.0))
    for normal, offset in walls:
        scene.add_static(HalfPlane(normal=normal, offset=offset), restitution=0.95)
    return scene
