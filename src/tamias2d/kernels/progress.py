"""What a person who waits for the compiler is told.

Serves: engines. Hides: how the compiler reports what it does. Whether compiled code can be used
again, only the compiler knows; so it is heard, and where it has nothing to do, nothing is said.
"""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

_PACE = 9000  # bytes of source a second of processor time


def time_of_compiling(source: str) -> float:
    """Return about how long it takes to compile a source, s of processor time."""
    return max(len(source) / _PACE, 1.0)


@contextmanager
def progress(name: str, source: str) -> Iterator[None]:
    """Show on standard error how much of a source is compiled, if any of it is.

    A terminal has a bar, which vanishes; elsewhere there is one line at the start and one at the
    end.
    """
    from numba.core import event
    from rich.console import Console

    shown = _Shown(name, source, Console(stderr=True))

    class Listener(event.Listener):
        def on_start(self, event: Any) -> None:
            if _is_ours(event):
                shown.start()

        def on_end(self, event: Any) -> None:
            if _is_ours(event):
                shown.done(event.data["dispatcher"].py_func.__qualname__)

    with event.install_listener("numba:compile", Listener()):
        try:
            yield
        finally:
            shown.end()


def _is_ours(event: Any) -> bool:
    """Whether it is about a kernel, and not about what the user compiles meanwhile."""
    module: str = event.data["dispatcher"].py_func.__module__
    return module.startswith("tamias2d_kernel_")


class _Shown:
    """A line, and a bar of the functions that are compiled; nothing before the first begins."""

    def __init__(self, name: str, source: str, console: Any) -> None:
        self.name = name
        self.console = console
        self.count = source.count("\ndef ")
        self.seconds = time_of_compiling(source)
        self.compiled: set[str] = set()  # one function may be compiled for several types
        self.started: float | None = None
        self.bar: Any = None

    def start(self) -> None:
        """Print the line and begin the bar, once."""
        if self.started is not None:
            return
        self.started = time.perf_counter()
        self.console.print(
            f"Compiling the {self.name}: {self.count} functions, about {self.seconds:.0f} s of "
            "processor time, kept for this processor and these versions of Python, numba and "
            "Tamias2D ...",
            soft_wrap=True,
            highlight=False,
        )
        if self.console.is_terminal:
            from rich.progress import BarColumn, MofNCompleteColumn, Progress, TimeElapsedColumn

            columns = (BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
            self.bar = Progress(*columns, console=self.console, transient=True)
            self.bar.add_task("", total=self.count)
            self.bar.start()

    def done(self, function: str) -> None:
        self.compiled.add(function)
        if self.bar is not None:
            self.bar.update(self.bar.task_ids[0], completed=len(self.compiled))

    def end(self) -> None:
        if self.bar is not None:
            self.bar.stop()
        if self.started is not None:
            took = time.perf_counter() - self.started
            self.console.print(f"Compiled in {took:.1f} s.", highlight=False)
