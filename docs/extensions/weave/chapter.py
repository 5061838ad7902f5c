"""The fences of a chapter as directives: each shows its item as the reader understood it.

Serves: the pages of srs/. Hides: which parts a kind of item has, and in which order they stand.
"""

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.util.docutils import SphinxDirective

from tamias2d.spec.chapter import Item
from weave import parts
from weave.woven import Woven


class WovenDirective(SphinxDirective):
    """What all directives share: the woven specification, and Markdown from text."""

    has_content = True
    optional_arguments = 1
    final_argument_whitespace = True

    @property
    def woven(self) -> Woven:
        """The specification of this build."""
        return self.env.app.woven  # type: ignore[attr-defined,no-any-return]

    def parse(self, markdown: str, into: nodes.Element) -> None:
        """Append what the Markdown says."""
        source = self.env.docname
        self.state.nested_parse(StringList(markdown.splitlines(), source), 0, into)


class ItemDirective(WovenDirective):
    """An item with its id as anchor: statement, formulas, derivation, code, cases, links."""

    def run(self) -> list[nodes.Node]:
        name = self.arguments[0].split()[0]
        item = self.woven.spec.items.get(name)
        if item is None:
            raise self.error(f"{name} is new since the specification was read. Build again")
        section = nodes.section(ids=[item.id], names=[], classes=["srs-item", item.kind])
        section += nodes.title(
            "", "", nodes.inline("", item.id, classes=["srs-id"]), nodes.Text(f" {item.title}")
        )
        self.parse(parts.body(item, self.woven), section)
        return [section]


class SymbolsDirective(WovenDirective):
    """A table of symbols; the fence's place says which."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container(classes=["srs-symbols"])
        self.parse(parts.symbol_table(self._declared(), self.woven), box)
        return [box]

    def _declared(self) -> list[str]:
        file = f"{self.env.docname}.md"
        span = range(self.lineno, self.lineno + len(self.content) + 2)
        table = self.woven.spec.table
        return [s.name for s in table.symbols.values() if s.file == file and s.line in span]


class IndicesDirective(WovenDirective):
    """The table of indices."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container(classes=["srs-symbols"])
        self.parse(parts.index_table(self.woven), box)
        return [box]


def item_kinds() -> list[str]:
    """The kinds of fence that hold one item."""
    from tamias2d.spec.kinds import KINDS

    return [kind.name for kind in KINDS.values() if kind.ids is not None]


__all__ = ["IndicesDirective", "Item", "ItemDirective", "SymbolsDirective", "item_kinds"]
