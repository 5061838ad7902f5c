"""What is at rest sleeps as a whole, wakes as a whole, and is the same meanwhile."""

import math
import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine.sleep import SLEEP_SPEED
from tamias2d.engine.tables import SLEEPING, TOUCHING
from tamias2d.generated import sleeping

SURFACE: Any = {"friction": 0.6, "restitution": 0.0}
BOX = t2.Box(width=1.0, height=1.0)


def stack(
    count: int, *, top: float = 1.0, sleeping: bool = True, substeps: int = 4
) -> t2.Simulator:
    """Return a stack on the ground, which is body 0; the mass of the top box in kg."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    for k in range(count):
        mass = top if k == count - 1 else 1.0
        scene.add_body(BOX, mass=mass, position=(0.0, 0.5 + k), **SURFACE)
    return t2.Simulator(scene, sleeping=sleeping, substeps=substeps)


def slept(count: int = 4, within: int = 120) -> t2.Simulator:
    """Return a stack that sleeps."""
    sim = stack(count)
    for _ in range(within):
        sim.step()
        if sim.asleep[1:].all():
            return sim
    raise AssertionError("it does not fall asleep")


def test_it_falls_asleep_after_half_a_second_and_costs_nothing() -> None:
    sim = stack(4)
    sim.step(29)
    assert not sim.asleep.any()
    sim.step(2)
    assert sim.asleep.tolist() == [False, True, True, True, True]
    place, turn = sim.position.copy(), sim.orientation.copy()
    sim.step(100)
    assert sim.position.tobytes() == place.tobytes()
    assert sim.orientation.tobytes() == turn.tobytes()
    assert not sim.velocity.any()
    assert sim._engine.world.touching.counts[TOUCHING] == 0


def test_steps_in_which_all_sleep_are_counted_and_not_taken() -> None:
    """A step that is taken counts anew how many bodies sleep."""
    sim = slept()
    sim.step()
    sim._engine.world.islands.counts[SLEEPING] = 77
    sim.step(1000)
    assert sim.asleep[1:].all()
    assert sim._engine.world.islands.counts[SLEEPING] == 77
    sim.velocity[1, 0] = 1.0
    sim.step()
    assert not sim.asleep.any()
    assert sim._engine.world.islands.counts[SLEEPING] == 0


def test_what_sleeps_touches_on() -> None:
    sim = stack(3)
    began = ended = 0
    for _ in range(100):
        sim.step()
        began += len(sim.began)
        ended += len(sim.ended)
    assert (began, ended) == (3, 0)
    assert len(sim.contacts) == 6


def fast_crowd(sim: t2.Simulator) -> None:
    """Add discs that land so fast, far off, that steps are taken in parts."""
    place = [(30.0 + 0.025 * (k % 10), 0.05 + 0.025 * (k // 10)) for k in range(60)]
    sim.add(t2.Disc(radius=0.01), mass=0.01, position=place, velocity=(0.0, -6.0), **SURFACE)


@pytest.mark.parametrize("asleep", [True, False])
def test_it_touches_on_while_others_are_solved_in_parts(asleep: bool) -> None:
    """Asleep before or falling asleep meanwhile, it is told the push that carries its weight."""
    parted = 0
    for begin in [120] if asleep else range(20, 32):
        sim = stack(1)
        sim.step(begin)
        fast_crowd(sim)
        slept_in_parts = False
        for _ in range(30):
            before = bool(sim.asleep[1])
            sim.step()
            slept_in_parts |= sim.parts > 1 and bool(sim.asleep[1]) and before is asleep
            contacts = sim.contacts
            own = (contacts.bodies == 1).any(axis=1)
            pushed = float(contacts.impulse[own] @ contacts.normal[own, 1])
            assert set(sim.touching(1).bodies.ravel().tolist()) == {0, 1}
            assert pushed == pytest.approx(10.0 * sim.time_step, rel=0.02)
            assert not (sim.began.bodies == 1).any()
            assert not (sim.ended == 1).any()
        parted += slept_in_parts
    assert parted > 0


def test_what_wakes_in_parts_is_told_what_it_was_pushed_with_then() -> None:
    """A crowd lands on a box that sleeps, and presses it on its ground."""
    sim = slept(1)
    sim.step()
    place = [(-0.4 + 0.025 * (k % 30), 1.05 + 0.025 * (k // 30)) for k in range(150)]
    sim.add(t2.Disc(radius=0.01), mass=0.01, position=place, velocity=(0.0, -6.0), **SURFACE)
    twin = pickle.loads(pickle.dumps(sim))
    twin.wake(1)
    told = []
    for each in (sim, twin):
        while each.parts == 1:
            each.step()
        contacts = each.contacts
        own = (contacts.bodies == (0, 1)).all(axis=1)
        told.append(contacts.impulse[own].sum())
    assert not sim.asleep[1]
    assert told[0] == pytest.approx(told[1], rel=0.05)


def test_falling_asleep_loses_no_more_than_quiet_bodies_have() -> None:
    """IM13; a twin that does not sleep tells what is lost, which is not nothing."""
    sims = [stack(4, top=9.0, sleeping=sleeps) for sleeps in (True, False)]
    for sim in sims:
        sim.velocity[1:, 0] = 0.01
    while not sims[0].asleep.any():
        for sim in sims:
            sim.step()
    twin, extent = sims[1], math.sqrt(0.5)
    for body, mass in zip(range(1, 5), (1.0, 1.0, 1.0, 9.0), strict=True):
        lost = 0.5 * mass * (twin.velocity[body] ** 2).sum()
        lost += mass / 12 * twin.angular_velocity[body] ** 2
        quiet = sleeping.quiet_square(SLEEP_SPEED, extent, 10.0)
        assert 0.0 < lost <= sleeping.kinetic_energy_most(mass, mass / 6, extent, quiet)


def test_without_sleeping_nothing_sleeps() -> None:
    sim = stack(3, sleeping=False)
    sim.step(100)
    assert not sim.asleep.any()


WAYS: dict[str, Callable[[t2.Simulator], object]] = {
    "moved": lambda sim: sim.position.__setitem__((4, 0), 0.01),
    "turned": lambda sim: sim.orientation.__setitem__(2, 1e-6),
    "set in motion": lambda sim: sim.velocity.__setitem__((1, 0), 1e-6),
    "spun": lambda sim: sim.angular_velocity.__setitem__(1, 1e-6),
    "pushed": lambda sim: sim.force.__setitem__((3, 0), 1e-6),
    "twisted": lambda sim: sim.torque.__setitem__(3, 1e-6),
    "pushed once": lambda sim: sim.apply_force(2, (1.0, 0.0)),
    "hit": lambda sim: sim.apply_impulse(2, (1.0, 0.0)),
    "other gravity": lambda sim: sim.gravity.__setitem__(0, 0.1),
    "neighbour removed": lambda sim: sim.remove(4),
    "ground removed": lambda sim: sim.remove(0),
    "something on it": lambda sim: sim.add(BOX, mass=1.0, position=(0.2, 4.5), **SURFACE),
    "wall in it": lambda sim: sim.add_static(BOX, position=(0.9, 0.5), **SURFACE),
    "woken": lambda sim: sim.wake(3),
}


@pytest.mark.parametrize("counted", [0, 5])
@pytest.mark.parametrize("way", WAYS)
def test_it_wakes_as_a_whole(way: str, counted: int) -> None:
    """In the step after it fell asleep, or after steps that were only counted."""
    sim = slept()
    sim.step(counted)
    WAYS[way](sim)
    sim.step()
    assert not sim.asleep.any()


HELD: dict[str, Callable[[t2.Simulator], Any]] = {
    "a view": lambda sim: sim.velocity,
    "a part of a view": lambda sim: sim.velocity[2:],
    "a part of a part": lambda sim: sim.velocity[1:][::-1].T,
    "a buffer": lambda sim: memoryview(sim.torque),
    "gravity": lambda sim: sim.gravity[:1],
}


@pytest.mark.parametrize("what", HELD)
def test_what_is_written_into_a_view_that_is_held_counts(what: str) -> None:
    """However many steps were only counted since it was taken, and nothing else was looked at."""
    sim = slept()
    held = HELD[what](sim)
    for _ in range(3):
        sim.step()
    held[-1] = 1e-3
    sim.step()
    assert not sim.asleep.any()


def test_where_nobody_holds_a_view_nothing_is_looked_at() -> None:
    """A change that nobody can have made, for it needs a view, is not found."""
    sim = slept()
    sim.step()  # since `asleep` was asked for
    load = sim._engine.load
    load[2] = 1.0
    sim.step()
    assert sim._engine.asleep[1:].all()
    assert sim.force.any()  # looked at: the next step finds it
    sim.step()
    assert not sim.asleep.any()


def test_it_wakes_where_its_ground_is_taken_away() -> None:
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(t2.Box(width=4.0, height=1.0), **SURFACE)
    scene.add_body(BOX, mass=1.0, position=(0.0, 1.0), **SURFACE)
    sim = t2.Simulator(scene, sleeping=True)
    sim.step(60)
    assert sim.asleep[1]
    sim.position[0] = (0.0, -50.0)
    sim.step(30)
    assert sim.position[1, 1] < 0.0


def test_what_is_far_sleeps_on() -> None:
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    for x in (0.0, 3.0):
        scene.add_body(BOX, mass=1.0, position=(x, 0.5), **SURFACE)
    sim = t2.Simulator(scene, sleeping=True)
    sim.step(60)
    sim.apply_impulse(1, (0.0, 3.0))
    sim.step(10)
    assert sim.asleep.tolist() == [False, False, True]


def test_a_bullet_wakes_a_pile() -> None:
    sim = slept(6)
    bullet = sim.add(
        t2.Disc(radius=0.1), mass=0.5, position=(-10.0, 2.5), velocity=(300.0, 0.0), **SURFACE
    )
    for _ in range(6):
        sim.step()
        if sim.position[bullet, 0] > -1.0:
            break
        assert sim.asleep[1:7].all()
    sim.step(2)
    assert not sim.asleep.any()
    assert sim.velocity[1:7, 0].max() > 1.0


def test_what_rides_on_something_that_moves_does_not_sleep() -> None:
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_kinematic(
        t2.Box(width=50.0, height=1.0), position=(0.0, 0.0), velocity=(1e-3, 0.0), **SURFACE
    )
    scene.add_body(BOX, mass=1.0, position=(0.0, 1.0), velocity=(1e-3, 0.0), **SURFACE)
    sim = t2.Simulator(scene, sleeping=True)
    sim.step(120)
    assert not sim.asleep.any()


@pytest.mark.parametrize("speed", [0.3, 0.03, 0.003])
def test_what_rides_on_a_surface_that_runs_does_not_sleep(speed: float) -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)), sleeping=True)
    belt = sim.add_static(
        t2.Box(width=60.0, height=1.0), position=(0.0, 0.0), surface_speed=-speed, **SURFACE
    )
    riders = sim.add(BOX, mass=1.0, position=[(0.0, 1.0), (0.0, 2.0), (5.0, 1.0)], **SURFACE)
    start = sim.position[riders, 0]
    sim.step(600)
    assert not sim.asleep.any()
    assert sim.position[riders, 0] - start == pytest.approx(speed * sim.time, rel=0.02)
    sim.set_surface(belt, surface_speed=0.0)
    sim.step(60)
    assert sim.asleep[riders].all()
    place = sim.position[riders, 0]
    sim.set_surface(belt, surface_speed=-speed)
    sim.step(60)
    assert not sim.asleep.any()
    assert sim.position[riders, 0] - place == pytest.approx(speed, rel=0.1)


def test_what_is_beside_a_surface_that_runs_sleeps() -> None:
    """So does what hangs on its body by a joint."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)), sleeping=True)
    belt = sim.add_static(
        t2.Box(width=6.0, height=1.0), position=(0.0, 0.0), surface_speed=1.0, **SURFACE
    )
    sim.add_static(BOX, position=(5.0, 0.0), **SURFACE)
    beside = sim.add(BOX, mass=1.0, position=(5.0, 1.0), **SURFACE)
    hung = sim.add(BOX, mass=1.0, position=(0.0, -2.0), angular_drag=5.0, **SURFACE)
    sim.add_joint(t2.Weld(), belt, hung, at=(0.0, 0.0))
    sim.step(120)
    assert sim.asleep[[beside, hung]].all()


