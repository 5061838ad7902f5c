"""Joints in the frame loop beside Pymunk and Box2D: time of a step, drift, stretch and energy.

The programs step the same scene in turns, 60 steps each: a net, a heavy ball on a chain, a slack
bridge, chains, and ragdolls that fall side by side or on a heap. Random mechanisms follow, of our
own engine alone.
"""

import argparse
import math
import random
import time
import warnings
from collections.abc import Callable
from copy import deepcopy
from dataclasses import replace
from typing import Any

import numpy as np
from rich.console import Console

from tamias2d.errors import StepWarning
from tamias2d.scene import (
    Box,
    Capsule,
    Disc,
    Distance,
    Groove,
    HalfPlane,
    Joint,
    JointSpring,
    Motor,
    Prismatic,
    Revolute,
    Rotary,
    Scene,
    Weld,
)
from tamias2d.scene.freedoms import Freedom
from tamias2d.simulator import Simulator
from tamias2d.state import Array
from tamias2d.study.engines.box2d import Box2D
from tamias2d.study.engines.chipmunk import Chipmunk

_STEP = 1 / 60
_TURN = 60  # steps
_G = 10.0
_SURFACE: dict[str, Any] = {"friction": 0.6, "restitution": 0.0}
_APART = 1e-3  # of the reach of a joint, or rad


def options(parser: argparse.ArgumentParser) -> None:
    """Add how long and how much."""
    parser.add_argument("--seconds", type=int, default=10, help="s of simulated time")
    parser.add_argument("--side", type=int, default=30, help="discs on a side of the net")
    parser.add_argument("--ragdolls", type=int, default=20, help="that fall side by side")
    parser.add_argument("--heap", type=int, default=4, help="ragdolls that fall on each other")
    parser.add_argument("--spun", type=int, default=600, help="bodies around a driven bar")
    parser.add_argument("--random", type=int, default=500, help="random mechanisms")
    parser.add_argument("--seed", type=int, default=1_000_000, help="of the first of them")


def measure(
    seconds: int = 10,
    side: int = 30,
    ragdolls: int = 20,
    heap: int = 4,
    spun: int = 600,
    random: int = 500,
    seed: int = 1_000_000,
) -> dict[str, Any]:
    """Return a row for each scene and program, and what became of random mechanisms."""
    told = Console(stderr=True)
    scenes: dict[str, Callable[[], Scene]] = {
        f"net {side} x {side}": lambda: net(side),
        "ball and chain 672:1": ball_and_chain,
        "slack bridge of 40": bridge,
        "20 chains of 20": lambda: chains(20, 20),
        f"{ragdolls} ragdolls": lambda: falling_ragdolls(ragdolls),
        f"heap of {heap} ragdolls": lambda: ragdoll_heap(heap),
        f"rain of {ragdolls} sprung ragdolls": lambda: ragdoll_rain(ragdolls),
        f"spinner among {spun}": lambda: spinner(spun),
    }
    rows: list[dict[str, Any]] = []
    for name, made in scenes.items():
        rows += _race(name, made(), seconds)
        for row in rows[-3:]:
            told.print("  ".join(_cells(row)), highlight=False)
    return {"rows": rows, "mechanisms": _mechanisms(random, seed, seconds)}


def table(found: dict[str, Any]) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """Return heads and rows for people."""
    heads = ("scene", "joints", "program", "ms a step", "apart at the end", "at most", "gain")
    return heads, [_cells(row) for row in found["rows"]]


def notes(found: dict[str, Any]) -> list[str]:
    """Return what the columns mean, and what became of random mechanisms."""
    of = found["mechanisms"]
    return [
        "gain: the most that energy rose in a step, of all that gravity gave or motion had",
        f"{of['count']} random mechanisms, seeds from {of['first']}: {of['apart']} were ever more "
        f"than {_APART:g} of their reach apart, {of['untold']} of them without a warning; "
        f"{of['risen']} gained more than 1e-9 of their energy in a step, "
        f"at most {of['gain']:.1e}",
    ]


def _cells(row: dict[str, Any]) -> tuple[str, ...]:
    return (
        row["scene"],
        f"{row['joints']}",
        row["program"],
        f"{row['milliseconds']:.3g}",
        f"{row['last']:.1e} m",
        f"{row['most']:.1e} m",
        f"{row['gain']:.0e}",
    )


