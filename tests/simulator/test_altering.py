"""Bodies that get other masses, drags and shapes between steps (R2).

Expected values come from closed forms, and from bodies that were added as others are changed to.
"""

import copy
import math
import pickle
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import tamias2d as t2
from tests.rebuilt import rebuilt
from tests.simulator.crowd import SHAPES, crowd

SURFACE: Any = {"friction": 0.5, "restitution": 0.0}
PLANE = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
BOX = t2.Box(width=1.0, height=1.0)
DISC = t2.Disc(radius=0.5)
TALL = t2.Box(width=0.6, height=1.8)
LOW = t2.Box(width=0.6, height=0.9)
PAIR = t2.Compound(
    parts=[t2.Part(shape=BOX, position=(x, 0.0)) for x in (-0.5, 0.5)]
)  # two boxes beside each other


def space(**settings: Any) -> t2.Simulator:
    return t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), **settings)


def ground(**settings: Any) -> t2.Simulator:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)), **settings)
    sim.add_static(PLANE, name="floor", **SURFACE)
    return sim


# -- mass and drag


@given(st.floats(0.1, 100.0), st.floats(0.1, 100.0), st.floats(-50.0, 50.0))
@settings(max_examples=20)
def test_a_force_moves_what_is_heavier_by_less(before: float, after: float, force: float) -> None:
    sim = space()
    sim.add(DISC, mass=before, position=(0.0, 0.0), force=(force, 0.0), restitution=0.0)
    sim.step(60)
    speed = force / before
    sim.set_mass(0, mass=after)
    assert sim.velocity[0, 0] == pytest.approx(speed, rel=1e-12)  # momentum changes
    sim.step(60)
    assert sim.velocity[0, 0] == pytest.approx(speed + force / after, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("inertia", [None, 7.0])
@pytest.mark.parametrize("shape", [*SHAPES, None])
def test_an_inertia_goes_along_with_the_mass_or_is_stated(shape: Any, inertia: Any) -> None:
    sim = space()
    first = 0.3 if shape is None else shape.inertia(2.0)
    stated = first if shape is None else None
    sim.add(shape, mass=2.0, inertia=stated, position=(0, 0), torque=1.5, restitution=0.0)
    sim.step(30)
    sim.set_mass(0, mass=5.0, inertia=inertia)
    second = 2.5 * first if inertia is None else inertia
    assert sim.body(0).inertia == pytest.approx(second, rel=1e-12)
    sim.step(60)
    spin = 1.5 * 0.5 / first + 1.5 / second
    assert sim.angular_velocity[0] == pytest.approx(spin, rel=1e-12)


def test_a_particle_without_an_inertia_keeps_none() -> None:
    sim = space()
    sim.add(None, mass=1.0, position=(0.0, 0.0))
    sim.set_mass(0, mass=3.0)
    assert (sim.mass[0], sim.body(0).inertia) == (3.0, math.inf)


def test_coefficients_of_drag_stay_and_their_rates_follow() -> None:
    sim = space()
    moving: Any = {"velocity": (4.0, 0.0), "angular_velocity": 2.0}
    drag: Any = {"linear_drag": 0.6, "angular_drag": 0.2}
    sim.add(DISC, mass=2.0, inertia=0.5, position=(0, 0), restitution=0.0, **moving, **drag)
    sim.step(60)
    sim.set_mass(0, mass=3.0, inertia=0.8)
    sim.step(60)
    sim.set_drag(0, linear_drag=1.2)
    sim.step(60)
    sim.set_drag(0, angular_drag=0.0)
    sim.step(60)
    assert sim.velocity[0, 0] == pytest.approx(4 * math.exp(-0.3 - 0.2 - 0.4 - 0.4), rel=1e-13)
    assert sim.angular_velocity[0] == pytest.approx(2 * math.exp(-0.4 - 0.25 - 0.25), rel=1e-13)
    found = sim.body(0)
    assert (found.linear_drag, found.angular_drag) == (pytest.approx(1.2), 0.0)


def test_each_body_has_a_value_of_its_own_or_all_have_one() -> None:
    sim = space()
    rows = sim.add(DISC, mass=1.0, position=[(3.0 * k, 0.0) for k in range(4)], restitution=0.0)
    sim.set_mass(rows[:3], mass=[2.0, 3.0, 4.0], inertia=1.0)
    sim.set_mass([3, 3], mass=[5.0, 6.0])  # the last one counts
    assert sim.mass.tolist() == [2.0, 3.0, 4.0, 6.0]
    sim.set_drag(sim.mass > 2.5, linear_drag=0.5)
    assert [sim.body(int(k)).linear_drag for k in rows] == [0.0, 0.5, 0.5, pytest.approx(0.5)]
    sim.set_shape([1, 2, 2], [BOX, BOX, LOW])
    assert [sim.body(int(k)).shape for k in rows] == [DISC, BOX, LOW, DISC]


@pytest.mark.parametrize("count", [3, 40])
def test_a_restored_copy_has_the_bits_of_what_flies_on(count: int) -> None:
    """Also where a stretch of flight was foreseen with what bodies were before."""
    sim = space()
    places = [(3.0 * k, 0.0) for k in range(count)]
    drag = [0.5] * (count - 1) + [2.0]
    sim.add(DISC, mass=1.0, position=places, velocity=(0, 1), linear_drag=drag, restitution=0.0)
    sim.step(20)
    sim.set_drag(1, linear_drag=2.0)  # which another body has
    copied = copy.deepcopy(sim)
    for each in (sim, copied):
        each.step(20)
    assert sim.digest() == copied.digest()
    assert sim.velocity[0, 1] == pytest.approx(math.exp(-0.5 * 40 / 60))
    assert sim.velocity[1, 1] == pytest.approx(math.exp(-(0.5 + 2.0) * 20 / 60))


def test_rates_that_come_and_go_leave_nothing_behind() -> None:
    sim = space()
    sim.add(DISC, mass=1.0, position=(0.0, 0.0), linear_drag=0.1, restitution=0.0)
    for k in range(50):
        sim.set_mass(0, mass=1.0 + k)
        sim.step()
    assert len(sim._engine.world.state.drag_rates) < 6


@pytest.mark.parametrize("change", ["mass", "drag", "shape"])
def test_a_pile_at_rest_knows_what_changed_as_its_copy_does(change: str) -> None:
    sim = t2.Simulator(crowd(30, seed=3))
    sim.step(240)
    k = 20
    if change == "mass":
        sim.set_mass(k, mass=20.0)
    elif change == "drag":
        sim.set_drag(k, linear_drag=5.0, angular_drag=5.0)
    else:
        sim.set_shape(k, t2.Disc(radius=0.5))
    copied = pickle.loads(pickle.dumps(sim))
    plain = copy.deepcopy(sim)
    for _ in range(60):
        sim.step()
    copied.step(60)
    plain.step(60)
    assert sim.digest() == copied.digest() == plain.digest()


def test_a_heavier_box_presses_harder() -> None:
    sim = ground()
    sim.add(BOX, mass=2.0, position=(0.0, 0.5), **SURFACE)
    sim.step(30)
    sim.set_mass(1, mass=7.0)
    sim.step(30)
    assert sim.contacts.impulse.sum() * 60 == pytest.approx(70.0, rel=1e-6)
    assert not len(sim.began)
    assert not len(sim.ended)


def test_attraction_and_fields_act_on_what_bodies_weigh_now() -> None:
    """A field in proportion to the mass gives all the same acceleration, and Newton's law too."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_field(force=("mass*2[m/s^2]", "0[N]"))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), name="own")
    sim = t2.Simulator(scene)
    sim.add(None, mass=1.0, position=(0.0, 5.0))
    sim.force[0, 1] = 3.0
    sim.set_mass([0, 1], mass=[4.0, 5.0])
    assert sim.force.tolist() == [[8.0, 3.0], [10.0, 0.0]]
    other = copy.deepcopy(sim)
    other.set_mass(0, mass=1.0)
    assert other.force[0].tolist() == [2.0, 3.0]

    pull = t2.Scene(gravity=(0.0, 0.0))
    pull.add_attraction(gravitational_constant=1.0)
    pull.add_body(None, mass=1.0, position=(0.0, 0.0))
    stars = t2.Simulator(pull, time_step=1e-3)
    stars.add(None, mass=1.0, position=(10.0, 0.0))
    stars.set_mass(0, mass=6.0)
    stars.set_mass(1, mass=3.0)
    copied = copy.deepcopy(stars)
    for each in (stars, copied):
        each.step(100)
        assert each.velocity[:, 0] == pytest.approx([0.1 * 3.0 / 100, -0.1 * 6.0 / 100], rel=1e-4)


def test_laws_of_a_body_of_its_own_follow_its_mass() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), force=("mass*3[m/s^2]", 0.0))
    sim = t2.Simulator(scene)
    sim.set_mass(0, mass=2.0)
    sim.step(60)
    assert sim.velocity[0, 0] == pytest.approx(3.0)


# -- shapes


@pytest.mark.parametrize("before", range(len(SHAPES)))
@pytest.mark.parametrize("after", range(len(SHAPES)))
def test_it_moves_as_one_that_was_added_so(before: int, after: int) -> None:
    """In flight, onto the ground, and on it, to the bit."""
    one, other = ground(), ground()
    moving: Any = {"velocity": (1.0, 0.0), "angular_velocity": 3.0, "orientation": 0.3}
    drag: Any = {"linear_drag": 0.25, "angular_drag": 0.125}
    one.add(SHAPES[before], mass=1.5, position=(0.0, 3.0), **moving, **SURFACE)
    one.step(10)
    one.set_shape(1, SHAPES[after], mass=2.0)
    one.set_drag(1, **drag)
    pose: Any = {"position": one.position[1], "orientation": one.orientation[1]}
    speed: Any = {"velocity": one.velocity[1], "angular_velocity": one.angular_velocity[1]}
    other.add(SHAPES[after], mass=2.0, **pose, **speed, **drag, **SURFACE)
    for _ in range(120):
        one.step()
        other.step()
        assert one.position.tobytes() == other.position.tobytes()
        assert one.angular_velocity.tobytes() == other.angular_velocity.tobytes()
    assert one.contacts.impulse.tolist() == other.contacts.impulse.tolist()
    assert len(one.contacts)


def test_all_else_of_a_body_stays() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    words: Any = {"category": 2, "mask": 5, "group": 3, "friction": 0.25, "restitution": 0.75}
    scene.add_body(BOX, mass=3.0, position=(1.0, 2.0), velocity=(1.0, 0.0), name="hero", **words)
    sim = t2.Simulator(scene)
    sim.step()
    before = sim.body("hero")
    sim.set_shape("hero", SHAPES[4])
    after = sim.body("hero")
    for key, value in vars(before).items():
        if key not in ("shape", "inertia"):
            assert getattr(after, key) == value, key
    assert after.inertia == pytest.approx(SHAPES[4].inertia(3.0))
    assert sim.index("hero") == 0
    assert sim.generation[0] == 1


def test_an_inertia_that_was_stated_stays_unless_another_one_is() -> None:
    """So does an upright hero, who is not to fall over as he crouches."""
    sim = space()
    sim.add(TALL, mass=70.0, inertia=1e9, position=(0.0, 0.0), restitution=0.0)
    sim.add(TALL, mass=70.0, position=(5.0, 0.0), restitution=0.0)
    sim.set_shape([0, 1], LOW)
    assert sim.body(0).inertia == pytest.approx(1e9, rel=1e-12)
    assert sim.body(1).inertia == pytest.approx(LOW.inertia(70.0), rel=1e-12)
    sim.set_shape([0, 1], TALL, mass=140.0)
    assert sim.body(0).inertia == pytest.approx(2e9, rel=1e-12)
    assert sim.body(1).inertia == pytest.approx(TALL.inertia(140.0), rel=1e-12)
    sim.set_shape(0, LOW, inertia=3.0)
    assert sim.body(0).inertia == pytest.approx(3.0)


def test_what_is_set_for_a_pair_holds_for_all_shapes_to_come() -> None:
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(PLANE, name="floor", **SURFACE)
    scene.add_body(BOX, mass=1.0, position=(0.0, 0.5), velocity=(2.0, 0.0), name="box", **SURFACE)
    scene.set_friction("box", "floor", 0.0)
    sim = t2.Simulator(scene)
    for shape in (PAIR, BOX, PAIR):
        sim.set_shape("box", shape)
        sim.set_shape("floor", PLANE)
        sim.step(30)
        assert sim.velocity[1, 0] == pytest.approx(2.0)


def test_queries_and_bodies_see_it_at_once() -> None:
    sim = ground()
    sim.add(DISC, mass=1.0, position=(0.0, 5.0), **SURFACE)  # in no step yet
    sim.set_shape(1, t2.Box(width=4.0, height=0.2))
    assert sim.at_point((1.9, 5.0)).tolist() == [1]
    assert sim.at_point((0.0, 5.3)).tolist() == []
    assert sim.body(1).shape == t2.Box(width=4.0, height=0.2)
    sim.step()
    sim.set_shape(1, DISC)
    assert sim.at_point((0.0, 5.3)).tolist() == [1]
    assert sim.at_point((1.9, 5.0)).tolist() == []


# -- what touches


def crouched(sim: t2.Simulator, row: int, low: t2.Box, tall: t2.Box) -> None:
    """Let a body crouch, its feet where they are."""
    sim.set_shape(row, low)
    sim.position[row, 1] -= (tall.height - low.height) / 2


@pytest.mark.parametrize("steps", [1, 3])
def test_feet_that_stay_on_the_ground_tell_nothing(steps: int) -> None:
    sim = ground()
    hero = sim.add(TALL, mass=70.0, position=(0.0, 0.9), **SURFACE)
    sim.step(30)
    height = sim.position[hero, 1] - 0.9
    crouched(sim, hero, LOW, TALL)
    assert len(sim.contacts) == 2  # of the last step
    for _ in range(5):
        sim.step(steps)
        assert not len(sim.began)
        assert not len(sim.ended)
        assert sim.contacts.impulse.sum() * 60 == pytest.approx(700.0, rel=0.02)
    assert sim.position[hero, 1] - 0.45 == pytest.approx(height, abs=1e-4)
    crouched(sim, hero, TALL, LOW)
    sim.step(steps)
    assert not len(sim.began)
    assert not len(sim.ended)


@pytest.mark.parametrize("steps", [1, 4])
def test_what_touches_no_longer_is_told_once(steps: int) -> None:
    sim = ground()
    hero = sim.add(TALL, mass=70.0, position=(0.0, 0.9), **SURFACE)
    wall = sim.add_static(BOX, position=(0.8, 1.5), **SURFACE)
    sim.step(30)
    sim.velocity[hero, 0] = 0.2
    sim.step()
    assert [hero, wall] in np.sort(sim.contacts.bodies, axis=1).tolist()
    crouched(sim, hero, LOW, TALL)
    sim.step(steps)
    assert np.sort(sim.ended).tolist() == [[hero, wall]]
    assert not len(sim.began)
    sim.step()
    assert not len(sim.ended)


@pytest.mark.parametrize("shapes", [(BOX, PAIR, BOX), (PAIR, BOX, PAIR), (PAIR, PAIR, DISC)])
@pytest.mark.parametrize("others", [0, 12])
def test_a_pair_is_told_as_a_pair_whatever_its_shapes(
    shapes: Sequence[t2.Box], others: int
) -> None:
    sim = ground()
    sim.add(shapes[0], mass=1.0, position=(0.0, 0.5), **SURFACE)
    if others:  # of few, all pairs are listed
        sim.add_static(DISC, position=[(10.0 + 2 * k, 5.0) for k in range(others)], **SURFACE)
    sim.step(20)
    counted = 1
    for shape in shapes[1:]:
        sim.set_shape(1, shape)
        assert copy.deepcopy(sim).digest() == sim.digest()
        for _ in range(10):
            sim.step()
            counted += len(sim.began) - len(sim.ended)
        assert counted == 1
        sim.position[1, 1] += 3.0
        sim.set_shape(1, shape)
        sim.step()
        assert sim.ended.tolist() == [[0, 1]]
        sim.position[1, 1] -= 3.0
        sim.velocity[1] = 0.0
        sim.step(10)
        assert len(sim.began) == 1


def test_sensors_tell_what_enters_and_leaves_as_shapes_change() -> None:
    sim = space()
    sensor = sim.add_static(DISC, position=(0.0, 0.0), sensor=True)
    body = sim.add(DISC, mass=1.0, position=(1.2, 0.0), restitution=0.0)
    told = []
    for radius in (0.5, 0.8, 0.9, 0.5, 0.8):
        sim.set_shape(body, t2.Disc(radius=radius))
        sim.step()
        told.append((len(sim.began), len(sim.ended)))
    assert told == [(0, 0), (1, 0), (0, 0), (0, 1), (1, 0)]
    sim.set_shape(sensor, t2.Disc(radius=0.1))
    assert sim.body(sensor).sensor
    sim.step()
    assert sim.ended.tolist() == [[0, 1]]
    assert not sim.velocity.any()


@pytest.mark.parametrize("who", ["floor", "box0", "box2"])
def test_what_sleeps_wakes_with_what_touches_it(who: str) -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)), sleeping=True)
    sim.add_static(t2.Box(width=9.0, height=1.0), position=(0, -0.5), name="floor", **SURFACE)
    for k in range(3):
        sim.add(BOX, mass=1.0, position=(0.0, 0.5 + k), name=f"box{k}", **SURFACE)
    sim.add(BOX, mass=1.0, position=(3.0, 0.5), name="far", **SURFACE)
    sim.step(200)
    assert sim.asleep[1:].all()
    small = t2.Box(width=0.1, height=0.1)
    sim.set_shape(who, small)
    copied = copy.deepcopy(sim)
    sim.step(2)
    copied.step(2)
    assert sim.digest() == copied.digest()
    assert sim.asleep[4] == (who != "floor")
    assert not sim.asleep[1:4].any()
    falls = {"floor": 1, "box0": 2, "box2": 3}[who]
    assert sim.velocity[falls, 1] == pytest.approx(-10 / 30, rel=1e-2)
    if who == "floor":
        sim.step(200)
        sim.set_mass("far", mass=2.0)
        assert not sim.asleep[4]


def test_what_sleeps_wakes_where_something_that_stands_grows_into_it() -> None:
    sim = ground(sleeping=True)
    sim.add(BOX, mass=1.0, position=(0.0, 0.5), **SURFACE)
    post = sim.add_static(t2.Disc(radius=0.1), position=(1.0, 0.5), **SURFACE)
    sim.step(120)
    assert sim.asleep[1]
    sim.set_shape(post, t2.Disc(radius=0.6))
    sim.step(60)
    assert sim.position[1, 0] == pytest.approx(-0.1, abs=0.01)


def test_what_grows_in_a_pile_is_pushed_apart_without_an_explosion() -> None:
    """The speeds are those at which overlaps end, far below that of a fall through a body."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(t2.Box(width=20.0, height=1.0), position=(0.0, -0.5), **SURFACE)
    for k in range(5):
        for n in range(5):
            at = (n - 2.0, 0.5 + k)
            scene.add_body(BOX, mass=1.0, position=at, name=f"{k}{n}", **SURFACE)
    sim = t2.Simulator(scene)
    sim.step(120)
    sim.set_shape("22", t2.Box(width=1.3, height=1.3))
    fastest = 0.0
    for _ in range(240):
        sim.step()
        fastest = max(fastest, float(np.abs(sim.velocity).max()))
    assert fastest < 1.5
    assert sim.position[:, 1].max() == pytest.approx(4.5 + 0.3, abs=0.05)
    assert np.abs(sim.position[:, 0]).max() < 3.0


def test_joints_hold_on_through_changes() -> None:
    """A pendulum keeps its length, and beats as its inertia about the pivot says."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_body(BOX, mass=1.0, position=(0.0, -2.0), restitution=0.0, name="bob")
    scene.add_joint(t2.Revolute(), (0.0, 0.0), "bob", other_anchor=(0.0, 2.0), name="pivot")
    sim = t2.Simulator(scene)
    sim.velocity[0], sim.angular_velocity[0] = (0.02, 0.0), 0.01
    sim.step(10)
    shape = t2.Box(width=0.2, height=4.0)
    sim.set_shape("bob", shape, mass=3.0)
    assert sim.joints == ("pivot",)
    copied = copy.deepcopy(sim)
    angles = []
    for _ in range(600):
        sim.step()
        angles.append(float(sim.orientation[0]))
        assert np.hypot(*sim.position[0]) == pytest.approx(2.0, abs=1e-6)
    copied.step(600)
    assert sim.digest() == copied.digest()
    crossed = [k for k, (a, b) in enumerate(pairwise(angles)) if a < 0.0 <= b]
    period = (crossed[-1] - crossed[0]) / 60 / (len(crossed) - 1)
    beat = 2 * math.pi * math.sqrt((shape.inertia(3.0) + 3.0 * 4.0) / (3.0 * 10.0 * 2.0))
    assert period == pytest.approx(beat, rel=5e-3)
    assert sim.reactions.force[0, 0] == pytest.approx((0.0, -30.0), abs=0.1)


def test_how_large_bodies_and_their_joints_are_follows_the_shapes() -> None:
    """By that a joint is judged to be apart, and a body to be far from the origin."""
    sim = space()
    sim.add(t2.Disc(radius=9.0), mass=1.0, position=(0.0, 0.0), restitution=0.0)
    sim.add_joint(t2.Revolute(), 0, (0.0, 0.0))
    for radius in (9.0, 0.25, 4.0):
        sim.set_shape(0, t2.Disc(radius=radius))
        sim.step()
        assert sim._engine.largest_radius == radius
        assert set(sim._joints.layout.sizes.tolist()) == {radius}


def test_what_a_spring_holds_beats_as_it_weighs_now() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(DISC, mass=1.0, position=(1.0, 0.0), restitution=0.0)
    scene.add_spring(0, (0.0, 0.0), stiffness=100.0, rest_length=0.0)
    sim = t2.Simulator(scene, time_step=1e-3)
    sim.set_mass(0, mass=4.0)
    sim.set_shape(0, BOX)
    sim.step(314)  # half a period of 2 pi sqrt(4/100)... a quarter of which is at the centre
    assert sim.position[0, 0] == pytest.approx(math.cos(5.0 * 0.314), abs=1e-4)


# -- order and keeping


@settings(max_examples=8, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_the_order_of_adding_changes_no_bit(seed: int) -> None:
    chance = np.random.default_rng(seed)
    scene = crowd(15, seed=seed % 1000)
    names = [body.name for body in scene.bodies if body.dynamic]
    order = chance.permutation(len(scene)).tolist()
    sims = t2.Simulator(scene), t2.Simulator(rebuilt(scene, order))
    for _ in range(6):
        some = chance.choice(names, 3, replace=False).tolist()
        shapes = [SHAPES[int(chance.integers(5))] for _ in some]
        mass = chance.uniform(0.5, 2.0, 3)
        turn = chance.permutation(3)
        for sim, own in zip(sims, (range(3), turn), strict=True):
            sim.set_shape([some[k] for k in own], [shapes[k] for k in own], mass=mass[[*own]])
            sim.step(8)
        assert sims[0].digest() == sims[1].digest()
    told = [sorted(map(sorted, _named(sim, sim.contacts.bodies))) for sim in sims]
    assert told[0] == told[1]


def _named(sim: t2.Simulator, pairs: Any) -> list[list[str]]:
    return [[str(sim.name(k)) for k in pair] for pair in pairs.tolist()]


def test_saved_and_plain_ones_go_on_with_the_same_bits(tmp_path: Path) -> None:
    sim = t2.Simulator(crowd(12, seed=5))
    sim.step(60)
    sim.set_shape([4, 5, 6], [SHAPES[4], DISC, BOX], mass=[1.0, 2.0, 3.0])
    sim.save(tmp_path / "sim.npz")
    restored = t2.Simulator.restore(tmp_path / "sim.npz")
    plain = t2.Simulator.restore(tmp_path / "sim.npz", compiled=False)
    for each in (sim, restored, plain):
        each.step(3)
    assert sim.digest() == restored.digest() == plain.digest()
    assert sim.ended.tolist() == restored.ended.tolist() == plain.ended.tolist()
    assert sim.began.bodies.tolist() == restored.began.bodies.tolist()


def test_rows_of_shapes_are_used_again() -> None:
    sim = ground()
    sim.add(BOX, mass=1.0, position=(0.0, 0.5), **SURFACE)
    for k in range(60):
        sim.set_shape(1, (PAIR, DISC, BOX)[k % 3])
        sim.step()
    assert sim._engine.capacities.shapes < 20
    assert sim._engine.capacities.vertices < 60


# -- ground


def hill(count: int, **words: Any) -> t2.Chain:
    x = np.linspace(4.0, -4.0, count + 1)
    return t2.Chain(
        vertices=list(zip(x.tolist(), (0.1 * np.sin(x)).tolist(), strict=True)), **words
    )


@pytest.mark.parametrize("shape", [hill(7), hill(3), hill(7, one_sided=True), PLANE, BOX])
def test_ground_changes_under_what_lies_on_it(shape: Any) -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)))
    sim.add_static(hill(5), name="ground", **SURFACE)
    sim.add(t2.Capsule(length=0.4, radius=0.2), mass=1.0, position=(0.1, 0.4), **SURFACE)
    sim.step(60)
    sim.set_shape("ground", shape)
    assert sim.body(0).shape == shape
    sim.step(120)
    top = 0.5 if shape == BOX else 0.0
    assert top - 0.1 < sim.position[1, 1] < top + 0.6
    assert np.abs(sim.velocity).max() < 0.5


def test_a_platform_that_moves_may_be_a_chain() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)))
    sim.add_kinematic(BOX, position=(0.0, 0.0), velocity=(0.0, 0.5), **SURFACE)
    sim.set_shape(0, hill(6))
    sim.add(DISC, mass=1.0, position=(0.0, 0.6), **SURFACE)
    sim.step(60)
    assert sim.velocity[1, 1] == pytest.approx(0.5, abs=0.05)


def test_pieces_of_a_chain_lie_side_by_side() -> None:
    """The engine goes from one to the next by their rows, of which others may be free."""
    sim = space()
    rods = sim.add_static(
        t2.Segment(length=1.0), position=[(3.0 * k, 0.0) for k in range(6)], restitution=0.0
    )
    sim.step()
    sim.remove(rods[[1, 3, 4]])
    sim.step()
    chain = sim.add_static(hill(3), position=(0.0, 9.0), restitution=0.0)
    sim.add_static(t2.Segment(length=2.0), position=(50.0, 9.0), restitution=0.0)
    sim.step()
    owner = sim._engine.world.state.body_of_shape
    assert np.diff(np.flatnonzero(owner == chain)).tolist() == [1, 1]
    for count in (5, 2, 7, 4):
        sim.set_shape(chain, hill(count))
        sim.step()
        owner = sim._engine.world.state.body_of_shape
        assert np.diff(np.flatnonzero(owner == chain)).tolist() == [1] * (count - 1)
        assert sim.body(chain).shape == hill(count)


def test_bodies_that_take_free_rows_stand_in_their_order() -> None:
    """The saved state of what touches is refused where shapes are not in the order of bodies."""
    sim = ground()
    rods = sim.add(
        [DISC, BOX, DISC, BOX], mass=1.0, position=[(3.0 * k, 0.5) for k in range(4)], **SURFACE
    )
    sim.step()
    sim.remove(rods[:3])
    sim.step()
    places = [(-9.0, 0.5), (-9.0, 1.5), (-5.0, 0.5), (-5.0, 1.5), (-7.0, 0.5)]
    sim.add([BOX, DISC, PAIR, BOX, DISC], mass=1.0, position=places, **SURFACE)
    sim.step(5)
    copied = copy.deepcopy(sim)
    for each in (sim, copied):
        each.step(60)
    assert sim.digest() == copied.digest()


# -- refusals


@pytest.mark.parametrize(
    ("call", "words", "message"),
    [
        ("set_mass", {"bodies": 0, "mass": 1.0}, "mass of body 'floor': nothing can push it"),
        ("set_mass", {"bodies": 1, "mass": -1.0}, r"mass\[0\] -1 kg of the bodies: must be > 0"),
        ("set_mass", {"bodies": 1, "mass": math.nan}, r"mass\[0\] of the bodies: found nan"),
        ("set_mass", {"bodies": 1, "mass": 1e-310}, r"mass\[0\] .*cannot hold its inverse"),
        ("set_mass", {"bodies": 1, "mass": [1.0, 2.0]}, r"found an array of shape \(2,\)"),
        ("set_mass", {"bodies": 1, "mass": 1.0, "inertia": -math.inf}, "found -inf"),
        ("set_mass", {"bodies": 2, "mass": 1e300}, r"inertia\[0\] .*cannot hold its inverse"),
        ("set_mass", {"bodies": 9, "mass": 1.0}, "body 9: the simulator has none such"),
        ("set_drag", {"bodies": 1}, r"found nothing to change \(R2\)"),
        ("set_drag", {"bodies": 0, "linear_drag": 1.0}, "linear drag of body 'floor'"),
        ("set_drag", {"bodies": 1, "angular_drag": -1.0}, r"angular drag\[0\] -1"),
        ("set_drag", {"bodies": 1, "linear_drag": 1e308, "angular_drag": 0.0}, "beyond float64"),
        ("set_shape", {"bodies": 1, "shape": PLANE}, "found a half-plane: it cannot move"),
        ("set_shape", {"bodies": 1, "shape": hill(2)}, "found a chain: it cannot move freely"),
        ("set_shape", {"bodies": 1, "shape": None}, "found None: must be a shape"),
        ("set_shape", {"bodies": 1, "shape": [BOX, BOX]}, "found 2 for 1 bodies"),
        ("set_shape", {"bodies": 3, "shape": BOX}, "body 3: it is a particle"),
        ("set_shape", {"bodies": 0, "shape": PLANE, "mass": 1.0}, "mass of body 'floor'"),
        ("set_shape", {"bodies": 1, "shape": BOX, "mass": 0.0}, r"mass\[0\] 0 kg of the bodies"),
        ("set_shape", {"bodies": 1, "shape": t2.Disc(radius=1e-170)}, "cannot hold its inverse"),
    ],
)
def test_what_has_no_answer_is_refused_and_changes_nothing(
    call: str, words: dict[str, Any], message: str
) -> None:
    sim = ground()
    sim.add(BOX, mass=1e-3, position=(0.0, 2.0), **SURFACE)
    sim.add(BOX, mass=1.0, inertia=1e200, position=(3.0, 2.0), **SURFACE)
    sim.add(None, mass=1.0, position=(9.0, 9.0))
    sim.step()
    before, bodies = sim.digest(), [sim.body(k) for k in range(4)]
    with pytest.raises(t2.InputError, match=message):
        getattr(sim, call)(**words)
    assert sim.digest() == before
    assert [sim.body(k) for k in range(4)] == bodies
