"""The cheapest steps through contacts that are within a tolerance of where shorter ones lead.

Runs are refined until they agree about the answer. Then the cheapest steps are looked for that are
near enough to it (`cheapest_steps`).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tamias2d.contact import steps_because
from tamias2d.errors import SceneError, SimulationError
from tamias2d.motion import Stepped
from tamias2d.scene import Scene
from tamias2d.scene.reach import pairs_that_can_meet
from tamias2d.simulator.stepper import SAME_STEP
from tamias2d.solve import FRAMES, solve
from tamias2d.state import Array
from tamias2d.study.cheapest_steps import Pilots
from tamias2d.study.companion import RefusedError
from tamias2d.study.looks import LOOKS_AT_STEPS, with_ends_of_steps
from tamias2d.study.pilot import Estimate
from tamias2d.study.refined import Refined, refined, refinements, step_alone
from tamias2d.study.refusal import BOUND_LESS, LOOSEST, ToleranceError, rounded_up, sooner

_SHARE = 1 / 3  # of the tolerance may be in doubt
WORK = 1000.0
"""Substeps of one body for each step of the work limit: together they take some 0.1 ms."""
_COARSEST = 2.0 / FRAMES  # s
_FEWEST = 16  # steps of a run
_STALE = 4  # halvings in which the doubt must halve, or it never will
_HALVINGS = 30  # of the first step: more than any work limit leaves


RULE_BOUNDS_NOTHING = "impacts that act on one another are decided by a rule (A18)"


@dataclass(frozen=True)
class SteppedPlan:
    """What to do for a tolerance, and what was found out on the way."""

    refined: Refined
    estimates: tuple[Estimate, ...]
    """The cheapest that meets the tolerance first, then what failed"""
    spent: int
    """Steps of pilot runs"""


def stepped_because(scene: Scene, duration: float) -> str | None:
    """Return why the contacts of a scene are stepped where a bound is asked for, or None.

    They are if nothing is asked for, or where a rule decides what no bound is known of.
    """
    if reason := steps_because(scene, duration):
        return _first_sentence(reason)
    if not pairs_that_can_meet(scene, duration):
        return None
    try:
        run = solve(scene, duration=duration, times=[duration])
    except (SimulationError, SceneError):
        return None
    if not isinstance(run.method, Stepped):
        return None if run.ruled is None else RULE_BOUNDS_NOTHING
    assert run.stepped_because is not None
    return _first_sentence(run.stepped_because)


def _first_sentence(reason: str) -> str:
    """Return a reason without what to do about it."""
    return reason.partition(". ")[0]


def plan_steps(
    scene: Scene,
    *,
    duration: float,
    tolerance: float,
    times: Sequence[float] | Array,
    work_limit: int,
    reason: str,
) -> SteppedPlan:
    """Return the cheapest steps within a tolerance of where shorter ones lead, at all times, s.

    Raises:
        ToleranceError: runs do not agree so well, or not up to the end; it says until when.
    """
    first, looked = _grid(duration, times)
    seen = _refined(scene, duration, tolerance, looked, first, WORK * work_limit)
    refined = seen[-1]
    if len(seen) < 2 or not refined.share <= _SHARE * tolerance:
        raise _beyond(tolerance, duration, seen, reason)
    pilots = Pilots(refined, duration, tolerance, first)
    estimates = pilots.cheapest()
    return SteppedPlan(refined, estimates, pilots.spent + sum(found.steps for found in seen))


def refined_to(
    scene: Scene, *, duration: float, times: Array, shortest: float | None
) -> Refined | None:
    """Return what shorter steps say, refined as in a plan down to the shortest step, s.

    None if no plan of this scene has such steps.
    """
    first, looked = _grid(duration, times)
    for step in (first / 2**halvings for halvings in range(1, _HALVINGS)):
        if shortest == step / 2:
            longer, shorter = (
                refined(scene, duration=duration, times=looked, time_step=each, grid=first)
                for each in (2 * step, step)
            )
            return shorter.after(longer)
    return None


def _grid(duration: float, times: Sequence[float] | Array) -> tuple[float, Array]:
    """Return the step, s, from which runs are refined, and the times (k,), s, at which they are."""
    asked = np.unique(np.asarray(times, dtype=float))
    first = aligned_step(duration, asked)
    return first, with_ends_of_steps(asked, duration, first)


def first_step(duration: float) -> float:
    """Return the step from which runs are refined, s."""
    return min(1 / FRAMES, duration / _FEWEST)


def aligned_step(duration: float, times: Array) -> float:
    """Return about `first_step`, s, so that most of the times (k,), s, are at ends of steps."""
    most = first_step(duration)
    gap = float(np.median(np.diff(times, prepend=0.0)[times > 0.0])) if times.any() else duration
    if gap > most:
        return gap / math.ceil(gap / most * (1 - SAME_STEP))
    return gap * 2.0 ** math.floor(math.log2(most / gap * (1 + SAME_STEP)))


def _refined(
    scene: Scene, duration: float, tolerance: float, times: Array, step: float, work: float
) -> list[Refined]:
    """Return refinements, the last of which is good enough, or no better than those before.

    Each but the first is trusted no more than the one before it.
    """
    seen: list[Refined] = []
    share = _SHARE * tolerance
    try:
        before = None
        for found in refinements(
            scene,
            duration=duration,
            times=times,
            time_step=step,
            work=work,
            per_step=step_alone(scene),
        ):
            seen.append(found if before is None else found.after(before))
            if (before and seen[-1].share <= share) or _stale(seen, share):
                break
            before = found
    except RefusedError as fault:
        if not seen:
            raise ToleranceError(
                f"tolerance {tolerance:g}: a run by short steps was refused: {fault}"
            ) from fault
    return seen


def _stale(seen: list[Refined], share: float) -> bool:
    """Whether shorter steps brought runs neither nearer to each other nor farther together."""
    if len(seen) <= _STALE:
        return False
    now, then = seen[-1], seen[-1 - _STALE]
    return now.share > 0.5 * then.share and _agreed(now, share) < 1.1 * _agreed(then, share)


def _beyond(tolerance: float, duration: float, seen: list[Refined], reason: str) -> ToleranceError:
    """Return the error that says until when, and how well, runs agree."""
    offer = rounded_up(min(found.share for found in seen[1:] or seen) / _SHARE)
    until = _agreed(seen[-1], _SHARE * tolerance)  # what only longer steps agreed on was chance
    before = sooner(until) if until > duration / LOOKS_AT_STEPS else None
    agree = "do not agree so well"
    if before is not None:
        agree = f"agree so well only up to {until:.3g} s of {duration:g} s"
    return ToleranceError(
        f"tolerance {tolerance:g}: contacts are stepped, and runs of ever shorter steps {agree} "
        f"(R5, R12; {reason}).",
        offer if offer <= LOOSEST else None,
        until=before,
        otherwise=BOUND_LESS,
    )


def _agreed(found: Refined, share: float) -> float:
    """Return up to which time runs agree within a share of the length, s."""
    return float(found.times[found.agreed(share)])
