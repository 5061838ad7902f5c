"""The joints of many worlds, and what they exerted, found for all worlds at once.

Hides: that worlds may have other joints, as where one broke.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.scene.joints import Joint
from tamias2d.simulator import Simulator
from tamias2d.simulator.joint_columns import JointColumns
from tamias2d.simulator.joint_reactions import Reactions, reactions_of, told


@dataclass(frozen=True, kw_only=True)
class WorldReactions(Reactions):
    """Reactions with an axis of worlds before all others, such as `force` (worlds, j, 3, 2).

    Where a world does not have a joint, as where it broke, its numbers are nan and its limit 0.
    """


class WorldJoints:
    """Joints of worlds, each with its place by name."""

    def __init__(self, sims: Sequence[Simulator], starts: Sequence[Sequence[Joint]]) -> None:
        """Take worlds, and the joints of each at its start."""
        self._sims = sims
        self.names = tuple(dict.fromkeys(joint.name for own in starts for joint in own))
        """Of all joints that any world has at its start, as they were added."""
        self._columns: JointColumns | None = None  # once reactions were asked for

    def reactions(self) -> WorldReactions:
        """Return what they exerted in the last step, and how well they hold now."""
        engines = [sim._engine for sim in self._sims]
        owned = [list(sim._joints) for sim in self._sims]
        counts = [len(own) for own in owned]
        joints = [joint for own in owned for joint in own]
        if self._columns is None or not self._columns.are(joints):
            sizes = [engine.size for engine in engines]
            self._columns = JointColumns(joints, np.repeat(np.cumsum([0, *sizes[:-1]]), counts))
        values = reactions_of(
            self._columns,
            np.concatenate([sim._joints.totals(sim._engine) for sim in self._sims]),
            np.concatenate([engine.pose for engine in engines]),
            np.concatenate([engine.velocity for engine in engines]),
            time=np.repeat([engine.time for engine in engines], counts),
            time_step=self._sims[0].time_step,
        )
        return self._by_world(values, self._columns.names, counts)

    def _by_world(
        self, values: Mapping[str, NDArray[Any]], of: Sequence[str], counts: Sequence[int]
    ) -> WorldReactions:
        """Return values of joints with names, world after world, so many in each."""
        place = {name: k for k, name in enumerate(self.names)}
        worlds, rows = np.repeat(np.arange(len(counts)), counts), [place[name] for name in of]
        columns = {}
        for key, array in values.items():
            missing = np.nan if array.dtype.kind == "f" else 0
            shape = (len(counts), len(self.names), *array.shape[1:])
            columns[key] = np.full(shape, missing, dtype=array.dtype)
            columns[key][worlds, rows] = array
        return WorldReactions(**told(self.names, columns))
