"""Crowds of fast bodies beside Pymunk and Box2D v3 (pyb2d3): do they go where their velocities say?

All engines take steps of 1/60 s of the same crowd, one after the other in turns, in one process on
one thread. The share that hangs is that of moving body-steps (faster than 0.3 m/s before and after,
in the same direction) whose way is less than a fifth of speed times step. The centre of mass of a
crowd that nothing outside pushes is compared with momentum/mass times time, as a share of the mean
way of its bodies.
"""

import math
from argparse import ArgumentParser
from collections.abc import Callable
from time import perf_counter
from typing import Any

import numpy as np
from rich.console import Console
from rich.progress import track

from tamias2d.scene import Box, Capsule, Disc, Scene, Shape
from tamias2d.state import Array
from tamias2d.study.engines.box2d import Box2D
from tamias2d.study.engines.chipmunk import Chipmunk
from tamias2d.study.engines.engine import Engine, Maker
from tamias2d.study.engines.overlap import worst
from tamias2d.study.engines.own import Own
from tools.measurements.arena.race import TIME_STEP

_ENGINES: tuple[Maker, ...] = (Own, Chipmunk, Box2D)
_SLOW = 0.3  # m/s, up to which a body counts as resting
_HANGS = 0.2  # of its way
_GRAVITY = (0.0, -9.81)


def options(parser: ArgumentParser) -> None:
    """Add what can be chosen."""
    parser.add_argument("--bodies", type=int, default=500, help="in each crowd (500)")
    parser.add_argument("--steps", type=int, default=120, help="of each engine (120)")


def measure(bodies: int = 500, steps: int = 120) -> dict[str, Any]:
    """Return a row for each crowd and engine."""
    told = Console(stderr=True)
    rows: list[dict[str, Any]] = []
    for name in track(CROWDS, "Crowds", console=told, transient=True):
        rows += _crowd(name, CROWDS[name](bodies), steps)
    return {"bodies": bodies, "steps": steps, "rows": rows}


def table(found: dict[str, Any]) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """Return heads and rows for people."""
    heads = ("crowd", "engine", "ms a step", "worst/median", "hang", "centre", "overlap", "gain")
    return heads, [
        (
            row["crowd"],
            row["engine"],
            f"{1e3 * row['seconds']:.2f}",
            f"{row['worst'] / row['seconds']:.0f}",
            f"{row['hang']:.2%}",
            "" if row["centre"] is None else f"{row['centre']:.0e}",
            f"{row['overlap']:.0%}",
            f"{row['gain']:.0e}",
        )
        for row in found["rows"]
    ]


def notes(_: dict[str, Any]) -> list[str]:
    """Return what the columns mean."""
    return [
        "overlap: the deepest at the end, of the largest circle in the smaller body; "
        "gain: the most that energy rises in a step, of that at the start"
    ]


class _Followed:
    """An engine on a crowd, and what was seen of it so far."""

    def __init__(self, make: Maker, scene: Scene) -> None:
        self.engine: Engine = make(scene, TIME_STEP)
        self.seconds: list[float] = []
        self.gain, self._moving, self._hanging = 0.0, 0, 0
        self._scene = scene
        self._free = np.array([body.dynamic for body in scene.bodies])
        self._mass = np.array([body.mass for body in scene.bodies if body.dynamic])
        self._inertia = np.array([body.inertia for body in scene.bodies if body.dynamic])
        self._start = self._state()
        self._energy = self._first = self._energy_of(self._start)

    def step(self) -> None:
        """Take a step, and see who went where."""
        before = self._state()
        start = perf_counter()
        self.engine.step()
        self.seconds.append(perf_counter() - start)
        after = self._state()
        way = np.hypot(*(after[:, :2] - before[:, :2]).T)
        speed = np.minimum(np.hypot(*before[:, 3:5].T), np.hypot(*after[:, 3:5].T))
        goes = (speed > _SLOW) & ((before[:, 3:5] * after[:, 3:5]).sum(axis=1) > 0.0)
        self._moving += int(goes.sum())
        self._hanging += int((goes & (way < _HANGS * speed * TIME_STEP)).sum())
        energy = self._energy_of(after)
        self.gain = max(self.gain, (energy - self._energy) / self._first)
        self._energy = energy

    def row(self) -> dict[str, Any]:
        """Return what was seen."""
        return {
            "engine": self.engine.name,
            "seconds": float(np.median(self.seconds)),
            "worst": max(self.seconds),
            "hang": self._hanging / max(self._moving, 1),
            "centre": self._centre(),
            "overlap": worst(self._scene, self.engine.state()).share,
            "gain": self.gain,
        }

    def _state(self) -> Array:
        state: Array = self.engine.state()[self._free]
        return state

    def _energy_of(self, state: Array) -> float:
        """Kinetic energy, and that of gravity above the lowest place at the start, J."""
        speed = (state[:, 3:5] ** 2).sum(axis=1)
        pull = -self._scene.gravity[1]
        height = state[:, 1] - self._start[:, 1].min()
        return float(
            (0.5 * (self._mass * speed + self._inertia * state[:, 5] ** 2)).sum()
            + pull * (self._mass * height).sum()
        )

    def _centre(self) -> float | None:
        """Return the error of the centre of mass, or nothing where something outside pushes."""
        if self._scene.gravity != (0.0, 0.0) or not self._free.all():
            return None
        share, time = self._mass / self._mass.sum(), len(self.seconds) * TIME_STEP
        went = share @ (self._state()[:, :2] - self._start[:, :2])
        mean = time * share @ np.hypot(*self._start[:, 3:5].T)
        return float(np.abs(went - time * share @ self._start[:, 3:5]).max() / mean)


