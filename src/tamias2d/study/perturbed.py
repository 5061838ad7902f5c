"""Perturbed runs: they start a little elsewhere, and so show how small errors grow.

Each coordinate and rate is moved by a share of its largest size in the run. Those that stay the
same throughout are left alone, as rounding leaves them alone.
"""

import math
from dataclasses import replace

import numpy as np

from tamias2d.float64 import EPSILON
from tamias2d.motion import ClosedForm, Dop853, RungeKutta4, Stepped
from tamias2d.run import Run
from tamias2d.scene import Body, Scene
from tamias2d.scene.other_bodies import with_bodies
from tamias2d.state import Array
from tamias2d.study.companion import RefusedError, companion, limit_beside
from tamias2d.study.error import apart
from tamias2d.study.scale import scale

MOVED = 1e-12
_FINE = 1e-13  # errs less than what is perturbed
LOST = 1e-2  # of the scale: so far away a perturbed run says nothing any more


def rounding_spread(run: Run) -> float | None:
    """Return how far runs perturbed by one rounding end up from a run, m.

    A larger perturbation, scaled down, would leave out the rounding of each impact. None if a
    perturbed run is refused before its end.
    """
    try:
        perturbed = [
            _history(_perturbed(run, EPSILON, phase), run, {"method": run.method})
            for phase in (1.0, 2.0)
        ]
    except RefusedError:
        return None
    return max(float(apart(one, run).max()) for one in perturbed)


def growth(run: Run) -> Array | None:
    """Return (k,): how far a perturbed run is from the run, relative to its perturbation.

    None if it is refused before its end.
    """
    perturbed = _perturbed(run, MOVED, 1.0)
    for method in _ways(run):
        try:
            own = run if method["method"] is run.method else _history(run.scene, run, method)
            other = _history(perturbed, run, method)
        except RefusedError:
            return None
        if float(apart(own, run).max()) <= LOST * scale(run):
            break
    away = apart(other, own)
    result: Array = away / max(MOVED * scale(run), float(away[0]))
    return result


def _ways(run: Run) -> list[dict[str, object]]:
    """Return by which methods a run and a perturbed one are compared, the cheapest first.

    Runs that are exact or step through contacts go by their own method; others by a scheme on as
    many equal steps as they took or, where that leads elsewhere, by steps that are chosen.
    """
    if isinstance(run.method, ClosedForm | Stepped):
        return [{"method": run.method, "time_step": run.time_step}]
    steps = max(run.cost.steps if run.cost else 0, 64)
    return [
        {"method": RungeKutta4(), "time_step": run.duration / steps},
        {"method": Dop853(rtol=_FINE)},
    ]


def horizon(run: Run, grown: Array | None) -> float | None:
    """Return the time in s at which a perturbed run is lost; None if it is not within the run."""
    if grown is None:
        return None
    lost = np.flatnonzero(~(grown * MOVED < LOST))
    return float(run.times[lost[0]]) if len(lost) else None


def _history(scene: Scene, run: Run, method: dict[str, object]) -> Run:
    limit = limit_beside(run)
    return companion(scene, duration=run.duration, times=run.times, work_limit=limit, **method)


def _perturbed(run: Run, moved: float, phase: float) -> Scene:
    parts = (
        run.position[..., 0],
        run.position[..., 1],
        run.orientation,
        run.velocity[..., 0],
        run.velocity[..., 1],
        run.angular_velocity,
    )
    size = [np.abs(part).max(axis=0) * (np.ptp(part, axis=0) > 0) for part in parts]
    bodies = [
        _moved(body, [moved * float(part[i]) for part in size], phase + 14.4 * i)
        for i, body in enumerate(run.scene.bodies)
    ]
    return with_bodies(run.scene, bodies)


def _moved(body: Body, by: list[float], phase: float) -> Body:
    """Return a body moved by given sizes, to sides that differ with the phase."""
    start = (*body.position, body.orientation, *body.velocity, body.angular_velocity)
    x, y, turn, u, v, spin = (
        value + math.copysign(size, math.cos(phase + 2.4 * k))
        for k, (value, size) in enumerate(zip(start, by, strict=True))
    )
    return replace(body, position=(x, y), orientation=turn, velocity=(u, v), angular_velocity=spin)
