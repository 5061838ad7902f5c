"""Energy over 1e7 steps of an orbit, and of a disc that bounces: a swing, or a trend?

The orbit is flown by kernels. The bounce by steps takes most of the time: some six minutes.
"""

from dataclasses import asdict
from typing import Any

from rich.console import Console
from rich.progress import track

from tamias2d.motion import (
    ClosedForm,
    ExplicitEuler,
    Method,
    RungeKutta4,
    SemiImplicitEuler,
    VelocityVerlet,
    Yoshida4,
)
from tamias2d.study.drift import Drift, bounce_drift, orbit_drift

_STEPS = 10_000_000
ORBITERS: tuple[Method, ...] = (
    SemiImplicitEuler(),
    VelocityVerlet(),
    Yoshida4(),
    RungeKutta4(),
    ExplicitEuler(),
)


def measure() -> dict[str, Any]:
    """Return one row for each scene and method; the last two orbiters are there to be caught."""
    runs = [(orbit_drift, method, _STEPS) for method in ORBITERS]
    runs += [(bounce_drift, method, _STEPS) for method in (ClosedForm(), VelocityVerlet())]
    told = Console(stderr=True)
    rows = [go(method, steps) for go, method, steps in track(runs, console=told, transient=True)]
    return {"rows": [_row(drift) for drift in rows]}


def table(found: dict[str, Any]) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """Return heads and rows for people."""
    heads = ("scene", "method", "steps", "impacts", "swing", "largest", "trend", "verdict")
    return heads, [
        (
            row["scene"],
            row["method"],
            f"{row['steps']:.0e}",
            f"{row['impacts']}",
            f"{row['swing']:.1e}",
            f"{row['largest']:.1e}",
            f"{row['trend']:+.1e}",
            "no trend" if row["trendless"] else "trend",
        )
        for row in found["rows"]
    ]


def _row(drift: Drift) -> dict[str, Any]:
    return asdict(drift) | {"trendless": drift.trendless}
