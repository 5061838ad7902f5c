"""Scenes at the ends of what float64 holds: a finite run, or an error with a name."""

import math
import random

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.contact import RangeError, UndecidedContactError
from tamias2d.errors import TamiasError
from tamias2d.motion import ClosedForm
from tamias2d.motion.reference import NoStepError


def dropped(shape, floor=None, *, x=0.0, mass=1.0, friction=0.0) -> t2.Scene:
    scene = t2.Scene(gravity=(0, -9.81))
    floor = floor or t2.HalfPlane(normal=(0, 1), offset=0)
    scene.add_static(floor, restitution=0.5, friction=friction)
    scene.add_body(
        shape,
        mass=mass,
        position=(x, 5),
        velocity=(1, 0),
        restitution=0.5,
        friction=friction,
    )
    return scene


@pytest.mark.parametrize("duration", [5e-324, 1e-193, 1e-100])
@pytest.mark.parametrize("name", ["cradle-touching", "resting"])
def test_a_run_may_be_as_short_as_numbers_are(name, duration):
    run = t2.simulate(t2.catalogue.load(name), duration=duration, method=ClosedForm())
    assert np.isfinite(run.position).all()


@pytest.mark.parametrize("length", [5e-324, 1e-320])
def test_a_line_too_short_for_float64_is_refused(length):
    with pytest.raises(TamiasError, match="float64"):
        t2.simulate(dropped(t2.Disc(radius=1), t2.Segment(length=length)), duration=3.0)


@pytest.mark.parametrize("mass", [1e200, 1e300])
def test_a_mass_whose_square_is_no_number_is_refused(mass):
    with pytest.raises(RangeError, match="float64 holds"):
        t2.simulate(dropped(t2.Disc(radius=1), mass=mass, friction=0.5), duration=3.0)


@pytest.mark.parametrize("x", [1e14, 1e15, 1e16, 1e18, 1e300])
def test_bodies_too_far_away_to_be_told_are_refused(x):
    with pytest.raises(RangeError, match="tells places no nearer than"):
        t2.simulate(dropped(t2.Disc(radius=0.5), x=x), duration=3.0)


@pytest.mark.parametrize("x", [1e6, 1e10])
def test_bodies_far_away_still_land(x):
    run = t2.simulate(dropped(t2.Disc(radius=0.5), x=x), duration=3.0)
    assert len(run.impacts) > 0
    assert run.position[-1, 1, 1] > 0.49


def test_a_force_that_grows_beyond_float64_is_refused_by_name():
    scene = t2.Scene(gravity=(0, 0))
    force = ("1[N]*exp(1000[1/s]*time)", "0[N]")
    scene.add_body(None, mass=1, position=(0, 0), force=force)
    with pytest.raises(NoStepError, match="beyond what float64 holds"):
        t2.simulate(scene, duration=10)


def test_two_bodies_that_slide_on_the_same_line_do_not_hang():
    scene = t2.Scene(gravity=(0, -9.81))
    floor = t2.Segment(length=100)
    scene.add_static(floor, orientation=-0.7887808306511657, restitution=0.0)
    for body, place, angle, velocity in (
        (t2.Segment(length=0.32966347691224634), (0.0826499571, 0.210261207), -3.90894809, (0, 0)),
        (t2.Box(width=0.58409457, height=0.829764484), (0.0, 0.890440502), 0.0, (-0.0878, -0.0199)),
    ):
        scene.add_body(
            body, mass=1, position=place, orientation=angle, velocity=velocity, restitution=0.0
        )
    try:
        t2.simulate(scene, duration=0.5, method=ClosedForm())
    except UndecidedContactError as fault:
        assert "cannot tell" in str(fault)


def anything(seed: int) -> t2.Scene:
    """Return a stack of bodies of all sizes that touch, or nearly do."""
    rng = random.Random(seed)
    size = 10 ** rng.choice([0.0, rng.uniform(-6, 6)])
    scene, y = t2.Scene(gravity=rng.choice([(0, -9.81), (0, -10 * size), (0, 0)])), 0.0

    def some(static):
        length = size * 10 ** rng.choice([0.0, rng.uniform(-3, 3)])
        kinds = [
            t2.Disc(radius=length),
            t2.Box(width=length, height=length),
            t2.Box(width=length, height=length * 10 ** rng.uniform(-3, 0)),
            t2.Segment(length=length),
            t2.Capsule(length=length, radius=length / 3),
        ]
        return rng.choice([*kinds, t2.HalfPlane(normal=(0, 1), offset=0)] if static else kinds)

    def surface():
        return {
            "restitution": rng.choice([0.0, 0.5, 1.0, rng.random()]),
            "friction": rng.choice([0.0, 0.3, 10.0]),
        }

    scene.add_static(some(True), **surface())
    floor = scene.bodies[0].shape
    y = 0.0 if isinstance(floor, t2.HalfPlane) else getattr(floor, "height", 0.0) / 2
    for _ in range(rng.randint(1, 3)):
        shape = some(False)
        half = rng.choice([shape.bounding_radius, getattr(shape, "height", size) / 2])
        y += half * rng.choice([1.0, 1.0, 1.0000001, 1.5])
        scene.add_body(
            shape,
            mass=10 ** rng.choice([0.0, rng.uniform(-6, 6)]),
            position=(rng.choice([0.0, rng.uniform(-0.5, 0.5) * size]), y),
            orientation=rng.choice([0.0, math.pi / 2, math.pi, rng.uniform(-7, 7)]),
            velocity=(rng.choice([0.0, size]), -rng.choice([0.0, size])),
            angular_velocity=rng.choice([0.0, rng.uniform(-5, 5)]),
            **surface(),
        )
        y += half
    return scene


@pytest.mark.parametrize("seed", range(60))
def test_any_scene_ends_in_a_finite_run_or_an_error_with_a_name(seed):
    try:
        run = t2.simulate(anything(seed), duration=0.2, method=ClosedForm())
    except TamiasError:
        return
    assert all(np.isfinite(part).all() for part in (run.position, run.velocity, run.energy))
