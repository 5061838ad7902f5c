"""Each command: what it prints, what it answers to machines, and how it refuses."""

import io
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from importlib import metadata
from pathlib import Path
from typing import Any
from warnings import warn

import pytest
from typer.testing import CliRunner, Result

import tamias2d as t2
from tamias2d import cli, motion
from tamias2d.commands import run as run_command
from tamias2d.commands.names import find_method
from tamias2d.commands.output import followed, print_table
from tamias2d.commands.step_warnings import as_lines
from tamias2d.errors import RecordingError, StepWarning
from tamias2d.method_names import METHOD_NAMES
from tamias2d.record import load
from tamias2d.scene import catalogue, needs
from tamias2d.simulate import simulate
from tamias2d.solve import Interrupted
from tamias2d.trace import trace
from tamias2d.verify import case, exact, results
from tamias2d.verify.items import fingerprint, items
from tamias2d.verify.outcome import Outcome

Call = Callable[..., Result]


@pytest.fixture
def call(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Call:
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path / "home"))
    monkeypatch.delenv("TAMIAS2D_COMMAND", raising=False)
    return lambda *words: CliRunner().invoke(cli.app, [str(word) for word in words])


@pytest.fixture
def call_warm(monkeypatch: pytest.MonkeyPatch) -> Call:
    """With the compiled engine that the user has."""
    monkeypatch.delenv("TAMIAS2D_COMMAND", raising=False)
    return lambda *words: CliRunner().invoke(cli.app, [str(word) for word in words])


def answer(result: Result) -> Any:
    """What a machine reads: nothing but JSON."""
    assert result.exit_code == 0, result.stderr
    return json.loads(result.stdout, parse_constant=pytest.fail)


def refused(result: Result) -> str:
    """The one line that a user reads."""
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    return result.stderr


# --- run ---------------------------------------------------------------------------------------


def test_run_prints_state_and_error(call: Call) -> None:
    text = call("run", "tc3").stdout
    assert "ClosedForm(): every force and torque is constant" in text
    assert "(870, 50)" in text
    assert "TC3   position over the whole history" in text


def test_run_answers_with_state_impacts_and_errors(call: Call) -> None:
    found = answer(call("run", "tc3", "--json"))
    assert found["final"]["bodies"][0]["position"] == [870, 50]
    assert found["impacts"] == []
    assert {error["case"] for error in found["errors"]} == {"TC3"}
    assert all(error["error"] <= 1e-12 for error in found["errors"])


BREAKS = """
gravity: [0 m/s^2, -9.81 m/s^2]
duration: 1 s
bodies:
  bob: {shape: none, mass: 2 kg, position: [1 m, 0 m]}
joints:
  - {kind: distance, between: [[0 m, 0 m], bob], break_force: 30 N, name: thread}
"""


def test_run_says_which_energy_it_tells(call: Call) -> None:
    """Of a planet in a field it is the kinetic one, and of a thrown body that and another."""
    for scene, kind in (("kepler", "kinetic"), ("bouncing-disc", "kinetic and potential")):
        assert answer(call("run", scene, "--json"))["final"]["energy_is"] == kind


def test_impacts_in_json_have_no_digits_of_rounding(call: Call) -> None:
    """Where the text has 0; nor is there a zero below zero."""
    text = call("run", "galperin-100", "--json").stdout
    told = "".join(
        str(impact["point"] + impact["normal"]) for impact in json.loads(text)["impacts"]
    )
    assert "e-1" not in told
    assert "-0.0," not in told
    assert "-0.0]" not in told


def test_run_says_what_broke(call: Call, tmp_path: Path) -> None:
    """It bears 3 m g sin a at an angle a below the level: 30 N after 0.332 s."""
    scene = tmp_path / "thread.yaml"
    scene.write_text(BREAKS)
    text = call("run", scene).stdout
    assert "Events of joints: 1:" in text
    (event,) = answer(call("run", scene, "--json"))["joint_events"]
    assert (event["joint"], event["what"]) == ("thread", "breaks")
    assert f"{event['time']:.10g}  thread  breaks" in text
    assert "Events" not in call("run", "tc3").stdout


