"""How long one waits for the first step, with nothing compiled before and with all of it.

Serves: the measurement of contacts. Hides: how a place without kernels is made.
"""

import os
import subprocess
import sys
import tempfile
from statistics import median
from time import perf_counter

_FIRST = """
import tamias2d as t2
t2.Simulator(t2.catalogue.load({scene!r}), time_step=1 / 60).step()
"""
_AGAIN = 5


def starts(scene: str) -> dict[str, float]:
    """Return seconds from the start of Python to the end of the first step of a scene.

    `empty`: no kernel is there; `cached`: the kernels of this scene are; `menu`: `tamias2d warm` in
    an empty place, which compiles all there are.
    """
    step = ["-c", _FIRST.format(scene=scene)]
    with tempfile.TemporaryDirectory() as place:
        empty = _seconds(step, place)
        cached = median(_seconds(step, place) for _ in range(_AGAIN))
    with tempfile.TemporaryDirectory() as place:
        menu = _seconds(["-m", "tamias2d", "warm"], place)
    return {"empty": empty, "cached": cached, "menu": menu}


def _seconds(arguments: list[str], place: str) -> float:
    start = perf_counter()
    subprocess.run(
        [sys.executable, *arguments],
        check=True,
        capture_output=True,
        env=os.environ | {"TAMIAS2D_HOME": place},
    )
    return perf_counter() - start
