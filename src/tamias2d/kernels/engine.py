"""Engines: plain functions that are compiled together as one kernel.

Serves: the stepped way, and `tamias2d warm`. Hides: assembling and compiling, and what a person who
waits for it is told.
"""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from types import SimpleNamespace
from typing import Any

from tamias2d.kernels.arrays import name_of_entry
from tamias2d.kernels.assembled import assembled
from tamias2d.kernels.compiled import loaded
from tamias2d.kernels.copied import Function

_PACE = 5000  # bytes of source a second, to say about how long it takes


@dataclass(frozen=True)
class Engine:
    """Functions, by a name, that are compiled together."""

    name: str
    """What people are told is compiled, such as 'contact engine'."""
    entries: tuple[Function, ...]
    """What is called from outside; their types are those of `tamias2d.kernels.arrays`."""

    def source(self) -> str:
        """Return the source that is compiled, with all that the entries use."""
        return assembled(*self.entries, says=f"The {self.name} of Tamias2D.")

    def plain(self) -> SimpleNamespace:
        """Return the entries by their names as they are, to look into and to compare with."""
        return SimpleNamespace(**{entry.__name__: entry for entry in self.entries})

    def compiled(self) -> SimpleNamespace:
        """Return the entries by their names, compiled; where that takes a while, it is said.

        Their bits are those of the plain ones. An entry that takes a group takes its `addresses`
        instead.
        """
        return _compiled(self)


@cache
def _compiled(engine: Engine) -> SimpleNamespace:
    text = engine.source()
    with _told(engine.name, max(len(text) / _PACE, 1)):
        module = loaded(text)
    return SimpleNamespace(
        **{entry.__name__: getattr(module, name_of_entry(entry)) for entry in engine.entries}
    )


@contextmanager
def _told(name: str, seconds: float) -> Iterator[None]:
    """Say on standard error that an engine is compiled, if that happens meanwhile.

    The compiler itself reports it: whether compiled code can be used again, only it knows.
    """
    from numba.core import event
    from rich.console import Console

    console = Console(stderr=True)

    class Teller(event.Listener):
        started: float | None = None

        def on_start(self, event: Any) -> None:  # noqa: ARG002
            if self.started is None:
                self.started = time.perf_counter()
                console.print(
                    f"Compiling the {name}, about {seconds:.0f} s, once for this machine ..."
                )

        def on_end(self, event: Any) -> None:
            """Nothing: functions within functions end as well."""

    teller = Teller()
    with event.install_listener("numba:compile", teller):
        yield
    if teller.started is not None:
        console.print(f"Compiled in {time.perf_counter() - teller.started:.1f} s.")