# -- scenes


def net(side: int) -> Scene:
    """Box2D's joint grid: discs, each hinged to four neighbours, hung by seven at the top."""
    scene = Scene(gravity=(0.0, -_G))
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
    scene = Scene(gravity=(0.0, -_G))
    for k in range(count):
        shape, place = Capsule(length=0.7, radius=0.125), (k + 0.5, 0.0)
        scene.add_body(shape, mass=1.0, position=place, **_SURFACE)
        _hinge(scene, (0.0, 0.0) if k == 0 else k - 1, k, 0.0 if k == 0 else 0.5, -0.5)
    scene.add_body(Disc(radius=8.0), mass=672.0, position=(count + 8.0, 0.0), **_SURFACE)
    _hinge(scene, count - 1, count, 0.5, -8.0)
    return scene


def bridge(planks: int = 40) -> Scene:
    """Planks that start as an arc between two banks, a twentieth nearer than they reach."""
    scene = Scene(gravity=(0.0, -_G))
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
    scene = Scene(gravity=(0.0, -_G))
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
    scene = Scene(gravity=(0.0, -_G))
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **_SURFACE)
    for n in range(count):
        _ragdoll(scene, 1.5 * n, 0.5, -1 - n)
    return scene


def ragdoll_heap(count: int, seed: int = 0) -> Scene:
    """Dolls that fall on each other between two walls."""
    scene, rng = Scene(gravity=(0.0, -_G)), random.Random(seed)
    for normal, offset in (((0.0, 1.0), 0.0), ((1.0, 0.0), -2.0), ((-1.0, 0.0), -2.5)):
        scene.add_static(HalfPlane(normal=normal, offset=offset), **_SURFACE)
    for n in range(count):
        _ragdoll(scene, rng.uniform(-1.0, 1.0), 0.5 + 2.0 * n, -1 - n)
    return scene


def ragdoll_rain(count: int, seed: int = 0) -> Scene:
    """Dolls with springs of 5 Hz and half of critical damping, that fall between two walls."""
    scene, rng = Scene(gravity=(0.0, -_G)), random.Random(seed)
    half = 0.4 * count
    for normal, offset in (((0.0, 1.0), 0.0), ((1.0, 0.0), -half), ((-1.0, 0.0), -half)):
        scene.add_static(HalfPlane(normal=normal, offset=offset), **_SURFACE)
    for n in range(count):
        x = rng.uniform(1.0 - half, half - 1.0)
        _ragdoll(scene, x, 0.5 + 2.0 * (n % 4), -1 - n, sprung=True)
    return scene


def spinner(count: int) -> Scene:
    """Box2D's spinner, smaller: a bar that a motor turns among small bodies in a ring."""
    scene = Scene(gravity=(0.0, -_G))
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
    inertia = _inertia_between(scene, scene.joints[k])
    spring = JointSpring(stiffness=inertia * pace**2, damping=inertia * pace)
    scene.add_joint(Rotary(spring=spring), a, b)


def _inertia_between(scene: Scene, joint: Joint) -> float:
    """Return the inertia that turns when a hinge does, kg m^2."""
    held = [scene.bodies[k].inertia for k in joint.ends[:2] if k is not None]
    return 1 / sum(1 / inertia for inertia in held)


def _hinge(scene: Scene, a: Any, b: int, at_a: float, at_b: float) -> None:
    scene.add_joint(Revolute(), a, b, anchor=(at_a, 0.0), other_anchor=(at_b, 0.0))


# -- random mechanisms


def random_mechanism(seed: int) -> Scene:
    """Two to eight bodies in a tree of joints of all kinds, with a loop now and then."""
    rng, scene = random.Random(seed), Scene(gravity=(0.0, -_G))
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


def _size(joint: Joint) -> float:
    """Return how far a joint reaches from the middles of its bodies, or how long it is, m."""
    held = zip(joint.anchors, joint.ends, strict=True)
    lengths = [math.hypot(*anchor) for anchor, body in held if body is not None]
    length = joint.given.get("joint_length")
    return max(*lengths, length if isinstance(length, float) else 0.0)


