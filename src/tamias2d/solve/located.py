"""Runs along smooth paths, whose impacts are located (IM3)."""

from collections.abc import Sequence

import numpy as np

from tamias2d.contact import ContactImpulse, Located
from tamias2d.errors import SimulationError
from tamias2d.kernels import flight
from tamias2d.motion import Motion, PathMethod
from tamias2d.motion.fixed_steps import grid
from tamias2d.motion.track import sample
from tamias2d.run import Impacts, Run
from tamias2d.solve.assembly import NO_IMPACTS, run_of, start_of
from tamias2d.solve.following import Interrupted, follow
from tamias2d.solve.plan import Plan
from tamias2d.state import History
from tamias2d.work_limit import Work


def run_by_paths(plan: Plan, method: PathMethod, *, progress: bool) -> Run:
    """Return the run along the paths of a method, from impact to impact.

    Raises as `solve` does; the error's `run` is the history up to there.
    """
    motion = method.motion(plan.scene, plan.duration, plan.time_step or plan.duration)
    motion.work = Work(plan.duration, plan.work_limit)
    located = Located(plan.scene, motion, motion.work)
    try:
        if not located.can_meet:
            history = _without_contact(plan, method, motion)
            return run_of(plan, history, NO_IMPACTS, motion.notes, motion.tally)
        follow(located, plan.duration, progress=progress)
    except SimulationError as refusal:
        refusal.run = _reached(plan, motion, located)
        raise
    except KeyboardInterrupt:
        raise Interrupted(_reached(plan, motion, located)) from None
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


def _reached(plan: Plan, motion: Motion, located: Located) -> Run:
    """Return the run up to the time that was reached."""
    if not all(located.tracks):  # it did not get as far as a first path
        history = motion.sampled or start_of(plan)
        times = plan.times[: len(history.position)] if motion.sampled else np.zeros(1)
        plan = plan._replace(times=times)
        return run_of(plan, history, NO_IMPACTS, motion.notes, motion.tally)
    times = plan.times[plan.times <= located.time]
    plan = plan._replace(times=times if len(times) else plan.times[:1])
    history, impacts = sample(located.tracks, plan.times), _impacts(located.contact_impulses)
    return run_of(plan, history, impacts, motion.notes + located.notes, motion.tally)


def _impacts(contact_impulses: Sequence[tuple[float, ContactImpulse]]) -> Impacts:
    contacts = [hit.contact for _, hit in contact_impulses]
    return Impacts(
        time=np.array([time for time, _ in contact_impulses], dtype=np.float64),
        bodies=np.array([(c.a, c.b) for c in contacts], dtype=np.int64).reshape(-1, 2),
        point=np.array([c.point for c in contacts], dtype=np.float64).reshape(-1, 2),
        normal=np.array([c.normal for c in contacts], dtype=np.float64).reshape(-1, 2),
        impulse=np.array([hit.impulse for _, hit in contact_impulses], dtype=np.float64),
        normal_velocity=np.array(
            [hit.normal_velocity for _, hit in contact_impulses], dtype=np.float64
        ),
    )
