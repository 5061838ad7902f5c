"""What bounces come to, and contacts that last: oracle B6, and mechanics with known answers."""

import math
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.generated import rest

G = 9.81
FLOOR = t2.HalfPlane(normal=(0, 1), offset=0)
BOX = t2.Box(width=1, height=1)


def dropped(shape: t2.Disc | t2.Box, *, height: float, restitution: float, **motion) -> t2.Scene:
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(FLOOR)
    scene.add_body(shape, mass=1, position=(0, height), restitution=restitution, **motion)
    return scene


def rest_time(run: t2.Run) -> float:
    return float(run.notes[-1].split()[-2])


@pytest.mark.parametrize(
    ("restitution", "zeno"),
    [(0.5, 1.3545709229571927), (0.8, 4.0637127688715781), (0.9, 8.5789491787288872)],
)
def test_bounces_end_at_the_zeno_time(restitution, zeno):
    """B6: t1 (1 + e)/(1 - e), then rest, to the bit."""
    run = t2.simulate(dropped(t2.Disc(radius=0.5), height=1.5, restitution=restitution), duration=9)
    assert rest_time(run) == pytest.approx(zeno, abs=1e-13)
    after = run.times > zeno + 1e-6
    assert run.velocity[after].max() == 0
    assert len(set(run.position[after, 1, 1])) == 1
    assert run.position[-1, 1, 1] == pytest.approx(0.5, abs=4e-15)


def test_impact_times_and_apexes():
    """B6: t_n = t1 (1 + 2 sum e^i) and apex_n = h e^(2 n)."""
    e, first = 0.8, math.sqrt(2 / G)
    at = [first * (1 + 2 * sum(e**i for i in range(1, n))) for n in range(1, 9)]
    tops = [t + first * e ** (n + 1) for n, t in enumerate(at)]
    scene = dropped(t2.Disc(radius=0.5), height=1.5, restitution=e)
    run = t2.simulate(scene, duration=4.0, times=tops)
    np.testing.assert_allclose(run.impacts.time[:8], at, rtol=0, atol=2e-14)
    np.testing.assert_allclose(
        run.position[:, 1, 1] - 0.5, [e ** (2 * n) for n in range(1, 9)], atol=2e-14
    )


def test_elastic_bounce_keeps_its_apex():
    """X8: 110 bounces in 100 s."""
    tops = [2 * k * math.sqrt(2 / G) for k in range(1, 111)]
    scene = dropped(t2.Disc(radius=0.5), height=1.5, restitution=1.0)
    run = t2.simulate(scene, duration=100.0, times=tops)
    assert np.abs(run.position[:, 1, 1] - 1.5).max() < 1e-12


@pytest.mark.parametrize("restitution", [0.0, 1e-12, 1e-3, 0.5])
def test_flat_box_comes_to_rest(restitution):
    run = t2.simulate(dropped(BOX, height=1.5, restitution=restitution), duration=3)
    fall = math.sqrt(2 / G)
    assert rest_time(run) == pytest.approx(fall * (1 + restitution) / (1 - restitution), abs=1e-13)
    assert run.angular_velocity[-1, 1] == 0
    assert run.velocity[-1, 1].tolist() == [0, 0]


@pytest.mark.parametrize("restitution", [0.0, 0.2, 0.5, 0.8])
@pytest.mark.parametrize("spin", [0.0, 3.0])
def test_tilted_square_comes_to_rest_flat(restitution, spin):
    """Corners in turn, one of them in lasting contact meanwhile, until it lies flat."""
    scene = dropped(
        BOX,
        height=2,
        restitution=restitution,
        orientation=0.3,
        velocity=(0.25, 0),
        angular_velocity=spin,
    )
    run = t2.simulate(scene, duration=8.0)
    quarter_turns = run.orientation[-1, 1] / (math.pi / 2)
    assert quarter_turns == pytest.approx(round(quarter_turns), abs=1e-12)
    assert run.position[-1, 1].tolist() == pytest.approx([2.0, 0.5], abs=1e-11)
    assert run.angular_velocity[-1, 1] == 0
    assert run.velocity[-1, 1].tolist() == pytest.approx([0.25, 0], abs=1e-12)
    assert (np.diff(run.energy) <= 1e-11).all()


