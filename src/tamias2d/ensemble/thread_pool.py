"""Threads on which worlds step.

Serves: whoever steps many worlds. Hides: that a process has none of the threads of the one that it
was forked from, and that Ctrl-C reaches the main thread alone.
"""

import os
from collections.abc import Callable, Iterable
from concurrent.futures import Future, ThreadPoolExecutor, wait
from threading import Event
from typing import TypeVar

from tamias2d.engine.interruption import ended_by

_T = TypeVar("_T")


class ThreadPool:
    """So many threads, which start when there is first something to do."""

    def __init__(self, size: int) -> None:
        """Prepare so many threads."""
        self.size = size
        self._process = -1  # whose threads they are

    def run(self, act: Callable[[_T], None], items: Iterable[_T]) -> None:
        """Do something with all items at once, and return when all is done.

        After Ctrl-C it raises once nothing goes on: steps end between two of them.
        """
        asked = Event()

        def go(item: _T) -> None:
            with ended_by(asked):
                act(item)

        futures: list[Future[None]] = []
        try:
            for item in items:
                futures.append(self._executor().submit(go, item))
            wait(futures)
        finally:
            asked.set()
            wait(futures)
        for future in futures:
            future.result()

    def _executor(self) -> ThreadPoolExecutor:
        """Return the threads of this process, which a fork does not take along."""
        if self._process != os.getpid():
            self._process, self._threads = os.getpid(), ThreadPoolExecutor(self.size)
        return self._threads
