"""Plots are drawn black on white, and turned over where pages are dark: their class says which."""

import re
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[2] / "docs"
PICTURE = re.compile(r"^```\{(?:figure|image)\} (\S+)\n((?::.*\n)*)", re.MULTILINE)
DARK = {"pictures/viewer.png"}
"""Pictures of what is dark itself."""


@pytest.mark.parametrize("page", sorted(DOCS.glob("*.md")), ids=lambda page: page.stem)
def test_every_plot_of_a_page_is_turned_over_in_the_dark(page: Path) -> None:
    text = page.read_text()
    assert "![" not in text  # it cannot have a class
    for path, options in PICTURE.findall(text):
        assert path in DARK or ":class: plot" in options, path
