"""Why a step could not be taken, as one error."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.state import LARGEST, RESOLVED
from tamias2d.engine.tables import ABSENT
from tamias2d.engine.validity import (
    MOVES,
    NO_BODY,
    NOT_FINITE,
    OVERFLOWED,
    PUSHED,
    SPINS,
    TOO_FAR,
    TOO_LARGE,
    Invalid,
)
from tamias2d.scene.rules import RuleError

_RULES = {
    NOT_FINITE: "must be finite (R4). Set it to a number; the step was not taken.",
    TOO_LARGE: f"must be at most {LARGEST:.2g}, in all with what is like it, or float64 cannot "
    "hold what follows (R4). Set a smaller one; the step was not taken.",
    TOO_FAR: f"must be within {RESOLVED:.2g} times the radius of the body, or float64 does not "
    "tell its parts apart (R4). Bring it nearer; the step was not taken.",
    MOVES: "with the angular velocity, of a static body: must be 0 (R2). Add it as a kinematic "
    "one; the step was not taken.",
    PUSHED: "of a static or kinematic body: must be 0, since nothing pushes it (R2). Set it to 0, "
    "or add a body that has a mass; the step was not taken.",
    SPINS: "must be 0: its inertia is infinite, or it is a particle without one (R2, DD20). Set it "
    "to 0, or give the body an inertia by set_mass; the step was not taken.",
    NO_BODY: "must be 0: the body was removed (R2). Set it to 0, and forget the index: a body that "
    "is added may take it; the step was not taken.",
    OVERFLOWED: "float64 cannot hold what a step makes of it (R4): the body stays as it was. Give "
    "smaller forces or velocities, or masses that are nearer to each other.",
}


class NoValueError(RuleError):
    """The equation of a joint has no value where a step leads (TM7)."""


def invalid_state(
    invalid: Invalid,
    kind: NDArray[np.int8],
    name_of: Callable[[int], str],
    equation: str | None = None,
    joint: str | None = None,
) -> RuleError:
    """Return the error of a value that keeps a step from being taken; bodies have kinds (n,).

    An `equation` is the name of a joint that has one of its own, and holds the body; a `joint` that
    of any other one.
    """
    quantity, row, found, reason = invalid
    value = found[0] if len(found) == 1 else found
    if row < 0:
        return RuleError(f"gravity: found {value}: {_RULES[reason]}", quantity)
    what = name_of(row) if kind[row] != ABSENT else f"row {row}, which has no body"
    if reason == OVERFLOWED and equation is not None:
        return NoValueError(
            f"{quantity}[{row}] of {what}: found {value}: the equation of joint '{equation}' has "
            "no value where a step leads (TM7), or float64 cannot hold what a step makes of the "
            "body (R4): it stays as it was. Let the equation have a value wherever the body goes.",
            *(quantity, row),
        )
    if reason == OVERFLOWED and joint is not None:
        return RuleError(
            f"{quantity}[{row}] of {what}: found {value}: float64 cannot hold what a step makes of "
            f"the mechanism of joint '{joint}', which holds it (R4, R13): the body stays as it "
            "was. Look whether its joints fit each other and what it touches; give more substeps, "
            "smaller forces or velocities, or masses that are nearer to each other.",
            *(quantity, row),
        )
    separator = "," if reason in (MOVES, PUSHED) else ":"
    return RuleError(
        f"{quantity}[{row}] of {what}: found {value}{separator} {_RULES[reason]}", quantity, row
    )
