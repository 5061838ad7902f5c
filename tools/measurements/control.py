"""Worlds that are acted on before each step, as learning does, beside Pymunk in a loop of Python.

A cart on a rail bears a pole, and is pushed by what a linear law says of both; or a box is pushed
about under two that lie on it. Each turn takes some steps of all worlds: forces are written, a step
is taken, and places and velocities are read. Pymunk does the same world after world. Times are
those of the processor, on one thread; of each turn the ratio is taken, what is told is its median.
"""

from argparse import ArgumentParser
from collections.abc import Callable
from itertools import product
from statistics import median
from time import process_time
from typing import Any

import numpy as np

from tamias2d import Box, Disc, HalfPlane, Prismatic, Revolute, Scene, Simulators
from tamias2d.study.engines.refusal import imported
from tools.measurements.arena.race import TIME_STEP, undisturbed
from tools.measurements.columns import Columns
from tools.measurements.progress import each

_GRAVITY = -9.81  # m/s^2
_CART, _POLE, _LONG = 1.0, 0.1, 1.0  # kg, kg, m
_ACROSS = 0.2  # m, of a box
_GAINS = np.array((1.0, 2.0, 30.0, 8.0))  # N/m, N s/m, N/m, N s/m

_Loop = Callable[[int], None]


def options(parser: ArgumentParser) -> None:
    """Add what can be chosen."""
    parser.add_argument("--worlds", nargs="+", type=int, default=[16, 256], help="(16 256)")
    parser.add_argument("--steps", type=int, default=20, help="of a turn (20)")
    parser.add_argument("--turns", type=int, default=7, help="(7)")


def measure(worlds: list[int] | None = None, steps: int = 20, turns: int = 7) -> dict[str, Any]:
    """Return a row for each kind of world and each number of worlds."""
    kinds = list(product((_cart_pole, _boxes), worlds or [16, 256]))
    return {
        "rows": [make(count, steps, turns) for make, count in each(kinds, "Kinds")],
        "steps": steps,
        "turns": turns,
    }


COLUMNS: Columns = {
    "world": "{name}",
    "worlds": "{worlds}",
    "Tamias2D, us a world": "{own:.1f}",
    "Pymunk, us a world": "{pymunk:.1f}",
    "Pymunk / Tamias2D": "{ratio:.1f}",
}


def notes(found: dict[str, Any]) -> list[str]:
    """Return what the columns mean."""
    return [f"medians of {found['turns']} turns of {found['steps']} steps, one step a call"]


def _row(name: str, worlds: int, own: _Loop, other: _Loop, steps: int, turns: int) -> Any:
    times: tuple[list[float], list[float]] = ([], [])
    own(2)
    other(2)
    for _ in range(turns):
        with undisturbed():
            for loop, found in zip((own, other), times, strict=True):
                start = process_time()
                loop(steps)
                found.append(1e6 * (process_time() - start) / steps / worlds)
    ratio = median(theirs / mine for mine, theirs in zip(*times, strict=True))
    mine, theirs = map(median, times)
    return {"name": name, "worlds": worlds, "own": mine, "pymunk": theirs, "ratio": ratio}


