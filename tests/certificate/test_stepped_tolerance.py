"""A tolerance or a quality where contacts are stepped: met at the least cost, or refused."""

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.motion import Stepped
from tamias2d.scene import catalogue
from tamias2d.scene.joint_kinds import JointKind
from tamias2d.study.engines.overlap import worst
from tamias2d.study.error import distance
from tamias2d.study.refined import refined, refinements, step_alone, stepped, work_of

G = (0.0, -9.81)
TIMES = np.linspace(0.0, 0.5, 11)


def slider() -> t2.Scene:
    """Two boxes as one body, which slide on a floor until friction has stopped them."""
    scene = t2.Scene(gravity=G, name="slider", duration=0.5)
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, friction=0.5, restitution=0.0, name="floor")
    half = t2.Box(width=0.5, height=0.5)
    both = t2.Compound(parts=[t2.Part(shape=half, position=(x, 0.0)) for x in (-0.25, 0.25)])
    scene.add_body(
        both, mass=1.0, position=(0.0, 0.25), velocity=(2.0, 0.0), friction=0.5, restitution=0.0,
        name="brick",
    )  # fmt: skip
    return scene


def error_of(run: t2.Run) -> float:
    """Against steps that are far shorter than any that the certificate has seen, m."""
    true = stepped(run.scene, run.duration, run.times, (run.time_step or 1.0) / 51, 7)
    return float(distance(run.scene, run, true).max())


def bound_of(run: t2.Run) -> float:
    """In m: relative to the way of the brick, or to its size."""
    assert run.certificate is not None
    assert run.certificate.bound is not None
    way = np.ptp(run.position, axis=0)
    return run.certificate.bound * max(float(np.hypot(*way.T).max()), 0.25 * 5**0.5)


@pytest.mark.parametrize("tolerance", [1e-1, 1e-2, 1e-3])
def test_the_error_against_far_shorter_steps_is_within_bound_and_tolerance(
    tolerance: float,
) -> None:
    run = t2.simulate(slider(), duration=0.5, tolerance=tolerance, times=TIMES)
    assert isinstance(run.method, Stepped)
    assert run.certificate is not None
    assert run.certificate.meets(tolerance)
    assert error_of(run) <= 1.001 * bound_of(run)  # the way is read off samples


def test_a_looser_tolerance_costs_no_more() -> None:
    costs = []
    for tolerance in (1e-1, 1e-2, 1e-3):
        plan = t2.recommend(slider(), duration=0.5, tolerance=tolerance)
        step, method = plan.choice.time_step, plan.choice.method
        assert isinstance(method, Stepped)
        assert step is not None
        costs.append(work_of(slider(), 0.5, step, method.substeps))
    assert costs == sorted(costs)
    assert costs[0] < costs[-1]


def test_a_run_of_given_steps_is_certified_by_shorter_ones() -> None:
    run = t2.simulate(slider(), duration=0.5, method=Stepped(), time_step=1 / 60, times=TIMES)
    assert error_of(run) <= 1.001 * bound_of(t2.certify(run))


def test_what_is_past_the_horizon_is_refused_with_what_can_be_met() -> None:
    scene = catalogue.load("dominoes")
    with pytest.raises(t2.ToleranceError, match=r"End the run at .* quality") as refused:
        t2.simulate(scene, duration=0.6, tolerance=1e-2)
    until = refused.value.until
    assert until is not None
    assert 0.0 < until < 0.6
    run = t2.simulate(scene, duration=until, tolerance=1e-2)
    assert run.certificate is not None
    assert run.certificate.meets(1e-2)


def test_what_is_finer_than_steps_can_be_is_refused() -> None:
    with pytest.raises(t2.ToleranceError, match="give a tolerance of") as refused:
        t2.simulate(slider(), duration=0.5, tolerance=1e-12, work_limit=1000)
    reachable = refused.value.reachable
    assert reachable is not None
    run = t2.simulate(slider(), duration=0.5, tolerance=reachable, work_limit=1000)
    assert run.certificate is not None


def test_runs_agree_until_bodies_touch_at_once() -> None:
    """The first domino falls against the second one after a quarter of a second."""
    scene = catalogue.load("dominoes")
    times = np.linspace(0.0, 2.0, 101)
    found = refined(scene, duration=2.0, times=times, time_step=1 / 120, grid=1 / 60)
    horizon = found.horizon(1e-2)
    assert horizon is not None
    assert 0.2 <= horizon < 0.4
    assert found.share > 1e-2  # at the end, where they do not


def test_shorter_steps_leave_less_doubt() -> None:
    found = [
        refined(slider(), duration=0.5, times=TIMES, time_step=step, grid=1 / 60).share
        for step in (1 / 60, 1 / 240, 1 / 960)
    ]
    assert found == sorted(found, reverse=True)


def test_a_quality_bounds_overlap_and_energy() -> None:
    scene = catalogue.load("arch")
    work = []
    for quality in (1e-1, 1e-3):
        run = t2.simulate(scene, duration=0.5, quality=quality)
        assert run.certificate is not None
        assert run.certificate.kind == "invariants"
        assert run.certificate.bound is not None
        assert run.certificate.bound <= quality
        assert run.energy.max() <= run.energy[0] * (1 + quality)
        rows = zip(run.position, run.orientation, strict=True)
        deepest = max(
            worst(scene, np.column_stack((place, turn, 0 * place, turn))).share_of_size
            for place, turn in rows
        )
        assert deepest <= quality
        assert isinstance(run.method, Stepped)
        work.append(work_of(scene, 0.5, run.time_step or 1.0, run.method.substeps))
    assert work[0] < work[1]


