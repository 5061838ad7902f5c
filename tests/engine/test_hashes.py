"""The same bits on any day: the digest of each scene of many contacts after some steps is stored.

Where the engine is meant to change, `python -m tests.engine.test_hashes` stores them anew.
"""

import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from tamias2d.scene import Scene, catalogue
from tamias2d.simulator import Simulator
from tests.rebuilt import rebuilt

STORE = Path(__file__).with_name("hashes.json")
NAMES = catalogue.names("stepped")
SMALL = ("arch", "bullet-wall", "card-house", "stack-10-heavy")


def steps(name: str) -> int:
    return 4 if name == "pyramid-100" else 60


def digest(name: str, scene: Scene | None = None) -> str:
    sim = Simulator(scene or catalogue.load(name))
    sim.step(steps(name))
    return sim.digest()


def test_every_scene_has_a_stored_digest() -> None:
    assert sorted(json.loads(STORE.read_text())) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_a_scene_has_the_digest_that_is_stored(name: str) -> None:
    assert digest(name) == json.loads(STORE.read_text())[name]


def test_one_step_at_a_time_gives_the_same_bits() -> None:
    sim = Simulator(catalogue.load("card-house"))
    for _ in range(steps("card-house")):
        sim.step()
    assert sim.digest() == json.loads(STORE.read_text())["card-house"]


@pytest.mark.parametrize("name", SMALL)
def test_the_order_of_bodies_changes_no_bit(name: str) -> None:
    scene = catalogue.load(name)
    backwards = rebuilt(scene, reversed(range(len(scene))))
    assert digest(name, backwards) == json.loads(STORE.read_text())[name]


def test_simulators_in_threads_of_their_own_give_the_same_bits() -> None:
    stored = json.loads(STORE.read_text())
    with ThreadPoolExecutor(len(SMALL)) as pool:
        assert list(pool.map(digest, SMALL)) == [stored[name] for name in SMALL]


def test_another_process_gives_the_same_bits() -> None:
    program = f"from tests.engine.test_hashes import *\nfor n in {SMALL!r}: print(digest(n))"
    environment = {**os.environ, "PYTHONHASHSEED": "4242"}
    call = [sys.executable, "-c", program]
    found = subprocess.run(call, env=environment, capture_output=True, text=True, check=True)
    stored = json.loads(STORE.read_text())
    assert found.stdout.split() == [stored[name] for name in SMALL]


def renew() -> None:
    """Store the digests of the engine as it is."""
    STORE.write_text(json.dumps({name: digest(name) for name in NAMES}, indent=2) + "\n")


if __name__ == "__main__":
    renew()
