"""Which bodies are meant: by index, by name, many at once (R1).

Serves: whatever takes bodies. Hides: how they can be given.
"""

from collections.abc import Mapping, Sequence
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from tamias2d.scene.rules import RuleError, shown
from tamias2d.stepped.layout import ABSENT

Whole = NDArray[np.int64]
Bodies: TypeAlias = int | str | Sequence[int] | Sequence[str] | NDArray[np.integer | np.bool_]
"""One body by index or name; many by a list or an array of them, or by a mask of truth values."""
_REMEDY = "Give an index or a name, an array of indices, or a truth value for each body."


def selected(bodies: object, kind: NDArray[np.int8], names: Mapping[str, int]) -> Whole:
    """Return the rows of bodies (k,), or raise `RuleError` if one is not there."""
    given = np.asarray(names.get(bodies, bodies) if isinstance(bodies, str) else bodies)
    if given.dtype.kind == "U":
        given = np.array([names.get(str(name), -1) for name in given.ravel()])
        if (given < 0).any():
            missing = shown(np.asarray(bodies).ravel()[int(np.argmin(given))].item())
            raise RuleError(
                f"body {missing}: the simulator has none such (R1). Name one of "
                f"{shown(list(names))}.",
                "bodies",
            )
    elif given.dtype.kind == "b":
        if given.shape != kind.shape:
            raise RuleError(
                f"bodies: found {given.size} truth values: must be {len(kind)}, one for each body "
                f"(R1). {_REMEDY}",
                "bodies",
            )
        given = np.flatnonzero(given)
    elif given.dtype.kind not in "iu" and given.size:
        raise RuleError(
            f"bodies: found {shown(bodies)}: must be whole numbers or names (R1). {_REMEDY}",
            "bodies",
        )
    rows = given.astype(np.int64).ravel()
    there = (rows >= 0) & (rows < len(kind))
    there[there] = kind[rows[there]] != ABSENT
    if not there.all():
        raise RuleError(
            f"body {rows[int(np.argmin(there))]}: the simulator has none such, or it was removed "
            f"(R1). {_REMEDY}",
            "bodies",
        )
    return rows
