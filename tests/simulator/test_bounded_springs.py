"""Springs of joints with a maximum in steps, against Newton's law by hand (DD103, DD105)."""

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine import tables as tb
from tamias2d.engine.joints import grouping
from tamias2d.scene import Scene
from tamias2d.simulator import Simulator
from tamias2d.state import Array
from tests.engine.scenes import plain

G, MOST, MASS = 10.0, 10.0, 2.0
FAR = (60.0, 80.0)
TOWARDS = np.array([0.6, 0.8])


def pulled(spring: t2.JointSpring, to: tuple[float, float] = FAR, **settings: Any) -> Simulator:
    """Return a disc that a point of the plane pulls, and nothing else."""
    sim = plain(Scene(gravity=(0.0, 0.0)), **settings)
    ball = sim.add(t2.Disc(radius=0.5), mass=MASS, position=(0.0, 0.0), restitution=0.0)
    sim.add_joint(t2.Target(spring=spring), to, ball, name="mouse")
    return sim


def most(stiffness: float, damping: float = 0.0, maximum: float | None = MOST) -> t2.JointSpring:
    return t2.JointSpring(stiffness=stiffness, damping=damping, maximum=maximum)


def forces(sim: Simulator) -> Array:
    """Return the size of what each spring with a maximum gave in the last step, over that."""
    joints = sim._engine.world.joints
    count = joints.counts[tb.JOINTS]
    ends, force = joints.joints[:count], joints.numbers[:count, tb.J_FORCE]
    return np.array([
        math.hypot(force[j], force[pair] if pair >= 0 else 0.0) / joints.laws[j, tb.LAW_MOST]
        for j, pair in enumerate(ends[:, tb.J_PAIR].tolist())
        if ends[j, tb.J_LAW] == tb.SPRING and pair != tb.OF_PAIR
    ])  # fmt: skip


@pytest.mark.parametrize(
    ("spring", "substeps"),
    [(most(1e3), 1), (most(1e6, 100.0), 4), (most(1e6, 1e4), 2)],
    ids=["soft", "stiff", "damped"],
)
def test_far_point_accelerates_by_the_maximum_over_the_mass(
    spring: t2.JointSpring, substeps: int
) -> None:
    sim = pulled(spring, time_step=1 / 60, substeps=substeps)
    for k in range(1, 31):
        sim.step()
        time = k / 60
        assert sim.velocity[0] == pytest.approx(MOST / MASS * time * TOWARDS, rel=1e-8)
        assert sim.position[0] == pytest.approx(MOST / MASS * time**2 / 2 * TOWARDS, rel=1e-5)
        assert sim.reactions.force[0, 1] == pytest.approx(MOST * TOWARDS, rel=1e-8)
    assert sim.angular_velocity[0] == 0.0


@pytest.mark.parametrize("direction", [0.0, 0.7, 2.5, -1.9])
@pytest.mark.parametrize("damping", [1e3, 1e5])
def test_strong_damper_is_friction_seen_from_above(direction: float, damping: float) -> None:
    """Alike in all directions: it stops after v^2 m/(2 F), and goes straight there."""
    way, speed = np.array([math.cos(direction), math.sin(direction)]), 3.0
    sim = plain(Scene(gravity=(0.0, 0.0)), time_step=1 / 60)
    velocity = (speed * way).tolist()
    sim.add(t2.Disc(radius=0.5), mass=MASS, position=(0, 0), velocity=velocity, restitution=0.0)
    sim.add_joint(t2.Target(spring=most(0.0, damping)), (0.0, 0.0), 0)
    speeds = []
    for _ in range(60):
        sim.step()
        speeds.append(math.hypot(*sim.velocity[0]))
        assert abs(way[0] * sim.position[0, 1] - way[1] * sim.position[0, 0]) < 1e-13
    lost = np.array(speeds[:35])
    assert lost == pytest.approx(speed - MOST / MASS * np.arange(1, 36) / 60, abs=1e-8)
    assert sim.position[0] == pytest.approx(speed**2 * MASS / (2 * MOST) * way, abs=1e-4)
    assert speeds[-1] < 1e-6


