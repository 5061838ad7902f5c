"""Joints in the frame loop beside Pymunk and Box2D: time of a step, and how far joints are apart.

The programs step the same scene in turns, 60 steps each. Scenes are those of Box2D's benchmarks and
of solver2d, all hinges: a net, a heavy ball on a chain, chains and ragdolls that fall.
"""

import argparse
import math
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from tamias2d.scene import Capsule, Disc, HalfPlane, Revolute, Scene
from tamias2d.simulator import Simulator
from tamias2d.state import Array
from tamias2d.study.engines.box2d import Box2D
from tamias2d.study.engines.chipmunk import Chipmunk

_STEP = 1 / 60
_TURN = 60  # steps
_SURFACE: dict[str, Any] = {"friction": 0.6, "restitution": 0.0}


def options(parser: argparse.ArgumentParser) -> None:
    """Add how long and how much."""
    parser.add_argument("--seconds", type=int, default=10, help="s of simulated time")
    parser.add_argument("--side", type=int, default=100, help="discs on a side of the net")
    parser.add_argument("--ragdolls", type=int, default=20, help="that fall")


def measure(seconds: int, side: int, ragdolls: int) -> dict[str, Any]:
    """Return one row for each scene and program."""
    scenes: dict[str, Callable[[], Scene]] = {
        f"net {side} x {side}": lambda: net(side),
        "ball and chain 672:1": ball_and_chain,
        "20 chains of 20": lambda: chains(20, 20),
        f"{ragdolls} ragdolls": lambda: falling_ragdolls(ragdolls),
    }
    rows = [row for name, made in scenes.items() for row in _race(name, made(), seconds)]
    return {"rows": rows}


def table(found: dict[str, Any]) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """Return heads and rows for people."""
    heads = ("scene", "joints", "program", "time of a step", "apart at the end", "at most")
    return heads, [
        (
            row["scene"],
            f"{row['joints']}",
            row["program"],
            f"{row['milliseconds']:.3g} ms",
            f"{row['last']:.1e} m",
            f"{row['most']:.1e} m",
        )
        for row in found["rows"]
    ]


def net(side: int) -> Scene:
    """Box2D's joint grid: discs, each hinged to four neighbours, hung by seven at the top."""
    scene = Scene(gravity=(0.0, -10.0))
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
    scene = Scene(gravity=(0.0, -10.0))
    for k in range(count):
        shape, place = Capsule(length=0.7, radius=0.125), (k + 0.5, 0.0)
        scene.add_body(shape, mass=1.0, position=place, **_SURFACE)
        _hinge(scene, (0.0, 0.0) if k == 0 else k - 1, k, 0.0 if k == 0 else 0.5, -0.5)
    scene.add_body(Disc(radius=8.0), mass=672.0, position=(count + 8.0, 0.0), **_SURFACE)
    _hinge(scene, count - 1, count, 0.5, -8.0)
    return scene


def chains(count: int, links: int) -> Scene:
    """Level chains, each hung at its left end, that swing past each other's planes."""
    scene = Scene(gravity=(0.0, -10.0))
    for n in range(count):
        for k in range(links):
            body = scene.add_body(
                Capsule(length=0.7, radius=0.1), mass=1.0, group=-1 - n,
                position=(k + 0.5 + 50.0 * n, 0.0), **_SURFACE,
            )  # fmt: skip
            _hinge(scene, (50.0 * n, 0.0) if k == 0 else body - 1, body, 0.5 * (k > 0), -0.5)
    return scene


def falling_ragdolls(count: int) -> Scene:
    """Dolls of thirteen capsules that fall on the ground side by side."""
    scene = Scene(gravity=(0.0, -10.0))
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **_SURFACE)
    for n in range(count):
        _ragdoll(scene, 1.5 * n, 0.5)
    return scene


def _ragdoll(scene: Scene, x: float, y: float) -> None:
    """Add a doll that stands upright; the axes of its capsules point upwards."""

    def limb(at: tuple[float, float], length: float, radius: float, mass: float) -> int:
        place = (x + at[0], y + at[1])
        shape = Capsule(length=length, radius=radius)
        return scene.add_body(shape, mass=mass, position=place, orientation=math.pi / 2, **_SURFACE)

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


def _hinge(scene: Scene, a: Any, b: int, at_a: float, at_b: float) -> None:
    scene.add_joint(Revolute(), a, b, anchor=(at_a, 0.0), other_anchor=(at_b, 0.0))


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
        """Return (n, 3) and more: positions and orientations."""
        return np.column_stack((self._sim.position, self._sim.orientation))


class _Box2D(Box2D):
    """Box2D with hinges."""

    def __init__(self, scene: Scene, time_step: float) -> None:
        super().__init__(scene, time_step)
        ground = self._world.create_body()
        for joint in scene.joints:
            a, b = (ground if k is None else self.bodies[k] for k in joint.ends[:2])
            ends = {"local_anchor_a": joint.anchors[0], "local_anchor_b": joint.anchors[1]}
            self._world.create_revolute_joint(a, b, **ends)


class _Pymunk(Chipmunk):
    """Pymunk with hinges."""

    def __init__(self, scene: Scene, time_step: float) -> None:
        import pymunk

        super().__init__(scene, time_step)
        for joint in scene.joints:
            a, b = (
                self._space.static_body if k is None else self.bodies[k] for k in joint.ends[:2]
            )
            hinge = pymunk.PivotJoint(a, b, joint.anchors[0], joint.anchors[1])
            hinge.collide_bodies = False
            self._space.add(hinge)


def _race(name: str, scene: Scene, seconds: int) -> list[dict[str, Any]]:
    """Return the row of each program; they step the scene in turns."""
    worlds = [made(scene, _STEP) for made in (_Own, _Box2D, _Pymunk)]
    times: list[list[float]] = [[] for _ in worlds]
    apart: list[list[float]] = [[] for _ in worlds]
    for turn in range(math.ceil(seconds / (_TURN * _STEP))):
        for k, world in enumerate(worlds):
            began = time.perf_counter()
            world.step(_TURN)
            if turn or seconds == 1:  # the first one compiles
                times[k].append((time.perf_counter() - began) / _TURN)
            apart[k].append(_apart(scene, world.state()))
    return [
        {
            "scene": name,
            "joints": len(scene.joints),
            "program": world.name,
            "milliseconds": 1e3 * float(np.median(times[k])),
            "last": apart[k][-1],
            "most": max(apart[k]),
        }
        for k, world in enumerate(worlds)
    ]


def _apart(scene: Scene, state: Array) -> float:
    """Return by how much the worst hinge is apart, m."""
    poses = np.vstack((state[:, :3], np.zeros((1, 3))))
    ends = np.array([[-1 if k is None else k for k in joint.ends[:2]] for joint in scene.joints])
    anchors = np.array([joint.anchors[:2] for joint in scene.joints])
    cosine, sine = np.cos(poses[ends][..., 2]), np.sin(poses[ends][..., 2])
    x = poses[ends][..., 0] + cosine * anchors[..., 0] - sine * anchors[..., 1]
    y = poses[ends][..., 1] + sine * anchors[..., 0] + cosine * anchors[..., 1]
    return float(np.hypot(x[:, 1] - x[:, 0], y[:, 1] - y[:, 0]).max())
