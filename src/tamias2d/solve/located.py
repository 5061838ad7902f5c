"""Runs along smooth paths, whose impacts are located (IM3)."""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from tamias2d.contact import (
    MANY,
    MOST_RULED,
    Located,
    RangeError,
    has_thin_pair,
    is_event_driven,
    thin_bodies,
)
from tamias2d.errors import SimulationError
from tamias2d.event_driven import EventDriven
from tamias2d.kernels import flight, joint_code, march_by_kernels
from tamias2d.motion import ClosedForm, Motion, PathMethod
from tamias2d.motion.fixed_steps import grid
from tamias2d.motion.mechanisms import fitted_history
from tamias2d.motion.track import sample
from tamias2d.run import Impacts, Run
from tamias2d.scene import Scene, in_pieces, owners
from tamias2d.scene.reach import pairs_that_can_meet
from tamias2d.solve.assembly import NO_IMPACTS, run_of, start_of
from tamias2d.solve.following import Interrupted, follow
from tamias2d.solve.plan import Plan
from tamias2d.state import Array, History
from tamias2d.work_limit import Work


def run_by_paths(
    plan: Plan,
    method: PathMethod,
    *,
    progress: bool,
    asked: bool,
    motion: Motion | None = None,
    followed: Callable[[Located], None] = lambda _: None,
) -> Run:
    """Return the run along the paths of a method, from impact to impact.

    Where the method was not asked for, more bodies than `MANY` are followed by compiled code or not
    at all. The motion is made if none is given; `followed` hears of paths along which bodies might
    have met. Raises as `solve` does; the error's `run` is the history up to there.
    """
    scene = in_pieces(plan.scene)
    motion = motion or method.motion(scene, plan.duration, plan.time_step or plan.duration)
    motion.work = Work(plan.duration, plan.work_limit)
    march_by_kernels(motion, scene)
    follower = follower_of(plan.scene, method, plan.times)
    located = Located(
        scene,
        motion,
        motion.work,
        follower,
        alone=asked or not are_many(scene),
        most_ruled=math.inf if asked else MOST_RULED,
    )
    try:
        if not (located.can_meet and _may_meet(plan)):
            found = _without_contact(plan, method, motion)
            events = motion.joint_events()
            history = fitted_history(plan.scene, plan.times, found, events, joint_code)
            return _run(plan, motion, history)
        follow(located, plan.duration, progress=progress)
        followed(located)
    except SimulationError as refusal:
        refusal.run = _finite(plan, motion, located, follower)
        raise
    except KeyboardInterrupt:
        raise Interrupted(lambda: _finite(plan, motion, located, follower)) from None
    return _reached(plan, motion, located, follower)


def _may_meet(plan: Plan) -> bool:
    """Return whether bodies may meet; for a few that is found while they are followed."""
    return not are_many(plan.scene) or bool(pairs_that_can_meet(plan.scene, plan.duration))


def _without_contact(plan: Plan, method: PathMethod, motion: Motion) -> History:
    """Return the history of a scene in which nothing meets: by a kernel, where that pays."""
    if plan.time_step is not None:
        steps = grid(plan.duration, plan.time_step)
        if (history := flight(plan.scene, method, steps, plan.times)) is not None:
            motion.tally.steps = len(steps) - 1
            if method.facts is not None:
                motion.tally.force_evaluations = method.facts.evaluations * (len(steps) - 1)
            return history
    return _of_bodies(motion.history(plan.times), plan.scene)


def _finite(plan: Plan, motion: Motion, located: Located, follower: EventDriven | None) -> Run:
    """Return the run up to the time that was reached, or to the last finite energy before."""
    try:
        return _reached(plan, motion, located, follower)
    except RangeError as beyond:
        before = plan._replace(times=plan.times[plan.times < beyond.time])
        return _reached(before, motion, located, follower)


def follower_of(scene: Scene, method: PathMethod, times: Array | None) -> EventDriven | None:
    """Return what follows the bodies of a scene by compiled code, with samples at times, s.

    None where it does not know them.
    """
    if not (isinstance(method, ClosedForm) and is_event_driven(scene)):
        return None
    many = are_many(scene)
    if has_thin_pair(scene) and not many:
        return None
    return EventDriven(scene, times, many=many)


def are_many(scene: Scene) -> bool:
    """Whether more bodies move than are followed one by one."""
    return sum(body.dynamic and body.shape is not None for body in scene.bodies) > MANY


def _reached(plan: Plan, motion: Motion, located: Located, follower: EventDriven | None) -> Run:
    """Return the run up to the time that was reached."""
    if not all(located.tracks):  # it did not get as far as a first path
        history, times = _sampled(plan, motion)
        return _run(plan._replace(times=times), motion, history)
    times = plan.times[plan.times <= located.time]
    plan = plan._replace(times=times if len(times) else np.zeros(1))
    events = motion.joint_events()
    states = sample if follower is None else follower.history
    found = states(located.tracks[: len(plan.scene)], plan.times)
    history = fitted_history(plan.scene, plan.times, found, events, joint_code)
    impacts = _impacts(located.impacts, owners(in_pieces(plan.scene)))
    notes = located.notes if follower is None else located.notes + _untold_sides(plan.scene)
    run = replace(_run(plan, motion, history, impacts, notes), ruled=located.ruled)
    if (loads := located.contact_loads(plan.times, history)) is None:
        return run
    return replace(run, contact_force=loads[..., :2].copy(), contact_torque=loads[..., 2].copy())


def _run(
    plan: Plan,
    motion: Motion,
    history: History,
    impacts: Impacts = NO_IMPACTS,
    notes: tuple[str, ...] = (),
) -> Run:
    """Return the run of a motion, with its own notes and others."""
    notes = motion.notes + notes
    run = run_of(plan, history, impacts, notes, motion.tally, motion.joint_events())
    return replace(run, unresolved=motion.unresolved)


def _untold_sides(scene: Scene) -> tuple[str, ...]:
    """Return the note that thin bodies may pass through each other where compiled code follows."""
    thin = thin_bodies(scene)
    if len(thin) < 2:
        return ()
    first, second = (scene.bodies[k].name for k in thin[:2])
    return (
        f"thin bodies: {len(thin)}, {first!r} and {second!r} among them: of more than {MANY} "
        "moving bodies it is not remembered from which side two of these have met, and one may "
        "fall through the other. Make them thicker than a fiftieth of their reach.",
    )


def _sampled(plan: Plan, motion: Motion) -> tuple[History, Array]:
    """Return the samples that a motion without contacts has reached, or else the start."""
    count = 0 if motion.sampled is None else len(motion.sampled.position)
    times = plan.times[:count]
    if motion.sampled is None or not len(times):
        return start_of(plan), np.zeros(1)
    found = History(*(part[: len(times)] for part in motion.sampled))
    return _of_bodies(found, plan.scene), times


def _of_bodies(history: History, scene: Scene) -> History:
    """Return the history of the bodies of a scene, without that of pieces of chains."""
    return History(*(part[:, : len(scene)] for part in history))


def _impacts(rows: Array, owner: list[int]) -> Impacts:
    """Return impacts from their rows (m, 9), as `Located.impacts` has them.

    `owner` tells of each body there to which one of the scene it belongs.
    """
    return Impacts(
        time=rows[:, 0].copy(),
        bodies=np.array(owner)[rows[:, 1:3].astype(np.int64)],
        point=rows[:, 3:5].copy(),
        normal=rows[:, 5:7].copy(),
        impulse=rows[:, 7].copy(),
        normal_velocity=rows[:, 8].copy(),
    )
