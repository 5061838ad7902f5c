"""Why a step could not be taken, as one error.

Serves: the frame loop. Hides: where a number that is none is looked for.
"""

from collections.abc import Callable

import numpy as np

from tamias2d.engine.engine import Engine
from tamias2d.engine.tables import ABSENT, STATIC
from tamias2d.scene.rules import RuleError

_COLUMNS = {
    "position": ("pose", slice(0, 2)),
    "orientation": ("pose", 2),
    "velocity": ("velocity", slice(0, 2)),
    "angular_velocity": ("velocity", 2),
    "force": ("load", slice(0, 2)),
    "torque": ("load", 2),
}


def fault(engine: Engine, name_of: Callable[[int], str]) -> RuleError:
    """Return the error of the first value that is not finite; the state is as before the step."""
    for key, (array, columns) in _COLUMNS.items():
        values = getattr(engine.world.state, array)[: engine.size, columns].reshape(engine.size, -1)
        bad = ~np.isfinite(values).all(axis=1)
        if bad.any():
            row = int(np.argmax(bad))
            what = (
                name_of(row)
                if engine.world.state.kind[row] != ABSENT
                else f"row {row}, which has no body"
            )
            found = values[row].tolist()
            return RuleError(
                f"{key}[{row}] of {what}: found {found[0] if len(found) == 1 else found}: must be "
                "finite (R4). Set it to a number; no step was taken.",
                key,
                row,
            )
    moving = engine.world.state.velocity[: engine.size].any(axis=1) & (
        engine.world.state.kind[: engine.size] == STATIC
    )
    if moving.any():
        row = int(np.argmax(moving))
        return RuleError(
            f"velocity[{row}] of {name_of(row)}: found {engine.world.state.velocity[row].tolist()}, with the "
            "angular velocity, of a static body: must be 0 (R2). Add it as a kinematic one; no "
            "step was taken.",
            "velocity",
            row,
        )
    return RuleError(
        "gravity: must be finite (R4). Set it to numbers; no step was taken.", "gravity"
    )
