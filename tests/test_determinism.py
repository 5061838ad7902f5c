"""The same input gives the same bits in any process, whatever the seed of Python's hashes."""

import os
import subprocess
import sys

SCENES = ("billiard", "showcase", "spinning-square", "spring-chain", "driven")
PROGRAM = f"""
from tamias2d.scene import catalogue
from tamias2d.simulate import simulate

for name in {SCENES!r}:
    scene = catalogue.load(name)
    print(name, simulate(scene, duration=min(scene.duration, 2.0)).digest())
"""


def digests(seed: str) -> str:
    environment = {**os.environ, "PYTHONHASHSEED": seed}
    call = [sys.executable, "-c", PROGRAM]
    return subprocess.run(call, env=environment, capture_output=True, text=True, check=True).stdout


def test_two_processes_give_the_same_bits() -> None:
    first, second = digests("1"), digests("4242")
    assert len(first.splitlines()) == len(SCENES)
    assert first == second
