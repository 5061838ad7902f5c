"""The time of impact where bodies pass close by each other, and bounds within a window."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.contact import conservative_advancement
from tamias2d.contact.conservative_advancement import Pair
from tamias2d.contact.core import cores_of, place
from tamias2d.contact.gap import resolution
from tamias2d.contact.manifold import manifold
from tamias2d.motion.polynomial import Polynomial
from tamias2d.motion.uniform import Uniform
from tamias2d.state import State
from tools.measurements.drops import drop
from tools.measurements.located_drops import ROUNDING, laws


@pytest.mark.parametrize("turning", [0.0, 1e-13])
@pytest.mark.parametrize("gap", [1e-7, 1e-9, 1e-12])
def test_a_body_that_falls_close_beside_another_is_looked_at_a_few_times(
    turning: float, gap: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also where the other turns by next to nothing: gravity is along its side."""
    monkeypatch.setattr(conservative_advancement, "_MAX_STEPS", 50)
    scene = t2.Scene(gravity=(0.0, 0.0))
    beside, tip = 0.5 + gap + math.sqrt(0.5), math.pi / 4
    for x, turn in ((0.0, 0.0), (beside, tip)):
        box = t2.Box(width=1.0, height=1.0)
        scene.add_body(box, mass=1.0, position=(x, 0.5), orientation=turn)
    a, b = cores_of(scene)
    stands = State((0.0, 0.5), 0.0, (0.0, 0.0), 0.0)
    falls = State((beside, 0.5), tip, (0.0, -0.1), 0.0)
    paths = (
        Uniform(start=0.0, end=0.02, state=stands, acceleration=(0.0, 0.0, turning)),
        Uniform(start=0.0, end=0.02, state=falls, acceleration=(0.0, -9.81, 0.0)),
    )
    assert Pair(a, b, *paths).time_of_impact(0.0, 0.02) is None


