"""A certificate for a run, from companion runs of the same scene that bound its error."""

from collections.abc import Callable
from dataclasses import replace

from tamias2d.certificate import USUAL, Basis, Certificate
from tamias2d.errors import InputError
from tamias2d.motion import ClosedForm, Dop853, DormandPrince5, Legacy2018, Stepped
from tamias2d.motion.halved import Halving
from tamias2d.run import Run
from tamias2d.scene.reach import pairs_that_can_meet
from tamias2d.scene.rules import shown
from tamias2d.solve import sampled_at
from tamias2d.state import Array
from tamias2d.study.bound import Bound, Bounder, NoBoundError, companion_of
from tamias2d.study.companion import RefusedError, companion, limit_beside
from tamias2d.study.embedded import embedded, looser_than, of_halves, of_tighter, whole_beside
from tamias2d.study.exact_bound import exact
from tamias2d.study.looks import looked_at, with_looks
from tamias2d.study.path_error import error_beside, has_error_equation, of_error
from tamias2d.study.penetration import crowded, penetrations
from tamias2d.study.perturbed import LOST, MOVED, growth, horizon
from tamias2d.study.quality import certify_quality
from tamias2d.study.refined import Refined
from tamias2d.study.scale import scale
from tamias2d.study.statement import of_energy, of_penetration, of_positions, with_rule
from tamias2d.study.step_doubling import against_shorter, shorter_runs, step_doubling
from tamias2d.study.stepped_plan import refined_to
from tamias2d.suggestions import suggests

_COARSE = 10 * MOVED  # is the tolerance of a method whose steps err more than what is perturbed


@suggests
def certify(run: Run) -> Run:
    """Return the run with a certificate; without a bound where bodies pass through each other.

    The scene is simulated some times more: in closed form twice, by a stepped scheme on two coarser
    grids (together three quarters of the run's cost, and a finer one if they disagree about the
    order), by an adaptive one with the equation of its error, at a tighter tolerance where lasting
    contacts or joints hide that or, where its steps are halved, by whole ones,
    through contacts eight times by steps from its own to a quarter (some 15 times the run's cost);
    once more, perturbed, where steps are equal or a path is exact; and once to look for bodies that
    overlap or pass through each other.
    """
    if not isinstance(run, Run):
        raise InputError(f"run: found {shown(run)}: must be a Run (R5). Give one of `simulate`.")
    if isinstance(run.method, Stepped):
        return certify_steps(run)
    return replace(run, certificate=_certificate(_looked_at(run)))


def _certificate(run: Run) -> Certificate | None:
    return _certified(run, _bounder_for(run), with_horizon=True).certificate


def _looked_at(run: Run) -> Run:
    """Return a run with samples also when it is looked at, if it can be made again with these."""
    if looked_at(run) is not None or isinstance(run.method, Legacy2018 | Stepped):
        return run
    limit, times = limit_beside(run), with_looks(run.times, run.duration)
    given = {"method": run.method, "time_step": run.time_step, "work_limit": limit}
    try:
        whole = companion(run.scene, duration=run.duration, times=times, **given)
    except RefusedError:
        return run
    same = sampled_at(whole, run.times)
    return run if same is None or same.digest() != run.digest() else whole


def certify_with_error(run: Run, error: Array | None) -> Run:
    """Return an adaptive run with a certificate from the largest error (n, 3) of its path.

    The equation of the error knows how this grows: no perturbed run is needed.
    """
    if pairs_that_can_meet(run.scene, run.duration):
        return _certified(run, of_error(error))
    return replace(run, certificate=_stated(run, lambda: of_error(error)(run, None)))


def certify_halved(run: Run, halving: Halving | None) -> tuple[Run, Run | None]:
    """Return a run by halved steps with a certificate, from how far whole ones are.

    The other run is the one at a tighter tolerance behind it, if these tell nothing.
    """
    tighter: list[Run] = []
    found = _certified(run, lambda run, _: of_halves(run, halving, tighter))
    return found, tighter[-1] if tighter else None


def certify_by_companion(run: Run) -> Run:
    """Return a run with a certificate as `certify` makes it, but for the equation of its error.

    This bounds the whole path, also where it passes something closely between two samples.
    """
    if not isinstance(run.method, Dop853 | DormandPrince5) or run.method.halved:
        return certify(run)
    return _certified(run, _by_companions, with_horizon=True)


def certify_embedded(run: Run) -> tuple[Run, Run | None]:
    """Return an adaptive run with a certificate, and the one at a tighter tolerance behind it."""
    tighter: list[Run] = []
    found = _certified(run, lambda run, _: embedded(run, tighter))
    return found, tighter[-1] if tighter else None


def certify_tighter(run: Run, looser: Run) -> Run:
    """Return a run with a certificate from a looser one, whose companion it was."""
    return _certified(run, lambda run, _: of_tighter(run, looser), looser=looser)


