"""No pair that can meet is without a restitution (R3); bodies alike are looked at once."""

from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from itertools import combinations_with_replacement, product
from typing import NamedTuple

import numpy as np

from tamias2d.engine.bodies.batch import Batch
from tamias2d.engine.engine import Engine
from tamias2d.engine.shapes.stated_surfaces import UNSTATED
from tamias2d.engine.tables import BY_BODY, DYNAMIC, RESTITUTION, SENSOR
from tamias2d.errors import SceneError
from tamias2d.scene.compound import Compound, Shape
from tamias2d.scene.filters import may_touch
from tamias2d.scene.joints import Joint, kept_apart
from tamias2d.state import IntArray


class _Class(NamedTuple):
    """What bodies have in common of which something states no restitution."""

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
    if UNSTATED in batch.surfaces[:, 1].tolist() and (new := dict(_new(batch, engine.size))):
        _refuse(new, dict(_present(engine)), named, stated or {}, place_of)


def refuse_refiltered(
    engine: Engine,
    rows: IntArray,
    columns: Mapping[int, IntArray],
    named: Callable[[int], str],
    joints: Iterable[Joint],
) -> None:
    """Raise `SceneError` if a body that gets other filters can meet one without a restitution.

    `columns` (k,) of the filters of k bodies are those that they get; joints keep pairs apart.
    """
    present = dict(_present(engine))
    new = {
        row: present[row]._replace(**{_Class._fields[1 + n]: int(x[k]) for n, x in columns.items()})
        for k, row in enumerate(rows.tolist())
        if row in present
    }
    if new:
        _refuse(new, present, named, engine.stated_restitutions() | kept_apart(joints))


def refuse_reshaped(
    engine: Engine,
    rows: IntArray,
    shapes: Sequence[Shape],
    named: Callable[[int], str],
    joints: Iterable[Joint],
) -> None:
    """Raise `SceneError` if a body that gets another shape can meet one without a restitution.

    Bodies (k,) get k shapes, the last one of several; joints keep pairs apart.
    """
    given = dict(zip(rows.tolist(), shapes, strict=True))
    table, owner = engine.world.shapes, engine.world.state.body_of_shape
    silent = (table.stated[:, BY_BODY + RESTITUTION] < 0.0) & (table.filters[:, SENSOR] == 0)
    new = {
        row: _Class(int(engine.kind[row] == DYNAMIC), *table.filters[place, :SENSOR].tolist())
        for place in np.flatnonzero(silent & np.isin(owner, rows)).tolist()
        if _is_silent(given[row := int(owner[place])])
    }
    if new:
        present = {row: what for row, what in _present(engine) if row not in given}
        _refuse(new, present, named, engine.stated_restitutions() | kept_apart(joints))


def _is_silent(shape: Shape | None) -> bool:
    """Return whether a part of a shape states no restitution, so that its body has to."""
    if isinstance(shape, Compound):
        return any(part.restitution is None for part in shape.parts)
    return shape is not None


def _refuse(
    new: Mapping[int, _Class],
    present: Mapping[int, _Class],
    named: Callable[[int], str],
    stated: Container[tuple[int, int]],
    place_of: Callable[[int, int], str] = lambda *_: "",
) -> None:
    """Refuse a pair of bodies, one of them new, that can meet and for which nothing is stated."""
    groups: dict[_Class, list[int]] = {}
    for row, what in {**present, **new}.items():
        groups.setdefault(what, []).append(row)
    for one, other in combinations_with_replacement(groups, 2):
        if not (may_touch(one, other) and (one.dynamic or other.dynamic)):
            continue
        for i, j in product(groups[one], groups[other]):
            first, second = min(i, j), max(i, j)
            if i != j and (i in new or j in new) and (first, second) not in stated:
                raise SceneError(
                    f"{place_of(first, second)}restitution of the pair {named(first)} and "
                    f"{named(second)}: not stated, and they can meet (R3). Give one of "
                    "them a restitution, set it for the pair, or let them not touch."
                )


def _new(batch: Batch, first: int) -> Iterator[tuple[int, _Class]]:
    silent = (batch.surfaces[:, 1] < 0.0) & (batch.filters[:, SENSOR] == 0)
    for k in np.flatnonzero(silent).tolist():
        if _is_silent(batch.shapes[k]):
            dynamic = int(batch.kind[k] == DYNAMIC)
            yield first + k, _Class(dynamic, *batch.filters[k, :SENSOR].tolist())


def _present(engine: Engine) -> Iterator[tuple[int, _Class]]:
    owner, surface, filters = engine.surfaces()
    silent = np.flatnonzero((surface[:, 1] < 0.0) & (filters[:, SENSOR] == 0))
    rows, which = np.unique(owner[silent], return_index=True)
    columns = filters[silent[which], :SENSOR]
    for row, numbers in zip(rows.tolist(), columns.tolist(), strict=True):
        yield row, _Class(int(engine.kind[row] == DYNAMIC), *numbers)
