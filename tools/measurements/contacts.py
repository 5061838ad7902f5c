"""Speed and quality beside Pymunk and Box2D v3 (pyb2d3), on piles, stacks and flights.

All engines are told the same scene and take steps of 1/60 s in turns, in one process on one thread,
with nothing asleep: Pymunk with 10 iterations, Box2D with 4 substeps, this library with its
defaults. Stop it by Ctrl-C, and it tells what it has found so far.
"""

from argparse import ArgumentParser
from collections.abc import Callable
from dataclasses import asdict
from functools import partial
from importlib.metadata import version
from pathlib import Path
from typing import Any, TypeAlias

from tamias2d.study.engines.box2d import Box2D
from tamias2d.study.engines.chipmunk import Chipmunk
from tamias2d.study.engines.engine import Maker
from tamias2d.study.engines.own import Own
from tools.measurements.arena import page, picture
from tools.measurements.arena.growth import BODIES, bytes_of_a_body, seconds
from tools.measurements.arena.quality import quality
from tools.measurements.arena.race import race
from tools.measurements.arena.reading import share_of_a_step
from tools.measurements.arena.scenes import SCENES
from tools.measurements.arena.start import starts
from tools.measurements.arena.towers import substeps_to_stand
from tools.measurements.columns import Table
from tools.measurements.progress import each, until_stopped

Part: TypeAlias = Callable[[dict[str, Any]], None]
"""A part of the measurement, which adds to what was found."""

_ENGINES: dict[str, Maker] = {engine.name: engine for engine in (Own, Chipmunk, Box2D)}
_READ = ("pyramid-30", "disc-pile", "free-discs")
_FIRST = "pyramid-30"


def options(parser: ArgumentParser) -> None:
    """Add what can be chosen."""
    parser.add_argument(
        "--scenes", nargs="+", choices=SCENES, metavar="SCENE",
        help=f"these alone, of {', '.join(SCENES)}",
    )  # fmt: skip
    parser.add_argument("--repeats", type=int, default=5, help="of each timing (5)")
    parser.add_argument(
        "--store", type=Path, metavar="FOLDER", help="also write the table and picture of the docs"
    )


def measure(
    scenes: list[str] | None = None, repeats: int = 5, store: Path | None = None
) -> dict[str, Any]:
    """Return what was found: `scenes` holds this library's numbers, `engines` everybody's."""
    peers = {"Pymunk": version("pymunk"), "pyb2d3": version("pyb2d3")}
    found: dict[str, Any] = {"scenes": {}, "engines": {}, "peers": peers, "repeats": repeats}
    parts: list[Part] = [partial(_scene, name, repeats) for name in scenes or SCENES]
    if not scenes:
        parts += _rest()
    with until_stopped():
        for part in each(parts):
            part(found)
    if store is not None:
        page.write(found, store)
        picture.draw(found, store)
    return found


def table(found: dict[str, Any]) -> Table:
    """Return heads and rows for people: each scene, and each engine on it."""
    return page.table(found)


def notes(found: dict[str, Any]) -> list[str]:
    """Return what else was found, a sentence each."""
    return page.notes(found)


def _scene(name: str, repeats: int, found: dict[str, Any]) -> None:
    entry = SCENES[name]
    scene = entry.make()
    times = race(
        list(_ENGINES.values()), scene, steps=entry.timed, repeats=repeats, call=entry.call
    )
    engines = {
        engine: {"seconds": times.of_a_step(engine)}
        | asdict(quality(make, scene, steps=entry.steps, stands=entry.stands))
        for engine, make in _ENGINES.items()
    }
    own = engines[Own.name]
    found["engines"][name] = engines
    found["scenes"][name] = {
        "ratio_to_pymunk": times.ratio("Pymunk", Own.name),
        "ratio_to_pyb2d3": times.ratio("pyb2d3", Own.name),
        **{key: own[key] for key in ("sag", "penetration", "speed_at_end")},
    }


def _rest() -> list[Part]:
    """Return the parts that are about no single scene."""
    return [
        *(partial(_reading, name) for name in _READ),
        _towers,
        *(partial(_growth, bodies) for bodies in BODIES),
        *(partial(_memory, engine) for engine in _ENGINES),
        _start,
    ]


def _reading(name: str, found: dict[str, Any]) -> None:
    scene = SCENES[name].make()
    found.setdefault("reading", {})[name] = {
        engine: share_of_a_step(make, scene) for engine, make in _ENGINES.items()
    }


def _towers(found: dict[str, Any]) -> None:
    found["towers"] = substeps_to_stand()


def _growth(bodies: int, found: dict[str, Any]) -> None:
    rows = found.setdefault("growth", [])
    rows.append({"bodies": bodies, "seconds": seconds(list(_ENGINES.values()), bodies)})


def _memory(engine: str, found: dict[str, Any]) -> None:
    found.setdefault("bytes_of_a_body", {})[engine] = bytes_of_a_body(engine)


def _start(found: dict[str, Any]) -> None:
    found["start"] = starts(_FIRST)
