"""Many worlds of discs between three walls beside Pymunk in a loop, in turns, on one thread.

Discs of 15 cm are thrown at random on a floor of 4 m between two walls. Pymunk takes steps of
1/60 s; a world of it is made, stepped and read. Of each turn the ratio of processor times is taken;
what is told is their median. Worlds that compiled code does not follow are left out of the time of
located ones, and their share is told.
"""

from argparse import ArgumentParser
from itertools import product
from statistics import median
from time import process_time
from typing import Any

import numpy as np

from tamias2d import Disc, HalfPlane, Scene, Stepped
from tamias2d.ensemble.followed import followed
from tamias2d.ensemble.request import Request, request_of
from tamias2d.ensemble.stepped import stepped
from tamias2d.ensemble.worlds import VariedWorlds, worlds_of
from tamias2d.study.engines.refusal import imported
from tools.measurements.arena.race import TIME_STEP, undisturbed
from tools.measurements.columns import Columns
from tools.measurements.progress import each

_RADIUS, _WIDTH, _TOP = 0.15, 4.0, 3.0  # m
_SPEED = 2.0  # m/s
_GRAVITY = -9.81  # m/s^2
_LEAST_WORLDS = 128  # of one turn: fewer are not followed
_MOST = 0.5  # of the worlds are followed: the time of fewer tells little
_ASKED = {2: 20.0, 5: 10.0, 10: 4.0}


def options(parser: ArgumentParser) -> None:
    """Add what can be chosen."""
    parser.add_argument("--discs", nargs="+", type=int, default=list(_ASKED), help="(2 5 10)")
    parser.add_argument("--restitution", nargs="+", type=float, default=[1.0, 0.9], help="(1 0.9)")
    parser.add_argument("--friction", nargs="+", type=float, default=[0.0, 0.5], help="(0 0.5)")
    parser.add_argument("--worlds", type=int, default=512, help="of a turn (512)")
    parser.add_argument("--turns", type=int, default=7, help="(7)")
    parser.add_argument("--duration", type=float, default=4.0, help="s (4)")
    parser.add_argument("--seed", type=int, default=1, help="(1)")


def measure(
    discs: list[int] | None = None,
    restitution: list[float] | None = None,
    friction: list[float] | None = None,
    worlds: int = 512,
    turns: int = 7,
    duration: float = 4.0,
    seed: int = 1,
) -> dict[str, Any]:
    """Return a row for each number of discs, restitution, friction, and way through contacts."""
    kinds = list(product(restitution or [1.0, 0.9], friction or [0.0, 0.5], discs or _ASKED))
    rows: list[dict[str, Any]] = []
    for bounce, rough, count in each(kinds, "Worlds"):
        many = scattered(count, bounce, max(worlds, _LEAST_WORLDS) * turns, seed, friction=rough)
        rows += _rows(many, turns, duration)
    return {"duration": duration, "turns": turns, "seed": seed, "rows": rows}


def scattered(
    count: int, restitution: float, worlds: int, seed: int, *, friction: float = 0.0
) -> VariedWorlds:
    """Return worlds of discs that start apart from each other, with random velocities."""
    scene = Scene(gravity=(0.0, _GRAVITY), name="walls")
    for name, normal, offset in (
        ("floor", (0.0, 1.0), 0.0),
        ("left", (1.0, 0.0), 0.0),
        ("right", (-1.0, 0.0), -_WIDTH),
    ):
        wall = HalfPlane(normal=normal, offset=offset)
        scene.add_static(wall, restitution=1.0, friction=friction, name=name)
    random = np.random.default_rng(seed)
    vary: dict[str, Any] = {}
    places = _apart(random, worlds, count)
    for k in range(count):
        scene.add_body(
            Disc(radius=_RADIUS), mass=1.0, position=(0.3 + 0.35 * k, 1.0), friction=friction,
            restitution=restitution, name=f"disc{k}",
        )  # fmt: skip
        vary[f"bodies.disc{k}.position"] = places[:, k]
        vary[f"bodies.disc{k}.velocity"] = random.normal(0.0, _SPEED, (worlds, 2))
    found = worlds_of(scene, vary, None, None, None)
    assert isinstance(found, VariedWorlds)
    return found


def _apart(random: np.random.Generator, worlds: int, count: int) -> np.ndarray:
    """Return places (worlds, count, 2), m: of each disc some that no earlier one is near to."""
    low, high = (2 * _RADIUS, 2 * _RADIUS), (_WIDTH - 2 * _RADIUS, _TOP)
    found = random.uniform(low, high, (worlds, count, 2))
    for k in range(1, count):
        while True:
            gaps = np.linalg.norm(found[:, :k] - found[:, k : k + 1], axis=-1).min(axis=1)
            near = np.flatnonzero(gaps < 2.2 * _RADIUS)
            if not len(near):
                break
            found[near, k] = random.uniform(low, high, (len(near), 2))
    return found


