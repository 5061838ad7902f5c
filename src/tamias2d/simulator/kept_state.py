"""A simulator between two steps, in memory, to which it can go back again and again."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NoReturn

from tamias2d.engine.engine import Engine
from tamias2d.engine.reports.contact_events import TouchReport
from tamias2d.engine.saving.state_copy import StateCopy
from tamias2d.errors import RecordingError
from tamias2d.motion.joint_events import JointEvent
from tamias2d.scene.rules import RuleError, shown
from tamias2d.simulator.joint_set import JointSet
from tamias2d.state import Array


@dataclass(frozen=True, kw_only=True, repr=False, eq=False)
class KeptState:
    """What a simulator was; made by `Simulator.copy_state`, for that simulator alone."""

    engine: Engine
    bodies: StateCopy
    joints: JointSet
    expects_joints: bool
    names: Mapping[str, int]
    staying: frozenset[int]
    touching: TouchReport
    happened: tuple[JointEvent[str], ...]
    pushed: Array | None
    left: Array
    warnings: Mapping[str, str]
    limits: int
    limit_changes: int

    def __reduce__(self) -> NoReturn:
        """Refuse to be pickled or copied: it is what it is within one simulator."""
        raise RecordingError(
            "state of a simulator: it belongs to that simulator, and cannot be pickled or copied. "
            "Save, pickle or copy the simulator itself."
        )


def checked_state(state: object, engine: Engine) -> KeptState:
    """Return a state of an engine's simulator, or raise `RuleError`."""
    if not isinstance(state, KeptState):
        raise RuleError(
            f"state: found {shown(state)}: must be one of copy_state() (R4). Give what that "
            "returned, or read a file by Simulator.restore.",
            "state",
        )
    if state.engine is not engine:
        raise RuleError(
            "state: it is one of another simulator (R4). Give one that copy_state() of this one "
            "returned, or copy the other simulator.",
            "state",
        )
    return state
