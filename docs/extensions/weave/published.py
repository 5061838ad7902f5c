"""The tables of 2018 beside what the program's scheme gives and what is exact.

Serves: the pages of cases and results. Hides: how numbers are grouped and shown.
"""

from functools import cache
from itertools import groupby

from tamias2d.verify import cases
from tamias2d.verify.published import Sample, samples
from weave.markdown import table


@cache
def _samples(id: str) -> list[Sample]:
    (case,) = cases(id)
    return samples(case)


def part(id: str) -> str:
    """The table of a case."""
    groups = groupby(_samples(id), key=lambda s: (s.body, s.quantity, s.time))
    head = ["body", "quantity", "time in s", "published", "reproduced", "exact", ""]
    return table(head, (_row(list(group)) for _, group in groups), style="published")


def _row(group: list[Sample]) -> list[str]:
    first = group[0]
    misprints = [f"misprint, reads {s.reads:.2f}" for s in group if s.misprint]
    return [
        first.body,
        first.quantity.replace("_", " "),
        f"{first.time:.4f}",
        _shown([s.published for s in group]),
        _shown([s.reproduced for s in group]),
        _shown([s.exact for s in group]),
        "; ".join(misprints),
    ]


def _shown(numbers: list[float]) -> str:
    texts = [f"{number:.2f}" for number in numbers]
    return texts[0] if len(texts) == 1 else f"({', '.join(texts)})"


def summary(ids: list[str]) -> str:
    """One row a case: how well the tables are reproduced, and how far they are from the truth."""
    head = ["", "numbers", "misprints", "farthest from the scheme", "farthest from exact"]
    return table(head, map(_summary_row, ids))


def _summary_row(id: str) -> list[str]:
    found = _samples(id)
    missed = max(abs(s.reads - s.reproduced) for s in found)
    wrong = max(abs(s.published - s.exact) for s in found)
    misprints = sum(s.misprint for s in found)
    return [f"{{srs}}`{id}`", str(len(found)), str(misprints), f"{missed:.4f}", f"{wrong:.4g}"]
