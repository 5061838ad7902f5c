"""Runs along smooth paths, whose impacts are located (IM3)."""

from collections.abc import Sequence

import numpy as np

from tamias2d.contact import ContactImpulse, Located, RangeError
from tamias2d.errors import SimulationError
from tamias2d.kernels import flight, march_by_kernels
from tamias2d.motion import Motion, PathMethod
from tamias2d.motion.fixed_steps import grid
from tamias2d.motion.mechanisms import fitted_history
from tamias2d.motion.track import sample
from tamias2d.run import Impacts, Run
from tamias2d.solve.assembly import NO_IMPACTS, run_of, start_of
from tamias2d.solve.following import Interrupted, follow
from tamias2d.solve.plan import Plan
from tamias2d.state import Array, History
from tamias2d.work_limit import Work


def run_by_paths(plan: Plan, method: PathMethod, *, progress: bool) -> Run:
    """Return the run along the paths of a method, from impact to impact.

    Raises as `solve` does; the error's `run` is the history up to there.
    """
    motion = method.motion(plan.scene, plan.duration, plan.time_step or plan.duration)
    motion.work = Work(plan.duration, plan.work_limit)
    march_by_kernels(motion, plan.scene)
    located = Located(plan.scene, motion, motion.work)
    try:
        if not located.can_meet:
            found = _without_contact(plan, method, motion)
            events = motion.joint_events()
            history = fitted_history(plan.scene, plan.times, found, events)
            return run_of(plan, history, NO_IMPACTS, motion.notes, motion.tally, events)
        follow(located, plan.duration, progress=progress)
    except SimulationError as refusal:
        refusal.run = _finite(plan, motion, located)
        raise
    except KeyboardInterrupt:
        raise Interrupted(_finite(plan, motion, located)) from None
    return _reached(plan, motion, located)


def _without_contact(plan: Plan, method: PathMethod, motion: Motion) -> History:
    """Return the history of a scene in which nothing meets: by a kernel, where that pays."""
    if plan.time_step is not None:
        steps = grid(plan.duration, plan.time_step)
        if (history := flight(plan.scene, method, steps, plan.times)) is not None:
            motion.tally.steps = len(steps) - 1
            if method.facts is not None:
                motion.tally.force_evaluations = method.facts.evaluations * (len(steps) - 1)
            return history
    return motion.history(plan.times)


def _finite(plan: Plan, motion: Motion, located: Located) -> Run:
    """Return the run up to the time that was reached, or to the last finite energy before."""
    try:
        return _reached(plan, motion, located)
    except RangeError as beyond:
        return _reached(plan._replace(times=plan.times[plan.times < beyond.time]), motion, located)


def _reached(plan: Plan, motion: Motion, located: Located) -> Run:
    """Return the run up to the time that was reached."""
    if not all(located.tracks):  # it did not get as far as a first path
        history, times = _sampled(plan, motion)
        plan = plan._replace(times=times)
        events = motion.joint_events()
        return run_of(plan, history, NO_IMPACTS, motion.notes, motion.tally, events)
    times = plan.times[plan.times <= located.time]
    plan = plan._replace(times=times if len(times) else np.zeros(1))
    events = motion.joint_events()
    history = fitted_history(plan.scene, plan.times, sample(located.tracks, plan.times), events)
    impacts = _impacts(located.contact_impulses)
    return run_of(plan, history, impacts, motion.notes + located.notes, motion.tally, events)


def _sampled(plan: Plan, motion: Motion) -> tuple[History, Array]:
    """Return the samples that a motion without contacts has reached, or else the start."""
    count = 0 if motion.sampled is None else len(motion.sampled.position)
    times = plan.times[:count]
    if motion.sampled is None or not len(times):
        return start_of(plan), np.zeros(1)
    return History(*(part[: len(times)] for part in motion.sampled)), times


def _impacts(contact_impulses: Sequence[tuple[float, ContactImpulse]]) -> Impacts:
    contacts = [each.contact for _, each in contact_impulses]
    return Impacts(
        time=np.array([time for time, _ in contact_impulses], dtype=np.float64),
        bodies=np.array([(c.a, c.b) for c in contacts], dtype=np.int64).reshape(-1, 2),
        point=np.array([c.point for c in contacts], dtype=np.float64).reshape(-1, 2),
        normal=np.array([c.normal for c in contacts], dtype=np.float64).reshape(-1, 2),
        impulse=np.array([each.impulse for _, each in contact_impulses], dtype=np.float64),
        normal_velocity=np.array(
            [each.normal_velocity for _, each in contact_impulses], dtype=np.float64
        ),
    )
