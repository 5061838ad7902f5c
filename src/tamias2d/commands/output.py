"""Output of the commands: tables for people, JSON for machines."""

import errno
import io
import json
import math
import os
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, TypeVar

_OPEN = dict.fromkeys(("stale", "uncovered", "not run"), "yellow")
_COLOURS = {"pass": "green", "fail": "bold red", **_OPEN}
_Item = TypeVar("_Item")
_WIDE = 1000  # columns: where no screen limits them, no line is folded


def command() -> str:
    """How the user called this program; `tools/dev` passes its own name on."""
    return os.environ.get("TAMIAS2D_COMMAND", "tamias2d")


def prepare() -> None:
    """Make it possible to print anything: to streams that are closed, or have few letters."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, "w"))  # noqa: SIM115 - for good
        getattr(sys, name).reconfigure(errors="backslashreplace")


@contextmanager
def _output() -> Iterator[None]:
    """Give a fault of standard output its name, and print nothing more to it.

    That a reader has enough is no fault of anybody, and has no name.
    """
    try:
        yield
    except OSError as fault:
        if fault.errno != errno.EPIPE:
            fault.filename = "standard output"
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise


def flush() -> None:
    """Print what is still to be printed; raise OSError if that cannot be done."""
    with _output():
        sys.stdout.flush()


def say(text: str = "") -> None:
    """Print one line to standard output; raise OSError if that cannot be done."""
    with _output():
        print(text)


def print_json(value: Any) -> None:
    """Print a value as JSON, every float with all its digits; NaN and infinity are refused."""
    say(json.dumps(value, indent=2, allow_nan=False))


def print_table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
    """Print rows in columns; cells are folded only where a screen is narrow."""
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, pad_edge=False, header_style="bold")
    for head in heads:
        table.add_column(head, overflow="fold")
    for row in rows:
        table.add_row(*(Text(cell, style=_COLOURS.get(cell, "")) for cell in row))
    if sys.stdout.isatty():
        Console().print(table)
        return
    drawn = io.StringIO()
    Console(file=drawn, width=_WIDE, color_system=None).print(table)
    say("\n".join(line.rstrip() for line in drawn.getvalue().splitlines()))


def followed(items: Sequence[_Item], name: Callable[[_Item], str]) -> Iterator[_Item]:
    """Give the items one by one; in a terminal a bar on standard error shows how far that is."""
    if not sys.stderr.isatty():
        yield from items
        return
    from rich.console import Console
    from rich.progress import MofNCompleteColumn, Progress

    columns = (*Progress.get_default_columns(), MofNCompleteColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("", total=len(items))
        for item in items:
            bar.update(task, description=name(item))
            yield item
            bar.advance(task)


def figure(value: float) -> str:
    """A number as people read it: ten digits at most."""
    return f"{value:.10g}"


def pair(value: Sequence[float]) -> str:
    """A vector as people read it."""
    return f"({figure(value[0])}, {figure(value[1])})"


def error_text(value: float) -> str:
    """An error or a tolerance: two digits are enough; '-' where nothing could be compared."""
    return f"{value:.1e}" if math.isfinite(value) else "-"
