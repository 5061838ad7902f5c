"""No certificate bounds the error of a run in which bodies overlap or pass through each other."""

import math
from dataclasses import replace

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.contact import conservative_advancement, instant, manifold
from tamias2d.contact.refusal import Refusal
from tamias2d.motion import ClosedForm, Stepped
from tamias2d.study import penetration
from tamias2d.study.penetration import penetrations


def rod(orientation: float = 0.0) -> t2.Scene:
    scene = t2.Scene(gravity=(0, -9.81))
    scene.add_static(t2.Segment(length=20), restitution=0.0)
    scene.add_body(
        t2.Segment(length=1), mass=1, position=(0, 1), orientation=orientation, restitution=0.0
    )
    return scene


@pytest.fixture
def blind(monkeypatch):
    """The search for impacts as it was: it forgets the side on which thin bodies were."""
    for module in (conservative_advancement, manifold):
        monkeypatch.setattr(module, "from_side", lambda _a, _b, found, _ahead: found)
    monkeypatch.setattr(instant, "either_side", lambda *_: None)


@pytest.mark.usefixtures("blind")
@pytest.mark.parametrize("orientation", [0.0, 0.1])
def test_a_rod_that_falls_through_a_line_has_no_bound(orientation):
    run = t2.simulate(rod(orientation), duration=1.0, method=ClosedForm())
    assert run.position[-1, 1, 1] < -0.1  # it falls through
    certificate = t2.certify(run).certificate
    assert certificate is not None
    assert (certificate.kind, certificate.bound) == ("none", None)
    assert "'body0' and 'body1' pass through each other at 0.45" in certificate.how


def test_a_rod_that_lands_has_a_bound():
    certificate = t2.certify(t2.simulate(rod(), duration=1.0)).certificate
    assert certificate is not None
    assert certificate.kind == "exact"


def moved(monkeypatch, scene: t2.Scene, paths) -> list[penetration.Penetration]:
    """Look at a run in which all bodies follow paths given as functions of time."""
    run = t2.simulate(replaced(scene), duration=1.0, method=ClosedForm())

    def sample(times, bodies):
        rows = np.array([[paths[k](t) for k in bodies] for t in times])
        slopes = np.gradient(rows, axis=0) * 0.0
        return penetration.History(rows[..., :2], rows[..., 2], slopes[..., :2], slopes[..., 2])

    monkeypatch.setattr(penetration, "sampler", lambda _: sample)
    return list(penetrations(replace(run, scene=scene)))


def replaced(scene: t2.Scene) -> t2.Scene:
    """Return as many bodies that cannot meet."""
    free = t2.Scene(gravity=(0, 0))
    for k in range(len(scene)):
        free.add_body(t2.Disc(radius=0.1), mass=1, position=(10.0 * k, 0), restitution=0.0)
    return free


def pair(a, b) -> t2.Scene:
    scene = t2.Scene(gravity=(0, 0))
    scene.add_static(a, restitution=0.0)
    scene.add_body(b, mass=1, position=(0, 5), restitution=0.0)
    return scene


LINE = t2.Segment(length=2)
SHAPES = [
    LINE,
    t2.Box(width=2, height=1e-12),
    t2.Capsule(length=2, radius=1e-12),
    t2.Disc(radius=0.1),
    t2.Box(width=1, height=0.5),
]


@pytest.mark.parametrize("body", SHAPES)
@pytest.mark.parametrize("turn", [0.0, 0.3, math.pi / 2])
@pytest.mark.parametrize("speed", [1.0, 4.0, 1e4])
def test_a_passage_is_seen(monkeypatch, body, turn, speed):
    def falls(t: float) -> tuple[float, float, float]:
        return 0.1, 3.0 - speed * t if speed < 1e3 else 3.0 - speed * (t - 0.3), turn

    found = moved(monkeypatch, pair(LINE, body), [lambda _: (0.0, 0.0, 0.0), falls])
    crosses = 3.0 - speed * 1.0 < -0.1
    assert bool(found) == crosses


@pytest.mark.parametrize("body", SHAPES)
def test_a_body_that_goes_around_the_end_does_not_pass(monkeypatch, body):
    def around(t: float) -> tuple[float, float, float]:
        angle = math.pi * (0.5 - t)
        return 2.2 * math.cos(angle), 2.2 * math.sin(angle), 0.0

    still = (0.0, 0.0, 0.0)
    assert moved(monkeypatch, pair(LINE, body), [lambda _: still, around]) == []


def test_a_rod_that_tips_over_on_its_end_does_not_pass(monkeypatch):
    def tips(t: float) -> tuple[float, float, float]:
        angle = math.pi * t
        return math.cos(angle), math.sin(angle), angle

    paths = [lambda _: (0.0, 0.0, 0.0), tips]
    assert moved(monkeypatch, pair(LINE, LINE), paths) == []


def test_a_short_overlap_between_samples_is_seen_and_named(monkeypatch):
    def dips(t: float) -> tuple[float, float, float]:
        return 0.0, 0.1 + 400 * (t - 0.4991) ** 2 - 1e-3, 0.0

    (found,) = moved(
        monkeypatch,
        pair(t2.HalfPlane(normal=(0, 1), offset=0), t2.Disc(radius=0.1)),
        [lambda _: (0.0, 0.0, 0.0), dips],
    )
    assert found.bodies == (0, 1)
    assert 0 < found.depth <= 1e-3
    assert found.time == pytest.approx(0.4991, abs=2e-3)


def test_steps_that_press_bodies_a_little_keep_their_bound():
    scene = t2.Scene(gravity=(0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), restitution=0.0)
    scene.add_body(t2.Box(width=1, height=1), mass=1, position=(0, 0.6), restitution=0.0)
    run = t2.simulate(scene, duration=1.0, method=Stepped(), time_step=1 / 60)
    assert list(penetrations(run)) == []


def test_a_run_that_was_refused_is_looked_at_as_far_as_it_went():
    scene = t2.Scene(gravity=(0, 0))
    for x in (-1.0, 1.0):  # corner meets corner, and stays
        body = t2.Box(width=0.2, height=0.2)
        scene.add_body(body, mass=1, position=(x, x), velocity=(-x, -x), restitution=0.0)
    with pytest.raises(Refusal) as fault:
        t2.simulate(scene, duration=2.0, method=ClosedForm())
    assert list(penetrations(fault.value.run)) == []