def test_slider_with_a_bounded_damper_slows_at_its_maximum() -> None:
    sim = plain(Scene(gravity=(0.0, 0.0)), time_step=1 / 60)
    sim.add(t2.Box(width=1, height=1), mass=MASS, position=(0, 0), velocity=(4, 0), restitution=0.0)
    slide = t2.Prismatic(axis=(1.0, 0.0), spring=most(0.0, 50.0))
    sim.add_joint(slide, (0.0, 0.0), 0)
    sim.step(30)
    assert sim.velocity[0, 0] == pytest.approx(4 - MOST / MASS * 0.5, abs=1e-8)
    assert sim.position[0, 0] == pytest.approx(4 * 0.5 - MOST / MASS * 0.125, abs=1e-3)


def test_spring_of_an_angle_turns_by_its_maximum() -> None:
    sim = plain(Scene(gravity=(0.0, 0.0)), time_step=1 / 60)
    sim.add(t2.Disc(radius=0.5), mass=MASS, inertia=4.0, position=(0, 0), restitution=0.0)
    spring = t2.JointSpring(stiffness=1e4, rest=50.0, maximum=6.0)
    sim.add_joint(t2.Rotary(spring=spring), (0.0, 0.0), 0)
    sim.step(60)
    assert sim.angular_velocity[0] == pytest.approx(1.5, rel=1e-8)
    assert sim.orientation[0] == pytest.approx(0.75, rel=1e-5)


@pytest.mark.parametrize("force", [9.0, 9.9, 10.1, 14.0])
def test_dragged_box_slides_where_the_pull_is_more_than_friction(force: float) -> None:
    friction = 0.5
    sim = plain(Scene(gravity=(0.0, -G)), time_step=1 / 60)
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    sim.add_static(floor, restitution=0.0, friction=friction)
    box = sim.add(
        t2.Box(width=1, height=1), mass=MASS, position=(0, 0.5), restitution=0.0, friction=friction
    )
    sim.add_joint(t2.Target(spring=most(1e4, maximum=force)), (100.0, 0.5), box)
    sim.step(12)
    before = sim.velocity[box, 0]
    sim.step(24)
    gained = max(force - friction * MASS * G, 0.0) / MASS * 24 / 60
    assert sim.velocity[box, 0] - before == pytest.approx(gained, abs=1e-4)
    assert forces(sim) == pytest.approx([1.0], rel=1e-8)
    if force < friction * MASS * G:
        assert abs(sim.position[box, 0]) < 1e-4


def test_what_is_pinned_presses_with_the_maximum() -> None:
    sim = plain(Scene(gravity=(0.0, 0.0)), time_step=1 / 60)
    sim.add_static(t2.Box(width=1, height=4), position=(1.0, 0.0), restitution=0.0, friction=0.0)
    box = sim.add(
        t2.Box(width=1, height=1), mass=MASS, position=(0, 0), restitution=0.0, friction=0.0
    )
    sim.add_joint(t2.Target(spring=most(1e5, 1e3, 7.0)), (100.0, 0.0), box)
    sim.step(40)
    assert sim.contacts.impulse.sum() == pytest.approx(7.0 / 60, rel=1e-6)
    assert sim.position[box, 0] == pytest.approx(0.0, abs=1e-4)
    assert forces(sim).max() <= 1 + 1e-12


def test_what_leaves_the_ground_is_pulled_by_no_more_than_the_maximum() -> None:
    """Steps in contact leave an impulse to the next: the first one in flight counts it.

    It so gives half of a substep less.
    """
    sim = plain(Scene(gravity=(0.0, -G)), time_step=1 / 60, substeps=1)
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    sim.add_static(floor, restitution=0.0, friction=0.5)
    box = t2.Box(width=1, height=1)
    sim.add(box, mass=MASS, position=(0, 0.5), restitution=0.0, friction=0.5)
    sim.add_joint(t2.Target(spring=most(1e4, maximum=3 * MASS * G)), (0.0, 50.0), 1)
    for _ in range(12):
        sim.step()
        assert forces(sim).max() <= 1 + 1e-12
    assert sim.velocity[1, 1] == pytest.approx(2 * G * 11.25 / 60, abs=1e-6)


def test_heap_stays_whole_where_a_weak_hand_pulls() -> None:
    sim = plain(Scene(gravity=(0.0, -G)), time_step=1 / 60)
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    sim.add_static(floor, restitution=0.0, friction=0.5)
    for level in range(3):
        sim.add(
            *(t2.Box(width=1, height=1),), mass=1.0, position=(0, 0.5 + level),
            restitution=0.0, friction=0.5,
        )  # fmt: skip
    sim.add_joint(t2.Target(spring=most(1e6, 1e3, 8.0)), (100.0, 1.5), 2)
    start = sim.position.copy()
    sim.step(60)
    assert sim.position == pytest.approx(start, abs=1e-2)
    assert np.abs(sim.velocity).max() < 1e-3


