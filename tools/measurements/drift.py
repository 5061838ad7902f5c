"""Energy over 1e7 steps of an orbit, and of a disc that bounces: a swing, or a trend?

The orbit is flown by kernels. The bounce by steps takes most of the time: some six minutes.
"""

from dataclasses import asdict
from typing import Any

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
from tools.measurements.columns import Columns
from tools.measurements.progress import each

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
    rows = [go(method, steps) for go, method, steps in each(runs)]
    return {"rows": [_row(drift) for drift in rows]}


COLUMNS: Columns = {
    "scene": "{scene}",
    "method": "{method}",
    "steps": "{steps:.0e}",
    "impacts": "{impacts}",
    "swing": "{swing:.1e}",
    "largest": "{largest:.1e}",
    "trend": "{trend:+.1e}",
    "verdict": lambda row: "no trend" if row["trendless"] else "trend",
}


def _row(drift: Drift) -> dict[str, Any]:
    return asdict(drift) | {"trendless": drift.trendless}
