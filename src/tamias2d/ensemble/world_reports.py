"""What many worlds tell of their last step: contacts, joints and warnings, and in which world.

Serves: whoever reads many worlds between steps. Hides: that each world tells for itself, and that
worlds may have other joints.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from tamias2d.engine.reports.contact_report import Contacts
from tamias2d.engine.tables import STEPS_TAKEN
from tamias2d.ensemble.shared_arrays import SharedArrays
from tamias2d.ensemble.world_joints import WorldJoints, WorldReactions
from tamias2d.motion.joint_events import JointEvent
from tamias2d.read_only import read_only
from tamias2d.simulator import Simulator
from tamias2d.simulator.exclusive import between_calls, exclusive
from tamias2d.simulator.told_only import REMEDIES, refuses_assignment
from tamias2d.simulator.views import Views
from tamias2d.simulator.warned import warn_caller
from tamias2d.state import Array, IntArray

_ALONE = "Take a world out by world(k): that Simulator has"
_REMEDIES = {
    **REMEDIES,
    "mass": "Call set_mass, or vary it at the start.",
    "present": f"{_ALONE} add and remove.",
    "dynamic": f"{_ALONE} remove, add, add_static and add_kinematic.",
    "generation": f"It counts the bodies that a row has held. {_ALONE} add.",
    "asleep": f"What is moved or pushed wakes; what is slow falls asleep by itself. {_ALONE} wake.",
    "joints": f"{_ALONE} add_joint and remove_joint.",
}
"""For each name, what to do instead of setting it in worlds, which keep their bodies and joints."""


@dataclass(frozen=True, kw_only=True)
class WorldContacts(Contacts):
    """Points at which bodies pushed each other, world after world."""

    world: IntArray
    """(m,)"""


@refuses_assignment
class WorldReports(Views):
    """Worlds that tell what happened in them."""

    __slots__ = ()
    _remedies = _REMEDIES
    _sims: tuple[Simulator, ...]
    _jointed: WorldJoints
    _shared: SharedArrays

    @property
    @between_calls
    def time(self) -> Array:
        """Since the start of each world, s: (worlds,)."""
        times = self._shared.counts[:, STEPS_TAKEN] * self._sims[0].time_step
        return read_only(times, "time of the worlds", REMEDIES["time"])

    @property
    @exclusive
    def contacts(self) -> WorldContacts:
        """All points at which bodies pushed each other in the last step, world after world."""
        return _gathered([sim.contacts for sim in self._sims])

    @property
    @exclusive
    def began(self) -> WorldContacts:
        """The pairs that began to touch in the last call of `step`, world after world.

        Those of one world are as `Simulator.began` tells them.
        """
        return _gathered([sim.began for sim in self._sims])

    @property
    @exclusive
    def ended(self) -> IntArray:
        """The pairs (k, 3) that ceased to touch in the last call of `step`: world, then bodies."""
        pairs = [sim.ended for sim in self._sims]
        rows = np.column_stack((_worlds(pairs), np.concatenate(pairs)))
        return read_only(rows, "pairs that ended", REMEDIES["ended"])

    @property
    def joints(self) -> tuple[str, ...]:
        """The names of all joints that any world has at its start, as they were added."""
        return self._jointed.names

    @property
    @exclusive
    def reactions(self) -> WorldReactions:
        """What the `joints` exerted in the last step, and how well they hold now."""
        return self._jointed.reactions()

    @property
    @between_calls
    def joint_events(self) -> tuple[tuple[JointEvent[str], ...], ...]:
        """What happened to the joints of each world in the last call of `step`."""
        return tuple(sim.joint_events for sim in self._sims)

    @property
    @between_calls
    def warnings(self) -> tuple[str, ...]:
        """What was warned of since the start of each world, and in which one, world after world."""
        return tuple(
            in_world(world, text) for world, sim in enumerate(self._sims) for text in sim.warnings
        )


def in_world(world: int, text: object) -> str:
    """Return a text about a world that says which one."""
    return f"world {world}: {text}"


def warn_of(sims: Sequence[Simulator]) -> None:
    """Warn of what the simulators of worlds kept back."""
    for world, sim in enumerate(sims):
        for text in sim._warned.taken():
            warn_caller(in_world(world, text))


def _gathered(found: list[Contacts]) -> WorldContacts:
    columns = {
        name: np.concatenate([getattr(one, name) for one in found]) for name in vars(found[0])
    }
    columns["world"] = _worlds(found)
    return WorldContacts(
        **{
            name: read_only(values, f"{name} of the contacts", REMEDIES["contacts"])
            for name, values in columns.items()
        }
    )


def _worlds(found: list[Any]) -> IntArray:
    """Return the number of its world for each row of some that were found in all of them."""
    return np.repeat(np.arange(len(found)), [len(one) for one in found])