def certify_as(run: Run, basis: Basis) -> Run:
    """Return a run with a certificate by the computation that another one follows from.

    It is the usual one where the run allows no other.
    """
    method = run.method
    if basis.kind == "quality":
        return certify_quality(run)
    if isinstance(method, Stepped):
        return certify_steps(run, _planned_as(run, basis))
    if not isinstance(method, Dop853 | DormandPrince5):
        return certify(run)
    run = _looked_at(run)
    match basis.kind:
        case "error equation" if has_error_equation(run.scene, method, run.duration):
            return certify_with_error(run, error_beside(run))
        case "halved steps" if method.halved:
            return certify_halved(run, whole_beside(run))[0]
        case "companions":
            return certify_embedded(run)[0]
        case "looser run" if (looser := _looser_run(run, method, basis)) is not None:
            return certify_tighter(run, looser)
    return certify(run)


def _planned_as(run: Run, basis: Basis) -> Refined | None:
    """Return what shorter steps say that were planned, if they were."""
    if basis.kind != "planned steps":
        return None
    times, shortest = run.times, basis.time_step
    return refined_to(run.scene, duration=run.duration, times=times, shortest=shortest)


def _looser_run(run: Run, method: Dop853 | DormandPrince5, basis: Basis) -> Run | None:
    """Return the looser run whose companion a run was, if it can be made again."""
    known = [looser for looser in looser_than(method) if looser.rtol == basis.rtol]
    try:
        return companion_of(run, method=known[0]) if known else None
    except NoBoundError:
        return None


def _certified(
    run: Run, bounder: Bounder, *, with_horizon: bool = False, looser: Run | None = None
) -> Run:
    """Return a run with a certificate; `with_horizon` it tells of one where its bound is large."""
    if not crowded(run) and (fault := next(penetrations(run), None)) is not None:
        return replace(run, certificate=of_penetration(run, fault))
    certificate = _stated(
        run, lambda: _found(run, bounder, looser or run, with_horizon=with_horizon)
    )
    # the paths of many bodies are searched only if something is said of them
    if (
        certificate.bounds_positions
        and crowded(run)
        and (fault := next(penetrations(run), None)) is not None
    ):
        certificate = of_penetration(run, fault)
    return replace(run, certificate=with_rule(certificate, run))


def _stated(run: Run, bound: Callable[[], Bound]) -> Certificate:
    """Return the certificate of a bound of places or, where there is none, of the energy."""
    try:
        return of_positions(run, bound())
    except NoBoundError as reason:
        return of_energy(run, str(reason), reason.lost_at)


def _found(run: Run, bounder: Bounder, loosest: Run, *, with_horizon: bool) -> Bound:
    """Return a bound; none past the horizon.

    Runs that agree although each step of the loosest errs by more than what is perturbed show that
    this does not grow: they need no perturbed run.
    """
    if isinstance(run.method, Legacy2018):
        raise NoBoundError("the scheme of 2018 is inconsistent: no step makes its error small")
    early, fault = None, None
    if getattr(loosest.method, "rtol", 0.0) >= _COARSE:
        try:
            early = bounder(run, None)
        except NoBoundError as reason:
            fault = reason
        if early is not None and (not with_horizon or early.value <= LOST * scale(run)):
            return early
    grown = growth(run)
    if (lost_at := horizon(run, grown)) is not None:
        raise NoBoundError(
            f"a change of {MOVED:g} of the scale grows to {LOST:.0%} of it within the run", lost_at
        )
    if fault is not None:
        raise fault
    return early or bounder(run, grown)


def certify_steps(run: Run, shorter: Refined | None = None) -> Run:
    """Return a run by steps through contacts with a certificate, from runs by shorter steps.

    Without such, eight are made, by steps from its own to a quarter of it.
    """
    if not crowded(run) and (fault := next(penetrations(run), None)) is not None:
        return replace(run, certificate=of_penetration(run, fault))
    lost_at = None
    basis = USUAL if shorter is None else Basis("planned steps", time_step=shorter.time_step)
    try:
        shorter = shorter or shorter_runs(run)
        lost_at = shorter.horizon(LOST)
        found = replace(against_shorter(run, shorter), basis=basis)
        certificate = of_positions(run, found, shorter.whole)
    except NoBoundError as reason:
        certificate = of_energy(run, str(reason), lost_at)
    return replace(run, certificate=certificate)


def _bounder_for(run: Run) -> Bounder:
    method = run.method
    if isinstance(method, ClosedForm):
        return exact
    if method.fixed_step:
        return step_doubling
    if has_error_equation(run.scene, method, run.duration):
        return _by_error_equation
    if isinstance(method, Dop853 | DormandPrince5) and method.halved:
        return lambda run, _: of_halves(run, whole_beside(run), [])
    return _by_companions


def _by_companions(run: Run, _: Array | None) -> Bound:
    return embedded(run, [])


def _by_error_equation(run: Run, grown: Array | None) -> Bound:
    try:
        return of_error(error_beside(run))(run, grown)
    except NoBoundError:
        return embedded(run, [])
