"""The specification, what trace knows of its items, and their last results, as one object.

Serves: every directive. Hides: where the three come from and how links run backwards.
"""

import re
from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from tamias2d.spec.chapter import Item
from tamias2d.spec.expression import Name
from tamias2d.spec.messages import SpecFault
from tamias2d.spec.reader import read
from tamias2d.spec.specification import Specification
from tamias2d.spec.tex import tex
from tamias2d.trace import Graph, Traced, trace
from tamias2d.verify import NOT_RUN, Outcome, results
from tamias2d.verify.items import items


@dataclass
class Woven:
    """All that the pages show."""

    root: Path
    spec: Specification
    traced: Mapping[str, Traced]
    outcomes: Mapping[str, Iterable[Outcome]]

    @cached_property
    def books(self) -> set[str]:
        """The keys of references.bib."""
        text = (self.root / "srs/references.bib").read_text("utf-8")
        return set(re.findall(r"@\w+\{([^,\s]+)", text))

    @cached_property
    def used_by(self) -> dict[str, list[str]]:
        """For each id, the ids of the items that name it, errata apart."""
        return self._backwards([i for i in self.spec.items.values() if i.kind != "erratum"])

    @cached_property
    def corrected_by(self) -> dict[str, list[str]]:
        """For each id, the errata about it."""
        return self._backwards(self.spec.of_kind("erratum"))

    @cached_property
    def graph(self) -> Graph:
        """The items with their links in both directions, as `tamias2d trace` follows them."""
        return Graph(items(), results.read())

    def _backwards(self, items: list[Item]) -> dict[str, list[str]]:
        found: dict[str, list[str]] = defaultdict(list)
        for item in items:
            for id in self.spec.linked(item):
                found[id].append(item.id)
        return found

    def verdict(self, id: str) -> str:
        """Of an item's cases, or of the case itself."""
        return self.traced[id].verdict if id in self.traced else NOT_RUN

    def code(self, id: str) -> list[tuple[str, str]]:
        """The functions printed from an item, with their files."""
        found = self.traced[id].code if id in self.traced else ()
        return [(function["function"], function["file"]) for function in found]

    def source(self, item: Item) -> str:
        """The fence of an item as it is written, without its marks."""
        lines = (self.root / item.file).read_text("utf-8").splitlines()[item.line :]
        return "\n".join(lines[: lines.index("```")])

    def letter(self, name: str) -> str:
        """A name as TeX; a name that is no symbol stands upright."""
        try:
            return tex(Name(name), self.spec.table)
        except SpecFault:
            return rf"\mathrm{{{name.replace('_', ' ')}}}"


def weave(root: Path) -> Woven:
    """Read what the pages below the root of the project show."""
    return Woven(root, read(root / "srs"), {row.id: row for row in trace()}, results.read())
