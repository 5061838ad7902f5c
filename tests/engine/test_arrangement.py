"""What stays from step to step is what would be found anew, bit by bit."""

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.scene import catalogue
from tamias2d.simulator import Simulator
from tamias2d.stepped.layout import ARRANGED, ISLANDED, OF_A, OF_B, PAIRS, SIDE, STILL
from tests.simulator.crowd import crowd


@pytest.mark.parametrize("name", ["arch", "card-house", "dominoes", "pyramid-30", "stack-10-heavy"])
def test_contacts_stay_arranged_as_they_would_be_anew(name: str) -> None:
    kept, anew = Simulator(catalogue.load(name)), Simulator(catalogue.load(name))
    stayed = 0
    for _ in range(90):
        stayed += int(kept._world.counts[ARRANGED])
        anew._world.counts[ARRANGED] = anew._world.counts[ISLANDED] = 0
        kept.step()
        anew.step()
    assert kept.digest() == anew.digest()
    assert stayed > 20


def listed(sim: Simulator) -> list[tuple[int, int]]:
    """The bodies of all pairs on the list."""
    world = sim._world
    seats = world.pairs[world.counts[SIDE], : world.counts[PAIRS], OF_A : OF_B + 1]
    pairs = world.owner[seats]
    return [(int(min(pair)), int(max(pair))) for pair in pairs]


@pytest.mark.parametrize("seed", range(4))
def test_who_overlaps_is_on_the_list_however_it_was_made(seed: int) -> None:
    """Discs poured onto each other: some leave their rooms long before others."""
    chance = np.random.default_rng(seed)
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), restitution=0.3, friction=0.4)
    radii = chance.uniform(0.1, 0.5, 150)
    for k, radius in enumerate(radii):
        scene.add_body(
            t2.Disc(radius=radius),
            mass=radius,
            position=(1.1 * (k % 12), 0.6 + 1.1 * (k // 12)),
            velocity=chance.normal(0.0, 3.0, 2),
            restitution=0.3,
            friction=0.4,
        )
    sim = Simulator(scene)
    lists = set()
    for _ in range(120):
        before = sim._world.counts[PAIRS]
        sim.step()
        pairs = listed(sim)
        lists.add((int(before), len(pairs)))
        assert len(set(pairs)) == len(pairs)
        centres = sim.position[1:]
        apart = np.linalg.norm(centres[:, None] - centres, axis=2)
        near = np.argwhere(np.triu(apart < radii[:, None] + radii, 1))
        assert {(int(i) + 1, int(j) + 1) for i, j in near} <= set(pairs)
    assert len(lists) > 30  # it was made, and mended, often


@pytest.mark.parametrize("seed", range(3))
def test_a_mended_list_leads_where_a_new_one_does(seed: int) -> None:
    """Only the order of contacts may differ, and with it what rounding and visits make of them."""
    mended, anew = Simulator(crowd(20, seed=seed)), Simulator(crowd(20, seed=seed))
    for _ in range(15):
        anew._world.counts[STILL] = 0
        mended.step()
        anew.step()
        assert np.abs(mended.position - anew.position).max() < 1e-2
