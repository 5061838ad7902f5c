"""Perturbed runs: they start a little elsewhere, and so show how small errors grow.

Each coordinate and rate is moved by a share of its largest size in the run. Those that stay the
same throughout are left alone, as rounding leaves them alone.
"""

import math
from dataclasses import replace

import numpy as np

from tamias2d.motion import ClosedForm, RungeKutta4, Stepped
from tamias2d.run import Run
from tamias2d.scene import Body, Scene
from tamias2d.scene.restart import restarted
from tamias2d.state import Array
from tamias2d.study.companion import RefusedError, companion, limit_beside
from tamias2d.study.error import apart, scale

MOVED = 1e-12
_ROUNDING = 2.0**-52
LOST = 1e-2  # of the scale: so far away a perturbed run says nothing any more


def rounding_spread(run: Run) -> float | None:
    """Return how far runs perturbed by one rounding end up from a run, m.

    A larger perturbation, scaled down, would leave out the rounding of each impact. None if a
    perturbed run is refused before its end.
    """
    try:
        perturbed = [
            _history(_perturbed(run, _ROUNDING, phase), run, {"method": run.method})
            for phase in (1.0, 2.0)
        ]
    except RefusedError:
        return None
    return max(float(apart(one, run).max()) for one in perturbed)


def growth(run: Run) -> Array | None:
    """Return (k,): how far a perturbed run is from the run, relative to its perturbation.

    None if it is refused before its end. Runs that are exact or step through contacts are compared
    with perturbed runs by their own method; others are made anew, like the perturbed run, by a
    scheme on as many steps as they took.
    """
    perturbed = _perturbed(run, MOVED, 1.0)
    like_it = isinstance(run.method, ClosedForm | Stepped)
    method: dict[str, object] = {"method": run.method, "time_step": run.time_step}
    if not like_it:
        steps = max(run.cost.steps if run.cost else 0, 64)
        method = {"method": RungeKutta4(), "time_step": run.duration / steps}
    try:
        other = _history(perturbed, run, method)
        own = run if like_it else _history(run.scene, run, method)
    except RefusedError:
        return None
    away = apart(other, own)
    result: Array = away / max(MOVED * scale(run), float(away[0]))
    return result


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
    return restarted(run.scene, bodies)


def _moved(body: Body, by: list[float], phase: float) -> Body:
    """Return a body moved by given sizes, to sides that differ with the phase."""
    start = (*body.position, body.orientation, *body.velocity, body.angular_velocity)
    x, y, turn, u, v, spin = (
        value + math.copysign(size, math.cos(phase + 2.4 * k))
        for k, (value, size) in enumerate(zip(start, by, strict=True))
    )
    return replace(body, position=(x, y), orientation=turn, velocity=(u, v), angular_velocity=spin)
