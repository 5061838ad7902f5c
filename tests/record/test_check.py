"""A recomputation finds a single changed bit, and names when, whose and what it is."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d import record, replay
from tamias2d.certificate import Certificate
from tamias2d.record import header as headers
from tamias2d.record.difference import first_difference
from tamias2d.record.history import OF_BODIES, TOTALS

from .conftest import RUNS, with_impacts


@pytest.mark.parametrize("suffix", [".rrd", ".npz"])
@pytest.mark.parametrize("name", [name for name in RUNS if name != "impacts made up"])
def test_an_honest_recording_is_identical(tmp_path: Path, suffix: str, name: str) -> None:
    path = tmp_path / f"run{suffix}"
    RUNS[name]().save(path)
    answer = replay.check(path)
    assert answer.identical
    assert answer.difference is None
    assert f"{path}: identical" in answer.says
    assert answer.says.endswith("what the viewer draws was not compared.") == (suffix == ".rrd")


def one_bit(array: np.ndarray[Any, Any], place: tuple[int, ...]) -> np.ndarray[Any, Any]:
    changed = array.copy()
    changed.view(np.int64)[place] ^= 1
    return changed


@pytest.mark.parametrize("suffix", [".rrd", ".npz"])
@pytest.mark.parametrize("quantity", [*OF_BODIES, *TOTALS])
def test_one_bit_is_found(run: t2.Run, tmp_path: Path, suffix: str, quantity: str) -> None:
    array = getattr(run, quantity)
    place = (17, 2, 1)[: array.ndim] if quantity in OF_BODIES else (17, 1)[: array.ndim]
    path = tmp_path / f"run{suffix}"
    replace(run, **{quantity: one_bit(array, place)}).save(path)
    answer = replay.check(path)
    assert not answer.identical
    assert answer.difference is not None
    assert answer.difference.time == run.times[17]
    assert answer.difference.of == ("body 'Kiste ü'" if quantity in OF_BODIES else "the scene")
    assert answer.difference.quantity == quantity + (
        " y" if array.ndim > len(place) - 1 > 0 and place[-1] == 1 else ""
    )
    assert answer.difference.recorded != answer.difference.recomputed
    assert f"at {float(run.times[17])!r} s" in answer.says
    assert repr(answer.difference.recomputed) in answer.says


@pytest.mark.parametrize(
    ("quantity", "place", "name", "component"),
    [
        ("time", (1,), "time", ""),
        ("bodies", (1, 1), "bodies", " B"),
        ("point", (1, 0), "point", " x"),
        ("normal", (1, 1), "normal", " y"),
        ("impulse", (1,), "impulse", ""),
        ("normal_velocity", (1,), "normal_velocity", ""),
    ],
)
def test_one_bit_of_an_impact_is_found(
    run: t2.Run, quantity: str, place: tuple[int, ...], name: str, component: str
) -> None:
    true = with_impacts(run)
    array = getattr(true.impacts, quantity)
    false = replace(true, impacts=replace(true.impacts, **{quantity: one_bit(array, place)}))
    found = first_difference(false, true)
    assert found is not None
    assert found.quantity == name + component
    assert found.of.startswith("impact 1 of 'red ball / 1' and '")
    assert first_difference(true, true) is None


def test_the_earliest_difference_is_named(run: t2.Run) -> None:
    late = replace(run, position=one_bit(run.position, (20, 0, 0)))
    both = replace(late, energy=one_bit(run.energy, (3,)))
    found = first_difference(both, run)
    assert found is not None
    assert (found.time, found.quantity) == (run.times[3], "energy")


def test_zero_has_a_sign_and_nan_equals_itself(run: t2.Run) -> None:
    energy = run.energy.copy()
    energy[4], energy[5] = np.nan, 0.0
    odd = replace(run, energy=energy)
    assert first_difference(odd, odd) is None
    signed = replace(odd, energy=np.where(energy == 0.0, -0.0, energy))
    found = first_difference(signed, odd)
    assert found is not None
    assert "recorded -0.0, recomputed 0.0 J" in str(found)


def test_an_impact_too_many_is_found(run: t2.Run) -> None:
    found = first_difference(with_impacts(run), run)
    assert found is not None
    assert found.quantity == "number of impacts"
    assert (found.recorded, found.recomputed) == (3, 0)


def test_impacts_that_an_interrupted_run_did_not_see(run: t2.Run) -> None:
    short = {name: getattr(run, name)[:1] for name in ("times", *OF_BODIES, *TOTALS)}
    cut, whole = replace(run, **short), replace(with_impacts(run), **short)
    assert first_difference(cut, whole) is None


def test_a_changed_input_is_found(run: t2.Run, tmp_path: Path) -> None:
    path = tmp_path / "run.npz"
    run.save(path)
    stored = dict(np.load(path))
    stored["header"] = np.array(str(stored["header"]).replace("-9.81 m", "-9.80 m"))
    np.savez(path, **stored)
    answer = replay.check(path)
    assert not answer.identical
    assert answer.difference is not None
    assert (answer.difference.time, answer.difference.quantity) == (0.0, "energy")


def test_changed_by_hand_or_by_another_version(
    run: t2.Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "run.npz"
    replace(run, energy=one_bit(run.energy, (0,))).save(path)
    told = "the program has changed, or it was not `simulate` that made the run"
    assert told in replay.check(path).says
    stored = dict(np.load(path))
    here = headers.versions()
    monkeypatch.setattr(headers, "versions", lambda: {**here, "numpy": "0.1"})
    assert f"recorded with numpy {np.__version__}, now 0.1" in replay.check(path).says
    stored["energy"][7] = 0.0
    np.savez(path, **stored)
    assert "it was changed after it was recorded" in replay.check(path).says


def test_what_the_viewer_draws_is_not_the_history(run: t2.Run, tmp_path: Path) -> None:
    run.save(tmp_path / "run.rrd")
    exact = record.load(tmp_path / "run.rrd").position
    assert np.any(exact != exact.astype(np.float32))


ASKED = {
    "of a quality": ("incline", {"quality": 0.01}),
    "within a tolerance": ("incline", {"tolerance": 1e-2}),
    "of a quality, located": ("cradle-touching", {"quality": 0.01}),
}


@pytest.mark.parametrize("suffix", [".rrd", ".npz"])
@pytest.mark.parametrize("name", ASKED)
def test_what_was_asked_for_is_certified_again_in_the_same_way(
    tmp_path: Path, suffix: str, name: str
) -> None:
    scene, asked = ASKED[name]
    path = tmp_path / f"run{suffix}"
    t2.simulate(t2.catalogue.load(scene), duration=2.0, **asked).save(path)  # type: ignore[arg-type]
    answer = replay.check(path)
    assert answer.identical, answer.says
    assert "its certificate, computed again, is the same" in answer.says


def test_a_bound_of_steps_that_is_forged_is_found(tmp_path: Path) -> None:
    """Also if it tells of steps that no plan has, or of a quality that the run has not."""
    run = t2.simulate(t2.catalogue.load("incline"), duration=2.0, tolerance=1e-2)
    honest = run.certificate
    assert honest is not None
    path = tmp_path / "run.npz"
    for forged in (
        replace(honest, bound=1e-9),
        replace(honest, how=honest.how.replace("steps of 0", "steps of 9")),
        replace(honest, measure=of_quality(run).measure),
    ):
        replace(run, certificate=forged).save(path)
        assert "its certificate differs" in replay.check(path).says


def of_quality(run: t2.Run) -> Certificate:
    """Return the certificate of a run of some quality."""
    certificate = t2.simulate(run.scene, duration=0.1, quality=0.5).certificate
    assert certificate is not None
    return certificate