def huber(spring: t2.JointSpring, stretch: float) -> float:
    """Return the energy of a spring with a maximum that is stretched."""
    limit = spring.maximum or math.inf
    if spring.stiffness * stretch <= limit:
        return spring.stiffness * stretch**2 / 2
    return limit * stretch - limit**2 / (2 * spring.stiffness)


def random_mechanism(seed: int) -> tuple[Simulator, Callable[[], float]]:
    """Return boxes hinged to each other, some by springs, that are pulled; and their energy."""
    random = np.random.default_rng(seed)
    sim = plain(Scene(gravity=(0.0, -G)), time_step=1 / 60, substeps=2)
    count = int(random.integers(1, 6))
    above = [int(random.integers(max(k - 2, 0), k)) for k in range(1, count)]
    spread = [(k, 0.0) for k in range(count)]
    for place in spread:
        box = t2.Box(width=1.0, height=0.3)
        sim.add(
            box, mass=10 ** random.uniform(-0.5, 0.5), position=place, restitution=0.0, group=-1
        )
    weight = G * sim.mass.sum()
    elbows: list[tuple[int, int, t2.JointSpring]] = []
    for one, other in zip(above, range(1, count), strict=True):
        elbow = t2.JointSpring(
            stiffness=10 ** random.uniform(0, 3), damping=random.choice([0.0, 1.0]), rest=0.0,
            maximum=weight * 10 ** random.uniform(-2, 1),
        )  # fmt: skip
        sprung = random.random() < 0.5
        elbows += [(one, other, elbow)] if sprung else []
        at = ((spread[one][0] + spread[other][0]) / 2, 0.0)
        sim.add_joint(t2.Revolute(spring=elbow if sprung else None), one, other, at=at)
    hand = t2.JointSpring(
        stiffness=0.0 if seed % 5 == 0 else 10 ** random.uniform(0, 4),
        damping=10 ** random.uniform(-2, 4), maximum=weight * 10 ** random.uniform(-2, 0.7),
    )  # fmt: skip
    to, held = random.uniform(-2, 3, 2), int(random.integers(0, count))
    sim.add_joint(t2.Target(spring=hand), tuple(to.tolist()), held)

    def energy() -> float:
        speeds = (sim.velocity**2).sum(axis=1) + 1.09 / 12 * sim.angular_velocity**2
        moving = sim.mass @ (speeds / 2 + G * sim.position[:, 1])
        turned = sim.orientation
        inside = sum(huber(spring, abs(turned[b] - turned[a])) for a, b, spring in elbows)
        return float(moving + inside + huber(hand, math.hypot(*(sim.position[held] - to))))

    return sim, energy


def test_energy_never_rises_while_the_point_stands() -> None:
    for seed in range(100):
        sim, energy = random_mechanism(seed)
        start = energy()
        moved = 0.0
        for _ in range(20):
            sim.step()
            moved = max(moved, sim.mass @ (sim.velocity**2).sum(axis=1) / 2)
            assert energy() <= start + 1e-3 * moved + 1e-9 * abs(start), seed
            assert forces(sim).max() <= 1 + 1e-12, seed


def test_energy_that_steps_look_at_is_that_of_what_the_spring_gives_back() -> None:
    sim = pulled(most(1e3), (3.0, 4.0), time_step=1 / 60)
    for _ in range(60):
        away = math.hypot(*(sim.position[0] - (3.0, 4.0)))
        sim.step()
        noted = sim._engine.world.joints.numbers[0, tb.J_ENERGY]
        assert noted == pytest.approx(huber(most(1e3), away), rel=1e-9, abs=1e-12)


def test_what_lies_the_other_way_round_goes_the_other_way_round() -> None:
    paths = []
    for side in (1.0, -1.0):
        sim = plain(Scene(gravity=(0.0, -G)), time_step=1 / 60)
        for k in range(3):
            sim.add(t2.Disc(radius=0.4), mass=1.0 + k, position=(side * k, 0.0), restitution=0.0)
        for k in range(2):
            spring = t2.JointSpring(stiffness=300.0, damping=1.0, rest=0.0, maximum=4.0)
            sim.add_joint(t2.Revolute(spring=spring), k, k + 1, at=(side * (k + 0.5), 0.0))
        sim.add_joint(t2.Target(spring=most(1e3, 5.0, 30.0)), (side * 1.5, 2.0), 1)
        sim.step(20)
        paths.append(sim.position * (side, 1.0))
    assert paths[0] == pytest.approx(paths[1], abs=1e-12)


