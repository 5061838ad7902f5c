"""Speeds, steps, places and sizes at which other engines fail: laws hold, nothing passes a wall.

Oracles: Newton's rule for two bodies, conservation, and mirror images of a corridor.
"""

import math
import random
from itertools import pairwise

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine.tables import CONTACTS
from tamias2d.scene import catalogue
from tamias2d.simulator import Simulator
from tamias2d.state import Array
from tests.engine.conserved import totals

GRAVITY = 9.81
SPEEDS = (10.0, 33.7, 100.0, 12345.6, 1e6)
WALL = t2.Box(width=0.02, height=2.0)


def empty() -> t2.Scene:
    return t2.Scene(gravity=(0.0, 0.0))


def throw(
    scene: t2.Scene,
    velocity: tuple[float, float],
    at: tuple[float, float] = (0.0, 0.0),
    restitution: float = 1.0,
) -> None:
    """Add the disc that is thrown."""
    disc = t2.Disc(radius=0.1)
    scene.add_body(disc, mass=1.0, position=at, velocity=velocity, restitution=restitution)


# -- X4: speed


def shot(kind: str, speed: float, restitution: float, mass: float = 1.0) -> Simulator:
    """A disc that has flown at a thin wall for half a second."""
    scene = empty()
    if kind == "box":
        scene.add_static(WALL, position=(1.0, 0.0), restitution=restitution)
    elif kind == "segment":
        line = t2.Segment(length=2.0)
        scene.add_static(
            line, position=(1.0, 0.0), orientation=math.pi / 2, restitution=restitution
        )
    elif kind == "kinematic":
        scene.add_kinematic(WALL, position=(1.0, 0.0), velocity=(0.0, 0.0), restitution=restitution)
    else:
        scene.add_body(WALL, mass=mass, position=(1.0, 0.0), restitution=restitution)
    throw(scene, (speed, 0.0), restitution=restitution)
    sim = Simulator(scene)
    sim.step(30)
    return sim


@pytest.mark.parametrize("restitution", [1.0, 0.5, 0.0])
@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("kind", ["box", "segment", "kinematic"])
def test_no_speed_takes_a_disc_through_a_thin_wall(
    kind: str, speed: float, restitution: float
) -> None:
    sim = shot(kind, speed, restitution)
    assert sim.position[1, 0] < 1.0 - 0.1 + 1e-4
    # a few roundings
    assert sim.velocity[1, 0] == pytest.approx(-restitution * speed, rel=1e-12)
    assert abs(sim.velocity[1, 1]) <= 1e-12 * speed


@pytest.mark.parametrize("restitution", [1.0, 0.5, 0.0])
@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("mass", [1e-3, 1.0, 1e3])
def test_a_free_wall_takes_its_part_of_the_momentum(
    mass: float, speed: float, restitution: float
) -> None:
    sim = shot("free", speed, restitution, mass)
    wall, disc = sim.velocity[:, 0]
    mean = speed / (1.0 + mass)
    assert disc == pytest.approx(mean - restitution * mass * mean, abs=1e-12 * speed)
    assert wall == pytest.approx(mean + restitution * mean, rel=1e-12)
    assert mass * wall + disc == pytest.approx(speed, rel=1e-14)
    assert sim.position[0, 0] - sim.position[1, 0] > 0.1


@pytest.mark.parametrize("speed", [30.0, 1e3, 1e5])
def test_a_fast_disc_passes_between_walls_without_a_contact(speed: float) -> None:
    scene = empty()
    scene.add_static(t2.Box(width=0.02, height=1.0), position=(1.0, 0.0), restitution=1.0)
    scene.add_static(t2.Box(width=0.02, height=1.0), position=(1.0, 1.21), restitution=1.0)
    # between both it has 5 mm on each side
    throw(scene, (speed, 0.0), at=(0.0, 0.605))
    sim = Simulator(scene)
    sim.step(10)
    assert sim.velocity[2].tolist() == [speed, 0.0]
    assert sim.position[2, 0] == pytest.approx(speed / 6.0, rel=1e-14)
    assert len(sim.contacts) == 0


@pytest.mark.parametrize("speed", [7.0, 50.0, 1e3, 3e3])
def test_many_bounces_in_one_step_end_at_the_mirror_image(speed: float) -> None:
    """A disc between two walls is where its mirror images say, as often as it bounces."""
    scene = empty()
    for x in (-1.01, 1.01):
        scene.add_static(t2.Box(width=0.02, height=4.0), position=(x, 0.0), restitution=1.0)
    throw(scene, (speed, 0.0), at=(0.1, 0.05))
    sim = Simulator(scene)
    sim.step(10)
    unfolded = (0.1 + speed / 6.0 + 0.9) % 3.6
    where = unfolded - 0.9 if unfolded < 1.8 else 2.7 - unfolded
    bounces = speed / 6.0 / 1.8 + 1.0
    # a disc is stopped before it touches, by at most 2**-13 of its size each time
    assert abs(sim.position[2, 0] - where) < 2.0 * bounces * 0.1 * 2.0**-13 + 1e-12
    assert abs(sim.velocity[2, 0]) == pytest.approx(speed, rel=1e-12)


