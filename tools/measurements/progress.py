"""How far a measurement is, on standard error."""

import signal
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import TypeVar

from rich.console import Console
from rich.progress import track

_Item = TypeVar("_Item")
TOLD = Console(stderr=True)


def each(items: Iterable[_Item], name: str = "", total: int | None = None) -> Iterable[_Item]:
    """Yield items, and show meanwhile how many are done."""
    return track(items, name, total=total, console=TOLD, transient=True)


@contextmanager
def until_stopped() -> Iterator[None]:
    """Let Ctrl-C, or SIGTERM, end what is done within, and no more."""
    before = signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        yield
    except KeyboardInterrupt:
        TOLD.print("Stopped; this is what was found until then.")
    finally:
        signal.signal(signal.SIGTERM, before)
