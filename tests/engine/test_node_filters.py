"""Shapes that filters keep apart are not looked at as pairs, and all others are."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import tamias2d as t2
from tamias2d.engine.broad_phase import candidates
from tamias2d.engine.broad_phase.node_filters import note_node_filters
from tamias2d.engine.tables import BUFFER, CONTACTS, LEAVES, SLOT_A, SLOT_B
from tamias2d.simulator import Simulator

SURFACE = {"mass": 1.0, "friction": 0.0, "restitution": 0.0}


def crowd(seed: int, filters: list[dict[str, int]], *, count: int = 60) -> Simulator:
    """Discs that overlap, each with one of some filters; in plain Python."""
    random = np.random.default_rng(seed)
    sim = Simulator(t2.Scene(gravity=(0.0, 0.0)), compiled=False)
    for _ in range(count):
        given_: dict[str, Any] = dict(filters[random.integers(len(filters))])
        sim.add(t2.Disc(radius=0.5), position=random.uniform(0, 6, 2), **SURFACE, **given_)
    return sim


def listed(sim: Simulator) -> list[tuple[int, ...]]:
    """The bodies of all contacts on the list after a step."""
    sim.step()
    world = sim._engine.world
    counts = world.broad_phase.counts
    slots = world.buffers.pairs[counts[BUFFER], : counts[CONTACTS], SLOT_A : SLOT_B + 1]
    return [tuple(pair) for pair in world.state.body_of_slot[slots].tolist()]


bits = st.sampled_from([0, 1, 2, 3, 4, 7])
one_filter = st.fixed_dictionaries(
    {"category": bits, "mask": bits, "group": st.sampled_from([-2, -1, 0, 1])}
)


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 2**32 - 1), st.lists(one_filter, min_size=1, max_size=3))
def test_no_pair_that_may_collide_is_left_out(seed: int, filters: list[dict[str, int]]) -> None:
    """The list is the one that is made where no node is passed over."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(candidates, "note_node_filters", lambda *_: False)
        wanted = listed(crowd(seed, filters))
    assert listed(crowd(seed, filters)) == wanted


def pairs_looked_at(sim: Simulator) -> int:
    sim.step()
    world = sim._engine.world
    leaves = int(world.tree.counts[LEAVES])
    filtered = note_node_filters(leaves, world.shapes.filters, world.tree)
    return candidates.find_leaf_pairs(
        leaves, filtered, world.tree, np.zeros((10_000, 2), dtype=np.uint32)
    )


def test_a_negative_group_is_not_looked_at() -> None:
    assert pairs_looked_at(crowd(1, [{"group": -1}])) == 0
    assert pairs_looked_at(crowd(1, [{"category": 2, "mask": 1}])) == 0
    assert pairs_looked_at(crowd(1, [{"group": 1}])) > 60
    assert pairs_looked_at(crowd(1, [{}])) > 60
