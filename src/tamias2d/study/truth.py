"""The run that others are compared with: the closed form, or else a far tighter run."""

import math
from dataclasses import dataclass
from time import thread_time

import numpy as np

from tamias2d.float64 import EPSILON
from tamias2d.motion import ClosedForm, Dop853, Method, Reference
from tamias2d.scene import Scene
from tamias2d.scene.exact import closed_forms
from tamias2d.solve import solve
from tamias2d.solve.located import are_many
from tamias2d.state import Array
from tamias2d.study.event_errors import errors
from tamias2d.study.perturbed import rounding_spread
from tamias2d.study.refusal import ToleranceError, sooner
from tamias2d.study.sampled import Sampled, sampled
from tamias2d.study.scale import scale
from tamias2d.study.schedule import LONGEST

SAMPLES = 1000
_TIGHTEST = 1e-13
_LOOSE, _ORDER = 1e-3, 8  # by the order of the method tighter runs take more steps
_PARTS = 1 / 64, 1 / 8, 1.0  # of the duration: what is too long is known before its end
_LONGEST = 60.0
"""s of the processor: what runs for the truth may take together: two of each phase, and two"""
_USUAL = 20  # times what a closed form takes, other methods do where there are impacts
_RUNS = 30  # of each phase


@dataclass(frozen=True)
class Truth:
    """The best that is known of a scene."""

    history: Sampled
    how: str


def affordable_phases(scene: Scene, duration: float, asked: int) -> int:
    """Return how many phases of those that are asked for can be studied in about a minute.

    That is estimated from runs that are quick, of parts and the whole: a whip is slow at first.
    Raises `ToleranceError` where a truth would take too long even of one.
    """
    exact = closed_forms_of_all(scene)
    more = 0.0 if exact else (_LOOSE / _TIGHTEST) ** (1 / _ORDER)
    method = ClosedForm() if exact else Reference(_LOOSE)
    _seconds(scene, _PARTS[0] * duration, method)  # its code is loaded
    for part in _PARTS:
        until = part * duration
        quick = _seconds(scene, until, method)
        if (coming := 4 * more * quick) > _LONGEST:
            raise _too_long(coming / part, duration, until * _LONGEST / coming)
    usual = _USUAL * quick if exact else quick
    for_truths = (_LONGEST / (more * quick) - 2) / 2 if more and quick else math.inf
    for_points = LONGEST / (_RUNS * usual) if usual else math.inf
    return max(1, int(min(asked, for_truths, for_points)))


def _seconds(scene: Scene, duration: float, method: Method) -> float:
    """Return what a run takes, s of the processor."""
    began = thread_time()
    solve(scene, duration=duration, method=method, times=[duration])
    return thread_time() - began


def _too_long(coming: float, duration: float, until: float) -> ToleranceError:
    """Return the refusal of what would take so many s, and for which duration, s, it would not."""
    return ToleranceError(
        f"tradeoff: what others are compared with would take about {coming:.2g} s for "
        f"{duration:g} s, and may take {_LONGEST:g} s (R4).",
        until=sooner(until),
        otherwise="ask for a tolerance or a quality",
    )


def closed_forms_of_all(scene: Scene) -> bool:
    """Whether every body that moves has a closed form."""
    return len(closed_forms(scene)) == sum(body.dynamic for body in scene.bodies)


def common_times(duration: float) -> Array:
    """Return the times at which all runs of a scene are compared, s."""
    return np.linspace(0.0, duration, SAMPLES + 1)


def truth_of(scene: Scene, duration: float) -> Truth:
    """Return the truth of a scene over a duration in s.

    Raises:
        SceneError, SimulationError: as `simulate`.
    """
    if closed_forms_of_all(scene):
        return Truth(_history(scene, duration, ClosedForm()), "closed form")
    reference = Reference(_TIGHTEST)
    return Truth(_history(scene, duration, reference), f"{reference}")


def floor_of(truth: Truth) -> float:
    """Return how far an independent way is from the truth: no error below it means anything.

    Where other methods would follow so many bodies one by one, it is how far runs are whose starts
    differ by a rounding.
    """
    run = truth.history.run
    if isinstance(run.method, ClosedForm) and are_many(run.scene):
        spread = rounding_spread(run)
        return max(1.0 if spread is None else spread / scale(run), EPSILON)
    other = _history(run.scene, run.duration, Dop853(_TIGHTEST))
    return max(errors(other, truth.history).size, EPSILON)


def _history(scene: Scene, duration: float, method: Method) -> Sampled:
    first = solve(scene, duration=duration, method=method, times=[duration])
    return sampled(
        lambda wanted: solve(scene, duration=duration, method=method, times=wanted),
        common_times(duration),
        first.impacts,
    )