def _crowd(name: str, scene: Scene, steps: int) -> list[dict[str, Any]]:
    followed = [_Followed(make, scene) for make in _ENGINES]
    for _ in range(steps):
        for one in followed:
            one.step()
    return [{"crowd": name} | one.row() for one in followed]


# -- crowds


def _rain(bodies: int, size: float, speed: float, shapes: Callable[[float], list[Shape]]) -> Scene:
    """Return bodies in a lattice that reach a floor at a speed, m/s."""
    chance = np.random.default_rng(7)
    scene = Scene(gravity=_GRAVITY)
    surface: Any = {"friction": 0.5, "restitution": 0.0}
    scene.add_static(
        Box(width=1000 * size, height=50 * size), position=(0.0, -25 * size), **surface
    )
    columns = max(1, round((bodies / 1.6) ** 0.5))
    for k in range(bodies):
        own = size * chance.uniform(0.5, 1.0)
        every = shapes(own)
        scene.add_body(
            every[k % len(every)],
            mass=1000 * own**2,
            position=(2.5 * size * (k % columns), 2 * size + 2.5 * size * (k // columns)),
            orientation=chance.uniform(0.0, 3.0),
            velocity=(0.0, -speed),
            **surface,
        )
    return scene


def _round_and_square(size: float) -> list[Shape]:
    return [Disc(radius=size), Box(width=1.6 * size, height=1.2 * size)]


def _needles(size: float) -> list[Shape]:
    return [Capsule(length=1.8 * size, radius=0.05 * size)]


def _gas(bodies: int) -> Scene:
    """Return elastic discs of 2 cm that fly into each other at half a radius to five a step."""
    return _flying(bodies, 0.01, 3.0, 1.0, inwards=False)


def _implosion(bodies: int) -> Scene:
    """Return discs of 2 cm that fly to their middle, most at ten radii a step, and stay there."""
    return _flying(bodies, 0.01, 6.0, 0.0, inwards=True)


def _flying(bodies: int, radius: float, speed: float, restitution: float, inwards: bool) -> Scene:
    chance = np.random.default_rng(11)
    scene = Scene(gravity=(0.0, 0.0))
    side = math.ceil(bodies**0.5)
    for k in range(bodies):
        place = np.array([k % side, k // side]) - (side - 1) / 2
        way = -2 * place / side if inwards else chance.normal(size=2)
        scene.add_body(
            Disc(radius=radius),
            mass=10 ** chance.uniform(-2, 0),
            position=tuple(3 * radius * place),
            velocity=tuple(speed * way),
            friction=0.0,
            restitution=restitution,
        )
    return scene


def _smash(bodies: int) -> Scene:
    """Return a wall of light boxes that a heavy one of 20 times their size hits at 40 m/s."""
    scene = Scene(gravity=(0.0, 0.0))
    surface: Any = {"friction": 0.6, "restitution": 0.0}
    side = max(1, round(bodies**0.5))
    scene.add_body(
        Box(width=8.0, height=8.0),
        mass=512.0,
        position=(-6.0, 0.0),
        velocity=(40.0, 0.0),
        **surface,
    )
    for k in range(side * side):
        place = (0.4 * (k % side), 0.4 * (k // side - (side - 1) / 2))
        scene.add_body(Box(width=0.4, height=0.4), mass=0.16, position=place, **surface)
    return scene


CROWDS: dict[str, Callable[[int], Scene]] = {
    "rain of 2 cm": lambda bodies: _rain(bodies, 0.01, 6.0, _round_and_square),
    "hail of 1 m": lambda bodies: _rain(bodies, 0.5, 40.0, _round_and_square),
    "needles 1:20": lambda bodies: _rain(bodies, 0.1, 6.0, _needles),
    "gas": _gas,
    "implosion": _implosion,
    "smash": _smash,
}
