"""Traceability is told item by item: no table has a column for each item."""

import re
from pathlib import Path

import pytest

lists = pytest.importorskip("weave.traceability", reason="needs Sphinx")
woven_module = pytest.importorskip("weave.woven", reason="needs Sphinx")

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def woven() -> object:
    return woven_module.weave(ROOT)


def test_a_requirement_names_what_it_rests_on_and_its_cases(woven: object) -> None:
    text = lists.demand(woven.spec.items["R5"], woven)
    assert text.startswith("::::::{dropdown} R5 Translation over time: ")
    assert "* - {srs}`IM1`\n  - Translation of a body\n" in text
    assert "*Cases:* {srs}`TC1`" in text


def test_a_change_touches_what_names_the_item(woven: object) -> None:
    text = lists.dependents(woven.spec.items["IM5"], woven)
    (head,) = re.findall(r"\{dropdown\} (.*)", text)
    direct, every = map(int, re.findall(r"\d+", head)[-2:])
    assert 0 < direct <= every == len(woven.graph.dependents("IM5"))
    assert text.count("{srs}`") == direct + 1


def test_an_item_that_nothing_names_has_no_line(woven: object) -> None:
    assert lists.dependents(woven.spec.items["TC1"], woven) == ""
