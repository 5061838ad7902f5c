"""The module guide has a service and a secret for each module."""

import ast
from pathlib import Path

import pytest

weave = pytest.importorskip("weave.modules", reason="needs Sphinx")

interface = pytest.importorskip("weave.interface")
PACKAGE = Path(__file__).parents[2] / "src/tamias2d"


def written_by_hand() -> list[object]:
    return [m for m in weave.modules(PACKAGE) if ".generated" not in m.name]


@pytest.mark.parametrize("module", written_by_hand(), ids=lambda module: module.name)
def test_a_module_says_what_it_serves_and_what_it_hides(module: object) -> None:
    service, secret = module.service_and_secret
    assert service, f"{module.name}: its docstring needs a sentence 'Serves: ...'"
    assert secret, f"{module.name}: its docstring needs a sentence 'Hides: ...'"


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
