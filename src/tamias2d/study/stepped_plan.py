"""The cheapest steps through contacts that are within a tolerance of where shorter ones lead.

Runs are refined until they agree about the answer. Then steps and substeps are tried from cheap to
dear, each whole, until one is near enough to that answer.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from tamias2d.contact import steps_because
from tamias2d.errors import SceneError, SimulationError
from tamias2d.motion import Stepped
from tamias2d.scene import Scene
from tamias2d.scene.reach import pairs_that_can_meet
from tamias2d.simulator.stepper import SAME_STEP
from tamias2d.solve import FRAMES, solve
from tamias2d.state import Array
from tamias2d.study.companion import RefusedError
from tamias2d.study.looks import LOOKS_AT_STEPS, with_ends_of_steps
from tamias2d.study.pilot import Estimate
from tamias2d.study.refined import Refined, refined, refinements, step_alone, stepped, work_of
from tamias2d.study.refusal import BOUND_LESS, LOOSEST, ToleranceError, rounded_up, sooner

_SHARE = 1 / 3  # of the tolerance may be in doubt
WORK = 1000.0
"""Substeps of one body for each step of the work limit: together they take some 0.1 ms."""
_SUBSTEPS = (1, 2, 4, 8, 16)
_COARSEST = 2.0 / FRAMES  # s
_FEWEST = 16  # steps of a run
_FALLS = 8.0  # times, at most, halving a step makes an error smaller
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
    estimates, spent = _cheapest(refined, duration, tolerance, first)
    return SteppedPlan(refined, estimates, spent + sum(found.steps for found in seen))


def _cheapest(
    refined: Refined, duration: float, tolerance: float, first: float
) -> tuple[tuple[Estimate, ...], int]:
    """Return the cheapest steps that meet a tolerance, what failed, and the steps of pilots.

    What shorter steps probably do not meet is tried last. Errors of steps longer than the first
    tell nothing of others: they have samples within steps, where an impact may be.
    """
    failed: dict[int, Estimate] = {}  # the last of each number of substeps
    least: dict[int, float] = {}  # error of the next step, as errors fall
    doubtful: list[tuple[float, int]] = []
    spent = 0

    def meets(step: float, substeps: int) -> bool:
        nonlocal spent
        estimate = _tried(refined, duration, step, substeps)
        spent += math.ceil(duration / step)
        failed[substeps] = estimate
        if step <= first * (1 + SAME_STEP):
            least[substeps] = estimate.error
        return estimate.error <= tolerance

    def found(estimate: Estimate) -> tuple[tuple[Estimate, ...], int]:
        lost = (_lost(one) for one in failed.values() if one is not estimate)
        return (estimate, *lost), spent

    for step, substeps in ladder(refined.scene, duration, 2 * first, 2 * refined.time_step):
        if substeps in least and (less := least[substeps] / _FALLS) > tolerance:
            least[substeps] = less
            doubtful.append((step, substeps))
        elif meets(step, substeps):
            return found(failed[substeps])
    for step, substeps in doubtful:
        if meets(step, substeps):
            return found(failed[substeps])
    steps = math.ceil(duration / refined.time_step)
    method = Stepped(refined.substeps)
    return found(Estimate(method, refined.time_step, steps, refined.share, None, "the cheapest"))


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


def ladder(
    scene: Scene, duration: float, coarsest: float, finest: float
) -> Iterator[tuple[float, int]]:
    """Yield steps, s, and substeps from cheap to dear."""
    steps = [coarsest]
    while steps[-1] / 2 >= finest * (1 - 1e-9):
        steps.append(steps[-1] / 2)
    pairs = [(step, substeps) for step in steps for substeps in _SUBSTEPS]
    yield from sorted(pairs, key=lambda pair: work_of(scene, duration, *pair))


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


def _tried(refined: Refined, duration: float, step: float, substeps: int) -> Estimate:
    steps = math.ceil(duration / step)
    method = Stepped(substeps)
    try:
        history = stepped(refined.scene, duration, refined.times, step, substeps)
    except RefusedError as fault:
        return Estimate(method, step, math.inf, math.inf, None, f"refused: {fault}")
    error = refined.bound(history) / float(refined.length[-1])
    return Estimate(method, step, steps, error, None, "the cheapest")


def _lost(estimate: Estimate) -> Estimate:
    """Return an estimate that fails, with the reason."""
    why = estimate.why
    if math.isfinite(estimate.error):
        why = "needs shorter steps, which cost more than the cheapest"
    return replace(estimate, force_evaluations=math.inf, why=why)


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
