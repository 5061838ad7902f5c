"""Mechanisms over long times: how far they are from where theory puts them, and at what cost.

Problems A01 and A02 of the multibody benchmarks. The longest pendulum takes a quarter of an hour.
"""

import argparse
import time
from typing import Any

import numpy as np

from tamias2d.motion import Dop853, PathMethod
from tamias2d.scene import Revolute, Scene, catalogue
from tamias2d.simulate import simulate
from tools.measurements.columns import Columns

PENDULUM = {
    10.0: (0.275087462576117, -0.961419205099125),
    100.0: (0.181513351427031, -0.983388480334058),
    2000.0: (-0.814603068589032, -0.580018827836935),
}
"""Where the mass is, m, after so many seconds: elliptic functions with 30 digits."""
FOUR_BARS = {
    (2, 10.0): (0.3284581115408154, 0.944518538178601),
    (40, 20.0): (0.4109011537629452, 0.9116799009719807),
}
"""Where the tip of the first crank is, m, for a number of four-bars after so many seconds."""


def four_bars(count: int) -> Scene:
    """Return four-bar linkages in a row: upright cranks of 1 m and 1 kg, their tips at 1 m/s."""
    scene = Scene(gravity=(0.0, -9.81))
    inertia = 1 / 12
    for k in range(count + 1):
        name = f"crank{k}"
        scene.add_body(
            None,
            mass=1.0,
            inertia=inertia,
            position=(k, 0.5),
            velocity=(0.5, 0.0),
            angular_velocity=-1.0,
            name=name,
        )
        scene.add_joint(Revolute(), name, (float(k), 0.0), anchor=(0.0, -0.5))
    for k in range(count):
        name, place = f"coupler{k}", (k + 0.5, 1.0)
        scene.add_body(None, mass=1.0, inertia=inertia, position=place, velocity=(1, 0), name=name)
        for side, crank in ((-0.5, f"crank{k}"), (0.5, f"crank{k + 1}")):
            scene.add_joint(Revolute(), name, crank, anchor=(side, 0.0), other_anchor=(0.0, 0.5))
    return scene


def options(parser: argparse.ArgumentParser) -> None:
    """Add how long it may take."""
    parser.add_argument("--longest", type=float, default=100.0, help="s of simulated time")
    parser.add_argument("--most", type=int, default=2, help="four-bars in a row")


def measure(longest: float, most: int) -> dict[str, Any]:
    """Return one row for each mechanism."""
    rows = [
        _row("A01 pendulum", catalogue.load("pendulum-a01"), duration, 1.0, place, Dop853(1e-14))
        for duration, place in PENDULUM.items()
        if duration <= longest
    ]
    rows += [
        _row(f"A02 {count} four-bars", four_bars(count), duration, 2.0, place, Dop853(1e-12))
        for (count, duration), place in FOUR_BARS.items()
        if count <= most
    ]
    return {"rows": rows}


COLUMNS: Columns = {
    "mechanism": "{what}",
    "duration": "{duration:g} s",
    "error": "{error:.1e} m",
    "energy": "{energy:.1e} J",
    "apart": "{apart:.1e} m",
    "evaluations": "{evaluations}",
    "time": "{seconds:.0f} s",
}


def _row(
    what: str,
    scene: Scene,
    duration: float,
    lever: float,
    place: tuple[float, float],
    method: PathMethod,
) -> dict[str, Any]:
    """Run a mechanism; the first body turns about its pivot `lever` times nearer than its tip."""
    began = time.process_time()
    run = simulate(scene, duration=duration, method=method, times=[0.0, duration], work_limit=10**7)
    return {
        "what": what,
        "duration": duration,
        "error": float(np.hypot(*(lever * run.position[-1, 0] - place))),
        "energy": float(run.energy[-1] - run.energy[0]),
        "apart": float(run.reactions.separation.max()),
        "evaluations": run.cost.force_evaluations if run.cost else 0,
        "seconds": time.process_time() - began,
    }
