"""Pymunk as one more way: it runs the scene that was asked, and errs as is known of it."""

import signal
import sys
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from tamias2d.scene import Box, Capsule, Disc, HalfPlane, Scene, Segment, catalogue
from tamias2d.simulate import simulate as exact
from tamias2d.study.box2d_run import simulate as box2d
from tamias2d.study.engines.chipmunk import Chipmunk
from tamias2d.study.invariants import energy_drift
from tamias2d.study.peers import simulate
from tamias2d.study.pymunk_world import PeerError

pytest.importorskip("pymunk")


def test_free_fall_is_high_by_half_a_step() -> None:
    """It moves bodies before it changes their velocities: g h T/2 too high (peers, measured)."""
    scene = Scene(gravity=(0.0, -9.81), name="fall")
    scene.add_body(Disc(radius=0.5), mass=1.0, position=(0.0, 0.0))
    for steps in (60, 240):
        run = simulate(scene, duration=4.0, steps=steps, times=[4.0])
        error = run.position[0, 0, 1] + 9.81 * 8
        assert error == pytest.approx(9.81 * (4 / steps) * 4 / 2, rel=1e-9)
        assert run.cost is not None
        assert run.cost.steps == steps


def test_head_on_impact_keeps_momentum_and_energy() -> None:
    scene = Scene(gravity=(0.0, 0.0), name="head-on")
    disc = Disc(radius=0.5)
    scene.add_body(disc, mass=3.0, position=(-2.0, 0.0), velocity=(1.0, 0.0), restitution=1.0)
    scene.add_body(disc, mass=1.0, position=(0.0, 0.0), restitution=1.0)
    run = simulate(scene, duration=3.0, steps=300, times=[0.0, 3.0])
    assert run.velocity[-1, :, 0] == pytest.approx([0.5, 1.5], rel=1e-12)
    assert run.energy[-1] == pytest.approx(run.energy[0], rel=1e-12)
    assert run.impacts.time == pytest.approx([1.0], abs=0.011)
    assert run.impacts.bodies.tolist() == [[0, 1]]
    assert run.impacts.normal_velocity == pytest.approx([-1.0])
    assert run.impacts.impulse == pytest.approx([1.5])


@pytest.mark.parametrize("scene", ["tc3", "kepler", "oscillator"])
def test_it_comes_nearer_to_the_exact_answer(scene: str) -> None:
    """Forces, fields and springs are the scene's own: errors fall as steps do, at order 1."""
    asked = catalogue.load(scene)
    best = exact(asked, duration=1.0, times=[1.0])
    errors = [
        np.abs(simulate(asked, duration=1.0, steps=n, times=[1.0]).position - best.position).max()
        for n in (400, 800)
    ]
    assert errors[0] / errors[1] == pytest.approx(2, rel=0.1)