@pytest.mark.parametrize("heaviest", [1.0, 1e6])
def test_stack_stands_to_the_bit(heaviest):
    """X2: a heavy box on light ones, each shifted a little."""
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(FLOOR)
    for k in range(8):
        mass = heaviest if k == 7 else 1.0
        scene.add_body(BOX, mass=mass, position=(0.1 * (k % 2), 0.5 + k), restitution=0.5)
    run = t2.simulate(scene, duration=10.0)
    assert np.array_equal(run.position[-1], run.position[0])
    assert np.array_equal(run.orientation[-1], run.orientation[0])


def test_box_slides_down_an_incline():
    angle = math.radians(30)
    normal = (math.sin(angle), math.cos(angle))
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(t2.HalfPlane(normal=normal, offset=0))
    centre = (0.5 * normal[0], 0.5 * normal[1])
    scene.add_body(BOX, mass=2, position=centre, orientation=-angle, restitution=0.5)
    run = t2.simulate(scene, duration=4.0)
    way = run.position[-1, 1] - run.position[0, 1]
    assert np.hypot(*way) == pytest.approx(0.5 * G * math.sin(angle) * 16, rel=1e-14)
    assert run.position[:, 1] @ normal == pytest.approx(0.5, abs=1e-13)


def test_disc_leaves_a_ball_where_the_height_has_fallen_by_a_third():
    """A frictionless slide from the top leaves where cos = (2/3) cos of the start."""
    start = 0.01
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(t2.Disc(radius=1))
    centre = (1.5 * math.sin(start), 1.5 * math.cos(start))
    scene.add_body(t2.Disc(radius=0.5), mass=1, position=centre, restitution=0.5)
    run = t2.simulate(scene, duration=3.0)
    gone = np.flatnonzero(np.hypot(*run.position[:, 1].T) > 1.5 + 1e-9)[0]
    # after it has left, the horizontal speed is that of the leaving
    height = 1.5 * 2 / 3 * math.cos(start)
    speed = math.sqrt(2 * G * (1.5 * math.cos(start) - height))
    assert run.velocity[gone, 1, 0] == pytest.approx(speed * 2 / 3 * math.cos(start), rel=1e-9)
    assert run.energy[-1] == pytest.approx(run.energy[0], rel=1e-12)


def test_ladder_leaves_the_wall():
    """A thin rod that slides down a wall leaves it at two thirds of its height (no friction)."""
    angle, length, width = math.radians(60), 2.0, 1e-6
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(FLOOR, restitution=0)
    scene.add_static(t2.HalfPlane(normal=(1, 0), offset=0), restitution=0)
    reach = (length * math.cos(angle) + width * math.sin(angle)) / 2
    height = (length * math.sin(angle) + width * math.cos(angle)) / 2
    rod = t2.Box(width=length, height=width)
    scene.add_body(
        rod, mass=1, position=(reach, height), orientation=math.pi - angle, restitution=0
    )
    run = t2.simulate(scene, duration=0.75, times=np.linspace(0, 0.75, 1501))
    sine = 2 / 3 * math.sin(angle)
    spin = math.sqrt(3 * G / length * (math.sin(angle) - sine))
    speed = spin * length / 2 * sine  # that of the centre along the floor, for good
    free = run.velocity[:, 2, 0] > speed * (1 - 1e-5)
    assert free.any()
    assert run.velocity[free, 2, 0] == pytest.approx(speed, rel=1e-5)
    falling = run.times < run.impacts.time[0]
    assert run.energy[falling] == pytest.approx(run.energy[0], rel=1e-11)


@pytest.mark.parametrize("speed", [0.5, 1.0, 3.0])
@pytest.mark.parametrize("shape", [t2.Disc(radius=0.5), BOX])
def test_energy_is_kept_over_the_edge_of_a_table(shape, speed):
    """Sliding, tipping or rolling off, and falling do no work but that of gravity."""
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(t2.Box(width=4, height=1), position=(0, -0.5))
    scene.add_body(shape, mass=1, position=(0, 0.5), velocity=(speed, 0), restitution=0.5)
    run = t2.simulate(scene, duration=2 / speed + 1.0)
    assert run.energy == pytest.approx(run.energy[0], rel=1e-12)
    assert run.position[-1, 1, 1] < 0


