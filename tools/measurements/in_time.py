"""A call in a process of its own, which the system ends at a limit of processor time."""

import math
import multiprocessing
import resource
import signal
import time
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any


def in_time(call: Callable[..., Any], given: tuple[Any, ...], limit: int) -> Any | None:
    """Return what a call returns; None if it takes more than a limit, s of the processor."""
    ours, theirs = multiprocessing.Pipe(duplex=False)
    child = multiprocessing.Process(target=_send, args=(call, given, limit, theirs))
    child.start()
    theirs.close()
    try:
        return ours.recv()
    except EOFError:  # the system has ended the process
        return None
    finally:
        child.kill()
        child.join()


def _send(call: Callable[..., Any], given: tuple[Any, ...], limit: int, to: Connection) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # whoever waits for it ends it
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    limit += math.ceil(time.process_time())
    resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
    to.send(call(*given))
