"""Each package has a page, small enough to read, and links lead to the page of a module."""

from pathlib import Path

import pytest

modules = pytest.importorskip("weave.modules", reason="needs Sphinx")
mirror = pytest.importorskip("weave.mirror", reason="needs Sphinx")

PACKAGE = Path(__file__).parents[2] / "src/tamias2d"
FOLDERS = modules.folders(PACKAGE)


def test_each_module_stands_on_one_page() -> None:
    listed = [module.name for inside in FOLDERS.values() for module in inside]
    assert sorted(listed) == sorted(module.name for module in modules.modules(PACKAGE))


def test_a_package_begins_its_page() -> None:
    assert all(inside[0].name == folder for folder, inside in FOLDERS.items())


def test_a_link_leads_to_the_page_of_a_module() -> None:
    assert (
        modules.page_of("tamias2d.engine.joints.all_stages", PACKAGE) == "internals/engine-joints"
    )
    assert modules.page_of("tamias2d.engine.joints", PACKAGE) == "internals/engine-joints"
    assert modules.page_of("tamias2d.trace", PACKAGE) == "internals/tamias2d"


def test_each_package_has_a_page() -> None:
    pages = mirror.package_pages(PACKAGE)
    assert len(pages) == len(FOLDERS)
    assert pages[Path("engine-joints.md")].startswith(b"# `tamias2d.engine.joints`\n")


def test_the_guide_links_each_package() -> None:
    guide = modules.guide(PACKAGE)
    assert all(f"{{package}}`{folder}`" in guide for folder in FOLDERS)
