"""What the package says of itself agrees, and an index can show it."""

import re
import tomllib
from importlib import metadata
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))


def test_versions_and_authors_agree() -> None:
    cited = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert cited["version"] == PROJECT["project"]["version"] == metadata.version("tamias2d")
    assert cited["authors"] == PROJECT["project"]["authors"]
    assert cited["license"] == PROJECT["project"]["license"]
    changes = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    assert re.findall(r"^## (\S+)", changes, re.M)[0] == cited["version"]


def test_the_origin_is_cited_as_in_the_references() -> None:
    cited = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    books = (ROOT / "srs/references.bib").read_text(encoding="utf-8")
    plain = " ".join(re.sub(r"[{}]", "", books).split())
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    assert len(cited["references"]) == 2
    for origin in cited["references"]:
        assert f"= {origin['title']}, howpublished" in plain
        repository = origin["repository-code"].removeprefix("https://github.com/")
        assert f"GitHub {repository}, year = {origin['year']}" in plain
        assert origin["repository-code"] in readme


def test_the_licence_is_the_one_that_is_named() -> None:
    text = (ROOT / "LICENSE").read_text(encoding="utf-8")
    assert text.startswith("BSD 2-Clause License")
    assert PROJECT["project"]["authors"][0]["name"] in text
    assert PROJECT["project"]["license-files"] == ["LICENSE"]


def test_an_index_gets_no_picture_that_it_cannot_show() -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    assert "](docs/" in readme
    for rule in PROJECT["tool"]["hatch"]["metadata"]["hooks"]["fancy-pypi-readme"]["substitutions"]:
        readme = re.sub(rule["pattern"], rule["replacement"], readme)
    assert re.findall(r"\]\((?!https://)", readme) == []


@pytest.mark.parametrize("page", ["README.md", "docs/tutorial.md", "docs/index.md"])
def test_first_pages_say_how_to_install(page: str) -> None:
    text = (ROOT / page).read_text(encoding="utf-8")
    assert "pip install" in text
    assert "tools/dev" in text
