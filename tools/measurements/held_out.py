"""Scenes that no choice was tuned on: made at random, always the same."""

import math
from collections.abc import Iterator

import numpy as np

from tamias2d.scene import Box, Compound, Disc, HalfPlane, Part, Scene
from tools.measurements.mechanisms.random_mechanism import random_mechanism

SEED = 577215  # nothing was tuned on these; 1618, 2718 and 31415 showed what had to be mended
_EACH = 6
_G = (0.0, -9.81)


def scenes(seed: int = SEED) -> Iterator[Scene]:
    """Yield throws through air, springs, orbits, bouncing discs and mechanisms, six of each."""
    random = np.random.default_rng(seed)
    for make in (_throw, _springs, _orbit, _bounces, _mechanism):
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


def _mechanism(random: np.random.Generator, k: int) -> Scene:
    """Bodies in a tree of joints, with loops: they may be rigid, or turn over chaotically."""
    seed, duration = int(random.integers(2**31)), float(random.uniform(1.0, 3.0))
    return random_mechanism(seed, name=f"mechanism {k}", duration=duration)


def stepped_scenes(seed: int = SEED) -> Iterator[Scene]:
    """Yield slopes, drops and platforms, six of each, whose contacts are stepped."""
    random = np.random.default_rng(seed)
    for make in (_slope, _drop, _platform):
        for k in range(_EACH):
            yield make(random, k)


def _slope(random: np.random.Generator, k: int) -> Scene:
    """Boxes of several frictions, one of them made of two parts."""
    scene = Scene(gravity=_G, name=f"slope {k}", duration=float(random.uniform(1.0, 3.0)))
    turn = -float(random.uniform(0.1, 0.6))
    up = (-math.sin(turn), math.cos(turn))
    scene.add_static(HalfPlane(normal=up, offset=0.0), restitution=0.0, friction=1.0)
    for i in range(3):
        shape = _brick(random) if i == 0 else Box(width=1.0, height=float(random.uniform(0.5, 1)))
        high = 0.5 if isinstance(shape, Compound) else shape.height / 2
        along = 4.0 * i
        scene.add_body(
            shape,
            mass=float(random.uniform(0.5, 3.0)),
            position=(along * up[1] + high * up[0], -along * up[0] + high * up[1]),
            orientation=turn,
            friction=float(random.uniform(0.0, 1.0)),
            restitution=0.0,
        )
    return scene


def _drop(random: np.random.Generator, k: int) -> Scene:
    """Bodies side by side above a floor, one of them made of two parts."""
    scene = Scene(gravity=_G, name=f"drop {k}", duration=float(random.uniform(0.8, 1.5)))
    loss = float(random.uniform(0.0, 0.6))
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=0.5, restitution=loss)
    for i in range(1 + k % 3):
        scene.add_body(
            _brick(random) if i == 0 else Disc(radius=float(random.uniform(0.2, 0.5))),
            mass=float(random.uniform(0.5, 3.0)),
            position=(3.0 * i, float(random.uniform(1.0, 2.5))),
            orientation=float(random.uniform(-0.6, 0.6)),
            velocity=(float(random.uniform(-0.5, 0.5)), 0.0),
            friction=float(random.uniform(0.2, 0.9)),
            restitution=loss,
        )
    return scene


def _platform(random: np.random.Generator, k: int) -> Scene:
    """A stack on a platform that moves at a constant velocity."""
    scene = Scene(gravity=_G, name=f"platform {k}", duration=float(random.uniform(1.0, 3.0)))
    speed = float(random.uniform(-0.6, 0.6))
    scene.add_kinematic(
        Box(width=20.0, height=1.0),
        position=(0.0, -0.5),
        velocity=(speed, 0.0),
        friction=float(random.uniform(0.2, 0.8)),
        restitution=0.0,
    )
    for i in range(1 + k % 3):
        scene.add_body(
            Box(width=1.0, height=0.5),
            mass=float(random.uniform(0.5, 3.0)),
            position=(0.05 * i, 0.25 + 0.5 * i),
            friction=float(random.uniform(0.3, 0.9)),
            restitution=0.0,
        )
    return scene


def _brick(random: np.random.Generator) -> Compound:
    """Return two boxes side by side, 1 m high together."""
    wide = float(random.uniform(0.5, 1.0))
    half = Box(width=wide, height=1.0)
    return Compound(parts=[Part(shape=half, position=(s * wide / 2, 0.0)) for s in (-1, 1)])
