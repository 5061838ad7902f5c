"""Slabs that are solved in turns: what each may touch, and that turns change nothing."""

from collections.abc import Callable
from inspect import signature
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.simulator import Simulator
from tamias2d.stepped import slabs, substeps
from tamias2d.stepped.layout import (
    ACTIVE,
    ACTIVE_ROW,
    BLOCKS,
    BOUNCING,
    DYNAMIC,
    HIT_A,
    HIT_B,
    HIT_PLACE,
    HITS,
    SLABS,
    SUBSTEPS,
    THIN,
)
from tamias2d.stepped.menu import CONTACT
from tamias2d.stepped.rows import BODY_A, BODY_B, LANES, S_BLOCK, S_BODY, S_HIT, S_ISLE
from tamias2d.stepped.thin import SLAB


def heap(*, upright: bool, bounces: bool = False) -> t2.Scene:
    """Discs in rows that press on each other, and apart from them towers of boxes.

    One may bounce: it is far from where the first slab is.
    """
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=0.5)
    columns, rows = (3, 14) if upright else (24, 3)
    for k in range(columns * rows):
        place = (0.97 * (k % columns), 0.49 + 0.97 * (k // columns))
        scene.add_body(t2.Disc(radius=0.5), mass=1.0 + k % 3, position=place, friction=0.5,
                       restitution=0.0)  # fmt: skip
    for k in range(9):
        place = (-3.0 - 2.0 * (k % 3), 0.5 + 0.999 * (k // 3))
        scene.add_body(t2.Box(width=1.0, height=1.0), mass=2.0, position=place, friction=0.5,
                       restitution=0.0)  # fmt: skip
    if bounces:
        scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(0.97 * columns + 0.5, 0.5),
                       velocity=(0.0, -3.0), friction=0.5, restitution=0.8)  # fmt: skip
    return scene


def plain(scene: t2.Scene) -> Simulator:
    sim = Simulator(scene)
    sim._world._engine = CONTACT.plain()
    return sim


@pytest.fixture(autouse=True)
def _small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where slabs are small, a scene needs not be large; engines as plain Python see that."""
    monkeypatch.setattr(slabs, "CONTACTS_IN_SLAB", 2)


@pytest.mark.parametrize("upright", [False, True])
def test_contacts_are_within_a_slab_or_with_the_next_one(*, upright: bool) -> None:
    sim = plain(heap(upright=upright))
    sim.step()
    world = sim._world
    count, number = int(world.counts[HITS]), int(world.counts[SLABS])
    table = world.slabs[: number + 1]
    assert number > 3
    assert (np.diff(table, axis=0) >= 0).all()
    assert table[0].tolist() == [0, 0, 0, 0]
    total = world.counts[[HITS, BLOCKS, ACTIVE, THIN]]
    assert table[-1][[S_HIT, S_BLOCK, S_BODY, S_ISLE]].tolist() == total.tolist()
    seats = set()
    for k in range(count):
        block, lane = divmod(int(world.hits[HIT_PLACE, k]), LANES)
        seats.add((block, lane))
        bodies = [int(world.hits[row, k]) for row in (HIT_A, HIT_B)]
        assert world.lanes[block, [BODY_A + lane, BODY_B + lane]].tolist() == bodies
        own = sorted(world.isle[i, SLAB] for i in bodies if world.seated_kind[i] == DYNAMIC)
        q = int(np.searchsorted(table[:, S_BLOCK], block, side="right")) - 1
        assert own[0] == q
        assert own[-1] <= q + 1
    assert len(seats) == count
    active = world.hits[ACTIVE_ROW, : world.counts[ACTIVE]].astype(np.int64)
    assert sorted(set(active.tolist())) == sorted(active.tolist())
    for q in range(number):
        assert (world.isle[active[table[q, S_BODY] : table[q + 1, S_BODY]], SLAB] == q).all()


def all_at_once(take: Callable[..., None]) -> Callable[..., None]:
    """Return what takes all bodies, and then all contacts, through a stage as one slab."""

    def go(stage: int, slab: int, *rest: Any) -> None:
        if slab > 0:
            return
        arguments = dict(zip(list(signature(take).parameters)[2:], rest, strict=True))
        counts, table = arguments["counts"].copy(), np.zeros_like(arguments["slabs"])
        table[1] = arguments["slabs"][counts[SLABS]]
        counts[SLABS] = 1
        take(stage, 0, **{**arguments, "counts": counts, "slabs": table})
        arguments["counts"][BOUNCING] = counts[BOUNCING]

    return go


@pytest.mark.parametrize(("upright", "bounces"), [(False, False), (True, False), (False, True)])
def test_turns_give_the_bits_of_one_stage_after_the_other(
    monkeypatch: pytest.MonkeyPatch, *, upright: bool, bounces: bool
) -> None:
    """Contacts of one slab change what those of the next one find, so the order is not free.

    That something bounces is found when the first slabs are done.
    """
    turns, stages = (plain(heap(upright=upright, bounces=bounces)) for _ in range(2))
    late = 0
    for _ in range(12):
        turns.step()
        late += turns._world.counts[BOUNCING]
    monkeypatch.setattr(substeps, "take_stage", all_at_once(substeps.take_stage))
    for _ in range(12):
        stages.step()
    assert turns._world.counts[SLABS] > (2 * turns._world.counts[SUBSTEPS] if bounces else 3)
    assert (late > 0) == bounces
    assert turns._world.pose.tobytes() == stages._world.pose.tobytes()
    assert turns._world.touches.tobytes() == stages._world.touches.tobytes()


def test_where_something_moves_by_itself_there_is_one_slab() -> None:
    scene = heap(upright=False)
    scene.add_kinematic(
        t2.Box(width=1.0, height=1.0), position=(24 * 0.97, 0.5), velocity=(-0.1, 0.0),
        friction=0.5, restitution=0.0,
    )  # fmt: skip
    sim = plain(scene)
    sim.step()
    assert sim._world.counts[SLABS] == 1
