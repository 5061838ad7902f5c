"""What many worlds tell of their last step: contacts, joints and warnings, and in which world.

Serves: whoever reads many worlds between steps. Hides: that each world tells for itself, and that
worlds may have other joints.
"""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.reports.contact_report import Contacts
from tamias2d.engine.tables import STEPS_TAKEN
from tamias2d.ensemble.shared_arrays import SharedArrays
from tamias2d.motion.joint_events import JointEvent
from tamias2d.read_only import read_only
from tamias2d.simulator import Simulator
from tamias2d.simulator.exclusive import between_calls, exclusive
from tamias2d.simulator.joint_reactions import Reactions
from tamias2d.simulator.told_only import REMEDIES, refuses_assignment
from tamias2d.simulator.views import Views
from tamias2d.simulator.warned import warn_caller
from tamias2d.state import Array, IntArray

_ALONE = "Take a world out by world(k): that Simulator has"
_REMEDIES = {
    **REMEDIES,
    "mass": f"Vary it at the start. {_ALONE} set_mass.",
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


@dataclass(frozen=True, kw_only=True)
class WorldReactions(Reactions):
    """Reactions with an axis of worlds before all others, such as `force` (worlds, j, 3, 2).

    Where a world does not have a joint, as where it broke, its numbers are nan and its limit 0.
    """


@refuses_assignment
class WorldReports(Views):
    """Worlds that tell what happened in them."""

    __slots__ = ()
    _remedies = _REMEDIES
    _sims: tuple[Simulator, ...]
    _joint_names: tuple[str, ...]
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
        return self._joint_names

    @property
    @exclusive
    def reactions(self) -> WorldReactions:
        """What the `joints` exerted in the last step, and how well they hold now."""
        return _stacked([sim.reactions for sim in self._sims], self._joint_names)

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


def _stacked(found: list[Reactions], names: tuple[str, ...]) -> WorldReactions:
    """Return the reactions of worlds, in which each joint has its place by name."""
    place = {name: k for k, name in enumerate(names)}
    rows = [[place[name] for name in one.names] for one in found]
    columns = {
        field.name: _in_rows([getattr(one, field.name) for one in found], rows, len(names))
        for field in fields(Reactions)
        if field.name != "names"
    }
    return WorldReactions(
        names=names,
        **{
            name: read_only(values, f"{name} of the reactions", REMEDIES["reactions"])
            for name, values in columns.items()
        },
    )


def _in_rows(found: list[NDArray[Any]], rows: list[list[int]], count: int) -> NDArray[Any]:
    """Return the values of worlds in the rows that are theirs of so many, (worlds, count, ...)."""
    like = found[0]
    missing = np.nan if like.dtype.kind == "f" else 0
    whole = np.full((len(found), count, *like.shape[1:]), missing, dtype=like.dtype)
    for world, values in enumerate(found):
        whole[world, rows[world]] = values
    return whole
