"""Text of a chapter stays text where code is generated from it, whatever it is."""

import ast
import shutil
from pathlib import Path

import pytest
from hypothesis import given, strategies as st

from tamias2d.errors import SpecError
from tamias2d.spec.reader import read
from tools import generate
from tools.quoting import docstring


@given(st.lists(st.text(st.characters(codec="utf-8")), min_size=1, max_size=3))
def test_a_docstring_holds_any_text(lines: list[str]) -> None:
    source = "def f():\n" + "\n".join(docstring(lines))
    (function,) = ast.parse(source).body
    assert isinstance(function, ast.FunctionDef)
    assert len(function.body) == 1
    said = ast.get_docstring(function, clean=False)
    assert said is not None
    for line in lines:
        if line.strip().isprintable():
            assert line.strip() in said


RAW = 'a\\"""; __import__("os").mkdir("run"); """ \\ "'
IN_YAML = RAW.replace("\\", "\\\\").replace('"', '\\"')
PLACES = {  # what stands in a chapter, and what is put there
    "meaning of a symbol": ("symbols.md", "  says: mass of", f'  says: "{IN_YAML}" # '),
    "title of a model": ("models/translation.md", "{model} IM1 ", "{model} IM1 " + RAW),
    "validity of a closed form": ("models/translation.md", "  when: ", f'  when: "{IN_YAML}" # '),
    "title of a scheme": ("schemes/verlet.md", "} velocity_verlet ", "} velocity_verlet " + RAW),
    "title of a case": ("verification/translation.md", "{case} TC1 ", "{case} TC1 " + RAW),
}


def test_no_text_of_a_chapter_becomes_code(tmp_path: Path) -> None:
    shutil.copytree(generate.ROOT / "srs", tmp_path / "srs")
    for file, old, new in PLACES.values():
        chapter = tmp_path / "srs" / file
        text = chapter.read_text(encoding="utf-8")
        assert old in text, file
        chapter.write_text(text.replace(old, new, 1), encoding="utf-8")
    found = 0
    for path, text in generate.outputs(read(tmp_path / "srs")).items():
        found += text.count("__import__")
        if path.endswith(".py"):
            names = {node.id for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Name)}
            assert "__import__" not in names, path
    assert found >= len(PLACES)


def test_one_fault_of_form_gives_one_message(tmp_path: Path) -> None:
    """And not one for each item that would have been linked to."""
    shutil.copytree(generate.ROOT / "srs", tmp_path / "srs")
    chapter = tmp_path / "srs/models/translation.md"
    chapter.write_text(chapter.read_text(encoding="utf-8").replace("input: [", "input: [[", 1))
    with pytest.raises(SpecError) as caught:
        read(tmp_path / "srs")
    assert len(str(caught.value).splitlines()) == 1
    assert str(caught.value).startswith("srs/models/translation.md:")
