"""What happens in joints at instants: limits that are reached and left, motors, breaking (GD21-23).

The events of a run tell at each time what holds: each limit, each motor, each joint.
"""

from bisect import bisect_right
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Generic, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from tamias2d.state import Array

WORDS = (
    "strikes its lower limit",
    "strikes its upper limit",
    "rests on its lower limit",
    "rests on its upper limit",
    "leaves its lower limit",
    "leaves its upper limit",
    "keeps the speed of its motor",
    "pushes with the maximum of its motor",
    "pushes back with the maximum of its motor",
    "clicks",
    "breaks",
)
"""What an event says of its joint, by its number."""
STRIKES, RESTS, LEAVES = 0, 2, 4
"""Of the lower limit; of the upper one it is one more."""
KEEPS, PUSHES, PUSHES_BACK, CLICKS, BREAKS = 6, 7, 8, 9, 10
_DRIVES = {0: KEEPS, 1: PUSHES, -1: PUSHES_BACK}


Called = TypeVar("Called", int, str)
"""A joint by its index in a scene, or in the frame loop, where joints come and go, by its name."""


class JointEvent(NamedTuple, Generic[Called]):
    """One event."""

    time: float
    """s; in the frame loop the end of the step"""
    joint: Called
    """Its index in the scene, or its name."""
    freedom: int
    """Of those that the joint governs; 0 where it breaks."""
    what: int
    """The number of its word."""
    value: float = 0.0
    """The impulse of a limit that is struck, N s or N m s; the angle of a tooth, rad.

    Of a joint that breaks, its reaction as a share of what it bears: 1 in a run, in which that is
    located, and more where the reaction jumps there, or a step of the frame loop ends. The force
    over `break_force`, or the torque over `break_torque` if that is more.
    """

    @property
    def words(self) -> str:
        """What it says of the joint, such as 'breaks' or 'clicks'."""
        return WORDS[self.what]


@dataclass(frozen=True, kw_only=True)
class JointEvents:
    """The m events of a run's joints, in the order of time."""

    time: Array
    """(m,), s"""
    joint: NDArray[np.int64]
    """(m,), index of the joint"""
    freedom: NDArray[np.int64]
    """(m,), which of those that the joint governs, 0 for most"""
    what: NDArray[np.int64]
    """(m,), index of what `words` says"""
    value: Array
    """(m,), impulse of a limit that is struck, N s or N m s; angle of a tooth, rad; of a joint
    that breaks, its reaction as a share of what it bears"""

    def __len__(self) -> int:
        return len(self.time)

    def __iter__(self) -> Iterator[JointEvent[int]]:
        columns = (self.time, self.joint, self.freedom, self.what, self.value)
        for row in zip(*(column.tolist() for column in columns), strict=True):
            yield JointEvent(*row)

    @property
    def words(self) -> tuple[str, ...]:
        """What each event says of its joint."""
        return tuple(WORDS[k] for k in self.what.tolist())


def joint_events(found: Iterable[JointEvent[int]] = ()) -> JointEvents:
    """Return events as arrays."""
    rows = sorted(found, key=lambda event: event.time)
    return JointEvents(
        time=np.array([event.time for event in rows], dtype=np.float64),
        joint=np.array([event.joint for event in rows], dtype=np.int64),
        freedom=np.array([event.freedom for event in rows], dtype=np.int64),
        what=np.array([event.what for event in rows], dtype=np.int64),
        value=np.array([event.value for event in rows], dtype=np.float64),
    )


Of = tuple[int, int]
"""A joint's index in the scene, and which of its freedoms."""


