"""Runs by the scheme of 2018, which knows its states at the ends of its steps only."""

import numpy as np

from tamias2d.balance import balance
from tamias2d.contact import refuse_contact
from tamias2d.errors import InputError
from tamias2d.motion import Legacy2018, Tally
from tamias2d.run import Run
from tamias2d.solve.assembly import NO_IMPACTS, run_of
from tamias2d.solve.finite import refuse_infinite
from tamias2d.solve.plan import Plan


def run_by_legacy(plan: Plan, method: Legacy2018) -> Run:
    """Return the run of a scene in which nothing meets.

    Raises:
        InputError: samples are asked for at other times than the ends of steps.
        UnlocatedContactError: bodies meet.
    """
    times, history = method.history(plan.scene, plan.duration, plan.time_step or plan.duration)
    if not np.array_equal(times, plan.times):
        raise InputError(
            f"times of the run: found {len(plan.times)} of them beside {method}: it knows its "
            "states at the ends of its steps only (R5). Leave times out."
        )
    refuse_infinite(times, *balance(plan.scene, history))
    refuse_contact(plan.scene, times, history)
    taken = len(times) - 1
    tally = Tally(steps=taken, force_evaluations=taken)
    return run_of(plan._replace(times=times), history, NO_IMPACTS, (), tally)
