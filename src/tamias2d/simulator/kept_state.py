"""A simulator between two steps, in memory, to which it can go back again and again."""

from collections.abc import Callable, Mapping
from copy import copy
from dataclasses import dataclass
from typing import Any, NoReturn

from tamias2d.engine.engine import Engine
from tamias2d.engine.saving.state_copy import StateCopy
from tamias2d.errors import RecordingError
from tamias2d.scene.rules import RuleError, shown
from tamias2d.simulator.body_names import BodyNames
from tamias2d.simulator.joint_set import JointSet


def _same(part: Any) -> Any:
    """Return what nobody changes in place."""
    return part


PARTS: Mapping[str, Callable[[Any], Any]] = {
    "_happened": copy,
    "_joints": JointSet.copied,
    "_left": copy,
    "_limit_changes": _same,
    "_limits": _same,
    "_names": BodyNames.copied,
    "_parted": copy,
    "_pushed": copy,
    "_scene": _same,
    "_staying": copy,
    "_touching": _same,
}
"""What a simulator is besides its engine and what it warned of: attributes, and how each is copied.

All others follow from these, or stay what they are.
"""


@dataclass(frozen=True, kw_only=True, repr=False, eq=False)
class KeptState:
    """What a simulator was; made by `Simulator.copy_state`, for that simulator alone."""

    engine: Engine
    bodies: StateCopy
    parts: Mapping[str, Any]
    """Copies of `PARTS`."""
    warnings: Mapping[str, str]

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


def copies(parts: Callable[[str], Any]) -> dict[str, Any]:
    """Return copies of the parts of a simulator, or of its state, by their names."""
    return {name: copied(parts(name)) for name, copied in PARTS.items()}
