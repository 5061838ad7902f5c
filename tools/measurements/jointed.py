"""Joints in the frame loop beside Pymunk and Box2D: time of a step, drift, stretch and energy.

The programs step the same scene in turns, 60 steps each: a net, a heavy ball on a chain, a slack
bridge, chains, and ragdolls that fall side by side or on a heap. Our own engine takes a step in
each of the numbers of substeps that are asked for; Box2D takes four. Times are those of the
processor. Random mechanisms follow, of our own engine alone: of all kinds of joints, and with
limits and motors.
"""

import argparse
import math
import time
import warnings
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np

from tamias2d.errors import StepWarning
from tamias2d.scene import Joint, Scene
from tamias2d.simulator import Simulator
from tools.measurements.columns import Columns, table_of
from tools.measurements.mechanisms.faults import Energy, apart
from tools.measurements.mechanisms.limited_mechanism import limited_mechanism
from tools.measurements.mechanisms.programs import JointedBox2D, JointedChipmunk, Own, rates_of
from tools.measurements.mechanisms.random_mechanism import random_mechanism
from tools.measurements.mechanisms.scenes import (
    ball_and_chain,
    bridge,
    chains,
    falling_ragdolls,
    net,
    ragdoll_heap,
    ragdoll_rain,
    spinner,
)
from tools.measurements.progress import TOLD

_STEP = 1 / 60
_TURN = 60  # steps
_APART = 1e-3  # of the reach of a joint, or rad


def options(parser: argparse.ArgumentParser) -> None:
    """Add how long and how much."""
    parser.add_argument("--seconds", type=int, default=10, help="s of simulated time")
    parser.add_argument(
        "--substeps", type=int, nargs="+", default=[4, 2], help="of ours, beside each other (4 2)"
    )
    parser.add_argument("--side", type=int, default=30, help="discs on a side of the net")
    parser.add_argument("--ragdolls", type=int, default=20, help="that fall side by side")
    parser.add_argument("--heap", type=int, default=4, help="ragdolls that fall on each other")
    parser.add_argument("--spun", type=int, default=600, help="bodies around a driven bar")
    parser.add_argument("--random", type=int, default=500, help="random mechanisms")
    parser.add_argument("--limited", type=int, default=200, help="more with limits, and motors")
    parser.add_argument("--seed", type=int, default=1_000_000, help="of the first of them")


def measure(
    seconds: int = 10,
    substeps: Sequence[int] = (4, 2),
    side: int = 30,
    ragdolls: int = 20,
    heap: int = 4,
    spun: int = 600,
    random: int = 500,
    limited: int = 200,
    seed: int = 1_000_000,
) -> dict[str, Any]:
    """Return a row for each scene and program, and what became of random mechanisms."""
    scenes: dict[str, Callable[[], Scene]] = {
        f"net {side} x {side}": lambda: net(side),
        "ball and chain 672:1": ball_and_chain,
        "slack bridge of 40": bridge,
        "20 chains of 20": lambda: chains(20, 20),
        f"{ragdolls} ragdolls": lambda: falling_ragdolls(ragdolls),
        f"heap of {heap} ragdolls": lambda: ragdoll_heap(heap),
        f"rain of {ragdolls} sprung ragdolls": lambda: ragdoll_rain(ragdolls),
        f"spinner among {spun}": lambda: spinner(spun),
    }
    rows: list[dict[str, Any]] = []
    for name, made in scenes.items():
        found = _race(name, made(), seconds, substeps)
        rows += found
        for cells in table_of(COLUMNS, found)[1]:
            TOLD.print("  ".join(cells), highlight=False)
    kinds: dict[str, tuple[int, Callable[[int], Scene]]] = {
        "of all kinds": (random, random_mechanism),
        "with limits": (limited, partial(limited_mechanism, motors=False)),
        "with limits and motors": (limited, partial(limited_mechanism, motors=True)),
    }
    mechanisms = {
        name: _mechanisms(range(seed, seed + count), made, seconds)
        for name, (count, made) in kinds.items()
    }
    return {"rows": rows, "mechanisms": mechanisms}


