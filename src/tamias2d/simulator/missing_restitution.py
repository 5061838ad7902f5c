"""No pair that can meet is without a restitution (R3); bodies alike are looked at once."""

from collections.abc import Callable, Iterator, Mapping
from itertools import combinations_with_replacement, product
from typing import NamedTuple

import numpy as np

from tamias2d.engine.batch import Batch
from tamias2d.engine.engine import Engine
from tamias2d.engine.tables import DYNAMIC, SENSOR
from tamias2d.errors import SceneError
from tamias2d.scene.filters import may_touch


class _Class(NamedTuple):
    """What bodies that state no restitution have in common."""

    dynamic: int
    category: int
    mask: int
    group: int


def refuse_missing_restitution(
    engine: Engine,
    batch: Batch,
    named: Callable[[int], str],
    stated: Mapping[tuple[int, int], float] | None = None,
    place_of: Callable[[int, int], str] = lambda *_: "",
) -> None:
    """Raise `SceneError` if a body of a batch can meet one, and nothing states a restitution.

    Bodies of the engine are given by rows, those of the batch count on from their number; `stated`
    are the restitutions of pairs, the lower number first. `place_of` a pair begins the message.
    """
    known = stated or {}
    new = list(_new(batch, engine.size))
    if not new:
        return
    groups: dict[_Class, list[int]] = {}
    for row, what in (*_present(engine), *new):
        groups.setdefault(what, []).append(row)
    for one, other in combinations_with_replacement(groups, 2):
        if not (may_touch(one, other) and (one.dynamic or other.dynamic)):
            continue
        for i, j in product(groups[one], groups[other]):
            if i != j and max(i, j) >= engine.size and (min(i, j), max(i, j)) not in known:
                first, second = min(i, j), max(i, j)
                raise SceneError(
                    f"{place_of(first, second)}restitution of the pair {named(first)} and "
                    f"{named(second)}: not stated, and they can meet (R3). Give one of "
                    "them a restitution, set it for the pair, or let them not touch."
                )


def _new(batch: Batch, first: int) -> Iterator[tuple[int, _Class]]:
    silent = (batch.restitution < 0.0) & (batch.filters[:, SENSOR] == 0)
    for k in np.flatnonzero(silent).tolist():
        if batch.shapes[k] is not None:
            dynamic = int(batch.kind[k] == DYNAMIC)
            yield first + k, _Class(dynamic, *batch.filters[k, :SENSOR].tolist())


def _present(engine: Engine) -> Iterator[tuple[int, _Class]]:
    owner, surface, filters = engine.surfaces()
    silent = np.flatnonzero((surface[:, 1] < 0.0) & (filters[:, SENSOR] == 0))
    rows, which = np.unique(owner[silent], return_index=True)
    columns = filters[silent[which], :SENSOR]
    for row, numbers in zip(rows.tolist(), columns.tolist(), strict=True):
        yield row, _Class(int(engine.kind[row] == DYNAMIC), *numbers)
