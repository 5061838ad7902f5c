"""The copies of the chapters follow the chapters."""

from pathlib import Path

import pytest

weave = pytest.importorskip("weave.mirror", reason="needs Sphinx")


def test_copies_follow_what_changed_and_nothing_else(tmp_path: Path) -> None:
    source, target = tmp_path / "srs", tmp_path / "docs"
    (source / "models").mkdir(parents=True)
    same, other = source / "a.md", source / "models/b.md"
    same.write_text("same", encoding="utf-8")
    other.write_text("old", encoding="utf-8")
    weave.mirror(source, target)
    before = (target / "a.md").stat().st_mtime_ns
    other.write_text("new", encoding="utf-8")
    weave.mirror(source, target)
    assert (target / "models/b.md").read_text(encoding="utf-8") == "new"
    assert (target / "a.md").stat().st_mtime_ns == before


def test_an_orphan_is_removed(tmp_path: Path) -> None:
    source, target = tmp_path / "srs", tmp_path / "docs"
    source.mkdir()
    target.mkdir()
    (target / "orphan.md").write_text("x", encoding="utf-8")
    weave.mirror(source, target)
    assert not (target / "orphan.md").exists()