def test_what_touches_nothing_is_not_stopped() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), sleeping=True)
    sim.add(
        BOX,
        mass=1.0,
        position=[(0.0, 0.0), (5.0, 0.0)],
        velocity=[(1e-9, 0.0), (0.0, 0.0)],
        **SURFACE,
    )
    sim.step(60)
    assert sim.asleep.tolist() == [False, True]
    assert sim.velocity[0, 0] == 1e-9


def test_a_copy_sleeps_and_wakes_alike() -> None:
    sim = slept()
    copy = pickle.loads(pickle.dumps(sim))
    assert copy.asleep.tolist() == sim.asleep.tolist()
    for each in (sim, copy):
        each.apply_impulse(4, (1.0, 0.0))
        each.step(20)
    assert copy.digest() == sim.digest()


def test_the_order_of_adding_does_not_matter() -> None:
    ends = []
    for order in (1, -1):
        sim = stack(0)
        places = np.array([(4.0 * k, 0.5 + j + 0.1 * k) for k in range(3) for j in range(3)])
        sim.add(BOX, mass=1.0, position=places[::order], **SURFACE)
        told = []
        for _ in range(90):
            sim.step()
            told.append((sim.digest(), int(sim.asleep.sum())))
        ends.append(told)
    assert ends[0] == ends[1]
    assert ends[0][-1][1] == 9


