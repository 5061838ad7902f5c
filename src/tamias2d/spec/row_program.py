"""The rows of a constraint as straight-line programs: values, slopes and bends from places.

Serves: a compiled solver of constraints that a scene states by equations of its own. Hides: in
which order a program finds what the solver asks for, so that it stops as soon as it has that.
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from tamias2d.spec.constraint import ENDS, TIME, Constraint, Named, Values
from tamias2d.spec.evaluate import Value, evaluate
from tamias2d.spec.expression import Call, Name, Node, names
from tamias2d.spec.straight_line import Operation, StraightLine

PLACE = ("position_{}_x", "position_{}_y", "orientation_{}", "cosine_{}", "sine_{}")
"""What is given of each body, A, B and C; then comes the time, then where each is held."""
_ANCHOR = ("anchor_{}_x", "anchor_{}_y")
INPUTS = (
    *(name.format(end) for end in ENDS for name in PLACE),
    TIME,
    *(name.format(end) for end in ENDS for name in _ANCHOR),
)
VALUE = 0
SLOPES = 1  # three for each body: by x, y and orientation
TIME_SLOPE = SLOPES + 3 * len(ENDS)
BENDS = TIME_SLOPE + 1  # one for each body: the second derivative by its orientation
OUTPUTS = BENDS + len(ENDS)
"""How many scalars a program finds."""
_SAMPLES: tuple[Mapping[str, Value], ...] = tuple(
    {
        **{f"position_{end}": (by + 1.3 * k, 2.1 * by - 0.7 * k) for k, end in enumerate(ENDS)},
        **{f"orientation_{end}": 0.4 * by + k for k, end in enumerate(ENDS)},
        **{f"anchor_{end}": (0.2 * by, 0.3 - 0.1 * k) for k, end in enumerate(ENDS)},
        TIME: by,
    }
    for by in (0.6, 1.7, 3.1)
)
"""Places near which it is looked whether a row is free: three, so that chance is none."""
_CLOSINGS = 30  # steps of Newton to where rows hold, of which a few do where such a place is near
_CLOSED = 1e-12  # m or rad, a step that is rounding
_ROUNDING = 1e-9  # of slopes
_KNOWN: Mapping[Node, str] = {
    Call(function, (Name(f"orientation_{end}"),)): f"{name}_{end}"
    for end in ENDS
    for function, name in (("cos", "cosine"), ("sin", "sine"))
}


class RowProgram(NamedTuple):
    """One row of a constraint."""

    operations: tuple[Operation, ...]
    """Their scalars are numbered from `INPUTS` on."""
    constants: tuple[float, ...]
    """Of each operation: what a constant yields."""
    counts: tuple[int, int, int]
    """How many operations find the value; that and the slopes; these and the bends."""
    outputs: tuple[int, ...]
    """The numbers of the scalars that it finds."""
    bodies: tuple[str, ...]
    """The indices of the bodies whose coordinates it takes."""
    timed: bool
    """Whether it changes with time."""
    free: bool
    """Whether it holds on however its bodies are moved and turned as one: nothing else bears it."""


def row_programs(constraint: Constraint) -> tuple[RowProgram, ...]:
    """Return the program of each row of a constraint without parameters but anchors.

    Raises:
        KeyError: there is no operation for a part of it; says which.
        ValueError: a part of it has no derivative.
    """
    slopes = {end: constraint.slopes(end) for end in constraint.bodies}
    bends = {end: constraint.bends(end) for end in constraint.bodies}
    timed, values = constraint.time_slopes(), constraint.values()
    places = [_where_it_holds(constraint, values.rows, slopes, place) for place in _SAMPLES]
    return tuple(
        _program(row, constraint, values, slopes, timed, bends, places)
        for row in range(len(values.rows))
    )


def _where_it_holds(
    constraint: Constraint,
    rows: tuple[Node, ...],
    slopes: Mapping[str, Values],
    place: Mapping[str, Value],
) -> Mapping[str, Value]:
    """Return a place near another one at which all rows are zero; that itself if none is found.

    A hinge that is stated by two differences is free only where it holds.
    """
    found = dict(place)
    try:
        for _ in range(_CLOSINGS):
            known = _with_points(found, constraint.where)
            gaps = np.array([evaluate(row, known) for row in rows], dtype=np.float64)
            moved = [
                [evaluate(slope, known) for slope in own.rows[3 * k : 3 * k + 3]]
                for k in range(len(rows))
                for own in slopes.values()
            ]
            matrix = np.array(moved, dtype=np.float64).reshape(len(rows), -1)
            if not (np.isfinite(matrix).all() and np.isfinite(gaps).all()):
                return place
            by = -np.linalg.lstsq(matrix, gaps, rcond=None)[0].reshape(-1, 3)
            for end, (x, y, turn) in zip(slopes, by.tolist(), strict=True):
                at_x, at_y = found[f"position_{end}"]
                found[f"position_{end}"] = (at_x + x, at_y + y)
                found[f"orientation_{end}"] += turn
            if not np.abs(by).max() > _CLOSED:
                return found
    except (ArithmeticError, ValueError, np.linalg.LinAlgError):
        return place
    return place


def _with_points(place: Mapping[str, Value], where: Named) -> dict[str, Value]:
    """Return a place with what its equations name besides."""
    values = dict(place)
    for name, tree in where:
        values[name] = evaluate(tree, values)
    return values


def _program(
    row: int,
    constraint: Constraint,
    values: Values,
    slopes: Mapping[str, Values],
    timed: Values,
    bends: Mapping[str, Values],
    places: list[Mapping[str, Value]],
) -> RowProgram:
    line = StraightLine(INPUTS, dict(constraint.where), _KNOWN)
    outputs = [line.constant(0.0)] * OUTPUTS
    outputs[VALUE] = line.scalar(values.rows[row])
    counts = [len(line.operations)]
    for end, found in slopes.items():
        at = SLOPES + 3 * ENDS.index(end)
        outputs[at : at + 3] = map(line.scalar, found.rows[3 * row : 3 * row + 3])
    outputs[TIME_SLOPE] = line.scalar(timed.rows[row])
    counts.append(len(line.operations))
    for end, found in bends.items():
        outputs[BENDS + ENDS.index(end)] = line.scalar(found.rows[row])
    counts.append(len(line.operations))
    used = {name for tree in _trees(constraint) for name in names(tree)}
    moved = {end: found.rows[3 * row : 3 * row + 3] for end, found in slopes.items()}
    return RowProgram(
        tuple(line.operations),
        tuple(line.constants),
        (counts[0], counts[1], counts[2]),
        tuple(outputs),
        constraint.bodies,
        TIME in used,
        all(_is_free(moved, constraint.where, place) for place in places),
    )


def _is_free(
    moved: Mapping[str, tuple[Node, ...]], where: Named, place: Mapping[str, Value]
) -> bool:
    """Return whether slopes by x, y and orientation say so where bodies are at some place."""
    total, size = [0.0, 0.0, 0.0], 0.0
    try:
        values = _with_points(place, where)
        for end, slopes in moved.items():
            along_x, along_y, turning = (evaluate(slope, values) for slope in slopes)
            x, y = values[f"position_{end}"]
            as_one = (along_x, along_y, turning + x * along_y - y * along_x)
            total = [a + b for a, b in zip(total, as_one, strict=True)]
            size += abs(along_x) + abs(along_y) + abs(turning)
    except (ArithmeticError, ValueError):
        return False  # it has no value there: it is bound to some place
    return max(map(abs, total)) <= _ROUNDING * size


def _trees(constraint: Constraint) -> tuple[Node, ...]:
    return (*constraint.equations, *(tree for _, tree in constraint.where))
