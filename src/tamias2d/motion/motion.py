"""The protocol of a motion: it makes the paths of a scene's bodies, and counts their cost."""

from dataclasses import dataclass
from typing import Protocol

from tamias2d.motion.joint_events import JointEvents
from tamias2d.path import Paths
from tamias2d.state import Array, History
from tamias2d.work_limit import Work


@dataclass
class Tally:
    """What a motion has cost so far."""

    steps: int = 0
    rejected: int = 0
    force_evaluations: int = 0


class Motion(Paths, Protocol):
    """One way of finding paths, for the bodies of one scene up to the end of one run."""

    tally: Tally
    """What it has cost so far."""
    notes: tuple[str, ...]
    """What the user should know of it."""
    unresolved: str | None
    """What its steps, where they are given, miss of a law."""
    work: Work
    """What counts its steps, where it chooses them itself."""
    sampled: History | None
    """What `history` has found until an error or Ctrl-C ended it."""

    def joint_events(self) -> JointEvents:
        """Return what has happened in joints so far."""

    def history(self, times: Array) -> History:
        """Return the states at sorted times (k,), s, where nothing touches."""
