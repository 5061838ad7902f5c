"""The page on the format of srs/ names every kind, key and word; its example is read and run."""

import json
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tamias2d.errors import SpecError
from tamias2d.spec.comparisons import COMPARISONS
from tamias2d.spec.expression import ARITY, MAX_DEPTH, MAX_LENGTH, MAX_POWER
from tamias2d.spec.kinds import KINDS, LINKS
from tamias2d.spec.messages import Code
from tamias2d.spec.reader import read
from tamias2d.spec.specification import Specification
from tamias2d.spec.units import UNITS
from tamias2d.verify import items as verified_items
from tamias2d.verify.case import Case
from tamias2d.verify.suite import COMPARISONS as JUDGES, judge
from tools.emit_data import emit_json
from tools.emit_functions import functions_by_module

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs/specification_format.md").read_text(encoding="utf-8")
_EXAMPLE = re.compile(r"^````\{code-block\} text\n:caption: (\S+)\n\n(.*?)^````$", re.M | re.S)
Keys = dict[str, dict[str, str]]
"""Kind -> key -> `must` or `may`."""


def tables() -> Iterator[list[list[str]]]:
    """All tables of the page: rows of cells, the head first."""
    for block in re.findall(r"(?:^\|.*\n)+", PAGE, re.M):
        rows = [
            [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
            for line in block.splitlines()
        ]
        yield [rows[0], *rows[2:]]


def table(first: str) -> list[list[str]]:
    """The rows below the head of the one table whose head begins so."""
    (found,) = [rows for rows in tables() if rows[0][0] == first]
    return found[1:]


def code_in(cell: str) -> list[str]:
    return re.findall(r"`([^`]+)`", cell)


def keys_on_page() -> Keys:
    found: Keys = {}
    for head, *rows in tables():
        if head[0] == "key":
            kinds = {column: code_in(cell)[0] for column, cell in enumerate(head[1:-1], 1)}
            for row in rows:
                for column, kind in kinds.items():
                    if row[column]:
                        assert row[column] in ("must", "may"), row
                        found.setdefault(kind, {})[code_in(row[0])[0]] = row[column]
    return found


def taken(schema: dict[str, Any]) -> dict[str, str]:
    """The keys of a schema; of a table from names, those of each entry."""
    if "patternProperties" in schema:
        (schema,) = schema["patternProperties"].values()
    return {key: "must" if key in schema["required"] else "may" for key in schema["properties"]}


def words_of(schema: Any) -> Iterator[str]:
    """The words that keys take where only some are allowed."""
    if isinstance(schema, dict):
        yield from schema.get("enum", ())
        for inner in schema.values():
            yield from words_of(inner)


def test_the_page_has_every_kind_with_ids_that_it_takes() -> None:
    rows = table("kind")
    assert [code_in(row[0])[0] for row in rows] == list(KINDS)
    for row in rows:
        kind = KINDS[code_in(row[0])[0]]
        examples = code_in(row[1])
        assert bool(examples) == (kind.ids is not None)
        assert all(map(kind.takes_id, examples)), examples
        for prefix in re.findall("[A-Z]+", (kind.ids or "").replace("[A-Z]", "")):
            assert any(id.startswith(prefix) for id in examples), prefix


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "case"])
def test_the_page_has_every_key_of_a_kind(kind: str) -> None:
    assert keys_on_page()[kind] == taken(KINDS[kind].schema)


def test_the_page_has_every_key_of_a_case() -> None:
    own = {key: need for key, need in taken(KINDS["case"].schema).items() if key not in COMPARISONS}
    assert keys_on_page()["case"] == own


def test_the_page_has_every_comparison_with_its_keys() -> None:
    found = {code_in(row[0])[0]: row for row in table("comparison")}
    assert list(found) == list(COMPARISONS)
    for name, row in found.items():
        keys = taken(COMPARISONS[name])
        stated = dict.fromkeys(code_in(row[1]), "must") | dict.fromkeys(code_in(row[2]), "may")
        if name != "survey":
            stated |= dict.fromkeys(("tolerance", "because", "source"), "must")
        assert stated == keys, name


def test_every_comparison_is_judged() -> None:
    assert set(JUDGES) == set(COMPARISONS)


def test_the_page_has_every_function_with_its_arguments() -> None:
    found = [call for row in table("function") for call in code_in(row[0])]
    arity = {call.partition("(")[0]: call.count(",") + 1 for call in found}
    assert arity == ARITY


def test_the_page_has_every_word_unit_link_and_limit() -> None:
    words = {word for kind in KINDS.values() for word in words_of(kind.schema)}
    words |= {word for comparison in COMPARISONS.values() for word in words_of(comparison)}
    for word in [*words, *UNITS, *LINKS]:
        assert f"`{word}`" in PAGE, word
    for limit in (MAX_LENGTH, MAX_DEPTH, MAX_POWER):
        assert re.search(rf"\b{limit}\b", PAGE), limit


def test_the_page_has_every_module_that_knows_a_key_of_a_scene() -> None:
    package = ROOT / "src/tamias2d"
    known = {
        path.relative_to(package).as_posix()
        for path in package.rglob("*.py")
        if "generated" not in path.parts and "quadratic_drag" in path.read_text(encoding="utf-8")
    }
    assert {file for row in table("module") for file in code_in(row[0])} == known


@pytest.fixture(scope="module")
def chapters(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of srs/ with the example of the page in it."""
    root = tmp_path_factory.mktemp("example")
    shutil.copytree(ROOT / "srs", root / "srs")
    found = _EXAMPLE.findall(PAGE)
    assert len(found) == 3
    for name, text in found:
        with (root / name).open("a", encoding="utf-8") as file:
            file.write(f"\n{text}")
    return root / "srs"


@pytest.fixture(scope="module")
def specification(chapters: Path) -> Specification:
    return read(chapters)


def test_the_example_becomes_functions(specification: Specification) -> None:
    made = functions_by_module(specification)
    assert [function.name for function in made["cubic_drag"]] == ["cubic_drag_force"]
    assert "cubic_drag_power" in [function.name for function in made["definitions"]]


def test_the_case_of_the_example_passes(
    specification: Specification, monkeypatch: pytest.MonkeyPatch
) -> None:
    known = {item["id"]: item for item in json.loads(emit_json(specification, {}))["items"]}
    monkeypatch.setattr(verified_items, "items", lambda: known)
    (id,) = re.findall(r"\{case\} (\w+)", PAGE)
    (outcome,) = judge(Case(known[id]))
    assert outcome.verdict == "pass", outcome


def test_faults_in_the_example_are_found(chapters: Path) -> None:
    file = chapters / "models/cubic_drag.md"
    good = file.read_text(encoding="utf-8")
    bad = good
    for old, new in (
        ("cubic_drag_force: -cubic_drag*", "cubic_drag_force: -2*cubic_drag*"),
        ("cubic_drag_force: [cubic_drag, velocity]", "cubic_drag_force: [mass]"),
        ("uses: [A1, A6", "uses: [A99, A6"),
    ):
        assert old in bad
        bad = bad.replace(old, new, 1)
    file.write_text(bad, encoding="utf-8")
    with pytest.raises(SpecError) as caught:
        read(chapters)
    for code in (Code.DERIVATION_GAP, Code.UNKNOWN_NAME, Code.UNKNOWN_ID):
        assert f": {code.code}: " in str(caught.value)