def test_a_quality_that_no_step_holds_is_refused_with_what_is_reached() -> None:
    with pytest.raises(t2.ToleranceError, match="give a quality of") as refused:
        t2.simulate(catalogue.load("arch"), duration=0.5, quality=1e-9, work_limit=10)
    assert refused.value.reachable is not None
    assert refused.value.reachable > 1e-9


def test_a_quality_that_is_offered_is_held_at_all_samples() -> None:
    """A bullet is deepest for an instant, which a few looks at a run miss."""
    scene = catalogue.load("bullet-wall")
    with pytest.raises(t2.ToleranceError, match="give a quality of") as refused:
        t2.simulate(scene, duration=0.1, quality=1e-4, work_limit=100)
    offer = refused.value.reachable
    assert offer is not None
    run = t2.simulate(scene, duration=0.1, quality=offer, work_limit=100)
    assert run.certificate is not None
    assert run.certificate.bound is not None
    assert run.certificate.bound <= offer


def test_particles_have_a_quality() -> None:
    """They have no shape, so that none is in another."""
    run = t2.simulate(catalogue.load("projectiles"), duration=1.0, quality=1e-6)
    assert run.certificate is not None
    assert "overlaps are at most 0.0e+00" in run.certificate.how


def test_a_located_run_has_a_quality_too() -> None:
    run = t2.simulate(catalogue.load("bouncing-elastic"), duration=1.0, quality=1e-6)
    assert not isinstance(run.method, Stepped)
    assert run.certificate is not None
    assert run.certificate.bound is not None
    assert run.certificate.bound <= 1e-6


def hung(kind: JointKind) -> t2.Scene:
    """A load that turns backwards and falls, held somehow to the origin."""
    scene = t2.Scene(gravity=G)
    scene.add_body(
        None, mass=1.0, inertia=0.1, position=(0.0, -0.5), orientation=0.05, angular_velocity=-2.0,
        name="load",
    )  # fmt: skip
    scene.add_joint(kind, (0.0, 0.0), "load", name="held")
    return scene


@pytest.mark.parametrize(
    "kind",
    [
        t2.Distance(limits=t2.Limits(upper=1.0, restitution=0.5)),
        t2.Distance(spring=t2.JointSpring(stiffness=20.0, damping=5.0)),
        t2.Rotary(motor=t2.Motor(speed=0.0, maximum=0.3)),
        t2.Ratchet(pitch=0.1, restitution=0.0),
    ],
)
def test_what_joints_take_is_no_fault_of_the_energy(kind: JointKind) -> None:
    """It was refused, with the advice to take shorter steps."""
    run = t2.simulate(hung(kind), duration=0.5, quality=0.01)
    assert run.energy[-1] < run.energy.max() - 0.05
    assert run.certificate is not None
    assert run.certificate.bound is not None
    assert run.certificate.bound < 1e-9


def test_energy_that_a_motor_gives_has_no_quality() -> None:
    scene = hung(t2.Rotary(motor=t2.Motor(speed=9.0, maximum=0.3)))
    with pytest.raises(t2.InputError, match="something gives energy"):
        t2.simulate(scene, duration=0.5, quality=0.01)


@pytest.mark.parametrize("quality", [0.0, -1.0, 1.0, float("nan"), "0.1", True])
def test_what_is_no_quality_is_refused(quality: object) -> None:
    with pytest.raises(t2.InputError, match=r"quality .*R5"):
        t2.simulate(slider(), duration=0.5, quality=quality)  # type: ignore[arg-type]


def test_quality_is_not_asked_for_beside_a_tolerance_or_a_method() -> None:
    with pytest.raises(t2.InputError, match="Give one of the two"):
        t2.simulate(slider(), duration=0.5, quality=0.01, tolerance=0.01)
    with pytest.raises(t2.InputError, match="Give one of the two"):
        t2.simulate(slider(), duration=0.5, quality=0.01, method=Stepped(), time_step=0.01)


def test_bodies_that_a_joint_keeps_from_touching_may_overlap() -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=0.5, restitution=0.0)
    frame = scene.add_body(t2.Box(width=1.0, height=0.2), mass=1.0, position=(0.0, 0.3))
    wheel = scene.add_body(t2.Disc(radius=0.3), mass=1.0, position=(0.0, 0.3), friction=0.5)
    scene.add_joint(t2.Revolute(), frame, wheel)
    run = t2.simulate(scene, duration=0.1, method=Stepped(), time_step=1 / 60)
    certificate = t2.certify(run).certificate
    assert certificate is not None
    assert certificate.kind == "step doubling"


def test_more_joints_than_are_solved_at_once_are_stepped() -> None:
    run = t2.simulate(catalogue.load("joint-grid"), duration=0.02)
    assert isinstance(run.method, Stepped)
    assert np.isfinite(run.energy).all()


def test_few_bodies_are_refined_no_longer_than_their_steps_take() -> None:
    """Without what steps cost alone, the work limit would leave ten times as many."""
    found = refinements(
        slider(),
        duration=0.5,
        times=TIMES,
        time_step=1 / 60,
        work=1e6,
        per_step=step_alone(slider()),
    )
    assert sum(one.steps for one in found) < 1e6 / 400