def test_run_tells_the_error_of_a_poor_method(call: Call) -> None:
    poor = answer(
        call("run", "tc3", "--method", "explicit-euler", "--time-step", "100 ms", "--json")
    )
    assert poor["time_step"] == 0.1
    # explicit Euler lags by a t dt / 2: here 10 m/s^2, 4 s and 0.1 s, on the way to x = 870 m
    assert poor["final"]["bodies"][0]["position"][0] == pytest.approx(870 + 2)
    assert max(error["error"] for error in poor["errors"]) > 1e-4


def test_run_knows_no_error_beyond_the_case(call: Call) -> None:
    assert answer(call("run", "tc3", "--duration", "5", "--json"))["errors"] == []
    assert "no case of the specification" in call("run", "tc3", "--duration", "5 s").stdout


def test_a_file_is_not_taken_for_the_case_of_its_name(call: Call, tmp_path: Path) -> None:
    file = tmp_path / "tc3.yaml"
    file.write_text(
        "name: tc3\ngravity: [0 m/s^2, 0 m/s^2]\n"
        "bodies:\n  body: {shape: none, mass: 1 kg, position: [0 m, 0 m]}\n"
    )
    assert answer(call("run", file, "--duration", "4", "--json"))["errors"] == []


@pytest.mark.parametrize("suffix", [".npz", ".rrd"])
def test_run_keeps_a_recording_that_checks(call: Call, tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"with blank{suffix}"
    text = call("run", "tc3", "--record", path).stdout
    assert f"Look at it: tamias2d replay '{path}'" in text
    checked = call("replay", path, "--check")
    assert checked.exit_code == 0
    assert "identical" in checked.stdout


@pytest.mark.parametrize(
    ("scene", "duration", "samples"),
    [("andrews", "0.03", 241), ("tc1", "1e-9", 241), ("tc3", "3 s", 361), ("tc3", "4.5 s", 271)],
)
def test_a_short_run_is_recorded_as_finely_as_a_long_one(
    call: Call, tmp_path: Path, scene: str, duration: str, samples: int
) -> None:
    path = tmp_path / "run.npz"
    call("run", scene, "--duration", duration, "--record", path)
    assert len(load(path).times) == samples
    assert call("replay", path, "--check").exit_code == 0


def test_run_draws_a_plot(call: Call, tmp_path: Path) -> None:
    assert call("run", "tc3", "--plot", tmp_path / "run.svg").exit_code == 0
    assert (tmp_path / "run.svg").read_text().lstrip().startswith("<?xml")
    assert "suffix '.doc'" in refused(call("run", "tc3", "--plot", tmp_path / "run.doc"))


def test_a_recording_that_was_changed_is_found_out(call: Call, tmp_path: Path) -> None:
    import numpy as np

    path = tmp_path / "run.npz"
    call("run", "tc3", "--record", path)
    arrays = dict(np.load(path))
    arrays["position"][7, 0, 1] += 1e-9
    np.savez(path, **arrays)
    checked = call("replay", path, "--check")
    assert checked.exit_code == 1
    assert "body 'body', position y" in checked.stdout


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["run", "tc33"], "SCENE: 'tc33': must be a name of the catalogue or a file (R1). Did you"),
        (["run", "."], ".: a directory (R2)"),
        (["run", "no/such.yaml"], "no/such.yaml: no such file (R2)"),
        (["run", "tc3", "--duration", "4 kg"], "--duration: '4 kg': must be a time"),
        (["run", "tc3", "--duration", "soon"], "--duration: 'soon': must be a time"),
        (["run", "tc3", "--duration", "-4 s"], "--duration: '-4 s': must be > 0"),
        (["run", "tc3", "--duration", "nan"], "--duration: 'nan': must be finite"),
        (["run", "tc3", "--duration", "inf"], "--duration: 'inf': must be finite"),
        (["run", "tc3", "--time-step", "0"], "--time-step: '0': must be > 0"),
        (["run", "tc3", "--time-step", "1 ms"], "takes no time step"),
        (
            ["run", "tc3", "--method", "runge-kutta-4"],
            "for example --time-step 0.01.",
        ),
        (["run", "driven", "--method", "closed-form"], "varies with time"),
        (["run", "tc3", "--record", "run.txt"], "a run is saved as .rrd"),
        (["replay", "scene.yaml"], "Give a file that `tamias2d run --record`"),
        (["replay", "."], "a directory: a run is saved as .rrd"),
        (["run", "tc3", "--record", ""], "--record: '' or '.': names no file"),
        (["run", "tc3", "--plot", "no/such/run.png"], "there is no directory no/such"),
        (["explain", "."], ".: a directory (R2)"),
        (["verify", "tc1"], "Did you mean 'TC1'?"),
        (["trace", "a6"], "Did you mean 'A6'?"),
        (["run", "tc3", "--record", "no/such/run.npz"], "no/such/run.npz"),
        (["explain", "tc33"], "SCENE: 'tc33'"),
        (["verify", "TC99"], "'TC99' is no item"),
        (["trace", "TC99"], "TC99"),
        (["replay", "no.rrd"], "no.rrd: there is no such file. Make it by `tamias2d run SCENE --r"),
        (["run", "tc3", "--method", "rk4"], "Did you mean runge-kutta-4?"),
        (["run", "tc3", "--method", "leapfrog"], "Did you mean velocity-verlet?"),
        (["run", "kepler", "--quality", "0.01"], "there is nothing to measure (R5). Ask for a tol"),
        (["replay", "no.txt", "--check"], "suffix '.txt'"),
    ],
)
def test_bad_input_is_one_line(call: Call, words: list[str], says: str) -> None:
    assert says in refused(call(*words))


