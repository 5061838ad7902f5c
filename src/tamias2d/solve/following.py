"""A run followed up to its end, with a progress bar, and stopped by Ctrl-C without being lost."""

from collections.abc import Callable
from functools import cached_property
from typing import Protocol

from tamias2d.run import Run


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
