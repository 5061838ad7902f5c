"""`began` and `ended` tell all steps of a call, whatever the number of steps that it takes."""

import copy
import warnings
from collections import Counter
from collections.abc import Callable

import numpy as np
import pytest

import tamias2d as t2
from tests.simulator.crowd import crowd

FLOOR = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)


def coins() -> tuple[t2.Simulator, int]:
    """A hero that flies through forty coins, at 15 s."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    hero = sim.add(
        t2.Disc(radius=0.3), mass=1.0, position=(0.0, 0.0), velocity=(3.0, 0.0), restitution=0.0
    )
    place = np.column_stack((1.0 + 1.03 * np.arange(40), np.zeros(40)))
    sim.add_static(t2.Disc(radius=0.2), position=place, sensor=True)
    return sim, hero


@pytest.mark.parametrize("pictures", [20, 30, 60, 144, 240])
def test_a_loop_counts_each_coin_once_at_any_rate_of_pictures(pictures: int) -> None:
    sim, hero = coins()
    left, picked = 0.0, 0
    for _ in range(15 * pictures):
        left += 1.0 / pictures
        count = int(left / sim.time_step)
        sim.step(count)
        left -= count * sim.time_step
        picked += sum(hero in pair for pair in sim.began.bodies)
    assert picked == 40


def discs(bodies: int, gravity: float) -> t2.Simulator:
    """Few discs between walls, whose steps go from impact to impact."""
    hard = {"friction": 0.3, "restitution": 0.9}
    sim = t2.Simulator(t2.Scene(gravity=(0.0, gravity)))
    for normal in ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)):
        sim.add_static(t2.HalfPlane(normal=normal, offset=-2.0), **hard)
    speeds = np.random.default_rng(5).normal(size=(bodies, 2)) * 3.0
    place = [(-1.5 + 0.7 * (k % 5), -1.5 + 0.7 * (k // 5)) for k in range(bodies)]
    sim.add(t2.Disc(radius=0.15), mass=1.0, position=place, velocity=speeds, **hard)
    return sim


def boxes(*, sleeping: bool = False, push: bool = False) -> t2.Simulator:
    """Boxes that bounce on a floor; a law may push them, too."""
    live = {"friction": 0.5, "restitution": 0.6}
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(FLOOR, **live)
    for k in range(4):
        law = {"force": ("3[N]*sin(5[rad/s]*time)", 0.0)} if push and k == 0 else {}
        scene.add_body(
            t2.Box(width=0.3, height=0.3),
            mass=1.0,
            position=(0.4 * k, 1.0 + 0.1 * k),
            **live,
            **law,
        )
    return t2.Simulator(scene, sleeping=sleeping)


def one_that_breaks() -> t2.Simulator:
    """A crate on a rope that tears, above a floor."""
    live = {"friction": 0.5, "restitution": 0.4}
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(FLOOR, **live)
    scene.add_body(t2.Disc(radius=0.2), mass=1.0, position=(0.0, 2.0), name="crate", **live)
    rope = t2.Distance(limits=t2.Limits(upper=0.5, restitution=0.0))
    scene.add_joint(rope, (0.1, 2.2), "crate", break_force=20.0)
    return t2.Simulator(scene)


def on_a_chain() -> t2.Simulator:
    """Discs that roll over the pieces of a chain: it is one body."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)))
    ground = [(x, 0.1 * np.sin(2 * x)) for x in np.linspace(12.0, -2.0, 60)]
    sim.add_static(t2.Chain(vertices=ground), friction=0.3, restitution=0.3)
    place = [(1.5 * k, 0.6) for k in range(3)]
    sim.add(
        t2.Disc(radius=0.2), mass=1.0, position=place, velocity=(3.0, 0.0), friction=0.3,
        restitution=0.3,
    )  # fmt: skip
    return sim


