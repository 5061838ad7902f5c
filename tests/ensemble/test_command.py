"""`tamias2d ensemble`: what it prints, draws and records."""

import json
import sys
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from click.testing import Result
from typer.testing import CliRunner

import tamias2d as t2
from tamias2d import Run
from tamias2d.cli import app
from tamias2d.ensemble import run_ensemble

VARY = (
    *("--vary", "bodies.disc.restitution=uniform(0.2, 0.8)"),
    *("--vary", "bodies.disc.position.y = normal(2 m, 10 cm)"),
)


def call(*arguments: object) -> Result:
    return CliRunner().invoke(app, ["ensemble", "bouncing-disc", *map(str, arguments)])


def test_it_prints_how_worlds_spread_draws_and_stores_them(tmp_path: Path) -> None:
    out, picture = tmp_path / "e.zarr", tmp_path / "e.png"
    found = call(
        *VARY, "--worlds", 6, "--seed", 3, "--duration", 1, "--workers", 1,
        *("--out", out, "--plot", picture, "--json"),
    )  # fmt: skip
    assert found.exit_code == 0, found.output
    told = json.loads(found.stdout)
    stored = xr.open_zarr(out, consolidated=False)
    heights = stored.position.values[:, -1, 0, 1]
    assert told["outcomes"] == {"located": 6}
    assert told["end"][1]["mean"] == pytest.approx(heights.mean(), rel=1e-12)
    assert told["end"][1]["deviation"] == pytest.approx(heights.std(), rel=1e-12)
    assert picture.read_bytes().startswith(b"\x89PNG")
    spread = stored["bodies.disc.restitution"].values
    assert ((spread >= 0.2) & (spread <= 0.8)).all()


def test_a_world_is_recorded_again_by_its_number(tmp_path: Path) -> None:
    arguments = (*VARY, "--worlds", 6, "--seed", 3, "--duration", 1)
    out, record = tmp_path / "e.zarr", tmp_path / "w.npz"
    assert call(*arguments, "--out", out, "--workers", 1).exit_code == 0
    assert call(*arguments, "--world", 4, "--record", record).exit_code == 0
    stored, run = xr.open_zarr(out, consolidated=False), Run.load(record)
    moving = [k for k, body in enumerate(run.scene.bodies) if body.dynamic]
    np.testing.assert_array_equal(run.position[-1, moving], stored.position.values[4, -1])
    assert run.scene == t2.world_scene(stored, 4)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--vary", "gravity.y"), "--vary: 'gravity.y': must be PLACE=FORM (R2)"),
        (("--vary", "gravity.y=1", "--vary", "gravity.y=2"), "stands twice"),
        (("--vary", "gravity.q=1"), "Did you mean 'gravity.y'?"),
        (("--vary", "gravity.y=uniform(1)"), "cannot be read"),
        (("--vary", "gravity.y=uniform(2, 1)"), "LOW must be below HIGH"),
        (("--vary", "gravity.y=gauss(2, 1)"), "cannot be read"),
        (("--vary", "gravity.y="), "cannot be read"),
        (("--vary", "gravity.y=normal(1, 0)"), "the deviation must be > 0"),
        (("--vary", "gravity.y=grid(1 m)"), "must be in m s^-2"),
        (("--vary", "gravity.y=normal(1, 1)"), "worlds: found none"),
        (("--vary", "gravity.y=1", "--world", "0"), "found one without the other"),
        (("--vary", "gravity.y=1", "--world", "1", "--record", "w.npz"), "must be from 0 to 0"),
        (("--vary", "gravity.y=1", "--plot", "e.txt"), "suffix '.txt'"),
    ],
)
def test_what_cannot_be_is_told_in_one_line(arguments: tuple[str, ...], message: str) -> None:
    found = call(*arguments)
    assert found.exit_code == 2
    assert message in found.stderr
    assert found.stderr.count("\n") == 1


@pytest.mark.parametrize("name", ["xarray", "zarr", "dask", "loky"])
def test_what_is_missing_is_told_before_any_world_is_computed(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, name: str
) -> None:
    def never(*_: object) -> None:
        raise AssertionError("it was computed")

    monkeypatch.setattr(run_ensemble, "_computed", never)
    monkeypatch.setitem(sys.modules, name, None)
    found = call("--vary", "gravity.y=-1, -2", "--workers", 2, "--out", tmp_path / "e.zarr")
    assert found.exit_code == 2
    assert found.stderr.startswith(f"{name}: is needed for labelled arrays, and not installed")
