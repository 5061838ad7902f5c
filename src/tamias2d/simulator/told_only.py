"""What a simulator tells and does not take, and what to do instead of assigning it."""

from collections.abc import Callable
from typing import Any, NoReturn, TypeVar

from tamias2d.scene.rules import RuleError, shown

_Class = TypeVar("_Class", bound=type)

_NEW = "Make another simulator."
_PUSH = "It tells what the last step did: call apply_impulse or apply_force to push bodies."
REMEDIES = {
    "mass": "Call set_mass.",
    "present": "Call add or remove.",
    "dynamic": "Remove the body, and add it by add, add_static or add_kinematic.",
    "generation": "Call add: it counts the bodies that a row has held.",
    "asleep": "Call wake; what is slow falls asleep by itself.",
    "contacts": _PUSH,
    "began": _PUSH,
    "ended": _PUSH,
    "reactions": _PUSH,
    "joint_events": _PUSH,
    "joints": "Call add_joint or remove_joint.",
    "time": "Call step.",
    "time_step": _NEW,
    "substeps": _NEW,
    "parts": "The simulator finds it.",
    "warnings": "The simulator finds them.",
}
"""For each name, what to do instead of setting it."""


def refuses_assignment(target: _Class) -> _Class:
    """Let a class say by name what to do instead where one of its read-only values is set."""
    for name in REMEDIES:
        value = vars(target).get(name)
        if isinstance(value, property):
            setattr(target, name, value.setter(_refusal(name)))
    return target


def _refusal(name: str) -> Callable[[Any, Any], NoReturn]:
    def refuse(told: Any, value: Any) -> NoReturn:
        raise RuleError(
            f"{name.replace('_', ' ')} of the simulator: found {shown(value)}: it is told, and "
            f"cannot be set (R4). {told._remedies[name]}",
            name,
        )

    return refuse