@dataclass(frozen=True)
class Mode:
    """What joints do between two instants."""

    broken: frozenset[int] = frozenset()
    held: frozenset[tuple[Of, int]] = frozenset()
    """The limits that hold; -1 for a lower one, 1 for an upper."""
    driven: tuple[tuple[Of, int], ...] = ()
    """The motors: 0 where one keeps its speed, else the sense in which it pushes."""
    teeth: tuple[tuple[Of, float], ...] = ()
    """The tooth behind which a ratchet does not go back, rad."""

    def after(self, event: JointEvent[int]) -> "Mode":
        """Return what joints do after an event."""
        of = (event.joint, event.freedom)
        if event.what == BREAKS:
            return self.without({event.joint})
        held, driven, teeth = set(self.held), dict(self.driven), dict(self.teeth)
        if event.what in (RESTS, RESTS + 1):
            held.add((of, 2 * (event.what - RESTS) - 1))
        elif event.what in (LEAVES, LEAVES + 1):
            held.discard((of, 2 * (event.what - LEAVES) - 1))
        elif event.what in _DRIVES.values():
            driven[of] = next(sense for sense, what in _DRIVES.items() if what == event.what)
        elif event.what == CLICKS:
            teeth[of] = event.value
        return Mode(self.broken, frozenset(held), tuple(driven.items()), tuple(teeth.items()))

    def without(self, joints: Collection[int]) -> "Mode":
        """Return what joints do once some have broken, whose limits and motors go with them."""
        return Mode(
            self.broken.union(joints),
            frozenset((of, side) for of, side in self.held if of[0] not in joints),
            tuple((of, sense) for of, sense in self.driven if of[0] not in joints),
            tuple((of, tooth) for of, tooth in self.teeth if of[0] not in joints),
        )


def changes(
    time: float, before: Mode, after: Mode, borne: Mapping[int, float]
) -> Iterator[JointEvent[int]]:
    """Yield the events that lead from one mode to another.

    Of joints that break at more than they bear it is told at which share of it.
    """
    for joint in sorted(after.broken - before.broken):
        yield JointEvent(time, joint, 0, BREAKS, borne.get(joint, 1.0))
    for (joint, freedom), tooth in after.teeth:
        if dict(before.teeth).get((joint, freedom)) != tooth:
            yield JointEvent(time, joint, freedom, CLICKS, tooth)
    for what, held in ((LEAVES, before.held - after.held), (RESTS, after.held - before.held)):
        for (joint, freedom), side in sorted(held):
            if joint not in after.broken:
                yield JointEvent(time, joint, freedom, what + (side > 0))
    for (joint, freedom), sense in after.driven:
        if dict(before.driven).get((joint, freedom)) != sense:
            yield JointEvent(time, joint, freedom, _DRIVES[sense])


@dataclass
class Timeline:
    """The events of a scene's joints, and the modes of each mechanism."""

    events: list[JointEvent[int]] = field(default_factory=list)
    _modes: dict[frozenset[int], list[tuple[float, Mode]]] = field(default_factory=dict)

    def modes(self, joints: frozenset[int]) -> list[tuple[float, Mode]]:
        """Return since when a mechanism has been in which mode: one list for all who ask."""
        if joints not in self._modes:
            found: list[tuple[float, Mode]] = []
            mode = Mode()
            for event in self.events:
                if event.joint in joints:
                    mode = mode.after(event)
                    found.append((event.time, mode))
            self._modes[joints] = found
        return self._modes[joints]

    def drop(self, joints: frozenset[int], after: float) -> None:
        """Forget the events of a mechanism after a time, s."""
        self.events[:] = [e for e in self.events if e.joint not in joints or e.time <= after]

    def replace(
        self, joints: frozenset[int], since: float, events: Sequence[JointEvent[int]]
    ) -> None:
        """Put events in the place of those that a mechanism has from a time on."""
        kept = [e for e in self.events if e.joint not in joints or e.time < since]
        self.events[:] = [*kept, *events]


def mode_at(modes: Sequence[tuple[float, Mode]], time: float) -> Mode:
    """Return the mode at a time, s; at that of an event the one after it."""
    k = bisect_right(modes, time, key=lambda entry: entry[0])
    return modes[k - 1][1] if k else Mode()
