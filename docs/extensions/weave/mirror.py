"""Copies the chapters of srs/ into docs/srs/, where Sphinx can read them.

Serves: one page a chapter. Hides: which copies are stale or orphaned.
"""

from pathlib import Path

from sphinx.application import Sphinx


def mirror(source: Path, target: Path) -> None:
    """Make target hold exactly the chapters of source; touch only what differs."""
    chapters = {path.relative_to(source): path.read_bytes() for path in source.rglob("*.md")}
    for path in target.rglob("*.md"):
        if path.relative_to(target) not in chapters:
            path.unlink()
    for name, content in chapters.items():
        copy = target / name
        if not copy.is_file() or copy.read_bytes() != content:
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_bytes(content)


def on_builder_inited(app: Sphinx) -> None:
    """Bring docs/srs/ up to date before Sphinx looks for pages."""
    mirror(Path(app.srcdir).parent / "srs", Path(app.srcdir) / "srs")
