"""The checks of finished pages, each on a good page and on one that it must find fault with."""

from pathlib import Path

import pytest

weave = pytest.importorskip("weave.checks", reason="needs Sphinx")

GOOD = """
<script src="_static/mathjax/tex-svg-full.js"></script>
<section id="rest"><a href="#IM1">IM1</a> <a href="https://example.org/">a source</a>
<section id="IM1"><div class="math notranslate">a</div></section></section>
"""


def pages(folder: Path, **texts: str) -> dict[str, object]:
    for name, text in texts.items():
        (folder / f"{name}.html").write_text(text, encoding="utf-8")
    return weave.read_pages(folder)


def test_a_good_page_passes(tmp_path: Path) -> None:
    found = pages(tmp_path, good=GOOD)
    assert not list(weave.missing_items(found, {"IM1": True}))
    assert not list(weave.loads_from_elsewhere(found))
    assert not list(weave.dead_links(found))


def test_an_item_without_a_page_is_found(tmp_path: Path) -> None:
    found = pages(tmp_path, good=GOOD)
    (fault,) = weave.missing_items(found, {"IM2": False})
    assert "IM2 stands 0 times" in fault


def test_an_item_on_two_pages_is_found(tmp_path: Path) -> None:
    found = pages(tmp_path, good=GOOD, twin=GOOD)
    (fault,) = weave.missing_items(found, {"IM1": False})
    assert "IM1 stands 2 times" in fault


def test_an_item_without_its_formula_is_found(tmp_path: Path) -> None:
    text = '<section id="IM1"></section><section id="x"><div class="math">a</div></section>'
    (fault,) = weave.missing_items(pages(tmp_path, page=text), {"IM1": True})
    assert "IM1 has no formula" in fault


@pytest.mark.parametrize(
    "load",
    [
        '<script src="https://example.org/mathjax.js"></script>',
        '<link rel="stylesheet" href="//example.org/font.css">',
        '<img src="http://example.org/a.png">',
    ],
)
def test_a_load_from_elsewhere_is_found(tmp_path: Path, load: str) -> None:
    (fault,) = weave.loads_from_elsewhere(pages(tmp_path, page=load))
    assert "example.org" in fault


@pytest.mark.parametrize(
    "style",
    [
        "a { background: url('https://example.org/a.png') }",
        "@import '//example.org/font.css';",
        "@import url(http://example.org/font.css);",
    ],
)
def test_a_style_from_elsewhere_is_found(tmp_path: Path, style: str) -> None:
    (tmp_path / "page.css").write_text("a { background: url(a.png) }\n" + style, encoding="utf-8")
    (fault,) = weave.styles_from_elsewhere(tmp_path)
    assert "example.org" in fault


@pytest.mark.parametrize("link", ["#IM9", "good.html#IM9", "gone.html"])
def test_a_dead_link_is_found(tmp_path: Path, link: str) -> None:
    found = pages(tmp_path, good=GOOD, page=f'<a href="{link}">x</a>')
    (fault,) = weave.dead_links(found)
    assert f"{link} leads nowhere" in fault