def _mechanisms(count: int, first: int, seconds: int) -> dict[str, Any]:
    """Follow random mechanisms; return how many came apart or gained energy."""
    apart = untold = risen = 0
    gain = 0.0
    for seed in range(first, first + count):
        scene = random_mechanism(seed)
        seen = Energy(scene)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", StepWarning)
            sim = Simulator(scene, time_step=_STEP)
            sim.step()
            most, sizes = 0.0, np.array([_size(joint) for joint in scene.joints])
            for _ in range(seconds * 60):
                seen.look(np.column_stack((sim.position, sim.orientation)), _rates(sim))
                sim.step()
                told = sim.reactions
                lengths = told.separation / sizes
                most = max(most, float(lengths.max()), float(told.angular_separation.max()))
        apart += most > _APART
        untold += most > _APART and not sim.warnings
        risen += seen.gain > 1e-9
        gain = max(gain, seen.gain)
    return {
        "count": count,
        "first": first,
        "apart": apart,
        "untold": untold,
        "risen": risen,
        "gain": gain,
    }


# -- programs


class _Own:
    """Our own frame loop."""

    name = "Tamias2D"

    def __init__(self, scene: Scene, time_step: float) -> None:
        self._sim = Simulator(scene, time_step=time_step)

    def step(self, count: int) -> None:
        """Go so many time steps ahead, one by one."""
        for _ in range(count):
            self._sim.step()

    def state(self) -> Array:
        """Return (n, 6): positions, orientations and their rates."""
        sim = self._sim
        return np.column_stack((sim.position, sim.orientation, _rates(sim)))


def _rates(sim: Simulator) -> Array:
    return np.column_stack((sim.velocity, sim.angular_velocity))


def _bare(scene: Scene) -> Scene:
    """Return the bodies of a scene without joints and groups, which its engines are told apart."""
    bare = deepcopy(scene)
    bare._joints.clear()
    bare._bodies[:] = [replace(body, group=0) for body in bare._bodies]
    bare._shown = ()
    return bare


class _Box2D(Box2D):
    """Box2D with hinges."""

    def __init__(self, scene: Scene, time_step: float) -> None:
        super().__init__(_bare(scene), time_step)
        import pyb2d3

        for body, own in zip(scene.bodies, self.bodies, strict=True):
            for shape in own.shapes:
                shape.filter = pyb2d3.make_filter(group_index=body.group)
        ground = self._world.create_body()
        for joint in _hinges(scene):
            a, b = (ground if k is None else self.bodies[k] for k in joint.ends[:2])
            ends = {"local_anchor_a": joint.anchors[0], "local_anchor_b": joint.anchors[1]}
            self._world.create_revolute_joint(a, b, **ends, **_laws(scene, joint))


def _hinges(scene: Scene) -> list[Joint]:
    return [joint for joint in scene.joints if joint.rigid]


def _freedoms(scene: Scene, hinge: Joint) -> list[Freedom]:
    """Return what is said of the angle of a hinge, by itself or by another joint."""
    return [law for joint in scene.joints if joint.ends == hinge.ends for law in joint.freedoms]


def _laws(scene: Scene, joint: Joint) -> dict[str, Any]:
    """Return the motor and the spring of a hinge as Box2D takes them."""
    found: dict[str, Any] = {}
    inertia = _inertia_between(scene, joint)
    for law in _freedoms(scene, joint):
        if law.motor:
            found |= {"enable_motor": True, "motor_speed": law.motor.speed}
            found |= {"max_motor_torque": law.motor.maximum}
        if law.spring:
            pace = math.sqrt(law.spring.stiffness / inertia)
            ratio = law.spring.damping / (2 * pace * inertia)
            found |= {"enable_spring": True, "hertz": pace / (2 * math.pi), "damping_ratio": ratio}
    return found


