"""Reads srs/ into a checked specification.

Serves: generator, docs, tests. Hides: the order of the checks. The faults that all chapters have
in the first stage with any are reported together, each as `file:line:column: code: message`.
"""

import keyword
import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import jsonschema

from tamias2d.errors import SpecError
from tamias2d.spec.chapter import Chapter, Item, read_chapter
from tamias2d.spec.circles import rings
from tamias2d.spec.formulas import check_item
from tamias2d.spec.kinds import KINDS
from tamias2d.spec.letters import check_letters
from tamias2d.spec.links import check_links
from tamias2d.spec.messages import Code, Diagnostic, SpecFault
from tamias2d.spec.modules import check_modules
from tamias2d.spec.schema_fault import schema_fault
from tamias2d.spec.specification import Specification
from tamias2d.spec.symbols import Index, Range, Symbol, SymbolTable, parse_range
from tamias2d.spec.tex import has_balanced_braces
from tamias2d.spec.ties import check_ties
from tamias2d.spec.units import parse_unit

_BIB_KEY = re.compile(r"@\w+\{\s*([^,\s]+)\s*,")


def read(folder: Path) -> Specification:
    """Read and check all chapters below a folder.

    Raises:
        SpecError: at least one fault; its text has a line for each, in the order of the files.
            Faults that may follow from others are told when those are mended.
    """
    return _Reader(folder).read()


