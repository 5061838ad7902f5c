"""`tamias2d trace`: from requirement to model, code, cases and results, or around one item."""

import sys
from collections.abc import Iterable, Iterator
from typing import TypeAlias

from tamias2d.commands.output import command, print_json, print_table, say
from tamias2d.trace import (
    Traced,
    exit_code,
    lacking,
    neighbourhood,
    never_run,
    trace,
    unrun,
)
from tamias2d.verify import NOT_RUN

_LISTED = 6  # cases in one row
_Row: TypeAlias = tuple[str, str, str, str]


def trace_items(id: str | None, *, as_json: bool) -> int:
    """Print all items, or one with its surroundings; return 1 if an item is not in order."""
    items = trace(id)
    if as_json:
        print_json({"items": [item.as_json() for item in items]})
    elif id is None:
        _print_all(items)
    else:
        _print_around(id)
    if any(item.verdict == NOT_RUN for item in items):
        for hint in _hints(id):
            print(hint, file=sys.stderr)
    return exit_code(items)


def _hints(id: str | None) -> Iterator[str]:
    if waiting := lacking():
        call = " ".join((command(), "verify", *waiting))
        needs = " and ".join(dict.fromkeys(waiting.values()))
        yield f"{', '.join(waiting)}: not run: {needs}. Install it, then `{call}` runs them."
    if never_run():
        yield _hint(unrun(id) if id else [])


def _hint(unrun: list[str]) -> str:
    whose = f" of {', '.join(unrun)}" if unrun else ""
    call = " ".join((command(), "verify", *unrun))
    return f"Some cases{whose} have not been run yet: `{call}` runs them."


def _print_all(items: list[Traced]) -> None:
    known = {item.id: item for item in items}
    demands = [item for item in items if item.kind in ("goal", "requirement")]
    rows: list[_Row] = []
    shown: set[str] = set()
    for demand in demands:
        rows.append(_row(demand))
        for used in (known[id] for id in demand.links):
            rows.append(_row(used, "  "))
            rows += () if used.id in shown else _code(used)
            shown.add(used.id)
    _print(rows)
    verdicts = [demand.verdict for demand in demands]
    counts = ", ".join(f"{verdicts.count(v)} {v}" for v in dict.fromkeys(verdicts))
    say(f"\n{len(demands)} goals and requirements: {counts}")


def _print_around(id: str) -> None:
    near = neighbourhood(id)
    _print([_row(near.item), *_code(near.item)])
    for head, items in (
        (f"{id} rests on", near.rests_on),
        (f"What depends on {id}", near.depended_on_by),
    ):
        say(f"\n{head}" + ("" if items else ": nothing"))
        if items:
            _print(row for item in items for row in (_row(item), *_code(item)))


def _print(rows: Iterable[_Row]) -> None:
    print_table(("item", "where", "cases", "verdict"), rows)


def _row(item: Traced, indent: str = "") -> _Row:
    cases = " ".join(item.cases[:_LISTED])
    more = len(item.cases) - len(item.cases[:_LISTED])
    return (
        f"{indent}{item.id} {item.title}",
        f"{item.file}:{item.line}",
        f"{cases} and {more} more" if more else cases,
        item.verdict,
    )


def _code(item: Traced) -> Iterator[_Row]:
    for function in item.code:
        module = function["module"].rpartition(".")[2]
        yield (
            f"    {module}.{function['function']}",
            f"{function['file']}:{function['line']}",
            "",
            "",
        )
