"""From a scene to its run: choose the way, go it, and say which it was (R5, R6, R8).

Serves: `tamias2d.simulate`, the one door to a run. Hides: which way is taken, and how its parts
are put together.
"""

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import NamedTuple

import numpy as np

from tamias2d.balance import balance
from tamias2d.contact import Hit, Located, RangeError, Refusal, refuse_contact
from tamias2d.cost import Cost
from tamias2d.errors import InputError
from tamias2d.motion import ClosedForm, Legacy2018, Method, Motion, Reference, Tally
from tamias2d.motion.legacy import legacy_history
from tamias2d.motion.loads import Loads, coordinates, start_states
from tamias2d.motion.reference import NoStepError
from tamias2d.motion.stepped import grid
from tamias2d.motion.track import sample
from tamias2d.run import Impacts, Run
from tamias2d.scene import Scene
from tamias2d.scene.acting import varying_loads
from tamias2d.scene.exact import closed_forms
from tamias2d.scene.rules import number, sequence
from tamias2d.state import Array, History

_FRAMES = 60  # samples in a second, where nothing else is asked
_MOST = 2**30  # bytes that a history, or the times of all steps, may take


class Interrupted(KeyboardInterrupt):
    """The user stopped a run; `run` is what there was of it."""

    def __init__(self, run: Run) -> None:
        super().__init__(f"Run of {run.duration:g} s: interrupted at {run.times[-1]:.6g} s.")
        self.run = run


class _Plan(NamedTuple):
    scene: Scene
    method: Method
    duration: float
    time_step: float | None
    times: Array
    notes: tuple[str, ...]


def simulate(
    scene: Scene,
    *,
    duration: float,
    method: Method | None = None,
    time_step: float | None = None,
    times: Iterable[float] | None = None,
    tolerance: float | None = None,
    progress: bool = False,
) -> Run:
    """Simulate a scene for a duration in s, and return its history.

    Impacts are located: the path of the method is followed to the instant at which a pair meets,
    and IM3 says how it parts. Without a `method` it is the closed form if all bodies have one, and
    the reference otherwise. `times` are those of the samples, s, sorted and
    within the run; without them it is 60 a second, or every step (`time_step`, s) of a stepped
    method. `progress` shows a bar on standard error.

    With a `tolerance` method and step are those that meet it at the least cost, found by pilot
    runs, and the run has a certificate (`recommend` says what is bounded).

    Raises:
        InputError: an argument breaks a rule, or the history would take more than 1 GiB.
        SceneError: bodies overlap at the start, or a pair that meets has no restitution.
        SimulationError: the answer is not unique, or not within the models; the message says
            when, and the error's `run` is the history up to there.
        ToleranceError: no method meets the tolerance; it says what can be met.
        RangeError: a number of the run, or its energy or momentum, is beyond float64.
        StabilityError: the method is unstable at the time step; told before it runs.
        StepSizeError: no step that float64 can take meets an adaptive method's tolerance.
        Interrupted: the user stopped it; likewise with its `run`.
    """
    plan = _plan(scene, duration, method, time_step, times)
    if tolerance is not None:
        return _within(plan, tolerance, chosen=method, progress=progress)
    with _within_range(plan.duration):
        return _run(plan, progress)


@contextmanager
def _within_range(duration: float) -> Iterator[None]:
    """Turn what float64 cannot hold into a refusal, without warnings before it."""
    with np.errstate(all="ignore"):
        try:
            yield
        except OverflowError:
            raise RangeError(_beyond(f"run of {duration!r} s: a number"), time=0.0) from None


def _beyond(what: str) -> str:
    return (
        f"{what} is beyond what float64 holds, about 1e308 (R4). Give smaller values, or a "
        "shorter duration."
    )


def _run(plan: _Plan, progress: bool) -> Run:
    scene = plan.scene
    _refuse_singular(scene)
    _refuse_beyond(np.zeros(1), *balance(scene, _start(scene)))
    if isinstance(plan.method, Legacy2018):
        return _legacy(plan)
    motion = plan.method.motion(scene, plan.duration, plan.time_step or plan.duration)
    located = Located(scene, motion)
    if not located.can_meet:
        history = _unhindered(plan, motion)
        return _finished(plan, history, _impacts([]), motion.notes, motion.tally)
    try:
        _go(located, plan.duration, progress)
    except (Refusal, NoStepError) as refusal:
        refusal.run = _collected(plan, motion, located)
        raise
    except KeyboardInterrupt:
        raise Interrupted(_collected(plan, motion, located)) from None
    return _collected(plan, motion, located)


