"""Runs cases by seed in a process of their own: a fault, a hang and a kill are told with its seed.

A case may take `LIMIT` seconds of the processor. Cost: a start of Python for each fault that ends a
process.
"""

import multiprocessing
import signal
import traceback
from collections.abc import Callable, Iterator
from importlib import import_module
from multiprocessing.connection import Connection
from types import FrameType
from typing import NamedTuple

LIMIT = 20.0  # s of the processor
KINDS = {
    "scenes": "scenes:case",
    "files": "documents:case",
    "sequences": "sequences:case",
    "sequences-changed": "changed_sequences:case",
    "sequences-jointed": "jointed_sequences:case",
    "saved": "damage:saved",
    "cached": "damage:cached",
    "momentum-located": "momentum:located",
    "momentum-stepped": "momentum:stepped",
    "momentum-jointed": "momentum:jointed",
}


class Result(NamedTuple):
    """What came of a case."""

    seed: int
    what: str
    """done, refused, or what is wrong"""
    wrong: bool


class _HangError(Exception):
    pass


def results(kind: str, first: int, count: int) -> Iterator[Result]:
    """Go through the results of cases with consecutive seeds."""
    context = multiprocessing.get_context("spawn")
    seed, last = first, first + count
    while seed < last:
        here, there = context.Pipe(duplex=False)
        process = context.Process(target=_run, args=(kind, seed, last, there), daemon=True)
        process.start()
        there.close()
        try:
            while seed < last:
                yield Result(seed, *here.recv())
                seed += 1
        except EOFError:
            process.join()
            yield Result(seed, f"the process was killed ({process.exitcode})", True)
            seed += 1
        finally:
            process.terminate()
            process.join()


def run_case(kind: str, seed: int) -> Result:
    """Run one case here; a hang is ended at its limit."""
    module, _, name = KINDS[kind].partition(":")
    case: Callable[[int], str] = getattr(import_module(f"tools.fuzz.{module}"), name)
    signal.signal(signal.SIGPROF, _end)
    try:
        signal.setitimer(signal.ITIMER_PROF, LIMIT)  # its signal may come before the case begins
        return Result(seed, case(seed), False)
    except BaseException as error:
        if isinstance(error, KeyboardInterrupt):
            raise
        return Result(seed, _told(error), True)
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)


def _run(kind: str, first: int, last: int, pipe: Connection) -> None:
    for seed in range(first, last):
        found = run_case(kind, seed)
        pipe.send((found.what, found.wrong))


def _end(_signal: int, _frame: FrameType | None) -> None:
    raise _HangError(f"takes more than {LIMIT:g} s of the processor")


def _told(error: BaseException) -> str:
    frame = traceback.extract_tb(error.__traceback__)[-1]
    place = frame.filename.rpartition("tamias2d/")[2]
    return f"{type(error).__name__} at {place}:{frame.lineno}: {str(error)[:120]}"
