"""`tools/dev` sets its environment up when it must, and only then.

A pretended Python takes the place of the real one: it notes its arguments, and "makes" virtual
environments by copying itself.
"""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from tools import generate

ROOT = Path(__file__).parents[2]
PRETENDED = """\
#!/bin/sh
echo "$(basename "$(dirname "$0")")/$(basename "$0") $*" >>"$CALLS"
case $* in
*"-m pip"*) exit "${PIP_FAILS:-0}" ;;
*"-m venv"*) for last; do :; done; mkdir -p "$last/bin"; cp "$0" "$last/bin/python" ;;
esac
"""
TOOLS = ("sh", "dirname", "basename", "cksum", "rm", "mkdir", "cp", "cat")


class House:
    """A checkout with a blank in its path, and a machine with one pretended Python."""

    def __init__(self, place: Path) -> None:
        self.root = place / "a house"
        self.calls = place / "calls"
        self.bin = place / "bin"
        (self.root / "tools").mkdir(parents=True)
        self.bin.mkdir()
        shutil.copy(ROOT / "tools" / "dev", self.root / "tools" / "dev")
        (self.root / "pyproject.toml").write_text("[project]\n")
        for tool in TOOLS:
            (self.bin / tool).symlink_to(shutil.which(tool) or tool)
        self.python = self.bin / "python3.12"
        self.python.write_text(PRETENDED)
        self.python.chmod(0o755)

    def dev(self, *arguments: str, **environment: str) -> tuple[int, list[str], str]:
        """Exit code, what Python was called for, and what was said."""
        self.calls.write_text("")
        done = subprocess.run(
            [str(self.root / "tools" / "dev"), *arguments],
            env={"PATH": str(self.bin), "CALLS": str(self.calls), **environment},
            cwd=self.bin,
            capture_output=True,
            text=True,
        )
        return done.returncode, self.calls.read_text().splitlines(), done.stderr

    @property
    def installs(self) -> str:
        return f"bin/python -m pip install --quiet --editable {self.root}"


@pytest.fixture
def house(tmp_path: Path) -> House:
    if os.name != "posix":
        pytest.skip("a POSIX shell script")
    return House(tmp_path.resolve())


def test_the_first_call_sets_up_and_the_next_does_not(house: House) -> None:
    code, calls, _ = house.dev("scenes", "--json")
    assert code == 0
    assert f"{house.installs}[record,plot]" in calls
    assert calls[-1] == "bin/python -m tamias2d scenes --json"
    assert house.dev("python", "-c", "1")[1] == ["bin/python -c 1"]


def test_the_tests_need_more_than_the_demo(house: House) -> None:
    house.dev("demo")
    assert f"{house.installs}[dev]" in house.dev("test")[1]
    assert house.dev("demo")[1] == [
        f"bin/python -m tamias2d run showcase --record {house.root}/build/showcase.rrd"
    ]


def test_changed_requirements_bring_it_up_to_date(house: House) -> None:
    house.dev("test")
    (house.root / "pyproject.toml").write_text("[project]\nname = 'x'\n")
    calls = house.dev("scenes")[1]
    assert f"{house.installs}[dev]" in calls
    assert not [call for call in calls if "-m venv" in call]


def test_half_a_set_up_is_made_anew(house: House) -> None:
    code, _, said = house.dev("scenes", PIP_FAILS="1")
    assert code == 2
    assert "could not be installed" in said
    code, calls, _ = house.dev("scenes")
    assert code == 0
    assert [call for call in calls if "-m venv --clear" in call]


def test_an_environment_that_somebody_made_is_kept(house: House) -> None:
    (house.root / ".venv" / "bin").mkdir(parents=True)
    shutil.copy(house.python, house.root / ".venv" / "bin" / "python")
    calls = house.dev("scenes")[1]
    assert f"{house.installs}[record,plot]" in calls
    assert not [call for call in calls if "-m venv" in call]


def test_a_moved_checkout_is_made_anew(house: House) -> None:
    house.dev("scenes")
    house.root = house.root.rename(house.root.with_name("another house"))
    calls = house.dev("scenes")[1]
    assert [call for call in calls if "-m venv --clear" in call]
    assert f"{house.installs}[record,plot]" in calls


def test_without_python_it_says_what_to_do(house: House) -> None:
    house.python.unlink()
    code, _, said = house.dev("scenes")
    assert code == 2
    assert "no Python 3.11 or later found. Install one" in said


def test_a_failing_check_fails_and_all_are_listed(house: House) -> None:
    house.python.write_text(PRETENDED.replace("esac", '*"-m pytest"*) exit 1 ;;\nesac'))
    for tool in ("date", "id"):
        (house.bin / tool).symlink_to(shutil.which(tool) or tool)
    code, calls, _ = house.dev("test")
    assert code == 1
    assert "bin/python -m tamias2d trace" in calls


@pytest.mark.parametrize("module", ["tools.generate", "pytest", "mypy"])
def test_modules_of_the_tools_need_more_than_the_demo(house: House, module: str) -> None:
    house.dev("demo")
    calls = house.dev("python", "-m", module)[1]
    assert f"{house.installs}[dev]" in calls
    assert calls[-1] == f"bin/python -m {module}"


def test_the_generator_can_be_interrupted(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def stop(_: Path) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(generate, "read", stop)
    assert generate.main(["--check"]) == 130
    assert capsys.readouterr().err == "Interrupted.\n"


def test_the_generator_says_what_it_lacks(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(generate.importlib.util, "find_spec", lambda _: None)
    assert generate.main(["--check"]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert "ruff is not installed" in said
