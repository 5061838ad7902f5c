"""Formulas, schemes and links as the pages print them."""

from pathlib import Path
from typing import Any

import pytest

from tamias2d.spec.chapter import Item
from tamias2d.spec.specification import Specification
from tamias2d.spec.symbols import Symbol, SymbolTable

pytest.importorskip("sphinx")
formulas = pytest.importorskip("weave.formulas")
links = pytest.importorskip("weave.links")
schemes = pytest.importorskip("weave.schemes")
woven_module = pytest.importorskip("weave.woven")


def item_of(kind: str, id: str, data: dict[str, Any]) -> Item:
    return Item(kind, id, "A title", "srs/a.md", 1, data, {}, [])


@pytest.fixture
def woven(tmp_path: Path) -> object:
    (tmp_path / "srs").mkdir()
    (tmp_path / "srs/references.bib").write_text("@book{newton1687,\n}\n", encoding="utf-8")
    symbols = [Symbol("mass", "kg", "mass", tex="m"), Symbol("length", "m", "length", tex="l")]
    item = item_of("model", "IM1", {})
    return woven_module.Woven(tmp_path, Specification({"IM1": item}, SymbolTable(symbols)), {}, {})


def test_a_short_equation_stays_on_its_line(woven: object) -> None:
    assert formulas.equation(woven, "mass", "length + 1") == "m & = l + 1"


def test_a_wide_sum_is_broken_between_its_terms(woven: object) -> None:
    text = " - ".join(["123456789*mass*length"] * 8)
    lines = formulas.equation(woven, "mass", text).split(r" \\ & \quad ")
    assert len(lines) > 1
    assert all(line.strip().startswith("-") for line in lines[1:])
    assert sum(line.count("123456789") for line in lines) == 8


def test_a_condition_is_an_equivalence(woven: object) -> None:
    text = formulas.equation(woven, "overlap", "mass <= 1 and length <= 2")
    assert text.startswith(r"\mathrm{overlap} & \iff m \le 1")
    assert r"\land" in text


def test_ids_and_books_in_text_become_links(woven: object) -> None:
    text = links.linked("see IM1, IM2 (newton1687) and (page 3)", woven)
    assert text == "see {srs}`IM1`, IM2 {cite}`newton1687` and (page 3)"


def test_ids_are_sorted_by_kind_and_number() -> None:
    found = sorted(["TC10", "R10", "TC2", "A1", "R2", "OB8b", "OB8a"], key=links.rank)
    assert found == ["A1", "R2", "R10", "TC2", "TC10", "OB8a", "OB8b"]


def test_a_runge_kutta_scheme_is_a_tableau() -> None:
    data = {
        "family": "runge_kutta", "order": "2", "says": "x", "source": ["x"],
        "a": [[], ["1/2"]], "b": ["0", "1"], "c": ["0", "1/2"],
    }  # fmt: skip
    text = "\n".join(schemes.parts(item_of("scheme", "midpoint", data)))
    assert r"0 &  & " in text
    assert r"\tfrac{1}{2} & \tfrac{1}{2} & " in text
    assert r"\hline  & 0 & 1" in text
