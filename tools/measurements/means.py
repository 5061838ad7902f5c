"""Means over worlds (`ensemble_mean`) repeated: how often within their bounds, at what cost.

Five scenes with known means: of a formula, integrated by quadrature over what is drawn, or of
scipy's solution at the nodes of a quadrature. Each repetition has its own seed. Cost is in steps,
beside that of worlds in the finest steps alone for the same statistical error.
"""

import math
from argparse import ArgumentParser
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy import integrate, stats

from tamias2d import (
    Box,
    Disc,
    HalfPlane,
    Mean,
    Run,
    Scene,
    SemiImplicitEuler,
    Stepped,
    VelocityVerlet,
    ensemble_mean,
)
from tamias2d.motion import Method
from tools.measurements.columns import Columns
from tools.measurements.progress import each, until_stopped

_G = 9.81  # m/s^2


@dataclass(frozen=True, kw_only=True)
class Known:
    """A scene in which the mean of a quantity is known."""

    scene: Scene
    quantity: Callable[[Run], float]
    vary: dict[str, Any]
    duration: float
    """s"""
    method: Method
    time_step: float
    """The coarsest one, s."""
    tolerance: float
    mean: float


def options(parser: ArgumentParser) -> None:
    """Add what can be chosen."""
    parser.add_argument("--repetitions", type=int, default=200, help="of each mean (200)")
    parser.add_argument("--scenes", nargs="+", default=list(KNOWN), help="some of them (all)")


def measure(repetitions: int = 200, scenes: list[str] | None = None) -> dict[str, Any]:
    """Return a row for each scene."""
    found: dict[str, tuple[Known, list[Mean]]] = {}
    with until_stopped():
        for name in scenes or KNOWN:
            known, means = found[name] = KNOWN[name](), []
            for seed in each(range(repetitions), name):
                means.append(_found(known, seed))
    rows = [{"scene": name, **_row(*of)} for name, of in found.items() if of[1]]
    return {"repetitions": repetitions, "rows": rows}


def _found(known: Known, seed: int) -> Mean:
    return ensemble_mean(
        known.scene,
        known.quantity,
        duration=known.duration,
        vary=known.vary,
        tolerance=known.tolerance,
        seed=seed,
        method=known.method,
        time_step=known.time_step,
        times=(known.duration,),
        workers=1,
    )


def _row(known: Known, means: list[Mean]) -> dict[str, Any]:
    errors = np.array([abs(mean.value - known.mean) for mean in means])
    bounds = np.array([mean.bound for mean in means])
    costs = np.array([mean.cost / mean.plain_cost for mean in means])
    return {
        "repetitions": len(means),
        "within": float(np.mean(errors <= bounds)),
        "tolerance": known.tolerance,
        "met": bool((bounds <= known.tolerance * (1 + 1e-12)).all()),
        "error": float(np.median(errors)),
        "worst": float((errors / bounds).max()),
        "levels": int(np.median([len(mean.levels) for mean in means])),
        "cost": float(np.median(costs)),
        "dearest": float(costs.max()),
    }


COLUMNS: Columns = {
    "scene": "{scene}",
    "repetitions": "{repetitions}",
    "within": "{within:.1%}",
    "error/bound": "{worst:.2f}",
    "tolerance": "{tolerance:g}",
    "error": "{error:.2g}",
    "levels": "{levels}",
    "cost": "{cost:.3f}",
    "at most": "{dearest:.3f}",
}


def notes(_: dict[str, Any]) -> list[str]:
    """Return what the columns mean."""
    return [
        "within: share of them whose error is within "
        "their bound; error/bound: the worst; error, levels, cost: medians; cost: in steps, of "
        "worlds in the finest steps alone for the same statistical error"
    ]


def _spring() -> Known:
    """A mass on a spring of random stiffness, from the solution by hand."""
    time = 1.0

    def place(stiffness: float) -> float:
        return 0.5 * math.cos(math.sqrt(stiffness / 2) * time)

    scene = Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=2.0, position=(0.0, 1.5), name="bob")
    scene.add_spring("bob", (0.0, 0.0), stiffness=30.0, rest_length=1.0)
    return Known(
        scene=scene,
        quantity=lambda run: float(run.position[-1, 0, 1]),
        vary={"springs.0.stiffness": stats.uniform(28.0, 4.0)},
        duration=time,
        method=VelocityVerlet(),
        time_step=0.2,
        tolerance=0.004,
        mean=1 + integrate.quad(place, 28, 32)[0] / 4,
    )


