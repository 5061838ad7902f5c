"""Warnings of too long steps, for people: one line each, and each once."""

import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TextIO

from tamias2d.errors import StepWarning


@contextmanager
def as_lines() -> Iterator[None]:
    """Print what is warned of within this to standard error; other warnings as Python does."""
    told: set[str] = set()
    as_ever = warnings.showwarning

    def tell(
        message: Warning | str,
        category: type[Warning],
        filename: str,
        lineno: int,
        file: TextIO | None = None,
        line: str | None = None,
    ) -> None:
        """Print a message once; the arguments are those of `warnings.showwarning`."""
        if not issubclass(category, StepWarning):
            as_ever(message, category, filename, lineno, file, line)
        elif str(message) not in told:
            told.add(str(message))
            print(message, file=sys.stderr)

    with warnings.catch_warnings():
        warnings.simplefilter("always", StepWarning)
        warnings.showwarning = tell
        yield


@contextmanager
def untold() -> Iterator[None]:
    """Print none within this: the notes of a run, and the overlaps of a study, tell as much."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", StepWarning)
        yield