@pytest.mark.parametrize("speed", [100.0, 1e4, 1e6])
@pytest.mark.parametrize("seed", range(6))
def test_bullets_of_any_shape_conserve_momenta_and_energy(seed: int, speed: float) -> None:
    chance = random.Random(seed)
    restitution = (1.0, 0.5)[seed % 2]
    shapes = (
        t2.Box(width=0.2, height=0.1),
        t2.Capsule(length=0.3, radius=0.05),
        t2.Polygon(vertices=[(0.0, 0.0), (0.3, 0.05), (0.1, 0.25)]),
    )
    scene = empty()
    scene.add_body(
        t2.Box(width=0.02, height=1.0),
        mass=10 ** chance.uniform(-1, 2),
        position=(1.0, 0.0),
        angular_velocity=chance.uniform(-20, 20),
        restitution=restitution,
    )
    scene.add_body(
        shapes[seed % 3],
        mass=1.0,
        position=(0.0, chance.uniform(-0.2, 0.2)),
        orientation=chance.uniform(-3, 3),
        velocity=(speed, 0.0),
        angular_velocity=chance.uniform(-20, 20),
        restitution=restitution,
    )
    sim = Simulator(scene)
    momentum, turning, energy = totals(sim)
    met = 0
    for _ in range(12):
        sim.step()
        met += len(sim.contacts)
    after, turning_after, energy_after = totals(sim)
    assert met > 0
    assert after == pytest.approx(momentum, abs=1e-12 * speed)
    # the bodies are at most 12 steps of this speed away
    assert turning_after == pytest.approx(turning, abs=1e-12 * speed)
    assert energy_after <= energy * (1.0 + 1e-12)
    if restitution == 1.0:
        assert energy_after == pytest.approx(energy, rel=1e-12)


@pytest.mark.parametrize(("restitution", "speed"), [(1.0, 60.0), (1.0, 1e5), (0.5, 1e3)])
def test_a_bullet_that_hits_a_row_of_discs_passes_none(restitution: float, speed: float) -> None:
    scene = empty()
    for k in range(10):
        scene.add_body(
            t2.Disc(radius=0.05), mass=0.2, position=(1.0 + 0.3 * k, 0.0), restitution=restitution
        )
    throw(scene, (speed, 0.0), restitution=restitution)
    sim = Simulator(scene)
    momentum, _, energy = totals(sim)
    for _ in range(12):
        sim.step()
        order = [int(sim.position[10, 0] < sim.position[:10, 0].min())]
        order += (np.diff(sim.position[:10, 0]) > 0.0).astype(int).tolist()
        assert all(order)
    after, _, energy_after = totals(sim)
    assert after == pytest.approx(momentum, rel=1e-13)
    assert energy_after <= energy * (1.0 + 1e-12)


def test_the_bullet_of_the_catalogue_does_not_pass_the_wall() -> None:
    scene = catalogue.load("bullet-wall")
    sim = Simulator(scene)
    fast = int(np.hypot(*np.array([body.velocity for body in scene.bodies]).T).argmax())
    momentum, _, _ = totals(sim)
    sim.step(30)
    assert np.isfinite(sim.position).all()
    hit = np.delete(np.arange(len(scene)), fast)
    assert abs(sim.velocity[hit]).max() > 0.1  # it has met the wall
    assert abs(totals(sim)[0][0]) <= abs(momentum[0])  # what rubs takes some


# -- X3: long steps


def dropped(
    shape: t2.Disc | t2.Box, height: float, time_step: float, thin: bool
) -> tuple[float, float]:
    """Where a body rests that fell on a floor for 1 m, and how low it has ever been, m."""
    scene = t2.Scene(gravity=(0.0, -GRAVITY))
    if thin:
        scene.add_static(t2.Box(width=20.0, height=0.1), position=(0.0, -0.05), restitution=0.0)
    else:
        scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), restitution=0.0)
    scene.add_body(shape, mass=1.0, position=(0.0, 1.0 + height), restitution=0.0)
    sim = Simulator(scene, time_step=time_step)
    low = math.inf
    for _ in range(100):
        sim.step(max(1, round(0.1 / time_step)))
        low = min(low, sim.position[1, 1] - height)
    assert abs(sim.velocity[1, 1]) < 1e-3
    return float(sim.position[1, 1] - height), float(low)


@pytest.mark.parametrize("thin", [False, True])
@pytest.mark.parametrize(
    ("shape", "height"), [(t2.Disc(radius=0.5), 0.5), (t2.Box(width=1.0, height=1.0), 0.5)]
)
def test_a_fall_ends_on_the_floor_however_long_steps_are(
    shape: t2.Disc | t2.Box, height: float, thin: bool
) -> None:
    depths = []
    for time_step in (1e-3, 0.01, 1 / 60, 0.05, 0.1, 0.2, 0.5):
        rest, low = dropped(shape, height, time_step, thin)
        assert low > -0.03  # Box2D v3 sinks by 0.08 m at 0.5 s
        depths.append(-rest)
    assert all(a <= b * (1.0 + 1e-3) for a, b in pairwise(depths[:5]))
    assert depths[2] < 1e-4  # at 60 Hz