@pytest.fixture
def heard() -> Iterator[None]:
    """A process that was started in the background ignores Ctrl-C; here it is heard."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.usefixtures("heard")
def test_ctrl_c_is_not_lost_in_what_pymunk_calls(capfd: pytest.CaptureFixture[str]) -> None:
    """It would be where C calls Python: cffi prints what is raised there, and goes on."""
    calls = 0

    def push(body: Any) -> tuple[float, float, float]:  # noqa: ARG001
        nonlocal calls
        calls += 1
        if calls == 3:
            signal.raise_signal(signal.SIGINT)
        return 0.0, 0.0, 0.0

    with pytest.raises(KeyboardInterrupt):
        simulate(catalogue.load("tc3"), duration=1.0, steps=100, times=[1.0], push=push)
    assert calls == 3
    assert capfd.readouterr().err == ""
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


@pytest.mark.usefixtures("heard")
def test_ctrl_c_is_not_lost_in_a_contact_that_is_heard(capfd: pytest.CaptureFixture[str]) -> None:
    class Stopping(Chipmunk):
        def _begun(self, arbiter: Any, space: Any, data: Any) -> None:
            super()._begun(arbiter, space, data)
            signal.raise_signal(signal.SIGINT)

    scene = Scene(gravity=(0.0, -9.81), name="fall")
    scene.add_body(Disc(radius=0.5), mass=1.0, position=(0.0, 0.6), restitution=0.0)
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0))
    engine = Stopping(scene, 0.01, listens=True)
    with pytest.raises(KeyboardInterrupt):
        engine.step(1000)
    assert engine.met
    assert capfd.readouterr().err == ""


def test_a_box_comes_to_lie_on_a_thick_floor() -> None:
    scene = Scene(gravity=(0.0, -9.81), name="box")
    scene.add_body(Box(width=1.0, height=1.0), mass=1.0, position=(0.0, 5.0), restitution=0.0)
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0))
    run = simulate(scene, duration=4.0, steps=240, times=[4.0])
    assert run.position[0, 0, 1] == pytest.approx(0.5, abs=1e-3)


def test_restitutions_that_differ_are_refused() -> None:
    scene = Scene(gravity=(0.0, 0.0), name="two")
    for x, kept in ((-2.0, 1.0), (0.0, 1.0), (2.0, 0.5)):
        scene.add_body(Disc(radius=0.5), mass=1.0, position=(x, 0.0), restitution=kept)
    with pytest.raises(PeerError, match="differs from pair to pair"):
        simulate(scene, duration=1.0, steps=10, times=[1.0])


def test_a_box_with_friction_slides_as_far_as_coulomb_says() -> None:
    """v^2/(2 mu g), the oldest sum there is; here 1.019 m."""
    scene = Scene(gravity=(0.0, -9.81), name="slide")
    scene.add_body(
        Box(width=1.0, height=0.2),
        mass=1.0,
        position=(0.0, 0.1),
        velocity=(2.0, 0.0),
        restitution=0.0,
        friction=0.2,
    )
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=0.2)
    run = simulate(scene, duration=2.0, steps=480, times=[2.0])
    assert run.position[0, 0, 0] == pytest.approx(4 / (2 * 0.2 * 9.81), rel=0.02)


def test_a_capsule_lands_on_a_segment() -> None:
    scene = Scene(gravity=(0.0, -9.81), name="capsule")
    capsule = Capsule(length=1.0, radius=0.25)
    scene.add_body(capsule, mass=1.0, position=(0.0, 3.0), restitution=0.0)
    scene.add_static(Segment(length=9.0), position=(0.0, 1.0))
    run = simulate(scene, duration=3.0, steps=480, times=[3.0])
    assert run.position[0, 0, 1] == pytest.approx(1.25, abs=1e-3)


def test_what_is_not_translated_is_refused() -> None:
    scene = Scene(gravity=(0.0, 0.0))
    scene.add_body(Disc(radius=0.5), mass=1.0, position=(0.0, 0.0), category=2)
    with pytest.raises(PeerError, match="filters"):
        simulate(scene, duration=1.0, steps=10, times=[1.0])
    scene = Scene(gravity=(0.0, 0.0))
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), surface_speed=1.0)
    with pytest.raises(PeerError, match="surfaces that run"):
        simulate(scene, duration=1.0, steps=10, times=[1.0])


def test_without_pymunk_it_says_so(bounce: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pymunk", None)
    with pytest.raises(PeerError, match="is not installed"):
        simulate(bounce, duration=1.0, steps=10, times=[1.0])


def test_box2d_comes_nearer_to_impacts_however_slow() -> None:
    """It bounces below 1 m/s, too, and its impacts are told one by one; of impulses nothing is."""
    scene = catalogue.load("oblique-discs")
    best = exact(scene, duration=2.0, times=[2.0])
    errors = []
    for steps in (60, 480):
        run = box2d(scene, duration=2.0, steps=steps, times=[0.0, 1.99, 2.0])
        assert run.position[0] == pytest.approx(exact(scene, duration=2.0, times=[0.0]).position[0])
        assert len(run.impacts) == len(best.impacts)
        assert run.impacts.time == pytest.approx(best.impacts.time, abs=2 * 2.0 / steps)
        errors.append(np.abs(run.position[-1] - best.position[-1]).max())
        assert energy_drift(run) is None
    assert errors[1] < errors[0] / 4


def test_box2d_is_told_no_springs() -> None:
    with pytest.raises(PeerError, match="spring"):
        box2d(catalogue.load("oscillator"), duration=1.0, steps=10, times=[1.0])
