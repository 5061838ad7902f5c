"""Which bodies are meant: by index, by name, many at once (R1)."""

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.tables import ABSENT
from tamias2d.scene.rules import RuleError, shown
from tamias2d.simulator.columns import as_array
from tamias2d.state import IntArray

Bodies: TypeAlias = int | str | Sequence[int] | Sequence[str] | NDArray[np.integer | np.bool_]
"""One body by index or name; many by a list or an array of them, or by a mask of truth values."""
_REMEDY = "Give an index or a name, an array of indices, or a truth value for each row."


def selected(bodies: object, kind: NDArray[np.int8], names: Mapping[str, int]) -> IntArray:
    """Return the rows of bodies (k,), or raise `RuleError` if one is not there."""
    found = names.get(bodies, bodies) if isinstance(bodies, str) else bodies
    given: NDArray[np.generic] = as_array(found, "bodies", "the selection", _REMEDY)
    if given.dtype.kind == "U":
        missing = [name for name in given.ravel().tolist() if name not in names]
        if missing:
            raise RuleError(
                f"body {shown(missing[0])}: the simulator has none such (R1). Name one of "
                f"{shown(list(names))}.",
                "bodies",
            )
        given = np.array([names[name] for name in given.ravel().tolist()], dtype=np.int64)
    elif given.dtype.kind == "b":
        if given.shape != kind.shape:
            raise RuleError(
                f"bodies: found {given.size} truth values: must be {len(kind)}, one for each row, "
                f"of which some may be empty: as many as len(sim.position) (R1). {_REMEDY}",
                "bodies",
            )
        given = np.flatnonzero(given)
    elif given.dtype.kind not in "iu" and given.size:
        raise RuleError(
            f"bodies: found {shown(bodies)}: must be whole numbers or names (R1). {_REMEDY}",
            "bodies",
        )
    asked: NDArray[Any] = given.ravel()
    rows = asked.astype(np.int64)
    there = (asked >= 0) & (asked < len(kind))
    there[there] = kind[rows[there]] != ABSENT
    if not there.all():
        raise RuleError(
            f"body {asked[int(np.argmin(there))]}: the simulator has none such, or it was removed "
            f"(R1). {_REMEDY}",
            "bodies",
        )
    return rows