@pytest.mark.parametrize("time_step", [0.1, 0.2, 0.5])
@pytest.mark.parametrize("turn", [0.3, 0.7])
@pytest.mark.parametrize("height", [1.0, 1.7, 3.0])
def test_a_box_that_tips_over_in_a_long_step_stays_on_a_thin_floor(
    height: float, turn: float, time_step: float
) -> None:
    """The corner that the solver knows holds; others come down within the step."""
    scene = t2.Scene(gravity=(0.0, -GRAVITY))
    scene.add_static(t2.Box(width=20.0, height=0.1), position=(0.0, -0.05), restitution=0.0)
    square = t2.Box(width=1.0, height=1.0)
    scene.add_body(
        square, mass=1.0, position=(0.0, height + 0.5), orientation=turn, restitution=0.0
    )
    sim = Simulator(scene, time_step=time_step)
    for _ in range(round(20.0 / time_step)):
        sim.step()
        assert sim.position[1, 1] > 0.25  # a corner may go in by 0.7 of half the widths of both
    assert sim.position[1, 1] == pytest.approx(0.5, abs=0.02)


# -- X5, X6: far away, and of any size


def stack(scale: float, at: tuple[float, float], count: int, time: float) -> Array:
    """Positions of boxes, from their first places, after a while; lengths and times scaled."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    size = 2.0 * scale
    scene.add_static(
        t2.Box(width=16.0 * scale, height=size), position=(at[0], at[1] - scale), friction=0.5,
        restitution=0.0,
    )  # fmt: skip
    for k in range(count):
        scene.add_body(
            t2.Box(width=size, height=size),
            mass=1.0,
            position=(at[0] + 0.0625 * scale * (k % 2), at[1] + scale * (1.0 + 2.125 * k)),
            friction=0.5,
            restitution=0.0,
        )
    start = np.array([body.position for body in scene.bodies])
    sim = Simulator(scene, time_step=time / 120)
    sim.step(240)
    moved: Array = (sim.position - start) / scale
    return moved


@pytest.mark.parametrize("power", [-20, 20])
def test_a_stack_of_any_size_moves_the_same(power: int) -> None:
    """Times go with the root of lengths: both are powers of two, and so the same bits."""
    one = stack(1.0, (0.0, 0.0), 5, 1.0)
    other = stack(2.0**power, (0.0, 0.0), 5, 2.0 ** (power // 2))
    assert abs(one).max() > 0.1
    assert other.tobytes() == one.tobytes()


@pytest.mark.parametrize("offset", [1e4, 1e6, 1e7])
def test_a_stack_far_away_moves_the_same(offset: float) -> None:
    near, far = stack(1.0, (0.0, 0.0), 10, 1.0), stack(1.0, (offset, offset), 10, 1.0)
    # places are rounded to 1e-16 of the distance in each of 240 steps
    assert abs(far - near).max() < 1e-6


@pytest.mark.parametrize("offset", [1e4, 1e6, 1e7])
def test_a_bullet_far_away_bounces_the_same(offset: float) -> None:
    ends = []
    for at in (0.0, offset):
        scene = empty()
        scene.add_static(WALL, position=(at + 1.0, at), restitution=1.0)
        throw(scene, (200.0, 3.0), at=(at, at))
        sim = Simulator(scene)
        sim.step(20)
        ends.append((*(sim.position[1] - at), *sim.velocity[1]))
    assert ends[1] == pytest.approx(ends[0], rel=0.0, abs=1e-6)


# -- X16: many


def falling(count: int) -> Simulator:
    """Discs side by side and above each other, in a frame that falls."""
    sim = Simulator(t2.Scene(gravity=(0.0, -10.0)))
    columns = math.isqrt(count)
    k = np.arange(count)
    place = np.stack((0.6 * (k % columns) + 0.1 * (k // columns % 2), 0.5 * (k // columns)), axis=1)
    velocity = np.stack((np.sin(3.0 * k), np.cos(5.0 * k)), axis=1)
    sim.add(t2.Disc(radius=0.25), mass=1.0, position=place, velocity=velocity, restitution=0.5)
    return sim


def test_contacts_grow_as_bodies_do_and_momentum_is_conserved() -> None:
    per_body = []
    for count in (1000, 4000, 16000):
        sim = falling(count)
        before = totals(sim)[0]
        sim.step(20)
        after = totals(sim)[0] + np.array((0.0, 10.0 * count * 20 / 60))
        # 1e-12 of the sum of all that is exchanged
        assert abs(after - before).max() < 1e-12 * count * 10.0
        per_body.append(sim._engine.world.broad_phase.counts[CONTACTS] / count)
    assert max(per_body) < 1.2 * min(per_body) < 8.0
