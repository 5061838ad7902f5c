"""Random cases of every kind: is each done, or refused by name?

Kinds: scenes and what is asked of them, damaged scene files, sequences of calls of a simulator,
damaged saved states and compiled code, and momentum where nothing outside pushes. A case is known
by its kind and seed. Stop it by Ctrl-C, and what was found is printed.
"""

from argparse import ArgumentParser
from collections import Counter
from typing import Any

from tools.fuzz.runner import KINDS, results
from tools.measurements.columns import Columns
from tools.measurements.progress import TOLD, each, until_stopped


def options(parser: ArgumentParser) -> None:
    """Add what can be chosen."""
    parser.add_argument("--kind", choices=sorted(KINDS), action="append", help="one kind only")
    parser.add_argument("--first", type=int, default=0, help="seed of the first case (0)")
    parser.add_argument("--count", type=int, default=1000, help="cases of each kind (1000)")


def measure(kind: list[str] | None = None, first: int = 0, count: int = 1000) -> dict[str, Any]:
    """Return for each kind how many cases were done and refused, and what was wrong."""
    counted: dict[str, Counter[str]] = {}
    wrong: dict[str, list[list[Any]]] = {}
    with until_stopped():
        for name in kind or KINDS:
            counted[name], wrong[name] = Counter(), []
            for found in each(results(name, first, count), name, total=count):
                if found.wrong:
                    wrong[name].append([found.seed, found.what])
                    TOLD.print(f"{name} {found.seed}: {found.what}")
                else:
                    counted[name][found.what] += 1
    rows = [{"kind": name, **counted[name], "wrong": wrong[name]} for name in counted]
    return {"first": first, "count": count, "rows": rows}


COLUMNS: Columns = {
    "kind": "{kind}",
    "done": lambda row: str(row.get("done", 0)),
    "refused": lambda row: str(row.get("refused", 0)),
    "wrong": lambda row: str(len(row["wrong"])),
}


def notes(found: dict[str, Any]) -> list[str]:
    """Return what was wrong."""
    return [f"{row['kind']} {seed}: {what}" for row in found["rows"] for seed, what in row["wrong"]]