@pytest.mark.parametrize(
    "words",
    [["run"], ["run", "tc3", "--method", "magic"], ["run", "tc3", "--nonsense"], ["nonsense"]],
)
def test_wrong_usage_is_refused(call: Call, words: list[str]) -> None:
    result = call(*words)
    assert result.exit_code == 2
    assert "Traceback" not in result.stderr


def test_a_damaged_scene_names_its_place(call: Call, tmp_path: Path) -> None:
    file = tmp_path / "pile.yaml"
    file.write_text(
        "gravity: [0 m/s^2, -9.81 m/s^2]\nbodies:\n  crate:\n    shape: none\n"
        "    mass: -1 kg\n    position: [0 m, 0 m]\n"
    )
    assert "pile.yaml:5:11: mass -1 kg of" in refused(call("run", file))


@pytest.mark.parametrize("name", ["VelocityVerlet", "velocity_verlet", "VelocityVerlet()"])
def test_a_method_may_be_typed_as_python_has_it(call: Call, name: str) -> None:
    found = answer(call("run", "tc3", "--method", name, "--time-step", "0.1", "--json"))
    assert found["method"] == "VelocityVerlet()"


def test_a_method_with_its_options_is_told_its_name(call: Call) -> None:
    said = refused(call("run", "tc3", "--method", "Dop853(rtol=1e-6)"))
    assert said.startswith("--method: 'Dop853(rtol=1e-6)': must be one of closed-form, ")
    assert said.endswith("Did you mean dop853?\n")


def test_a_warning_is_one_line_and_told_once(capsys: pytest.CaptureFixture[str]) -> None:
    with as_lines():
        for text in ("a", "a", "b"):
            warn(text, StepWarning, stacklevel=1)
    assert capsys.readouterr().err == "a\nb\n"


def test_a_run_tells_in_its_notes_what_was_warned_of(call_warm: Call) -> None:
    result = call_warm("run", "card-house", "--duration", "500 ms")
    assert result.stderr == ""
    assert result.stdout.count("shorter step or more substeps") == 1


LIFT = """\
gravity: [0 m/s^2, -9.81 m/s^2]
duration: 1 s
bodies:
  load: {shape: box, width: 1 m, height: 1 m, mass: 2 kg, position: [0 m, 2 m], restitution: 0}
kinematics:
  lift: {shape: box, width: 3 m, height: 20 cm, position: [0 m, 0 m], velocity: [0 m/s, 1 m/s]}
statics:
  zone: {shape: disc, radius: 1 m, position: [0 m, 1 m], sensor: true}
"""


def test_a_lift_moves_and_a_sensor_pushes_nothing(call_warm: Call, tmp_path: Path) -> None:
    file = tmp_path / "lift.yaml"
    file.write_text(LIFT)
    text = call_warm("run", file).stdout
    assert "1 s, 2 of 3 bodies move\n" in text
    assert "\nlift " in text.partition("State at")[2].partition("Impacts")[0]
    assert "zone" not in text.partition("Impacts")[2].partition("Met by sensors")[0]
    found = answer(call_warm("run", file, "--json"))
    assert all("zone" not in impact["bodies"] for impact in found["impacts"])
    assert {"zone", "load"} in [set(met["bodies"]) for met in found["met_by_sensors"]]


