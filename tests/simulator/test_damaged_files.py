"""Files of saved simulators in which bytes were changed: refused by name, or the same simulator.

Ten thousand seeds were tried; the first few hundred are tried each time.
"""

import random
from pathlib import Path

import pytest

import tamias2d as t2
from tests.simulator.crowd import crowd
from tools.fuzz.damage import damaged


@pytest.fixture(scope="module")
def saved(tmp_path_factory: pytest.TempPathFactory) -> tuple[bytes, str]:
    """The bytes of a file, and the digest of the simulator in it."""
    sim = t2.Simulator(crowd(6, seed=3, size=4.0))
    sim.step(10)
    path = tmp_path_factory.mktemp("saved") / "game.npz"
    sim.save(path)
    return path.read_bytes(), sim.digest()


def restored_is_the_same(seed: int, saved: tuple[bytes, str], path: Path) -> bool:
    """Whether a damaged file can be read; then the simulator is the one that was saved."""
    content, digest = saved
    path.write_bytes(damaged(content, random.Random(seed)))
    try:
        sim = t2.Simulator.restore(path)
    except t2.RecordingError:
        return False
    assert sim.digest() == digest
    sim.step(2)
    return True


def test_a_damaged_file_is_refused_or_the_same(saved: tuple[bytes, str], tmp_path: Path) -> None:
    read = [restored_is_the_same(seed, saved, tmp_path / "bad.npz") for seed in range(400)]
    assert 0 < sum(read) < 100  # dates of a zip file, and bytes that were what they became