def _rows(many: VariedWorlds, turns: int, duration: float) -> list[dict[str, Any]]:
    """Return the rows of both ways through contacts."""
    part = len(many) // turns
    located = request_of(many.base, duration=duration)
    steps = request_of(many.base, duration=duration, method=Stepped(), time_step=TIME_STEP)
    spent: dict[str, list[float]] = {"located": [], "stepped": [], "pymunk": []}
    done: dict[str, list[float]] = {"located": [], "stepped": []}
    for ask, way in ((located, followed), (steps, stepped)):
        way(many, ask, 0, part)  # compiles
    for turn in range(turns):
        first, last = turn * part, (turn + 1) * part
        with undisturbed():
            for name, ask, way in (("located", located, followed), ("stepped", steps, stepped)):
                start = process_time()
                kept = way(many, ask, first, last)
                spent[name].append((process_time() - start) / part)
                assert kept is not None
                done[name].append(float(kept.done.mean()))
            spent["pymunk"].append(_chipmunk(many, first, min(part, 128), steps))
    return [
        {
            "discs": sum(body.dynamic for body in many.base.bodies),
            "restitution": float(many.base.bodies[-1].restitution or 0.0),
            "friction": float(many.base.bodies[-1].friction or 0.0),
            "way": name,
            "seconds": median(spent[name]),
            "pymunk": median(spent["pymunk"]),
            "ratio": median(p / s for p, s in zip(spent["pymunk"], spent[name], strict=True)),
            "done": float(np.mean(done[name])),
        }
        for name in ("located", "stepped")
    ]


def _chipmunk(many: VariedWorlds, first: int, count: int, request: Request) -> float:
    """Return seconds of a world of Pymunk, made by its own calls alone."""
    pymunk = imported("Pymunk", "pymunk")
    scene, values = many.base, {place.path: rows for place, rows in many.values.items()}
    discs = [body for body in scene.bodies if body.dynamic]
    steps = round(request.duration / TIME_STEP)
    rows = range(first, first + count)
    places = [[values[f"bodies.{d.name}.position"][w].tolist() for d in discs] for w in rows]
    going = [[values[f"bodies.{d.name}.velocity"][w].tolist() for d in discs] for w in rows]
    start = process_time()
    for at, by in zip(places, going, strict=True):
        space = pymunk.Space()
        space.gravity = scene.gravity
        space.collision_slop = 0.01 * _RADIUS
        _walls(pymunk, space, float(discs[0].friction or 0.0))
        bodies = []
        for disc, place, velocity in zip(discs, at, by, strict=True):
            body = pymunk.Body(disc.mass, disc.inertia)
            body.position, body.velocity = place, velocity
            circle = pymunk.Circle(body, _RADIUS)
            circle.elasticity = float(disc.restitution or 0.0)
            circle.friction = float(disc.friction or 0.0)
            space.add(body, circle)
            bodies.append(body)
        for _ in range(steps):
            space.step(TIME_STEP)
        [(body.position, body.angle, body.velocity, body.angular_velocity) for body in bodies]
    return (process_time() - start) / count


def _walls(pymunk: Any, space: Any, friction: float) -> None:
    far = 1000.0
    for a, b in (
        ((-far, 0.0), (far, 0.0)),
        ((0.0, -far), (0.0, far)),
        ((_WIDTH, -far), (_WIDTH, far)),
    ):
        wall = pymunk.Segment(space.static_body, a, b, 0.0)
        wall.elasticity, wall.friction = 1.0, friction
        space.add(wall)


COLUMNS: Columns = {
    "discs": "{discs}",
    "restitution": "{restitution:g}",
    "friction": "{friction:g}",
    "way": "{way}",
    "us a world": lambda row: f"{1e6 * row['seconds']:.1f}",
    "Pymunk": lambda row: f"{1e6 * row['pymunk']:.0f}",
    "ratio": lambda row: f"{row['ratio']:.2f}" if row["done"] > _MOST else "",
    "asked": lambda row: f"{_ASKED[row['discs']]:g}" if row["discs"] in _ASKED else "",
    "followed": "{done:.1%}",
}


def notes(found: dict[str, Any]) -> list[str]:
    """Return what the columns mean."""
    return [
        f"{found['duration']:g} s, medians of {found['turns']} turns, seed {found['seed']}; "
        "Pymunk: a world of it in steps of 1/60 s; asked: the ratio of issue 17; followed: of the "
        "worlds, those of which the time is told: it has a ratio if these are most"
    ]