class _Reader:
    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.faults: list[Diagnostic] = []

    def report(self, fault: Diagnostic) -> None:
        self.faults.append(fault)

    def read(self) -> Specification:
        """All chapters, checked in order: form, declarations, links, sources, formulas, letters,
        and ties of statements.

        What a fault of form or of a declaration hides would give faults elsewhere: they wait.
        """
        chapters = [
            read_chapter(path, self.name(path)) for path in sorted(self.folder.rglob("*.md"))
        ]
        if not chapters:
            text = "no chapter (*.md) is here. Name the folder of the specification"
            self.report(Diagnostic(str(self.folder), 1, 1, Code.UNREADABLE.code, text))
        self.faults += [fault for chapter in chapters for fault in chapter.faults]
        items = [item for chapter in chapters for item in chapter.items if self.has_schema(item)]
        self.stop_at_faults()
        specification = self.assemble(items, chapters)
        self.stop_at_faults()
        self.check_links(specification)
        self.check_circles(specification.items)
        self.check_sources(specification)
        check_modules(specification.items.values(), self.report)
        for item in specification.items.values():
            self.faults += check_item(item, specification.items, specification.table)
        self.stop_at_faults()
        self.faults += check_letters(specification.items.values(), specification.table)
        self.stop_at_faults()
        for item in specification.items.values():
            check_ties(item, specification.items, specification.table, self.report)
        self.stop_at_faults()
        return specification

    def stop_at_faults(self) -> None:
        if self.faults:
            raise SpecError("\n".join(str(fault) for fault in sorted(set(self.faults))))

    def name(self, path: Path) -> str:
        return f"{self.folder.name}/{path.relative_to(self.folder).as_posix()}"

    def has_schema(self, item: Item) -> bool:
        validator = jsonschema.Draft202012Validator(KINDS[item.kind].schema)
        errors = list(validator.iter_errors(item.data))
        for error in errors:
            self.report(schema_fault(item, error))
        return not errors

    def assemble(self, items: Iterable[Item], chapters: list[Chapter]) -> Specification:
        """Items by id and the symbol table; what is declared twice is reported."""
        by_id: dict[str, Item] = {}
        symbols: dict[str, Item] = {}
        indices: dict[str, Item] = {}
        for item in items:
            if item.kind == "symbols":
                self.declare(item, symbols)
            elif item.kind == "indices":
                self.declare(item, indices)
            elif item.id in by_id:
                first = by_id[item.id]
                text = (
                    f"'{item.id}' stands already in {first.file}:{first.line}. Give it another id"
                )
                self.report(item.diagnostic(Code.DUPLICATE_ID, text))
            else:
                by_id[item.id] = item
        table = SymbolTable(
            [self.symbol(item, name, item.data[name]) for name, item in symbols.items()],
            [self.index(item, name, item.data[name]) for name, item in indices.items()],
        )
        titles = {chapter.file: chapter.title for chapter in chapters}
        return Specification(by_id, table, titles, [role for c in chapters for role in c.roles])

    def declare(self, item: Item, found: dict[str, Item]) -> None:
        """Note the item that declares each name; report names that are taken or no names."""
        for name in item.data:
            if keyword.iskeyword(name):
                text = f"'{name}' is a word of Python, and code could not use it. Rename it"
                self.report(item.diagnostic(Code.BAD_KEY, text, name, "key"))
            elif name in found:
                first = f"{found[name].file}:{found[name].at(name, 'key')[0]}"
                text = f"'{name}' is declared already in {first}. Remove one"
                self.report(item.diagnostic(Code.DUPLICATE_ID, text, name, "key"))
            else:
                found[name] = item

    def symbol(self, item: Item, name: str, data: dict[str, Any]) -> Symbol:
        """One symbol with its unit and range; where these are at fault it gets plain ones."""
        unit, limits = "1", Range()
        try:
            unit = parse_unit(data["unit"]).text
        except SpecFault as fault:
            self.report(
                item.diagnostic(fault.code, fault.message, name, "unit", offset=fault.offset)
            )
        try:
            limits = parse_range(data["range"]) if "range" in data else Range()
        except SpecFault as fault:
            self.report(item.diagnostic(fault.code, fault.message, name, "range"))
        self.check_tex(item, name, data["tex"])
        line = item.at(name, "key")[0]
        typical = data.get("typical", "")
        says = " ".join(data["says"].split())
        return Symbol(
            name, unit, says, data.get("shape", "scalar"), limits, data["tex"],
            typical if isinstance(typical, str) else "(" + ", ".join(typical) + ")",
            data.get("uncertainty", ""), item.file, line,
        )  # fmt: skip

    def index(self, item: Item, name: str, data: dict[str, str]) -> Index:
        self.check_tex(item, name, data["tex"])
        return Index(name, data["tex"], data["says"], data.get("place", "sub"))

    def check_tex(self, item: Item, name: str, tex: str) -> None:
        if not has_balanced_braces(tex):
            text = f"'{tex}' has braces that do not pair up. Close or remove them"
            self.report(item.diagnostic(Code.BAD_VALUE, text, name, "tex"))

    def check_links(self, specification: Specification) -> None:
        """Report each id, in a fence or in the prose, that leads to no item that it may name."""
        known = specification.items
        for item in known.values():
            check_links(item, known, self.report)
        for role in specification.roles:
            if role.id not in known and role.id not in specification.table.symbols:
                text = f"'{role.id}' is no item. Correct the id or write the item"
                self.report(
                    Diagnostic(role.file, role.line, role.column, Code.UNKNOWN_ID.code, text)
                )

    def check_circles(self, items: dict[str, Item]) -> None:
        """Report items that rest on themselves."""
        for ring in rings({id: item.data.get("uses", ()) for id, item in items.items()}):
            first = items[ring[0]]
            text = f"'{ring[0]}' rests on itself: {' uses '.join(ring)}. Leave out one of these"
            place = ("uses", first.data["uses"].index(ring[1]))
            self.report(first.diagnostic(Code.CIRCLE, text, *place))

    def check_sources(self, specification: Specification) -> None:
        path = self.folder / "references.bib"
        keys = set(_BIB_KEY.findall(path.read_text(encoding="utf-8"))) if path.exists() else set()
        for item in specification.items.values():
            sources = item.data.get("source", [])
            for number, key in enumerate(sources if isinstance(sources, list) else []):
                if key not in keys:
                    text = (
                        f"source '{key}' is not in references.bib. Add the entry or correct the key"
                    )
                    self.report(item.diagnostic(Code.UNKNOWN_ID, text, "source", number))