def test_force_lifts_a_disc_off():
    """It leaves when the force has grown to the weight, and not before."""
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(FLOOR)
    scene.add_body(
        t2.Disc(radius=0.5),
        mass=1,
        position=(0, 0.5),
        force=(0, "20[N]*sin(1[rad/s]*time)"),
        restitution=0.5,
    )
    run = t2.simulate(scene, duration=2.0)
    start = math.asin(G / 20)

    def height(t: float) -> float:
        """Twice the integral of 20 sin(t) - g from the start on."""
        s = t - start
        return 20 * (math.sin(start) - math.sin(t) + s * math.cos(start)) - G * s**2 / 2

    exact = [0.5 + (height(t) if t > start else 0.0) for t in run.times]
    np.testing.assert_allclose(run.position[:, 1, 1], exact, rtol=0, atol=1e-11)


def test_discs_pushed_together_without_restitution_stay():
    scene = t2.Scene(gravity=(0, 0))
    disc = t2.Disc(radius=0.5)
    scene.add_body(disc, mass=1, position=(-2, 0), force=(3, 0), restitution=0)
    scene.add_body(disc, mass=2, position=(2, 0), force=(-3, 0), restitution=0)
    run = t2.simulate(scene, duration=5.0)
    gap = run.position[-1, 1] - run.position[-1, 0]
    assert gap.tolist() == pytest.approx([1.0, 0.0], abs=1e-14)
    assert run.velocity[-1].tolist() == pytest.approx(np.zeros((2, 2)), abs=1e-14)


def test_a_bounce_is_as_high_as_its_energy_says() -> None:
    """A ball dropped by 1 m comes back to the square of its restitution."""
    run = t2.simulate(dropped(t2.Disc(radius=0.5), height=1.5, restitution=0.8), duration=1.0)
    highest = run.position[run.times > run.impacts.time[0], 1, 1].max() - 0.5
    assert highest == pytest.approx(0.64, abs=G / 120**2 / 2)  # between two samples
    assert rest.bounce_height(run.impacts.impulse[0] * 0.8 / 1.8, -G) == pytest.approx(0.64)


def test_no_rest_is_told_that_begins_after_the_run():
    """A bounce too low to be seen may yet take longer than the run, where hardly anything pulls."""
    scene = t2.Scene(gravity=(0.0, -1e-14))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.5, friction=0.0, name="floor")
    scene.add_body(
        t2.Disc(radius=0.5), mass=1.0, position=(0.0, 0.5), velocity=(0.0, -1e-14),
        restitution=0.5, friction=0.0, name="disc",
    )  # fmt: skip
    assert rest_time(t2.simulate(scene, duration=1.0)) == 0.0  # its bounces would end at 2 s


@pytest.mark.parametrize("pull", [1e-9, 1.0])
def test_discs_that_attract_each_other_sink_apart_with_their_energy(pull: float) -> None:
    """A third one between two, without friction; the potential of each pair is -G m m / d."""
    scene = t2.Scene(gravity=(0.0, -G))
    slippery: Any = {"friction": 0.0, "restitution": 0.0}
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **slippery)
    for place in ((-0.55, 0.5), (0.55, 0.5), (0.0, 0.5 + math.sqrt(1 - 0.55**2))):
        scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=place, **slippery)
    scene.add_attraction(gravitational_constant=pull)
    run = t2.simulate(scene, duration=0.3, times=np.linspace(0.0, 0.3, 7))
    assert not isinstance(run.method, t2.Stepped)
    place, speed = run.position[:, 1:], run.velocity[:, 1:]
    energy = (speed**2).sum(axis=(1, 2)) / 2 + G * place[..., 1].sum(axis=1)
    for i, j in ((0, 1), (0, 2), (1, 2)):
        energy -= pull / np.hypot(*(place[:, i] - place[:, j]).T)
    assert energy == pytest.approx(energy[0], rel=1e-11)
    assert np.diff(place[:, 0, 0]).max() < 0  # they do part
