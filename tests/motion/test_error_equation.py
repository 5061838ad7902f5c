"""The error of a path by adaptive steps, as its equation says, beside what is known otherwise."""

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.motion.error_equation import ErrorEquation
from tamias2d.solve import solve_with_error
from tamias2d.study.path_error import HopelessError, hopeless
from tests.certificate.test_tolerance import oscillator

METHODS = (t2.Dop853(1e-3), t2.Dop853(1e-6), t2.Dop853(1e-9), t2.DormandPrince5(1e-5))


@pytest.mark.parametrize("method", METHODS, ids=str)
@pytest.mark.parametrize("name", ["kepler", "pendulum", "quadratic-drag"])
def test_it_is_the_distance_from_a_far_tighter_run(
    method: t2.Dop853 | t2.DormandPrince5, name: str
) -> None:
    """Within a factor of two, and of eight where drag is felt: there it is too large (R5)."""
    scene = t2.catalogue.load(name)
    duration = scene.duration or 10.0
    times = np.linspace(0.0, duration, 3001)
    run, error = solve_with_error(scene, duration=duration, method=method, times=times)
    exact = t2.simulate(scene, duration=duration, method=t2.Reference(1e-13), times=times)
    moved = np.abs(run.position - exact.position).max()
    away = max(moved, np.abs(run.orientation - exact.orientation).max())
    assert error is not None
    said = error.max()
    assert away / 2 < said < (8 if name == "quadratic-drag" else 2) * away


def test_the_run_is_that_without_it() -> None:
    method = t2.Dop853(1e-6)
    run, _ = solve_with_error(oscillator(), duration=1.0, method=method)
    plain = t2.simulate(oscillator(), duration=1.0, method=method)
    assert run.digest() == plain.digest()
    assert run.cost is not None
    assert plain.cost is not None
    assert run.cost.steps == plain.cost.steps
    nodes = run.cost.force_evaluations - plain.cost.force_evaluations
    assert nodes == 5 * run.cost.steps + 1  # six, the first of which is the last one before


@pytest.mark.parametrize("name", ["kepler", "damped-oscillator", "quadratic-drag", "pendulum"])
def test_compiled_plain_and_general_code_say_the_same(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    scene = t2.catalogue.load(name)

    def errors() -> object:
        run, found = solve_with_error(scene, duration=2.0, method=t2.Dop853(1e-6))
        assert found is not None
        return found.tobytes(), run.cost

    plain = errors()
    with monkeypatch.context() as patch:
        patch.setattr("tamias2d.kernels.choice.Kernel._price", lambda *_: 0.0)
        patch.setattr("tamias2d.kernels.choice._LOAD", 0.0)
        errors()
        compiled = errors()
    with monkeypatch.context() as patch:
        patch.setattr("tamias2d.solve.located.march_by_kernels", lambda *_: None)
        general = errors()
    assert plain == compiled == general


def test_nothing_is_said_across_impacts() -> None:
    scene = t2.catalogue.load("bouncing-disc")
    _, error = solve_with_error(scene, duration=1.0, method=t2.Dop853(1e-8))
    assert error is None


def test_nothing_is_said_where_the_force_has_no_value_beside_the_path(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def lost(*_: object) -> None:
        raise t2.SimulationError("no force there")

    monkeypatch.setattr(ErrorEquation, "_step", lost)
    monkeypatch.setattr("tamias2d.solve.located.march_by_kernels", lambda *_: None)
    run, error = solve_with_error(oscillator(), duration=1.0, method=t2.Dop853(1e-6))
    assert error is None
    assert run.times[-1] == 1.0


def test_a_run_that_will_be_too_far_off_is_stopped() -> None:
    asked = {"duration": 40.0, "method": t2.Dop853(1e-4)}
    run, _ = solve_with_error(oscillator(), **asked)  # type: ignore[arg-type]
    with pytest.raises(HopelessError) as stopped:
        solve_with_error(oscillator(), **asked, watch=hopeless(oscillator(), 40.0, 1e-7))  # type: ignore[arg-type]
    assert run.cost is not None
    assert 0 < stopped.value.force_evaluations < run.cost.force_evaluations / 2
    assert stopped.value.share > 1e-7
    solve_with_error(oscillator(), **asked, watch=hopeless(oscillator(), 40.0, 0.1))  # type: ignore[arg-type]
