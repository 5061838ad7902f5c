"""Steps that adapt themselves: tolerance, cost, refusals, and paths without seams."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.generated import schemes
from tamias2d.motion.adaptive import Adaptive, Tolerance
from tamias2d.motion.law_resolution import LawResolution
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.methods import Method
from tamias2d.motion.motion import Tally
from tamias2d.state import Array

PAIRS = [t2.DormandPrince5, t2.Dop853]


def orbit() -> t2.Scene:
    """Ellipse of excentricity 0.6 about a body that hardly moves (OA11)."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1e-12, position=(0.4, 0.0), velocity=(0.0, 2.0), name="planet")
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), name="sun")
    scene.add_attraction(gravitational_constant=1.0)
    return scene


@pytest.mark.parametrize("pair", PAIRS)
def test_error_follows_the_tolerance(pair: type[Method]) -> None:
    for rtol in (1e-4, 1e-7, 1e-10):
        run = t2.simulate(orbit(), duration=10.0, method=pair(rtol=rtol), times=[10.0])  # type: ignore[call-arg]
        error = np.abs(run.position[-1, 0] - [-1.5350235919098137, -0.28366840649978086]).max()
        assert 1e-3 * rtol < error < 1e3 * rtol


def test_the_higher_order_pays_below_a_tolerance() -> None:
    def evaluations(method: Method) -> int:
        cost = t2.simulate(orbit(), duration=20.0, method=method).cost
        assert cost is not None
        return cost.force_evaluations

    assert evaluations(t2.DormandPrince5(rtol=1e-3)) < evaluations(t2.Dop853(rtol=1e-3))
    assert evaluations(t2.Dop853(rtol=1e-11)) < evaluations(t2.DormandPrince5(rtol=1e-11)) / 2


def test_costs_are_counted() -> None:
    run = t2.simulate(orbit(), duration=10.0, method=t2.DormandPrince5(rtol=1e-6))
    cost = run.cost
    assert cost is not None
    assert cost.rejected > 0
    # six a step, since the first slope is the last of the step before
    assert 6 * (cost.steps + cost.rejected) < cost.force_evaluations
    assert cost.force_evaluations < 6 * (cost.steps + cost.rejected) + 8
    free = t2.simulate(t2.catalogue.load("bouncing-disc"), duration=1.0).cost
    assert free is not None
    assert (free.force_evaluations, free.steps, free.rejected) == (0, 0, 0)
    assert free.impacts == 1


@pytest.mark.parametrize("pair", PAIRS)
def test_a_force_without_limit_is_refused_by_name(pair: type[Method]) -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(1.0, 0.0), name="comet")
    scene.add_field(force=("-1[N*m^2]/norm(position)**2", "0[N]"))
    fall = math.pi / math.sqrt(8)
    with pytest.raises(t2.SimulationError, match=r"DormandPrince5|Dop853|finite"):
        t2.simulate(scene, duration=2 * fall, method=pair(rtol=1e-8))  # type: ignore[call-arg]


@pytest.mark.parametrize("pair", PAIRS)
def test_force_that_jumps_is_stepped_over(pair: type[Method]) -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), name="cart")
    scene.add_field(force=("1[N]*max(0, min(1, (time - 1[s])/1e-9[s]))", "0[N]"))
    run = t2.simulate(scene, duration=2.0, method=pair(rtol=1e-9))  # type: ignore[call-arg]
    assert run.position[-1, 0, 0] == pytest.approx(0.5, rel=1e-6)


@pytest.mark.parametrize("wrong", [0.0, 1.0, -1e-6, math.nan])
@pytest.mark.parametrize("pair", PAIRS)
def test_tolerance_out_of_range(pair: type[Method], wrong: float) -> None:
    with pytest.raises(t2.InputError, match="rtol"):
        pair(rtol=wrong)  # type: ignore[call-arg]
    with pytest.raises(t2.InputError, match="atol"):
        pair(atol=-1.0)  # type: ignore[call-arg]


@pytest.mark.parametrize(("name", "orders"), [("dormand_prince_5", (4,)), ("dop853", (5, 3))])
def test_path_within_a_step(name: str, orders: tuple[int, ...]) -> None:
    """It meets both ends to the bit, its velocity is its derivative, and it solves the equation."""

    def field(_time: float, position: Array, _velocity: Array) -> Array:
        return -position

    start = np.array([[1.0, 0.0, 0.5]]), np.array([[0.3, 1.0, -0.2]])
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0))
    watched = MemoisedField(field, [0], [None], Tally())
    steps = Adaptive(
        name,
        getattr(schemes, name),
        orders=orders,
        tolerance=Tolerance(1e-9, 1e-9, 1e-9),
        damping=0.0,
        resolution=LawResolution(scene, 10.0),
    )
    step = steps.step(watched, 0.0, 10.0, *start)
    assert np.array_equal(step.at(0.0)[0], start[0])
    near_end = step.at(math.nextafter(step.end, 0.0))
    assert np.allclose(near_end, step.last, rtol=0, atol=1e-14)
    for share in (0.2, 0.5, 0.9):
        time = share * step.end
        c, s = math.cos(time), math.sin(time)
        q, rate = step.at(time)
        assert q == pytest.approx(start[0] * c + start[1] * s, abs=1e-8)
        assert rate == pytest.approx(start[1] * c - start[0] * s, abs=1e-8)
        change = (step.at(time + 1e-6)[0] - step.at(time - 1e-6)[0]) / 2e-6
        assert rate == pytest.approx(change, abs=1e-9)
