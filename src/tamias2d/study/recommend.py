"""Which method and step meet a tolerance at the least cost, and why the others lost.

The scene says which methods can be asked: the closed form where every body has one, which costs
nothing; else all schemes that suit its forces. A pilot finds what each would cost.
"""

import math
from dataclasses import dataclass, replace

from tamias2d.contact import steps_because
from tamias2d.errors import InputError, SceneError, SimulationError
from tamias2d.motion import (
    ClosedForm,
    Dop853,
    DormandPrince5,
    ExponentialDrag,
    Method,
    RungeKutta4,
    SemiImplicitEuler,
    VelocityVerlet,
    Yoshida4,
)
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.scene.acting import varying_loads
from tamias2d.scene.exact import closed_forms
from tamias2d.scene.rules import is_number, number, shown
from tamias2d.scene.scene_data import checked_scene
from tamias2d.solve import solve
from tamias2d.study.certify import certify
from tamias2d.study.offers import holding
from tamias2d.study.pilot import Estimate, Pilot
from tamias2d.study.refusal import LOOSEST, ToleranceError as ToleranceError, refusal
from tamias2d.study.stepped_plan import RULE_BOUNDS_NOTHING, plan_steps, stepped_because
from tamias2d.suggestions import suggests
from tamias2d.work_limit import WORK_LIMIT, WorkLimitError

TIGHTEST = 1e-15
_MORE = 4  # times the work of the first pilot run may the tightest one take


@dataclass(frozen=True)
class Recommendation:
    """What to do for a tolerance, and all that was weighed, the cheapest first."""

    tolerance: float
    estimates: tuple[Estimate, ...]
    pilot: int
    """Force evaluations that finding it has cost."""

    @property
    def choice(self) -> Estimate:
        """The cheapest that meets the tolerance."""
        return self.estimates[0]


@suggests
def recommend(
    scene: Scene, *, duration: float, tolerance: float, work_limit: int = WORK_LIMIT
) -> Recommendation:
    """Return how to simulate a scene for a duration in s within a tolerance.

    The tolerance bounds the distance of any point of any body from its exact place, at any time,
    relative to how far the farthest dynamic one goes. Where contacts are stepped, the place is that
    to which ever shorter steps lead, as far as they agree about it. Pilot runs take at most
    `work_limit` steps and impacts each, and twice as many together; by steps through contacts,
    1000 substeps of one body for each of them.

    Raises:
        InputError: an argument breaks a rule.
        ToleranceError: nothing meets it, or not within the work limit.
        SimulationError: the scene has no unique answer.
    """
    checked_scene(scene)
    duration = number(duration, "duration", "the run", "Give it in s.", at=("duration",))
    tolerance = checked_tolerance(tolerance)
    try:
        return _recommended(scene, duration, tolerance, work_limit)
    except ToleranceError as refused:
        raise holding(
            refused,
            duration,
            lambda other, time: _recommended(scene, time, other or tolerance, work_limit),
        ) from None


def _recommended(
    scene: Scene, duration: float, tolerance: float, work_limit: int
) -> Recommendation:
    """Return the recommendation; a refusal offers what was not tried."""
    reason = steps_because(scene, duration)
    if reason is None:
        try:
            if solved(scene):
                run = solve(scene, duration=duration, method=ClosedForm())
                if run.ruled is not None and not _bounds_positions(run):
                    reason = RULE_BOUNDS_NOTHING
            if reason is None:
                return located_plan(scene, duration, tolerance, work_limit)
        except (SimulationError, SceneError):
            if (reason := stepped_because(scene, duration)) is None:
                raise
    found = plan_steps(
        scene,
        duration=duration,
        tolerance=tolerance,
        times=[duration],
        work_limit=work_limit,
        reason=reason,
    )
    return Recommendation(tolerance, found.estimates, found.spent)


def _bounds_positions(run: Run) -> bool:
    certificate = certify(run).certificate
    return certificate is not None and certificate.bounds_positions


def located_plan(
    scene: Scene, duration: float, tolerance: float, work_limit: int
) -> Recommendation:
    """Return what to do where impacts are located; raises as `recommend` does."""
    if solved(scene):
        why = "costs nothing more than its impacts"
        return Recommendation(tolerance, (Estimate(ClosedForm(), None, 0.0, 0.0, None, why),), 0)
    try:
        pilot = Pilot(scene, duration, tolerance, work_limit)
    except WorkLimitError as spent:
        raise _beyond(tolerance, duration, work_limit, spent) from spent
    if pilot.reachable > tolerance:
        raise refusal(tolerance, pilot.reachable, until=pilot.until)
    found = _weighed(scene, pilot)
    if not math.isfinite(found[0].force_evaluations):
        raise refusal(tolerance, min(estimate.error for estimate in found))
    return Recommendation(tolerance, tuple(found), pilot.spent)


def solved(scene: Scene) -> bool:
    """Whether every body that moves has a closed form."""
    return not set(varying_loads(scene)) - set(closed_forms(scene))


def checked_tolerance(value: object) -> float:
    """Return a tolerance that a run can be asked for; raise `InputError` otherwise."""
    remedy = "Give a relative error such as 1e-6."
    if not is_number(value) or not value == value:
        raise InputError(f"tolerance {shown(value)}: must be a number (R5). {remedy}")
    if not TIGHTEST <= value <= LOOSEST:
        raise InputError(
            f"tolerance {shown(value)}: must lie from {TIGHTEST:g}, which is as far as float64 "
            f"goes, to {LOOSEST:g} (R5). {remedy}"
        )
    return float(value)


def _beyond(
    tolerance: float, duration: float, work_limit: int, spent: WorkLimitError
) -> ToleranceError:
    """Return the error that says how far pilot runs came, and what a whole one would take."""
    until, more = None, "larger one"
    if spent.time > 0:
        until = float(f"{spent.time / _MORE:.1e}")
        more = f"work_limit of about {_MORE * work_limit * duration / spent.time:.2g}"
    return ToleranceError(
        f"tolerance {tolerance:g}: the run that methods are compared with came to {spent.time:.4g} "
        f"s of {duration:g} s within a work_limit of {work_limit} (R4, R5).",
        until=until,
        otherwise=f"give a {more}, or run by a method of fixed steps and certify that",
    )


def _weighed(scene: Scene, pilot: Pilot) -> list[Estimate]:
    """Return the estimates of all methods, the cheapest first; those who lost say why."""
    found = [pilot.adaptive(Dop853)]
    found.append(pilot.adaptive(DormandPrince5, found[0].force_evaluations))
    for method in schemes_for(scene):
        best = min(estimate.force_evaluations for estimate in found)
        found.append(pilot.fixed_step(method, best))
    found.sort(key=lambda estimate: estimate.force_evaluations)
    best = found[0].force_evaluations
    reasons = ["the cheapest", *(one.why or _lost(one, best) for one in found[1:])]
    return [replace(one, why=why) for one, why in zip(found, reasons, strict=True)]


def _lost(one: Estimate, best: float) -> str:
    return f"costs {one.force_evaluations / best:.3g} times as much"


def schemes_for(scene: Scene) -> list[Method]:
    """Return the stepped methods that suit the forces of a scene."""
    schemes: list[Method] = [RungeKutta4(), Yoshida4(), VelocityVerlet(), SemiImplicitEuler()]
    if any(body.linear_drag for body in scene.bodies) and not scene.joints:
        schemes.insert(0, ExponentialDrag())
    return schemes
