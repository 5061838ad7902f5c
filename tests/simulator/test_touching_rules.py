"""Filters and surfaces that change between steps (R3).

Expected values come from free falls, from Coulomb's law, from `may_touch`, and from what is the
same with the values that hold from the start.
"""

import copy
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine import tables as tb
from tamias2d.scene.filters import may_touch

G = 10.0
ALL = 2**63 - 1
SURFACE: Any = {"friction": 0.5, "restitution": 0.0}
BOX = t2.Box(width=1.0, height=1.0)


def stack(count: int = 3, *, floor: Any = None, boxes: Any = None, **settings: Any) -> t2.Simulator:
    """Return boxes on each other on a floor, with words of their own for either."""
    scene = t2.Scene(gravity=(0.0, -G))
    plane = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(plane, name="floor", **{**SURFACE, **(floor or {})})
    for k in range(count):
        own = {**SURFACE, **(boxes or {})}
        scene.add_body(BOX, mass=1.0, position=(0.0, 0.5 + k), name=f"box{k}", **own)
    return t2.Simulator(scene, **settings)


def test_what_may_touch_no_longer_falls_through_from_the_next_step_on() -> None:
    """The boxes press on each other a little as they fall, which leaves their mean alone."""
    sim = stack()
    sim.step(30)
    assert len(sim.contacts) == 6
    sim.set_filters("floor", mask=0)
    assert len(sim.contacts) == 6  # of the last step
    for k in range(1, 10):
        sim.step()
        assert sim.velocity[1:, 1].mean() == pytest.approx(-G * k / 60, abs=1e-9)
        assert not (sim.contacts.bodies == 0).any()
        assert [pair for pair in map(sorted, sim.ended.tolist()) if 0 in pair] == (
            [[0, 1]] if k == 1 else []
        )


def counted(sim: t2.Simulator, pair: set[int], before: int) -> int:
    """Return by what a step tells whether a pair touches: 1 or 0, from what it was before."""
    sim.step()
    began = sum(set(each) == pair for each in sim.began.bodies.tolist())
    return before + began - sum(set(each) == pair for each in sim.ended.tolist())


def test_what_began_ends_once_also_where_a_joint_or_filters_keep_it_apart() -> None:
    sim = stack(2)
    told = 0
    for held in (False, True, False):
        if held:
            sim.add_joint(t2.Weld(), 1, 2, at=(0.0, 1.0), name="grip")
        elif sim.joints:
            sim.remove_joint("grip")
        for _ in range(3):
            told = counted(sim, {1, 2}, told)
        assert told == (0 if held else 1)
    sim.set_filters(2, mask=0)
    near = sim.in_box((-1.0, 0.0), (1.0, 3.0))  # which lets the contact leave between two steps
    assert near.tolist() == [0, 1, 2]
    kept, other = sim.copy_state(), copy.copy(sim)
    assert counted(sim, {1, 2}, 1) == counted(other, {1, 2}, 1) == 0
    sim.restore_state(kept)
    assert counted(sim, {1, 2}, 1) == 0
    sim.restore_state(kept)
    sim.remove(2)
    sim.step()
    assert sim.ended.tolist() == []


def test_filters_that_are_put_back_before_a_step_end_nothing() -> None:
    sim = stack(2)
    sim.step(5)
    sim.set_filters(2, mask=0)
    sim.set_filters(2, mask=ALL)
    sim.step(3)
    assert (len(sim.began), len(sim.ended)) == (0, 0)
    sim.set_filters(2, mask=0)
    sim.step(3)
    assert [sorted(pair) for pair in sim.ended.tolist()] == [[1, 2]]