@pytest.mark.parametrize(
    ("count", "top", "substeps"),
    [(10, 100.0, 4), (100, 1.0, 12)],
)
def test_tall_and_top_heavy_stacks_stand_and_sleep(count: int, top: float, substeps: int) -> None:
    sim = stack(count, top=top, substeps=substeps)
    start = sim.position.copy()
    for _ in range(1800):
        sim.step()
        if sim.asleep[1:].all():
            break
    assert sim.asleep[1:].all()
    assert np.abs(sim.position - start)[:, 0].max() < 0.1
    assert (start - sim.position)[:, 1].max() < 0.05 * count


def test_a_pile_falls_asleep_and_a_bullet_wakes_it() -> None:
    rng = np.random.default_rng(5)
    scene = t2.Scene(gravity=(0.0, -10.0))
    for normal in ((0.0, 1.0), (1.0, 0.0), (-1.0, 0.0)):
        scene.add_static(t2.HalfPlane(normal=normal, offset=-3.0), **SURFACE)
    sim = t2.Simulator(scene, sleeping=True)
    shapes: Any = [
        BOX,
        t2.Box(width=0.8, height=0.4),
        t2.Polygon(vertices=[(0, 0), (0.9, 0), (0, 0.7)]),
    ]
    places = [(0.3 * rng.uniform(-1, 1) + 1.4 * (k % 4) - 2.1, 1.2 * (k // 4)) for k in range(48)]
    picked = [shapes[k % 3] for k in range(48)]
    sim.add(picked, mass=1.0, position=places, orientation=rng.uniform(-1, 1, 48), **SURFACE)
    for _ in range(40):
        sim.step(60)
        if sim.asleep[3:].all():
            break
    assert sim.asleep[3:].all()
    place = sim.position.copy()
    sim.step(60)
    assert sim._engine.world.touching.counts[TOUCHING] == 0
    assert sim.position.tobytes() == place.tobytes()
    sim.add(t2.Disc(radius=0.1), mass=1.0, position=(0.0, 30.0), velocity=(0.0, -900.0), **SURFACE)
    sim.step(10)
    assert sim.asleep[3:].sum() <= 1  # in a corner, one lies apart from the pile


def test_only_true_and_false_are_taken() -> None:
    with pytest.raises(t2.InputError, match="sleeping: found 1: must be True or False"):
        t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), sleeping=1)  # type: ignore[arg-type]


def standing(*, lift: bool) -> t2.Simulator:
    """Return a world without anything that can be pushed, which may hold a lift that stands."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)), sleeping=True)
    if lift:
        sim.add_static(t2.Disc(radius=0.5), position=(0.0, -3.0), sensor=True)
        sim.add_kinematic(BOX, position=(0.0, 0.0), **SURFACE)
    return sim


@pytest.mark.parametrize("lift", [False, True])
def test_a_world_in_which_nothing_moves_sleeps(lift: bool) -> None:
    sim = standing(lift=lift)
    sim.step(2)
    sim._engine.world.islands.counts[SLEEPING] = 77
    sim.step(1000)
    assert sim._engine.world.islands.counts[SLEEPING] == 77
    assert sim.time == pytest.approx(1002 / 60)
    box = sim.add(BOX, mass=1.0, position=(5.0, 0.0), **SURFACE)
    sim.step(60)
    assert sim.velocity[box, 1] == pytest.approx(-10.0)


def test_a_lift_that_stood_alone_goes_when_it_is_told() -> None:
    sim = standing(lift=True)
    sim.step(100)
    sim.velocity[1] = 0.0, -1.0
    sim.step(150)
    assert sim.position[1, 1] == pytest.approx(-2.5)
    assert sim.began.bodies.tolist() == [[0, 1]]
