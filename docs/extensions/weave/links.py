"""Links between items: the role in the prose, and ids that stand in plain text.

Serves: chapters and tables. Hides: on which page an item stands.
"""

import re
from collections.abc import Iterable
from typing import Any

from docutils import nodes
from sphinx.util.docutils import SphinxRole

from weave.modules import page_of
from weave.woven import Woven

_PREFIXES = [
    "GS",
    "A",
    "TM",
    "GD",
    "DD",
    "IM",
    "P",
    "R",
    "NFR",
    "LC",
    "UC",
    "E",
    "TC",
    "OA",
    "OB",
    "OC",
    "OD",
]
_ID = re.compile(r"(?<![\w`-])(?:GS|TM|GD|DD|IM|NFR|LC|UC|TC|O[A-Z]|[APRE])\d+[a-z]?(?![\w`])")


_ROLE = re.compile(r"\{[a-z][\w:+-]*\}`([^`<]*?)(?:\s*<[^`]*>)?`")
_KEY = re.compile(r"\(([a-z]+\d{4}[a-z]?)\)|^([a-z]+\d{4}[a-z]?)$")


class ItemRole(SphinxRole):
    """`` {srs}`IM1` `` links to the item, whose title shows when the pointer rests on it."""

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        woven: Woven = self.env.app.woven  # type: ignore[attr-defined]
        item = woven.spec.items.get(self.text)
        if item is None:
            message = f"{self.text}: no such item. Correct the id"
            fault = self.inliner.reporter.warning(message, line=self.lineno)
            return [nodes.literal("", self.text)], [fault]
        page = item.file.removesuffix(".md")
        uri = self.env.app.builder.get_relative_uri(self.env.docname, page)
        options: dict[str, Any] = {"internal": True, "classes": ["srs-link", item.kind]}
        title = f"{item.title}. {without_roles(item.data.get('says', ''))}".strip()
        return [
            nodes.reference("", item.id, refuri=f"{uri}#{item.id}", reftitle=title, **options)
        ], []


def without_roles(text: str) -> str:
    """Text for where no link can stand: of each role, such as `` {srs}`IM3` ``, its words."""
    return _ROLE.sub(lambda match: match[1], " ".join(text.split()))


def linked(text: str, woven: Woven) -> str:
    """Plain text in which the id of every item, and every key of a book, has become a link."""

    def link(match: re.Match[str]) -> str:
        known = match.group() in woven.spec.items
        return f"{{srs}}`{match.group()}`" if known else match.group()

    def cited(match: re.Match[str]) -> str:
        key = match[1] or match[2]
        return f"{{cite}}`{key}`" if key in woven.books else match.group()

    return _KEY.sub(cited, _ID.sub(link, " ".join(text.split())))


def ids(names: Iterable[str]) -> str:
    """Links to several items, side by side, in order."""
    return " ".join(f"{{srs}}`{name}`" for name in sorted(names, key=rank))


def rank(id: str) -> tuple[int, int, str]:
    """Sorts ids by kind and number: R2 before R10, models before cases."""
    prefix = re.match(r"[A-Z]*", id).group()  # type: ignore[union-attr]
    digits = re.search(r"\d+", id)
    place = _PREFIXES.index(prefix) if prefix in _PREFIXES else len(_PREFIXES)
    return place, int(digits.group()) if digits else 0, id


class SymbolRole(SphinxRole):
    """`` {symbol}`mass` `` is an anchor in the table that declares it, else a link to there."""

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        woven: Woven = self.env.app.woven  # type: ignore[attr-defined]
        symbol = woven.spec.table.resolve(self.text).symbol
        page, anchor = symbol.file.removesuffix(".md"), f"symbol-{symbol.name}"
        name = nodes.literal("", self.text)
        if page == self.env.docname and symbol.name == self.text:
            return [nodes.inline("", "", name, ids=[anchor])], []
        uri = self.env.app.builder.get_relative_uri(self.env.docname, page)
        return [nodes.reference("", "", name, refuri=f"{uri}#{anchor}", internal=True)], []


class ModuleRole(SphinxRole):
    """`` {module}`tamias2d.run` `` links to the module among the internals."""

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        anchor = f"#{module_anchor(self.text)}"
        return [internal_link(self.env, self.text, anchor)], []


class PackageRole(SphinxRole):
    """`` {package}`tamias2d.engine` `` links to the page of the package."""

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        return [internal_link(self.env, self.text, "")], []


def internal_link(env: Any, name: str, anchor: str) -> nodes.reference:
    """A link to the page on which a module stands, or to its anchor there."""
    page = page_of(name, env.app.woven.root / "src/tamias2d")
    target = f"{env.app.builder.get_relative_uri(env.docname, page)}{anchor}"
    return nodes.reference("", "", nodes.literal("", name), refuri=target, internal=True)


def module_anchor(name: str) -> str:
    """The anchor of a module among the internals."""
    return f"module-{name.replace('.', '-')}"
