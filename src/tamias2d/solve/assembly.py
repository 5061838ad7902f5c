"""A run put together from its plan and its history, with its balance and its cost."""

from dataclasses import replace

import numpy as np

from tamias2d.balance import balance
from tamias2d.cost import Cost
from tamias2d.motion import JointEvents, Tally, joint_events
from tamias2d.run import Impacts, Run
from tamias2d.solve.finite import refuse_infinite
from tamias2d.solve.plan import Plan
from tamias2d.state import Array, History
from tamias2d.work_limit import WORK_LIMIT

NO_IMPACTS = Impacts(
    time=np.zeros(0),
    bodies=np.zeros((0, 2), np.int64),
    point=np.zeros((0, 2)),
    normal=np.zeros((0, 2)),
    impulse=np.zeros(0),
    normal_velocity=np.zeros(0),
)


def run_of(
    plan: Plan,
    history: History,
    impacts: Impacts,
    notes: tuple[str, ...],
    tally: Tally,
    events: JointEvents | None = None,
) -> Run:
    """Return the run; raise `RangeError` if its energy or a momentum is not finite."""
    energy, momentum, angular_momentum = balance(plan.scene, history)
    refuse_infinite(plan.times, energy, momentum, angular_momentum)
    return Run(
        scene=plan.scene,
        method=plan.method,
        duration=plan.duration,
        time_step=plan.time_step,
        times=plan.times,
        **history._asdict(),
        impacts=impacts,
        joint_events=joint_events() if events is None else events,
        energy=energy,
        momentum=momentum,
        angular_momentum=angular_momentum,
        notes=plan.notes + notes,
        stepped_because=plan.stepped_because,
        cost=cost_of(impacts, tally),
    )


def sampled_at(run: Run, times: Array) -> Run | None:
    """Return a run at some of its times (k,), s; None if it has no samples at others of these."""
    rows = np.searchsorted(run.times, times)
    rows = np.minimum(rows, len(run.times) - 1)
    if not np.array_equal(run.times[rows], times):
        return None
    names = ("position", "orientation", "velocity", "angular_velocity")
    more: tuple[str, ...] = ("energy", "momentum", "angular_momentum")
    if run.contact_force is not None:
        more += "contact_force", "contact_torque"
    parts = {name: getattr(run, name)[rows] for name in (*names, *more)}
    return replace(run, times=times, **parts)


def with_reason(run: Run, reason: str) -> Run:
    """Return a run whose first note says why its method was taken, in place of the one it had."""
    return replace(run, notes=(reason, *run.notes[1:]))


def cost_of(impacts: Impacts, tally: Tally, *, contacts: int = 0) -> Cost:
    """Return the cost of a run; an impact with a whole side counts once."""
    met = zip(impacts.time.tolist(), *impacts.bodies.T.tolist(), strict=True)
    return Cost(**vars(tally), impacts=len(set(met)), contacts=contacts)


def work_limit_of(run: Run) -> int:
    """Return a work limit under which a run can be computed again."""
    steps = run.cost.steps if run.cost else 0
    return max(WORK_LIMIT, steps + len(run.impacts.time))


def start_of(plan: Plan) -> History:
    """Return the states of all bodies at the start, as a history of one sample."""
    bodies = plan.scene.bodies
    return History(
        np.array([[body.position for body in bodies]]).reshape(1, -1, 2),
        np.array([[body.orientation for body in bodies]]),
        np.array([[body.velocity for body in bodies]]).reshape(1, -1, 2),
        np.array([[body.angular_velocity for body in bodies]]),
    )
