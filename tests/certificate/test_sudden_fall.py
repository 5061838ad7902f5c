"""Tolerances that short steps meet although the errors of longer ones do not tell that."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.motion import Stepped
from tamias2d.scene import Scene
from tamias2d.study.cheapest_steps import Pilots
from tamias2d.study.pilot import Estimate
from tamias2d.study.refined import refined
from tamias2d.study.stepped_plan import SteppedPlan, plan_steps


def lifted() -> Scene:
    """Return a disc that falls on a lift; its impacts are found within steps."""
    scene = Scene(gravity=(0.0, -9.81))
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(0.0, 1.1), restitution=0.7, name="ball")
    scene.add_kinematic(
        t2.Box(width=4.0, height=1.0), position=(0.0, -0.5), velocity=(0.0, 0.8), restitution=1.0,
        name="lift",
    )  # fmt: skip
    return scene


def beside_a_sensor() -> Scene:
    scene = Scene(gravity=(0.0, -9.81))
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(0.0, 1.1), restitution=0.7, name="ball")
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=1.0, name="floor")
    box = t2.Box(width=1.0, height=1.0)
    scene.add_static(box, position=(5.0, 1.0), sensor=True, name="sensor")
    return scene


@pytest.mark.parametrize("scene", [lifted, beside_a_sensor])
@pytest.mark.parametrize("tolerance", [1e-3, 1e-4, 1e-6])
def test_an_error_that_is_gone_once_samples_are_ends_of_steps(
    scene: Callable[[], Scene], tolerance: float
) -> None:
    """Steps of 1/30 s have samples within an impact: all shorter ones were passed over for it."""
    run = t2.simulate(scene(), duration=0.8, tolerance=tolerance)
    assert isinstance(run.method, Stepped)
    assert run.certificate is not None
    assert run.certificate.meets(tolerance)


def planned(
    monkeypatch: pytest.MonkeyPatch, error: Callable[[float, int], float]
) -> tuple[SteppedPlan, list[tuple[float, int]]]:
    """Return a plan whose pilots have some errors, and those pilots."""
    tried: list[tuple[float, int]] = []

    def pilot(_: Pilots, step: float, substeps: int) -> Estimate:
        tried.append((step, substeps))
        return Estimate(Stepped(substeps), step, 1.0, error(step, substeps), None, "tried")

    monkeypatch.setattr(Pilots, "_tried", pilot)
    times = np.linspace(0.0, 0.8, 49)
    plan = plan_steps(
        lifted(), duration=0.8, tolerance=1e-4, times=times, work_limit=10**6, reason="a lift"
    )
    return plan, tried


def test_steps_that_were_passed_over_are_tried_before_a_refusal(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    plan, tried = planned(monkeypatch, lambda step, sub: 0.0 if step < 0.01 and sub == 2 else 0.9)
    assert plan.estimates[0].error == 0.0
    assert len(tried) == len(set(tried))


def test_the_shortest_steps_meet_what_no_other_ones_do(monkeypatch: pytest.MonkeyPatch) -> None:
    """The runs that agree within a third of the tolerance are an answer themselves."""
    plan, _ = planned(monkeypatch, lambda _step, _substeps: 0.9)
    best = plan.estimates[0]
    assert best.time_step == plan.refined.time_step
    assert best.method == Stepped(plan.refined.substeps)
    assert best.error <= 1e-4 / 3


def test_the_time_up_to_which_runs_agree_is_the_last_one() -> None:
    """Before, less has moved, so that the same doubt is more of it."""
    times = np.linspace(0.0, 0.8, 49)
    first = 1 / 60
    found = refined(lifted(), duration=0.8, times=times, time_step=first, grid=first)
    doubt, way = np.full(49, 0.1), np.linspace(0.0, 1.0, 49)
    way[40:], doubt[40:] = way[39], 1.0
    found = replace(found, doubt=doubt, way=way, sinks=np.zeros(49, dtype=bool))
    assert found.agreed(0.2) == 39
    assert found.horizon(0.2) == times[40]
    assert found.agreed(1e-3) == 0
