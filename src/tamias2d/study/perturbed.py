"""The twin of a run: one that starts a little elsewhere, and shows how small errors grow.

Serves: horizons and certificates of exact runs. Hides: how a start is moved.

It is moved by 1e-12 of what changes during the run, as rounding would do; what stays as it is, and
what is zero throughout, rounding leaves alone, and so does the twin.
"""

import math
from dataclasses import replace

import numpy as np

from tamias2d.motion import ClosedForm, RungeKutta4, Stepped
from tamias2d.run import Run
from tamias2d.scene import Body, Scene
from tamias2d.scene.restart import restarted
from tamias2d.state import Array
from tamias2d.study.companion import RefusedError, companion
from tamias2d.study.error import apart, scale

MOVED = 1e-12
_ROUNDING = 2.0**-52
LOST = 1e-2  # of the scale: a twin that far away says nothing any more


def rounded_apart(run: Run) -> float | None:
    """Return how far twins end up that start one rounding away, m: what rounding does to a run.

    Unlike what is scaled from a larger change, it has in it the rounding of each impact. None if a
    twin could not go all the way.
    """
    try:
        twins = [
            _history(_twin(run, _ROUNDING, phase), run, {"method": run.method})
            for phase in (1.0, 2.0)
        ]
    except RefusedError:
        return None
    return max(float(apart(twin, run).max()) for twin in twins)


def growth(run: Run) -> Array | None:
    """Return (k,): how far the twin is from the run, relative to how far it was moved.

    None if the twin could not go all the way. The motion is that of the run where it is exact or
    goes through contacts by steps, and else that of a scheme on as many steps as the run took, for
    both.
    """
    twin = _twin(run, MOVED, 1.0)
    like_it = isinstance(run.method, ClosedForm | Stepped)
    method: dict[str, object] = {"method": run.method, "time_step": run.time_step}
    if not like_it:
        steps = max(run.cost.steps if run.cost else 0, 64)
        method = {"method": RungeKutta4(), "time_step": run.duration / steps}
    try:
        other = _history(twin, run, method)
        own = run if like_it else _history(run.scene, run, method)
    except RefusedError:
        return None
    away = apart(other, own)
    result: Array = away / max(MOVED * scale(run), float(away[0]))
    return result


def horizon(run: Run, grown: Array | None) -> float | None:
    """Return the time in s at which the twin is lost; None if that is not within the run."""
    if grown is None:
        return None
    lost = np.flatnonzero(~(grown * MOVED < LOST))
    return float(run.times[lost[0]]) if len(lost) else None


def _history(scene: Scene, run: Run, method: dict[str, object]) -> Run:
    return companion(scene, duration=run.duration, times=run.times, **method)


def _twin(run: Run, moved: float, phase: float) -> Scene:
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
