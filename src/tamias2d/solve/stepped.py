"""Runs step by step through their contacts (R12)."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tamias2d.contact import RangeError
from tamias2d.errors import SimulationError
from tamias2d.motion import JointEvents, Stepped, Tally, joint_events
from tamias2d.motion.joint_events import JointEvent
from tamias2d.run import Impacts, Run
from tamias2d.scene import Scene
from tamias2d.scene.rules import RuleError
from tamias2d.simulator import NoValueError, Overlap, Stepper
from tamias2d.solve.assembly import cost_of, run_of, start_of
from tamias2d.solve.finite import range_error
from tamias2d.solve.following import Interrupted, follow
from tamias2d.solve.plan import Plan


def run_by_steps(plan: Plan, method: Stepped, *, progress: bool) -> Run:
    """Return the run of a scene whose contacts are stepped.

    Raises as `solve` does; the error's `run` is the history up to there.
    """
    stepper = Stepper(
        plan.scene,
        time_step=plan.time_step or plan.duration,
        substeps=method.substeps,
        times=plan.times,
    )
    try:
        follow(stepper, plan.duration, progress=progress)
    except NoValueError as broken:
        fault = RangeError(f"run at {stepper.time!r} s: {broken}", time=stepper.time)
        fault.run = _reached(plan, stepper)
        raise fault from None
    except RuleError:  # the plan is sound: a number went beyond float64 on the way
        raise range_error(f"run at {stepper.time!r} s: a number", stepper.time) from None
    except SimulationError as fault:
        fault.run = _reached(plan, stepper)
        raise
    except KeyboardInterrupt:
        raise Interrupted(lambda: _reached(plan, stepper)) from None
    return _reached(plan, stepper)


def _reached(plan: Plan, stepper: Stepper) -> Run:
    """Return the run up to the step that was reached, with what is known of its error."""
    history, times = stepper.history(), plan.times
    times = times[: len(history.position)]
    if not len(times):  # it did not get as far as a first sample
        history, times = start_of(plan), np.zeros(1)
    plan = plan._replace(times=times)
    tally = Tally(steps=stepper.steps, force_evaluations=stepper.steps)
    run = run_of(plan, history, _impacts(stepper), (), tally, _joint_events(stepper, plan.scene))
    names = [body.name for body in plan.scene.bodies]
    notes = (
        f"contacts: told at the ends of steps; over all steps, {stepper.contacts} had an impulse",
        _overlap(stepper.deepest, names),
        *_parts(stepper),
        f"energy: {run.energy[0]:.6g} J at first, {run.energy[-1]:.6g} J at last, "
        f"never more than {run.energy.max():.6g} J",
        *_joints(plan.scene),
        "error: not bounded; `certify` finds how much shorter steps change",
        *stepper.warnings,
    )
    cost = cost_of(run.impacts, tally, contacts=stepper.contacts)
    return replace(run, notes=run.notes + notes, cost=cost)


def _overlap(deepest: Overlap | None, names: Sequence[str]) -> str:
    if deepest is None:
        return "overlap: none"
    a, b = (names[k] for k in deepest.bodies)
    return (
        f"overlap: at most {deepest.share:.2g} of the size of the smaller body, "
        f"{deepest.depth:.2g} m of '{a}' and '{b}' at {deepest.time:.4g} s"
    )


def _joints(scene: Scene) -> tuple[str, ...]:
    if not scene.joints:
        return ()
    return (
        "joints: `reactions` of this run count no contacts, limits, teeth or motors; those of "
        "Simulator(scene).reactions do",
    )


def _parts(stepper: Stepper) -> tuple[str, ...]:
    if not stepper.split:
        return ()
    return (
        f"parts: {stepper.split} of {stepper.steps} steps, in which many bodies went farther than "
        f"they are thick, were taken in up to {stepper.most_parts} parts",
    )


def _joint_events(stepper: Stepper, scene: Scene) -> JointEvents:
    """Return what happened to joints, at the end of the step in which it did."""
    index = {joint.name: k for k, joint in enumerate(scene.joints)}
    return joint_events(
        JointEvent(event.time, index[event.joint], 0, event.what, event.value)
        for event in stepper.joint_events
    )


def _impacts(stepper: Stepper) -> Impacts:
    """Return the pairs that began to touch, at the end of the step in which they did."""
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