class _Pymunk(Chipmunk):
    """Pymunk with hinges."""

    def __init__(self, scene: Scene, time_step: float) -> None:
        import pymunk

        super().__init__(_bare(scene), time_step)
        for body, own in zip(scene.bodies, self.bodies, strict=True):
            for shape in own.shapes:
                shape.filter = pymunk.ShapeFilter(group=-body.group)
        for joint in _hinges(scene):
            a, b = (
                self._space.static_body if k is None else self.bodies[k] for k in joint.ends[:2]
            )
            hinge = pymunk.PivotJoint(a, b, joint.anchors[0], joint.anchors[1])
            hinge.collide_bodies = False
            self._space.add(hinge)
            for law in _freedoms(scene, joint):
                if law.motor:
                    motor = pymunk.SimpleMotor(a, b, -law.motor.speed)
                    most = law.motor.maximum
                    motor.max_force = math.inf if most is None else most
                    self._space.add(motor)
                if law.spring:
                    own = (0.0, law.spring.stiffness, law.spring.damping)
                    self._space.add(pymunk.DampedRotarySpring(a, b, *own))


class Energy:
    """The most that the energy of a scene has risen in a step, as a share of all there was.

    What does not move has none but by rounding: at least what gravity gives in a millionth of the
    scene's size counts.
    """

    def __init__(self, scene: Scene) -> None:
        moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
        self._moving = np.array(moving)
        self._mass = np.array([scene.bodies[k].mass for k in moving])
        self._inertia = np.array([scene.bodies[k].inertia for k in moving])
        self._before: float | None = None
        self._start = self._size = 0.0
        self.gain = 0.0

    def look(self, places: Array, rates: Array) -> None:
        """Look at the state after a step: places (n, 3) and their rates (n, 3)."""
        places, rates = places[self._moving], rates[self._moving]
        moving = 0.5 * float(
            self._mass @ (rates[:, :2] ** 2).sum(axis=1) + self._inertia @ rates[:, 2] ** 2
        )
        height = _G * float(self._mass @ places[:, 1])
        if self._before is None:
            self._before = moving + height
            self._start = height
            extent = float(np.ptp(places[:, :2], axis=0).max())
            self._size = 1e-6 * _G * float(self._mass.sum()) * extent
        self._size = max(self._size, moving, abs(height - self._start))
        rise = moving + height - self._before
        if self._size > 0:
            self.gain = max(self.gain, rise / self._size)
        self._before = moving + height


def _race(name: str, scene: Scene, seconds: int) -> list[dict[str, Any]]:
    """Return the row of each program; they step the scene in turns."""
    worlds = [made(scene, _STEP) for made in (_Own, _Box2D, _Pymunk)]
    seen = [Energy(scene) for _ in worlds]
    times: list[list[float]] = [[] for _ in worlds]
    apart: list[list[float]] = [[] for _ in worlds]
    for turn in range(math.ceil(seconds / (_TURN * _STEP))):
        for k, world in enumerate(worlds):
            spent = 0.0
            for _ in range(_TURN):
                began = time.perf_counter()
                world.step(1)
                spent += time.perf_counter() - began
                state = world.state()
                seen[k].look(state[:, :3], state[:, 3:])
            if turn or seconds == 1:  # the first one compiles
                times[k].append(spent / _TURN)
            apart[k].append(_apart(scene, world.state()))
    return [
        {
            "scene": name,
            "joints": len(scene.joints),
            "program": world.name,
            "milliseconds": 1e3 * float(np.median(times[k])),
            "last": apart[k][-1],
            "most": max(apart[k]),
            "gain": seen[k].gain,
        }
        for k, world in enumerate(worlds)
    ]


def _apart(scene: Scene, state: Array) -> float:
    """Return by how much the worst hinge is apart, m."""
    poses = np.vstack((state[:, :3], np.zeros((1, 3))))
    hinges = _hinges(scene)
    ends = np.array([[-1 if k is None else k for k in joint.ends[:2]] for joint in hinges])
    anchors = np.array([joint.anchors[:2] for joint in hinges])
    cosine, sine = np.cos(poses[ends][..., 2]), np.sin(poses[ends][..., 2])
    x = poses[ends][..., 0] + cosine * anchors[..., 0] - sine * anchors[..., 1]
    y = poses[ends][..., 1] + sine * anchors[..., 0] + cosine * anchors[..., 1]
    return float(np.hypot(x[:, 1] - x[:, 0], y[:, 1] - y[:, 0]).max())
