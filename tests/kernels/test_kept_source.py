"""The source of a library is assembled once, and anew when a file of the package has changed."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from tamias2d.kernels import kept_source as module
from tamias2d.kernels.kept_source import kept_source


class Assembler:
    """Assembles sources, and counts them."""

    def __init__(self) -> None:
        self.count = 0

    def __call__(self) -> str:
        self.count += 1
        return f"source {self.count}"


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A package of two files, and a home of its own."""
    folder = tmp_path / "package"
    (folder / "inner").mkdir(parents=True)
    (folder / "one.py").write_text("one = 1\n")
    (folder / "inner" / "two.py").write_text("two = 2\n")
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path / "home"))
    monkeypatch.setattr(module, "_PACKAGE", folder)
    module._package_key.cache_clear()
    yield folder
    module._package_key.cache_clear()


def again(assemble: Assembler, name: str = "a library") -> str:
    """What another process would get."""
    module._package_key.cache_clear()
    return kept_source(name, assemble)


@pytest.mark.usefixtures("package")
def test_a_source_is_assembled_once() -> None:
    assemble = Assembler()
    assert [again(assemble) for _ in range(3)] == ["source 1"] * 3
    assert again(assemble, "another") == "source 2"


@pytest.mark.parametrize("file", ["one.py", "inner/two.py", "inner/three.py"])
def test_a_change_in_any_file_makes_it_anew(package: Path, file: str) -> None:
    assemble = Assembler()
    again(assemble)
    (package / file).write_text("changed = 0\n")
    assert again(assemble) == "source 2"
    assert again(assemble) == "source 2"


def test_text_that_moves_to_another_file_is_a_change(package: Path) -> None:
    assemble = Assembler()
    again(assemble)
    (package / "one.py").rename(package / "three.py")
    assert again(assemble) == "source 2"


def test_what_is_damaged_is_assembled_anew(package: Path) -> None:
    assemble = Assembler()
    again(assemble)
    (file,) = (package.parent / "home" / "kernels").iterdir()
    whole = file.read_bytes()
    for k, damaged in enumerate((b"", whole[:-1], whole[:-1] + b"x")):
        file.write_bytes(damaged)
        assert again(assemble) == again(assemble) == f"source {k + 2}"


def test_a_package_without_files_keeps_nothing(package: Path) -> None:
    for file in package.rglob("*.py"):
        file.unlink()
    assemble = Assembler()
    assert [again(assemble) for _ in range(2)] == ["source 1", "source 2"]
