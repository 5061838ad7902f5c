"""From a scene to its run: choose the way, go it, and say which it was (R5, R6, R8).

Serves: `tamias2d.simulate`, the one door to a run. Hides: which way is taken, and how its parts
are put together.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from typing import Protocol

import numpy as np

from tamias2d.balance import balance
from tamias2d.contact import (
    MEANT_TO_TOUCH,
    Hit,
    LastingContactError,
    Located,
    OverlapError,
    RangeError,
    Refusal,
    SimultaneousImpactsError,
    UndecidedContactError,
    refuse_contact,
)
from tamias2d.cost import Cost
from tamias2d.errors import InputError, SimulationError
from tamias2d.motion import Legacy2018, Method, Motion, Stepped, Tally
from tamias2d.motion.legacy import legacy_history
from tamias2d.motion.loads import Loads, coordinates, start_states
from tamias2d.motion.reference import NoStepError
from tamias2d.motion.stepped import grid
from tamias2d.motion.track import sample
from tamias2d.plan import Plan, planned
from tamias2d.run import Impacts, Run
from tamias2d.scene import Scene
from tamias2d.simulator import Overlap, Stepper
from tamias2d.state import Array, History
from tamias2d.suggestions import suggests

_UNDECIDED = (SimultaneousImpactsError, LastingContactError, UndecidedContactError)


class Interrupted(KeyboardInterrupt):
    """The user stopped a run; `run` is what there was of it."""

    def __init__(self, run: Run) -> None:
        super().__init__(f"Run of {run.duration:g} s: interrupted at {run.times[-1]:.6g} s.")
        self.run = run


@suggests
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
    the reference otherwise; but contacts are stepped (`Stepped`, R12) where more than a hundred
    moving bodies can meet, where a body is kinematic, a sensor or a compound, where bodies are so
    near at the start that they are meant to touch, and from the start where impacts, located, came
    to what rigid bodies leave open. The first of the run's `notes` says which way it was, and why.

    `times` are those of the samples, s, sorted and within the run; without them it is 60 a second,
    or every step (`time_step`, s) of a stepped method. Between steps through contacts states are
    interpolated. `progress` shows a bar on standard error.

    With a `tolerance` method and step are those that meet it at the least cost, found by pilot
    runs, and the run has a certificate (`recommend` says what is bounded).

    Raises:
        InputError: an argument breaks a rule, or the history would take more than 1 GiB.
        SceneError: bodies overlap at the start, or a pair that meets has no restitution.
        SimulationError: by the method that was asked for the answer is not unique, or not within
            the models; the message says when, and the error's `run` is the history up to there.
        ToleranceError: no method meets the tolerance; it says what can be met.
        RangeError: a number of the run, or its energy or momentum, is beyond float64.
        StabilityError: the method is unstable at the time step; told before it runs.
        StepSizeError: no step that float64 can take meets an adaptive method's tolerance.
        Interrupted: the user stopped it; likewise with its `run`.
    """
    plan = planned(scene, duration, method, time_step, times)
    if tolerance is not None:
        return _within(plan, tolerance, chosen=method, progress=progress)
    with _within_range(plan.duration):
        try:
            return _run(plan, progress)
        except _UNDECIDED as refusal:
            if method is not None:
                raise
            reason = f"impacts could be located up to {refusal.time:.6g} s. {refusal}"
        except OverlapError as refusal:
            if method is not None or refusal.share > MEANT_TO_TOUCH:
                raise
            reason = (
                f"bodies touch at the start; {refusal.bodies} overlap by {refusal.depth:.2g} m, "
                "as rounding does it"
            )
        return _run(plan.by_steps(reason), progress)


def sampler(run: Run) -> Callable[[Array, Sequence[int]], History]:
    """Return what tells the states of some bodies at sorted times (k,), s.

    The run is simulated once more. Where it is stepped, the states change linearly between the ends of steps.
    """
    plan = planned(run.scene, run.duration, run.method, run.time_step, None)
    if isinstance(run.method, Stepped | Legacy2018):
        steps = _run(plan, progress=False)
        return lambda times, bodies: _interpolated(steps, times, bodies)
    motion = plan.method.motion(run.scene, run.duration, run.time_step or run.duration)
    located = Located(run.scene, motion)
    with np.errstate(all="ignore"), suppress(Refusal, NoStepError):  # as far as the run went
        located.go(run.duration)
    return lambda times, bodies: sample([located.tracks[k] for k in bodies], times)


def _interpolated(run: Run, times: Array, bodies: Sequence[int]) -> History:
    """Return states that change linearly between the samples of a run."""
    after = np.clip(np.searchsorted(run.times, times, side="right"), 1, len(run.times) - 1)
    before = after - 1
    share = (times - run.times[before]) / (run.times[after] - run.times[before])
    known = (run.position, run.orientation, run.velocity, run.angular_velocity)
    rows = (
        part[before] + share.reshape(-1, *[1] * (part.ndim - 1)) * (part[after] - part[before])
        for part in (whole[:, list(bodies)] for whole in known)
    )
    return History(*rows)


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