def test_order_in_which_targets_come_makes_no_difference() -> None:
    """Two at one point of one body, one of them with the numbers of the other."""
    points = [(3.0, 1.0), (-2.0, 4.0), (3.0, 1.0)]
    ends = []
    for order in ((0, 1, 2), (1, 2, 0)):
        sim = plain(Scene(gravity=(0.0, 0.0)), time_step=1 / 60)
        sim.add(t2.Disc(radius=0.5), mass=MASS, position=(0, 0), restitution=0.0)
        for k in order:
            sim.add_joint(t2.Target(spring=most(100.0, 1.0)), points[k], 0)
        sim.step(30)
        ends.append(sim.position.tobytes())
    assert ends[0] == ends[1]


def test_maximum_is_set_between_steps() -> None:
    sim = pulled(most(1e4, maximum=None), (0.0, 0.0), time_step=1 / 60)
    sim.set_target("mouse", FAR)
    sim.set_spring("mouse", most(1e4))
    sim.step(6)
    assert sim.velocity[0] == pytest.approx(MOST / MASS * 0.1 * TOWARDS, rel=1e-8)
    sim.set_spring("mouse", most(1e4, maximum=4.0))
    sim.step(6)
    assert sim.velocity[0] == pytest.approx((MOST + 4.0) / MASS * 0.1 * TOWARDS, rel=1e-8)
    sim.set_spring("mouse", None)
    before = sim.velocity.copy()
    sim.step(6)
    assert sim.velocity == pytest.approx(before, abs=1e-12)
    sim.set_spring("mouse", most(50.0, maximum=None))
    sim.step()
    assert math.hypot(*(sim.velocity[0] - before[0])) > 10.0


def test_saved_ones_go_on_as_they_did(tmp_path: Path) -> None:
    sim, _ = random_mechanism(3)
    sim.step(7)
    sim.save(tmp_path / "saved.npz")
    again = Simulator.restore(tmp_path / "saved.npz", compiled=False)
    for each in (sim, again):
        each.step(7)
    assert sim.position.tobytes() == again.position.tobytes()
    assert again.joints == sim.joints


def test_a_maximum_that_is_never_reached_changes_nothing() -> None:
    ends = []
    for maximum in (None, 1e9):
        sim = plain(Scene(gravity=(0.0, -G)), time_step=1 / 60)
        sim.add(t2.Disc(radius=0.5), mass=MASS, position=(0, 0), restitution=0.0)
        sim.add_joint(t2.Target(spring=most(400.0, 3.0, maximum)), (1.0, 1.0), 0)
        sim.step(60)
        ends.append(sim.position)
    assert ends[0] == pytest.approx(ends[1], abs=1e-12)


@pytest.mark.parametrize("maximum", [None, 100.0])
def test_net_of_rods_is_pulled_alike_by_iteration(
    maximum: float | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A mesh, which is solved by iteration, gives way to springs as one solved directly does."""
    found = []
    for few in (grouping.FEW, 0):
        monkeypatch.setattr(grouping, "FEW", few)
        monkeypatch.setattr(grouping, "LOOPED", grouping.LOOPED if few else 0)
        sim = plain(Scene(gravity=(0.0, -G)), time_step=1 / 60)
        for x, y in np.ndindex(4, 4):
            sim.add(t2.Disc(radius=0.1), mass=1.0, position=(x, y), restitution=0.0, group=-1)
        for x, y in np.ndindex(4, 4):
            for to_x, to_y in ((x + 1, y), (x, y + 1)):
                if to_x < 4 and to_y < 4:
                    sim.add_joint(t2.Distance(), 4 * x + y, 4 * to_x + to_y)
        for corner, x in ((3, 0.0), (15, 3.0)):
            sim.add_joint(t2.Target(spring=most(1e3, 10.0, maximum)), (x, 4.5), corner)
        sim.step(10)
        assert bool(sim._engine.world.joints.mechanisms[0, tb.M_MESHED]) == (few == 0)
        assert forces(sim).max() <= 1 + 1e-12
        found.append(np.hstack([sim.reactions.force[-1, 1], 100 * sim.position.ravel()]))
    assert found[1] == pytest.approx(found[0], abs=40.0)
