"""One tiny chapter for each check: it must give exactly one message, at its place."""

import re
from pathlib import Path

import pytest

from tamias2d.errors import SpecError
from tamias2d.spec.chapter import read_chapter
from tamias2d.spec.messages import Code
from tamias2d.spec.reader import read

HERE = Path(__file__).parent
CHAPTERS = sorted((HERE / "bad").glob("*.md"))


def faults(chapter: Path, folder: Path) -> list[str]:
    (folder / "srs").mkdir()
    (folder / "srs" / "0_symbols.md").write_text((HERE / "symbols.md").read_text())
    (folder / "srs" / chapter.name).write_text(chapter.read_text())
    try:
        read(folder / "srs")
    except SpecError as error:
        return str(error).splitlines()
    return []


def expected(chapter: Path) -> str:
    match = re.match(r"<!-- (.*) -->", chapter.read_text())
    assert match, f"{chapter.name} does not say what it expects"
    return match.group(1)


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda path: path.stem)
def test_a_bad_chapter_gives_one_message(chapter: Path, tmp_path: Path) -> None:
    found = faults(chapter, tmp_path)
    want = expected(chapter)
    if not want:
        assert found == []
        return
    place, code = want.split()
    assert len(found) == 1, found
    assert found[0].startswith(f"srs/{chapter.name}:{place}: {code}: "), found[0]


def test_every_code_has_its_chapter() -> None:
    shown = {want.split()[1] for path in CHAPTERS if (want := expected(path))}
    elsewhere = {Code.UNREADABLE.code}  # test_unreadable_chapter
    assert shown | elsewhere == {code.code for code in Code}


def test_unreadable_chapter(tmp_path: Path) -> None:
    (tmp_path / "srs").mkdir()
    (tmp_path / "srs" / "latin.md").write_bytes("# Café\n\nÀ la carte, caf".encode() + b"\xe9\n")
    with pytest.raises(SpecError, match=r"^srs/latin.md:3:16: unreadable: found byte 0xe9: "):
        read(tmp_path / "srs")


def test_a_directory_is_no_chapter(tmp_path: Path) -> None:
    (tmp_path / "srs" / "adir.md").mkdir(parents=True)
    with pytest.raises(SpecError, match=r"^srs/adir.md:1:1: unreadable: a directory: "):
        read(tmp_path / "srs")


def test_a_chapter_may_begin_with_a_byte_order_mark(tmp_path: Path) -> None:
    (tmp_path / "marked.md").write_text("# Marked\n", encoding="utf-8-sig")
    chapter = read_chapter(tmp_path / "marked.md", "marked.md")
    assert (chapter.title, chapter.faults) == ("Marked", [])


@pytest.mark.parametrize("text", ["", "\n", "#\n", "## Section\n", "```text\n# Code\n```\n"])
def test_a_chapter_without_title_is_refused(text: str, tmp_path: Path) -> None:
    (tmp_path / "bare.md").write_text(text)
    faults = read_chapter(tmp_path / "bare.md", "bare.md").faults
    assert [str(fault)[:24] for fault in faults] == ["bare.md:1:1: bad-heading"]


def test_empty_folder(tmp_path: Path) -> None:
    with pytest.raises(SpecError, match="no chapter"):
        read(tmp_path)


def test_all_faults_are_reported_together(tmp_path: Path) -> None:
    chapters = [HERE / "bad" / name for name in ("unit_mismatch.md", "dangling_link.md")]
    (tmp_path / "srs").mkdir()
    for source in (*chapters, HERE / "symbols.md"):
        (tmp_path / "srs" / source.name).write_text(source.read_text())
    with pytest.raises(SpecError) as caught:
        read(tmp_path / "srs")
    assert len(str(caught.value).splitlines()) == 2


@pytest.mark.parametrize(
    ("chapter", "first"), [("duplicate_symbol", "srs/0_symbols.md:4"), ("duplicate_index", ":19")]
)
def test_a_second_declaration_names_the_first(chapter: str, first: str, tmp_path: Path) -> None:
    found = faults(HERE / "bad" / f"{chapter}.md", tmp_path)
    assert f"{first}. Remove one" in found[0]
