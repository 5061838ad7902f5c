"""The module guide has a sentence for each module, a service and a secret for each package."""

import ast
import re
import tomllib
from itertools import pairwise
from pathlib import Path

import pytest

import tamias2d

weave = pytest.importorskip("weave.modules", reason="needs Sphinx")

interface = pytest.importorskip("weave.interface")
public_names = pytest.importorskip("weave.public_names")
ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "src/tamias2d"
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


def test_every_package_has_a_place_in_the_guide() -> None:
    inner = {path.parent.name for path in PACKAGE.glob("*/__init__.py")}
    assert sorted(weave.PARTS) == sorted({"", *inner})


GUIDE = (ROOT / "docs/modules.md").read_text(encoding="utf-8")
FIRST_COLUMN = re.compile(r"^\| (`[^|]+`) \|", re.M)


def rows_of(heading: str) -> list[list[str]]:
    """The names in the first column of all tables under a heading of the guide."""
    text = GUIDE.partition(f"\n## {heading}\n")[2].partition("\n## ")[0]
    return [re.findall(r"`([^`]+)`", cell) for cell in FIRST_COLUMN.findall(text)]


def test_the_guide_lists_the_layers_in_their_order() -> None:
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    (contract,) = (
        one for one in settings["tool"]["importlinter"]["contracts"] if one["type"] == "layers"
    )
    layers = [re.findall(r"\w+", layer) for layer in reversed(contract["layers"])]
    height = {name: k for k, layer in enumerate(layers) for name in layer if name != "__main__"}
    rows = rows_of("Which package may use which")
    assert sorted(name for row in rows for name in row) == sorted(height)
    for below, above in pairwise(rows):
        assert max(map(height.get, below)) <= min(map(height.get, above)), (below, above)


def test_the_guide_lists_each_file_and_folder_of_the_engine() -> None:
    engine = PACKAGE / "engine"
    folders = [f"{path.parent.name}/" for path in engine.glob("*/__init__.py")]
    files = [path.name for path in engine.glob("*.py") if path.name != "__init__.py"]
    listed = [name for row in rows_of("Inside the engine") for name in row]
    assert sorted(listed) == sorted(files + folders)


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
    text = public_names.public_name(name, EVERY)
    assert name in text or name == "catalogue"
    assert len(text.splitlines()) > 3


CLASSES = [name for name in tamias2d._HOME_OF if isinstance(getattr(tamias2d, name), type)]


@pytest.mark.parametrize("name", CLASSES)
def test_every_member_of_a_class_has_an_entry(name: str) -> None:
    kind = getattr(tamias2d, name)
    entries = re.findall(r":::\{py:\w+\} (\w+)", public_names.public_name(name, EVERY))
    foreign = {key for base in kind.__mro__ if base.__module__ == "builtins" for key in dir(base)}
    there = {key for key in dir(kind) if not key.startswith("_") and hasattr(kind, key)}
    members = there - foreign - {"code"}
    assert members <= set(entries)
    assert len(entries) == len(set(entries))


@pytest.mark.parametrize(
    ("name", "head"),
    [
        ("Disc", "Disc(*, radius: float)"),
        ("Dop853", "Dop853(rtol: float = 1e-10, atol: float | None = None, halved: bool = False)"),
        ("Grid", "Grid(*values: Any)"),
        ("JointEvent", "JointEvent(time: float, joint: Called, freedom: int, what: int,"),
        ("Scene", "Scene(*, gravity: VectorLike, name: str='', says: str='', duration: float |"),
        ("Simulator", "Simulator(scene: Scene, *, time_step: float=1 / 60, substeps: int=4,"),
        ("StabilityError", "StabilityError\n"),
    ],
)
def test_a_class_shows_what_it_is_made_with(name: str, head: str) -> None:
    assert f"}} {head}" in public_names.public_name(name, EVERY)


def test_members_of_bases_are_described_with_the_class() -> None:
    run = public_names.public_name("Run", EVERY)
    assert '{py:attribute} notes\n:type: "tuple[str, ...]"' in run  # of `RunData`
    assert '{py:property} reactions\n:type: "Reactions"' in run
    assert "{py:method} load(path: str | Path) -> Run\n:classmethod:" in run
    assert "{py:property} velocity" in public_names.public_name("Simulator", EVERY)  # of `Views`
