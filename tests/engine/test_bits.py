"""The engine as plain Python and compiled: whole runs with the same bits."""

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine.arrays.world import named_arrays
from tamias2d.simulator import Simulator
from tests.engine.scenes import mixed, plain


@pytest.mark.parametrize("seed", range(3))
def test_plain_and_compiled_runs_have_the_same_bits(seed: int) -> None:
    scene = mixed(seed, bodies=8)
    compiled, slow = Simulator(scene), plain(scene)
    most = 0
    with np.errstate(all="ignore"):  # plain arithmetic warns where compiled code does not
        for step in range(50):
            compiled.step()
            slow.step()
            first, second = (named_arrays(sim._engine.world) for sim in (compiled, slow))
            assert list(first) == list(second)
            for name in first:
                assert first[name].tobytes() == second[name].tobytes(), (step, name)
            most = max(most, len(compiled.contacts))
    assert most >= 5  # the run was about contacts


def test_plain_runs_of_more_bodies_than_a_byte_counts_find_all_contacts() -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    for k in range(140):
        scene.add_static(t2.Box(width=1.0, height=1.0), position=(float(k), 0.0), restitution=0.0)
    disc = scene.add_body(
        t2.Disc(radius=0.5), mass=1.0, position=(20.2, 1.01), velocity=(9.0, 0.0), restitution=0.0
    )
    compiled, slow = Simulator(scene), plain(scene)
    with np.errstate(all="ignore"):
        for _ in range(40):
            compiled.step()
            slow.step()
    assert compiled.digest() == slow.digest()
    assert slow.position[disc, 1] > 0.99
