"""Laws that have no finite value everywhere: a trial that met none is lost, a run ends there."""

from pathlib import Path

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.motion import Method
from tamias2d.replay import check
from tamias2d.study.pilot import Pilot


def pulled(law: str, velocity: float = 1.0) -> t2.Scene:
    """A particle that a law alone acts on, along x."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), velocity=(velocity, 0.0))
    scene.add_field(force=(law, 0.0))
    return scene


@pytest.mark.parametrize("velocity", [4.0, 6.0])
@pytest.mark.parametrize("method", [t2.Dop853(1e-1), t2.Dop853(1e-3), t2.DormandPrince5(1e-3)])
def test_a_step_that_went_beyond_a_wall_is_taken_again(method: Method, velocity: float) -> None:
    scene = pulled("-1[N]/(1 - x(position)/1[m])**1.5", velocity)
    run = t2.simulate(scene, duration=1.0, method=method, times=np.linspace(0.0, 1.0, 101))
    x, speed = run.position[:, 0, 0], run.velocity[:, 0, 0]
    energy = speed**2 / 2 + 2 / np.sqrt(1 - x)  # U = 2 J/sqrt(1 - x/m)
    assert x.max() < 1.0
    assert speed[-1] < 0.0
    assert abs(energy / energy[0] - 1).max() < 0.1  # as loose as the loosest method


def test_a_pilot_that_diverged_has_lost() -> None:
    scene = pulled("-1[N/m^5]*x(position)**5", 20.0)
    pilot = Pilot(scene, 2.0, 1e-3)
    estimate = pilot.fixed_step(t2.RungeKutta4(), np.inf)
    assert estimate.time_step is not None
    assert estimate.time_step < 2.0 / 16


@pytest.mark.parametrize(
    "asked",
    [
        {"method": t2.Dop853(1e-8)},
        {"method": t2.RungeKutta4(), "time_step": 0.01},
        {"method": t2.Reference()},
        {"tolerance": 1e-2},
        {"tolerance": 1e-6},
    ],
    ids=str,
)
def test_a_run_to_where_a_law_has_no_value_says_so(asked: dict[str, object]) -> None:
    told = r"force\[0\] of field 0: .* no finite value at time 1\.0"
    with pytest.raises(t2.InputError, match=told) as refused:
        t2.simulate(pulled("1[N]*log(1 - time/1[s])"), duration=2.0, **asked)  # type: ignore[arg-type]
    assert isinstance(refused.value, t2.SimulationError)
    run = refused.value.run
    assert isinstance(run, t2.Run)
    assert 0.9 < run.times[-1] <= 1.0


def test_the_reference_names_a_law_beside_which_no_step_meets_its_tolerance() -> None:
    scene = pulled("-1[N]/sqrt(1 - (x(position)/1[m])**4)", 0.9)
    with pytest.raises(t2.InputError, match=r"no finite value at position \(-1\.0"):
        t2.simulate(scene, duration=3.0)


def test_what_such_a_run_left_is_recomputed(tmp_path: Path) -> None:
    scene = pulled("1[N]*sqrt(1 - time/1[s])")
    with pytest.raises(t2.SimulationError) as refused:
        t2.simulate(scene, duration=2.0, method=t2.Dop853(1e-8))
    run = refused.value.run
    assert isinstance(run, t2.Run)
    path = tmp_path / "left.npz"
    run.save(path)
    assert check(path).identical
