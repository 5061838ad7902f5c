"""The module guide has a sentence for each module, a service and a secret for each package."""

import ast
import re
from pathlib import Path

import pytest

import tamias2d

weave = pytest.importorskip("weave.modules", reason="needs Sphinx")

interface = pytest.importorskip("weave.interface")
PACKAGE = Path(__file__).parents[2] / "src/tamias2d"
EVERY = list(weave.modules(PACKAGE))


WRITTEN = [module for module in EVERY if ".generated" not in module.name]
PACKAGES = [
    module
    for module in WRITTEN
    if module.path.name == "__init__.py" and module.name.count(".") == 1
]


@pytest.mark.parametrize("module", WRITTEN, ids=lambda module: module.name)
def test_a_module_says_in_a_sentence_what_it_is(module: object) -> None:
    assert module.summary.endswith("."), f"{module.name}: its docstring begins with a sentence"


@pytest.mark.parametrize("package", PACKAGES, ids=lambda package: package.name)
def test_a_package_says_what_it_serves_and_what_it_hides(package: object) -> None:
    service, secret = package.service_and_secret
    assert service, f"{package.name}: its docstring needs a sentence 'Serves: ...'"
    assert secret, f"{package.name}: its docstring needs a sentence 'Hides: ...'"


def test_service_and_secret_are_read_from_a_docstring() -> None:
    tree = ast.parse('"""What it is.\n\nServes: a, b\nand c. Hides: how. More words.\n\nMore."""')
    module = weave.Module("m", Path("m.py"), tree)
    assert module.summary == "What it is."
    assert module.service_and_secret == ("a, b and c.", "how.")


def test_a_long_signature_is_broken_at_its_arguments() -> None:
    text = "def f(a: dict[str, tuple[int, int]], *, " + "b" * 60 + ": int = 1) -> None: ..."
    (node,) = interface.public(ast.parse(text))
    lines = interface.signature(node).splitlines()
    assert lines[0] == "f("
    assert lines[1] == "    a: dict[str, tuple[int, int]],"
    assert lines[-1] == ") -> None"


def test_the_interface_page_has_every_public_name_once() -> None:
    page = (PACKAGE.parents[1] / "docs/interface.md").read_text(encoding="utf-8")
    listed = " ".join(re.findall(r"```\{interface\}\n(.*?)```", page, re.S)).split()
    assert sorted(listed) == sorted(tamias2d._HOME_OF)


@pytest.mark.parametrize("name", sorted(tamias2d._HOME_OF))
def test_a_public_name_is_declared_and_described(name: str) -> None:
    text = "\n".join(interface.public_name(name, EVERY))
    assert name in text or name == "catalogue"
    assert len(text.splitlines()) > 3


def test_members_of_a_base_are_shown_with_the_class() -> None:
    text = "\n".join(interface.public_name("Simulator", EVERY))
    assert "`step(" in text  # its own
    assert "property velocity" in text  # of `Views`
