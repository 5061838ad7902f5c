"""A run followed up to its end, with a progress bar, and stopped by Ctrl-C without being lost."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cached_property
from typing import Protocol

import numpy as np

from tamias2d.motion import Tally
from tamias2d.run import Run
from tamias2d.solve.assembly import NO_IMPACTS, run_of, sampled_at, start_of
from tamias2d.solve.plan import Plan


class Interrupted(KeyboardInterrupt):
    """The user stopped a run; `run` is its history up to there, made when somebody wants it."""

    def __init__(self, reached: Callable[[], Run]) -> None:
        super().__init__()
        self._reached = reached

    @cached_property
    def run(self) -> Run:
        """The history up to there; it is not made for who only stops."""
        return self._reached()

    def __str__(self) -> str:
        return f"Run of {self.run.duration:g} s: interrupted at {self.run.times[-1]:.6g} s."


@contextmanager
def interruptible(plan: Plan) -> Iterator[None]:
    """Let whatever is done for a plan end by `Interrupted`, and by no bare `KeyboardInterrupt`.

    Its `run` is the history that was being made for the plan, or the start alone: pilots and
    companions, which go another way or have other samples, are none.
    """
    try:
        yield
    except KeyboardInterrupt as stop:
        raise _interrupted(stop, plan) from None


def _interrupted(stop: KeyboardInterrupt, plan: Plan) -> Interrupted:
    def reached() -> Run:
        if isinstance(stop, Interrupted) and (known := _known(stop.run, plan)) is not None:
            return known
        start = plan._replace(times=np.zeros(1))
        return run_of(start, start_of(plan), NO_IMPACTS, (), Tally())

    return Interrupted(reached)


def _known(run: Run, plan: Plan) -> Run | None:
    """Return a run at the first of the times of a plan; None if it has none, or another scene."""
    times = plan.times[plan.times <= run.times[-1]]
    return sampled_at(run, times) if run.scene is plan.scene and len(times) else None


class Solver(Protocol):
    """A solver that goes on to a time in s, and tells of each time that it reaches."""

    def go(self, duration: float, *, told: Callable[[float], None] = ...) -> None:
        """Go on to `duration`, s, and call `told` with each time reached, s."""


def follow(solver: Solver, duration: float, *, progress: bool) -> None:
    """Let a solver go on to the end of a run, s; `progress` shows a bar on standard error."""
    if not progress:
        solver.go(duration)
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("simulating", total=duration)
        solver.go(duration, told=lambda time: bar.update(task, completed=time))
