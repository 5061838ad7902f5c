"""What errors are relative to: how far the farthest body goes of those that forces move."""

import re

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.motion import Stepped
from tamias2d.scene import Scene
from tamias2d.study.refined import refined
from tamias2d.study.scale import farthest, length_of, scale

G = 9.81
SPEED, FRICTION = 0.3, 0.4
WAY = SPEED**2 / (2 * FRICTION * G)  # m, until friction has stopped it
TIME = SPEED / (FRICTION * G)


def sliding(width: float = 10.0, speed: float = SPEED) -> Scene:
    """Return a box that friction stops, beside a sensor that nothing meets: so it is stepped."""
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(
        t2.Box(width=width, height=0.2), mass=2.0, position=(0.0, 0.1), velocity=(speed, 0.0),
        friction=FRICTION, restitution=0.0, name="box",
    )  # fmt: skip
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, friction=FRICTION, restitution=0.0, name="floor")
    scene.add_static(t2.Disc(radius=0.1), position=(50.0, 5.0), sensor=True, name="sensor")
    return scene


def with_tram(scene: Scene, speed: float) -> Scene:
    """Add a disc that moves as it is told, far from all others."""
    scene.add_kinematic(
        t2.Disc(radius=0.1), position=(0.0, 50.0), velocity=(speed, 0.0), restitution=0.0,
        name="tram",
    )  # fmt: skip
    return scene


def slid(times: np.ndarray) -> np.ndarray:
    """Return how far the box has come, m."""
    t = np.minimum(times, TIME)
    return SPEED * t - FRICTION * G * t**2 / 2


def said(run: t2.Run) -> tuple[float, str]:
    """Return the length that a certificate is relative to, and what it says of it."""
    assert run.certificate is not None
    found = re.search(r"relative to the (\S+) m (.*)", run.certificate.measure)
    assert found is not None
    return float(found[1]), found[2]


@pytest.mark.parametrize("width", [10.0, 0.4])
def test_a_slide_much_shorter_than_the_box_is_within_its_tolerance(width: float) -> None:
    """It was relative to half the diagonal of the box, and the certificate said to the way."""
    run = t2.simulate(sliding(width), duration=0.1, tolerance=1e-2)
    assert isinstance(run.method, Stepped)
    length, of = said(run)
    assert of == "that the farthest one goes"
    assert length == pytest.approx(WAY, rel=1e-2)
    error = np.abs(run.position[:, 0, 0] - slid(run.times)).max()
    assert error <= 1e-2 * WAY
    assert run.certificate is not None
    assert run.certificate.bound is not None
    assert error <= run.certificate.bound * length


def test_the_way_is_not_that_of_samples_alone() -> None:
    """Where only the end is asked for, what is gone is known all the same."""
    run = t2.simulate(sliding(), duration=0.1, method=Stepped(), time_step=1 / 4000, times=[0.1])
    length, of = said(t2.certify(run))
    assert of == "that the farthest one goes"
    assert length == pytest.approx(WAY, rel=1e-2)


def test_what_moves_as_told_makes_no_tolerance_looser() -> None:
    found = []
    for speed in (10.0, 1000.0):
        run = t2.simulate(with_tram(sliding(0.4), speed), duration=0.1, tolerance=1e-2)
        length, of = said(run)
        assert of == "that the farthest dynamic one goes"
        assert length == pytest.approx(WAY, rel=1e-2)
        found.append((run.method, run.time_step))
        assert np.abs(run.position[:, 0, 0] - slid(run.times)).max() <= 1e-2 * WAY
    assert found[0] == found[1]


def test_what_moves_as_told_counts_in_no_measure() -> None:
    """Nor where a run alone is looked at, or the extents that a path had so far."""
    runs = [
        t2.simulate(scene, duration=0.1, method=Stepped(), time_step=1 / 600)
        for scene in (sliding(), with_tram(sliding(), 70.0))
    ]
    assert scale(runs[0]) == scale(runs[1]) == pytest.approx(WAY, rel=0.1)
    extent = np.array([[3.0, 4.0, 0.0], *[[0.0, 0.0, 0.0]] * 2, [70.0, 0.0, 0.0]])
    assert farthest(runs[1].scene, extent) == farthest(runs[1].scene, extent[:1]) == 5.0


def test_where_all_that_moves_is_told_nothing_else_does() -> None:
    run = t2.simulate(with_tram(Scene(gravity=(0.0, 0.0)), 70.0), duration=1.0)
    assert length_of(run) == (1.0, False)
    assert (
        said(t2.certify(run))[1] == "taken where nothing moves but as it is told or by sinking in"
    )


def test_what_rests_and_sinks_in_is_relative_to_its_size() -> None:
    run = t2.simulate(sliding(1.0, speed=0.0), duration=0.5, tolerance=1e-3)
    assert isinstance(run.method, Stepped)
    assert np.ptp(run.position[:, 0, 1]) > 0.0
    length, of = said(run)
    assert of == "taken where nothing moves but by sinking in"
    assert length == pytest.approx(np.hypot(0.5, 0.1))


def test_a_slide_of_a_thousandth_of_the_size_is_no_sinking_in() -> None:
    speed = SPEED / 30
    run = t2.simulate(sliding(speed=speed), duration=TIME / 20, tolerance=1e-1)
    length, of = said(run)
    assert of == "that the farthest one goes"
    assert length == pytest.approx(WAY / 900, rel=0.1)


def test_a_way_that_one_length_of_steps_takes_for_sinking_in_is_one() -> None:
    times = np.linspace(0.0, 0.5, 31)
    rests, moves = (
        refined(sliding(1.0, speed), duration=0.5, times=times, time_step=1 / 60, grid=1 / 60)
        for speed in (0.0, SPEED)
    )
    assert rests.after(rests).whole == (np.hypot(0.5, 0.1), False)
    assert rests.after(moves).whole.moves
