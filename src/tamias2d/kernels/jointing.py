"""Reactions of joints by kernels, and the return to them.

Serves: mechanisms, to which it is given by `march_by_kernels`. Hides: the tables that kernels take,
and whether these are compiled. Compiled and plain code have the same bits, so that it does not
matter which of them ran.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.kernels import joint_source
from tamias2d.kernels.choice import Kernel, kernel
from tamias2d.kernels.elimination import Elimination, elimination
from tamias2d.kernels.joint_source import (
    DOUBTED,
    ENTRIES,
    FADED,
    KEPT,
    JointDemand,
    shapes_of,
    tables_of,
)
from tamias2d.motion.constraint_rows import Block, ConstraintRows
from tamias2d.motion.joint_code import JointRows
from tamias2d.motion.least import DEPENDENT, DOUBTFUL
from tamias2d.motion.mechanism import NEAR
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array

_WORK = 2**20  # products of an elimination; more are done faster by those who know blocks
_FEW = 24  # rows, with which the general factors pass better than reactions that fade
_SPREAD = 16  # of masses at the reach of joints: what fades is at least 1e-13 of the largest
_SHORT, _SHORT_RETURN = 2e-4, 6e-5  # as far as reactions, and the return, fade (GD19)
_FULL = 6  # times what fades: so long combinations have all of their reactions but 1e-12
_LIKELY = 1000  # reactions are asked for by those who cannot say how often they will
Tables = dict[str, NDArray[Any]]


def joint_code(joints: JointRows) -> "KernelJoints | None":
    """Return code for a mechanism; None where there is none for many joints."""
    pushed = _kinds(joints.pushes.rows) if joints.pushes else {}
    kinds, all_pushed = joints.kinds.union(_kinds(joints.rows)), joints.pushed.union(pushed)
    demand = JointDemand(tuple(sorted(kinds)), tuple(sorted(all_pushed)))
    numbers = _numbers(joints.rows, demand)
    tables = _tables(joints, demand, numbers)
    return None if tables is None else KernelJoints(demand, tables, numbers)


class KernelJoints:
    """The reactions of one mechanism by kernels (`JointCode`).

    Only rows that are independent where it begins fade elsewhere.
    """

    def __init__(self, demand: JointDemand, tables: Tables, numbers: NDArray[np.int64]) -> None:
        self.demand = demand
        self.tables = [tables[name] for name in tables_of(demand)]
        self._numbers = numbers
        self._sizes = tables["sizes"]
        self._doubtful = float(tables["doubtful"][0])
        self.begun = False
        """Whether it is known if rows may fade: its tables stay as they are from then on."""

    @cached_property
    def lists(self) -> list[list[Any]]:
        """The tables as plain Python takes them."""
        return [table.tolist() for table in self.tables]

    @property
    def count(self) -> int:
        """How many rows there are."""
        return len(self._numbers)

    @property
    def is_compiled(self) -> bool:
        """Whether reactions are found by compiled code."""
        return self._code.compiled(_LIKELY) is not None

    @property
    def _code(self) -> Kernel:
        return kernel(*joint_source.joints(self.demand), "joints")

    def react(
        self, time: float, position: Array, velocity: Array, free: Array
    ) -> tuple[Array, Array | None] | None:
        """Return the accelerations (n, 3) for those by the loads, and the multipliers (m,)."""
        rows, found = self._run(False, time, position, velocity, free)
        if rows == DOUBTED:
            return None
        multipliers = np.empty(len(self._numbers))
        multipliers[self._numbers] = found[3]
        return _rows(found[2]), multipliers if rows == KEPT else None

    def fit(self, time: float, position: Array, velocity: Array) -> tuple[Array, Array] | None:
        """Return places and velocities (n, 3), moved to where the joints hold (GD18)."""
        rows, found = self._run(True, time, position, velocity, velocity)
        return None if rows == DOUBTED else (_rows(found[0]), _rows(found[1]))

    def drift(
        self, time: float, duration: float, position: Array, velocity: Array
    ) -> tuple[Array, Array] | None:
        """Return places (n, 3) after a drift, and velocities along it (GD24)."""
        code = kernel(*joint_source.drifts(self.demand), "drift")
        rows, found = self._called(code, (time, duration), (position, velocity))
        return None if rows == DOUBTED else (_rows(found[0]), _rows(found[1]))

    def _run(self, fitting: bool, time: float, *states: Array) -> tuple[int, list[Array]]:
        """Return what the rows are, and states and multipliers after a kernel."""
        rows, found = self._tried(fitting, time, *states)
        if rows == FADED and not self.begun:
            self._sizes[2:] = (0.0, self._doubtful, 0.0, self._doubtful)
            self.__dict__.pop("lists", None)
            rows, found = self._tried(fitting, time, *states)
        self.begun = True
        return rows, found

    def _tried(self, fitting: bool, time: float, *states: Array) -> tuple[int, list[Array]]:
        return self._called(self._code, (fitting, time), states)

    def _called(
        self, code: Kernel, numbers: tuple[float, ...], states: Sequence[Array]
    ) -> tuple[int, list[Array]]:
        """Call a kernel, compiled or plain, with states that it changes."""
        compiled: Callable[..., int] | None = code.compiled(_LIKELY)
        rows = [state.T.flatten() for state in states] + [np.zeros(len(self._numbers))]
        if compiled is not None:
            return compiled(*numbers, *rows, *self.tables), rows
        lists = [row.tolist() for row in rows]
        try:
            found: int = code.plain(*numbers, *lists, *self.lists)
        except (ArithmeticError, ValueError):  # where compiled code goes on with what is not finite
            return DOUBTED, []
        return found, [np.array(row) for row in lists]


def _rows(flat: Array) -> Array:
    return flat.reshape(3, -1).T.copy()


def _kinds(rows: ConstraintRows) -> dict[str, Block]:
    return {block.functions.name: block for block in rows.blocks}


def _numbers(rows: ConstraintRows, demand: JointDemand) -> NDArray[np.int64]:
    """Return the numbers of a mechanism's rows in the order of a kernel's."""
    blocks = _kinds(rows)
    found = [blocks[kind].rows for kind in demand.kinds if kind in blocks]
    return np.array([k for own in found for k in range(own.start, own.stop)], dtype=np.int64)


def _tables(joints: JointRows, demand: JointDemand, numbers: NDArray[np.int64]) -> Tables | None:
    """Return what a kernel takes; None where eliminating would take long."""
    rows, size = joints.rows, joints.weights.size
    holds = list(_held(rows, demand.kinds))
    columns = [{column for _, column in row} for row in holds]
    if any(len(own) < len(row) for own, row in zip(columns, holds, strict=True)):
        return None  # a body holds itself
    found = elimination(columns, _WORK)
    if found is None:
        return None
    still = [*rows.fixed, *(joints.pushes.rows.fixed if joints.pushes else ())]
    weights = joints.weights.T.ravel()
    doubtful = _doubtful(joints, columns)
    tables: Tables = {
        "still": np.array(still).ravel(),
        "fixed": joints.fixed.ravel(),
        "sizes": np.array(
            [
                joints.length,
                NEAR / joints.weights[:, :2].max(initial=0.0),
                *(_fading(joints) or 2 * [0.0, doubtful]),
            ]
        ),
        "doubtful": np.array([doubtful]),
        "weights": weights,
        "inverse": weights * weights,
        "reach": joints.reach.T.ravel() ** 2,
        "speeds": joints.speeds[numbers],
        "placed": joints.placed[numbers],
        **_pattern(holds, found),
        "entries": np.zeros(ENTRIES * len(holds)),
        "change": np.zeros(size),
        "lower": np.zeros(len(found.below_rows)),
        "shared": np.zeros(len(found.below_rows)),
        **{name: np.zeros(len(holds)) for name in ("wanted", "total", "diagonal", "own")},
    }
    blocks = _kinds(rows)
    for kind in demand.kinds:
        tables |= _block(kind, blocks.get(kind), 0, rows.moving)
    pushes = joints.pushes
    blocks = _kinds(pushes.rows) if pushes else {}
    for kind in demand.pushed:
        tables |= _block(f"{kind}_push", blocks.get(kind), len(rows.fixed), rows.moving)
        laws = pushes.laws[list(blocks[kind].joints)] if pushes and kind in blocks else ()
        tables[f"{kind}_push_law"] = np.array(laws, dtype=np.float64).ravel()
    return tables


def _fading(joints: JointRows) -> list[float]:
    """Return what lets short combinations of rows fade, and the trace of the inverse from which on.

    For reactions, then for the return (GD19). Nothing fades where masses and reaches differ so much
    that it would be lost in rounding, nor of few rows.
    """
    least, most = _ratios(joints)
    if most > _SPREAD * least or len(joints.speeds) < _FEW:
        return []
    return [
        number
        for short in (_SHORT, _SHORT_RETURN)
        for number in ((short * least) ** 2, 1 / (_FULL * short) ** 2)
    ]


def _doubtful(joints: JointRows, columns: Sequence[set[int]]) -> float:
    """Return the trace of the inverse from which on some rows may depend on others (GD19).

    What a combination of rows measures by mass and what it measures by the reach of joints are
    apart by a factor at most, and no combination is longer than all rows that share a body.
    """
    least, most = _ratios(joints)
    together = Counter(column for own in columns for column in own)
    longest = max((sum(together[c] for c in own) for own in columns), default=1)
    return max(DOUBTFUL**2, (least / most / DEPENDENT) ** 2 / longest)


def _ratios(joints: JointRows) -> tuple[float, float]:
    """Return the least and the largest of what masses make of the reaches of joints."""
    ratio = (joints.weights / joints.reach)[joints.weights > 0]
    return float(ratio.min(initial=np.inf)), float(ratio.max(initial=1e-300))


def _held(rows: ConstraintRows, kinds: Iterable[str]) -> Iterator[list[tuple[int, int]]]:
    """Yield the places of the slopes of each row and their columns, in the order of a kernel."""
    blocks = _kinds(rows)
    number = 0
    for kind in kinds:
        if kind not in blocks:
            continue
        block = blocks[kind]
        for _ in range(block.shape[0]):
            for k in range(block.shape[1]):
                bodies = [(end, int(block.ends[end][k])) for end in block.functions.bodies]
                yield [
                    (ENTRIES * number + 3 * ENDS.index(end) + axis, axis * rows.moving + body)
                    for end, body in bodies
                    if body < rows.moving
                    for axis in range(3)
                ]
                number += 1


def _pattern(holds: Sequence[list[tuple[int, int]]], found: Elimination) -> Tables:
    starts = [0]
    at: list[dict[int, list[int]]] = []
    for row in holds:
        columns: dict[int, list[int]] = {}
        for place, (_, column) in enumerate(row, starts[-1]):
            columns.setdefault(column, []).append(place)
        at.append(columns)
        starts.append(starts[-1] + len(row))
    pairs: list[int] = []
    for k, row_number in enumerate(found.order):
        for p in range(found.below[k], found.below[k + 1]):
            first, second = at[row_number], at[found.order[found.below_rows[p]]]
            for column in sorted(first.keys() & second.keys()):
                for a in first[column]:
                    for b in second[column]:
                        pairs += (p, a, b)
    lists = {
        "row_starts": starts,
        "row_entries": [entry for row in holds for entry, _ in row],
        "row_columns": [column for row in holds for _, column in row],
        "pairs": pairs,
        **vars(found),
    }
    return {name: np.array(values, dtype=np.int64) for name, values in lists.items()}


def _block(name: str, block: Block | None, stills: int, moving: int) -> Tables:
    """Return the parameters and the ends of the joints of one kind; still ones follow others."""
    given: list[Array] = []
    ends: list[NDArray[np.intp]] = []
    if block is not None:
        for parameter, size in shapes_of(block.functions).items():
            value = block.given[parameter]
            parts = value if size == 2 else (value,)
            given += [np.broadcast_to(part, len(block.joints)) for part in parts]
        for end in block.functions.bodies:
            places = block.ends[end]
            ends.append(np.where(places < moving, places, places + stills))
    return {
        f"{name}_given": np.array(given, dtype=np.float64).T.ravel(),
        f"{name}_ends": np.array(ends, dtype=np.int64).T.ravel(),
    }