def _fall() -> Known:
    """A fall against quadratic drag of a random coefficient, from the solution by hand."""
    time = 2.0

    def way(drag: float) -> float:
        return math.log(math.cosh(math.sqrt(_G * drag) * time)) / drag

    scene = Scene(gravity=(0.0, -_G))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), quadratic_drag=0.1, name="stone")
    return Known(
        scene=scene,
        quantity=lambda run: float(run.position[-1, 0, 1]),
        vary={"bodies.stone.quadratic_drag": stats.uniform(0.05, 0.1)},
        duration=time,
        method=SemiImplicitEuler(),
        time_step=0.2,
        tolerance=0.25,
        mean=-integrate.quad(way, 0.05, 0.15)[0] / 0.1,
    )


def _bounce() -> Known:
    """A ball that bounces once, of random height and restitution, from the solution by hand."""
    time = 0.7

    def height(restitution: float, start: float) -> float:
        met = math.sqrt(2 * start / _G)
        left = time - met
        return restitution * _G * met * left - _G * left**2 / 2

    scene = Scene(gravity=(0.0, -_G))
    floor = HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=1.0, name="floor")
    scene.add_body(Disc(radius=0.1), mass=1.0, position=(0.0, 1.1), restitution=0.7, name="ball")
    return Known(
        scene=scene,
        quantity=lambda run: float(run.position[-1, 1, 1]),
        vary={
            "bodies.ball.restitution": stats.uniform(0.6, 0.3),
            "bodies.ball.position.y": stats.uniform(0.9, 0.4),
        },
        duration=time,
        method=SemiImplicitEuler(),
        time_step=0.1,
        tolerance=0.032,
        mean=0.1 + integrate.dblquad(height, 0.8, 1.2, 0.6, 0.9)[0] / (0.4 * 0.3),
    )


def _slide() -> Known:
    """A box that friction stops, of random speed: the way is v^2/(2 mu g)."""
    friction = 0.5
    scene = Scene(gravity=(0.0, -_G))
    floor = HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.0, friction=friction, name="floor")
    scene.add_body(
        Box(width=1.0, height=0.2),
        mass=1.0,
        position=(0.0, 0.1),
        velocity=(2.0, 0.0),
        restitution=0.0,
        friction=friction,
        name="box",
    )
    return Known(
        scene=scene,
        quantity=lambda run: float(run.position[-1, 1, 0]),
        vary={"bodies.box.velocity.x": stats.uniform(1.8, 0.4)},
        duration=0.8,
        method=Stepped(),
        time_step=0.1,
        tolerance=0.009,
        mean=(2.2**3 - 1.8**3) / 3 / 0.4 / (2 * friction * _G),  # of v^2
    )


def _orbit() -> Known:
    """A planet of random speed around a sun that stands still, from scipy's solution."""
    time = 2.0

    def pull(_: float, state: Any) -> Any:
        x, y, u, v = state
        cube = math.hypot(x, y) ** 3
        return [u, v, -x / cube, -y / cube]

    def place(speed: float) -> float:
        start = [1.0, 0.0, 0.0, speed]
        found = integrate.solve_ivp(
            pull, (0.0, time), start, method="DOP853", rtol=1e-12, atol=1e-12
        )
        return float(found.y[0, -1])

    nodes, weights = np.polynomial.legendre.leggauss(20)
    scene = Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), name="sun")
    scene.add_body(None, mass=1e-9, position=(1.0, 0.0), velocity=(0.0, 1.0), name="planet")
    scene.add_attraction(gravitational_constant=1.0)
    return Known(
        scene=scene,
        quantity=lambda run: float(run.position[-1, 1, 0]),
        vary={"bodies.planet.velocity.y": stats.uniform(0.9, 0.3)},
        duration=time,
        method=SemiImplicitEuler(),
        time_step=0.1,
        tolerance=0.02,
        mean=float(np.dot(weights, [place(1.05 + 0.15 * node) for node in nodes])) / 2,
    )


KNOWN: dict[str, Callable[[], Known]] = {
    "spring": _spring,
    "fall with drag": _fall,
    "bounce": _bounce,
    "slide with friction, stepped": _slide,
    "orbit": _orbit,
}