def _start(scene: Scene) -> History:
    return History(
        np.array([[body.position for body in scene.bodies]]).reshape(1, -1, 2),
        np.array([[body.orientation for body in scene.bodies]]),
        np.array([[body.velocity for body in scene.bodies]]).reshape(1, -1, 2),
        np.array([[body.angular_velocity for body in scene.bodies]]),
    )


def _refuse_singular(scene: Scene) -> None:
    """Raise an error that names the force, where one has no finite value at the start."""
    moving = [i for i, body in enumerate(scene.bodies) if body.dynamic]
    start = start_states(scene)
    states = [start[i] for i in moving]
    Loads(scene).field(moving, [None] * len(moving))(0.0, *coordinates(states))


def _refuse_beyond(times: Array, *found: Array) -> None:
    """Raise `RangeError` at the first time whose energy or momenta are not finite."""
    names = ("energy", "momentum", "angular momentum")
    for name, values in zip(names, found, strict=True):
        bad = ~np.isfinite(values.reshape(len(times), -1)).all(axis=1)
        if bad.any():
            time = float(times[np.argmax(bad)])
            raise RangeError(_beyond(f"run at {time!r} s: its {name}"), time=time)


def _within(plan: _Plan, tolerance: float, *, chosen: Method | None, progress: bool) -> Run:
    if chosen is not None:
        raise InputError(
            f"tolerance {tolerance!r}: found method {chosen} beside it: the method follows from "
            "the tolerance (R5). Give one of the two."
        )
    from tamias2d.study.tolerance import within

    return within(
        plan.scene,
        duration=plan.duration,
        tolerance=tolerance,
        times=plan.times,
        progress=progress,
    )


def _unhindered(plan: _Plan, motion: Motion) -> History:
    """Return the history of a scene in which nothing meets: by a kernel, where that pays."""
    if plan.time_step is not None:
        from tamias2d.kernels import flight

        steps = grid(plan.duration, plan.time_step)
        if (history := flight(plan.scene, plan.method, steps, plan.times)) is not None:
            motion.tally.steps = len(steps) - 1
            if plan.method.facts is not None:
                motion.tally.force_evaluations = plan.method.facts.evaluations * (len(steps) - 1)
            return history
    return motion.history(plan.times)


def _plan(
    scene: Scene,
    duration: float,
    method: Method | None,
    time_step: float | None,
    times: Iterable[float] | None,
) -> _Plan:
    duration = number(duration, "duration", "the run", "Give it in s.", at=("duration",))
    chosen, note = _method(scene, method)
    if chosen.stepped != (time_step is not None):
        need = "needs" if chosen.stepped else "chooses its own steps and takes no"
        remedy = "Give time_step in s." if chosen.stepped else "Leave time_step out."
        raise InputError(f"time_step {time_step!r}: {chosen} {need} time step (R5). {remedy}")
    if time_step is not None:
        time_step = number(time_step, "time_step", "the run", "Give it in s.", at=("time_step",))
    _refuse_endless(scene, duration, time_step, kept=times is None)
    steps = grid(duration, time_step or 1 / _FRAMES) if times is None else _samples(times, duration)
    return _Plan(scene, chosen, duration, time_step, steps, (note,))


def _refuse_endless(scene: Scene, duration: float, time_step: float | None, *, kept: bool) -> None:
    """Refuse more steps or samples than memory should be asked for."""
    if time_step is None and not kept:
        return
    count = duration / time_step if time_step else duration * _FRAMES
    size = count * 8 * (6 * len(scene.bodies) + 5 if kept else 1)
    if size <= _MOST:
        return
    what = f"time_step {time_step!r} s" if time_step else f"duration {duration!r} s"
    makes = "steps" if time_step else f"samples, {_FRAMES} a second"
    remedy = (
        "a larger time_step, `times` of the samples"
        if time_step and kept
        else ("a larger time_step" if time_step else "`times` of the samples")
    )
    raise InputError(
        f"{what} of the run: found {count:.3g} {makes}, which take {size / 2**30:.3g} GiB: must "
        f"take at most {_MOST / 2**30:g} GiB (R5). Give {remedy}, or a shorter duration."
    )


