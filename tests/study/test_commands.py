"""The command `tradeoff`, and `tools.measure`."""

import json
import signal
import subprocess
import sys
from pathlib import Path

import jsonschema
import pytest
from typer.testing import CliRunner

from tamias2d import cli
from tamias2d.commands import tradeoff as command
from tamias2d.scene import Scene
from tamias2d.study.report import schema
from tamias2d.study.work_precision import Study


@pytest.fixture
def told(studied: Study, monkeypatch: pytest.MonkeyPatch) -> Study:
    """The command has a study to show, whatever the scene."""
    monkeypatch.setattr(command, "study", lambda scene, **asked: studied)  # noqa: ARG005
    return studied


def test_tradeoff_prints_every_point_and_marks_the_front(told: Study) -> None:
    result = CliRunner().invoke(cli.app, ["tradeoff", "tc3", "--tolerance", "1e-6"])
    assert result.exit_code == 0, result.stderr
    lines = result.stdout.splitlines()
    assert sum(line.startswith(("f ", "sf ", "s ")) for line in lines) == 1
    rows = [line for line in lines if "steps" in line or "rtol" in line or "ClosedForm" in line]
    assert len(rows) >= len(told.points)
    assert any("Yoshida4" in line and "grow by the factor" in line for line in lines)
    assert "within 1e-06" in result.stdout
    refused = [line for line in lines if line.startswith("Pymunk") and ": " in line]
    assert len(refused) == len({line.partition(": ")[2] for line in refused})


def test_tradeoff_answers_machines_by_its_schema(told: Study, tmp_path: Path) -> None:
    path = tmp_path / "front.png"
    result = CliRunner().invoke(cli.app, ["tradeoff", "tc3", "--json", "--plot", str(path)])
    assert result.exit_code == 0, result.stderr
    found = json.loads(result.stdout, parse_constant=pytest.fail)
    jsonschema.validate(found, schema())
    assert len(found["points"]) == len(told.points)
    assert path.read_bytes().startswith(b"\x89PNG")


def test_tradeoff_keeps_what_was_computed(monkeypatch: pytest.MonkeyPatch) -> None:
    real = command.study

    def stopped(scene: Scene, **asked: object) -> Study:
        def stop(of: int, done: int, what: str) -> None:  # noqa: ARG001
            if done == 2:
                raise KeyboardInterrupt

        return real(scene, **{**asked, "told": stop, "timed": False})  # type: ignore[arg-type]

    monkeypatch.setattr(command, "study", stopped)
    result = CliRunner().invoke(cli.app, ["tradeoff", "tc3"])
    assert result.exit_code == cli.INTERRUPTED
    assert "ExplicitEuler" in result.stdout
    assert "the 2 points so far" in result.stderr


_STOPPED = """
import signal, sys
from tamias2d import cli
from tamias2d.commands import tradeoff
from tamias2d.study import work_precision

def told(what):
    def call(*words, **more):
        print("begun", file=sys.stderr, flush=True)
        return what(*words, **more)
    return call

if sys.argv[1] == "early":
    tradeoff.stepped_because = told(tradeoff.stepped_because)
else:
    work_precision.point_of = told(work_precision.point_of)
signal.signal(signal.SIGINT, signal.default_int_handler)  # what runs in the background ignores it
cli.app(["tradeoff", *sys.argv[2:]])
"""


@pytest.mark.skipif(sys.platform == "win32", reason="Ctrl-C cannot be sent to one process there")
@pytest.mark.parametrize(
    ("when", "scene", "says"),
    [
        ("early", "gear-train", "Interrupted before the first point: nothing was measured yet."),
        ("late", "kepler", "Interrupted: the 3 points so far are shown."),
    ],
)
def test_one_press_of_ctrl_c_ends_it(when: str, scene: str, says: str) -> None:
    """Else they would take minutes. No time decides: what does not end is killed."""
    with subprocess.Popen(
        [sys.executable, "-c", _STOPPED, when, scene],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as asked:
        assert asked.stderr is not None
        for _ in range(1 if when == "early" else 4):
            assert asked.stderr.readline() == "begun\n"
        asked.send_signal(signal.SIGINT)
        out, err = asked.communicate()
    assert asked.returncode == cli.INTERRUPTED
    assert err.splitlines()[-1] == says
    assert "Traceback" not in err
    assert ("ExplicitEuler" in out) == (when == "late")


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["nowhere"], "must be a name of the catalogue"),
        (["tc3", "--tolerance", "0"], "must lie between 0 and 1"),
        (["tc3", "--duration", "-1 s"], "duration"),
    ],
)
def test_tradeoff_refuses_in_one_line(words: list[str], says: str) -> None:
    result = CliRunner().invoke(cli.app, ["tradeoff", *words])
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert says in result.stderr


def test_measure_names_its_measurements() -> None:
    asked = [sys.executable, "-m", "tools.measure", "nothing"]
    done = subprocess.run(asked, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    for name in ("drift", "peers", "specialisation"):
        assert name in done.stderr
