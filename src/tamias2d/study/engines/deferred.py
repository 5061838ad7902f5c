"""Ctrl-C while C calls Python, where an exception is printed and lost: it waits for the next step.

Serves: engines written in C that are given functions to call. Hides: signals, and whose they are.
"""

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def deferred_interrupts() -> Iterator[Callable[[], None]]:
    """Keep Ctrl-C within the block; what is yielded raises it, and so does the end of the block.

    Where somebody else deals with Ctrl-C, nothing is kept.
    """
    kept: list[int] = []

    def raise_kept() -> None:
        if kept:
            raise KeyboardInterrupt

    def keep(number: int, frame: Any) -> None:  # noqa: ARG001
        kept.append(number)

    ours = threading.current_thread() is threading.main_thread()
    if not ours or signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
        yield raise_kept
        return
    signal.signal(signal.SIGINT, keep)
    try:
        yield raise_kept
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
        raise_kept()
