"""Settings of a simulator, checked (R4)."""

from typing import Any

from tamias2d.engine.state import LARGEST
from tamias2d.scene.rules import RuleError, checked_count, number

MOST_SUBSTEPS = 1000
"""More than solve anything; so few that Ctrl-C does not wait for the end of a step."""


def checked_time_step(value: object) -> float:
    """Return a time step, s, that float64 can divide by and square, or raise `RuleError`."""
    remedy = "Give it in s, such as 1/60."
    time_step = number(value, "time_step", "the simulator", remedy, at=("time_step",))
    if not 1 / LARGEST <= time_step <= LARGEST:
        raise RuleError(
            f"time step {time_step!r} s of the simulator: must be from {1 / LARGEST:.2g} to "
            f"{LARGEST:.2g} s, or float64 cannot hold what follows (R4). {remedy}",
            "time_step",
        )
    return time_step


def checked_substeps(value: object) -> int:
    """Return a number of substeps, or raise `RuleError`."""
    count = checked_count(value, "substeps", 1)
    if count > MOST_SUBSTEPS:
        raise RuleError(
            f"substeps {count}: must be at most {MOST_SUBSTEPS} (R4). Give a shorter time_step "
            "instead.",
            "substeps",
        )
    return count


def checked_steps(value: Any) -> int:
    """Return how many steps are asked for, or raise `RuleError`."""
    remedy = (
        "Give how many steps; how long one is, Simulator is told as it is made: time_step=1/60."
    )
    return checked_count(value, "count", 0, remedy=remedy)