def test_a_box_that_parts_at_one_corner_comes_down_on_the_next() -> None:
    """One corner rests on the floor and is pulled up; the box is flat at a known time."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0))
    scene.add_body(t2.Box(width=1.0, height=1.0), mass=1.0, position=(0.0, 0.5))
    floor, box = cores_of(scene)
    tilt, spin, pull = 1e-12, -1.0, 2.0
    x, y = place(box, State((0.0, 0.0), tilt, (0.0, 0.0), spin)).corners[0]
    state = State((0.0, -y), tilt, (0.0, -spin * x), spin)
    still = State((0.0, 0.0), 0.0, (0.0, 0.0), 0.0)
    paths = (
        Uniform(start=0.0, end=1.0, state=still, acceleration=(0.0, 0.0, 0.0)),
        Uniform(start=0.0, end=1.0, state=state, acceleration=(0.0, pull, 0.0)),
    )
    a, b = place(floor, still), place(box, state)
    touching = manifold(a, b, resolution(a, b, 0.0), 0.0)
    assert len(touching) == 1
    met = Pair(floor, box, *paths).separation_time(0.0, 1e-8, pull - spin**2 * y, touching)
    assert met == pytest.approx(tilt / -spin, rel=1e-3)


def test_what_was_found_of_a_pair_that_parts_holds_no_more_on_other_paths() -> None:
    """A pentagon that rocks on its corners stops to slide soon after one of them has parted."""
    run = t2.simulate(drop(9500070), duration=1.421, method=t2.ClosedForm())
    assert laws(run)["overlap"] <= ROUNDING


@pytest.mark.parametrize("seed", range(20))
def test_bounds_within_a_window_hold_and_are_no_wider_than_those_of_the_step(seed: int) -> None:
    """Against values at many times of the window."""
    chance = np.random.default_rng(seed)
    powers = chance.normal(size=(9, 3)) / (1 + np.arange(9))[:, None] ** 2
    state = State((0.0, 0.0), 0.0, (0.0, 0.0), 0.0)
    path = Polynomial(1.0, 3.0, state, state, powers.tolist())
    first = float(chance.uniform(1.0, 2.9))
    last = first + float(chance.uniform(0.0, 0.1))
    near, far = path.bounds(first, last), path.bounds(1.0, 3.0)
    times = np.linspace(first, last, 50)[1:-1].tolist()
    rates = [path.at(time) for time in times]
    bends = [path.acceleration(time) for time in times]
    little = 1 + 1e-12
    away = [math.hypot(x - near.acceleration[0], y - near.acceleration[1]) for x, y, _ in bends]
    assert max(away) <= near.deviation * little + 1e-12
    assert max(math.hypot(*state.velocity) for state in rates) <= near.speed * little
    assert max(abs(state.angular_velocity) for state in rates) <= near.angular_speed * little
    assert max(abs(turn) for *_, turn in bends) <= near.angular_acceleration * little
    assert near.deviation <= far.deviation
    assert near.speed <= far.speed
    assert near.angular_acceleration <= far.angular_acceleration * little


@pytest.mark.parametrize("seed", [50001, 50045])
def test_ordinary_drops_are_located_to_the_end(seed: int) -> None:
    """Of both it was once said that float64 cannot tell whether two of the bodies part."""
    run = t2.simulate(drop(seed), duration=3.0, method=t2.ClosedForm())
    assert run.times[-1] == 3.0
    energy = run.energy
    assert (np.diff(energy) <= 1e-9 * np.ptp(energy)).all()


def test_a_corner_comes_down_beside_a_lasting_contact_though_its_angle_stands_still() -> None:
    """The box is flat at a known time; near it float64 has one angle for 1000 steps and more."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(t2.Box(width=4.0, height=4.0))
    scene.add_body(t2.Box(width=1.0, height=1.0), mass=1.0, position=(0.0, 2.5))
    floor, box = cores_of(scene)
    spin, tilt, slope = -0.00018898828628479013, 1.641659605597502e-11, -6.6321392926984e-11
    state = State((0.0, 0.0), 1.5 * math.pi + slope + tilt, (0.0, 0.0), spin)
    x, y = min(place(box, state).corners, key=lambda corner: corner[1] - slope * corner[0])
    state = state._replace(position=(0.0, 2.0 - y + slope * x), velocity=(spin * y, -spin * x))
    still = State((0.0, 0.0), slope, (0.0, 0.0), 0.0)
    paths = (
        Uniform(start=2.0, end=3.0, state=still, acceleration=(0.0, 0.0, 0.0)),
        Uniform(start=2.0, end=3.0, state=state, acceleration=(0.0, 0.0, 0.0)),
    )
    a, b = place(floor, still), place(box, state)
    lasting = manifold(a, b, 1e-15, 2.0)
    assert len(lasting) == 1
    met = Pair(floor, box, *paths, lasting).time_of_impact(2.0, 3.0)
    assert met == pytest.approx(2.0 + tilt / -spin, rel=0, abs=2e-15 / -spin)  # two last places


@pytest.mark.parametrize(("seed", "duration"), [(9600315, 1.2), (9600658, 2.45)])
def test_a_pair_that_opens_by_rounding_and_comes_back_is_located(seed, duration):
    """Drops in which a box that turns presses a body again right after they seemed to part."""
    times = np.linspace(0.0, duration, 721)
    run = t2.simulate(drop(seed), duration=duration, method=t2.ClosedForm(), times=times)
    assert max(laws(run).values()) < ROUNDING


def _opening(rate: float, acceleration: float) -> Pair:
    """Return a pair of discs that touch and open, or are pressed back."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    for x in (0.0, 1.0):
        scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(x, 0.0))
    a, b = cores_of(scene)
    still = State((0.0, 0.0), 0.0, (0.0, 0.0), 0.0)
    goes = State((1.0, 0.0), 0.0, (rate, 0.0), 0.0)
    return Pair(
        a,
        b,
        Uniform(start=0.0, end=1.0, state=still, acceleration=(0.0, 0.0, 0.0)),
        Uniform(start=0.0, end=1.0, state=goes, acceleration=(acceleration, 0.0, 0.0)),
    )


def test_a_pair_that_opens_slowly_is_found_apart_unless_it_comes_back():
    apart = _opening(1e-10, 1e-2)._time_apart(0.0, 1e-12, 1.0)
    assert apart is not None
    assert 1e-7 < apart < 1e-2  # where 1e-10 t + 1e-2 t^2/2 is more than rounding
    assert _opening(1e-10, -1e-2)._time_apart(0.0, 1e-12, 1.0) is None
