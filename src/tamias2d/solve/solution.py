"""A scene solved by one method; contacts are stepped where locating them decides nothing."""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from tamias2d.balance import balance
from tamias2d.contact import (
    MEANT_TO_TOUCH,
    FrictionError,
    JointedContactError,
    LastingContactError,
    Located,
    OverlapError,
    UndecidedContactError,
)
from tamias2d.motion import (
    Dop853,
    DormandPrince5,
    Legacy2018,
    LimitHeldError,
    Method,
    PathMethod,
    Stepped,
)
from tamias2d.motion.error_equation import Watch
from tamias2d.motion.halved import Halving
from tamias2d.motion.integrated import IntegratedMotion
from tamias2d.motion.loads import Loads, coordinates, start_states
from tamias2d.run import Run
from tamias2d.scene import Scene, in_pieces
from tamias2d.scene.reach import pairs_that_can_meet
from tamias2d.solve.assembly import start_of
from tamias2d.solve.error_through_impacts import error_through_impacts
from tamias2d.solve.finite import refuse_infinite, within_range
from tamias2d.solve.following import interruptible
from tamias2d.solve.legacy import run_by_legacy
from tamias2d.solve.located import are_many, run_by_paths
from tamias2d.solve.plan import Plan, planned
from tamias2d.solve.stepped import run_by_steps
from tamias2d.state import Array
from tamias2d.work_limit import WORK_LIMIT, WorkLimitError

_UNDECIDED = (
    LastingContactError,
    JointedContactError,
    UndecidedContactError,
    FrictionError,
    LimitHeldError,
)


def solve(
    scene: Scene,
    *,
    duration: float,
    method: Method | None = None,
    time_step: float | None = None,
    times: Iterable[float] | None = None,
    progress: bool = False,
    work_limit: int = WORK_LIMIT,
) -> Run:
    """Return the history of a scene: `tamias2d.simulate` without a tolerance.

    Arguments and errors are those of `simulate`, except `ToleranceError`.
    """
    plan = planned(scene, duration, method, time_step, times, work_limit)
    with within_range(plan.duration), interruptible(plan):
        try:
            return _run(plan, progress, asked=method is not None)
        except _UNDECIDED as refusal:
            if method is not None:
                raise
            when = f"{refusal.time:.6g} s"
            why = str(refusal).replace(f"{refusal.time!r} s", when)  # a note is read by people
            reason = f"impacts could be located up to {when}. {why}"
        except OverlapError as refusal:
            if method is not None or scene.joints or refusal.share > MEANT_TO_TOUCH:
                raise
            reason = (
                f"bodies touch at the start; {refusal.bodies} overlap by {refusal.depth:.2g} m, "
                "as rounding does it"
            )
        except WorkLimitError as spent:
            if method is not None or not are_many(scene):
                raise
            reason = f"locating the impacts would be too much work. {spent}"
        return _run(plan.by_steps(reason), progress, asked=False)


def solve_halved(
    scene: Scene,
    *,
    duration: float,
    method: Dop853 | DormandPrince5,
    times: Iterable[float] | None = None,
    progress: bool = False,
    work_limit: int = WORK_LIMIT,
) -> tuple[Run, Halving | None]:
    """Return the history of a scene by halved steps, and how far whole ones are from it.

    That is None where impacts or joints hide it. Arguments and errors are those of `solve`.
    """
    method = replace(method, halved=True)
    plan = planned(scene, duration, method, None, times, work_limit)
    motion = method.motion(in_pieces(scene), plan.duration, plan.duration)
    with within_range(plan.duration):
        _check(plan)
        run = run_by_paths(plan, method, progress=progress, asked=True, motion=motion)
    halving = motion.halving if isinstance(motion, IntegratedMotion) else None
    return run, None if len(run.impacts) else halving


class StoppedError(Exception):
    """Whoever watched a run has seen enough."""

    force_evaluations = 0
    """Up to there"""


def solve_with_error(
    scene: Scene,
    *,
    duration: float,
    method: Dop853 | DormandPrince5,
    times: Iterable[float] | None = None,
    progress: bool = False,
    work_limit: int = WORK_LIMIT,
    watch: Watch = lambda time, error, extent: None,  # noqa: ARG005
) -> tuple[Run, Array | None]:
    """Return the history of a scene, and the largest error (n, 3) of coordinates, m and rad.

    It is that of their path at any time, by the equation of the error, carried through impacts;
    None where that says nothing. No joint of the scene may switch. Arguments and errors are as of
    `solve`; where nothing can meet also those that `watch` raises, with what they have cost:
    `StoppedError`.
    """
    plan = planned(scene, duration, method, None, times, work_limit)
    motion = method.motion(in_pieces(scene), plan.duration, plan.duration)
    assert isinstance(motion, IntegratedMotion)
    carried: list[Array | None] = []
    meet = bool(pairs_that_can_meet(scene, plan.duration))
    if not meet:
        motion.integrate_error(watch)

    def followed(located: Located) -> None:
        if meet:
            carried.append(error_through_impacts(located, motion, plan.duration))

    try:
        with within_range(plan.duration):
            _check(plan)
            run = run_by_paths(
                plan, method, progress=progress, asked=True, motion=motion, followed=followed
            )
    except StoppedError as stopped:
        stopped.force_evaluations = motion.tally.force_evaluations
        raise
    error = carried[0] if carried else motion.largest_error
    return run, None if error is None else error[: len(scene)]


def _run(plan: Plan, progress: bool, *, asked: bool) -> Run:
    _check(plan)
    match plan.method:
        case PathMethod() as method:
            return run_by_paths(plan, method, progress=progress, asked=asked)
        case Stepped() as method:
            return run_by_steps(plan, method, progress=progress)
        case Legacy2018() as method:
            return run_by_legacy(plan, method)


def _check(plan: Plan) -> None:
    """Raise an error where the start is not finite."""
    _refuse_singular(plan.scene, reactions=not isinstance(plan.method, Stepped))
    refuse_infinite(np.zeros(1), *balance(plan.scene, start_of(plan)))


def _refuse_singular(scene: Scene, *, reactions: bool) -> None:
    """Raise an error that names the force, where one has no finite value at the start.

    Steps find the reactions of joints in their own way, so that these need not be solved for.
    """
    moving = [i for i, body in enumerate(scene.bodies) if body.dynamic]
    start = start_states(scene)
    states = [start[i] for i in moving]
    loads = Loads(scene)
    field = loads.field(moving, [None] * len(moving)) if reactions else loads.free_field(moving)
    field(0.0, *coordinates(states))
