"""Bounces that slide or stick while they end: oracles that follow each bounce, or need none."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.event_driven import EventDriven
from tests.contact.bounces import Bounces, errors
from tools.measurements.drops import drop
from tools.measurements.located_drops import ROUNDING, laws

G = 9.81
EPSILON = 2.0**-52
DISC, BOX = t2.Disc(radius=0.3), t2.Box(width=2.0, height=0.6)


def dropped(
    shape: t2.Disc | t2.Box, *, restitution: float, friction: float, slope: float = 0.0,
    height: float = 0.4, speed: float = 0.0, spin: float = 0.0,
) -> t2.Scene:  # fmt: skip
    """A body that falls on a slope, which falls to the right, and moves along it."""
    scene = t2.Scene(gravity=(0.0, -G))
    x, y = math.sin(slope), math.cos(slope)
    scene.add_static(t2.HalfPlane(normal=(x, y), offset=0.0))
    scene.add_body(
        shape,
        mass=1.7,
        position=((0.3 + height) * x, (0.3 + height) * y),
        orientation=-slope if shape == BOX else 0.0,
        velocity=(speed * y, -speed * x),
        angular_velocity=spin,
        restitution=restitution,
        friction=friction,
    )
    return scene


def followed(scene: t2.Scene) -> t2.Run:
    """The run, with samples just after the last bounce, and later."""
    end = Bounces(scene).end
    times = [0.0, end * (1 + 1e-9) + 1e-9, 1.01 * end + 0.01, 1.5 * end + 0.5]
    return t2.simulate(scene, duration=times[-1], times=times, method=t2.ClosedForm())


def rounding(run: t2.Run) -> tuple[float, float]:
    """What rounding at each impact, and a few more, may do to place and velocity, m and m/s."""
    speed = np.hypot(*run.velocity[:, 1].T).max() + np.abs(run.angular_velocity[:, 1]).max()
    place = np.abs(run.position[:, 1]).max() + run.times[-1] * float(speed)
    share = EPSILON * (10 + len(run.impacts))
    return share * place, share * float(speed)


@pytest.mark.parametrize(
    ("shape", "restitution"), [*((DISC, e) for e in (0.1, 0.5, 0.9, 0.99)), (BOX, 0.1), (BOX, 0.9)]
)
@pytest.mark.parametrize("friction", [0.01, 0.1, 0.3])
@pytest.mark.parametrize("slope", [0.0, 0.2])
def test_what_slides_keeps_the_friction_of_all_bounces(shape, restitution, friction, slope):
    """At 20 m/s, and in up to 1600 bounces. (A box that bounces more than that begins to rock.)"""
    run = followed(
        dropped(shape, restitution=restitution, friction=friction, slope=slope, speed=20.0)
    )
    (off, strayed), (place, velocity) = errors(run), rounding(run)
    assert off.max() < place
    assert strayed.max() < velocity


@pytest.mark.parametrize("spin", [-200.0, 30.0, 200.0])
@pytest.mark.parametrize("friction", [0.1, 1.0])
def test_spin_and_speed_end_in_rolling(spin, friction):
    run = followed(dropped(DISC, restitution=0.5, friction=friction, speed=3.0, spin=spin))
    (off, strayed), (place, velocity) = errors(run), rounding(run)
    assert off.max() < place
    assert strayed.max() < velocity


@pytest.mark.parametrize("shape", [DISC, BOX])
@pytest.mark.parametrize("restitution", [0.5, 0.8])
def test_what_sticks_creeps_in_the_bounces_that_are_left(shape, restitution):
    """On a slope each flight brings it on; what is cut of them is more than rounding.

    Roundings of height and time at each impact add up to 1/(1 - e^2) of them.
    """
    run = followed(dropped(shape, restitution=restitution, friction=1.0, slope=0.5))
    off, strayed = errors(run)
    length = np.abs(run.position[:, 1]).max()
    assert off.max() < 8 * EPSILON * length / (1 - restitution**2)
    assert strayed.max() <= rounding(run)[1]


def test_slip_that_ends_among_the_bounces_that_are_left():
    """The slip at the last located bounce is less than what those that are left would take."""
    for speed in np.linspace(1e-8, 4e-7, 8):
        scene = dropped(DISC, restitution=0.5, friction=0.1, height=2e-14, speed=float(speed))
        off, strayed = errors(followed(scene))
        assert off.max() < 1e-14  # the friction coefficient times the height of a bounce
        assert strayed.max() < 1e-16


def test_two_bodies_that_press_on_each_other():
    """Neither depends on the bounces: momentum, and the slip with what is left of the approach.

    A board that hardly turns is pushed up against a disc that slides along it.
    """
    scene = t2.Scene(gravity=(0.0, 0.0))
    mass, other, push, friction = 1.5, 4.0, 7.0, 0.2
    scene.add_body(
        t2.Box(width=60.0, height=0.4), mass=other, inertia=1e16, position=(0.0, -0.2),
        force=(0.0, push), restitution=0.6, friction=friction,
    )  # fmt: skip
    inertia = 0.5 * mass * 0.3**2
    scene.add_body(
        DISC, mass=mass, inertia=inertia, position=(-5.0, 0.4), velocity=(12.0, 0.0),
        force=(0.0, -push), restitution=0.6, friction=friction,
    )  # fmt: skip
    run = t2.simulate(scene, duration=2.0, method=t2.ClosedForm())
    assert any(note.startswith("rest:") for note in run.notes)
    momentum = mass * run.velocity[:, 1, 0] + other * run.velocity[:, 0, 0]
    np.testing.assert_allclose(momentum, mass * 12.0, rtol=1e-14)
    given = push * friction * run.times[-1]  # by friction, as if they touched all the time
    assert run.velocity[-1, 1, 0] == pytest.approx(12.0 - given / mass, rel=1e-13)
    assert run.angular_velocity[-1, 1] == pytest.approx(-0.3 * given / inertia, rel=1e-13)


@pytest.mark.parametrize("seed", range(12))
def test_certificates_bound_drops_that_slide(seed):
    chance = np.random.default_rng(seed)
    scene = dropped(
        DISC,
        restitution=float(chance.uniform(0.1, 0.9)),
        friction=float(chance.uniform(0.02, 0.3)),
        slope=float(chance.choice([0.0, 0.3])),
        height=float(10 ** chance.uniform(-2, 0)),
        speed=float(chance.uniform(5.0, 40.0)),
        spin=float(chance.normal(0, 20)),
    )
    run = followed(scene)
    certificate = t2.certify(run).certificate
    assert certificate is not None
    assert certificate.kind == "exact"
    assert certificate.bound is not None
    way = float(np.hypot(*np.ptp(run.position[:, 1], axis=0)))
    assert errors(run)[0].max() / way <= certificate.bound < 1e-13


def test_a_body_that_rocks_is_told_to_rest_when_it_does(monkeypatch: pytest.MonkeyPatch) -> None:
    """It comes down on one corner after another; until then the floor pushes by impacts alone."""
    monkeypatch.setattr(EventDriven, "pays", lambda *_: False)  # which the clock decides
    times = np.linspace(0.0, 3.0, 721)
    run = t2.simulate(drop(9600199), duration=3.0, method=t2.ClosedForm(), times=times)
    assert sum(note.startswith("rest:") for note in run.notes) == 1
    assert max(laws(run).values()) <= ROUNDING
