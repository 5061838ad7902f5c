"""The state of an engine in memory, to which it goes back.

Serves: loops that try steps and take them back. Hides: which arrays hold nothing from one step to
the next, and that arrays may have become longer since. Nothing is checked: nobody else makes one.
Cost: a copy of some 10 kB for each body of a pile.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.world import Capacities, lasting_arrays
from tamias2d.engine.engine import Engine
from tamias2d.state import IntArray


@dataclass(frozen=True, kw_only=True)
class StateCopy:
    """What an engine was between two steps."""

    capacities: Capacities
    arrays: Mapping[str, NDArray[Any]]
    rank: IntArray
    generation: IntArray
    expects_joints: bool


def copy_state(engine: Engine) -> StateCopy:
    """Return what an engine is, which has settled."""
    arrays = {name: values.copy() for name, values in lasting_arrays(engine.world).items()}
    arrays["touching.counts"][[tb.ARRANGED, tb.ISLANDS_KNOWN]] = 0  # whose arrays are left out
    arrays["control.counts"][tb.ALL_ASLEEP] = 0  # likewise
    return StateCopy(
        capacities=engine.capacities,
        arrays=arrays,
        rank=engine.rank.copy(),
        generation=engine.generation.copy(),
        expects_joints=engine.expects_joints,
    )


def restore_state(engine: Engine, state: StateCopy) -> None:
    """Let an engine be what it was, with the same bits from then on; what users see stays there.

    It has at least as many slots as then.
    """
    engine.resize(**(vars(state.capacities) | {"slots": engine.capacities.slots}))
    for name, values in lasting_arrays(engine.world).items():
        kept = state.arrays[name]
        if values.shape == kept.shape:
            values[...] = kept
        else:
            values[...] = 0
            values[tuple(map(slice, kept.shape))] = kept
    if engine.size != len(state.rank):
        engine.size = len(state.rank)
        engine.forget_addresses()
    engine.idle_from(state.capacities.slots - 1)
    engine.begin(state.rank.copy(), state.generation.copy())
    engine.know_corners()
    engine.expects_joints = state.expects_joints
    engine.revision += 1
    engine.forms += 1
