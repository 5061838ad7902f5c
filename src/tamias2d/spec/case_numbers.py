"""The numbers of a case: tolerances that can fail, and quantities with the unit of their symbol.

Serves: the check of a case. Hides: where in a case they stand.
"""

from collections.abc import Iterator

from tamias2d.spec.chapter import Item
from tamias2d.spec.comparisons import COMPARISONS
from tamias2d.spec.equations import Report, placed, symbol_of
from tamias2d.spec.messages import Code, SpecFault
from tamias2d.spec.symbols import Symbol, SymbolTable
from tamias2d.spec.units import parse_quantity

_MOST = 0.01  # of relative errors: steps of first order come as near
_MOST_OF = {
    "certified": 1.0,  # shares of a bound
    "worlds": 1.0,
    "schemes": 0.5,  # of an order, which is a whole number
    "published": 0.1,  # some digits are printed
    "pace": 60.0,  # s, that a user would wait
}
Path = tuple[str | int, ...]


def check_numbers(item: Item, table: SymbolTable, report: Report) -> None:
    """Report tolerances that nothing could miss, and quantities that are none of their symbol."""
    for path, text, most in _tolerances(item):
        if float(text) > most:
            rule = f"must be at most {most:g}, or hardly an error could fail. Give a smaller one"
            report(item.diagnostic(Code.BAD_VALUE, f"tolerance '{text}': {rule}", *path))
    for path, text in _asked(item):
        if not float(text):
            rule = "no run is that exact: must be above 0. Give a larger one"
            report(item.diagnostic(Code.BAD_VALUE, f"tolerance '{text}': {rule}", *path))
    for path, text, name in _quantities(item):
        if symbol := symbol_of(item, name, table, report, *path):
            check_quantity(item, text, symbol, report, *path)
    for place, (low, high) in item.data.get("worlds", {}).get("vary", {}).items():
        _check_order(item, place, low, high, report)


def check_quantity(item: Item, text: str, symbol: Symbol, report: Report, *path: str | int) -> None:
    """Report a text that is no quantity in the unit and the range of its symbol."""
    try:
        quantity = parse_quantity(text)
    except SpecFault as fault:
        report(placed(item, fault, *path))
        return
    if quantity.dimension != symbol.dimension:
        rule = f"must be in {symbol.dimension} (symbol {symbol.name}). Correct the unit"
        message = f"'{text}' is in {quantity.dimension}: {rule}"
        report(item.diagnostic(Code.UNIT_MISMATCH, message, *path))
    elif not symbol.admits(quantity.value):
        message = f"'{text}': {symbol.rule}. Give another value"
        report(item.diagnostic(Code.BAD_VALUE, message, *path))


def _tolerances(item: Item) -> Iterator[tuple[Path, str, float]]:
    """Where tolerances stand, and how large each may be."""
    data = item.data
    for key in COMPARISONS:
        if "tolerance" in data.get(key, {}):
            yield (key, "tolerance"), data[key]["tolerance"], _MOST_OF.get(key, _MOST)
    if "reference" in data.get("exact", {}):
        yield ("exact", "reference"), data["exact"]["reference"], _MOST


def _asked(item: Item) -> Iterator[tuple[Path, str]]:
    """Where tolerances stand that a run is asked to keep."""
    for number, text in enumerate(item.data.get("certified", {}).get("tolerances", ())):
        yield ("certified", "tolerances", number), text
    if "worlds" in item.data:
        yield ("worlds", "within"), item.data["worlds"]["within"]


def _quantities(item: Item) -> Iterator[tuple[Path, str, str]]:
    """Where quantities stand, and the symbol of each."""
    data = item.data
    if "duration" in data:
        yield ("duration",), data["duration"], "duration"
    for key in ("stepped", "published", "worlds"):
        if "time_step" in data.get(key, {}):
            yield (key, "time_step"), data[key]["time_step"], "time_step"
    for number, text in enumerate(data.get("impacts", {}).get("impulses", ())):
        yield ("impacts", "impulses", number), text, "impulse"
    for key, part in (("schemes", "durations"), ("reference", "scenes")):
        for name, text in data.get(key, {}).get(part, {}).items():
            yield (key, part, name), text, "duration"
    for key in ("refuses", "notes"):
        for label, entry in data.get(key, {}).get("scenes", {}).items():
            if "time_step" in entry:
                yield (key, "scenes", label, "time_step"), entry["time_step"], "time_step"


def _check_order(item: Item, place: str, low: str, high: str, report: Report) -> None:
    path = ("worlds", "vary", place)
    try:
        first, last = parse_quantity(low), parse_quantity(high)
    except SpecFault as fault:
        report(item.diagnostic(fault.code, fault.message, *path))
        return
    if first.dimension != last.dimension or not first.value < last.value:
        message = f"from '{low}' to '{high}': the second must be larger, in one unit. Correct it"
        report(item.diagnostic(Code.BAD_RANGE, message, *path))
