"""Checks of the finished pages; what they find are warnings, which `sphinx -W` makes errors.

Serves: the docs build. Hides: how a page is searched.
"""

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from html.parser import HTMLParser
from itertools import chain
from pathlib import Path
from posixpath import dirname, normpath
from urllib.parse import unquote, urlsplit

from sphinx.application import Sphinx
from sphinx.util import logging

_LOADS = {"script": "src", "img": "src", "iframe": "src", "source": "src", "link": "href"}
_STYLE_LOAD = re.compile(r"""(?:url\(|@import)\s*["']?((?:https?:)?//[^"')\s]+)""")
_FORMAL = ("equation", "equations", "states")


@dataclass
class Page(HTMLParser):
    """What matters of one page: anchors, links, files that it loads, sections with formulas."""

    name: str
    ids: Counter[str] = field(default_factory=Counter)
    links: list[str] = field(default_factory=list)
    loads: list[str] = field(default_factory=list)
    with_formula: set[str] = field(default_factory=set)
    _open: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        super().__init__()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {key: value or "" for key, value in attrs}
        if "id" in given:
            self.ids[given["id"]] += 1
        if tag == "section":
            self._open.append(given.get("id", ""))
        if tag == "div" and "math" in given.get("class", "").split():
            self.with_formula.update(self._open)
        if tag == "a" and "href" in given:
            self.links.append(given["href"])
        if tag in _LOADS and _LOADS[tag] in given:
            self.loads.append(given[_LOADS[tag]])

    def handle_endtag(self, tag: str) -> None:
        if tag == "section":
            self._open.pop()


def read_pages(folder: Path) -> dict[str, Page]:
    """Every page below a folder, by its path."""
    pages: dict[str, Page] = {}
    for path in sorted(folder.rglob("*.html")):
        page = Page(path.relative_to(folder).as_posix())
        page.feed(path.read_text("utf-8"))
        pages[page.name] = page
    return pages


def missing_items(pages: dict[str, Page], items: dict[str, bool]) -> Iterator[str]:
    """Items that do not stand on exactly one page, or whose formula is not there.

    `items` says for each id whether it has a formula.
    """
    for id, formal in items.items():
        found = [page for page in pages.values() if page.ids[id]]
        if sum(page.ids[id] for page in found) != 1:
            times = sum(page.ids[id] for page in found)
            yield f"{id} stands {times} times on the pages: must be once. Look for its fence"
        elif formal and id not in found[0].with_formula:
            yield f"{found[0].name}: {id} has no formula. Look at its equations"


def loads_from_elsewhere(pages: dict[str, Page]) -> Iterator[str]:
    """Scripts, styles and pictures that need a network."""
    for page in pages.values():
        for address in page.loads:
            if urlsplit(address).netloc:
                yield f"{page.name} loads {address}: pages must work offline. Vendor the file"


def styles_from_elsewhere(folder: Path) -> Iterator[str]:
    """Style sheets that load fonts, pictures or more styles over a network."""
    for path in sorted(folder.rglob("*.css")):
        for address in _STYLE_LOAD.findall(path.read_text("utf-8")):
            yield f"{path.name} loads {address}: pages must work offline. Vendor the file"


def dead_links(pages: dict[str, Page]) -> Iterator[str]:
    """Links to a page or an anchor that is not there."""
    for page in pages.values():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc or not (parts.path or parts.fragment):
                continue
            target = (
                normpath(f"{dirname(page.name)}/{parts.path}").lstrip("/")
                if parts.path
                else page.name
            )
            if not target.endswith(".html"):
                continue
            anchor = unquote(parts.fragment)
            if target not in pages or (anchor and anchor not in pages[target].ids):
                yield f"{page.name}: {link} leads nowhere. Correct the link"


def on_build_finished(app: Sphinx, error: Exception | None) -> None:
    """Check all pages of a finished build."""
    if error is not None or app.builder.format != "html":
        return
    pages = read_pages(Path(app.outdir))
    spec = app.woven.spec  # type: ignore[attr-defined]
    items = {id: any(key in item.data for key in _FORMAL) for id, item in spec.items.items()}
    logger = logging.getLogger(__name__)
    for fault in chain(
        missing_items(pages, items),
        loads_from_elsewhere(pages),
        styles_from_elsewhere(Path(app.outdir)),
        dead_links(pages),
    ):
        logger.warning(fault)
