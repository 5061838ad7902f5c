"""The check of a case: it holds what it compares, with names, numbers and units that exist.

Serves: the reader. Hides: where in a case expressions stand.
"""

from collections.abc import Iterator, Mapping

from tamias2d.spec.case_answers import check_shared_answers
from tamias2d.spec.case_calls import check_calls
from tamias2d.spec.case_numbers import check_numbers
from tamias2d.spec.case_schemes import check_schemes
from tamias2d.spec.chapter import Item
from tamias2d.spec.check import Type, expect
from tamias2d.spec.comparisons import COMPARISONS, WITHOUT_RUN
from tamias2d.spec.equations import Report, parsed, placed, symbol_of
from tamias2d.spec.expression import names
from tamias2d.spec.messages import Code, SpecFault
from tamias2d.spec.symbols import SymbolTable
from tamias2d.spec.units import SECOND

_OF_BODIES = ("position", "velocity", "orientation", "angular_velocity")
_ONE_OF = {
    "impacts": ("count", "times", "impulses"),
    "schemes": ("orders", "shows", "constants"),
    "conserves": ("momentum", "angular_momentum", "energy"),
}
"""Comparisons that say nothing without one of these keys."""
Path = tuple[str | int, ...]
Answer = tuple[Path, str, Type, tuple[str, ...]]
"""Where an expression stands, its text, what it has to be, and the names that it may use."""


def check_case(item: Item, items: Mapping[str, Item], table: SymbolTable, report: Report) -> None:
    """Report what a case lacks, names that do not exist, and answers that cannot be right."""
    compared = [key for key in COMPARISONS if key in item.data]
    if not compared:
        known = ", ".join(COMPARISONS)
        report(item.diagnostic(Code.BAD_KEY, f"a case compares something: one of {known}. Add one"))
    _check_run(item, [key for key in compared if key not in WITHOUT_RUN], report)
    _check_content(item, report)
    for answer in _answers(item, table, report):
        _check_answer(item, answer, table, report)
    check_shared_answers(item, report)
    check_numbers(item, table, report)
    check_schemes(item, items, report)
    check_calls(item, items, table, report)


def _check_run(item: Item, on_a_run: list[str], report: Report) -> None:
    """Report a case that has comparisons of a run and does not say of what, or for how long."""
    for needed in ("scene", "duration"):
        if on_a_run and needed not in item.data:
            text = f"found no '{needed}': '{on_a_run[0]}' compares a run and needs one. State it"
            report(item.diagnostic(Code.BAD_KEY, text))


def _check_content(item: Item, report: Report) -> None:
    """Report a comparison that compares nothing."""
    data = item.data
    for key, any_of in _ONE_OF.items():
        if key in data and not any(each in data[key] for each in any_of):
            text = f"'{key}' compares nothing: it needs one of {', '.join(any_of)}. State one"
            report(item.diagnostic(Code.BAD_KEY, text, key))


def _check_answer(item: Item, answer: Answer, table: SymbolTable, report: Report) -> None:
    path, text, wanted, known = answer
    node = parsed(item, text, report, *path)
    if node is None:
        return
    try:
        expect(node, table, wanted)
    except SpecFault as fault:
        report(placed(item, fault, *path))
        return
    for name in names(node):
        if name not in known:
            rule = f"an answer here knows {' and '.join(known) or 'no name'}"
            message = f"'{name}': {rule}. Write the number with its unit"
            report(item.diagnostic(Code.UNKNOWN_NAME, message, *path))


def _answers(item: Item, table: SymbolTable, report: Report) -> Iterator[Answer]:
    instant = Type("scalar", SECOND)
    for number, text in enumerate(item.data.get("impacts", {}).get("times", [])):
        yield ("impacts", "times", number), text, instant, ()
    for number, state in enumerate(item.data.get("moments", {}).get("states", [])):
        yield ("moments", "states", number, "at"), state["at"], instant, ()
    for path, bodies, known in _tables(item):
        for body, quantities in bodies.items():
            for name, text in quantities.items():
                place = (*path, body, name)
                if name not in _OF_BODIES:
                    message = f"'{name}' of a body: must be one of {', '.join(_OF_BODIES)}. Correct"
                    report(item.diagnostic(Code.UNKNOWN_NAME, f"{message} it", *place, "key"))
                    continue
                if symbol := symbol_of(item, name, table, report, *place, "key"):
                    yield place, text, Type(symbol.shape, symbol.dimension), known


def _tables(
    item: Item,
) -> Iterator[tuple[Path, Mapping[str, Mapping[str, str]], tuple[str, ...]]]:
    """Where answers stand by body and quantity, these, and the names that they know."""
    for key in ("exact", "final", "stepped", "worlds"):
        yield (key, "bodies"), item.data.get(key, {}).get("bodies", {}), ("time",)
    for number, state in enumerate(item.data.get("moments", {}).get("states", [])):
        yield ("moments", "states", number, "bodies"), state["bodies"], ("time",)
    for scheme, bodies in item.data.get("schemes", {}).get("constants", {}).items():
        yield ("schemes", "constants", scheme), bodies, ("time", "time_step")
