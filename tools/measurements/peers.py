"""Accuracy and cost beside Pymunk, on five small scenes: who is better where.

Errors are relative; with impacts they are medians over 32 phases of positions, times and states of
impacts, whichever is the largest. Pymunk runs at steps from those of a game to far shorter ones,
and has the orbit's law written by hand, as its users do.
"""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from tamias2d.run import Run
from tamias2d.scene import Disc, Scene, catalogue
from tamias2d.study.candidates import Candidate, candidates
from tamias2d.study.front import front
from tamias2d.study.peers import simulate
from tamias2d.study.phases import LEAST, phases
from tamias2d.study.truth import floor_of, truth_of
from tamias2d.study.work_precision import Point, point_of
from tools.measurements.columns import Table
from tools.measurements.progress import each

_RATES = (60, 240, 960, 3840)  # steps in a second
_OWN = {
    "ClosedForm": ("",),
    "Dop853": ("rtol 0.0001", "rtol 1e-08", "rtol 1e-12"),
    "DormandPrince5": ("rtol 0.01",),
}


def measure() -> dict[str, Any]:
    """Return one row for each scene, with all ways that were tried."""
    return {"rows": [_row(*one) for one in each(_scenes())]}


def table(found: dict[str, Any]) -> Table:
    """Return heads and rows for people: error in seconds of each way."""
    heads = ("scene", "Tamias2D", *(f"Pymunk, {rate} Hz" for rate in _RATES), "who is better")
    return heads, [
        (
            row["scene"],
            "; ".join(_cell(row, way) for way in row["ways"] if not way["peer"]),
            *(_cell(row, way) for way in row["ways"] if way["peer"]),
            row["verdict"],
        )
        for row in found["rows"]
    ]


def _scenes() -> list[tuple[str, Scene, float]]:
    fall = Scene(gravity=(0.0, -9.81), name="free fall")
    fall.add_body(Disc(radius=0.5), mass=1.0, position=(0.0, 0.0))
    throw = Scene(gravity=(0.0, -9.81), name="projectile")
    speed = 20 / 2**0.5
    throw.add_body(Disc(radius=0.5), mass=1.0, position=(0.0, 0.0), velocity=(speed, speed))
    return [
        ("free fall", fall, 4.0),
        ("projectile", throw, 1.5),
        ("orbit", catalogue.load("kepler"), 10.0),
        ("bounce", catalogue.load("bouncing-elastic"), 10.0),
        ("oblique impact", catalogue.load("oblique-discs"), 3.0),
    ]


def _row(name: str, scene: Scene, duration: float) -> dict[str, Any]:
    first = truth_of(scene, duration)
    impacts = first.history.run.impacts
    start = float(impacts.time[0]) if len(impacts) else 0.0
    scenes = phases(scene, duration, LEAST if len(impacts) else 1, first_impact=start)
    truths = [first, *(truth_of(other, duration) for other in scenes[1:])]
    tried = [
        _by_hand(way) if way.peer and name == "orbit" else way for way in _tried(scene, duration)
    ]
    points = [point_of(way, scenes, truths, timed=True) for way in tried]
    floor = floor_of(first)
    best = front([(_seconds(point), max(_error(point), floor)) for point in points])
    return {
        "scene": name,
        "duration": duration,
        "phases": len(scenes),
        "floor": floor,
        "ways": [_way(point, k in best) for k, point in enumerate(points)],
        "verdict": _verdict([points[k] for k in best]),
    }


def _tried(scene: Scene, duration: float) -> list[Candidate]:
    every = list(candidates(scene, rungs=[round(rate * duration) for rate in _RATES]))
    exact = any(way.name == "ClosedForm" for way in every)
    own = {"ClosedForm": ("",)} if exact else _OWN
    return [way for way in every if way.name == "Pymunk" or way.setting in own.get(way.name, ())]


def _by_hand(candidate: Candidate) -> Candidate:
    def run(scene: Scene, duration: float, times: Iterable[float]) -> Run:
        steps = candidate.steps or 1
        return simulate(scene, duration=duration, steps=steps, times=times, push=_kepler)

    return replace(candidate, run=run)


def _kepler(body: Any) -> tuple[float, float, float]:
    x, y = body.position
    pull = -body.mass / (x * x + y * y) ** 1.5
    return x * pull, y * pull, 0.0


def _verdict(best: list[Point]) -> str:
    """Say who is on the common front of error and seconds: from cheap to dear."""
    peers = [point for point in best if point.peer]
    if not peers:
        return "Tamias2D at any accuracy"
    return f"Pymunk for errors of {min(map(_error, peers)):.0e} and more; Tamias2D below"


def _error(point: Point) -> float:
    return point.error.size if point.error else float("inf")


def _seconds(point: Point) -> float:
    return point.seconds.minimum if point.seconds else float("inf")


def _way(point: Point, best: bool) -> dict[str, Any]:
    return {
        "method": point.method,
        "setting": point.setting,
        "peer": point.peer,
        "error": point.error.size if point.error else None,
        "worst": point.worst.size if point.worst else None,
        "seconds": point.seconds.median if point.seconds else None,
        "force_evaluations": point.cost.force_evaluations if point.cost else None,
        "front": best,
        "failure": point.failure,
    }


def _cell(row: dict[str, Any], way: dict[str, Any]) -> str:
    if way["error"] is None:
        return f"{way['failure']}"
    who = "" if way["peer"] else f"{way['method']} {way['setting']}".strip() + ": "
    error = f"{way['error']:.0e}" if way["error"] > row["floor"] else f"<= {row['floor']:.0e}"
    return f"{who}{error} in {way['seconds'] * 1e3:.2g} ms"
