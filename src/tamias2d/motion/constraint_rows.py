"""The rows of all joints of a mechanism as arrays: their values, slopes, rates (TM7).

Joints of one kind are computed together. A place that nothing pushes stands in a row of its own,
after those of the bodies that move; that of a kinematic body moves on evenly.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.scene import Scene
from tamias2d.scene.joints import Joint
from tamias2d.spec.constraint import ENDS
from tamias2d.spec.constraint_functions import ConstraintFunctions, Formula
from tamias2d.state import Array

_Places = NDArray[np.intp]
_PLANE = (0.0,) * 6


@dataclass(frozen=True)
class Block:
    """All joints of one kind: (r rows, k joints) of the whole, one row after the other."""

    functions: ConstraintFunctions
    joints: tuple[int, ...]
    """Their places among the joints of the mechanism."""
    ends: Mapping[str, _Places]
    """(k,), where bodies A, B and C stand."""
    given: Mapping[str, Any]
    first: int
    """The number of its first row."""

    @property
    def shape(self) -> tuple[int, int]:
        """How many rows each joint has, and how many joints there are."""
        return len(self.functions.units), len(self.joints)

    def columns(self, rows: Array, end: str) -> tuple[Any, Any, Any]:
        """Return three columns for the bodies at one end: arrays (k,), or floats for one joint."""
        if len(self.joints) == 1:
            x, y, turn = rows[self.ends[end][0]].tolist()
            return x, y, turn
        x, y, turn = rows[self.ends[end]].T
        return x, y, turn

    @property
    def rows(self) -> slice:
        """Where its rows stand among those of the mechanism."""
        count, joints = self.shape
        return slice(self.first, self.first + count * joints)


class ConstraintRows:
    """m rows in the coordinates (n, 3) of n bodies that move, x y orientation."""

    def __init__(self, scene: Scene, joints: Sequence[Joint], row_of: Mapping[int, int]) -> None:
        """Take the joints of a mechanism, and the row of each body that moves."""
        fixed: list[tuple[float, ...]] = []
        groups: dict[object, list[int]] = {}
        for k, joint in enumerate(joints):
            groups.setdefault(joint.equations or joint.model, []).append(k)
        self.blocks: list[Block] = []
        self.count = 0
        for members in groups.values():
            chosen = [joints[k] for k in members]
            ends = {
                end: np.array([_row(scene, joint.ends[i], row_of, fixed) for joint in chosen])
                for i, end in enumerate(ENDS)
            }
            given = _given(chosen)
            block = Block(chosen[0].functions, tuple(members), ends, given, self.count)
            self.blocks.append(block)
            self.count = block.rows.stop
        self.fixed, self.told = np.hsplit(np.array(fixed).reshape(-1, 6), 2)
        self.moving = len(row_of)

    def values(self, time: float, position: Array) -> Array:
        """Return the rows (m,): zero where the joints hold."""
        return self._summed("constraint", time, position, None)

    def rates(self, time: float, position: Array, velocity: Array) -> Array:
        """Return the rates of the rows (m,) along the motion."""
        return self._summed("rate", time, position, velocity)

    def convective(self, time: float, position: Array, velocity: Array) -> Array:
        """Return the second derivatives of the rows (m,) where no body is accelerated."""
        return self._summed("convective", time, position, velocity)

    def along(self, times: Array, position: Array, velocity: Array) -> tuple[Array, Array]:
        """Return values and rates (k, m) at times (k,), s, of coordinates and rates (k, n, 3).

        They are those of single times but for rounding: NumPy has functions of its own for arrays.
        """
        values, rates = np.empty((2, len(times), self.count))
        still = np.broadcast_to(self.fixed, (len(times), *self.fixed.shape))
        places = np.concatenate((position, still + times[:, None, None] * self.told), axis=1)
        speeds = np.concatenate((velocity, np.broadcast_to(self.told, still.shape)), axis=1)
        for block in self.blocks:
            known: dict[str, Any] = {"time": times[:, None], **block.given}
            for end in block.functions.bodies:
                x, y, turn = np.moveaxis(places[:, block.ends[end]], -1, 0)
                known[f"position_{end}"], known[f"orientation_{end}"] = (x, y), turn
                x, y, turn = np.moveaxis(speeds[:, block.ends[end]], -1, 0)
                known[f"velocity_{end}"], known[f"angular_velocity_{end}"] = (x, y), turn
            for name, found in (("constraint", values), ("rate", rates)):
                formula: Formula = getattr(block.functions, name)
                count, joints = block.shape
                with np.errstate(all="ignore"):
                    for i, row in enumerate(_evaluated(formula, known, count)):
                        found[:, block.first + i * joints : block.first + (i + 1) * joints] = row
        return values, rates

    def slopes(self, time: float, position: Array) -> Array:
        """Return the slopes (m, n, 3) of the rows by the coordinates of the bodies that move."""
        found = np.zeros((self.count, self.moving + len(self.fixed), 3))
        for _, rows, places, entries in self._slopes(time, position):
            found[rows, places] += entries
        return found[:, : self.moving]

    def end_slopes(self, time: float, position: Array) -> dict[str, Array]:
        """Return the slopes (m, 3) of the rows by the coordinates of their bodies A, B and C."""
        found = {end: np.zeros((self.count, 3)) for end in ENDS}
        for end, rows, _, entries in self._slopes(time, position):
            found[end][rows] = entries
        return found

    def of_joints(self) -> Iterator[tuple[int, list[int], tuple[str, ...]]]:
        """Yield the place of each joint with the numbers and units of its rows."""
        for block in self.blocks:
            count, joints = block.shape
            for k, joint in enumerate(block.joints):
                rows = [block.first + i * joints + k for i in range(count)]
                yield joint, rows, block.functions.units

    def _summed(self, name: str, time: float, position: Array, velocity: Array | None) -> Array:
        found = np.empty(self.count)
        for block, values in self._known(time, position, velocity):
            formula: Formula = getattr(block.functions, name)
            rows = found[block.rows].reshape(block.shape)
            for row, value in zip(rows, _evaluated(formula, values, len(rows)), strict=True):
                row[:] = value
        return found

    def _slopes(
        self, time: float, position: Array
    ) -> Iterator[tuple[str, NDArray[np.intp], _Places, Array]]:
        """Yield body, numbers, places and slopes (k, 3) of the rows of k joints."""
        for block, values in self._known(time, position, None):
            count, joints = block.shape
            for end, formula in block.functions.slopes.items():
                entries = _evaluated(formula, values, 3 * count)
                for i in range(count):
                    numbers = np.arange(joints) + block.first + i * joints
                    slopes = np.empty((joints, 3))
                    for column in range(3):
                        slopes[:, column] = entries[3 * i + column]
                    yield end, numbers, block.ends[end], slopes

    def _known(
        self, time: float, position: Array, velocity: Array | None
    ) -> Iterator[tuple[Block, dict[str, Any]]]:
        places = np.concatenate((position, self.fixed + time * self.told))
        speeds = None if velocity is None else np.concatenate((velocity, self.told))
        for block in self.blocks:
            values: dict[str, Any] = {"time": time, **block.given}
            for end in block.functions.bodies:
                x, y, turn = block.columns(places, end)
                values[f"position_{end}"], values[f"orientation_{end}"] = (x, y), turn
                if speeds is not None:
                    x, y, turn = block.columns(speeds, end)
                    values[f"velocity_{end}"], values[f"angular_velocity_{end}"] = (x, y), turn
            yield block, values


def _evaluated(formula: Formula, values: Mapping[str, Any], count: int) -> Sequence[Any]:
    """Return the rows of a formula; nothing finite where floats have no value."""
    try:
        return formula(values)
    except (ArithmeticError, ValueError):
        return [np.nan] * count


def _given(joints: Sequence[Joint]) -> dict[str, Any]:
    """Return the parameters of joints of one kind as arrays, and vectors as pairs of these.

    Those of a single joint are floats, with which a formula takes a tenth of the time.
    """
    if len(joints) == 1:
        return joints[0].given
    found: dict[str, Any] = {}
    for name in joints[0].functions.parameters:
        values = np.array([joint.given[name] for joint in joints])
        found[name] = (values[:, 0], values[:, 1]) if values.ndim == 2 else values
    return found


def _row(
    scene: Scene,
    body: int | None,
    row_of: Mapping[int, int],
    fixed: list[tuple[float, ...]],
) -> int:
    """Return the row of a joint's end; one that nothing pushes gets one, with place and speed."""
    if body is not None and body in row_of:
        return row_of[body]
    still = None if body is None else scene.bodies[body]
    fixed.append(
        (*still.position, still.orientation, *still.velocity, still.angular_velocity)
        if still
        else _PLANE
    )
    return len(row_of) + len(fixed) - 1