def test_what_may_touch_from_now_on_meets() -> None:
    """Equal discs exchange their velocities; before that nothing has touched anything."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    disc = t2.Disc(radius=0.5)
    for x, speed in ((-3.0, 1.0), (3.0, -2.0)):
        place: Any = {"position": (x, 0.0), "velocity": (speed, 0.0)}
        sim.add(disc, mass=1.0, friction=0.0, restitution=1.0, mask=0, **place)
    sim.step(60)
    sim.set_filters([0, 1], mask=ALL)
    sim.step(60)
    assert sim.velocity == pytest.approx(np.array([(-2.0, 0.0), (1.0, 0.0)]), abs=1e-12)
    sim.position = (-3.0, 0.0), (3.0, 0.0)
    sim.velocity = (1.0, 0.0), (-2.0, 0.0)
    sim.set_filters([0, 1], category=[2, 4], mask=[2, 4])
    sim.step(120)
    assert sim.velocity.tolist() == [[1.0, 0.0], [-2.0, 0.0]]


@pytest.mark.parametrize("seed", range(4))
def test_who_touches_is_told_by_categories_masks_and_groups(seed: int) -> None:
    """Sensors in one heap, changed a few at a time: those that overlap are those that may."""
    chance = np.random.default_rng(seed)
    count = 9 if seed % 2 else 6  # of few, all pairs are listed
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    heap: Any = chance.uniform(-0.05, 0.05, (count, 2))
    sim.add(t2.Disc(radius=0.5), mass=1.0, position=heap, sensor=True)
    numbers = np.tile((1, ALL, 0), (count, 1))
    for _ in range(12):
        some = chance.choice(count, chance.integers(1, 4), replace=False)
        numbers[some, :2] = chance.integers(0, 8, (len(some), 2))
        numbers[some, 2] = chance.integers(-2, 3, len(some))
        category, mask, group = numbers[some].T
        sim.set_filters(some, category=category, mask=mask, group=group)
        sim.step()
        filters = [t2.Body(name="", **_filters(row)) for row in numbers.tolist()]
        pairs = combinations(range(count), 2)
        wanted = {(i, j) for i, j in pairs if may_touch(filters[i], filters[j])}
        assert touching(sim) == wanted


def touching(sim: t2.Simulator) -> set[tuple[int, ...]]:
    """Return the pairs of bodies that touch, though nothing pushes them."""
    world = sim._engine.world
    side, size = world.broad_phase.counts[[tb.BUFFER, tb.CONTACTS]]
    now = world.buffers.flags[side, :size, tb.TOUCHES] & tb.IS_TOUCHING != 0
    slots = world.buffers.pairs[side, :size, tb.SLOT_A : tb.SLOT_B + 1][now]
    return {tuple(sorted(pair)) for pair in world.state.body_of_slot[slots].tolist()}


def _filters(row: list[int]) -> dict[str, Any]:
    named = dict(zip(("category", "mask", "group"), row, strict=True))
    return {"shape": None, "dynamic": True, "mass": 1.0, **named}


def test_what_is_set_before_the_first_step_is_that_of_the_scene() -> None:
    sim = stack()
    sim.set_filters([1, 2, 3], category=2, group=[0, 5, 5])
    sim.set_surface([1, 2, 3], friction=0.3, restitution=0.4)
    meant = stack(boxes={"category": 2, "friction": 0.3, "restitution": 0.4})
    meant.set_filters([2, 3], group=5)
    for one in (sim, meant):
        one.step(30)
    assert sim.digest() == meant.digest()


def test_what_overlaps_and_may_touch_now_is_as_what_was_moved_there() -> None:
    """It is pushed apart, and keeps no speed of that."""
    moved, let = (t2.Simulator(t2.Scene(gravity=(0.0, 0.0))) for _ in range(2))
    for sim, place, mask in ((moved, (0.0, 9.0), ALL), (let, (0.3, 0.7), 0)):
        sim.add_static(BOX, **SURFACE)
        sim.add(BOX, mass=1.0, position=place, mask=mask, **SURFACE)
        sim.step()
    moved.position[1] = 0.3, 0.7
    let.set_filters(1, mask=ALL)
    for sim in (moved, let):
        sim.step(60)
    assert let.position.tolist() == moved.position.tolist()
    assert let.position[1] == pytest.approx(np.array((0.3, 1.0)), abs=2e-3)
    assert np.abs(let.velocity).max() < 1e-3


@pytest.mark.parametrize("change", [{"bodies": 0, "mask": 0}, {"bodies": 1, "mask": 0}], ids=str)
def test_what_sleeps_wakes_where_filters_change(change: dict[str, Any]) -> None:
    sim = stack(sleeping=True)
    sim.step(120)
    assert sim.asleep[1:].all()
    sim.set_filters(bodies=change["bodies"], mask=ALL)
    assert sim.asleep[1:].all()  # nothing changed
    sim.set_filters(**change)
    sim.step(2)
    assert not sim.asleep[1:].any()
    assert sim.velocity[1, 1] == pytest.approx(-G / 30)


def test_what_sleeps_wakes_where_something_that_stands_may_touch_it_now() -> None:
    sim = stack(1, sleeping=True)
    sim.add_static(t2.Disc(radius=0.2), position=(0.5, 0.5), mask=0, **SURFACE)
    sim.step(120)
    assert sim.asleep[1]
    sim.set_filters(2, mask=ALL)
    sim.step(60)
    assert sim.position[1, 0] < -0.199  # it is pushed off


@pytest.mark.parametrize("which", [0, 1])
def test_a_surface_rubs_as_it_is_told(which: int) -> None:
    """On 3 m/s^2 of gravity aside, friction mu leaves 3 - mu g; the root of a product mixes."""
    sim = stack(1)
    sim.gravity = 3.0, -G
    sim.step(60)
    assert abs(sim.velocity[1, 0]) < 1e-3
    at = sim.velocity[1, 0]
    for friction in (0.0, 0.02, 0.08):
        sim.set_surface(which, friction=friction)
        sim.step(30)
        rate = 3.0 - (0.5 * friction) ** 0.5 * G
        at += rate * 0.5
        assert sim.velocity[1, 0] == pytest.approx(at, abs=2e-3)


def test_a_surface_bounces_as_it_is_told() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    plane = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    sim.add_static(plane, friction=0.0)
    disc = t2.Disc(radius=0.5)
    sim.add(disc, mass=1.0, position=(0.0, 2.0), friction=0.0, restitution=0.0)
    for restitution in (0.0, 0.5, 1.0):
        sim.set_surface(1, restitution=restitution)
        sim.position[1], sim.velocity[1] = (0.0, 2.0), (0.0, -3.0)
        sim.step(60)
        assert sim.velocity[1, 1] == pytest.approx(3.0 * restitution, abs=1e-9)


def test_what_is_set_for_a_pair_stays() -> None:
    scene = t2.Scene(gravity=(0.0, -G))
    plane = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(plane, name="ice", **SURFACE)
    scene.add_body(BOX, mass=1.0, position=(0.0, 0.5), name="puck", **SURFACE)
    scene.set_friction("ice", "puck", 0.0)
    sim = t2.Simulator(scene)
    sim.set_surface([0, 1], friction=0.9)
    sim.velocity[1, 0] = 2.0
    sim.step(60)
    assert sim.velocity[1, 0] == pytest.approx(2.0, abs=1e-9)


@pytest.mark.parametrize("which", ["floor", "box0"])
def test_what_sleeps_on_a_surface_that_changes_wakes(which: str) -> None:
    sim = stack(1, sleeping=True)
    sim.gravity = 3.0, -G
    sim.step(120)
    assert sim.asleep[1]
    sim.set_surface(which, friction=0.5)  # as it is
    sim.step()
    assert sim.asleep[1]
    sim.set_surface(which, friction=0.0)
    sim.step(30)
    assert not sim.asleep[1]
    assert sim.velocity[1, 0] == pytest.approx(1.5, abs=1e-6)


@pytest.mark.parametrize("asleep", [False, True])
@pytest.mark.parametrize("pending", [False, True])
def test_saved_after_a_change_it_goes_on_with_the_same_bits(
    asleep: bool, pending: bool, tmp_path: Path
) -> None:
    sim = stack(sleeping=asleep, compiled=False)
    sim.step(45 if asleep else 8)
    sim.set_filters("box2", mask=0)
    sim.set_surface(["box0", "box1"], friction=[0.1, 0.9], restitution=0.3)
    if not pending:
        sim.step(2)
    sim.save(tmp_path / "changed.npz")
    others = [
        copy.copy(sim),
        t2.Simulator.restore(tmp_path / "changed.npz"),
        t2.Simulator.restore(tmp_path / "changed.npz", compiled=False),
    ]
    told = [one.contacts.bodies.tolist() for one in (sim, *others)]
    assert told == told[:1] * 4
    for one in (sim, *others):
        one.step(6)
    assert len({one.digest() for one in (sim, *others)}) == 1


def test_bodies_that_can_meet_now_need_a_restitution() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(BOX, position=(0.0, -9.0), name="wall")
    for k, name in enumerate(("one", "two", "three")):
        scene.add_body(BOX, mass=1.0, position=(3.0 * k, 0.0), mask=0, name=name)
    scene.set_restitution("wall", "one", 0.5)
    scene.add_joint(t2.Revolute(), "one", "two", anchor=(1.5, 0.0), other_anchor=(-1.5, 0.0))
    sim = t2.Simulator(scene)
    before = sim.digest()
    with pytest.raises(t2.SceneError, match=r"pair body 'wall' and body 'two': not stated"):
        sim.set_filters(["one", "two"], mask=ALL)
    sim.set_filters(["one", "two"], category=2, mask=2)  # a joint keeps them apart
    sim.set_filters("one", category=1, mask=1)  # stated for the pair
    with pytest.raises(t2.SceneError, match=r"pair body 'wall' and body 'three': not stated"):
        sim.set_filters("three", mask=1)
    sim.set_surface("three", restitution=0.5)
    sim.set_filters("three", mask=1)
    assert sim.digest() == before


WRONG: list[tuple[str, dict[str, Any], str]] = [
    ("set_filters", {}, r"the bodies: found nothing to change .*Give category, mask or group\."),
    (
        "set_surface",
        {},
        r"the bodies: found nothing to change .*Give friction, restitution or surface_speed\.",
    ),
    ("set_filters", {"category": -1}, "category -1 of the bodies: must be from 0"),
    ("set_filters", {"mask": 0.5}, "mask of the bodies: found 0.5: must be a whole number"),
    ("set_filters", {"group": [1, 2, 3]}, r"group of the bodies: found an array of shape \(3,\)"),
    ("set_filters", {"group": 2**63}, r"group 9223372036854775808 of the bodies: must be from"),
    ("set_surface", {"friction": -0.1}, r"friction\[0\] -0.1 of the bodies: must be"),
    ("set_surface", {"friction": [0.1, np.nan]}, r"friction\[1\] of the bodies: found nan"),
    ("set_surface", {"restitution": 1.5}, r"restitution\[0\] 1.5 of the bodies: must be"),
    ("set_surface", {"restitution": "much"}, "restitution of the bodies: found 'much'"),
]


@pytest.mark.parametrize(("call", "words", "says"), WRONG, ids=str)
def test_what_cannot_be_set_is_refused_by_name(call: str, words: Any, says: str) -> None:
    sim = stack()
    sim.step(3)
    before = sim._arrays()
    with pytest.raises(t2.InputError, match=says):
        getattr(sim, call)([1, 2], **words)
    with pytest.raises(t2.InputError, match="body 9: the simulator has none such"):
        getattr(sim, call)([1, 9], **words)
    after = sim._arrays()
    assert before.keys() == after.keys()
    assert all(np.array_equal(before[name], after[name]) for name in before)