COLUMNS: Columns = {
    "scene": "{scene}",
    "joints": "{joints}",
    "program": "{program}",
    "ms a step": "{milliseconds:.3g}",
    "apart at the end": "{last:.1e} m",
    "at most": "{most:.1e} m",
    "gain": "{gain:.0e}",
}


def notes(found: dict[str, Any]) -> list[str]:
    """Return what the columns mean, and what became of random mechanisms."""
    lines = ["gain: the most that energy rose in a step, of all that gravity gave or motion had"]
    for name, of in found["mechanisms"].items():
        line = (
            f"{of['count']} mechanisms {name}, seeds from {of['first']}: {of['apart']} were ever "
            f"more than {_APART:g} of their reach apart, {of['untold']} of them without a warning, "
            f"at most {of['most']:.1e}"
        )
        if not name.endswith("motors"):
            line += f"; {of['risen']} had ever more than 1e-9 more energy than at first, "
            line += f"at most {of['gain']:.1e}"
        lines.append(line)
    return lines


def _race(name: str, scene: Scene, seconds: int, substeps: Sequence[int]) -> list[dict[str, Any]]:
    """Return the row of each program; they step the scene in turns."""
    worlds: list[Own | JointedBox2D | JointedChipmunk] = [
        *(Own(scene, _STEP, each) for each in substeps),
        *(JointedBox2D(scene, _STEP), JointedChipmunk(scene, _STEP)),
    ]
    seen = [Energy(scene) for _ in worlds]
    times: list[list[float]] = [[] for _ in worlds]
    gaps: list[list[float]] = [[] for _ in worlds]
    for turn in range(math.ceil(seconds / (_TURN * _STEP))):
        for k, world in enumerate(worlds):
            spent = 0.0
            for _ in range(_TURN):
                began = time.process_time()
                world.step(1)
                spent += time.process_time() - began
                state = world.state()
                seen[k].look(state[:, :3], state[:, 3:])
            if turn or seconds == 1:  # the first one compiles
                times[k].append(spent / _TURN)
            gaps[k].append(apart(scene, world.state()))
    return [
        {
            "scene": name,
            "joints": len(scene.joints),
            "program": world.name,
            "milliseconds": 1e3 * float(np.median(times[k])),
            "last": gaps[k][-1],
            "most": max(gaps[k]),
            "gain": seen[k].gain,
        }
        for k, world in enumerate(worlds)
    ]


def _size(joint: Joint) -> float:
    """Return how far a joint reaches from the middles of its bodies, or how long it is, m."""
    held = zip(joint.anchors, joint.ends, strict=True)
    lengths = [math.hypot(*anchor) for anchor, body in held if body is not None]
    length = joint.given.get("joint_length")
    return max(*lengths, length if isinstance(length, float) else 0.0)


def _mechanisms(seeds: range, made: Callable[[int], Scene], seconds: int) -> dict[str, Any]:
    """Follow random mechanisms; return how many came apart or gained energy."""
    parted = untold = risen = 0
    gain = farthest = 0.0
    for seed in seeds:
        scene = made(seed)
        seen = Energy(scene)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", StepWarning)
            sim = Simulator(scene, time_step=_STEP)
            seen.look(np.column_stack((sim.position, sim.orientation)), rates_of(sim))
            sim.step()
            most, sizes = 0.0, np.array([_size(joint) for joint in scene.joints])
            for _ in range(seconds * 60):
                seen.look(np.column_stack((sim.position, sim.orientation)), rates_of(sim))
                sim.step()
                told = sim.reactions
                lengths = told.separation / sizes
                most = max(most, float(lengths.max()), float(told.angular_separation.max()))
        parted += most > _APART
        untold += most > _APART and not sim.warnings
        risen += seen.above > 1e-9
        gain, farthest = max(gain, seen.above), max(farthest, most)
    return {
        "count": len(seeds),
        "first": seeds.start,
        "apart": parted,
        "untold": untold,
        "most": farthest,
        "risen": risen,
        "gain": gain,
    }
