"""Scenes of joints: nets, chains, bridges, ragdolls and a driven bar."""

import math
import random
from typing import Any

from tamias2d.scene import (
    Box,
    Capsule,
    Disc,
    HalfPlane,
    Joint,
    JointSpring,
    Motor,
    Revolute,
    Rotary,
    Scene,
)

G = 10.0
_SURFACE: dict[str, Any] = {"friction": 0.6, "restitution": 0.0}


def net(side: int) -> Scene:
    """Box2D's joint grid: discs, each hinged to four neighbours, hung by seven at the top."""
    scene = Scene(gravity=(0.0, -G))
    for k in range(side * side):
        x, y = divmod(k, side)
        held = y == 0 and abs(x - side // 2) <= 3
        place: dict[str, Any] = {"position": (float(x), float(-y)), **_SURFACE}
        if held:
            scene.add_static(Disc(radius=0.4), **place)
        else:
            scene.add_body(Disc(radius=0.4), mass=0.5, **place)
        if y:
            scene.add_joint(Revolute(), k - 1, k, anchor=(0.0, -0.5), other_anchor=(0.0, 0.5))
        if x and (scene.bodies[k - side].dynamic or not held):
            scene.add_joint(Revolute(), k - side, k, anchor=(0.5, 0.0), other_anchor=(-0.5, 0.0))
    return scene


def ball_and_chain(count: int = 40) -> Scene:
    """A chain that starts level, with a ball of 672 times the mass of a link at its end."""
    scene = Scene(gravity=(0.0, -G))
    for k in range(count):
        shape, place = Capsule(length=0.7, radius=0.125), (k + 0.5, 0.0)
        scene.add_body(shape, mass=1.0, position=place, **_SURFACE)
        _hinge(scene, (0.0, 0.0) if k == 0 else k - 1, k, 0.0 if k == 0 else 0.5, -0.5)
    scene.add_body(Disc(radius=8.0), mass=672.0, position=(count + 8.0, 0.0), **_SURFACE)
    _hinge(scene, count - 1, count, 0.5, -8.0)
    return scene


def bridge(planks: int = 40) -> Scene:
    """Planks that start as an arc between two banks, a twentieth nearer than they reach."""
    scene = Scene(gravity=(0.0, -G))
    half = 0.55  # rad, of the arc
    step = 2 * half / planks
    radius = 0.5 / math.sin(step / 2)
    ends = [-half + step * k for k in range(planks + 1)]
    points = [(radius * math.sin(t), radius * (math.cos(half) - math.cos(t))) for t in ends]
    for k in range(planks):
        (x, y), (u, v) = points[k], points[k + 1]
        scene.add_body(
            Capsule(length=0.7, radius=0.125),
            mass=5.0,
            position=((x + u) / 2, (y + v) / 2),
            orientation=math.atan2(v - y, u - x),
            **_SURFACE,
        )
        _hinge(scene, points[0] if k == 0 else k - 1, k, 0.5 * (k > 0), -0.5)
    scene.add_joint(Revolute(), points[-1], planks - 1, other_anchor=(0.5, 0.0))
    return scene


def chains(count: int, links: int) -> Scene:
    """Level chains, each hung at its left end, far from each other."""
    scene = Scene(gravity=(0.0, -G))
    for n in range(count):
        for k in range(links):
            body = scene.add_body(
                Capsule(length=0.7, radius=0.1),
                mass=1.0,
                position=(k + 0.5 + 50.0 * n, 0.0),
                **_SURFACE,
            )
            _hinge(scene, (50.0 * n, 0.0) if k == 0 else body - 1, body, 0.5 * (k > 0), -0.5)
    return scene


def falling_ragdolls(count: int) -> Scene:
    """Dolls of thirteen capsules that fall on the ground side by side."""
    scene = Scene(gravity=(0.0, -G))
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **_SURFACE)
    for n in range(count):
        _ragdoll(scene, 1.5 * n, 0.5, -1 - n)
    return scene


def ragdoll_heap(count: int, seed: int = 0) -> Scene:
    """Dolls that fall on each other between two walls."""
    scene, rng = Scene(gravity=(0.0, -G)), random.Random(seed)
    for normal, offset in (((0.0, 1.0), 0.0), ((1.0, 0.0), -2.0), ((-1.0, 0.0), -2.5)):
        scene.add_static(HalfPlane(normal=normal, offset=offset), **_SURFACE)
    for n in range(count):
        _ragdoll(scene, rng.uniform(-1.0, 1.0), 0.5 + 2.0 * n, -1 - n)
    return scene