def _cart_pole(worlds: int, steps: int, turns: int) -> dict[str, Any]:
    scene = Scene(gravity=(0.0, _GRAVITY))
    scene.add_body(None, mass=_CART, inertia=1.0, position=(0.0, 0.0), name="cart")
    scene.add_joint(Prismatic(axis=(1.0, 0.0)), "cart", (0.0, 0.0))
    place = (0.05 * _LONG, _LONG)
    scene.add_body(None, mass=_POLE, inertia=0.01, position=place, name="pole")
    scene.add_joint(Revolute(), "cart", "pole", at=(0.0, 0.0))
    sims = Simulators(scene, worlds=worlds, time_step=TIME_STEP, threads=1)
    cart, pole = sims.index("cart"), sims.index("pole")

    def own(steps: int) -> None:
        for _ in range(steps):
            at, speed = sims.position[:, cart, 0], sims.velocity[:, cart, 0]
            leans = sims.position[:, pole, 0] - at
            falls = sims.velocity[:, pole, 0] - speed
            sims.force[:, cart, 0] = np.stack((at, speed, leans, falls), axis=1) @ _GAINS
            sims.step()

    pymunk = imported("Pymunk", "pymunk")
    spaces = []
    for _ in range(worlds):
        space = pymunk.Space()
        space.gravity = 0.0, _GRAVITY
        first, second = pymunk.Body(_CART, np.inf), pymunk.Body(_POLE, 0.01)
        second.position = place
        space.add(first, second)
        space.add(pymunk.GrooveJoint(space.static_body, first, (-9.0, 0.0), (9.0, 0.0), (0.0, 0.0)))
        space.add(pymunk.PivotJoint(first, second, (0.0, 0.0)))
        spaces.append((space, first, second))

    def other(steps: int) -> None:
        gains = _GAINS.tolist()
        for _ in range(steps):
            for space, first, second in spaces:
                at, speed = first.position.x, first.velocity.x
                leans, falls = second.position.x - at, second.velocity.x - speed
                push = gains[0] * at + gains[1] * speed + gains[2] * leans + gains[3] * falls
                first.apply_force_at_local_point((push, 0.0), (0.0, 0.0))
                space.step(TIME_STEP)

    return dict(_row("cart and pole", worlds, own, other, steps, turns))


def _boxes(worlds: int, steps: int, turns: int) -> dict[str, Any]:
    scene = Scene(gravity=(0.0, _GRAVITY))
    floor = HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, friction=0.5, restitution=0.0)
    box = Box(width=_ACROSS, height=_ACROSS)
    places = [(0.0, _ACROSS * (k + 0.5)) for k in range(3)]
    for k, place in enumerate(places):
        scene.add_body(box, mass=1.0, position=place, friction=0.5, restitution=0.0, name=f"box{k}")
    scene.add_body(
        Disc(radius=0.1), mass=1.0, position=(1.0, 0.1), friction=0.5, restitution=0.0, name="ball"
    )
    sims = Simulators(scene, worlds=worlds, time_step=TIME_STEP, threads=1)
    lowest = sims.index("box0")

    def own(steps: int) -> None:
        for _ in range(steps):
            at, speed = sims.position[:, lowest, 0], sims.velocity[:, lowest, 0]
            sims.force[:, lowest, 0] = 3.0 - at - speed
            sims.step()

    pymunk = imported("Pymunk", "pymunk")
    spaces = []
    for _ in range(worlds):
        space = pymunk.Space()
        space.gravity = 0.0, _GRAVITY
        ground = pymunk.Segment(space.static_body, (-99.0, -1.0), (99.0, -1.0), 1.0)
        ground.friction = 0.5
        space.add(ground)
        inertia = pymunk.moment_for_box(1.0, (_ACROSS, _ACROSS))
        bodies = []
        for place in places:
            body = pymunk.Body(1.0, inertia)
            body.position = place
            shape = pymunk.Poly.create_box(body, (_ACROSS, _ACROSS))
            shape.friction = 0.5
            space.add(body, shape)
            bodies.append(body)
        ball = pymunk.Body(1.0, 0.005)
        ball.position = 1.0, 0.1
        disc = pymunk.Circle(ball, 0.1)
        disc.friction = 0.5
        space.add(ball, disc)
        spaces.append((space, bodies[0]))

    def other(steps: int) -> None:
        for _ in range(steps):
            for space, first in spaces:
                push = 3.0 - first.position.x - first.velocity.x
                first.apply_force_at_local_point((push, 0.0), (0.0, 0.0))
                space.step(TIME_STEP)

    return dict(_row("boxes", worlds, own, other, steps, turns))
