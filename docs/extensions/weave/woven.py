"""The specification, its generated code and its last results, as one object for the pages.

Serves: every directive. Hides: where the three come from and how links run backwards.
"""

import json
import re
from collections import defaultdict
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from tamias2d.spec.chapter import Item
from tamias2d.spec.expression import Name
from tamias2d.spec.messages import SpecFault
from tamias2d.spec.specification import Specification
from tamias2d.spec.tex import tex
from tamias2d.verify.outcome import Outcome
from weave.results import last_results


@dataclass(frozen=True)
class Code:
    """A generated function and its place."""

    function: str
    file: str
    line: int


@dataclass
class Woven:
    """All that the pages show."""

    root: Path
    spec: Specification
    code: dict[str, list[Code]] = field(default_factory=dict)
    results: dict[str, list[Outcome]] = field(default_factory=dict)

    @cached_property
    def books(self) -> set[str]:
        """The keys of references.bib."""
        return set(
            re.findall(r"@\w+\{([^,\s]+)", (self.root / "srs/references.bib").read_text("utf-8"))
        )

    @cached_property
    def used_by(self) -> dict[str, list[str]]:
        """For each id, the ids of the items that name it, errata apart."""
        return self._backwards([i for i in self.spec.items.values() if i.kind != "erratum"])

    @cached_property
    def corrected_by(self) -> dict[str, list[str]]:
        """For each id, the errata about it."""
        return self._backwards(self.spec.of_kind("erratum"))

    def _backwards(self, items: list[Item]) -> dict[str, list[str]]:
        found: dict[str, list[str]] = defaultdict(list)
        for item in items:
            for id in self.spec.linked(item):
                found[id].append(item.id)
        return found

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
    """Read srs/, generated/srs.json and the last results below the root of the project."""
    from tamias2d.spec.reader import read

    spec = read(root / "srs")
    listing = root / "src/tamias2d/generated/srs.json"
    entries = json.loads(listing.read_text("utf-8"))["items"] if listing.is_file() else []
    code = {
        entry["id"]: [Code(c["function"], c["file"], c["line"]) for c in entry["code"]]
        for entry in entries
    }
    return Woven(root, spec, code, last_results(spec))
