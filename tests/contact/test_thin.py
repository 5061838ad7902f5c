"""Thin bodies are solid: nothing passes through a line, however it lands."""

import math
import random

import pytest

import tamias2d as t2
from tamias2d.contact import Refusal
from tamias2d.event_driven import LIBRARY
from tamias2d.motion import ClosedForm
from tamias2d.study.penetration import penetrations

THICKNESSES = (1e-300, 1e-16, 1e-15, 1e-12, 1e-6, 1e-3)


def fallen(floor, body, *, orientation=0.0, velocity=(0.0, 0.0), spin=0.0, restitution=0.0, x=0.0):
    scene = t2.Scene(gravity=(0, -9.81))
    scene.add_static(floor, restitution=restitution)
    scene.add_body(
        body,
        mass=1,
        position=(x, 1.0),
        orientation=orientation,
        velocity=velocity,
        angular_velocity=spin,
        restitution=restitution,
    )
    return t2.simulate(scene, duration=2.0, method=ClosedForm())


@pytest.mark.parametrize("orientation", [0.0, math.pi, 1e-15, 1e-11, -1e-3, 0.1, math.pi / 2, 3.0])
@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
def test_a_rod_stays_above_a_line(orientation, restitution):
    run = fallen(
        t2.Segment(length=20),
        t2.Segment(length=1),
        orientation=orientation,
        restitution=restitution,
    )
    assert run.position[:, 1, 1].min() > -1e-12
    assert len(run.impacts)


def test_what_is_thin_is_not_left_to_compiled_code():
    """It does not remember from which side thin bodies have met, and let this rod pass."""
    LIBRARY.compiled()
    assert LIBRARY.is_loaded()
    run = fallen(t2.Segment(length=20), t2.Segment(length=1), restitution=0.5)
    assert run.position[:, 1, 1].min() > -1e-12


@pytest.mark.parametrize("thickness", THICKNESSES)
@pytest.mark.parametrize("orientation", [0.0, math.pi, 1e-12, 0.1])
def test_a_board_of_any_thickness_stays_above_a_line(thickness, orientation):
    board = t2.Box(width=1, height=thickness)
    run = fallen(t2.Segment(length=20), board, orientation=orientation)
    assert run.position[-1, 1, 1] > -1e-12


@pytest.mark.parametrize("thickness", THICKNESSES)
def test_a_line_stays_above_a_board_of_any_thickness(thickness):
    run = fallen(t2.Box(width=20, height=thickness), t2.Segment(length=1))
    assert run.position[-1, 1, 1] > -1e-12


def test_a_rod_whose_end_meets_the_end_of_a_line_does_not_pass():
    try:
        run = fallen(t2.Segment(length=1), t2.Segment(length=0.2), x=0.4, orientation=-1e-10)
    except Refusal as refusal:  # corner on corner, and flat
        run = refusal.run
    assert run.position[:, 1, 1].min() > -1e-9


def test_a_rod_put_on_a_line_rests_there():
    scene = t2.Scene(gravity=(0, -9.81))
    scene.add_static(t2.Segment(length=20), restitution=0.0)
    scene.add_body(t2.Segment(length=1), mass=1, position=(0, 0), restitution=0.0)
    run = t2.simulate(scene, duration=1.0, method=ClosedForm())
    assert run.position[-1, 1].tolist() == [0.0, 0.0]


def shape(rng: random.Random):
    length, thickness = 10 ** rng.uniform(-1, 0.5), 10 ** rng.uniform(-16, 0)
    angles = [k * math.tau / 5 for k in range(5)]
    return rng.choice(
        [
            t2.Segment(length=length),
            t2.Box(width=length, height=thickness),
            t2.Capsule(length=length, radius=thickness),
            t2.Disc(radius=length / 4),
            t2.Polygon(vertices=[(length * math.cos(a), length * math.sin(a)) for a in angles]),
        ]
    )


@pytest.mark.parametrize("seed", range(48))
def test_nothing_passes_through_anything(seed):
    rng = random.Random(seed)
    restitution = rng.choice([0.0, 1.0, rng.random()])
    friction = rng.choice([0.0, 0.4])
    scene = t2.Scene(gravity=(0, -9.81))
    floor = rng.choice([t2.Segment(length=20), t2.Box(width=20, height=1e-9), shape(rng)])
    scene.add_static(floor, restitution=restitution, friction=friction)
    body = shape(rng)
    scene.add_body(
        body,
        mass=1,
        position=(rng.choice([0.0, rng.uniform(-1, 1)]), 5.0 + floor.bounding_radius % 9),
        orientation=rng.choice([0.0, math.pi / 2, rng.uniform(-7, 7)]),
        velocity=(0.0, -rng.choice([0.0, 1.0, 100.0])),
        angular_velocity=rng.choice([0.0, rng.uniform(-3, 3), rng.uniform(-100, 100)]),
        restitution=restitution,
        friction=friction,
    )
    try:
        run = t2.simulate(scene, duration=1.5, method=ClosedForm())
    except Refusal as refusal:
        run = refusal.run
    assert list(penetrations(run)) == []


@pytest.mark.parametrize(("count", "told"), [(101, True), (99, False)])
def test_a_run_tells_where_thin_bodies_may_pass_each_other(count, told):
    scene = t2.Scene(gravity=(0, 0))
    for k in range(count - 2):
        speed = 0.0 if k else 9.0  # two discs may meet
        scene.add_body(
            t2.Disc(radius=0.1), mass=1, position=(k, 0.0), velocity=(speed, 0.0), restitution=1
        )
    for name in ("one", "other"):
        at = (-5.0, len(name))
        scene.add_body(t2.Segment(length=1), mass=1, position=at, restitution=1, name=name)
    run = t2.simulate(scene, duration=0.1, method=ClosedForm())
    assert any("'one' and 'other'" in note for note in run.notes) == told
