"""Keeps the pages that are made at build time: the chapters of srs/, and a page for each package.

Serves: docs/srs/ and docs/internals/. Hides: which copies are stale or orphaned.
"""

from collections.abc import Mapping
from pathlib import Path

from sphinx.application import Sphinx

from weave.modules import folders, page_name


def mirror(source: Path, target: Path) -> None:
    """Make target hold exactly the chapters of source; touch only what differs."""
    keep(target, {path.relative_to(source): path.read_bytes() for path in source.rglob("*.md")})


def keep(target: Path, pages: Mapping[Path, bytes]) -> None:
    """Make target hold exactly these pages; touch only what differs."""
    for path in target.rglob("*.md"):
        if path.relative_to(target) not in pages:
            path.unlink()
    for name, content in pages.items():
        copy = target / name
        if not copy.is_file() or copy.read_bytes() != content:
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_bytes(content)


def package_pages(package: Path) -> dict[Path, bytes]:
    """The pages of a package and of those inside it, each a heading and a fence."""
    return {
        Path(
            f"{page_name(folder)}.md"
        ): f"# `{folder}`\n\n```{{internals}} {folder}\n```\n".encode()
        for folder in folders(package)
    }


def on_builder_inited(app: Sphinx) -> None:
    """Bring docs/srs/ and docs/internals/ up to date before Sphinx looks for pages."""
    docs = Path(app.srcdir)
    mirror(docs.parent / "srs", docs / "srs")
    keep(docs / "internals", package_pages(docs.parent / "src/tamias2d"))