def _run(plan: Plan, progress: bool) -> Run:
    scene = plan.scene
    _refuse_singular(scene)
    _refuse_beyond(np.zeros(1), *balance(scene, _start(scene)))
    if isinstance(plan.method, Legacy2018):
        return _legacy(plan)
    if isinstance(plan.method, Stepped):
        return _stepped(plan, plan.method, progress)
    motion = plan.method.motion(scene, plan.duration, plan.time_step or plan.duration)
    located = Located(scene, motion)
    if not located.can_meet:
        history = _unhindered(plan, motion)
        return _finished(plan, history, _impacts([]), motion.notes, motion.tally)
    try:
        _go(located, plan, progress)
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


def _within(plan: Plan, tolerance: float, *, chosen: Method | None, progress: bool) -> Run:
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


def _unhindered(plan: Plan, motion: Motion) -> History:
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


def _legacy(plan: Plan) -> Run:
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


def _stepped(plan: Plan, method: Stepped, progress: bool) -> Run:
    """Follow a scene step by step through its contacts (R12)."""
    stepper = Stepper(
        plan.scene,
        time_step=plan.time_step or plan.duration,
        substeps=method.substeps,
        times=plan.times,
    )
    try:
        _go(stepper, plan, progress)
    except InputError:  # what was given was sound
        reached = stepper.time
        raise RangeError(_beyond(f"run at {reached!r} s: a number"), time=reached) from None
    except SimulationError as fault:
        fault.run = _told(plan, stepper)  # type: ignore[attr-defined]
        raise
    except KeyboardInterrupt:
        raise Interrupted(_told(plan, stepper)) from None
    return _told(plan, stepper)


def _told(plan: Plan, stepper: Stepper) -> Run:
    """Return the run up to the step that was reached, with what is known of its error."""
    history = stepper.history()
    plan = plan._replace(times=plan.times[: len(history.position)])
    tally = Tally(steps=stepper.steps, force_evaluations=stepper.steps)
    run = _finished(plan, history, _begun(stepper), (), tally)
    names = [body.name for body in plan.scene.bodies]
    notes = (
        f"contacts: told at the ends of steps; {stepper.contacts} points pushed, over all steps",
        _overlap(stepper.deepest, names),
        f"energy: {run.energy[0]:.6g} J at first, {run.energy[-1]:.6g} J at last, "
        f"never more than {run.energy.max():.6g} J",
        "error: not bounded; `certify` finds how much shorter steps change",
    )
    cost = replace(_cost(run.impacts, tally), contacts=stepper.contacts)
    return replace(run, notes=run.notes + notes, cost=cost)


def _overlap(deepest: Overlap | None, names: Sequence[str]) -> str:
    if deepest is None:
        return "overlap: none"
    a, b = (names[k] for k in deepest.bodies)
    return (
        f"overlap: at most {deepest.share:.2g} of the size of the smaller body, "
        f"{deepest.depth:.2g} m of '{a}' and '{b}' at {deepest.time:.4g} s"
    )


def _begun(stepper: Stepper) -> Impacts:
    """Return the pairs that began to touch, as they are told of each step."""
    met = [one.contacts for one in stepper.met]
    return Impacts(
        time=np.repeat([one.time for one in stepper.met], [len(one) for one in met]),
        bodies=np.concatenate([np.zeros((0, 2), np.int64), *(one.bodies for one in met)]),
        point=np.concatenate([np.zeros((0, 2)), *(one.point for one in met)]),
        normal=np.concatenate([np.zeros((0, 2)), *(one.normal for one in met)]),
        impulse=np.concatenate([np.zeros(0), *(one.impulse for one in met)]),
        normal_velocity=np.concatenate(
            [np.zeros(0), *(one.normal_velocity for one in stepper.met)]
        ),
    )


class _Followed(Protocol):
    """What goes on to a time in s, and tells of each that it reaches."""

    def go(self, duration: float, *, told: Callable[[float], None] = ...) -> None: ...


def _go(way: _Followed, plan: Plan, progress: bool) -> None:
    if not progress:
        way.go(plan.duration)
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("simulating", total=plan.duration)
        way.go(plan.duration, told=lambda time: bar.update(task, completed=time))


def _collected(plan: Plan, motion: Motion, located: Located) -> Run:
    """Return the run up to the time that was reached."""
    reached = plan.times[plan.times <= located.time]
    plan = plan._replace(times=reached if len(reached) else plan.times[:1])
    if not all(located.tracks):  # it did not get as far as a first path
        plan = plan._replace(times=np.zeros(1))
        return _finished(plan, _start(plan.scene), _impacts([]), motion.notes, motion.tally)
    history, impacts = sample(located.tracks, plan.times), _impacts(located.hits)
    return _finished(plan, history, impacts, motion.notes + located.notes, motion.tally)


def _finished(
    plan: Plan, history: History, impacts: Impacts, notes: tuple[str, ...], tally: Tally
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
