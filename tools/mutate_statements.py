"""Breaks statements on purpose: `python -m tools.mutate_statements [--each N] [--seed N]`.

Each equation that is stated, each step of a derivation, each rate of a state and each closed form
is changed in a few of the small ways of `tools.mutate`, chosen at random. The reader has to refuse
the item, or one that hangs together with it. It prints the mutants that survive, and how many
of each kind. They are expected where an item says `unchecked`, and where a test in random crowds
judges it, which is not run here. Exits with 1 if another survives.
"""

import argparse
import random
import sys
from collections import Counter
from collections.abc import Iterator
from copy import deepcopy
from dataclasses import dataclass
from typing import Any

from tamias2d.spec.chapter import Item
from tamias2d.spec.expression import parse
from tamias2d.spec.formulas import check_item
from tamias2d.spec.messages import Diagnostic
from tamias2d.spec.reader import read
from tamias2d.spec.specification import Specification
from tamias2d.spec.tex import plain
from tamias2d.spec.ties import check_ties
from tools.generate import ROOT
from tools.mutate import changes

_EACH = 3


@dataclass(frozen=True)
class Mutant:
    """One changed statement."""

    item: Item
    path: tuple[str | int, ...]
    text: str

    def __str__(self) -> str:
        line = self.item.at(*self.path)[0]
        return f"{self.item.file}:{line}: {self.item.id} {self.path[0]}: {self.text}"


def mutants(specification: Specification, each: int, seed: int) -> list[Mutant]:
    """A few single changes of all that items state."""
    generator = random.Random(seed)
    found = []
    for item in specification.items.values():
        for path, text in _statements(item):
            tree = parse(text)
            changed = sorted({plain(other) for other in changes(tree)} - {plain(tree)})
            chosen = generator.sample(changed, min(each, len(changed)))
            found += [Mutant(item, path, other) for other in chosen]
    return found


def _statements(item: Item) -> Iterator[tuple[tuple[str | int, ...], str]]:
    if item.kind == "case":
        return
    data = item.data
    if "equation" in data:
        yield ("equation",), data["equation"]
    for number, step in enumerate(data.get("derivation", ())):
        yield ("derivation", number, "equation"), step["equation"]
    for key in ("states", "closed_form"):
        for name, text in data.get(key, {}).items():
            if name != "when":
                yield (key, name), text


def is_noticed(mutant: Mutant, specification: Specification) -> bool:
    """Whether the reader refuses the changed item, or one that hangs together with it."""
    changed = deepcopy(mutant.item)
    *above, last = mutant.path
    place: Any = changed.data
    for key in above:
        place = place[key]
    place[last] = mutant.text
    items = specification.items | {changed.id: changed}
    if check_item(changed, items, specification.table):
        return True
    used = changed.data.get("uses", ())
    near = [each for each in items.values() if each.kind != "case" and each is not changed]
    users = [each for each in near if changed.id in each.data.get("uses", ())]
    if any(check_item(each, items, specification.table) for each in users):
        return True
    faults: list[Diagnostic] = []
    for each in (changed, *users, *(items[id] for id in used)):
        check_ties(each, items, specification.table, faults.append)
    return bool(faults)


def main() -> int:
    """Run the tool; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m tools.mutate_statements", description=__doc__)
    parser.add_argument("--each", type=int, default=_EACH, help="changes of each statement")
    parser.add_argument("--seed", type=int, default=0)
    arguments = parser.parse_args()
    specification = read(ROOT / "srs")
    tried = mutants(specification, arguments.each, arguments.seed)
    left = [mutant for mutant in tried if not is_noticed(mutant, specification)]
    for mutant in left:
        print(f"{_expected(mutant) or 'survives'}: {mutant}")
    kinds, survived = (Counter(m.path[0] for m in each) for each in (tried, left))
    for kind, number in kinds.items():
        print(f"{kind}: {number} mutants, {survived[kind]} not noticed")
    return int(not all(map(_expected, left)))


def _expected(mutant: Mutant) -> str:
    """The key of the item that says why the reader does not notice; empty if there is none."""
    return next((key for key in ("unchecked", "crowd") if key in mutant.item.data), "")


if __name__ == "__main__":
    sys.exit(main())