def ragdoll_rain(count: int, seed: int = 0) -> Scene:
    """Dolls with springs of 5 Hz and half of critical damping, that fall between two walls."""
    scene, rng = Scene(gravity=(0.0, -G)), random.Random(seed)
    half = 0.4 * count
    for normal, offset in (((0.0, 1.0), 0.0), ((1.0, 0.0), -half), ((-1.0, 0.0), -half)):
        scene.add_static(HalfPlane(normal=normal, offset=offset), **_SURFACE)
    for n in range(count):
        x = rng.uniform(1.0 - half, half - 1.0)
        _ragdoll(scene, x, 0.5 + 2.0 * (n % 4), -1 - n, sprung=True)
    return scene


def spinner(count: int) -> Scene:
    """Box2D's spinner, smaller: a bar that a motor turns among small bodies in a ring."""
    scene = Scene(gravity=(0.0, -G))
    radius = 0.55 * math.sqrt(count)
    sides = 60
    for k in range(sides):
        turn = 2 * math.pi * k / sides
        place = (radius * math.cos(turn), radius * math.sin(turn))
        wall = Box(width=1.0, height=2 * radius * math.tan(math.pi / sides) + 0.5)
        scene.add_static(wall, position=place, orientation=turn, **_SURFACE)
    length = 0.9 * radius
    bar = Box(width=0.4, height=length)
    motor = Motor(speed=5.0, maximum=40000.0)
    spun = scene.add_body(bar, mass=length, position=(0.0, -0.5 * length), **_SURFACE)
    scene.add_joint(
        Revolute(motor=motor), (0.0, -0.5 * length), spun, name="motor", other_anchor=(0.0, 0.0)
    )
    small = (Disc(radius=0.25), Box(width=0.5, height=0.5), Capsule(length=0.5, radius=0.125))
    side = 0.6
    n = 0
    reach = int(radius / side)
    for row in range(1, reach):
        for column in range(-reach, reach + 1):
            x, y = side * column, side * row
            if n < count and math.hypot(x, y) < radius - 1.0:
                shape = small[n % 3]
                scene.add_body(shape, mass=0.05, position=(x, y), **_SURFACE)
                n += 1
    return scene


def _ragdoll(scene: Scene, x: float, y: float, group: int, *, sprung: bool = False) -> None:
    """Add a doll that stands upright, in a group of limbs that do not touch each other.

    The axes of its capsules point upwards.
    """
    first = len(scene.joints)

    def limb(at: tuple[float, float], length: float, radius: float, mass: float) -> int:
        place = (x + at[0], y + at[1])
        shape = Capsule(length=length, radius=radius)
        up = math.pi / 2
        return scene.add_body(
            shape, mass=mass, position=place, orientation=up, group=group, **_SURFACE
        )

    hip, torso = limb((0, 0.95), 0.1, 0.09, 10.0), limb((0, 1.2), 0.2, 0.09, 25.0)
    _hinge(scene, hip, torso, 0.1, -0.15)
    _hinge(scene, torso, limb((0, 1.5), 0.05, 0.08, 5.0), 0.2, -0.1)
    for _ in range(2):
        thigh, shin = limb((0, 0.7), 0.25, 0.06, 7.0), limb((0, 0.35), 0.25, 0.045, 4.0)
        _hinge(scene, hip, thigh, -0.1, 0.15)
        _hinge(scene, thigh, shin, -0.175, 0.175)
        _hinge(scene, shin, limb((0, 0.1), 0.1, 0.04, 1.0), -0.175, 0.075)
        arm, hand = limb((0, 1.225), 0.2, 0.035, 2.0), limb((0, 0.97), 0.2, 0.03, 1.5)
        _hinge(scene, torso, arm, 0.125, 0.1)
        _hinge(scene, arm, hand, -0.125, 0.13)
    if sprung:
        for k in range(first, len(scene.joints)):
            _add_spring(scene, k)


def _add_spring(scene: Scene, k: int) -> None:
    """Give a hinge a spring of 5 Hz and half of critical damping."""
    a, b = (body for body in scene.joints[k].ends if body is not None)
    pace = 2 * math.pi * 5.0
    inertia = inertia_between(scene, scene.joints[k])
    spring = JointSpring(stiffness=inertia * pace**2, damping=inertia * pace)
    scene.add_joint(Rotary(spring=spring), a, b)


def inertia_between(scene: Scene, joint: Joint) -> float:
    """Return the inertia that turns when a hinge does, kg m^2."""
    held = [scene.bodies[k].inertia for k in joint.ends[:2] if k is not None]
    return 1 / sum(1 / inertia for inertia in held)


def _hinge(scene: Scene, a: Any, b: int, at_a: float, at_b: float) -> None:
    scene.add_joint(Revolute(), a, b, anchor=(at_a, 0.0), other_anchor=(at_b, 0.0))
