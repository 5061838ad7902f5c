"""Slabs that are solved in turns: what each may touch, and that turns change no bit."""

from collections.abc import Callable

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine import substeps, tables as tb
from tamias2d.engine.solver import slabs
from tamias2d.engine.tables import Contacts, World
from tamias2d.kernels.lanes import LANES
from tests.engine.scenes import heap, plain

Stage = Callable[[int, int, float, World, Contacts], None]


@pytest.fixture(autouse=True)
def _small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where slabs are small, a scene needs not be large; engines as plain Python see that."""
    monkeypatch.setattr(slabs, "CONTACTS_IN_SLAB", 2)
    monkeypatch.setattr(slabs, "FEWEST_CONTACTS", 4)


@pytest.mark.parametrize("upright", [False, True])
def test_contacts_are_within_a_slab_or_with_the_next_one(*, upright: bool) -> None:
    sim = plain(heap(upright=upright))
    sim.step()
    world = sim._engine.world
    touching, constraints = world.touching, world.constraints
    count, number = int(touching.counts[tb.TOUCHING]), int(constraints.counts[tb.SLABS])
    table = constraints.slabs[: number + 1]
    assert number > 3
    assert (np.diff(table, axis=0) >= 0).all()
    assert table[0].tolist() == [0, 0, 0, 0]
    total = [*constraints.counts[[tb.BLOCKS, tb.ACTIVE]], world.direct.counts[tb.TREES]]
    assert table[-1][[tb.S_CONTACT, tb.S_BLOCK, tb.S_BODY, tb.S_TREE]].tolist() == [count, *total]
    lanes = set()
    for k in range(count):
        block, lane = divmod(int(touching.lane[k]), LANES)
        lanes.add((block, lane))
        bodies = [int(touching.body_a[k]), int(touching.body_b[k])]
        assert constraints.lanes[block, [tb.BODY_A + lane, tb.BODY_B + lane]].tolist() == bodies
        own = sorted(
            constraints.slab_of_body[i] for i in bodies if world.bodies.kind[i] == tb.DYNAMIC
        )
        q = int(np.searchsorted(table[:, tb.S_BLOCK], block, side="right")) - 1
        assert own[0] == q
        assert own[-1] <= q + 1
    assert len(lanes) == count
    active = touching.active_by_slab[: constraints.counts[tb.ACTIVE]].astype(np.int64)
    assert sorted(set(active.tolist())) == sorted(active.tolist())
    for q in range(number):
        own = active[table[q, tb.S_BODY] : table[q + 1, tb.S_BODY]]
        assert (constraints.slab_of_body[own] == q).all()


def all_at_once(take_stage: Stage) -> Stage:
    """Return a stage that takes all bodies, and then all contacts, as one slab."""

    def take_all(stage: int, slab: int, substep: float, world: World, contacts: Contacts) -> None:
        if slab > 0:
            return
        constraints = world.constraints
        counts, table = constraints.counts.copy(), np.zeros_like(constraints.slabs)
        table[1] = constraints.slabs[counts[tb.SLABS]]
        counts[tb.SLABS] = 1
        one = constraints._replace(counts=counts, slabs=table)
        take_stage(stage, 0, substep, world._replace(constraints=one), contacts)
        constraints.counts[tb.BOUNCING] = counts[tb.BOUNCING]

    return take_all


@pytest.mark.parametrize(("upright", "bounces"), [(False, False), (True, False), (False, True)])
def test_turns_give_the_bits_of_one_stage_after_the_other(
    monkeypatch: pytest.MonkeyPatch, *, upright: bool, bounces: bool
) -> None:
    """Contacts of one slab change what those of the next one find, so the order is not free.

    That something bounces is found when the first slabs are done.
    """
    turns, stages = (plain(heap(upright=upright, bounces=bounces)) for _ in range(2))
    bounced = 0
    for _ in range(12):
        turns.step()
        bounced += turns._engine.world.constraints.counts[tb.BOUNCING]
    monkeypatch.setattr(substeps, "take_stage", all_at_once(substeps.take_stage))
    for _ in range(12):
        stages.step()
    one, other = turns._engine.world, stages._engine.world
    least = 2 * one.control.counts[tb.SUBSTEPS] if bounces else 3
    assert one.constraints.counts[tb.SLABS] > least
    assert (bounced > 0) == bounces
    assert one.state.pose.tobytes() == other.state.pose.tobytes()
    assert one.buffers.manifolds.tobytes() == other.buffers.manifolds.tobytes()


def test_where_a_body_moves_that_cannot_be_pushed_there_is_one_slab() -> None:
    scene = heap(upright=False)
    scene.add_kinematic(
        t2.Box(width=1.0, height=1.0), position=(24 * 0.97, 0.5), velocity=(-0.1, 0.0),
        friction=0.5, restitution=0.0,
    )  # fmt: skip
    sim = plain(scene)
    sim.step()
    assert sim._engine.world.constraints.counts[tb.SLABS] == 1
