"""The tables of 2018 beside what the program's scheme gives and what is exact.

Serves: the pages of cases and results. Hides: where the three numbers come from.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from tamias2d.motion import Legacy2018
from tamias2d.scene import catalogue
from tamias2d.simulate import simulate
from tamias2d.spec.chapter import Item
from tamias2d.spec.evaluate import evaluate
from tamias2d.spec.expression import parse
from tamias2d.spec.units import parse_quantity
from weave.markdown import table

HEAD = ["body", "quantity", "step", "time in s", "published", "reproduced", "exact", ""]


@dataclass(frozen=True)
class Sample:
    """One printed number or pair, and the other two."""

    body: str
    quantity: str
    number: int
    step: int
    time: float
    published: np.ndarray
    reproduced: np.ndarray
    exact: np.ndarray | None
    note: str

    @property
    def row(self) -> list[str]:
        """The cells of a table."""
        numbers = (self.published, self.reproduced, self.exact)
        return [
            self.body,
            self.quantity,
            str(self.step),
            f"{self.time:.4f}",
            *map(_shown, numbers),
            self.note,
        ]


def _shown(value: np.ndarray | None) -> str:
    if value is None:
        return ""
    numbers = [f"{number:.2f}" for number in np.atleast_1d(value)]
    return numbers[0] if len(numbers) == 1 else f"({', '.join(numbers)})"


def part(item: Item) -> str:
    """The table of a case, empty if the plan published nothing for it."""
    return (
        table(HEAD, (s.row for s in samples(item)), style="published")
        if "published" in item.data
        else ""
    )


def samples(item: Item) -> Iterator[Sample]:
    """Every printed number of a case with its companions."""
    published = item.data["published"]
    steps = [int(step) for step in published["steps"]]
    h = parse_quantity(published["time_step"]).value
    run = _legacy(item.data["scene"], steps[-1], h)
    names = [body.name for body in run.scene.bodies]
    for body, quantities in published["tables"].items():
        for quantity, numbers in quantities.items():
            history = getattr(run, quantity)[:, names.index(body)]
            for k, (step, printed) in enumerate(zip(steps, numbers, strict=True)):
                yield Sample(
                    body, quantity, k + 1, step, step * h, np.array(printed, float), history[step],
                    _exact(item, body, quantity, step * h), _note(published, body, quantity, k + 1),
                )  # fmt: skip


@cache
def _legacy(scene: str, steps: int, h: float) -> Any:
    return simulate(catalogue.load(scene), duration=steps * h, method=Legacy2018(), time_step=h)


def _exact(item: Item, body: str, quantity: str, time: float) -> np.ndarray | None:
    text = item.data.get("exact", {}).get("bodies", {}).get(body, {}).get(quantity)
    return None if text is None else np.array(evaluate(parse(text), {"time": time}))


def _note(published: dict[str, Any], body: str, quantity: str, sample: int) -> str:
    for entry in published.get("misprints", []):
        if (entry["body"], entry["quantity"], int(entry["sample"])) == (body, quantity, sample):
            return f"misprint: {entry['says']}"
    return ""


def summary(items: list[Item]) -> str:
    """One row a case: how well the tables are reproduced, and how far they are from the truth."""
    rows = (_summary_row(item) for item in items if "published" in item.data)
    head = [
        "",
        "case",
        "numbers",
        "misprints",
        "largest difference reproduced",
        "largest difference from exact",
    ]
    return table(head, rows)


def _summary_row(item: Item) -> list[str]:
    found = list(samples(item))
    counted = sum(s.published.size for s in found)
    sound = [s for s in found if not s.note]
    missed = max(float(np.abs(s.published - s.reproduced).max()) for s in sound)
    wrong = max(
        (float(np.abs(s.published - s.exact).max()) for s in sound if s.exact is not None),
        default=0.0,
    )
    return [
        f"{{srs}}`{item.id}`",
        item.title,
        str(counted),
        str(len(found) - len(sound)),
        f"{missed:.4f}",
        f"{wrong:.4g}",
    ]
