"""Why a step could not be taken, as one error."""

from collections.abc import Callable

from tamias2d.engine.engine import Engine
from tamias2d.engine.tables import ABSENT
from tamias2d.scene.rules import RuleError


def invalid_state(engine: Engine, name_of: Callable[[int], str]) -> RuleError:
    """Return the error of the first value that keeps a step from being taken."""
    invalid = engine.first_invalid()
    if invalid is None:
        return RuleError(
            "gravity: must be finite (R4). Set it to numbers; no step was taken.", "gravity"
        )
    quantity, row, found, moves = invalid
    there = engine.kind[row] != ABSENT
    what = name_of(row) if there else f"row {row}, which has no body"
    if moves:
        return RuleError(
            f"velocity[{row}] of {what}: found {found}, with the angular velocity, of a static "
            "body: must be 0 (R2). Add it as a kinematic one; no step was taken.",
            quantity,
            row,
        )
    return RuleError(
        f"{quantity}[{row}] of {what}: found {found[0] if len(found) == 1 else found}: must be "
        "finite (R4). Set it to a number; no step was taken.",
        quantity,
        row,
    )
