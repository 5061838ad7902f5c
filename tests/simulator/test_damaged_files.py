"""Files of saved simulators in which bytes were changed: refused by name, or the same simulator.

Ten thousand seeds were tried; the first few hundred are tried each time.
"""

import random
from pathlib import Path

import pytest

import tamias2d as t2
from tests.simulator.crowd import crowd


@pytest.fixture(scope="module")
def saved(tmp_path_factory: pytest.TempPathFactory) -> tuple[bytes, str]:
    """The bytes of a file, and the digest of the simulator in it."""
    sim = t2.Simulator(crowd(6, seed=3, size=4.0))
    sim.step(10)
    path = tmp_path_factory.mktemp("saved") / "game.npz"
    sim.save(path)
    return path.read_bytes(), sim.digest()


def damaged(content: bytes, chance: random.Random) -> bytes:
    """The content with bits flipped, bytes set or moved, or a stretch cut, repeated or cleared."""
    found = bytearray(content)
    for _ in range(chance.choice((1, 1, 1, 2, 5))):
        start = chance.randrange(len(found))
        end = min(start + chance.choice((1, 1, 4, 100, len(found))), len(found))
        match chance.randrange(6):
            case 0:
                found[start] ^= 1 << chance.randrange(8)
            case 1:
                found[start] = chance.choice((0, 1, 127, 128, 255))
            case 2:
                found[start:end] = bytes(end - start)
            case 3:
                found[start:end] = found[start:end] * 2
            case 4 if end - start < len(found):
                del found[start:end]
            case _:
                place = chance.randrange(len(found))
                found[place : place + end - start] = found[start:end][: len(found) - place]
    return bytes(found)


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