SCENES: dict[str, Callable[[], t2.Simulator]] = {
    "coins": lambda: coins()[0],
    "two discs": lambda: discs(2, -10.0),
    "ten discs": lambda: discs(10, 0.0),
    "crowd of discs": lambda: discs(25, -10.0),
    "boxes": boxes,
    "boxes that fall asleep": lambda: boxes(sleeping=True),
    "boxes that a law pushes": lambda: boxes(push=True),
    "rope that breaks": one_that_breaks,
    "chain": on_a_chain,
    "crowd": lambda: t2.Simulator(crowd(40, seed=3)),
}


def told(sim: t2.Simulator) -> tuple[np.ndarray, np.ndarray]:
    began = sim.began
    rows = (began.bodies, began.point, began.normal, began.impulse, began.separation)
    return np.column_stack(rows), np.array(sim.ended)


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("together", [2, 7, 100])
def test_a_call_tells_what_its_steps_tell_one_by_one(name: str, together: int) -> None:
    one, many = SCENES[name](), SCENES[name]()
    events = 0
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", t2.StepWarning)
        for _ in range(300 // together):
            single = []
            for _ in range(together):
                one.step()
                single.append(told(one))
            many.step(together)
            for column, found in enumerate(told(many)):
                wanted = np.concatenate([each[column] for each in single])
                np.testing.assert_array_equal(found, wanted)
                events += len(found)
            assert one.digest() == many.digest()
    assert events > 0


def test_a_call_of_no_steps_has_no_events_and_the_contacts_of_the_last_step() -> None:
    sim = boxes()
    while not len(sim.began):
        sim.step()
    points = sim.contacts.point.tolist()
    sim.step(0)
    assert (len(sim.began), len(sim.ended)) == (0, 0)
    assert sim.contacts.point.tolist() == points != []


def test_a_step_that_is_refused_has_no_events() -> None:
    sim = boxes()
    while not len(sim.began):
        sim.step()
    sim.velocity[1, 0] = np.nan
    with pytest.raises(t2.InputError):
        sim.step(3)
    assert (len(sim.began), len(sim.ended)) == (0, 0)


def test_what_begins_and_ends_in_a_call_is_told_in_both_and_counts_tell_what_touches() -> None:
    one, many = discs(2, -10.0), discs(2, -10.0)
    touching: Counter[tuple[int, ...]] = Counter()
    for _ in range(40):
        many.step(9)
        both = [tuple(sorted(pair)) for pair in many.began.bodies.tolist()]
        gone = [tuple(sorted(pair)) for pair in many.ended.tolist()]
        touching.update(both)
        touching.subtract(gone)
        one.step(9)
        now = {tuple(sorted(pair)) for pair in one.contacts.bodies.tolist()}
        assert {pair for pair, count in touching.items() if count} == now
        assert set(touching.values()) <= {0, 1}


def test_events_of_a_call_are_saved_and_copied() -> None:
    sim = discs(10, 0.0)
    sim.step(50)
    other = copy.deepcopy(sim)
    for mine, same in zip(told(sim), told(other), strict=True):
        assert len(mine)
        np.testing.assert_array_equal(mine, same)
    sim.step(20)
    other.step(20)
    for mine, same in zip(told(sim), told(other), strict=True):
        np.testing.assert_array_equal(mine, same)


def test_many_worlds_tell_the_events_of_all_steps_of_a_call() -> None:
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(FLOOR, friction=0.0, restitution=0.8)
    scene.add_body(
        t2.Disc(radius=0.2), mass=1.0, position=(0.0, 0.4), friction=0.0, restitution=0.8, name="b"
    )
    high = {"bodies.b.position.y": [0.3, 0.5]}
    sims, steps = t2.Simulators(scene, vary=high), t2.Simulators(scene, vary=high)
    sims.step(60)
    wanted: Counter[int] = Counter()
    for _ in range(60):
        steps.step()
        wanted.update(steps.began.world.tolist())
    assert Counter(sims.began.world.tolist()) == wanted
    assert min(wanted.values()) > 1
    sims.step(0)
    assert (len(sims.began), len(sims.ended)) == (0, 0)
