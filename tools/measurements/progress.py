"""How far a measurement is, on standard error."""

import signal
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import TypeVar

from rich.console import Console
from rich.progress import track

_Item = TypeVar("_Item")
TOLD = Console(stderr=True)
_asked_to_stop: list[int] = []
"""Signals, which count at the next item, too: what is raised while a process forks is lost."""


def each(items: Iterable[_Item], name: str = "", total: int | None = None) -> Iterable[_Item]:
    """Yield items, and show meanwhile how many are done."""
    for item in track(items, name, total=total, console=TOLD, transient=True):
        if _asked_to_stop:
            raise KeyboardInterrupt
        yield item


@contextmanager
def until_stopped() -> Iterator[None]:
    """Let Ctrl-C, or SIGTERM, end what is done within, and no more."""
    signals = (signal.SIGINT, signal.SIGTERM)
    before = [signal.signal(number, _stop) for number in signals]
    try:
        yield
    except KeyboardInterrupt:
        TOLD.print("Stopped; this is what was found until then.")
    finally:
        _asked_to_stop.clear()
        for number, handler in zip(signals, before, strict=True):
            signal.signal(number, handler)


def _stop(number: int, _: FrameType | None) -> None:
    _asked_to_stop.append(number)
    raise KeyboardInterrupt
