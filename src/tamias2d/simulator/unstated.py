"""No pair that can meet is without a restitution (R3).

Serves: adding bodies. Hides: how pairs are sought without looking at all of them.
"""

from collections.abc import Callable, Iterator, Mapping
from itertools import combinations_with_replacement, product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.engine import Engine
from tamias2d.engine.tables import ABSENT, CATEGORY, DYNAMIC, GROUP, MASK, RESTITUTION, SENSOR
from tamias2d.errors import SceneError
from tamias2d.scene.filters import may_touch
from tamias2d.simulator.batch import Batch

Whole = NDArray[np.int64]


class _Class(NamedTuple):
    """What bodies that state no restitution have in common."""

    dynamic: int
    category: int
    mask: int
    group: int


def refuse_unstated(
    engine: Engine,
    batch: Batch,
    named: Callable[[int], str],
    stated: Mapping[tuple[int, int], float] | None = None,
) -> None:
    """Raise `SceneError` if a body of a batch can meet one, and nothing states a restitution.

    Bodies of the engine are given by rows, those of the batch count on from their number; `stated`
    are the restitutions of pairs, the lower number first.
    """
    known = stated or {}
    new = list(_new(batch, engine.size))
    if not new:
        return
    groups: dict[_Class, list[int]] = {}
    for row, what in (*_there(engine), *new):
        groups.setdefault(what, []).append(row)
    for one, other in combinations_with_replacement(groups, 2):
        if not (may_touch(one, other) and (one.dynamic or other.dynamic)):
            continue
        for i, j in product(groups[one], groups[other]):
            if i != j and max(i, j) >= engine.size and (min(i, j), max(i, j)) not in known:
                raise SceneError(
                    f"restitution of the pair {named(min(i, j))} and {named(max(i, j))}: not "
                    "stated, and they can meet (R3). Give one of them a restitution, set it for "
                    "the pair, or let them not touch."
                )


def _new(batch: Batch, first: int) -> Iterator[tuple[int, _Class]]:
    silent = (batch.restitution < 0.0) & (batch.filters[:, SENSOR] == 0)
    for k in np.flatnonzero(silent).tolist():
        if batch.shapes[k] is not None:
            dynamic = int(batch.kind[k] == DYNAMIC)
            yield first + k, _Class(dynamic, *batch.filters[k, :SENSOR].tolist())


def _there(engine: Engine) -> Iterator[tuple[int, _Class]]:
    kind = engine.world.state.kind[engine.world.state.body_of_shape]
    silent = (engine.world.shapes.material[:, RESTITUTION] < 0.0) & (
        engine.world.shapes.filters[:, SENSOR] == 0
    )
    slots = np.flatnonzero(silent & (kind != ABSENT))
    rows, which = np.unique(engine.world.state.body_of_shape[slots], return_index=True)
    columns = engine.world.shapes.filters[slots[which]][:, [CATEGORY, MASK, GROUP]]
    for row, filters in zip(rows.tolist(), columns.tolist(), strict=True):
        yield row, _Class(int(engine.world.state.kind[row] == DYNAMIC), *filters)
