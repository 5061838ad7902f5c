"""The tables printed in the V&V plan of 2018, reproduced by its program's scheme."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from tamias2d.motion import Legacy2018
from tamias2d.run import Run
from tamias2d.simulate import simulate
from tamias2d.state import Array
from tamias2d.verify.case import Case
from tamias2d.verify.formula import history, measure
from tamias2d.verify.outcome import Outcome

_AXES = ("x", "y")


@dataclass(frozen=True)
class Sample:
    """One printed number of 2018, beside what it should have been."""

    case: str
    body: str
    quantity: str
    axis: str
    """x, y, or nothing for a scalar."""
    time: float
    """When the sample was really taken, s."""
    published: float
    """As printed."""
    reads: float
    """What it must have been meant to be, where it is a misprint; else as printed."""
    reproduced: float
    """By the scheme of 2018."""
    exact: float
    misprint: bool
    """Whether the case lists this number as one."""


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """The largest difference in each table; a misprint must be one, and its reading must fit."""
    table = samples(case)
    for quantity in dict.fromkeys(sample.quantity for sample in table):
        numbers = [sample for sample in table if sample.quantity == quantity]
        error = max(abs(sample.reads - sample.reproduced) for sample in numbers)
        what = f"{len(numbers)} published numbers, {quantity.replace('_', ' ')}"
        yield case.outcome(given, what, _last_digit(error))
    wrong = [sample for sample in table if sample.misprint]
    if wrong:
        tolerance = float(given["tolerance"])
        fit = sum(abs(sample.published - sample.reproduced) <= tolerance for sample in wrong)
        note = f"listed as misprints of 2018: {len(wrong)}"
        yield case.outcome(given, "listed misprints that the program did print", fit, note)


def samples(case: Case) -> list[Sample]:
    """Return every printed number of a case with its reproduction and its exact value."""
    given = case.data["published"]
    step = float(measure(given["time_step"], "time_step"))
    steps = [int(text) for text in given["steps"]]
    run = simulate(case.scene, duration=steps[-1] * step, method=Legacy2018(), time_step=step)
    return [
        sample
        for body, tables in given["tables"].items()
        for quantity, rows in tables.items()
        for sample in _rows(case, run, steps, body, quantity, rows)
    ]


def _rows(
    case: Case, run: Run, steps: list[int], body: str, quantity: str, rows: list[Any]
) -> Iterator[Sample]:
    text = case.data["exact"]["bodies"][body][quantity]
    exact = history(text, quantity, run.times[steps])
    found: Array = getattr(run, quantity)[steps, run.scene.index(body)]
    readings = _readings(case, body, quantity)
    for k, row in enumerate(rows):
        printed = row if isinstance(row, list) else [row]
        for axis, number in enumerate(printed):
            name = _AXES[axis] if isinstance(row, list) else ""
            yield Sample(
                case.id, body, quantity, name, float(run.times[steps[k]]),
                published=float(number),
                reads=readings.get((k + 1, name), float(number)),
                reproduced=float(found[k].flat[axis]),
                exact=float(exact[k].flat[axis]),
                misprint=(k + 1, name) in readings,
            )  # fmt: skip


def _readings(case: Case, body: str, quantity: str) -> dict[tuple[int, str], float]:
    return {
        (int(entry["sample"]), entry.get("component", "")): float(entry["reads"])
        for entry in case.data["published"].get("misprints", ())
        if (entry["body"], entry["quantity"]) == (body, quantity)
    }


def _last_digit(error: float) -> float:
    """Forget the rounding of the subtraction: 0.01 that reads 0.010000000000019 is 0.01."""
    return round(error, 9)
