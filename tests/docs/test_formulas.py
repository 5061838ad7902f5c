"""Formulas, schemes and links as the pages print them."""

from pathlib import Path
from types import SimpleNamespace
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


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("the impulse of {srs}`IM3`, twice ({srs}`A4`).", "the impulse of IM3, twice (A4)."),
        ("see {doc}`the models\n  <srs/models>`, `x < y`", "see the models, `x < y`"),
        ("{cite}`newton1687`", "newton1687"),
    ],
)
def test_a_tooltip_has_no_roles(text: str, plain: str) -> None:
    assert links.without_roles(text) == plain


def test_the_tooltip_of_a_link_says_the_item_without_roles() -> None:
    item = item_of("definition", "DD5", {"says": "the impulse of {srs}`IM3`."})
    spec = SimpleNamespace(items={"DD5": item})
    builder = SimpleNamespace(get_relative_uri=lambda _here, there: there)
    env = SimpleNamespace(
        app=SimpleNamespace(woven=SimpleNamespace(spec=spec), builder=builder), docname="here"
    )
    role = links.ItemRole()
    role.text = "DD5"
    role.inliner = SimpleNamespace(
        document=SimpleNamespace(settings=SimpleNamespace(env=env)), reporter=None
    )
    (link,), faults = role.run()
    assert not faults
    assert link["reftitle"] == "A title. the impulse of IM3."


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


LONG = " + ".join(["123456789*mass*length"] * 8)


def fits(formula: str) -> bool:
    lines = formula.split(r"\\")
    return len(lines) > 1 and all(formulas._length(line) <= 1.5 * formulas.WIDTH for line in lines)


@pytest.mark.parametrize(
    "text",
    [
        f"length*({LONG})",
        f"({LONG})/mass",
        f"({LONG})*(1 + mass)",
        f"-({LONG})",
        f"dot({LONG}, ({LONG}))",
        f"vector({LONG}, {LONG})",
        f"1 - ({LONG})",
        f"1 + length*(2 - mass*({LONG}))",
    ],
)
def test_a_wide_bracket_is_broken_inside(woven: object, text: str) -> None:
    formula = formulas.equation(woven, "mass", text)
    assert fits(formula), formula
    assert formula.count(r"\Bigl(") == formula.count(r"\Bigr)") > 0
    assert formula.count("123456789") == text.count("123456789")


def test_a_decimal_of_many_digits_is_no_fraction(woven: object) -> None:
    """17 digits are more than a float keeps apart from its neighbours."""
    assert formulas.equation(woven, "mass", "1.1781436183311983*length") == (
        r"m & = 1.1781436183311983 \, l"
    )


def test_a_tableau_of_long_numbers_is_a_list() -> None:
    third = "0.333333333333333333"
    data = {
        "family": "runge_kutta", "order": "2", "says": "x", "source": ["x"],
        "a": [[], [third], ["0", third]], "b": ["1/4", "0", "3/4"], "c": ["0", third, third],
    }  # fmt: skip
    text = "\n".join(schemes.parts(item_of("scheme", "heun_3", data)))
    assert r"c_{3} &= 0.333333333 & \quad a_{3,2} &= 0.333333333" in text
    assert r"b_{1} &= \tfrac{1}{4} & \quad b_{3} &= \tfrac{3}{4}" in text
    assert "a_{3,1}" not in text
    assert "Rounded to nine digits" in text