def test_methods_on_the_command_line_are_those_of_the_library() -> None:
    kinds = {type(find_method(method)) for method in METHOD_NAMES}
    public = {kind for kind in vars(motion).values() if isinstance(kind, type)}
    bases = {motion.Method, motion.PathMethod}
    assert kinds == {kind for kind in public - bases if issubclass(kind, motion.Method)}
    assert set(METHOD_NAMES.values()) <= set(dir(t2))


def test_an_interrupted_run_is_kept(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def stopped(*_: Any, **__: Any) -> None:
        raise Interrupted(lambda: simulate(catalogue.load("tc3"), duration=1.0))

    monkeypatch.setattr(run_command, "simulate", stopped)
    result = call("run", "tc3", "--record", tmp_path / "part.npz")
    assert result.exit_code == 130
    assert f"The run up to 1 s is in {tmp_path / 'part.npz'}" in result.stderr
    assert (tmp_path / "part.npz").is_file()


def test_an_interrupted_check_is_no_failed_one(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def stopped(*_: Any, **__: Any) -> None:
        raise Interrupted(lambda: simulate(catalogue.load("tc3"), duration=1.0))

    monkeypatch.setattr(case, "simulate", stopped)
    result = call("verify", "TC3")
    assert result.exit_code == 130
    assert result.stdout == ""
    assert str(tmp_path / "home") in result.stderr


@pytest.mark.parametrize("words", [["--record", "no/x.rrd"], ["--plot", "no/x.png"]])
def test_a_place_is_refused_before_the_run(
    call: Call, monkeypatch: pytest.MonkeyPatch, words: list[str]
) -> None:
    monkeypatch.setattr(run_command, "simulate", lambda *_, **__: pytest.fail("simulated"))
    assert "there is no directory no" in refused(call("run", "tc3", *words))


def test_a_file_is_no_directory(call: Call, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    assert "is no directory" in refused(call("run", "tc3", "--record", tmp_path / "file" / "x.npz"))


def test_an_answer_outlives_a_disk_that_is_full(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: Any) -> None:
        raise RecordingError("the disk is full")

    monkeypatch.setattr(run_command._Files, "write", full)
    result = call("run", "tc3", "--json", "--record", tmp_path / "x.npz")
    assert result.exit_code == 2
    assert json.loads(result.stdout)["final"]["bodies"][0]["position"] == [870, 50]


def test_the_run_of_the_readme_tells_its_error(call: Call) -> None:
    text = call("run", "galperin-100").stdout
    assert "OB8b  velocity of large at the end" in text
    assert "e-1" not in text.partition("point, m")[2].partition("Error")[0]  # rounding is 0


def test_an_interrupted_run_says_nothing_of_checks(
    call: Call, monkeypatch: pytest.MonkeyPatch
) -> None:
    def stopped(*_: Any, **__: Any) -> None:
        raise Interrupted(lambda: simulate(catalogue.load("tc3"), duration=1.0))

    monkeypatch.setattr(run_command, "simulate", stopped)
    assert "checks" not in call("run", "tc3").stderr


def test_a_viewer_without_a_screen_names_the_file_of_the_user(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from tamias2d.record.rerun import program as viewer

    def blind(*words: str) -> subprocess.CompletedProcess[str]:
        said = "\x1b[31mError\x1b[0m: os error at /a/b.rs:765: no DISPLAY is set.\n"
        return subprocess.CompletedProcess(words, int("--bind" in words), "", said)

    path = tmp_path / "x.npz"
    call("run", "tc3", "--record", path)
    monkeypatch.setattr(viewer, "_run", blind)
    says = refused(call("replay", path))
    assert says.startswith(f"{path}: the viewer ended with code 1: no DISPLAY is set. It needs")


# --- the others --------------------------------------------------------------------------------


def test_scenes_lists_the_catalogue(call: Call) -> None:
    rows = answer(call("scenes", "--json"))["scenes"]
    assert [row["name"] for row in rows] == catalogue.names()
    assert all(row["says"] for row in rows)
    assert "showcase" in call("scenes").stdout


def test_explain_gives_every_reason(call: Call) -> None:
    entries = answer(call("explain", "tc3", "--json"))["entries"]
    assert len(entries) == len(needs(catalogue.load("tc3")).entries) + 1  # the way through contacts
    text = call("explain", "tc3").stdout
    assert all(entry["reason"] in text for entry in entries)


def test_explain_takes_a_duration_for_a_scene_that_states_none(call: Call, tmp_path: Path) -> None:
    scene = tmp_path / "scene.yaml"
    scene.write_text(
        "gravity: [0 m/s^2, -9.81 m/s^2]\n"
        "bodies:\n  ball: {shape: disc, radius: 10 cm, mass: 1 kg, position: [0 m, 0 m]}\n"
    )
    assert "--duration: found none" in call("explain", str(scene)).stderr
    assert "translation (IM1)" in call("explain", str(scene), "--duration", "2 s").stdout


def test_explain_tells_why_joints_are_stepped(call: Call) -> None:
    text = call("explain", "car").stdout
    assert "joints in a substep (IM15)" in text
    assert "a joint holds 'chassis', which may rub or rest on what it meets" in text


def test_verify_answers_a_row_a_comparison(call: Call) -> None:
    rows = answer(call("verify", "TC1", "TC2", "--json"))["cases"]
    assert {row["id"] for row in rows} == {"TC1", "TC2"}
    assert {"id", "quantity", "error", "tolerance", "verdict"} <= rows[0].keys()
    assert "0 failed" in call("verify", "TC1").stdout


class Terminal(io.StringIO):
    """A screen that keeps what was written on it."""

    def isatty(self) -> bool:
        return True


def test_in_a_terminal_verify_shows_how_far_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    screen = Terminal()
    monkeypatch.setattr(sys, "stderr", screen)
    assert list(followed(["TC1", "TC2"], str)) == ["TC1", "TC2"]
    shown = screen.getvalue()
    assert "TC2" in shown
    assert "2/2" in shown


@pytest.mark.parametrize("width", [80, 40, 20])
def test_a_narrow_terminal_loses_nothing_of_a_table(
    monkeypatch: pytest.MonkeyPatch, width: int
) -> None:
    screen = Terminal()
    monkeypatch.setattr(sys, "stdout", screen)
    monkeypatch.setenv("COLUMNS", str(width))
    heads = ("item", "where", "cases", "verdict")
    place = "src/tamias2d/generated/continuous_collision.py:123"
    row = ("coulomb.tangential_velocity_closest", place, "OF12a OF12b", "not run")
    print_table(heads, [row])
    lines = re.sub(r"\x1b\[[\d;]*m", "", screen.getvalue()).splitlines()
    assert max(map(len, lines)) <= width
    shown, meant = "".join(lines), "".join((*heads, *row))
    assert sorted(shown.replace(" ", "")) == sorted(meant.replace(" ", ""))


def test_verify_shows_nothing_where_nobody_looks(call: Call) -> None:
    assert call("verify", "TC1").stderr == ""


def test_version(call: Call) -> None:
    assert call("--version").stdout == f"tamias2d {metadata.version('tamias2d')}\n"


def test_a_failed_case_fails_the_command(call: Call, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(exact, "distance", lambda *_: 1.0)
    result = call("verify", "TC1")
    assert result.exit_code == 1
    assert "fail" in result.stdout


def test_a_missing_extra_fails_no_case(call: Call, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "xarray", None)
    result = call("verify", "OJ24")
    assert result.exit_code == 0
    assert result.stdout.endswith("0 failed, 1 not run: needs tamias2d[ensemble]\n")
    said = call("trace", "OJ24")
    assert " fail" not in said.stdout
    assert (
        "OJ24: not run: needs tamias2d[ensemble]. Install it, then `tamias2d verify OJ24` runs "
        "them.\n" in said.stderr
    )


def test_what_is_recommended_can_be_run_as_it_is_said(call: Call) -> None:
    """`run --tolerance` takes another setting: that is said, too."""
    said = call("recommend", "pendulum", "--tolerance", "1e-4", "--duration", "1 s").stdout
    (line,) = (line for line in said.splitlines() if line.startswith("Run it: "))
    run = eval(line.removeprefix("Run it: "), {"t2": t2, "scene": t2.catalogue.load("pendulum")})
    assert f"within 0.0001: {run.method}" in said
    assert f"{run.time_step:.4g} s\n" in said
    assert "often by another setting" in said


def test_trace_answers_every_item(call: Call) -> None:
    call("verify", "TC1")
    assert "`tamias2d verify` runs them" in call("trace", "TC1").stderr  # what it rests on
    result = call("trace", "--json")
    assert result.exit_code == 1  # the other cases have not been run
    items = {item["id"]: item for item in json.loads(result.stdout)["items"]}
    assert items["TC1"]["verdict"] == "pass"
    assert items["OS1"]["verdict"] == "not run"
    wanted = {"id", "kind", "title", "file", "line", "links", "code", "cases", "verdict"}
    assert wanted <= items["IM1"].keys()


def test_trace_names_the_used_items_whose_cases_are_open(call: Call) -> None:
    named = trace("R5")[0].cases
    results.add(Outcome(id, "", 0.0, 1.0, "pass", fingerprint(items()[id])) for id in named)
    said = call("trace", "R5").stderr
    assert said == (
        "Some cases of IM1, velocity_verlet, semi_implicit_euler, runge_kutta_4 have not been run "
        "yet: `tamias2d verify IM1 velocity_verlet semi_implicit_euler runge_kutta_4` runs them.\n"
    )


def test_trace_leads_from_a_requirement_to_the_line_of_its_code(call: Call) -> None:
    text = call("trace").stdout
    assert text.index("R5 ") < text.index("IM1 ", text.index("R5 "))
    _, place, *_ = next(line for line in text.splitlines() if "impact.impulse" in line).split()
    file, line = place.split(":")
    source = Path(__file__).parents[2].joinpath(file).read_text().splitlines()
    assert source[int(line) - 1].startswith("def impulse(")


def test_trace_shows_all_that_a_requirement_stands_on(call: Call) -> None:
    text = call("trace").stdout
    of_r13 = text[text.index("\nR13 ") : text.index("\nR15 ")]
    missing = [id for id in trace("R13")[0].links if f"\n  {id} " not in of_r13]
    assert missing == []


def test_trace_of_an_item_shows_what_depends_on_it(call: Call) -> None:
    result = call("trace", "A6")
    text = result.stdout
    assert result.exit_code == 1
    assert "`tamias2d verify A6` runs them" in result.stderr
    assert max(map(len, text.splitlines())) < 200
    assert "A6 rests on: nothing" in text
    assert "R8 " in text.partition("What depends on A6")[2]


def test_a_named_pipe_is_no_scene(call: Call, tmp_path: Path) -> None:
    if not hasattr(os, "mkfifo"):
        pytest.skip("no named pipes")
    os.mkfifo(tmp_path / "pipe.yaml")
    said = refused(call("run", tmp_path / "pipe.yaml"))
    assert (
        said == f"{tmp_path}/pipe.yaml: no regular file (R2). Give the path of a scene in YAML.\n"
    )


@pytest.mark.parametrize("command", ["run", "explain", "recommend", "tradeoff"])
def test_a_scene_in_which_nothing_moves(call: Call, tmp_path: Path, command: str) -> None:
    path = tmp_path / "still.yaml"
    path.write_text("gravity: [0 m/s^2, -9.81 m/s^2]\nduration: 1 s\n")
    more = ["--tolerance", "1e-3"] if command == "recommend" else []
    result = call(command, path, *more)
    if command == "tradeoff":
        assert "no body can move" in refused(result)
    else:
        assert result.exit_code == 0


# --- as a program ------------------------------------------------------------------------------


def program(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "tamias2d", *words], capture_output=True, text=True
    )


def test_help_loads_neither_numbers_nor_viewer() -> None:
    code = (
        "import sys\nfrom tamias2d import cli\nsys.argv = ['tamias2d', '--help']\n"
        "try:\n    cli.main()\nfinally:\n"
        "    bad = {'numpy', 'scipy', 'rerun', 'sphinx', 'matplotlib'} & set(sys.modules)\n"
        "    print(bad or 'light')\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.stdout.rstrip().endswith("light")


def test_the_program_refuses_without_a_traceback() -> None:
    done = program("run", "no-such-scene")
    assert done.returncode == 2
    assert done.stderr.startswith("SCENE: 'no-such-scene'")


def test_the_program_names_itself_as_it_was_called(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TAMIAS2D_COMMAND", "tools/dev")
    assert "Usage: tools/dev" in program("--help").stdout