def _method(scene: Scene, method: Method | None) -> tuple[Method, str]:
    if method is None:
        solved = closed_forms(scene)
        for body, why in varying_loads(scene).items():
            if body not in solved:
                return Reference(), f"Reference(): '{scene.bodies[body].name}' is {why}"
        forms = dict.fromkeys(solved.values())
        if list(forms) == ["constant loads"] or not forms:
            return ClosedForm(), "ClosedForm(): every force and torque is constant"
        return ClosedForm(), f"ClosedForm(): every body has one, {', '.join(forms)}"
    if not isinstance(method, Method):
        raise InputError(
            f"method {method!r}: must be a method of motion (R5). Give one such as ClosedForm() "
            "or VelocityVerlet(), with its brackets."
        )
    return method, f"{method}: as asked"


def _samples(times: Iterable[float], duration: float) -> Array:
    remedy = "Give sorted times in s, from 0 to the duration."
    values = sequence(times, "the run", remedy, at=("times",))
    steps = [
        number(value, "time", "the run", remedy, at=("times", k)) for k, value in enumerate(values)
    ]
    if not steps:
        raise InputError(f"times of the run: found none: must be one or more (R5). {remedy}")
    for k, (before, after) in enumerate(zip(steps, [*steps[1:], duration], strict=True)):
        if after < before:
            raise InputError(
                f"times[{k}] {before!r} s of the run: {after!r} s follows: must be sorted, and "
                f"within the duration of {duration!r} s (R5). {remedy}"
            )
    return np.array(steps)


def _legacy(plan: _Plan) -> Run:
    times, history = legacy_history(plan.scene, plan.duration, plan.time_step or plan.duration)
    if not np.array_equal(times, plan.times):
        raise InputError(
            f"times of the run: found {len(plan.times)} of them beside {plan.method}: it knows its "
            "states at the ends of its steps only (R5). Leave times out."
        )
    _refuse_beyond(times, *balance(plan.scene, history))
    refuse_contact(plan.scene, times, history)
    taken = len(times) - 1
    tally = Tally(steps=taken, force_evaluations=taken)
    return _finished(plan._replace(times=times), history, _impacts([]), (), tally)


def _go(located: Located, duration: float, progress: bool) -> None:
    if not progress:
        located.go(duration)
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("simulating", total=duration)
        located.go(duration, told=lambda time: bar.update(task, completed=time))


def _collected(plan: _Plan, motion: Motion, located: Located) -> Run:
    """Return the run up to the time that was reached."""
    reached = plan.times[plan.times <= located.time]
    plan = plan._replace(times=reached if len(reached) else plan.times[:1])
    if not all(located.tracks):  # it did not get as far as a first path
        plan = plan._replace(times=np.zeros(1))
        return _finished(plan, _start(plan.scene), _impacts([]), motion.notes, motion.tally)
    history, impacts = sample(located.tracks, plan.times), _impacts(located.hits)
    return _finished(plan, history, impacts, motion.notes + located.notes, motion.tally)


def _finished(
    plan: _Plan, history: History, impacts: Impacts, notes: tuple[str, ...], tally: Tally
) -> Run:
    energy, momentum, angular_momentum = balance(plan.scene, history)
    _refuse_beyond(plan.times, energy, momentum, angular_momentum)
    return Run(
        scene=plan.scene,
        method=plan.method,
        duration=plan.duration,
        time_step=plan.time_step,
        times=plan.times,
        **history._asdict(),
        impacts=impacts,
        energy=energy,
        momentum=momentum,
        angular_momentum=angular_momentum,
        notes=plan.notes + notes,
        cost=_cost(impacts, tally),
    )


def _cost(impacts: Impacts, tally: Tally) -> Cost:
    met = zip(impacts.time.tolist(), *impacts.bodies.T.tolist(), strict=True)
    return Cost(**vars(tally), impacts=len(set(met)))


def _impacts(hits: Sequence[tuple[float, Hit]]) -> Impacts:
    contacts = [hit.contact for _, hit in hits]
    return Impacts(
        time=np.array([time for time, _ in hits], dtype=np.float64),
        bodies=np.array([(c.a, c.b) for c in contacts], dtype=np.int64).reshape(-1, 2),
        point=np.array([c.point for c in contacts], dtype=np.float64).reshape(-1, 2),
        normal=np.array([c.normal for c in contacts], dtype=np.float64).reshape(-1, 2),
        impulse=np.array([hit.impulse for _, hit in hits], dtype=np.float64),
        normal_velocity=np.array([hit.normal_velocity for _, hit in hits], dtype=np.float64),
    )
